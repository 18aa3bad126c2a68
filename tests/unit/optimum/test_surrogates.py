"""Surrogates foretell what was not computed, say how far they are off, and save evaluations."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.optimum.generations import conditioned, fitted
from gearwright.render.answers.studies import optimise_answer
from gearwright.render.pages.studies import optimum_page
from gearwright.render.tables.study import fit_table
from gearwright.spec import Study
from gearwright.spec.studies import study_problems

AXES = {
    "motors.electric.speed_rpm": {"from": 4000, "to": 5000},
    "gears.helix_angle_deg": {"from": 0, "to": 25},
    "planetaries.second.planets": {"values": [3, 4, 5]},
}


def asked(**search) -> Study:
    return Study.model_validate({
        "name": "guided", "designs": ["in-line-h2"], "axes": AXES, "objectives": {"total_mass": "minimum"},
        "results": ["total_mass"], "constraints": {"worst_margin": {"minimum": 1.0}},
        "search": {"population": 8, "evaluations": 200, "surrogate": True, **search},
    })  # fmt: skip


def by(row):
    """A valley across two freedoms and a list, of which a corner is forbidden."""
    speed, helix, planets = (row[path] for path in AXES)
    x, y = (speed - 4000.0) / 1000.0, helix / 25.0
    margin = 1.2 - 0.5 * max(x + y - 1.2, 0.0) / 0.8
    return {"total_mass": 100.0 + 50.0 * (x - y) ** 2 + 20.0 * (x - 0.7) ** 2 + planets, "worst_margin": margin}


def reached(guided, seed, count=32, look=lambda search: None):
    with gw.search(asked(surrogate=guided, seed=seed)) as search:
        while len(search.rows) < count:
            search.tell(search.evaluate(search.ask(8), by))
            look(search)
        return search.front[0].number("total_mass"), search.fits, search.rows


def test_a_process_foretells_what_it_was_not_told_and_says_how_sure_it_is():
    generator = np.random.default_rng(1)
    places, others = generator.random((40, 2)), generator.random((200, 2))
    wave = lambda at: np.sin(5.0 * at[:, 0]) + at[:, 1]  # noqa: E731
    mean, deviation = fitted(places, wave(places)).at(others)
    assert np.abs(mean - wave(others)).max() < 0.05
    assert np.mean(np.abs(mean - wave(others)) <= 3.0 * deviation + 1e-3) > 0.95


def test_each_left_out_is_what_the_others_foretell_of_it():
    generator = np.random.default_rng(2)
    places, values = generator.random((12, 2)), generator.normal(size=12)
    values = (values - values.mean()) / values.std()
    logs = np.log([0.4, 0.6, 1e-2])
    whole = conditioned(places, values, logs)
    kept = np.arange(12) != 5
    matrix = np.linalg.inv(whole.factor @ whole.factor.T)
    by_others = values[5] - matrix[5] @ values / matrix[5, 5]
    assert whole.left_out[5] == pytest.approx(values[5] - by_others, rel=1e-9)
    without = whole.factor[kept] @ whole.factor.T[:, kept]
    across = (whole.factor @ whole.factor.T)[5, kept]
    assert across @ np.linalg.solve(without, values[kept]) == pytest.approx(by_others, rel=1e-9)


def test_a_guided_search_needs_fewer_designs_and_tells_its_errors():
    guided, bred = (np.mean([reached(how, seed)[0] for seed in (1, 2, 3)]) for how in (True, False))
    assert guided - 103.0 < 0.5 * (bred - 103.0)
    _, fits, _ = reached(True, 1)
    assert [fit.result for fit in fits] == ["total_mass", "worst_margin"]
    assert 0.0 < fits[0].error < 1.0 and all(fit.designs == 32 for fit in fits)
    assert reached(False, 1)[1] == ()


def test_a_guided_search_asks_for_the_same_again():
    assert reached(True, 4)[2] == reached(True, 4)[2]


def test_who_looks_at_the_errors_changes_nothing_of_what_is_asked_for():
    assert reached(True, 1, look=lambda search: search.fits)[2] == reached(True, 1)[2]


def test_too_many_designs_for_a_surrogate_are_refused():
    (problem,) = study_problems(asked(evaluations=5000))
    assert problem.path == "search.evaluations"
    with pytest.raises(DesignError, match="a surrogate is for 1000 at most"):
        gw.search(asked(evaluations=5000))


def test_the_answer_of_a_guided_search_tells_how_wrong_its_surrogates_are():
    optimum = gw.optimise(asked(evaluations=24, screened=0))
    assert [fit.result for fit in optimum.fits][:1] == ["total_mass"] and optimum.fits[0].designs <= 24
    assert optimum.prices == (), "what limits cost takes as many designs again, many times"
    (row, *_) = optimise_answer(optimum).fits
    assert row == optimum.fits[0]
    assert "How well surrogates foretell" in optimum_page(optimum)
    assert f"{100 * row.error:.0f}"[:1] in str(fit_table(optimum).rows[0][1])
