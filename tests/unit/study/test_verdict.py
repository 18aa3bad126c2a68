"""Who wins over all objectives: places, weights, confidence, and bounds of what may come."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gearwright.sizing import Named
from gearwright.spec import Study
from gearwright.study import Row, Table
from gearwright.study.answers import bound, confidence, kept, scenarios, verdict as found_of

DESIGNS = ("one", "two", "three")


def study_of(**more: object) -> Study:
    return Study.model_validate(
        {"name": "s", "designs": list(DESIGNS), "objectives": {"a": "minimum", "b": "maximum"}, **more}
    )


def table_of(*cases: tuple[tuple[float, float], ...]) -> Table:
    rows = tuple(
        Row(
            name,
            {"x": k},
            {"a": Named(a, "ratio"), "b": Named(b, "ratio")} if math.isfinite(a) else {},
            "" if math.isfinite(a) else "no",
        )
        for k, case in enumerate(cases)
        for name, (a, b) in zip(DESIGNS, case, strict=True)
    )
    return Table("s", "", ("a", "b"), rows)


def test_the_best_mean_place_wins_and_places_need_no_unit() -> None:
    found = found_of(study_of(), table_of(((1.0, 3e9), (2.0, 2e9), (3.0, 5e9)), ((1.0, 3.0), (2.0, 2.0), (3.0, 5.0))))
    assert found is not None
    assert [(each.design, each.place, each.first) for each in found.standings] == [
        ("one", 1.5, 2),
        ("three", 2.0, 0),
        ("two", 2.5, 0),
    ]
    assert [each.non_dominated for each in found.standings] == [1.0, 1.0, 0.0]
    assert found.without == {"a": "three"}


def test_over_all_weights_two_designs_that_each_lead_one_objective_share_the_first_place() -> None:
    """Places (1, 2) and (3, 1): the first is first where w + 2 (1 - w) < 3 w + (1 - w), that is w > 1/3."""
    found = found_of(study_of(), table_of(((1.0, 2.0), (3.0, 3.0), (2.0, 1.0))))
    assert found is not None
    shares = {each.design: each.weights for each in found.standings}
    assert shares["one"] == pytest.approx(2.0 / 3.0, abs=0.03)
    assert shares["two"] == pytest.approx(1.0 / 3.0, abs=0.03)
    assert sum(shares.values()) == pytest.approx(1.0)


def test_what_fails_or_breaks_a_constraint_has_the_last_place() -> None:
    table = table_of(((math.inf, 0.0), (2.0, 1.0), (3.0, 2.0)))
    found = found_of(study_of(constraints={"b": {"minimum": 1.5}}), table)
    assert found is not None
    assert found.standings[0].design == "three"


def test_there_is_no_verdict_where_inputs_are_not_equal() -> None:
    rows = tuple(
        Row(name, {"x": k}, {"a": Named(1.0, "ratio"), "b": Named(1.0, "ratio")}) for k, name in enumerate(DESIGNS)
    )
    assert found_of(study_of(), Table("s", "", ("a", "b"), rows)) is None
    assert scenarios(Table("s", "", ("a", "b"), rows)) == []


def test_the_verdict_repeats_bit_for_bit() -> None:
    draws = np.random.default_rng(3).random((20, 3, 2))
    cases = [tuple(map(tuple, case)) for case in draws]
    assert found_of(study_of(), table_of(*cases)) == found_of(study_of(), table_of(*cases))


def test_the_interval_of_a_share_covers_it_in_95_per_cent_of_samples() -> None:
    """Wilson 1927: 2000 samples of 40 with p = 0.9; the standard error of the coverage is 0.5 %."""
    hits = np.random.default_rng(1).binomial(40, 0.9, 2000)
    covered = np.mean([low <= 0.9 <= high for low, high in (confidence(int(each), 40) for each in hits)])
    assert 0.93 < covered < 0.985


def test_a_bound_holds_for_95_per_cent_in_95_per_cent_of_samples() -> None:
    """Wilks 1941: of 100 uniform samples the bound is at least 0.95 in 95 % or more; 2000 trials, error 0.5 %."""
    draws = np.random.default_rng(2).random((2000, 100))
    held = np.mean([(bound(list(row)) or 0.0) >= 0.95 for row in draws])
    assert 0.94 < held < 0.995


def test_kept_constraints_are_counted() -> None:
    table = table_of(((1.0, 3.0), (2.0, 2.0), (math.inf, 5.0)))
    assert kept(study_of(constraints={"a": {"maximum": 1.5}, "b": {"minimum": 0.0}}), table) == {"a": 1, "b": 2}
