"""A propeller at incidence against axial flow, symmetry, and the fin that it is without induced speed."""

import math

import numpy as np
import pytest

from gearwright.machines import Blades
from gearwright.machines.propellers import SectionLoads, generic_blade, inclined, loads

SIX = generic_blade(Blades(6, 115.0, 0.5))
CRUISE = (2.0, math.radians(42.0))


def test_without_incidence_it_is_the_axial_propeller():
    found, axial = inclined(SIX, *CRUISE, incidence=0.0), loads(SIX, *CRUISE)
    assert found.thrust == pytest.approx(float(axial.thrust), rel=1e-12)
    assert found.power == pytest.approx(float(axial.power), rel=1e-12)
    assert abs(found.normal) < 1e-15
    assert found.once_a_turn < 1e-15


def test_the_force_turns_with_the_incidence_and_grows_with_it():
    """Odd in the angle, and linear to 2 % at 1° and 2°."""
    up, down = (inclined(SIX, *CRUISE, incidence=math.radians(angle)) for angle in (2.0, -2.0))
    one = inclined(SIX, *CRUISE, incidence=math.radians(1.0))
    assert down.normal == pytest.approx(-up.normal, rel=1e-9)
    assert down.yaw == pytest.approx(-up.yaw, rel=1e-9)
    assert up.normal == pytest.approx(2.0 * one.normal, rel=0.02)


def test_narrow_blades_along_the_helix_are_a_fin():
    """Ribner, Formulas for propellers in yaw (NACA, 1945): a fin of the projected side area.

    Without induced speed, and with blades that bear nothing in axial flow, that is exact:
    N = ½ ρ V² a α B/2 ∫ c sin φ dr with the section's slope a; 1 % of elements and angle.
    """
    slope, ratio, angle = 6.0, 1.5, math.radians(0.5)
    chord = 1e-5

    def thin(angle, design_lift, thickness, mach):
        del design_lift, thickness, mach
        return SectionLoads(slope * angle, 0.0 * angle)

    helix = np.arctan(ratio / (math.pi * SIX.radius))
    at = math.atan(ratio / (math.pi * 0.75))
    shape = SIX._replace(polar=thin, losses=False, chord=np.full_like(SIX.radius, chord), twist=helix - at)
    found = inclined(shape, ratio, at, incidence=angle)
    area = 6 / 2 * float(np.sum(chord / 2.0 * np.sin(helix) * SIX.width / 2.0))  # over D²
    assert found.normal == pytest.approx(0.5 * ratio**2 * slope * angle * area, rel=0.01)


def test_the_hub_moment_is_half_of_what_all_blades_bend_once_a_turn():
    """The mean of B M sin ψ with M = M_1 sin ψ is B M_1/2."""
    found = inclined(SIX, *CRUISE, incidence=math.radians(1.0))
    assert abs(found.yaw) == pytest.approx(6 * found.once_a_turn / 2.0, rel=1e-3)


def test_incidences_that_are_no_small_part_are_refused():
    with pytest.raises(ValueError, match="at most 30°"):
        inclined(SIX, *CRUISE, incidence=math.radians(31.0))
    with pytest.raises(ValueError, match="faster than the blades' roots turn"):
        inclined(SIX, 6.0, math.radians(70.0), incidence=math.radians(20.0))
