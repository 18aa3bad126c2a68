"""Profile shifts reach everything that is computed from the teeth."""

from __future__ import annotations

import pytest

from designs import PAIR
from gearwright.dynamics.assembly import gear_pairs
from gearwright.mission import Oil, gearbox_of
from gearwright.render.drawings.views.teeth import cylindrical_gear
from gearwright.sizing import Sizing, size
from gearwright.spec import parse

TEETH = "pinion_teeth = 18\nwheel_teeth = 54\n"


def shifted(shift: float) -> Sizing:
    return size(parse(f"{PAIR}{TEETH}\n[gears]\nhelix_angle_deg = 0\nprofile_shift = {shift}\n"))


@pytest.mark.parametrize(("shift", "factor"), [(0.0, 0.1670), (0.4, 0.1769)])
def test_losses_in_flight_know_the_shift(shift, factor):
    """H_V of 18/54 by hand: see the validation of losses."""
    box = gearbox_of(shifted(shift), "propeller", Oil(353.15, 4e-7, {}))
    assert box.contacts[0].loss_factor == pytest.approx(factor, abs=5e-5)


def test_stiffness_and_contact_ratio_of_the_dynamics_know_the_shift():
    """By hand: ε_α = 1.648770 without a shift and 1.559706 with 0.4."""
    plain, cut = (gear_pairs(shifted(shift))["stage"] for shift in (0.0, 0.4))
    assert (cut.driver.profile_shift, cut.driven.profile_shift) == (0.4, -0.4)
    assert plain.transverse_contact_ratio == pytest.approx(1.648770, abs=3e-5)
    assert cut.transverse_contact_ratio == pytest.approx(1.559706, abs=3e-5)


def test_shifts_of_both_gears_add_up_to_nothing():
    """x_1 + x_2 = 0 keeps the centre distance."""
    sizing = shifted(0.3)
    shifts = [gear.profile_shift for gear in sizing.gears]
    assert sorted(shifts) == [-0.3, 0.3]
    assert [cylindrical_gear(sizing, gear).profile_shift for gear in sizing.gears] == shifts
