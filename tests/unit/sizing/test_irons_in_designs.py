"""Cast irons in designs: hardness in the scale of the class, no steel in place of an iron, what is left open."""

import pytest

from designs import PAIR
from gearwright.catalogue import materials, rated_steel
from gearwright.errors import DesignError
from gearwright.reviews import review
from gearwright.sizing import size
from gearwright.sizing.rating import METHODS, rating_of
from gearwright.spec import parse

IRON = """
[materials.iron]
elastic_modulus_gpa = 174
poisson_ratio = 0.275
density_kg_m3 = 7200
yield_strength_mpa = 370
hardness_hb = 230
steel = "nodular-iron"
source = "for this test"
"""
WHEEL = '[gears.iso6336.wheel]\nsteel = "nodular-iron"\nhardness_hv = 250\n'


def pair(rules: str = "", more: str = "", gears: str = "") -> str:
    head = f'{PAIR}pinion_teeth = 24\nwheel_teeth = 71\n[gears]\nrating = "iso6336"\n{gears}'
    return f"{head}[gears.iso6336]\n{rules}\n{more}"


def told(text: str) -> list[tuple[str, str]]:
    with pytest.raises(DesignError) as refused:
        parse(text)
    return [(problem.path, problem.message) for problem in refused.value.problems]


def test_a_class_that_is_never_as_hard_as_the_usual_asks_for_its_hardness():
    """The usual 700 HV of hard classes is none that anybody gave."""
    ((path, message),) = told(pair('steel = "grey-iron"'))
    assert path.endswith("gears.iso6336.hardness_hv")
    assert "is required: grey-iron MQ has 150 to 240 HBW" in message
    assert rated_steel(materials()["C45"], "case-hardened").hardness == 700.0


def test_hardnesses_are_told_in_the_scale_of_their_class():
    ((_, message),) = told(pair('steel = "grey-iron"\nhardness_hv = 250'))
    assert message == "250 HBW given; ISO 6336-5 covers 150 to 240 HBW for this class and grade; nearest is 240"
    ((_, message),) = told(pair('steel = "nitrided"\nhardness_hv = 600'))
    assert "600 HV given; ISO 6336-5 covers 650 to 900 HV" in message


def test_both_steels_of_a_pair_are_told_at_once():
    wheel = '[gears.iso6336.wheel]\nsteel = "grey-iron"\nhardness_hv = 100\n'
    paths = [path for path, _ in told(pair('steel = "nodular-iron"\nhardness_hv = 900', wheel))]
    assert [path.partition("gears.")[2] for path in paths] == ["iso6336.hardness_hv", "iso6336.wheel.hardness_hv"]


@pytest.mark.parametrize(
    ("rules", "wheel", "key"),
    [
        ('steel = "case-hardened"', "", "steel"),
        ("", '[gears.iso6336.wheel]\nsteel = "nitrided"\nhardness_hv = 700\n', "wheel.steel"),
    ],
)
def test_no_cast_iron_is_hardened_to_a_class_of_steel(rules, wheel, key):
    """E of the iron would stand under the strength of a hard case: S_H would be too large."""
    ((path, message),) = told(pair(rules, wheel + IRON, gears='material = "iron"\n'))
    assert path.endswith(f"gears.iso6336.{key}")
    assert "'iron' is nodular-iron" in message


def test_the_proof_stress_of_a_steel_is_none_of_an_iron_wheel():
    ((path, _),) = told(pair("", WHEEL))
    assert path.endswith("gears.iso6336.wheel.yield_strength_mpa")
    sizing = size(parse(pair("", WHEEL + "yield_strength_mpa = 370\n")))
    rated = sizing.meshes[0].rating
    assert rated.mate_steel.yield_strength == 370e6
    grey = '[gears.iso6336.wheel]\nsteel = "grey-iron"\nhardness_hv = 200\n'
    assert size(parse(pair("", grey))).meshes[0].rating.mate_steel.yield_strength is None
    making = METHODS["iso6336"].making(rating_of(sizing.design, sizing.meshes[0].stage, sizing.teeth))
    assert "wheels and rings nodular-iron MQ, 250 HBW" in making.steel[1]


def test_what_is_no_number_is_told_once():
    assert [message for _, message in told(pair("hardness_hv = nan"))] == ["nan is not allowed; give a finite number"]


def test_a_review_says_which_meshes_have_no_film_against_micropitting():
    design = parse(pair("micropitting_stage = 10", WHEEL + "yield_strength_mpa = 370\n"))
    (check,) = [check for check in review(design).open if check.mode == "micropitting"]
    assert check.why == "the document has no W_W of cast irons"
    steel = review(parse(pair("micropitting_stage = 10")))
    assert [check for check in steel.open if check.mode == "micropitting"] == []
