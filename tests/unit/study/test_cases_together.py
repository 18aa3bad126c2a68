"""Cases that are sized together: every row is what the case gives alone, to the last bit, whatever stands beside it."""

from __future__ import annotations

import math
import pickle
import random

import pytest

from gearwright.sizing import Named
from gearwright.spec import Study, parse_study, read
from gearwright.study.cases import LEAST, Case, cases, evaluate, evaluated, goes_together
from gearwright.study.tables import Row, blocks_of
from gearwright.study.workers import LAST, Pace

DESIGNS = {name: read(name) for name in ("in-line-h2", "mixed-h2")}
STUDY = """
schema = 1
name = "together"
designs = ["in-line-h2", "mixed-h2"]
results = {results}
[changes]
"gears.contact_safety" = 1.35
[axes]
"motors.electric.speed_rpm" = {{from = 2500, to = 5500}}
"carriers.fill" = {{from = 0.4, to = 0.8}}
"planetaries.second.planets" = {{values = [4, 5, 9]}}
[sampling]
method = "sobol"
count = 128
"""


def study_of(results: str = '["mass", "total_mass", "worst_margin"]') -> Study:
    return parse_study(STUDY.format(results=results))


def one_by_one(study: Study, some: list[Case]) -> dict[int, Row]:
    return {case.number: evaluate(study, DESIGNS[case.design], case) for case in some}


def same(row: Row, other: Row) -> bool:
    """Tell whether two rows have the same bits; what is no number counts as itself."""
    return repr(row) == repr(other)


@pytest.fixture(scope="module")
def drawn() -> list[Case]:
    return list(cases(study_of()))


@pytest.fixture(scope="module")
def alone(drawn: list[Case]) -> dict[int, Row]:
    return one_by_one(study_of(), drawn)


def test_rows_and_reasons_are_those_of_each_case_alone(drawn: list[Case], alone: dict[int, Row]) -> None:
    """Two designs, three numbers of planets of which one does not fit, and rows that part in the search."""
    found = dict(evaluated(study_of(), DESIGNS, drawn))
    assert {number for number, row in alone.items() if row.problem}
    assert [number for number, row in alone.items() if not same(row, found.pop(number))] == [] and not found


def test_whatever_stands_beside_a_case_its_row_is_the_same(drawn: list[Case], alone: dict[int, Row]) -> None:
    some = random.Random(3).sample(drawn, 100)
    assert all(same(row, alone[number]) for number, row in evaluated(study_of(), DESIGNS, some))


def test_one_value_that_is_none_costs_its_own_row_alone(drawn: list[Case], alone: dict[int, Row]) -> None:
    """The first case, whose design others are made of; a value beyond what the entry takes; one of another kind."""
    path = "motors.electric.speed_rpm"
    bad = {0: math.nan, 5: -1.0, 7: "fast", 9: True, 11: 10**400}
    own = [case for case in drawn if case.design == "in-line-h2"]
    some = [
        case._replace(inputs={**case.inputs, path: bad[case.number]}) if case.number in bad else case for case in own
    ]
    expected = one_by_one(study_of(), [case for case in some if case.number in bad])
    assert all(f"{path}: " in row.problem for row in expected.values())
    for number, row in evaluated(study_of(), DESIGNS, some):
        assert same(row, expected.get(number, alone[number]))


def test_results_of_parts_and_such_that_are_not_there_are_told_as_alone(drawn: list[Case]) -> None:
    """A row without the part says so by itself."""
    study = study_of('["mass", "gears.first.sun.module", "machines.electric.mass", "gears.none.module"]')
    some = drawn[:70]
    expected = one_by_one(study, some)
    assert "results.gears.none.module" in expected[1].problem
    assert all(same(row, expected[number]) for number, row in evaluated(study, DESIGNS, some))


def test_a_change_that_no_design_takes_is_a_reason_in_every_row(drawn: list[Case]) -> None:
    study = study_of().model_copy(update={"changes": {"gears.contact_safety": -1.0}})
    expected = one_by_one(study, drawn[:66])
    assert all(same(row, expected[number]) for number, row in evaluated(study, DESIGNS, drawn[:66]))


@pytest.mark.parametrize(
    ("results", "together"),
    [('["mass"]', True), ('["mass", "modes.frequency_1"]', False), ('["review.margin"]', False)],
)
def test_what_other_verbs_compute_goes_one_by_one(results: str, together: bool) -> None:
    assert goes_together(study_of(results)) is together


def test_rows_come_out_of_their_blocks_as_they_went_in() -> None:
    values = [1.0, -0.0, math.inf, 3, True, "text", 2**70, 5e-324, float("nan")]
    rows = {
        number: Row("d", {"a": value, "b": 2.0}, {"r": Named(1.5 * number, "mass"), "t": Named("who", "text")})
        for number, value in enumerate(values)
    }
    rows[20] = Row("d", {"a": 1.0}, {}, "it does not fit")
    rows[21] = Row("other", {}, {"r": Named(1, "mass")})
    blocks = pickle.loads(pickle.dumps(blocks_of(rows.items())))
    assert len(blocks) == len(rows) and blocks.failed == 1
    found = dict(blocks)
    assert sorted(found) == sorted(rows)
    for number in rows.keys() - {21}:
        assert same(found[number], rows[number])
    assert found[21] == rows[21]


def test_chunks_grow_by_two_and_never_take_longer_than_they_should() -> None:
    pace = Pace(together=True)
    sizes = []
    for _ in range(16):
        sizes.append(pace.size)
        pace.note(pace.size, 1e-4 * pace.size)
    assert sizes[:8] == [LEAST * 2**k for k in range(8)] and sizes[-1] == 8192
    pace.note(1000, 1000.0)
    assert pace.size == 3
    assert Pace(together=True, size=2048, known=True).next_of(1000, 4) == LAST, "the last chunks are smaller"
    assert Pace(together=True).next_of(100, 4) == 25, "few cases are for all workers"
    assert Pace(together=False).size == 1
