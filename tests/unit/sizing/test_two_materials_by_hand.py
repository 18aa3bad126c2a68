"""A mesh of two materials: each gear brings its own E and ν into Z_E, c′, E_r and the stiffness of the teeth."""

import math
from dataclasses import replace

import pytest

from designs import PAIR
from gearwright.catalogue import gear_steel, materials, rated_steel
from gearwright.dynamics.assembly.meshes import gear_pairs, mesh_curve
from gearwright.parts.gears import reduced_modulus
from gearwright.parts.iso6336 import elasticity_factor, mesh_geometry, mesh_springs
from gearwright.parts.scuffing import thermo_elastic_factor
from gearwright.parts.stiffness import mesh_stiffness_iso6336
from gearwright.sizing import size
from gearwright.sizing.rating import rating_of
from gearwright.sizing.rating.iso6336_inputs import steels_of
from gearwright.spec import parse

STEEL = gear_steel("case-hardened", "MQ", 700.0)
NODULAR = replace(gear_steel("nodular-iron", "MQ", 250.0), elastic_modulus=173e9)
WHEELS = {
    "nodular-iron": "yield_strength_mpa = 370", "nodular-iron-ferritic": "", "grey-iron": "",
    "malleable-iron": "yield_strength_mpa = 370",
}  # fmt: skip
TABLE = {"nodular-iron": 173e9, "nodular-iron-ferritic": 173e9, "grey-iron": 126e9, "malleable-iron": 172e9}


def design(wheel="", gears="", rules="", more=""):
    own = f'[gears.iso6336.wheel]\nsteel = "{wheel}"\nhardness_hv = 200\n{WHEELS[wheel]}\n' if wheel else ""
    head = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\nmodule_mm = 3\n[gears]\nrating = "iso6336"\n{gears}'
    return parse(f"{head}face_width_ratio = 12\n[gears.iso6336]\n{rules}\n{own}{more}")


@pytest.mark.parametrize(
    ("modulus", "printed"),
    [(206e9, 189.8), (202e9, 188.9), (173e9, 181.4), (103e9, 155.0), (113e9, 159.8), (118e9, 162.0), (126e9, 165.4)],
)
def test_z_e_of_steel_and_another_material_is_that_of_the_table(modulus, printed):
    """ISO 6336-2 and DIN 3990-2, table of Z_E: steel on steel, cast steel, nodular iron, bronzes, grey irons; N/mm²,
    half a unit of the last printed digit."""
    other = replace(STEEL, elastic_modulus=modulus)
    assert elasticity_factor((STEEL, other)) / 1e3 == pytest.approx(printed, abs=0.051)
    assert elasticity_factor((STEEL, other)) == pytest.approx(elasticity_factor((other, STEEL)), rel=1e-12)


def test_both_poisson_ratios_enter_z_e():
    """1/√(π (0.91/206 + (1 − 0.28²)/173)) with 1000 N/mm²: 181.36 → 182.9 of 0.9216 in place of 0.91."""
    other = replace(NODULAR, poisson_ratio=0.28)
    by_hand = 1.0 / math.sqrt(math.pi * (0.91 / 206e3 + (1.0 - 0.28**2) / 173e3))
    assert elasticity_factor((STEEL, other)) / 1e3 == pytest.approx(by_hand, rel=1e-12)


def test_the_reduced_modulus_of_two_materials_lies_between_theirs():
    """2/(0.91/206 + 0.91/173) = 206.66 GPa; of equals E/(1 − ν²), to the bit."""
    assert reduced_modulus((206e9, 0.3), (173e9, 0.3)) == pytest.approx(206.66e9, rel=1e-4)
    assert reduced_modulus((206e9, 0.3)) == reduced_modulus((206e9, 0.3), (206e9, 0.3)) == 206e9 / (1.0 - 0.3**2)
    by_hand = 2.0 / ((1.0 - 0.3**2) / 206e9 + (1.0 - 0.25**2) / 120e9)
    assert reduced_modulus((206e9, 0.3), (120e9, 0.25)) == pytest.approx(by_hand, rel=1e-12)
    x_m = thermo_elastic_factor(206e9, 0.3, (173e9, 0.3))
    assert x_m == pytest.approx(thermo_elastic_factor(206e9, 0.3) * (2.0 * 173.0 / 379.0) ** 0.25, rel=1e-12)


def test_the_mesh_of_another_modulus_is_softer_by_e_over_e_st():
    """2·206·173/379/206 = 0.91293 of steel on nodular iron, 0.83981 of iron on iron; 206·420/416/206 of steels."""
    sizing = size(design())
    pair = gear_pairs(sizing)[sizing.meshes[0].name]
    mesh = mesh_geometry(pair)
    plain = mesh_springs(mesh)
    for steels, factor in (
        ((STEEL, NODULAR), 0.912929), ((NODULAR, STEEL), 0.912929), ((NODULAR, NODULAR), 0.839806),
        ((STEEL, replace(STEEL, elastic_modulus=210e9)), 1.009615),
    ):  # fmt: skip
        soft = mesh_springs(mesh, steels=steels)
        for one, other in ((soft.single, plain.single), (soft.mesh, plain.mesh), (soft.face, plain.face)):
            assert float(one / other) == pytest.approx(factor, rel=2e-6)
    whole = mesh_stiffness_iso6336(pair, elastic_moduli=(206e9, 173e9))
    assert float(mesh_springs(mesh, steels=(STEEL, NODULAR)).single) == pytest.approx(whole.single, rel=1e-12)


@pytest.mark.parametrize("wheel", WHEELS)
def test_a_wheel_of_iron_brings_its_own_modulus_and_the_pinion_keeps_that_of_steel(wheel):
    """E of its class by the table of Z_E; Z_E and X_M of the pair by hand."""
    sizing = size(design(wheel))
    steel = materials()[sizing.design.rules(sizing.meshes[0].stage).material]
    rated = sizing.meshes[0].rating
    assert (rated.steel.elastic_modulus, rated.steel.poisson_ratio) == (steel.elastic_modulus, steel.poisson_ratio)
    assert (rated.mate_steel.elastic_modulus, rated.mate_steel.poisson_ratio) == (TABLE[wheel], 0.3)
    bodies = (steel.elastic_modulus, steel.poisson_ratio), (TABLE[wheel], 0.3)
    compliance = sum((1.0 - ratio**2) / modulus for modulus, ratio in bodies)
    assert rated.factors.pitting.geometry.elasticity == pytest.approx((math.pi * compliance) ** -0.5, rel=1e-12)
    assert rated.scuffing.thermal_flash == pytest.approx(
        math.sqrt(1000.0) * (2.0 / compliance / 1e6) ** 0.25 / math.sqrt(190.0), rel=1e-12
    )


def test_an_iron_wheel_presses_less_and_its_teeth_are_softer():
    """σ_H falls with √(Z_E²), teeth with E/E_St; flanks of the pinion keep their strength."""
    steel, iron = size(design()), size(design("nodular-iron"))
    assert iron.meshes[0].rating.contact_stress < steel.meshes[0].rating.contact_stress
    name = steel.meshes[0].name
    stiff, soft = (
        mesh_curve(sizing, sizing.meshes[0], gear_pairs(sizing)[name], harmonics=0).mean for sizing in (steel, iron)
    )
    own = materials()[steel.design.rules(steel.meshes[0].stage).material].elastic_modulus
    assert soft / stiff == pytest.approx(2.0 * 173e9 / (own + 173e9), rel=1e-9)


def test_classes_of_steel_and_the_irons_own_class_keep_the_modulus_of_the_material():
    steel, iron = materials()["16MnCr5"], materials()["EN-GJS-700-2"]
    assert rated_steel(steel, "nitrided").elastic_modulus == steel.elastic_modulus
    assert rated_steel(iron).elastic_modulus == iron.elastic_modulus == 176e9
    assert rated_steel(iron, "nodular-iron", hardness=250.0).poisson_ratio == iron.poisson_ratio == 0.28
    assert rated_steel(iron, "grey-iron", hardness=200.0).elastic_modulus == 126e9
    assert rated_steel(steel, "grey-iron", hardness=200.0).poisson_ratio == 0.3


def test_a_material_without_a_class_is_of_the_one_that_the_stage_is_rated_as():
    mine = """
[materials.mine]
elastic_modulus_gpa = 210
poisson_ratio = 0.29
density_kg_m3 = 7850
yield_strength_mpa = 700
source = "for this test"
"""
    made = design("grey-iron", 'material = "mine"\n', 'steel = "case-hardened"\nhardness_hv = 700', mine)
    sizing = size(made)
    mesh = sizing.meshes[0]
    first, second = steels_of(rating_of(made, mesh.stage, sizing.teeth), tuple(gear.role for gear in sizing.gears))
    assert (first.elastic_modulus, second.elastic_modulus) == (210e9, 126e9)
    assert (first.poisson_ratio, second.poisson_ratio) == (0.29, 0.3)
