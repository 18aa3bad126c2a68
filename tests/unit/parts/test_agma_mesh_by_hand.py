"""A mesh rated by AGMA 2001 in one call, and Miner's sum over its curves: every factor handed on as the clauses say."""

import math

import pytest

from gearwright.parts.agma908 import HobbedPair, bending_geometry, pitting_geometry_factor
from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    PITTING,
    PRECISION,
    AgmaDuty,
    AgmaGear,
    AgmaLoad,
    AgmaMaking,
    AgmaMesh,
    AgmaStrength,
    agma_rating,
    dynamic_factor_agma,
    elastic_coefficient,
    greatest_velocity,
    load_distribution_factor,
    rate_agma,
    reliability_factor,
    size_factor,
)
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import StressBin, damage_part, endurable_cycles, life_factor, spectrum_damage

HELICAL = HobbedPair((19, 64), math.radians(20.0), math.radians(12.0), 9.0, (0.1, -0.1), (1.0, 1.0), 1.35, 0.3, 0.02)
STRENGTH = AgmaStrength(450e6, 1550e6)


def near(value):
    return pytest.approx(value, rel=1e-9, abs=0.0)


@pytest.mark.parametrize(("factor", "constant", "exponent"), [
    (1.4, 2.466, 0.056), (1.01, 2.466, 0.056), (0.95, 1.4488, 0.023), (0.7, 1.4488, 0.023),
])  # fmt: skip
def test_endured_cycles_are_where_the_curve_has_the_factor(factor, constant, exponent):
    """(c/Z_N)^(1/e) on the branch that the factor lies on; the corner of 1e7 has 1.00."""
    assert endurable_cycles(PITTING, factor) == near((constant / factor) ** (1.0 / exponent))


def test_nothing_is_endured_without_end_but_no_stress():
    """e^600 times the corner's cycles and more are none that a machine makes."""
    assert damage_part(1e30, 0.0, PITTING) == damage_part(1e30, -0.1, PITTING) == 0.0
    limit = 1.4488 * math.exp(-0.023 * (600.0 + math.log(PITTING.cycles[1])))
    assert endurable_cycles(PITTING, limit * 0.99) == math.inf > endurable_cycles(PITTING, limit * 1.01)


def test_miner_adds_what_every_load_takes():
    """n/N by the branches of the curve; the safety brings the sum to one."""
    n_1, n_2 = (2.466 / 1.2) ** (1.0 / 0.056), (1.4488 / 0.8) ** (1.0 / 0.023)
    loads = [StressBin(1.2, 0.3 * n_1), StressBin(0.8, 0.2 * n_2), StressBin(0.0, 1e30)]
    assert spectrum_damage(loads, 1.0, PITTING).total == near(0.5)
    safety = spectrum_damage([StressBin(0.9, 1e6), StressBin(0.6, 1e9)], 1.0, PITTING).safety
    made = damage_part(1e6, 0.9 * safety, PITTING) + damage_part(1e9, 0.6 * safety, PITTING)
    assert made == pytest.approx(1.0, rel=1e-9)
    n = (2.466 / 1.3) ** (1.0 / 0.056)
    for ratio in (1.3 / 1100.0, 1.3 / 900.0, 1.3 * 900.0, 1.3 * 1100.0):
        alone = spectrum_damage([StressBin(ratio, n)], 1.0, PITTING).safety
        assert alone == pytest.approx(1.3 / ratio, rel=1e-9)


@pytest.mark.parametrize("making", [
    AgmaMaking(STRENGTH, BENDING_CARBURISED, PITTING, 207e9, 0.29, 8, PRECISION, 0.8, 0.9, 0.999, 1.1),
    AgmaMaking(STRENGTH, BENDING_CARBURISED, PITTING, 207e9, 0.29),
])  # fmt: skip
def test_a_mesh_is_rated_by_its_clauses_in_order(making):
    """W_t = 2 T/d, v = ω d/2, n = ω L q/2π over the ratio for the gear; K_R of table 11; d and F of the pinion."""
    duty = AgmaDuty(300.0, -200.0, 5e6, 1.25, (3.0, 2.0))
    made = rate_agma(HELICAL, 4e-3, duty, making)
    transverse = 4e-3 / math.cos(math.radians(12.0))
    d, width, turns = 19.0 * transverse, 36e-3, 200.0 * 5e6 / (2.0 * math.pi)
    cycles = (3.0 * turns, 2.0 * turns * 19.0 / 64.0)
    assert (made.tangential_force, made.speed, made.cycles) == (near(600.0 / d), near(100.0 * d), near(cycles))
    usual = making.quality == 11
    k_v = dynamic_factor_agma(100.0 * d, 11.0 if usual else 8.0)
    mounted = {} if usual else {"mounting": PRECISION, "crowning": 0.8, "adjustment": 0.9}
    k_m = load_distribution_factor(width, d, **mounted)
    k_r, k_t = (1.0, 1.0) if usual else (1.25, 1.1)
    assert reliability_factor(making.reliability) == near(k_r)
    assert (made.overload, made.dynamic, made.distribution) == (1.25, near(k_v), near(k_m))
    assert (made.reliability, made.temperature, made.strength) == (near(k_r), k_t, STRENGTH)
    elastic = elastic_coefficient((207e9, 207e9), (0.29, 0.29))
    assert made.elastic == near(elastic)
    mesh = AgmaMesh(width, transverse, d, pitting_geometry_factor(HELICAL), elastic)
    assert made.pitting_geometry == near(mesh.pitting_factor)
    load = AgmaLoad(600.0 / d, 1.25, k_v, k_m)
    for gear in (0, 1):
        teeth = (19.0, 64.0)[gear] / math.cos(math.radians(12.0)) ** 3
        size = size_factor(width, transverse, float(lewis_form_factor(teeth)))
        y_n, z_n = life_factor(BENDING_CARBURISED, cycles[gear]), life_factor(PITTING, cycles[gear])
        j = bending_geometry(HELICAL, gear)
        assert made.tooth_root[gear] == j and made.size[gear] == near(size)
        assert (made.bending_cycles[gear], made.contact_cycles[gear]) == (near(y_n), near(z_n))
        body = AgmaGear(j.factor, STRENGTH, size, 1.0, y_n, z_n)
        by_hand = agma_rating(load, body, mesh, reliability=k_r, temperature=k_t)
        assert tuple(vars(made.gears[gear]).values()) == near(tuple(vars(by_hand).values()))


def test_a_duty_is_nominal_and_of_one_mesh_if_nothing_else_is_said():
    made = rate_agma(HELICAL, 4e-3, AgmaDuty(300.0, 200.0, 5e6), AgmaMaking(STRENGTH, PITTING, PITTING, 207e9, 0.29))
    turns = 200.0 * 5e6 / (2.0 * math.pi)
    assert made.overload == 1.0 and made.cycles == near((turns, turns * 19.0 / 64.0))


@pytest.mark.parametrize("quality", [6.0, 9.0])
def test_k_v_holds_up_to_its_greatest_velocity(quality):
    """(A + Q_v − 3)² in ft/min, A = 50 + 56 (1 − B), B = ¼ (12 − Q_v)^⅔."""
    a = 50.0 + 56.0 * (1.0 - 0.25 * (12.0 - quality) ** (2.0 / 3.0))
    assert greatest_velocity(quality) == near((a + quality - 3.0) ** 2 * 0.3048 / 60.0)
