"""The oil film of ISO/TS 6336-22: limits, symmetries, by hand; printed numbers are in `gearwright validate`."""

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.iso6336 import MeshGeometry, Treatment
from gearwright.parts.micropitting import (
    BASES,
    POINTS,
    STAGES,
    THERMAL,
    FilmMesh,
    OilGrade,
    film_of_test,
    film_thickness,
    helical_factor,
    load_sharing,
    mean_friction,
    micropitting,
    path_places,
    permissible_film,
    relief_factor,
)

EVEN = MeshGeometry((24.0, 24.0), 4e-3, 40e-3, 96e-3, (52e-3, 52e-3))
"""Two equal gears: all is even about the pitch point."""
MESH = FilmMesh(EVEN, 10e3, 1.5, 150.0, 0.5e-6)
OIL = OilGrade(100e-6, 11e-6, 880.0)


def test_an_oil_has_its_stated_viscosities_and_density():
    assert float(OIL.kinematic(40.0)) == pytest.approx(100e-6, rel=1e-12)
    assert float(OIL.kinematic(100.0)) == pytest.approx(11e-6, rel=1e-12)
    assert float(OIL.density(16.0)) == pytest.approx(880.0)  # 289 K
    assert float(OIL.density(90.0)) == pytest.approx(880.0 - 0.7 * 74.0)
    assert float(replace(OIL, density_15=None).density(16.0)) == pytest.approx(43.37 * 2.0 + 805.5)
    assert float(OIL.dynamic(40.0)) == pytest.approx(100e-6 * (880.0 - 0.7 * 24.0))


@pytest.mark.parametrize(
    ("name", "scale", "power"),
    [("mineral", 2.657e-8, 0.1348), ("polyalphaolefin", 1.466e-8, 0.0507), ("polyglycol", 1.392e-8, 0.1572)],
)
def test_pressure_coefficients_by_base_stock(name, scale, power):
    """ISO/TR 15144-1:2014, eqs 8 to 11; at 38 °C the factor of temperature is 1."""
    oil = replace(OIL, base=BASES[name])
    at_38 = scale * float(oil.dynamic(38.0)) ** power
    assert float(oil.pressure_coefficient(38.0)) == pytest.approx(at_38)
    assert float(oil.pressure_coefficient(90.0)) == pytest.approx(at_38 * (1.0 + 516.0 * (1.0 / 363.0 - 1.0 / 311.0)))


def test_an_even_pair_has_an_even_film():
    film = film_thickness(MESH, OIL, 80.0)
    for values in (film.thickness, film.pressure, film.contact, film.curvature):
        assert np.allclose(values, values[::-1], rtol=1e-12)
    assert film.contact[POINTS.index("C")] == pytest.approx(film.bulk)


def test_pressure_and_film_at_the_pitch_point_by_hand():
    """ρ_n = r_b tan α/2, one pair bears: p = √(E_r/(2 π) F_t K/(b cos α ρ)); h by its four groups, S = 1 there."""
    film, angle = film_thickness(MESH, OIL, 80.0), math.radians(20.0)
    radius = 0.5 * 48e-3 * math.sin(angle)
    modulus = 206e9 / 0.91
    pressure = math.sqrt(modulus / (2.0 * math.pi) * 10e3 * 1.5 / (40e-3 * math.cos(angle) * radius))
    assert film.curvature[3] == pytest.approx(radius)
    assert film.pressure[3] == pytest.approx(pressure)
    rolling = 2.0 * 150.0 * 48e-3 * math.sin(angle)
    viscous, pressing = float(OIL.dynamic(film.bulk)), float(OIL.pressure_coefficient(film.bulk))
    height = (
        1600e-6 * (radius / 1e-3) * (pressing * modulus) ** 0.6 * (viscous * rolling / (2.0 * modulus * radius)) ** 0.7
        * (2.0 * math.pi * (pressure / modulus) ** 2) ** -0.13
    )  # fmt: skip
    assert film.thickness[3] == pytest.approx(height)


def test_bulk_temperature_and_friction_by_hand():
    film, angle = film_thickness(MESH, OIL, 80.0), math.radians(20.0)
    radius, rolling = 0.5 * 48.0 * math.sin(angle), 2.0 * 150.0 * 48e-3 * math.sin(angle)
    line = 1.5 * 10e3 / math.cos(angle) / 40.0
    friction = (
        0.045 * (line / (rolling * radius)) ** 0.2 * (1e3 * float(OIL.dynamic(80.0))) ** -0.05
        * 2.2 * (0.5 / radius) ** 0.25
    )  # fmt: skip
    assert film.friction == pytest.approx(friction)
    power = 10e3 * 150.0 * 48e-3 / 1e3
    assert film.bulk == pytest.approx(80.0 + 7400.0 * (power * friction * film.loss / (96.0 * 40.0)) ** 0.72 / 1.2)


def test_flash_at_a_by_hand():
    """θ_fl = √π/2 μ p Δv/(B_M (√v_1 + √v_2)) √(8 ρ p/E_r), B_M = √(45 · 7800 · 440)."""
    film = film_thickness(MESH, OIL, 80.0)
    reach = 96e-3 * math.sin(math.radians(20.0))
    tip = math.sqrt(52e-3**2 - (48e-3 * math.cos(math.radians(20.0))) ** 2)
    first, second = 150.0 * (reach - tip), 150.0 * tip
    pressure = film.pressure[0]
    flash = 0.5 * math.sqrt(math.pi) * film.friction * pressure * (second - first) / THERMAL
    flash *= math.sqrt(8.0 * film.curvature[0] * pressure * 0.91 / 206e9) / (math.sqrt(first) + math.sqrt(second))
    assert film.contact[0] - film.bulk == pytest.approx(flash)
    assert pytest.approx(12427.4, abs=0.05) == THERMAL


def test_load_sharing_of_spur_and_wide_helical_teeth():
    """(Q − 2)/15 at A, 1/3 for class 7 and finer, a third more at B, then 1; 1.3/ε_α at the ends of wide ones."""
    spur = load_sharing(EVEN, 5, path_places(EVEN))
    assert spur[[0, 1, 3, 5, 6]] == pytest.approx([1 / 3, 0.5, 1.0, 0.5, 1 / 3])
    assert load_sharing(EVEN, 10, path_places(EVEN))[0] == pytest.approx(8.0 / 15.0)
    slant = math.radians(20.0)
    wide = replace(
        EVEN, helix_angle=slant, face_width=80e-3, centre_distance=96e-3 / math.cos(slant),
        tip_radii=(4e-3 + 48e-3 / math.cos(slant),) * 2,
    )  # fmt: skip
    shared = load_sharing(wide, 6, path_places(wide))
    assert shared[0] == pytest.approx(1.3 / float(wide.transverse_contact_ratio))
    assert shared[3] == pytest.approx(1.0 / float(wide.transverse_contact_ratio))
    assert [helical_factor(total) for total in (1.5, 2.0, 3.5, 4.0)] == pytest.approx([1.0, 1.0, 1.3, 1.3])


def test_more_load_heat_and_roughness_thin_the_film_and_speed_thickens_it():
    least = micropitting(MESH, OIL, 80.0, stage=9.0)
    for worse in (replace(MESH, load_factor=2.0), replace(MESH, roughness=0.8e-6), replace(MESH, supply=1.2)):
        assert micropitting(worse, OIL, 80.0, stage=9.0).safety < least.safety
    assert micropitting(MESH, OIL, 95.0, stage=9.0).thinnest < least.thinnest
    assert micropitting(replace(MESH, speed=200.0), OIL, 80.0, stage=9.0).safety > least.safety


def test_relieved_tips_leave_the_teeth_cooler_and_the_film_thicker():
    """X_Ca = 1 + 0.24 ε + 0.71 ε² of a full relief of class 6 and finer, 1 of coarser teeth and of none.

    ε = 24/(2 π) (tan α_a − tan 20°) with cos α_a = 48 cos 20°/52: 0.8010, so X_Ca is 1.6477.
    """
    angle = math.radians(20.0)
    longest = 24.0 / (2.0 * math.pi) * (math.tan(math.acos(48.0 / 52.0 * math.cos(angle))) - math.tan(angle))
    full = 1.0 + 0.24 * longest + 0.71 * longest**2
    assert full == pytest.approx(1.6477, abs=5e-5)
    assert [relief_factor(EVEN, part, 5) for part in (0.0, 0.5, 1.0)] == pytest.approx([1.0, 0.5 + 0.5 * full, full])
    assert [relief_factor(EVEN, 1.0, grade) for grade in (6, 7)] == pytest.approx([full, 1.0])
    plain, relieved = (micropitting(replace(MESH, relief=factor), OIL, 80.0, stage=9.0) for factor in (1.0, full))
    assert (plain.tip_relief, relieved.tip_relief) == (1.0, full)
    assert relieved.bulk - 80.0 == pytest.approx((plain.bulk - 80.0) / full, rel=1e-12)
    assert relieved.safety > plain.safety


def test_better_oils_permit_thinner_films_and_softer_flanks_ask_for_thicker_ones_the_other_way():
    """The permissible film falls with the load stage and goes with W_W: 1 case-hardened, 1.5 nitrided, 0.5 tempered."""
    films = [film_of_test(OIL, stage) for stage in STAGES]
    assert films == sorted(films, reverse=True)
    assert films[2] > film_of_test(OIL, 7.5) > films[3]
    case = permissible_film(OIL, 8.0)
    assert case == pytest.approx(1.4 * films[3])
    assert permissible_film(OIL, 8.0, Treatment.NITRIDED) == pytest.approx(1.5 * case)
    assert permissible_film(OIL, 8.0, Treatment.THROUGH_HARDENED) == pytest.approx(0.5 * case)


def test_what_it_does_not_cover_is_named():
    with pytest.raises(DesignError, match="stages 5 to 10"):
        film_of_test(OIL, 12.0)
    with pytest.raises(DesignError, match="nothing rolls"):
        FilmMesh(replace(EVEN, tip_radii=(60e-3, 52e-3)), 1e3, 1.0, 10.0, 0.5e-6)
    with pytest.raises(DesignError, match="above 0"):
        FilmMesh(EVEN, 1e3, 1.0, 10.0, 0.0)


def test_base_stocks_lessen_friction_by_x_l():
    friction = mean_friction(MESH, OIL, 80.0)
    assert mean_friction(MESH, replace(OIL, base=BASES["polyalphaolefin"]), 80.0) == pytest.approx(0.8 * friction)
    assert mean_friction(MESH, replace(OIL, base=BASES["traction"]), 80.0) == pytest.approx(1.5 * friction)
