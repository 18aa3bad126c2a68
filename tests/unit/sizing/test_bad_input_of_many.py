"""Tables of designs that nobody meant: what is wrong in all of them is refused, what is wrong in one costs that one."""

from __future__ import annotations

import math

import numpy as np
import pytest

import gearwright as gw
from gearwright.sizing import size, size_many
from gearwright.sizing.many.sizings import LANES
from gearwright.spec import edited, read

HYBRID, MIXED = read("in-line-h2"), read("mixed-h2")
SPEED = "motors.electric.speed_rpm"
MODULE = "planetaries.first.module_mm"


@pytest.mark.parametrize(
    ("axes", "said"),
    [
        ({"motors.electrc.speed_rpm": [1.0]}, r"motors\.electrc\.speed_rpm: there is no motors\.electrc; did you mean"),
        ({SPEED: [4e3], "motors.electric.speed_rad_s": [4e2]}, "speed is given twice; keep one of motors.electric"),
        ({SPEED: [4e3, 5e3], MODULE: [2.0]}, "columns of different lengths: motors.electric.speed_rpm 2, planetaries"),
        ({SPEED: 4e3}, "motors.electric.speed_rpm: 4000.0 is no column; give a list with its value in every row"),
        ({SPEED: "4000"}, "motors.electric.speed_rpm: '4000' is no column; give a list"),
        ({SPEED: np.ones((3, 2))}, "an array of 3×2 is no column; give one value for every row"),
    ],
)
def test_axes_that_are_wrong_in_every_row_are_refused_with_path_value_and_fix(axes, said: str) -> None:
    with pytest.raises(gw.DesignError, match=said):
        size_many(HYBRID, axes)


def test_everything_that_is_wrong_is_said_at_once() -> None:
    with pytest.raises(gw.DesignError) as refused:
        size_many(HYBRID, {SPEED: 4e3, MODULE: {"a": 1}})
    assert [problem.path for problem in refused.value.problems] == [SPEED, MODULE]


@pytest.mark.parametrize(("designs", "axes"), [([], None), ([], {SPEED: []}), (HYBRID, {SPEED: []})])
def test_a_batch_of_no_designs_is_a_table_of_no_rows(designs, axes) -> None:
    sizings = size_many(designs, axes)
    assert len(sizings) == 0 and sizings.structures == () and not sizings.reasons
    with pytest.raises(gw.DesignError, match="0 is no row; there are 0"):
        sizings.at(0)


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        (math.nan, "nan is not allowed; give a finite number"),
        (math.inf, "inf is not allowed; give a finite number"),
        (-1.0, "-1.0 rpm is not allowed; give a value from"),
        ("4000 rpm", "'4000 rpm' is not a number; give a number in rpm"),
        (True, "True is not a number; give a number in rpm"),
        ([4000.0], r"\[4000\.0\] is not a number; give a number in rpm"),
        (10**400, "is not a finite number; give a finite number in rpm"),
    ],
)
@pytest.mark.parametrize("place", [0, 13])
def test_one_cell_among_many_that_is_no_number_costs_its_own_row_alone(cell, said: str, place: int) -> None:
    cells = [*np.linspace(4400.0, 4600.0, 30).tolist()]
    cells[place] = cell
    sizings = size_many(HYBRID, {SPEED: cells}, results=["mass"])
    assert list(sizings.reasons) == [place] and np.flatnonzero(np.isnan(sizings.columns["mass"])).tolist() == [place]
    with pytest.raises(gw.DesignError, match=said):
        sizings.at(place)
    assert sizings.reasons[place].startswith(f"{SPEED}: ")
    assert sizings.together.sum() > 12, "the others go together all the same"


def test_an_override_on_some_designs_only_leaves_the_others_their_own() -> None:
    given = [None] * 15 + [3.0] * 14 + [-3.0]
    sizings = size_many(HYBRID, {SPEED: [4500.0] * 30, MODULE: given}, results=["mass"])
    own, other = size(HYBRID).mass, size(edited(HYBRID, {MODULE: 3.0})).mass
    assert own != other
    assert sizings.columns["mass"][:29].tolist() == [own] * 15 + [other] * 14
    assert sizings.reasons == {29: f"{MODULE}: -3.0 mm is not allowed; give a value from 0.1 to 100 mm"}


def test_numbers_of_planets_are_columns_and_those_that_do_not_fit_are_told() -> None:
    planets = [4, 5, 9] * 14
    sizings = size_many(HYBRID, {"planetaries.second.planets": planets, SPEED: [4500.0 + k for k in range(42)]})
    assert {planets[row] for row in sizings.reasons} == {9}
    assert sizings.together.sum() > 12
    for row in (0, 1):
        assert sizings.columns["mass"][row] == sizings.at(row).mass


def test_designs_of_other_structure_stand_side_by_side() -> None:
    """An axis of a part that only one of them has is a reason in the other's row."""
    sizings = size_many([HYBRID, MIXED, HYBRID])
    assert len(sizings.structures) == 2 and sizings.structure.tolist() == [0, 1, 0]
    assert sizings.columns["mass"].tolist() == [size(design).mass for design in (HYBRID, MIXED, HYBRID)]
    turbine = read("ec120b")
    sizings = size_many([HYBRID, turbine], {SPEED: [4500.0, 4500.0]}, results=["mass"])
    assert list(sizings.reasons) == [1] and sizings.reasons[1].startswith("motors.electric")


def test_keep_outs_that_leave_no_room_are_checks_that_fail_by_name_in_their_rows_alone() -> None:
    walled = HYBRID.model_dump(by_alias=True, exclude_unset=True)
    walled["keep_out"] = {
        "wall": {
            "reason": "frame",
            "start": {"x": -9.0, "y": -9.0, "z": 1.0},
            "end": {"x": 9.0, "y": 9.0, "z": 2.0},
        }
    }
    design = type(HYBRID).model_validate(walled)
    heights = [1000.0] * 14 + [-900.0] * 14
    sizings = size_many(design, {"keep_out.wall.start.z_mm": heights}, results=["mass", "worst_margin"])
    margins = sizings.columns["worst_margin"]
    assert (margins[14:] < margins[0]).all() and (margins[:14] == margins[0]).all()
    failing = [check for check in sizings.at(20).checks if check.ratio is not None and check.ratio < 1.0]
    assert any("wall" in check.name for check in failing)
    assert margins[20] == sizings.at(20).worst_margin


def test_one_cell_that_is_no_number_is_refused_alone_also_beyond_the_first_lanes() -> None:
    """More rows than go together at once, by one, so that the last one stands alone behind them."""
    count, bad = LANES + 40, LANES + 17
    speeds = np.linspace(4400.0, 4600.0, count)
    speeds[bad] = math.nan
    sizings = size_many(HYBRID, {SPEED: speeds}, results=["mass"])
    assert list(sizings.reasons) == [bad]
    assert np.flatnonzero(~np.isfinite(sizings.columns["mass"])).tolist() == [bad]
    assert sizings.together.sum() == count - 1
    assert sizings.columns["mass"][bad - 1] == sizings.at(bad - 1).mass
