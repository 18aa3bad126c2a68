"""The involute's closed forms against each other and against textbook numbers."""

import math

import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.gears import (
    involute,
    involute_angle,
    least_profile_shift,
    least_teeth,
    shift_sum,
    working_pressure_angle,
)
from gearwright.parts.gears.cylindrical_gear import virtual_teeth

TWENTY = math.radians(20.0)


@given(st.floats(0.05, 1.5))
def test_the_inverse_involute_undoes_the_involute(angle):
    """ISO 21771. Rounding of tan α − α limits the angle to about 1e-16/tan² α, 4e-14 at the small end."""
    assert involute_angle(involute(angle)) == pytest.approx(angle, rel=2e-12)


def test_a_negative_involute_is_refused():
    with pytest.raises(DesignError, match="no angle"):
        involute_angle(-1e-3)


@given(st.integers(12, 80), st.integers(12, 150), st.floats(-0.3, 1.0), st.floats(0.0, 0.5))
def test_shift_and_working_angle_are_inverse(first, second, shift, helix):
    """ISO 21771; rounding only."""
    angle = working_pressure_angle(first + second, shift, pressure_angle=TWENTY, helix_angle=helix)
    assert shift_sum(first + second, angle, pressure_angle=TWENTY, helix_angle=helix) == pytest.approx(shift, abs=1e-9)


def test_seventeen_teeth_are_the_last_without_undercut():
    """Textbook: z_min = 2/sin² 20° = 17.1 for a straight dedendum of one module; exact to the printed digit."""
    assert least_teeth(1.0, pressure_angle=TWENTY, helix_angle=0.0) == pytest.approx(17.1, abs=0.05)
    assert least_profile_shift(18, 1.0, pressure_angle=TWENTY, helix_angle=0.0) < 0.0
    assert least_profile_shift(17, 1.0, pressure_angle=TWENTY, helix_angle=0.0) > 0.0


@pytest.mark.parametrize(("teeth", "virtual"), [(17, 18.905), (103, 114.543)])
def test_virtual_teeth_of_the_iso_example(teeth, virtual):
    """ISO/TR 6336-30:2017, example 1, β = 15.8°; printed to three decimals."""
    assert virtual_teeth(teeth, TWENTY, math.radians(15.8)) == pytest.approx(virtual, abs=6e-4)
