"""The catalogue's materials: complete, sane, each with its source, none with a number that nobody gave."""

import dataclasses

import pytest

from gearwright.catalogue import is_cast_iron, material_of, materials, rated_steel
from gearwright.parts import LifeLine
from gearwright.parts.iso6336 import Treatment, contact_life_curve, endurable_cycles, knee_curve, life_curves
from gearwright.parts.material import BRINELL_PER_VICKERS, vickers_of_rockwell
from gearwright.parts.shaft_fatigue import SteelGroup

GEARS = {name: steel for name, steel in materials().items() if steel.steel is not None}
BANDS = {
    Treatment.CASE_HARDENED: ((1300, 1650), (312, 525), (600, 800)),
    Treatment.NITRIDED: ((1125, 1450), (270, 468), (650, 900)),
    Treatment.THROUGH_HARDENED: ((413, 1124), (136, 371), (115, 390)),
    Treatment.NODULAR_IRON: ((462, 700), (180, 248), (175, 300)),
}
"""Group -> least and greatest σ_Hlim [MPa], σ_Flim [MPa] and hardness [HV, HBW of iron] of ISO 6336-5, table 1."""
WORDS = ("name", "source", "sources", "estimated")


def test_the_steels_that_gear_designers_ask_for_are_there():
    asked = {
        "AISI-9310", "Pyrowear-53", "M50NiL", "32CDV13", "18CrNiMo7-6", "16MnCr5", "20MnCr5", "34CrNiMo6", "42CrMo4",
        "31CrMoV9", "Nitralloy-N", "Nitralloy-135M", "AISI-4340", "EN36A", "17CrNi6-6", "15CrNi6", "20NiCrMo2-2", "C45",
        "Vasco-X2", "CSS-42L", "Ferrium-C61", "Ferrium-C64", "33CrMoV12-9",
    }  # fmt: skip
    assert asked <= set(GEARS)


IRONS = [name for name, material in materials().items() if is_cast_iron(material.steel)]


def test_irons_are_those_whose_numbers_a_foundry_prints():
    """EN 1563: E, density, R_p0.2, R_m and the least hardness, which the class of ISO 6336-5 has."""
    assert set(IRONS) == {"EN-GJS-600-3", "EN-GJS-700-2"}
    for name in IRONS:
        iron = materials()[name]
        assert iron.ultimate_strength == 1e6 * float(name.split("-")[2])
        assert 0.55 < iron.yield_strength / iron.ultimate_strength < 0.65
        assert 169e9 < iron.elastic_modulus < 180e9
        assert 7000.0 < iron.density < 7300.0
        assert rated_steel(iron).hardness == iron.surface_hardness


@pytest.mark.parametrize("name", [name for name in materials() if name not in IRONS])
def test_a_material_is_a_steel(name):
    steel = materials()[name]
    assert 190e9 <= steel.elastic_modulus <= 215e9
    assert 0.27 <= steel.poisson_ratio <= 0.31
    assert 7700.0 <= steel.density <= 7900.0
    if steel.ultimate_strength is not None:
        assert 0.5 < steel.yield_strength / steel.ultimate_strength < 0.95
    assert steel.group is None or steel.group.upper().replace("-", "_") in SteelGroup.__members__


@pytest.mark.parametrize("name", GEARS)
def test_the_strengths_of_a_gear_steel_lie_in_the_band_of_its_group(name):
    steel = rated_steel(GEARS[name])
    contact, bending, hardness = BANDS[steel.treatment]
    assert contact[0] <= steel.contact_strength / 1e6 <= contact[1]
    assert bending[0] <= steel.bending_strength / 1e6 <= bending[1]
    assert hardness[0] <= steel.hardness <= hardness[1]


@pytest.mark.parametrize("name", GEARS)
def test_the_two_hardnesses_of_a_flank_are_of_one_flank(name):
    """ISO 18265, HB = 0.95 HV; the two older entries state both, from different sources."""
    steel = GEARS[name]
    assert steel.surface_hardness == pytest.approx(BRINELL_PER_VICKERS * steel.hardness, rel=0.05)


@pytest.mark.parametrize("name", GEARS)
def test_a_through_hardened_steel_is_as_hard_as_it_is_strong(name):
    """R_m of ISO 18265 is about 3.2 times the Vickers hardness; a part may be harder than its least strength."""
    steel = GEARS[name]
    if rated_steel(steel).treatment is Treatment.THROUGH_HARDENED:
        assert 2.9 < steel.ultimate_strength / 1e6 / steel.hardness < 3.4


@pytest.mark.parametrize("name", materials())
def test_every_number_has_a_source_or_the_rule_by_which_it_is_estimated(name):
    steel = materials()[name]
    keys = {field.name for field in dataclasses.fields(steel)} - set(WORDS)
    assert steel.source
    assert set(steel.sources) | set(steel.estimated) <= keys
    assert not set(steel.sources) & set(steel.estimated)
    for key in keys:
        assert steel.source_of(key).strip()
    for key in set(steel.estimated) - {"contact_strength", "bending_strength"}:
        assert getattr(steel, key) is not None, key


def test_steels_that_iso_6336_does_not_cover_say_that_their_strengths_are_estimated():
    for name in ("Pyrowear-53", "M50NiL", "Vasco-X2", "CSS-42L", "Ferrium-C61", "Ferrium-C64"):
        assert {"contact_strength", "bending_strength"} <= set(GEARS[name].estimated), name
    assert not {"contact_strength", "bending_strength"} & set(GEARS["16MnCr5"].estimated)


def test_what_nobody_knows_is_left_out():
    for name in ("M50NiL", "Vasco-X2", "CSS-42L", "Nitralloy-N"):
        assert (GEARS[name].yield_strength, GEARS[name].ultimate_strength, GEARS[name].group) == (None, None, None)


@pytest.mark.parametrize(
    ("rockwell", "vickers"), [(20.3, 240), (30.4, 305), (45.3, 450), (60.1, 700), (64.0, 800), (68, 940)]
)
def test_rockwell_converts_by_iso_18265(rockwell, vickers):
    assert vickers_of_rockwell(rockwell) == pytest.approx(vickers, rel=1e-12)


def test_no_hardness_is_converted_beyond_the_table():
    with pytest.raises(ValueError, match=r"converts 20\.3 to 68"):
        vickers_of_rockwell(70.0)


def test_a_stated_line_goes_through_its_knee_and_ends_as_the_treatment_does():
    steel = material_of("mine", ELASTIC | {"contact_life": {"knee_cycles": 5e7, "exponent": 13.222}})
    contact, bending = life_curves(rated_steel(steel))
    usual = contact_life_curve(Treatment.CASE_HARDENED)
    assert steel.contact_life == LifeLine(5e7, 13.222)
    assert contact.cycles == pytest.approx(usual.cycles, rel=1e-3)
    assert contact.factors == usual.factors
    assert bending == life_curves(rated_steel(GEARS["16MnCr5"]))[1]


def test_a_line_is_inverted_where_it_is_stated():
    """N = N_k k^(−p): twice the exponent of the stress ratio."""
    assert endurable_cycles(knee_curve(1e7, 10.0, greatest=2.0), 1.25) == pytest.approx(1e7 * 1.25**-10.0, rel=1e-12)


def test_a_class_that_is_asked_for_comes_with_its_own_grade_and_hardness():
    nitrided = rated_steel(GEARS["nitriding-steel-785"])
    asked = rated_steel(GEARS["nitriding-steel-785"], "case-hardened")
    assert (nitrided.contact_strength, nitrided.hardness) == (1250e6, 650.0)
    assert (asked.contact_strength, asked.grade, asked.hardness) == (1500e6, "MQ", 700.0)


ELASTIC = {
    "elastic_modulus": 206e9, "poisson_ratio": 0.3, "density": 7830.0, "steel": "case-hardened", "hardness_hv": 700.0,
}  # fmt: skip
