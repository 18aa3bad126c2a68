"""One thing that a design tells twice, and not alike: oils, roughnesses, steels, methods of one gear; and one home."""

import pytest

from designs import PAIR
from gearwright.errors import DesignError
from gearwright.parts.losses import OilState
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.losses import loss_balance, oil_of_design
from gearwright.spec import parse, read

TEETH = f"{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n"
OIL = "[oil]\nviscosity_40 = 220\nviscosity_100 = 19\ntemperature = 70\n"


def rated(method: str, rules: str = "", more: str = "") -> str:
    return f'{TEETH}\n[gears]\nrating = "{method}"\n{rules}\n{more}'


def problem(text: str) -> str:
    """Return all that is wrong with a text."""
    with pytest.raises(DesignError) as caught:
        parse(text)
    return str(caught.value)


def test_teeth_take_the_oil_of_the_design():
    design = parse(rated("iso6336", more=OIL))
    rules = design.rules("stage").iso6336
    assert (rules.oil_viscosity, rules.oil_viscosity_100, rules.oil_temperature) == (220.0, 19.0, 70.0)
    written = parse(
        rated("iso6336", "[gears.iso6336]\noil_viscosity = 220\noil_viscosity_100 = 19\noil_temperature = 70")
    )
    assert size(design).meshes[0].rating == size(written).meshes[0].rating


def test_a_stage_may_have_an_oil_of_its_own_and_keeps_its_whole_grade():
    """ν_100 of [oil] is none of an oil that has another ν_40; the temperature is that of the gearbox."""
    own = "[pairs.stage.gears.iso6336]\noil_viscosity = 68\n"
    rules = parse(rated("iso6336", more=OIL + own)).rules("stage").iso6336
    assert (rules.oil_viscosity, rules.oil_viscosity_100, rules.oil_temperature) == (68.0, None, 70.0)


def test_without_oil_of_the_design_rules_are_as_they_stand():
    design = parse(rated("iso6336"))
    assert design.rules("stage") is design.gears


@pytest.mark.parametrize(
    ("rule", "value", "of_oil"),
    [
        ("oil_viscosity", 100, "viscosity_40"),
        ("oil_viscosity_100", 12, "viscosity_100"),
        ("oil_temperature", 90, "temperature"),
    ],
)
def test_two_oils_of_one_gearbox_are_told(rule, value, of_oil):
    told = problem(rated("iso6336", f"[gears.iso6336]\n{rule} = {value}\n", OIL))
    assert f"gears.iso6336.{rule}" in told
    assert f"oil.{of_oil}" in told


def test_losses_take_the_roughness_that_the_flanks_are_rated_with():
    """R_a = R_z/6 by ISO 6336-2; R_a itself by AGMA 2001; what [losses] says comes first."""
    iso = size(parse(rated("iso6336", "[gears.iso6336]\nflank_roughness_um = 3\n")))
    assert oil_of_design(iso).on_teeth("stage").roughness == pytest.approx(0.5e-6, rel=1e-12)
    agma = size(parse(rated("agma2001", "[gears.agma2001]\nflank_roughness_um = 0.6\n")))
    assert oil_of_design(agma).on_teeth("stage").roughness == pytest.approx(0.6e-6, rel=1e-12)
    both = parse(rated("iso6336", "[gears.iso6336]\nflank_roughness_um = 3\n", "[losses]\nroughness_um = 0.7\n"))
    assert oil_of_design(size(both)).on_teeth("stage").roughness == pytest.approx(0.7e-6, rel=1e-12)
    assert oil_of_design(size(parse(rated("iso6336")))).on_teeth("stage").roughness == pytest.approx(0.4e-6, rel=1e-12)


def test_losses_take_the_factor_of_the_base_oil():
    """Schlenk's friction is proportional to X_L: 0.7 of a polyglycol; with R_z of 2.4 µm R_a is 0.4 µm."""
    rules = "[gears.iso6336]\nflank_roughness_um = 2.4\noil_type = "
    thin, plain = (
        loss_balance(size(parse(rated("iso6336", f'{rules}"{base}"\n')))).by_origin()["meshes"]
        for base in ("polyglycol", "mineral")
    )
    assert thin / plain == pytest.approx(0.7, rel=1e-9)


def test_a_stage_without_flanks_of_its_own_has_those_of_all():
    oil = oil_of_design(size(read(shipped_design("off-set"))))
    assert oil.on_teeth() == OilState(oil.viscosity * oil.density, oil.density, oil.roughness, 1.0)


def test_a_roughness_that_the_rated_flanks_do_not_have_is_told():
    """R_z 3 µm is R_a 0.5; up to twice as much or half of it may be of one surface."""
    rules = "[gears.iso6336]\nflank_roughness_um = 3\n"
    assert "losses.roughness" in problem(rated("iso6336", rules, "[losses]\nroughness_um = 1.01\n"))
    assert "losses.roughness" in problem(rated("iso6336", rules, "[losses]\nroughness_um = 0.24\n"))
    for allowed in (0.26, 0.99):
        parse(rated("iso6336", rules, f"[losses]\nroughness_um = {allowed}\n"))


def test_a_shaper_cutter_without_a_ring_is_told():
    told = problem(rated("iso6336", "[gears.iso6336.ring_cutter]\nteeth = 20\n"))
    assert "gears.iso6336.ring_cutter" in told
    assert "no ring" in told


RAVIGNEAUX_WITHOUT_RING = """
schema = 1
name = "two suns and a stepped planet"
shafts = ["in", "out", "cage"]
level = "concept"
[motors.motor]
shaft = "in"
power_kw = 20
speed_rpm = 3000

[loads.load]
shaft = "out"

[clutches.hold]
driving = "cage"
driven = "ground"
kind = "engaged"

[epicyclics.set]
carrier = "cage"
sets = 3
suns.small = { shaft = "in", teeth = 24 }
suns.large = { shaft = "out", teeth = 36 }
planets.first = { teeth = 36, meshes = ["small"] }
planets.second = { teeth = 24, meshes = ["large"], in_one_piece_with = "first" }

[gears]
rating = "iso6336"
"""


@pytest.mark.parametrize(
    ("rules", "path", "words"),
    [
        ("rim_thickness_ratio = 4", "gears.rim_thickness_ratio", "no ring"),
        ("iso6336.ring_cutter = { teeth = 20 }", "gears.iso6336.ring_cutter", "no ring"),
        ('iso6336.wheel = { steel = "case-hardened", hardness_hv = 700 }', "gears.iso6336.wheel", "no ring"),
        ('iso6336.mounting = "straddle"', "gears.iso6336.mounting", "only bevel gears"),
    ],
)
def test_a_sets_own_rules_of_what_it_does_not_have_are_told(rules, path, words):
    parse(RAVIGNEAUX_WITHOUT_RING)
    told = problem(f"{RAVIGNEAUX_WITHOUT_RING}\n[epicyclics.set.gears]\n{rules}\n")
    assert f"epicyclics.set.{path}" in told
    assert words in told


def test_teeth_and_gearbox_have_one_oil_where_no_oil_is_named():
    design = parse(rated("iso6336"))
    teeth, oil = design.rules("stage").iso6336, design.oil
    assert (teeth.oil_viscosity, teeth.oil_temperature) == (oil.viscosity_40, oil.temperature)


@pytest.mark.parametrize(
    ("material", "rules", "path", "words"),
    [
        ("16MnCr5", 'steel = "through-hardened"', "steel", '"carburised"'),
        ("32CDV13", 'steel = "carburised"', "steel", '"nitrided-4140"'),
        ("tempered", 'steel = "carburised"', "steel", '"through-hardened"'),
        ("tempered", 'steel = "through-hardened"\nhardness_hb = 240', "hardness_hb", "300 HB"),
        ("hardened", 'steel = "carburised"', "steel", "another material"),
        ("16MnCr5", "hardness_hb = 300", "hardness_hb", "no effect"),
    ],
)
def test_a_steel_of_agma_that_the_stated_material_is_not_is_told(material, rules, path, words):
    told = problem(rated("agma2001", f'material = "{material}"\n[gears.agma2001]\n{rules}\n', MATERIALS))
    assert f"gears.agma2001.{path}" in told
    assert words in told


def test_a_steel_of_agma_that_agrees_with_its_material_is_taken():
    """300 HB, and 8 per cent of it for the conversion of scales."""
    for hardness in (300, 280, 320):
        rules = f'material = "tempered"\n[gears.agma2001]\nsteel = "through-hardened"\nhardness_hb = {hardness}\n'
        parse(rated("agma2001", rules, MATERIALS))
    parse(rated("agma2001", 'material = "16MnCr5"\n'))
    parse(rated("agma2001", 'material = "32CDV13"\n'))  # AGMA's own steel, where none is named


MATERIALS = """
[materials.tempered]
elastic_modulus_mpa = 206000
poisson_ratio = 0.3
density_kg_m3 = 7850
yield_strength_mpa = 800
hardness_hb = 300
steel = "through-hardened-alloy"
source = "for this test"
[materials.hardened]
elastic_modulus_mpa = 206000
poisson_ratio = 0.3
density_kg_m3 = 7850
yield_strength_mpa = 800
hardness_hv = 550
steel = "induction-hardened"
source = "for this test"
"""


def test_bevels_by_agma_are_held_against_their_material_too():
    text = f'{TEETH}kind = "bevel"\naxis_angle_deg = 90\n[gears]\nrating = "agma2003"\nmaterial = "16MnCr5"\n'
    parse(text)
    assert "gears.agma2003.steel" in problem(f'{text}[gears.agma2003]\nsteel = "through-hardened"\n')


def test_a_gear_that_pairs_share_is_rated_by_one_method():
    chain = TEETH.replace('shafts = ["', 'shafts = ["third", "')
    more = (
        '[pairs.next]\npinion = "stage.wheel"\nwheel = "third"\nwheel_teeth = 50\n'
        '[pairs.next.gears]\nrating = "din3990"\n[motors.end]\nshaft = "third"\npower_kw = 1\nspeed_rpm = 500\n'
    )
    told = problem(f'{chain}\n{more}\n[gears]\nrating = "iso6336"\n')
    assert "pairs.next.gears.rating" in told
