"""Maps of C_P and C_T: reading, looking up, inverting, and refusing."""

import math

import numba
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from gearwright.catalogue import map_of, propeller_map, read_propeller_map
from gearwright.errors import DesignError
from gearwright.machines import angle_for_power, angle_for_thrust, coefficients, look_up

SIX = propeller_map("6-blades-af115")
HEAD = "advance_ratio,blade_angle_deg,power_coefficient,thrust_coefficient\n"
SMALL = HEAD + "0,10,0.1,0.2\n0,20,0.3,0.4\n1,10,0.05,0.1\n1,20,0.2,0.3\n"


@settings(max_examples=60)
@given(st.floats(0.0, 3.9), st.floats(0.01, 0.99))
def test_the_angle_for_a_power_takes_that_power(ratio, part):
    """The inverse is exact for the bilinear map; 1e-9 is rounding."""
    i = min(int(np.searchsorted(SIX.advance_ratio, ratio)), len(SIX.advance_ratio) - 1)
    i = max(i, 1)
    low = max(SIX.first[i - 1], SIX.first[i])
    high = min(SIX.last[i - 1], SIX.last[i])
    angle = SIX.blade_angle[low] + part * (SIX.blade_angle[high] - SIX.blade_angle[low])
    found = coefficients(SIX, ratio, angle)
    assert angle_for_power(SIX, ratio, found.power) == pytest.approx(angle, abs=1e-9)
    assert angle_for_thrust(SIX, ratio, found.thrust) == pytest.approx(angle, abs=1e-9)


def test_a_node_of_the_map_is_its_own_value():
    found = coefficients(map_of(SMALL, "small"), 1.0, math.radians(20.0))
    assert found[:2] == pytest.approx((0.2, 0.3), rel=1e-12)


def test_a_compiled_kernel_reads_the_same_map():
    compiled = numba.njit(look_up)
    for ratio, angle in ((0.43, 0.2), (2.0, 0.75), (2.0, 0.1), (9.0, 0.75)):
        assert tuple(compiled(SIX, ratio, angle)) == pytest.approx(tuple(look_up(SIX, ratio, angle)), rel=1e-14)


@pytest.mark.parametrize(("ratio", "angle"), [(2.0, 10.0), (0.4, 60.0), (5.0, 60.0), (-0.1, 10.0)])
def test_a_point_outside_the_map_is_named(ratio, angle):
    assert look_up(SIX, ratio, math.radians(angle)).status == 1
    with pytest.raises(DesignError, match=f"advance ratio {ratio:g}, blade angle {angle:g}°: outside the map"):
        coefficients(SIX, ratio, math.radians(angle))


def test_a_power_that_no_blade_angle_takes_is_refused():
    with pytest.raises(DesignError, match="power coefficient 2, of"):
        angle_for_power(SIX, 1.0, 2.0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a,b\n1,2\n", "lacks advance_ratio and"),
        (HEAD, "at least two"),
        (SMALL + "1,x,0.1,0.1\n", "has no 4 numbers in line 6"),
        (SMALL + "1,30,nan,0.1\n", "has no 4 numbers in line 6"),
        (SMALL + "1,20,0.1,0.1\n", "given twice"),
        (SMALL + "0,40,0.5,0.5\n1,30,0.1,0.1\n", "gap between its blade angles"),
    ],
)
def test_a_file_that_is_no_map_is_refused(text, message):
    with pytest.raises(DesignError, match=message):
        map_of(text, "own.csv")


def test_a_users_own_file_is_read(tmp_path):
    (tmp_path / "own.csv").write_text(SMALL, encoding="utf-8")
    assert read_propeller_map(tmp_path / "own.csv").power[1, 1] == 0.2
    with pytest.raises(DesignError, match="there is no such file"):
        read_propeller_map(tmp_path / "none.csv")


def test_an_unknown_shipped_map_names_the_nearest():
    with pytest.raises(DesignError, match="did you mean 6-blades-af115"):
        propeller_map("6-blades-af11")
