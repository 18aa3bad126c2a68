"""Gears that a design has rated by ISO 6336 and ISO 10300: sized to their safeties, checked, refused with reasons."""

import numpy as np
import pytest

from gearwright.errors import DesignError
from gearwright.parts.iso6336 import PairRating, StressBin, Treatment, contact_life_curve, spectrum_damage
from gearwright.parts.iso10300 import BevelRating
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.rating import STANDARD_MODULES, Ask, modules, rating_of
from gearwright.spec import edited, parse, read
from shipped_work import BY_HAND, text_of

HELICOPTER = parse(text_of(BY_HAND))
SIZED = size(HELICOPTER)
PAIR = """
schema = 1
name = "One pair"
level = "concept"
shafts = ["fast", "slow"]
[motors.drive]
shaft = "fast"
power_kw = 200
speed_rpm = 6000
[propellers.load]
shaft = "slow"
speed_rpm = 1800
diameter_m = 2
[pairs.only]
pinion = "fast"
wheel = "slow"
[gears]
rating = "iso6336"
material = "carburised-9310"
"""


def mesh(sizing, name):
    return next(each for each in sizing.meshes if each.name == name)


def test_every_rated_gear_has_its_safeties_and_no_more_than_a_millimetre_of_width_to_spare():
    """The face width is the least in whole millimetres: one less, and a safety is missed, be it against scuffing."""
    rules = HELICOPTER.gears.iso6336
    for each in SIZED.meshes:
        assert min(each.rating.pitting) >= rules.pitting_safety
        assert min(each.rating.bending) >= rules.bending_safety
    gear = next(gear for gear in SIZED.gears if gear.name == "helical.pinion")
    sizes = {"module_mm": 1e3 * gear.module, "face_width_mm": 1e3 * gear.face_width - 1.0}
    narrower = size(edited(HELICOPTER, {f"overrides.helical.{key}": value for key, value in sizes.items()}))
    assert [check.name for check in narrower.checks if check.fails and check.part.name == "helical"]


def test_modules_are_those_of_iso_54_for_the_normal_module_and_the_outer_one_of_bevel_gears():
    helical, bevel = mesh(SIZED, "helical").rating.factors, mesh(SIZED, "bevel").rating.factors
    normal = next(gear.module for gear in SIZED.gears if gear.name == "helical.pinion")
    assert isinstance(helical, PairRating)
    assert isinstance(bevel, BevelRating)
    assert min(abs(1e3 * normal - each) for each in STANDARD_MODULES) < 1e-9
    assert min(abs(1e3 * bevel.virtual.bevel.outer_module - each) for each in STANDARD_MODULES) < 1e-9


def test_the_module_that_a_mesh_asks_for_just_meets_the_safety():
    """Rated with the module that contact asks for, S_H is the asked one to 1e-3; more loads in one call agree."""
    rating = rating_of(HELICOPTER, "helical")
    one = Ask(13.0, (27, 107), 18.0, speed=628.3)
    bending, contact = modules(one, rating)
    many = modules(
        one._replace(per_tooth=np.array([13.0, 26.0]), teeth=(np.array([27, 27]), np.array([107, 107]))), rating
    )
    assert float(many[0][0]) == pytest.approx(float(bending), rel=1e-12)
    assert float(many[1][0]) == pytest.approx(float(contact), rel=1e-12)
    assert many[1][1] > many[1][0]
    sized = size(
        edited(
            HELICOPTER,
            {
                "pairs.helical.pinion_teeth": 27,
                "pairs.helical.wheel_teeth": 130,
                "gears.iso6336.standard_modules": False,
            },
        )
    )
    found = mesh(sized, "helical").rating
    assert min(min(found.pitting) / 1.2, min(found.bending) / 1.6) == pytest.approx(1.0, abs=2e-2)


def test_a_load_spectrum_is_summed_by_miner():
    """Half of the life at 60 % of the power: the safety is what ISO 6336-6 makes of the two stresses."""
    cases = "[service]\nlife_h = 1000\n"
    low = "[cases.low]\nshare = 0.5\ndrive.power_kw = 120\n[cases.rated]\nshare = 0.5\ndrive.rating = 1\n"
    whole = size(parse(PAIR + cases))
    teeth = {f"pairs.only.{gear}_teeth": whole.teeth[f"only.{gear}"] for gear in ("pinion", "wheel")}
    alone = size(edited(parse(PAIR + cases + "[overrides]\n" + fixed(whole)), teeth))
    shared = size(edited(parse(PAIR + cases + low + "[overrides]\n" + fixed(whole)), teeth))
    assert mesh(shared, "only").rating.made == mesh(alone, "only").rating.made
    assert mesh(shared, "only").rating.pitting[0] > mesh(alone, "only").rating.pitting[0]
    factors = mesh(alone, "only").rating.factors
    half = size(edited(alone.design, {"service.life_h": 500}))
    stress, endurance = factors.pitting.stresses[0], factors.pitting.permissible[0] / factors.contact_strength[0].life
    curve = contact_life_curve(Treatment.CASE_HARDENED)
    only_half = spectrum_damage(
        [StressBin(float(stress / endurance), float(factors.cycles[0]) / 2.0)], 1.0, curve
    ).safety
    assert mesh(half, "only").rating.pitting[0] == pytest.approx(only_half, rel=1e-6)
    assert mesh(shared, "only").rating.pitting[0] <= mesh(half, "only").rating.pitting[0] * (1.0 + 1e-9)


def fixed(sizing):
    gear = next(gear for gear in sizing.gears if gear.name == "only.pinion")
    return f'"only.module_mm" = {1e3 * gear.module}\n"only.face_width_mm" = {1e3 * gear.face_width}\n'


def test_planets_alone_are_idlers():
    """Y_M of a planet is 0.7, of sun and ring 1 (ISO 6336-3, annex B)."""
    design = edited(read(shipped_design("single-planetary")), {"gears.rating": "iso6336"})
    sized = size(design)
    for each in sized.meshes:
        means = [strength.mean_stress for strength in each.rating.factors.root_strength]
        assert means == [0.7 if name.endswith(".planet") else 1.0 for name in each.gears]
        assert min(each.rating.bending) >= 1.6 * (1 - 1e-9)


def test_the_reports_gears_fail_where_the_report_does_not_look():
    """The bevel face beyond the cone is rated at R_e/3; undercut, width and strength are checks, not refusals."""
    found = {each.name: each.margin for each in size(read(shipped_design("ec120b-as-reported"))).checks}
    assert found["bevel.pinion tooth root"] < 0.2
    assert found["bevel.pinion face width"] == pytest.approx(30.83 / 150.8, rel=1e-3)
    assert found["helical.pinion undercut"] < 1.0
    assert found["helical.pinion pitting"] < 1.0


@pytest.mark.parametrize(
    ("edits", "words"),
    [
        ({"gears.iso6336.steel": "case-hardend"}, r"gears\.iso6336\.steel: .*did you mean case-hardened"),
        ({"gears.iso6336.hardness_hv": 300.0}, "300"),
        ({"gears.rating": "lewis-hertz"}, "ISO 10300"),
        ({"pairs.bevel.axis_angle_deg": 80.0}, "only square axes"),
        ({"pairs.bevel.internal": True}, "neither internal"),
        ({"pairs.bevel.pinion_teeth": 7, "pairs.bevel.wheel_teeth": 21, "teeth.speed_tolerance": 0.05}, "undercut"),
    ],
)
def test_what_cannot_be_rated_is_refused_with_what_would_do(edits, words):
    with pytest.raises(DesignError, match=words):
        size(edited(HELICOPTER, edits))
