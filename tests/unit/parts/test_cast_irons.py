"""Cast irons by ISO 6336: rows of part 5, and each clause that sets them beside steels of another group."""

import math

import numpy as np
import pytest

from designs import PAIR
from gearwright.catalogue import gear_steel
from gearwright.errors import DesignError
from gearwright.parts.iso6336 import GearSteel, Treatment, bending_life_curve, contact_life_curve, life_factor
from gearwright.parts.iso6336.dynamic import running_in_allowance
from gearwright.parts.iso6336.loads import lead_allowance
from gearwright.parts.iso6336.rating import static_notch_sensitivity
from gearwright.parts.iso6336.tooth_strength import (
    bending_size_factor,
    notch_sensitivity_factor,
    slip_layer,
    surface_factor,
    work_hardening_factor,
)
from gearwright.sizing import size
from gearwright.spec import parse

GREY, FERRITIC = Treatment.GREY_IRON, Treatment.FERRITIC_NODULAR_IRON
NODULAR, MALLEABLE = Treatment.NODULAR_IRON, Treatment.MALLEABLE_IRON


def iron(treatment, **more):
    return GearSteel("iron", treatment, "MQ", 200.0, 400e6, 150e6, **more)


@pytest.mark.parametrize(
    ("name", "grade", "hardness", "contact", "bending", "rows"),
    [
        ("malleable-iron", "MQ", 200.0, 1.371 * 200 + 143, 0.345 * 200 + 77, "9 and 15"),
        ("malleable-iron", "ME", 200.0, 1.333 * 200 + 267, 0.403 * 200 + 128, "10 and 16"),
        ("nodular-iron", "ML", 250.0, 1.434 * 250 + 211, 0.350 * 250 + 119, "11 and 17"),
        ("nodular-iron-ferritic", "ME", 250.0, 1.5 * 250 + 250, 0.38 * 250 + 134, "12 and 18"),
        ("grey-iron", "MQ", 200.0, 1.033 * 200 + 132, 0.256 * 200 + 8, "13 and 19"),
        ("grey-iron", "ME", 200.0, 1.465 * 200 + 122, 0.2 * 200 + 53, "14 and 20"),
    ],
)
def test_strengths_by_row_of_the_table(name, grade, hardness, contact, bending, rows):
    """ISO 6336-5:2016, table 1, rows 9 to 20; hardness in HBW."""
    found = gear_steel(name, grade, hardness)
    assert found.contact_strength == pytest.approx(contact * 1e6, rel=1e-12)
    assert found.bending_strength == pytest.approx(bending * 1e6, rel=1e-12)
    assert found.source.endswith(f"rows {rows}")


@pytest.mark.parametrize(
    ("name", "hardness"), [("grey-iron", 245.0), ("nodular-iron", 170.0), ("malleable-iron", 260.0)]
)
def test_a_hardness_that_an_iron_does_not_have_is_told(name, hardness):
    with pytest.raises(DesignError, match="nearest is"):
        gear_steel(name, "MQ", hardness)


def test_no_iron_has_a_hard_case_and_two_of_them_are_brittle():
    for treatment in (GREY, FERRITIC, NODULAR, MALLEABLE):
        assert treatment.is_cast_iron
        assert not treatment.is_surface_hardened
        assert not treatment.is_nitrided
        assert treatment.is_brittle_iron == (treatment in (GREY, FERRITIC))
    hard = [treatment for treatment in Treatment if treatment.is_surface_hardened]
    assert [treatment.value for treatment in hard] == ["Eh", "IF", "NT", "NV", "NVc"]


def test_lives_are_those_of_nitrided_or_of_tempered_steel():
    """ISO 6336-2, table 2: 1.3 at 1e5 and 1 at 2e6; 1.6 and 1 at 5e7. ISO 6336-3, table 1: 1.6 at 1e3; 2.5 at 1e4."""
    for treatment in (GREY, FERRITIC):
        assert contact_life_curve(treatment).cycles == (1e5, 2e6, 1e10)
        assert contact_life_curve(treatment, some_pitting=True).factors == (1.3, 1.0, 0.85)
        assert bending_life_curve(treatment) == bending_life_curve(Treatment.NITRIDED)
    for treatment in (NODULAR, MALLEABLE):
        for curve in (contact_life_curve, bending_life_curve):
            assert curve(treatment) == curve(Treatment.THROUGH_HARDENED)
    assert float(life_factor(contact_life_curve(GREY), 4e5)) == pytest.approx(1.3 ** (math.log(5) / math.log(20)))


def test_roots_of_brittle_irons():
    """ρ′ = 0.3095 mm; Y_RrelT = 4.299 − 3.259 (R_z + 1)^0.0058, 1.025 below 1 µm; Y_X = 1.075 − 0.015 m_n to 0.7."""
    for treatment in (GREY, FERRITIC):
        assert slip_layer(iron(treatment)) == pytest.approx(0.3095e-3)
        depth = 1.0 + math.sqrt(0.3095 * 0.2 * (1.0 + 2.0 * 1.8))
        factor = depth / (1.0 + math.sqrt(0.3095 * 1.2))
        assert float(notch_sensitivity_factor(1.8, iron(treatment))) == pytest.approx(factor)
        assert float(surface_factor(20e-6, treatment)) == pytest.approx(4.299 - 3.259 * 21.0**0.0058)
        assert float(surface_factor(0.5e-6, treatment)) == 1.025
        sizes = bending_size_factor(np.array([4e-3, 10e-3, 25e-3, 40e-3]), treatment)
        assert sizes == pytest.approx([1.0, 0.925, 0.7, 0.7])
        assert static_notch_sensitivity(2.3, iron(treatment)) == 1.0


def test_roots_of_tough_irons_are_those_of_tempered_steel():
    steel = GearSteel("V", Treatment.THROUGH_HARDENED, "MQ", 200.0, 400e6, 150e6, yield_strength=500e6)
    for treatment in (NODULAR, MALLEABLE):
        same = iron(treatment, yield_strength=500e6)
        assert slip_layer(same) == slip_layer(steel) == pytest.approx(0.0281e-3)
        assert surface_factor(20e-6, treatment) == surface_factor(20e-6, Treatment.THROUGH_HARDENED)
        assert bending_size_factor(12e-3, treatment) == bending_size_factor(12e-3, Treatment.THROUGH_HARDENED)
        with pytest.raises(DesignError, match="notch sensitivity"):
            slip_layer(iron(treatment))


@pytest.mark.parametrize(("speed", "most"), [(4.0, (27.5, 110.0)), (8.0, (22.0, 45.0)), (12.0, (11.0, 22.0))])
def test_brittle_irons_run_in_more(speed, most):
    """y_α = 0.275 f_pb up to 22 and 11 µm, y_β = 0.55 F_βx up to 45 and 22 µm, from 5 and 10 m/s on."""
    for treatment in (GREY, FERRITIC):
        assert float(running_in_allowance(100e-6, iron(treatment), speed)) == pytest.approx(most[0] * 1e-6)
        assert float(lead_allowance(200e-6, iron(treatment), speed)) == pytest.approx(most[1] * 1e-6)
        assert float(running_in_allowance(10e-6, iron(treatment), speed)) == pytest.approx(2.75e-6)
        assert float(lead_allowance(10e-6, iron(treatment), speed)) == pytest.approx(5.5e-6)


def test_no_iron_hardens_under_a_hard_mate():
    for treatments in ((GREY, Treatment.CASE_HARDENED), (NODULAR, Treatment.CASE_HARDENED),
                       (Treatment.THROUGH_HARDENED, MALLEABLE)):  # fmt: skip
        found = work_hardening_factor(200.0, treatments, mate_hardness=650.0, mate_roughness=3e-6, ratio=4.0)
        assert found == 1.0


def test_a_design_of_iron_is_rated_by_its_class():
    material = """
[materials.iron]
elastic_modulus_gpa = 126
poisson_ratio = 0.3
density_kg_m3 = 7300
yield_strength_mpa = 200
hardness_hb = 200
steel = "grey-iron"
source = "for this test"
"""
    text = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "iso6336"\nmaterial = "iron"\n{material}'
    sizing = size(parse(text))
    rated = sizing.meshes[0].rating
    assert rated.steel.treatment is GREY
    assert rated.steel.contact_strength == pytest.approx((1.033 * 200 + 132) * 1e6)
    elastic = math.sqrt(126e3 / (2.0 * math.pi * 0.91))  # √(N/mm²)
    assert float(rated.factors.pitting.geometry.elasticity) == pytest.approx(1e3 * elastic, rel=1e-9)
    assert rated.micropitting is None
