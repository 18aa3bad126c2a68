"""Micropitting film of unequal spur and helical pairs written out once more, in N, mm, µm; every row of its tables.

ISO/TR 15144-1:2014 (ISO/TS 6336-22), method B; the lines quote its symbols.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from gearwright.parts.iso6336 import MeshGeometry, Treatment
from gearwright.parts.micropitting import (
    BASES,
    STAGES,
    FilmMesh,
    OilGrade,
    film_of_test,
    film_thickness,
    load_sharing,
    micropitting as rate,
    path_places,
    permissible_film,
)

TEETH, MODULE = (19, 46), 3.0
OIL = OilGrade(150e-6, 15.5e-6, 870.0, BASES["polyalphaolefin"])
SLOW, FAST = 80.0, 210.0
CENTRES = {0.0: 98.4, 16.0: 101.9, 25.0: 108.2}
"""β [°] -> a [mm], a little above 97.5/cos β."""


def pair_of(helix: float, width: float) -> MeshGeometry:
    """Both gears with tips one module outside their reference circles."""
    slant = math.radians(helix)
    tips = [(0.5 * z / math.cos(slant) + 1.0) * MODULE * 1e-3 for z in TEETH]
    return MeshGeometry(
        (19.0, 46.0), MODULE * 1e-3, width * 1e-3, CENTRES[helix] * 1e-3, (tips[0], tips[1]), helix_angle=slant
    )


class Hand:
    """Lengths in mm, from tooth numbers, module, tips and centre distance alone."""

    def __init__(self, helix: float, width: float) -> None:
        slant, self.b, self.a = math.radians(helix), width, CENTRES[helix]
        self.at = math.atan(math.tan(math.radians(20.0)) / math.cos(slant))
        d = [z * MODULE / math.cos(slant) for z in TEETH]
        db = [x * math.cos(self.at) for x in d]
        self.d_1, self.u = d[0], TEETH[1] / TEETH[0]
        half = [0.5 * math.sqrt((x + 2.0 * MODULE) ** 2 - y**2) for x, y in zip(d, db, strict=True)]
        awt = math.acos(sum(db) / (2.0 * self.a))
        self.line = self.a * math.sin(awt)
        self.t_1a = self.line - half[1]
        self.g = sum(half) - self.line
        self.p = math.pi * d[0] / TEETH[0] * math.cos(self.at)
        self.beta_b = math.asin(math.sin(slant) * math.cos(math.radians(20.0)))
        self.eps_a, self.eps_b = self.g / self.p, width * math.sin(slant) / (math.pi * MODULE)
        self.c = 0.5 * db[0] * math.tan(awt) - self.t_1a
        double = self.g - self.p
        self.places = [0.0, double / 2.0, double, self.c, self.p, self.p + double / 2.0, self.g]
        self.addendum = [x / self.p for x in (self.g - self.c, self.c)]

    def radii(self, place: float) -> tuple[float, float, float]:
        first = self.t_1a + place
        second = self.line - first
        return first, second, first * second / (first + second) / math.cos(self.beta_b)

    def share(self, place: float, grade: int) -> float:
        """X_Y: spur and narrow by accuracy, 1/ε_α from ε_β = 1.2, between them in proportion; each with X_but."""
        double, near = self.g - self.p, min(place, self.g - place)
        base = (max(grade, 7) - 2) / 15.0
        spur = base + near / double / 3.0 if near < double - 1e-9 else 1.0
        part = min(max((self.eps_b - 0.8) / 0.4, 0.0), 1.0)
        value = (1.0 - part) * spur + part / self.eps_a
        end = 0.2 * math.sin(self.beta_b) * (self.t_1a + self.c)  # in mm: over 0.2 sin β_b of T_1C
        if end > 0.0 and near < end:
            value *= 1.0 + 0.3 * min(self.eps_b, 1.0) * (1.0 - near / end)
        return value


def viscosity(temperature: float) -> float:
    """ν [mm²/s] between 150 at 40 °C and 15.5 at 100 °C by Ubbelohde and Walther."""
    low, high = math.log10(math.log10(150.7)), math.log10(math.log10(16.2))
    part = math.log10((temperature + 273.0) / 313.0) / math.log10(373.0 / 313.0)
    return 10.0 ** (10.0 ** (low + (high - low) * part)) - 0.7


def dynamic(temperature: float) -> float:
    """η [Pa s] with ρ = 870 − 0.7 (T − 289)."""
    return 1e-6 * viscosity(temperature) * (870.0 - 0.7 * (temperature + 273.0 - 289.0))


def pressing(temperature: float) -> float:
    """α [1/Pa] of a polyalphaolefin."""
    at_38 = 1.466e-8 * dynamic(38.0) ** 0.0507
    return at_38 * (1.0 + 516.0 * (1.0 / (temperature + 273.0) - 1.0 / 311.0))


PAIRS = pytest.mark.parametrize(
    ("helix", "width", "overlap"),
    [(0.0, 20.0, (0.0, 0.0)), (16.0, 12.0, (0.3, 0.8)), (16.0, 32.0, (0.8, 1.0)), (25.0, 25.0, (1.0, 1.2)),
     (25.0, 60.0, (1.2, 3.0))],
)  # fmt: skip


@PAIRS
@pytest.mark.parametrize("grade", [4, 7, 9])
def test_the_load_is_shared_by_accuracy_overlap_and_buttressing(helix, width, overlap, grade):
    hand, pair = Hand(helix, width), pair_of(helix, width)
    assert overlap[0] <= hand.eps_b <= overlap[1]
    assert 1e3 * path_places(pair) == pytest.approx(hand.places, abs=1e-9)
    inner = [0.02 * hand.g, 0.1 * hand.g, 0.93 * hand.g]
    for place in (*inner, *hand.places):
        found = float(load_sharing(pair, grade, np.array([place * 1e-3]))[0])
        assert found == pytest.approx(hand.share(place, grade), rel=1e-6)


@PAIRS
def test_friction_bulk_pressure_flash_and_film_at_all_seven_points(helix, width, overlap):
    """μ_m by eqs 86 to 90, θ_M by 84, p by 24, θ_fl by 80, h by 4; H_v of ISO/TR 15144-1, eqs 85."""
    hand, pair = Hand(helix, width), pair_of(helix, width)
    force, load, grade = 6200.0, 1.4, 8
    mesh = FilmMesh(pair, force, load, FAST, 0.6e-6, grade=grade, elastic_modulus=208e9, poisson_ratio=0.29, supply=1.2)
    film = film_thickness(mesh, OIL, SLOW)
    turn = FAST / 1e3  # rad/s times mm to m/s
    reduced = 208e3 / (1.0 - 0.29**2)  # N/mm²
    first, second, rho = hand.radii(hand.c)
    total = hand.eps_a + hand.eps_b
    k_b = 1.0 if total <= 2.0 else 1.3 if total >= 3.5 else 1.0 + 0.2 * math.sqrt((total - 2.0) * (5.0 - total))
    rolling = turn * (first + second / hand.u)
    line = force * load * k_b / math.cos(hand.at) / hand.b
    rough = 2.2 * (0.6 / rho) ** 0.25
    friction = 0.045 * (line / (rolling * rho)) ** 0.2 * (1e3 * dynamic(SLOW)) ** -0.05 * rough * 0.8
    assert film.friction == pytest.approx(friction, rel=1e-6)
    power = force * FAST * hand.d_1 / 2.0 / 1e6  # kW
    warm = SLOW + 7400.0 * (power * friction * film.loss / (hand.a * hand.b)) ** 0.72 * 1.2 / 1.2
    assert film.bulk == pytest.approx(warm, rel=1e-6)
    for point, place in enumerate(hand.places):
        first, second, rho = hand.radii(place)
        share = hand.share(place, grade)
        v_1, v_2 = turn * first, turn * second / hand.u
        pressure = math.sqrt(reduced / (2.0 * math.pi) * force * load * share / (hand.b * math.cos(hand.at) * rho))
        assert film.pressure[point] == pytest.approx(1e6 * pressure, rel=1e-5)
        thermal = math.sqrt(45.0 * 7800.0 * 440.0)  # SI
        flash = math.sqrt(math.pi) / 2.0 * friction * 1e6 * pressure * abs(v_1 - v_2)
        flash /= thermal * (math.sqrt(v_1) + math.sqrt(v_2))
        flash *= math.sqrt(8.0 * rho * 1e-3 * pressure / reduced)
        assert film.contact[point] - film.bulk == pytest.approx(flash, rel=1e-4, abs=1e-6)
        material = pressing(warm) * 1e6 * reduced
        speed = dynamic(warm) * (v_1 + v_2) / (2.0 * reduced * 1e3 * rho)
        weight = 2.0 * math.pi * (pressure / reduced) ** 2
        hot = warm + flash
        sliding = pressing(hot) * dynamic(hot) / (pressing(warm) * dynamic(warm))
        height = 1600.0 * rho * material**0.6 * speed**0.7 * weight**-0.13 * sliding**0.22
        assert 1e6 * film.thickness[point] == pytest.approx(height, rel=1e-5)


def test_the_loss_factor_is_that_of_the_addendum_contact_ratios():
    """H_v = π (u + 1)/(z_1 u cos β_b) (1 − ε_α + ε_1² + ε_2²), both ε above none and below one (eq. 85)."""
    for helix, width in ((0.0, 20.0), (16.0, 12.0)):
        hand, pair = Hand(helix, width), pair_of(helix, width)
        first, second = hand.addendum
        assert hand.eps_a < 2.0 and min(first, second) > 0.0 and max(first, second) < 1.0
        expected = math.pi * (hand.u + 1.0) / (TEETH[0] * hand.u * math.cos(hand.beta_b))
        expected *= 1.0 - hand.eps_a + first**2 + second**2
        assert film_thickness(FilmMesh(pair, 6e3, 1.4, FAST, 0.6e-6), OIL, SLOW).loss == pytest.approx(expected)


def test_torques_of_the_stages_factors_of_oils_and_treatments_are_the_printed_ones():
    """FVA 54/7; ISO/TS 6336-22, table 3 and eqs 9 to 11; annex A."""
    assert STAGES == {5: 70.0, 6: 98.9, 7: 132.5, 8: 171.6, 9: 215.6, 10: 265.1}
    rows = {name: (base.lubricant, base.scale, base.exponent) for name, base in BASES.items()}
    assert rows == {
        "mineral": (1.0, 2.657e-8, 0.1348), "polyalphaolefin": (0.8, 1.466e-8, 0.0507),
        "polyglycol": (0.7, 1.392e-8, 0.1572), "water-soluble polyglycol": (0.6, 1.392e-8, 0.1572),
        "phosphate ester": (1.3, 2.657e-8, 0.1348), "traction": (1.5, 2.657e-8, 0.1348),
    }  # fmt: skip
    plain = permissible_film(OIL, 9.0)
    assert plain == pytest.approx(1.4 * film_of_test(OIL, 9.0))
    for treatment, factor in {
        Treatment.CASE_HARDENED: 1.0, Treatment.NITRIDED: 1.5, Treatment.NITRIDED_THROUGH_HARDENED: 1.5,
        Treatment.NITROCARBURISED: 1.5, Treatment.INDUCTION_HARDENED: 0.65, Treatment.THROUGH_HARDENED: 0.5,
        Treatment.STRUCTURAL: 0.5,
    }.items():  # fmt: skip
        assert permissible_film(OIL, 9.0, treatment) == pytest.approx(factor * plain, rel=1e-12)


@pytest.mark.parametrize(("stage", "torque"), [(5.0, 70.0), (9.0, 215.6), (9.5, 240.35), (10.0, 265.1)])
def test_the_film_of_the_test_is_that_of_its_gears_at_a(stage, torque):
    """C-GF: 16/24, m_n 4.5 mm, b 14 mm, a 91.5 mm, d_a 82.46 and 118.36 mm; 2250/min, 90 °C, R_a 0.5 µm, sprayed.

    Load factor 1.163, and 1.045 · 236.3 N/mm of line load at A for 265.1 N m, as the module's text reckons them back.
    """
    gears = MeshGeometry((16.0, 24.0), 4.5e-3, 14e-3, 91.5e-3, (41.23e-3, 59.18e-3))
    force = torque / 0.036
    line = 1.045 * 236.3e3 * torque / 265.1
    share = line / (1.163 * force / math.cos(math.radians(20.0)) / 14e-3)
    mesh = FilmMesh(gears, force, 1.163, 2250.0 * 2.0 * math.pi / 60.0, 0.5e-6, supply=1.2)
    film = film_thickness(mesh, OIL, 90.0, sharing=np.full(7, share))
    assert film_of_test(OIL, stage) == pytest.approx(film.thickness[0] / 0.5e-6, rel=1e-12)


def test_the_thinnest_film_of_an_unequal_pair_is_named_with_what_is_there():
    pair = pair_of(16.0, 32.0)
    mesh = FilmMesh(pair, 6.2e3, 1.4, FAST, 0.6e-6)
    film = film_thickness(mesh, OIL, SLOW)
    rated = rate(mesh, OIL, SLOW, stage=8.0, treatment=Treatment.INDUCTION_HARDENED)
    worst = min(range(7), key=lambda k: film.thickness[k])
    assert rated.films == pytest.approx([h / 0.6e-6 for h in film.thickness])
    assert rated.point == ("A", "AB", "B", "C", "D", "DE", "E")[worst]
    assert (rated.pressure, rated.contact) == (film.pressure[worst], film.contact[worst])
    assert rated.safety == pytest.approx(rated.films[worst] / (1.4 * 0.65 * film_of_test(OIL, 8.0)))
    relieved = film_thickness(replace(mesh, relief=1.3), OIL, SLOW)
    assert (film.bulk - SLOW) / (relieved.bulk - SLOW) == pytest.approx(1.3)
