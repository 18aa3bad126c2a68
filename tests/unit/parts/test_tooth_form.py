"""The outline of a tooth and its compliance."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from gearwright.errors import DesignError
from gearwright.parts import Material
from gearwright.parts.gears import BasicRack, CylindricalGear, half_angle_at, load_point, tooth_form
from gearwright.parts.stiffness import SHEAR_FACTOR, half_plane_foundation, held_body_foundation, tooth_compliance

STEEL = Material("steel", 206e9, 0.3, 7850.0)


def gear(teeth, shift=0.0, **more):
    return CylindricalGear(teeth, 2e-3, 0.02, profile_shift=shift, **more)


@pytest.mark.parametrize("teeth", [12, 20, 60, -60, -120])
def test_the_outline_passes_the_pitch_circle_with_the_right_thickness(teeth):
    """ISO 21771: half thickness r sin ψ at the reference radius; 400 chords are good to 2e-6 of a module."""
    part, form = gear(teeth, 0.2), tooth_form(gear(teeth, 0.2))
    height, half, _ = load_point(form, np.array([part.pitch_radius]))
    expected = part.pitch_radius * math.sin(half_angle_at(part, part.pitch_radius))
    assert half[0] == pytest.approx(expected)
    assert np.interp(height[0], form.height, form.half_thickness) == pytest.approx(expected, abs=4e-9)


@pytest.mark.parametrize("teeth", [12, 18, 25, 80, -50, -150])
def test_the_outline_rises_and_has_the_tooths_height(teeth):
    """Root to tip is 2.25 modules, less the arrow height of the tip chord, below 0.03 modules here."""
    form = tooth_form(gear(teeth))
    assert np.all(np.diff(form.height) > 0.0)
    # The root chord lies r_f (1 − cos θ_f) below the root circle's crown for external teeth, above it for rings.
    crown = form.side * form.root_radius * (1.0 - math.cos(form.root_half_angle))
    assert form.height[-1] - crown == pytest.approx(2.25 * 2e-3, abs=0.03 * 2e-3)


@pytest.mark.parametrize("teeth", [20, 40, -60])
def test_the_fillet_runs_smoothly_into_the_flank(teeth):
    """No undercut: between neighbouring points the outline turns by no more than the fillet asks, 0.1 rad."""
    form = tooth_form(gear(teeth))
    direction = np.arctan2(np.diff(form.height), -np.diff(form.half_thickness))
    assert np.max(np.abs(np.diff(direction))) < 0.1


def test_undercut_takes_material_from_the_root():
    """z = 10 without shift is undercut by the rack: the narrowest section lies inside the tooth, not at its tip."""
    form = tooth_form(gear(10))
    lower = form.half_thickness[form.height < 0.5 * form.height[-1]]
    waist = int(np.argmin(lower))
    assert 0 < waist < len(lower) - 1
    assert np.all(np.diff(tooth_form(gear(30)).half_thickness) < 0.0)


@settings(max_examples=150)
@given(st.integers(5, 300), st.sampled_from([1, -1]), st.floats(-0.8, 1.2), st.sampled_from([0.25, 0.30, 0.38]))
def test_every_outline_rises_from_root_to_tip_or_is_refused(teeth, side, shift, fillet):
    """Undercut, pointed or narrow teeth are named; whatever passes can be bent."""
    try:
        form = tooth_form(gear(side * teeth, shift, rack=BasicRack(fillet_radius=fillet)))
    except DesignError as error:
        assert error.problems[0].path in ("profile_shift", "rack.fillet_radius")
        return
    assert np.all(np.diff(form.height) > 0.0) and np.all(form.half_thickness > 0.0)


def test_a_tooth_that_the_rack_cuts_away_is_refused():
    with pytest.raises(DesignError, match="undercuts"):
        tooth_form(gear(5, -0.4))
    with pytest.raises(DesignError, match="base circle"):
        tooth_form(gear(-5, 1.19))


def test_a_fillet_that_does_not_fit_is_refused():
    with pytest.raises(DesignError, match="narrow"):
        tooth_form(gear(30, rack=BasicRack(dedendum=1.6, fillet_radius=0.5)))
    with pytest.raises(DesignError, match="narrow"):
        tooth_form(gear(-60, rack=BasicRack(fillet_radius=0.6)))


@pytest.mark.parametrize("teeth", [24, -72])
def test_the_load_on_a_large_gear_stands_at_the_pressure_angle(teeth):
    """At the reference circle the angle is α ∓ ψ."""
    part = gear(teeth)
    _, _, angle = load_point(tooth_form(part), np.array([part.pitch_radius]))
    assert angle[0] == pytest.approx(math.radians(20.0) - part.side * math.pi / (2 * abs(teeth)))


def test_a_block_bends_as_a_beam():
    """A tooth of constant width w: ∫ 12 (c (h − y) − s x)²/(E w³) dy in closed form, and 1.2 c² h/(G w), s² h/(E w)."""
    form = tooth_form(gear(30))
    width = 2e-3
    block = replace(form, half_thickness=np.full_like(form.height, 0.5 * width))
    radius = np.array([gear(30).pitch_radius])
    (h,), (x,), (angle,) = load_point(block, radius)
    c, s = math.cos(angle), math.sin(angle)
    beam = 12.0 / (206e9 * width**3) * (c**2 * h**3 / 3.0 - c * s * x * h**2 + s**2 * x**2 * h)
    found = tooth_compliance(block, radius, material=STEEL)
    assert found.bending[0] == pytest.approx(beam, rel=1e-12)
    assert found.shear[0] == pytest.approx(SHEAR_FACTOR * c**2 * h / (STEEL.shear_modulus * width), rel=1e-12)
    assert found.compression[0] == pytest.approx(s**2 * h / (206e9 * width), rel=1e-12)


@pytest.mark.parametrize("teeth", [14, 30, -90])
def test_gauss_points_resolve_the_fillet(teeth):
    """Against 20 000 trapezoids of the same outline: 1e-4 is far below the model's own few per cent."""
    part, form = gear(teeth), tooth_form(gear(teeth))
    radius = np.array([part.tip_radius])
    (h,), (x,), (angle,) = load_point(form, radius)

    y = np.linspace(0.0, h, 20001)
    width = 2.0 * np.interp(y, form.height, form.half_thickness)
    exact = np.trapezoid(12.0 * (math.cos(angle) * (h - y) - math.sin(angle) * x) ** 2 / width**3, y) / 206e9
    assert tooth_compliance(form, radius, material=STEEL).bending[0] == pytest.approx(exact, rel=2e-4)


def test_a_tooth_gives_more_the_higher_it_is_loaded():
    form = tooth_form(gear(30))
    radius = np.linspace(gear(30).pitch_radius, gear(30).tip_radius, 5)
    assert np.all(np.diff(tooth_compliance(form, radius, material=STEEL).total) > 0.0)


def test_compliance_does_not_depend_on_the_module():
    """Per unit length of contact everything is a ratio of lengths."""
    small, large = tooth_form(CylindricalGear(30, 1e-3, 0.01)), tooth_form(CylindricalGear(30, 4e-3, 0.01))
    one = tooth_compliance(small, np.array([15.5e-3]), material=STEEL)
    other = tooth_compliance(large, np.array([62e-3]), material=STEEL)
    assert one.total == pytest.approx(other.total, rel=1e-9)


def test_a_held_body_gives_up_to_half_more_than_the_half_plane_when_its_twist_is_small():
    """O'Donnell 1960 beside Sainsot et al. 2004 at r_f/r_bore = 1.5, z = 40: the sources differ by 37 % here."""
    form, radius = tooth_form(gear(40)), np.array([gear(40).pitch_radius])
    half_plane = half_plane_foundation(form, radius, material=STEEL)
    held = held_body_foundation(form, radius, material=STEEL, bore_radius=form.root_radius / 1.5)
    assert 1.0 < held[0] / half_plane[0] < 1.5


def test_a_smaller_bore_lets_the_body_twist_more():
    form, radius = tooth_form(gear(40)), np.array([gear(40).pitch_radius])
    held = [
        held_body_foundation(form, radius, material=STEEL, bore_radius=form.root_radius / ratio)[0]
        for ratio in (2, 4, 6)
    ]
    assert held == sorted(held)


@pytest.mark.parametrize(
    ("teeth", "ratio", "says"), [(40, 8.0, "from 1.4 to 7"), (18, 3.0, "z above"), (-60, 3.0, "half plane")]
)
def test_a_held_body_outside_the_fit_is_refused(teeth, ratio, says):
    form = tooth_form(gear(teeth))
    with pytest.raises(DesignError, match=says):
        held_body_foundation(form, np.array([0.04]), material=STEEL, bore_radius=form.root_radius / ratio)
