"""A preliminary sizing rates against fatigue, takes teeth whose gears meet everything, and weighs gears as made."""

import math
from functools import cache

import pytest

from designs import ONE_SET, PAIR
from gearwright.errors import DesignError
from gearwright.identity import Kind
from gearwright.shipped import shipped_design
from gearwright.sizing import size, size_many
from gearwright.sizing.answers import total_results
from gearwright.sizing.mass import complete_mass
from gearwright.spec import at_level, design_text, edited, parse, read

LIFE = {"service.life_h": 20000, "service.bearing_life_h": 20000}
GEARS = (Kind.GEAR, Kind.MESH, Kind.STAGE)


@cache
def hybrid(sized=1):
    """The two planetary sets in line, for 20 000 h, with a propeller at 1150 rpm."""
    design = at_level(read(shipped_design("in-line-h2")), "preliminary")
    given = {"propellers.propeller.speed_rpm": 1150.0, "motors.electric.power_kw": 1050.0, "teeth.sized": sized}
    return size(edited(design, LIFE | given))


@cache
def pair(level):
    return size(at_level(parse(PAIR), level))


def test_gears_weigh_what_the_complete_mass_counts():
    sizing = hybrid()
    items = {item.part: item.each for item in complete_mass(sizing).parts if item.group == "gears"}
    assert {gear.name: gear.mass for gear in sizing.gears} == pytest.approx(
        {gear.name: items[gear.name] for gear in sizing.gears}, rel=1e-12
    )


def test_bearings_of_planets_are_in_its_mass():
    sizing = hybrid()
    parts = sizing.gear_mass + sizing.shaft_mass + sizing.carrier_mass
    assert sizing.planet_bearing_mass > 0.0
    assert sizing.mass == pytest.approx(parts + sizing.planet_bearing_mass, rel=1e-12)


def test_gears_with_webs_are_lighter_than_their_bored_discs():
    """Rim, a web of 0.3 of the face and a hub; nothing lies outside the pitch disc but half of the teeth."""
    sizing = pair("preliminary")
    density = sizing.design.material(sizing.design.rules("stage").material).density
    shafts = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    for gear in sizing.gears:
        bored = gear.pitch_diameter**2 - shafts[gear.shafts[0]] ** 2
        share = gear.mass / (math.pi / 4.0 * bored * gear.face_width * density)
        assert 0.3 < share < 0.8, gear.name


def test_teeth_are_taken_whose_gears_meet_their_requirements():
    sizing = hybrid()
    assert [check.name for check in sizing.checks if check.fails and check.part.kind in GEARS] == []
    assert sizing.search.sized > sizing.search.failing >= 0


def test_of_teeth_that_meet_their_requirements_the_lightest_are_taken_where_many_are_sized():
    assert hybrid(sized=6).mass <= hybrid().mass


def test_what_planets_turn_on_is_held_against_its_life():
    lives = {check.name: check.fails for check in hybrid().checks if check.mode.endswith("life")}
    assert lives == {"first.planet life": True, "second.planet life": True}


def test_a_design_at_another_level_keeps_what_it_gives():
    design = at_level(read(shipped_design("in-line-h2")), "preliminary")
    assert design.level == "preliminary"
    assert {design.rating(stage) for stage in design.stages} == {"iso6336"}
    assert parse(design_text(design)).level == "preliminary"
    plain = edited(read(shipped_design("in-line-h2")), {"planetaries.first.planet_bearing.kind": "plain"})
    assert at_level(plain, "preliminary").planetaries["first"].planet_bearing.kind == "plain"
    assert at_level(design, "concept").level == "concept"


def test_many_preliminary_sizings_are_those_of_each_alone():
    design = at_level(parse(PAIR), "preliminary")
    powers = [100.0 + k for k in range(20)]
    many = size_many(design, {"turbines.turbine.power_kw": powers})
    alone = [size(edited(design, {"turbines.turbine.power_kw": power})).mass for power in powers]
    assert many.columns["mass"].tolist() == alone


def test_many_preliminary_sets_have_the_bits_of_each_alone():
    """Propeller speeds: other teeth, sizes and bearings of planets from row to row; several are completed of each."""
    text = ONE_SET.format(speed=1900) + 'sun = "fast"\nring = "ground"\ncarrier = "slow"\nplanets = 3\n'
    design = edited(at_level(parse(text), "preliminary"), LIFE)
    many = size_many(design, {"propellers.propeller.speed_rpm": [1850.0 + 90.0 * k for k in range(3)]})
    assert not many.together.any()
    for row in range(3):
        alone = total_results(many.at(row))
        assert {name: values[row] for name, values in many.columns.items()} == {
            name: alone[name].value for name in many.columns
        }


def test_a_gear_of_two_stages_bears_what_both_ask_of_it():
    """The motor of Off-Set H2 meshes with a pinion of the second stage: one module and face for both."""
    sizing = size(edited(at_level(read(shipped_design("off-set-h2")), "preliminary"), LIFE))
    assert [check.name for check in sizing.checks if check.fails and check.part.kind in GEARS] == []
    gears = {gear.name: gear for gear in sizing.gears}
    assert gears["motor-stage.pinion"].face_width <= gears["second.pinion"].face_width


def test_modules_stay_out_of_the_resonances_of_their_meshes():
    """At 1240 rpm the least module that bears the loads of a set runs in the main resonance of its mesh."""
    text = {"propellers.propeller.speed_rpm": 1240.0, "motors.electric.power_kw": 1050.0}
    design = edited(at_level(read(shipped_design("in-line-h2")), "preliminary"), {**LIFE, **text})
    assert [check.mode for check in size(design).checks if check.fails and check.part.kind in GEARS] == []


def test_levels_that_there_are_not_and_a_method_that_does_not_fit_are_told():
    with pytest.raises(DesignError, match="'final' is not known"):
        at_level(parse(PAIR), "final")
    stated = read_text("in-line-h2").replace('level = "concept"', 'level = "preliminary"')
    with pytest.raises(DesignError) as told:
        parse(stated)
    found = {row.path: row.message for row in told.value.problems}
    assert [*found] == ["planetaries.first.gears.rating", "planetaries.second.gears.rating"]
    assert all('write rating = "iso6336"' in message for message in found.values())
    design = parse(stated.replace('rating = "lewis-hertz"', ""))
    assert size(design).mass == size(at_level(read("in-line-h2"), "preliminary")).mass


def read_text(name):
    return shipped_design(name).read_text(encoding="utf-8")


def test_planets_of_a_simple_set_have_bearings_beside_a_stepped_set_that_names_none():
    """The stepped planet has 27 + 48 = 93 - 18 teeth between sun and ring."""
    stepped = {
        "carrier": "output",
        "suns": {"sun": {"shaft": "intermediate", "teeth": 27}},
        "rings": {"ring": {"shaft": "ground", "teeth": 93}},
        "planets": {
            "large": {"teeth": 48, "meshes": ["sun"]},
            "small": {"teeth": 18, "meshes": ["ring"], "in_one_piece_with": "large"},
        },
    }
    first = {"sun": "input", "ring": "ground", "carrier": "intermediate", "planets": 3, "sun_teeth": 57}
    mixed = edited(
        read("in-line"),
        {
            "planetaries": {"first": {**first, "planet_teeth": 21}},
            "epicyclics": {"second": stepped},
            "propellers.propeller.speed_rpm": 717,
        },
    )
    sizing = size(at_level(mixed, "preliminary"))
    assert {gear.stage for gear in sizing.gears if gear.runs_on is not None} == {"first"}
