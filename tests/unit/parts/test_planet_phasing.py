"""Relative phases of planetary meshes."""

import math

import pytest
from hypothesis import given, strategies as st

from gearwright.errors import DesignError
from gearwright.parts.gears import CylindricalGear, GearPair, half_angle_at
from gearwright.parts.planetary import even_positions, excited_modes, planet_phases, sun_to_ring_phase


def planetary(sun, planet, *, shifts=(0.0, 0.0, 0.0)):
    ring = sun + 2 * planet
    s, p, r = (
        CylindricalGear(z, 2e-3, 0.02, profile_shift=x) for z, x in zip((sun, planet, -ring), shifts, strict=True)
    )
    return GearPair(s, p), GearPair(p, r)


@pytest.mark.parametrize(("planet", "phase"), [(20, 0.5), (21, 0.0), (33, 0.0), (48, 0.5)])
def test_without_shift_the_ring_mesh_is_half_a_cycle_off_for_an_even_planet(planet, phase):
    """Tooth and space face each other across an odd planet, tooth and tooth across an even one; exact."""
    assert sun_to_ring_phase(*planetary(24, planet)) == pytest.approx(phase, abs=1e-12)


@pytest.mark.parametrize("shifts", [(0.3, 0.2, 0.0), (0.1, -0.1, 0.4), (0.5, 0.3, -0.2)])
def test_the_ring_phase_is_when_the_ring_flank_reaches_its_pitch_point(shifts):
    """Count the planet's flanks at the two working pitch radii: sun side on one flank, ring side on the other."""
    sun_mesh, ring_mesh = planetary(24, 21, shifts=shifts)
    planet = sun_mesh.driven
    at_sun = planet.base_radius / math.cos(sun_mesh.working_pressure_angle)
    at_ring = planet.base_radius / math.cos(ring_mesh.working_pressure_angle)
    pitch = 2.0 * math.pi / planet.teeth
    # The trailing flank of tooth 0 is at angle 0 on the sun's side; its leading flank at the ring's working radius:
    leading = half_angle_at(planet, at_sun) + half_angle_at(planet, at_ring)
    wait = (math.pi - leading) % pitch
    assert sun_to_ring_phase(sun_mesh, ring_mesh) == pytest.approx((-wait / pitch) % 1.0, abs=1e-9)


@given(st.integers(15, 60), st.integers(15, 60), st.integers(3, 7))
def test_sun_and_ring_meshes_of_every_planet_keep_the_same_phase_between_them(sun, planet, planets):
    """Parker & Lin 2004: γ_rn − γ_sn is the same for all planets, as (z_s + z_r) ψ_n/2π is whole."""
    if (2 * sun + 2 * planet) % planets:
        with pytest.raises(DesignError, match="whole multiples"):
            planet_phases(*planetary(sun, planet), even_positions(planets))
        return
    phases = planet_phases(*planetary(sun, planet), even_positions(planets))
    gaps = [math.e ** (2j * math.pi * (r - s)) for s, r in zip(phases.sun, phases.ring, strict=True)]
    assert gaps == pytest.approx([gaps[0]] * planets, abs=1e-6)


def test_phases_by_hand():
    """z_s = 27, N = 4: −27/4 of a cycle per planet, that is 0, 1/4, 1/2, 3/4; z_r = 69 and an odd planet: the same."""
    phases = planet_phases(*planetary(27, 21), even_positions(4))
    assert phases.sun == pytest.approx((0.0, 0.25, 0.5, 0.75))
    assert phases.ring == pytest.approx((0.0, 0.25, 0.5, 0.75), abs=1e-9)


@pytest.mark.parametrize(
    ("sun", "planets", "harmonic", "family"),
    [
        (24, 4, 1, "rotational"),
        (27, 4, 1, "translational"),
        (26, 4, 1, "planet"),
        (26, 4, 2, "rotational"),
        (31, 5, 4, "translational"),
    ],
)
def test_phasing_chooses_the_modes_that_are_excited(sun, planets, harmonic, family):
    """Parker 2000: l z_s mod N."""
    assert excited_modes(sun, planets, harmonic) == family
