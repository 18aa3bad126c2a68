"""How likely a constraint is broken: methods against exact probabilities, and studies that ask for it."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ndtr

from gearwright.errors import DesignError
from gearwright.sizing import Named
from gearwright.spec import parse_study
from gearwright.study import Row, Table, run
from gearwright.study.cases import cases
from gearwright.study.reliability import Estimate, failures, first_order, importance, index_of, reliability, subset
from gearwright.study.running import resume, run_study

Left = Callable[[np.ndarray], np.ndarray]


def _driven(search: Generator[np.ndarray, np.ndarray, Any], left: Left) -> tuple[Any, int]:
    """Return what a search finds, and after how many evaluations."""
    count, places = 0, next(search)
    while True:
        count += len(places)
        try:
            places = search.send(left(places))
        except StopIteration as end:
            return end.value, count


def _plane(index: float) -> Left:
    return lambda places: (index - places @ np.array([0.6, -0.8]))[:, None]


def _branches(places: np.ndarray) -> np.ndarray:
    """Return the four branches of Waarts (2000), a series system whose limits are curved."""
    x, y = places.T
    bowl = 3.0 + 0.1 * (x - y) ** 2
    side = 6.0 / math.sqrt(2.0)
    return np.stack([bowl - (x + y) / math.sqrt(2.0), bowl + (x + y) / math.sqrt(2.0), side + x - y, side - x + y], 1)


def _exact_branches() -> float:
    """Return their probability, by one integral over (x − y)/√2 and the normal distribution across it."""
    density = lambda t: math.exp(-0.5 * t * t) / math.sqrt(2.0 * math.pi)  # noqa: E731
    inside, _ = quad(lambda t: density(t) * (2.0 * ndtr(3.0 + 0.2 * t * t) - 1.0), -3.0, 3.0, epsabs=1e-14)
    return 1.0 - inside


def test_a_plane_is_found_exactly_by_first_order() -> None:
    (point,), count = _driven(first_order(2, np.random.default_rng(1)), _plane(4.7))
    assert point.place == pytest.approx([2.82, -3.76], abs=1e-6)
    assert point.probability == pytest.approx(ndtr(-4.7), rel=1e-6)
    assert point.settled and count < 120


def test_a_limit_that_is_broken_at_the_median_has_a_negative_index() -> None:
    (point,), _ = _driven(first_order(2, np.random.default_rng(1)), _plane(-1.0))
    assert index_of(point.probability) == pytest.approx(-1.0, abs=1e-6)


def test_a_kink_at_the_start_does_not_lead_astray() -> None:
    kinked: Left = lambda places: np.minimum(1.0 - places[:, :1] / 5.0, 1.0 - places[:, 1:] / 5.2)  # noqa: E731
    (point,), _ = _driven(first_order(2, np.random.default_rng(1)), kinked)
    assert np.linalg.norm(point.place) == pytest.approx(5.0, rel=1e-3)


def test_a_limit_on_which_nothing_has_an_influence_is_broken_never_or_always() -> None:
    for value, probability in ((1.0, 0.0), (-1.0, 1.0)):
        flat: Left = lambda places, value=value: np.full((len(places), 1), value)  # type: ignore[misc]  # noqa: E731
        (point,), _ = _driven(first_order(2, np.random.default_rng(1)), flat)
        assert point.probability == probability
        assert not np.isfinite(point.place).any()


def test_four_branches_are_counted_by_importance_and_subset_sampling() -> None:
    """The reference is an integral that neither method uses; each interval holds it, and first order does not."""
    exact = _exact_branches()
    points, _ = _driven(first_order(2, np.random.default_rng(1)), _branches)
    assert [point.probability for point in points] == pytest.approx([ndtr(-3.0)] * 4, rel=1e-3)
    drawn, count = _driven(importance(points, 2, 8000, np.random.default_rng(2)), _branches)
    assert count == 8000
    assert drawn.interval[0] < exact < drawn.interval[1]
    assert drawn.interval[1] / drawn.interval[0] < 1.2
    found, count = _driven(subset(2, 4, 1000, 60_000, np.random.default_rng(3)), _branches)
    assert count == 60_000
    assert found.settled and found.interval[0] < exact < found.interval[1]
    bowl = (exact - 2.0 * ndtr(-3.0)) / 2.0  # the branches hardly ever break together
    assert [point.probability for point in found.points] == pytest.approx([bowl, bowl, ndtr(-3.0), ndtr(-3.0)], rel=0.3)


def test_intervals_of_subset_simulation_hold_one_in_a_million() -> None:
    """Of a hundred intervals of 95 % some ninety hold what is exact: levels are no independent draws."""
    exact, hits, mean = float(ndtr(-4.753424)), 0, 0.0
    assert exact == pytest.approx(1e-6, rel=1e-5)
    for seed in range(100):
        found, _ = _driven(subset(2, 1, 1000, 6500, np.random.default_rng(seed)), _plane(4.753424))
        hits += found.interval[0] <= exact <= found.interval[1]
        mean += found.probability / 100.0
    assert hits >= 85
    assert mean == pytest.approx(exact, rel=0.15)


def test_a_count_that_does_not_suffice_gives_an_upper_bound_that_says_so() -> None:
    found, count = _driven(subset(2, 1, 100, 250, np.random.default_rng(1)), _plane(4.0))
    assert isinstance(found, Estimate)
    assert count == 250
    assert not found.settled and found.probability > ndtr(-4.0)


STUDY = """
schema = 1
name = "Loads of a pair"
designs = ["one", "two"]

[axes]
"loads.first" = {distribution = "normal", mean = 10.0, deviation = 1.0}
"loads.second" = {from = 0.0, to = 2.0}

[constraints]
strength = {minimum = 1.0}
stroke = {maximum = 8.0}

[sampling]
method = "form"
count = 2000
seed = 4
"""


def _computed(case: Any) -> Row:
    """Return the row of a case whose results are known in closed form: strength = 15/first, stroke = 5 + second."""
    first, second = case.inputs["loads.first"], case.inputs["loads.second"]
    strength = (15.0 if case.design == "one" else 13.0) / first
    return Row(case.design, case.inputs, {"strength": Named(strength, "ratio"), "stroke": Named(5.0 + second, "ratio")})


def _rows(text: str) -> tuple[Any, list[Row]]:
    study, rows = parse_study(text), list[Row]()
    search = failures(study)
    batch = next(search)
    while True:
        answers = [_computed(case) for case in batch]
        assert [case.number for case in batch] == list(range(len(rows), len(rows) + len(batch)))
        rows += answers
        try:
            batch = search.send(answers)
        except StopIteration as end:
            return (study, end.value), rows


@pytest.mark.parametrize("method", ["form", "subset"])
def test_a_study_says_which_limit_fails_where_and_by_what(method: str) -> None:
    text = STUDY.replace('"form"', f'"{method}"').replace("count = 2000", "count = 8000\npopulation = 500")
    (study, found), rows = _rows(text)
    assert len(rows) == 16_000
    assert [one.design for one in found] == ["one", "two"]
    assert reliability(study, Table("", "", study.asked, tuple(rows))) == found
    for one, index in zip(found, (5.0, 3.0), strict=True):
        assert one.settled and one.evaluations == 8000 and one.failed == 0
        assert one.index == pytest.approx(index, abs=0.1 if method == "form" else 0.3)
        strongest, other = one.limits
        assert strongest.limit.result == "strength" and strongest.limit.is_minimum
        assert strongest.likeliest["loads.first"] == pytest.approx(10.0 + index, rel=1e-3 if method == "form" else 0.05)
        assert strongest.influence["loads.first"] > 0.9
        assert other.probability < 1e-8  # the stroke comes to 7 at most


def test_cases_without_a_result_count_as_broken() -> None:
    study = parse_study(STUDY.replace('"form"', '"sobol"'))
    rows = [_computed(case) for case in cases(study)]
    lost = [replace(row, results={}, problem="no room") for row in rows[:500]]
    one, two = reliability(study, Table("", "", study.asked, (*lost, *rows[500:])))
    assert one.failed == 500
    assert one.probability >= 0.25 > two.probability


@pytest.mark.parametrize(
    ("changed", "path", "said"),
    [
        ("strength = {minimum = 1.0}\nstroke = {maximum = 8.0}", "constraints", "needs what must not be broken"),
        ("count = 2000", "sampling.count", "may take"),
        ("{from = 0.0, to = 2.0}", "axes.loads.second", "follows gradients"),
    ],
)
def test_what_a_study_lacks_is_said_at_its_place(changed: str, path: str, said: str) -> None:
    put = {"constraints": "", "sampling.count": "count = 500", "axes.loads.second": "{values = [0.0, 2.0]}"}[path]
    with pytest.raises(DesignError) as refused:
        parse_study(STUDY.replace(changed, put))
    assert [problem.path for problem in refused.value.problems] == [path]
    assert said in str(refused.value)


def test_levels_of_subset_simulation_have_a_least_size() -> None:
    with pytest.raises(DesignError, match="95 samples of a level; give a multiple of 10 from 100 to 1000"):
        parse_study(STUDY.replace('"form"', '"subset"').replace("seed = 4", "seed = 4\npopulation = 95"))


FROZEN = """
schema = 1
name = "A finished gearbox under other loads"
designs = ["star"]
frozen = true
results = ["mass", "worst_margin"]

[axes]
"gears.mesh_load_factor" = {from = 1.0, to = 1.5}

[changes]
level = "concept"

[constraints]
worst_margin = {minimum = 0.8}

[sampling]
method = "subset"
count = 200
population = 100
"""


def test_a_frozen_gearbox_keeps_its_mass_under_other_loads_and_is_found_again_by_resume(tmp_path: Path) -> None:
    """Frozen, a larger load is a smaller margin; without, a heavier gearbox."""
    from gearwright.shipped import find_design
    from gearwright.spec import edited, read

    designs = {"star": edited(read(find_design("star", None)), {"level": "concept", "gears.mesh_load_factor": 1.0})}
    study = parse_study(FROZEN)
    table = run_study(study, designs, journal=tmp_path / "j")
    assert np.ptp(table.column("mass")) < 1e-9 * table.column("mass")[0]
    assert np.ptp(table.column("worst_margin")) > 0.05
    again = resume(tmp_path / "j", designs=designs)
    assert again.rows == table.rows
    assert reliability(study, again) == reliability(study, table)
    assert reliability(study, table)[0].limits[0].influence == {"gears.mesh_load_factor": 1.0}
    free = run(study.model_copy(update={"frozen": False}), designs)
    assert np.ptp(free.column("mass")) > 0.01 * free.column("mass")[0]
