"""What a sizing keeps of where everything stands."""

import pytest
from shaft_designs import OFF_SET

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse, read
from mounted_designs import HELICOPTER, sized


@pytest.mark.parametrize("name", shipped_designs())
def test_shafts_and_drawings_read_one_arrangement(name):
    """Every shaft has its axis, its length and its bearings from it; the same numbers, not near ones."""
    sizing = size(read(shipped_design(name)))
    assert list(sizing.arrangement.axes) == list(sizing.arrangement.plans) == sizing.design.shafts
    for shaft in sizing.shafts:
        plan = sizing.arrangement.plans[shaft.name]
        assert complex(*shaft.axis) == sizing.arrangement.axes[shaft.name]
        assert shaft.length == plan.length
        assert [bearing.position for bearing in shaft.bearings] in ([], list(plan.bearings))


def test_a_plan_names_the_bearings_of_its_shaft_in_order_along_it():
    sizing = sized(HELICOPTER)
    for shaft, plan in sizing.arrangement.plans.items():
        given = {name: seat for name, seat in sizing.design.bearings.items() if seat.shaft == shaft}
        assert dict(plan.seats) == given
        assert [seat.position for seat in plan.seats.values()] == sorted(seat.position for seat in given.values())
        assert plan.bearings == tuple(seat.position for seat in plan.seats.values() if seat.radial)


def test_shafts_that_are_too_short_are_told_all_at_once():
    short = "[layout.left]\nlength_mm = 1\n[layout.right]\nlength_mm = 1\n"
    with pytest.raises(DesignError) as error:
        size(parse(OFF_SET + short))
    paths = [problem.path for problem in error.value.problems]
    assert {"layout.left.length_mm", "layout.right.length_mm"} <= set(paths)
