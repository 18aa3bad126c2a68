"""Studies that keep no rows: what is left equals what the rows say, in any order, in parts, and after a stop."""

from __future__ import annotations

import itertools
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.shipped import find_design
from gearwright.spec import Design, Study, edited, parse_study, read
from gearwright.study import run
from gearwright.study.answers import ACCURACY, Reduced, as_plain, buckets, quantiles_of
from gearwright.study.running import Part, Progress, is_reduced, merge_reduced, reduce_study
from gearwright.study.tables import Blocks, blocks_of, pareto_front

STUDY = """
schema = 1
name = "Small"
designs = ["star"]
results = ["mass"]

[axes]
"turbines.gas-turbine.speed_rpm" = {from = 15000, to = 30000}
"gears.material" = {values = ["AISI-9310", "no-such-steel"]}

[objectives]
mass = "minimum"
worst_margin = "maximum"

[sampling]
method = "random"
count = 300
seed = 3

[reduced]
best = 4
"""


@pytest.fixture(scope="module")
def study() -> Study:
    return parse_study(STUDY)


@pytest.fixture(scope="module")
def designs() -> dict[str, Design]:
    return {"star": edited(read(find_design("star", None)), {"level": "concept"})}


@pytest.fixture(scope="module")
def whole(study: Study, designs: dict[str, Design]) -> Reduced:
    return reduce_study(study, designs)


def test_quantiles_are_as_near_as_is_said_for_any_numbers() -> None:
    generator = np.random.default_rng(1)
    values = np.concatenate([generator.lognormal(0.0, 8.0, 5000), -generator.lognormal(0.0, 2.0, 3000), np.zeros(500)])
    counts = Counter(buckets(values).tolist())
    parts = tuple(np.linspace(0.0, 1.0, 41).tolist())
    exact = np.quantile(values, parts, method="lower")
    assert np.allclose(quantiles_of(counts, parts), exact, rtol=1.001 * ACCURACY, atol=0.0)


def test_endless_values_lie_at_the_ends() -> None:
    counts = Counter(buckets(np.array([-np.inf, 1.0, np.inf])).tolist())
    low, middle, high = quantiles_of(counts, (0.0, 0.5, 1.0))
    assert (low, high) == (-np.inf, np.inf)
    assert middle == pytest.approx(1.0, rel=ACCURACY)


def test_what_is_left_is_what_the_rows_say(study: Study, designs: dict[str, Design], whole: Reduced) -> None:
    table = run(study.model_copy(update={"reduced": None}), designs)
    assert (whole.cases, whole.failed) == (len(table.rows), len(table.failed)) and 100 < whole.failed < 200
    assert sum(whole.reasons.values()) == whole.failed
    masses = np.array(table.column("mass"))
    parts = (0.05, 0.5, 0.95)
    exact = np.quantile(masses, parts, method="lower")
    assert np.allclose(whole.quantiles("star", "mass"), exact, rtol=1.001 * ACCURACY)
    front = {(row.number("mass"), row.number("worst_margin")) for row in pareto_front(study, table)}
    kept = {(row.number("mass"), row.number("worst_margin")) for row in whole.best.values()}
    assert front <= kept
    assert sorted(masses)[:4] == sorted(mass for mass, _ in kept)[:4]
    assert all(row == table.rows[number] for number, row in whole.best.items())


def test_sections_of_an_axis_hold_the_cases_that_lie_in_them(
    study: Study, designs: dict[str, Design], whole: Reduced
) -> None:
    path = "turbines.gas-turbine.speed_rpm"
    table = run(study.model_copy(update={"reduced": None}), designs)
    speeds = np.array([row.inputs[path] for row in table.good], dtype=float)
    masses = np.array(table.column("mass"))
    found = {section: (count, middle) for section, count, (_, middle, _) in whole.along("star", "mass", path)}
    edges = 15000.0 + 15000.0 * np.arange(25) / 24.0
    for section, (low, high) in enumerate(itertools.pairwise(edges)):
        own = masses[(speeds >= low) & (speeds < high)]
        if len(own):
            count, middle = found[section]
            assert count == len(own)
            assert middle == pytest.approx(np.quantile(own, 0.5, method="lower"), rel=1.001 * ACCURACY)


def test_the_order_in_which_cases_are_finished_does_not_matter(
    study: Study, designs: dict[str, Design], whole: Reduced
) -> None:
    rows = list(enumerate(run(study.model_copy(update={"reduced": None}), designs).rows))
    shuffled = Reduced(study)
    order = np.random.default_rng(2).permutation(len(rows))
    for part in np.array_split(order, 7):
        shuffled.absorb(Blocks(tuple(blocks_of([rows[k] for k in part.tolist()]).blocks)))
    assert as_plain(shuffled) == as_plain(whole)


def test_parts_add_up_to_the_whole(study: Study, designs: dict[str, Design], whole: Reduced, tmp_path: Path) -> None:
    states = [tmp_path / f"{number}.state" for number in (1, 2, 3)]
    for number, state in enumerate(states, start=1):
        reduce_study(study, designs, state=state, part=Part(number, 3))
    assert all(map(is_reduced, states))
    merged = merge_reduced(states, tmp_path / "all.state")
    assert as_plain(merged) == as_plain(whole)
    with pytest.raises(DesignError, match="has the same part 1/3 as"):
        merge_reduced([states[0], states[1], _copy(states[0], tmp_path / "copy.state")], tmp_path / "no.state")


def _copy(path: Path, to: Path) -> Path:
    to.write_bytes(path.read_bytes())
    return to


class _Stopped(Exception):
    """Raised in the middle of a run."""


def test_a_run_that_was_stopped_goes_on_where_it_was(
    study: Study, designs: dict[str, Design], whole: Reduced, tmp_path: Path
) -> None:
    state, seen = tmp_path / "s", list[int]()

    def stop(now: Progress) -> None:
        seen.append(now.done)
        if now.done > 60:
            raise _Stopped

    with pytest.raises(_Stopped):
        reduce_study(study, designs, state=state, watch=stop)
    first = seen[-1]
    assert 60 < first < 300
    seen.clear()
    again = reduce_study(study, designs, state=state, watch=lambda now: seen.append(now.done))
    assert seen[0] > first and seen[-1] == 300
    assert as_plain(again) == as_plain(whole)


def test_a_state_of_other_things_is_refused_and_stays(study: Study, designs: dict[str, Design], tmp_path: Path) -> None:
    state = tmp_path / "s"
    reduce_study(study, designs, state=state, part=Part(1, 10))
    kept = state.read_bytes()
    other = edited(designs["star"], {"description": "another"})
    with pytest.raises(DesignError) as refused:
        reduce_study(parse_study(STUDY.replace("seed = 3", "seed = 4")), {"star": other}, state=state)
    assert [problem.path for problem in refused.value.problems] == ["journal", "designs.star", "--shard"]
    state.write_bytes(kept[:-40] + b"0" * 40)
    with pytest.raises(DesignError, match="or a damaged one"):
        reduce_study(study, designs, state=state, part=Part(1, 10))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"random"', '"sobol"', "are drawn at once; at most 1,000,000"),
        ('"random"', '"nsga2"', "goes on from its rows"),
    ],
)
def test_methods_that_need_rows_or_all_draws_at_once_are_refused(old: str, new: str, said: str) -> None:
    count = "2000000" if new == '"sobol"' else "300"
    with pytest.raises(DesignError, match=said):
        parse_study(STUDY.replace(old, new).replace("count = 300", f"count = {count}"))


def test_independent_draws_are_the_same_a_part_at_a_time() -> None:
    from gearwright.study.cases import cases, unit_sample

    study = parse_study(STUDY.replace("count = 300", "count = 70000"))
    places = unit_sample(study)
    for case, place in zip(cases(study), places, strict=True):
        if case.number in (0, 65535, 65536, 69999):
            assert case.inputs["turbines.gas-turbine.speed_rpm"] == 15000.0 + 15000.0 * place[0]
