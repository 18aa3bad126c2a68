"""Miner's sum over the stress cycle factors of AGMA 2001, and one call that rates a mesh."""

import math

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.agma908 import HobbedPair, bending_geometry, pitting_geometry_factor
from gearwright.parts.agma2001 import (
    BENDING_CARBURISED,
    PITTING,
    AgmaDuty,
    AgmaMaking,
    AgmaSteel,
    agma_strength,
    dynamic_factor_agma,
    elastic_coefficient,
    greatest_velocity,
    load_distribution_factor,
    rate_agma,
    size_factor,
)
from gearwright.parts.gears import lewis_form_factor
from gearwright.parts.iso6336 import StressBin, damage_part, endurable_cycles, life_factor, spectrum_damage


@pytest.mark.parametrize("curve", [PITTING, BENDING_CARBURISED])
@pytest.mark.parametrize("cycles", [2e4, 1e6, 2e7, 3e9])
def test_endured_cycles_are_the_inverse_of_the_factor_on_both_sides_of_the_corner(curve, cycles):
    assert endurable_cycles(curve, float(life_factor(curve, cycles))) == pytest.approx(cycles, rel=1e-9)


def safety(*loads):
    return spectrum_damage([StressBin(*load) for load in loads], 1.0, PITTING).safety


def test_the_safety_of_one_load_is_its_factor_over_its_stress_and_two_halves_are_as_one_load():
    ratio, cycles = 0.7, 5e8
    alone = float(life_factor(PITTING, cycles)) / ratio
    assert safety((ratio, cycles)) == pytest.approx(alone, rel=1e-10)
    assert safety((ratio, cycles / 2.0), (ratio, cycles / 2.0)) == pytest.approx(alone, rel=1e-10)
    assert safety((ratio, cycles), (0.4, cycles)) < alone


def test_miners_sum_is_linear_in_the_cycles_and_leaves_out_what_does_not_load():
    assert damage_part(1e8, 0.9, PITTING) == pytest.approx(1e8 / endurable_cycles(PITTING, 0.9), rel=1e-12)
    assert damage_part(2e8, 0.9, PITTING) == pytest.approx(2.0 * damage_part(1e8, 0.9, PITTING), rel=1e-12)
    assert damage_part(1e9, 0.0, PITTING) == 0.0


@pytest.mark.parametrize("ratio", [1e-9, 1e9])
def test_a_spectrum_of_little_or_much_stress_has_its_safety_too(ratio):
    assert safety((ratio, 3e8), (ratio, 2e8)) == pytest.approx(float(life_factor(PITTING, 5e8)) / ratio, rel=1e-10)


def test_a_spectrum_without_stress_has_no_safety():
    with pytest.raises(DesignError, match="spectrum"):
        safety((0.0, 1e9), (0.9, 0.0))


PAIR = HobbedPair((21.0, 55.0), helix_angle=math.radians(15.0), face_width=12.0)
MAKING = AgmaMaking(
    agma_strength(AgmaSteel.CARBURISED, 2), BENDING_CARBURISED, PITTING, 206e9, 0.3, quality=9, reliability=0.999,
    temperature=1.1,
)  # fmt: skip
DUTY = AgmaDuty(300.0, 400.0, 3.6e6, overload=1.25, meshes_per_turn=(2.0, 1.0))
MODULE = 3e-3


def test_one_call_multiplies_the_factors_of_the_standard():
    """Eqs 1, 4, 10 and 13 by hand, from the functions of single factors; rounding."""
    rated = rate_agma(PAIR, MODULE, DUTY, MAKING)
    transverse, width = MODULE / math.cos(math.radians(15.0)), 12.0 * MODULE
    diameter = 21.0 * transverse
    force, speed = 600.0 / diameter, 200.0 * diameter
    cycles = (2.0 * 400.0 * 3.6e6 / (2.0 * math.pi), 400.0 * 3.6e6 / (2.0 * math.pi) * 21.0 / 55.0)
    assert rated.cycles == pytest.approx(cycles, rel=1e-12)
    crowd = 1.25 * dynamic_factor_agma(speed, 9) * load_distribution_factor(width, diameter)
    for gear, (one, count) in enumerate(zip(rated.gears, cycles, strict=True)):
        form = lewis_form_factor((21.0, 55.0)[gear] / math.cos(math.radians(15.0)) ** 3)
        raised = force * crowd * size_factor(width, transverse, form)
        bending = raised / (width * transverse * bending_geometry(PAIR, gear).factor)
        contact = elastic_coefficient((206e9,) * 2, (0.3,) * 2) * math.sqrt(
            raised / (diameter * width * pitting_geometry_factor(PAIR))
        )
        assert one.bending_stress == pytest.approx(bending, rel=1e-12)
        assert one.contact_stress == pytest.approx(contact, rel=1e-12)
        limit = MAKING.strength.bending * life_factor(BENDING_CARBURISED, count) / (1.25 * 1.1)
        assert one.bending_safety == pytest.approx(limit / bending, rel=1e-12)
        limit = MAKING.strength.contact * life_factor(PITTING, count) / (1.25 * 1.1)
        assert one.contact_safety == pytest.approx(limit / contact, rel=1e-12)


def test_an_array_of_modules_is_rated_as_each_of_them():
    many = rate_agma(PAIR, np.array([2e-3, MODULE]), DUTY, MAKING)
    one = rate_agma(PAIR, MODULE, DUTY, MAKING)
    assert many.gears[0].contact_safety[1] == pytest.approx(float(one.gears[0].contact_safety), rel=1e-12)
    assert many.gears[1].bending_safety[0] < many.gears[1].bending_safety[1]


def test_the_curve_of_the_dynamic_factor_ends_where_shigley_ends_it():
    """Q_v = 6: A = 59.77, V = (59.77 + 3)² = 3940 ft/min (eq. 14-29)."""
    assert greatest_velocity(6) * 60.0 / 0.3048 == pytest.approx(3940.0, rel=1e-3)
