"""The mesh stiffness models, each on its own and beside each other."""

import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts import Material
from gearwright.parts.gears import BasicRack, CylindricalGear, GearPair
from gearwright.parts.stiffness import (
    GearBlank,
    blank_factor,
    contact_compliance,
    cut_square_wave,
    load_factor,
    mesh_curve_iso6336,
    mesh_cycle_energy,
    mesh_stiffness_energy,
    mesh_stiffness_iso6336,
    mesh_stiffness_kuang_yang,
    pair_stiffness,
    rack_factor,
    stiffness_at,
    tooth_stiffness_kuang_yang,
)

STEEL = Material("steel", 206e9, 0.3, 7850.0)


def pair(first, second, *, module=3e-3, helix=0.0, shifts=(0.0, 0.0), width=20e-3):
    return GearPair(
        CylindricalGear(first, module, width, helix_angle=helix, profile_shift=shifts[0]),
        CylindricalGear(second, module, width, helix_angle=helix, profile_shift=shifts[1]),
    )


def energy(mesh, harmonics=4):
    return mesh_stiffness_energy(mesh, materials=(STEEL, STEEL), harmonics=harmonics)


def test_hertz_line_contact_of_two_steel_gears():
    """Yang & Sun 1985: k_h = π E b/(4 (1 − ν²)); exact."""
    assert 1.0 / contact_compliance(STEEL, STEEL) == pytest.approx(math.pi * 206e9 / (4.0 * (1.0 - 0.09)))


def test_stiffness_per_width_does_not_depend_on_the_module():
    assert energy(pair(25, 50, module=1e-3)).mean == pytest.approx(energy(pair(25, 50, module=8e-3)).mean, rel=1e-9)


def test_stiffness_grows_with_the_width():
    assert energy(pair(25, 50, width=40e-3)).mean == pytest.approx(2.0 * energy(pair(25, 50)).mean)


def test_two_equal_gears_have_a_curve_that_is_even_about_the_pitch_point():
    """Driver and driven gear can be exchanged, which mirrors the path of contact."""
    curve = energy(pair(30, 30))
    assert curve.sine == pytest.approx(np.zeros(4), abs=1e-9 * curve.mean)


def test_exchanging_driver_and_driven_gear_mirrors_the_curve():
    one, other = energy(pair(25, 60)), energy(pair(60, 25))
    assert one.cosine == pytest.approx(other.cosine) and one.sine == pytest.approx(-np.array(other.sine))


def test_the_curve_is_the_sum_of_the_pairs_in_contact():
    """At the pitch point of 25/60 one pair touches: 400 harmonics come within 1 % at 0.1 cycles from the next jump."""
    mesh = pair(25, 60)
    single = pair_stiffness(mesh, np.array([0.0]), materials=(STEEL, STEEL)).stiffness[0] * mesh.face_width
    assert float(stiffness_at(energy(mesh, 400), 0.0)) == pytest.approx(single, rel=0.01)


def test_the_series_converges_to_the_jumping_curve():
    """In the mean square, away from nothing: 200 harmonics of a curve with jumps leave 1/(π √n) of the jump, 4 %."""
    mesh, phase = pair(25, 60), np.linspace(0.0, 2.0 * np.pi, 501)[:-1]
    jumping = mesh_cycle_energy(mesh, phase, materials=(STEEL, STEEL))
    series = stiffness_at(energy(mesh, 200), phase)
    assert np.sqrt(np.mean((series - jumping) ** 2)) < 0.04 * np.ptp(jumping)
    assert np.mean(jumping) == pytest.approx(energy(mesh).mean, rel=2e-3)


def test_internal_and_external_meshes_of_a_planet_jump_between_one_and_two_pairs():
    """ε_α between 1 and 2: the shares of the cycle with two pairs is ε_α − 1."""
    for mesh in (pair(27, 21), pair(21, -69)):
        phase = np.linspace(0.0, 2.0 * np.pi, 2001)[:-1]
        curve = mesh_cycle_energy(mesh, phase, materials=(STEEL, STEEL))
        double = np.mean(curve > 0.5 * (curve.min() + curve.max()))
        assert double == pytest.approx(mesh.transverse_contact_ratio - 1.0, abs=2e-3)


def test_helical_jumps_and_gaps_in_contact_are_refused():
    with pytest.raises(DesignError, match="no jumps"):
        mesh_cycle_energy(pair(25, 60, helix=0.2), np.zeros(1), materials=(STEEL, STEEL))
    with pytest.raises(DesignError, match="contact_ratio"):
        energy(GearPair(*(CylindricalGear(20, 3e-3, 0.02, tip_alteration=-0.6) for _ in range(2))))


def test_helical_teeth_smooth_the_curve():
    """β = 12°, ε_β about 0.44: the first harmonic falls by sinc(ε_β), and the normal section changes it a little."""
    spur, helical = energy(pair(25, 60)), energy(pair(25, 60, helix=math.radians(12.0)))

    def first(curve):
        return math.hypot(curve.cosine[0], curve.sine[0])

    assert first(helical) / first(spur) == pytest.approx(
        np.sinc(pair(25, 60, helix=math.radians(12)).overlap_ratio), rel=0.3
    )
    assert helical.mean == pytest.approx(spur.mean, rel=0.05)


def test_a_held_body_softens_the_mesh():
    held = mesh_stiffness_energy(pair(30, 60), materials=(STEEL, STEEL), bore_radii=(10e-3, 20e-3))
    assert held.mean < energy(pair(30, 60)).mean


def test_blank_factor_of_solid_and_webbed_bodies():
    """ISO 6336-1: C_R = 1 for a solid disc; b_s/b = 0.2, s_R/m_n = 1: 1 + ln 0.2/(5 e^0.2) = 0.7365."""
    assert blank_factor(GearBlank()) == 1.0
    assert blank_factor(GearBlank(0.2, 1.0)) == pytest.approx(0.7365, abs=1e-4)
    assert blank_factor(GearBlank(0.05, 0.5)) == blank_factor(GearBlank(0.2, 1.0))


def test_rack_factor_of_a_deep_rack():
    """ISO 6336-1: h_fP = 1.4 gives 1 + 0.5 (1.2 − 1.4) = 0.9; α = 25° adds 10 %."""
    deep = BasicRack(dedendum=1.4, fillet_radius=0.3)
    steep = BasicRack(math.radians(25.0), dedendum=1.4, fillet_radius=0.2)
    assert rack_factor(deep, deep) == pytest.approx(0.9)
    assert rack_factor(steep, steep) == pytest.approx(0.99)


def test_a_light_load_softens_the_mesh():
    """ISO 6336-1: (F_t K_A/b / 100 N/mm)^0.25."""
    assert load_factor(6.25e3) == pytest.approx(0.5)
    assert load_factor(300e3) == 1.0
    with pytest.raises(DesignError, match="above 0"):
        load_factor(0.0)


def test_a_softer_mate_counts_by_the_mean_modulus():
    steel = mesh_stiffness_iso6336(pair(25, 60))
    bronze = mesh_stiffness_iso6336(pair(25, 60), elastic_moduli=(206e9, 103e9))
    assert bronze.single / steel.single == pytest.approx(2.0 * 103.0 / 309.0)


@pytest.mark.parametrize(
    ("teeth", "shifts"), [((20, 40), (0.0, 0.0)), ((20, 40), (0.4, -0.4)), ((30, 30), (0.3, -0.3))]
)
def test_iso_stiffness_does_not_depend_on_the_order_of_the_gears(teeth, shifts):
    """Index 1 of the standard's regression is the pinion, the gear with fewer teeth; the order made 2.7 % of 20/40."""
    one, other = (CylindricalGear(z, 3e-3, 30e-3, profile_shift=x) for z, x in zip(teeth, shifts, strict=True))
    found = mesh_stiffness_iso6336(GearPair(one, other))
    turned = mesh_stiffness_iso6336(GearPair(other, one))
    for name in ("theoretical", "single", "mesh", "face"):
        assert getattr(turned, name) == pytest.approx(getattr(found, name), rel=1e-12)
    if teeth == (20, 40) and shifts == (0.0, 0.0):
        by_hand = 1e9 / (0.04723 + 0.15551 / 20 + 0.25791 / 40)
        assert found.theoretical == pytest.approx(by_hand, rel=1e-12)


def test_the_iso_curve_has_the_iso_mean():
    mesh = pair(25, 60)
    stiffness = mesh_stiffness_iso6336(mesh)
    assert mesh_curve_iso6336(mesh, stiffness).mean == pytest.approx(stiffness.mesh * mesh.face_width)


def test_iso_names_what_lies_outside_its_range():
    with pytest.raises(DesignError, match="45°"):
        mesh_stiffness_iso6336(pair(25, 60, helix=math.radians(50.0)))
    with pytest.raises(DesignError, match=r"−0\.5 to 2"):
        mesh_stiffness_iso6336(pair(60, 60, shifts=(-0.4, -0.3)))


@pytest.mark.parametrize(
    ("teeth", "values"),
    [
        (20, (25.6854, 25.5204, -13.8782, -19.622)),
        (30, (30.1761, 26.0561, -17.2533, -21.759)),
        (50, (30.9795, 22.7175, -17.7755, -20.405)),
    ],
)
def test_kuang_yang_coefficients(teeth, values):
    """Cubics of Kuang & Yang 1992 evaluated by hand; printed digits. A_2 and A_3 by the slope over the radius."""
    base, shifted = (tooth_stiffness_kuang_yang(teeth, [0.0, 0.5], x) / 1e9 for x in (0.0, 0.5))
    assert base[0] == pytest.approx(values[0], rel=1e-4)
    assert (shifted[0] - base[0]) / 0.5 == pytest.approx(values[1], rel=1e-4)
    assert (base[1] - base[0]) / 0.5 == pytest.approx(values[2], rel=1e-4)
    assert (shifted[1] - shifted[0]) / 0.5 * 1.5 == pytest.approx(values[2] + 0.5 * values[3], rel=1e-4)


def test_kuang_yang_outside_its_fit_is_refused():
    for call in (
        lambda: tooth_stiffness_kuang_yang(51, 0.0),
        lambda: tooth_stiffness_kuang_yang(30, 0.0, 0.7),
        lambda: mesh_stiffness_kuang_yang(pair(30, -90)),
        lambda: mesh_stiffness_kuang_yang(pair(30, 60)),
    ):
        with pytest.raises(DesignError, match="Kuang & Yang"):
            call()


def test_the_thesis_wave_is_a_square_wave_of_a_quarter_cut_at_the_fifth_harmonic():
    """Pulvirenti 2023, eq. (3.35): K/π (1 − 1/3 + 1/5) at a quarter cycle."""
    curve = cut_square_wave(4e8)
    assert float(stiffness_at(curve, 0.5 * math.pi)) == pytest.approx(4e8 * (1.0 + 13.0 / 15.0 / math.pi))
    assert curve.cosine == (0.0,) * 5 and curve.sine[1] == curve.sine[3] == 0.0
