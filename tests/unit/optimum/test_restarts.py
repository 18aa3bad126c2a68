"""How far the best may lie beyond what independent starts found: the estimator, and the answer that says it."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.optimum import optimise, restarted
from gearwright.optimum.optimise import study_for
from gearwright.optimum.optimum import expected_gap
from gearwright.render.answers.studies import optimise_answer
from gearwright.render.words.study import optimum_sentences
from gearwright.spec import Search


def test_the_gap_is_without_bias():
    """Four starts that each miss the best by Exp(5): their best misses it by 5/4 in the mean, and so says the gap."""
    missed = np.random.default_rng(0).exponential(5.0, (4000, 4))
    corrected = [min(row) - expected_gap(row.tolist()) for row in missed]
    assert np.mean(missed.min(axis=1)) == pytest.approx(1.25, abs=0.06)
    assert np.mean(corrected) == pytest.approx(0.0, abs=0.06)


@pytest.fixture(scope="module")
def found():
    rules = Search(screened=8, population=8, evaluations=16, seed=1)
    design = gw.read("in-line-h2")
    study = study_for("in-line-h2", design, objectives={"total_mass": "minimum"}, search=rules)
    return optimise(study)


def test_one_start_says_that_it_knows_of_no_gap(found):
    assert found.starts == 1
    assert not found.gaps
    assert any(sentence.startswith("One start: it tells nothing") for sentence in optimum_sentences(found))


def test_more_starts_say_the_gap(found):
    more = restarted(found, starts=2)
    (gap,) = more.gaps
    own = min(best.row.number("total_mass") for best in found.front)
    assert more.starts == 2
    assert more.front == found.front
    assert gap.best <= own
    assert gap.beyond >= 0.0
    assert any(sentence.startswith("2 independent starts of as many designs: ") for sentence in optimum_sentences(more))
    answer = optimise_answer(more)
    assert answer.starts == 2
    assert list(answer.gaps[0].best.values()) == [pytest.approx(gap.best)]


def test_no_start_is_refused(found):
    with pytest.raises(gw.DesignError, match="0 are asked for"):
        restarted(found, starts=0)
