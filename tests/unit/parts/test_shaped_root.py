"""The fillet that a shaper cutter leaves in a ring, against the envelope of its tip and against the rack."""

from dataclasses import replace

import numpy as np
import pytest

from designs import problem
from gearwright.errors import SolveError
from gearwright.parts.iso6336 import (
    Edition,
    LoadedTooth,
    ShaperCutter,
    ToothProportions,
    outer_single_contact,
    root_section,
)
from gearwright.parts.iso6336.geometry import shaped_fillet
from gearwright.sizing import size
from gearwright.spec import parse
from gearwright.validate.gears.ratings import PLANET_RING

ALPHA = np.radians(20.0)
RING = ToothProportions(1.25, 0.3, -0.5013, cutter=ShaperCutter(36.0))


def enveloped(tooth: ToothProportions, teeth: float) -> tuple[float, float]:
    """Chord and radius at the 60° tangent of the traced envelope, by small steps of roll and finite differences."""
    cutter = tooth.cutter
    assert cutter is not None
    inv = lambda angle: np.tan(angle) - angle  # noqa: E731
    wanted = inv(ALPHA) - 2.0 * (cutter.shift + tooth.profile_shift) / (teeth - cutter.teeth) * np.tan(ALPHA)
    angles = np.linspace(0.05, 0.9, 400_001)
    working = float(np.interp(wanted, inv(angles), angles))
    centre = 0.5 * (teeth - cutter.teeth) * np.cos(ALPHA) / np.cos(working)
    base = 0.5 * cutter.teeth * np.cos(ALPHA)
    reach = 0.5 * teeth + tooth.dedendum - tooth.profile_shift - centre - tooth.fillet_radius
    half = (0.5 * np.pi + 2.0 * cutter.shift * np.tan(ALPHA)) / cutter.teeth + inv(ALPHA)
    half -= inv(np.arccos(base / reach)) + tooth.fillet_radius / base
    roll = np.linspace(-0.15, 0.15, 60_001)
    tip = centre + reach * np.exp(1j * (half + roll))
    away = tip - centre * teeth / (teeth - cutter.teeth)
    touched = tip + tooth.fillet_radius * away / np.abs(away)
    seen = touched * np.exp(-1j * (roll * cutter.teeth / teeth + np.pi / teeth))
    slope = np.gradient(seen, roll)
    tangent = np.unwrap(np.angle(slope))
    steep = np.abs(np.tan(tangent)) - np.tan(np.radians(60.0))
    crossings = np.flatnonzero(np.diff(np.sign(steep)))
    at = max(crossings, key=lambda index: seen[index].imag)
    curvature = np.gradient(tangent, roll)[at] / np.abs(slope[at])
    return float(-2.0 * seen[at].imag), float(1.0 / abs(curvature))


@pytest.mark.parametrize(
    ("cutter", "shift", "radius"), [(36.0, -0.5013, 0.3), (30.0, 0.0, 0.25), (20.0, 0.2, 0.2), (25.0, -0.3, 0.1)]
)
def test_the_fillet_of_a_shaped_ring_is_the_envelope_of_the_cutters_tip(cutter, shift, radius):
    """Traced in steps of 5e-6 rad; 1e-3 is what finite differences leave of the curvature."""
    tooth = ToothProportions(1.25, radius, shift, cutter=ShaperCutter(cutter))
    touched = shaped_fillet(tooth, 56.0, ALPHA)
    assert (float(touched.chord), float(touched.radius)) == pytest.approx(enveloped(tooth, 56.0), rel=1e-3)


def test_a_cutter_and_a_ring_without_end_are_racks():
    """With z_n and z_0 endless the cutter and the rack leave the same fillet: the tip's own radius."""
    tooth = ToothProportions(1.25, 0.25)
    load = LoadedTooth(-4e6, -(4e6 - 1.0), ALPHA, tooth)
    rack = root_section(load)
    shaped = root_section(replace(load, tooth=replace(tooth, cutter=ShaperCutter(1e6))))
    assert float(shaped.chord) == pytest.approx(float(rack.chord), rel=1e-5)
    assert float(shaped.fillet_radius) == pytest.approx(float(rack.fillet_radius), rel=2e-5)
    assert float(shaped.fillet_radius) == pytest.approx(0.25, rel=1e-5)
    assert float(shaped.lever) == pytest.approx(float(rack.lever), rel=1e-4)


def test_an_array_of_rings_is_shaped_as_each_alone():
    shifts = np.array([-0.5, -0.2, 0.1])
    teeth = np.array([56.0, 80.0, 100.0])
    cutter = ShaperCutter(30.0)
    every = shaped_fillet(ToothProportions(1.25, 0.2, shifts, cutter=cutter), teeth, ALPHA)
    for index, (shift, number) in enumerate(zip(shifts, teeth, strict=True)):
        alone = shaped_fillet(ToothProportions(1.25, 0.2, float(shift), cutter=cutter), float(number), ALPHA)
        assert [float(value[index]) for value in every] == pytest.approx([float(value) for value in alone], rel=1e-12)


def test_the_edition_of_2006_puts_a_rack_in_place_of_the_cutter():
    """KISSsoft's report of this ring has ρ_F = 0.494 m_n; the contour that the cutter really leaves has 0.302."""
    load = outer_single_contact(replace(PLANET_RING, proportions=(PLANET_RING.proportions[0], RING)), 1)
    assert float(root_section(load, Edition.ISO2006).fillet_radius) == pytest.approx(0.494, abs=5e-4)
    assert float(root_section(load, Edition.ISO2019).fillet_radius) == pytest.approx(0.3016, abs=5e-4)


def test_a_rounder_tip_leaves_a_rounder_fillet_and_a_smaller_notch():
    sharp, round_ = (
        root_section(LoadedTooth(-72.0, -71.0, ALPHA, ToothProportions(1.25, radius, cutter=ShaperCutter(30.0))))
        for radius in (0.1, 0.3)
    )
    assert round_.fillet_radius > sharp.fillet_radius
    assert round_.stress_correction < sharp.stress_correction


def test_a_tip_without_room_for_its_roundings_is_refused():
    with pytest.raises(SolveError, match="too narrow"):
        shaped_fillet(replace(RING, fillet_radius=0.6), 56.0, ALPHA)


SET = """\
schema = 1
name = "A set whose ring is shaped"
level = "concept"
shafts = ["fast", "slow"]
motors.drive = { shaft = "fast", power_kw = 200, speed_rpm = 6000 }
propellers.load = { shaft = "slow", speed_rpm = 1500, diameter_m = 2 }
gears = { rating = "iso6336", iso6336 = { RULES } }

[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 24
planet_teeth = 24
ring_teeth = 72
"""


def ring_design(rules: str) -> str:
    return SET.replace("RULES", rules)


def test_a_designs_ring_is_rated_by_its_cutter():
    """The fillet in the rating is that of the cutter of 30 teeth with a tip of 0.2 m_n, for a ring of 72."""
    sizing = size(parse(ring_design("ring_cutter = { teeth = 30, tip_radius = 0.2 }")))
    rated = next(mesh for mesh in sizing.meshes if mesh.name == "set.planet-ring").rating
    touched = shaped_fillet(ToothProportions(1.25, 0.2, cutter=ShaperCutter(30.0)), 72.0, ALPHA)
    assert float(rated.factors.bending[1].section.fillet_radius) == pytest.approx(float(touched.radius), rel=1e-12)


@pytest.mark.parametrize(
    ("rules", "told"),
    [
        ("ring_cutter = { teeth = 72 }", "72 given; a ring of 72 teeth is cut by fewer"),
        ("ring_cutter = { teeth = 30, tip_radius = 0.55 }", "too narrow for this radius"),
        ("ring_cutter = { teeth = 2 }", "5"),
        ("ring_cutter = { tip_radius = 0.2 }", "teeth"),
    ],
)
def test_a_cutter_that_cuts_no_such_ring_is_told(rules, told):
    found = problem(ring_design(rules), sized=True)
    assert "ring_cutter" in found.path
    assert told in found.message + found.path
