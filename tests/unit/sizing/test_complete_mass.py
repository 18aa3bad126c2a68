"""The complete mass: sums, hand calculations, limits and how it scales."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import gearwright as gw
from gearwright.catalogue import housing_materials, mass_classes
from gearwright.identity import Kind, PartId
from gearwright.particulars import particulars
from gearwright.parts.gears import BasicRack, Blank, TransverseTooth, blank_volume, outline_area
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.schema import plain
from gearwright.render.tables.sizing import mass_sentence, with_band
from gearwright.render.tables.weights import summary
from gearwright.shipped import shipped_designs
from gearwright.sizing.casing import housed, shell_of
from gearwright.sizing.gear_geometry import ring_radii
from gearwright.sizing.housing_shell import section_across, shell_around
from gearwright.sizing.inner_walls import inner_walls
from gearwright.sizing.mass import (
    TRAIN,
    complete_mass,
    gear_blanks,
    held_torques,
    reaction_torque,
    statistics_beside,
    wall_of,
    weighed_flanges,
    weighed_wall,
)
from gearwright.sizing.result import Body, Direction, Point, Station
from gearwright.spec import edited, parse
from mounted_designs import SPLIT_PATH

STEEL = 7850.0


@cache
def sized(name, changes=()):
    return gw.size(edited(gw.read(name), dict(changes)))


def item(mass, part, group="gears"):
    return next(item for item in mass.parts if item.part == part and item.group == group)


@pytest.mark.parametrize("name", ["in-line-h2", "off-set", "geared-turbofan-star", "face-gear-split-torque"])
def test_the_sum_of_the_parts_is_the_whole(name):
    mass = complete_mass(sized(name))
    assert mass.total == pytest.approx(sum(part.count * part.each for part in mass.parts), rel=1e-12)
    assert mass.total == pytest.approx(sum(group.total for group in mass.groups), rel=1e-12)
    assert sum(group.share for group in mass.groups) == pytest.approx(1.0, rel=1e-12)
    assert all(part.each > 0.0 and part.formula and part.source and 0.0 < part.uncertainty < 1.0 for part in mass.parts)
    assert mass.band[0] < mass.total < mass.band[1]


def test_a_tooth_space_is_as_large_as_a_tooth_near_the_pitch_circle():
    """Of many teeth, the area of the teeth between circles m/4 apart about the pitch circle is half the annulus."""
    tooth = TransverseTooth(400, 1e-3, tip_alteration=-0.75, rack=BasicRack(dedendum=0.25, fillet_radius=1e-6))
    annulus = math.pi * (tooth.tip_radius**2 - tooth.root_radius**2)
    assert 400 * outline_area(tooth) == pytest.approx(annulus / 2.0, rel=2e-3)  # flanks bend by 1/z


@pytest.mark.parametrize(("side", "near"), [(1, 1e-3), (-1, 5e-3)])  # a shaper of 40 teeth rounds roots more
def test_teeth_of_a_rack_have_the_area_of_trapezia_and_of_their_roundings(side, near):
    """Of very many teeth each is (s + (c − a) tan α) high h, s = π m/2, and ρ² (tan ½θ − ½θ) a root, θ = 90° − α."""
    module, corner = 1e-3, math.radians(35.0)
    tooth = TransverseTooth(4_000, module, side=side, shaper=40.0)
    width = math.pi / 2.0 * module + 2.0 * math.tan(math.radians(20.0)) * (1.25 - 2.25 / 2.0) * module
    roots = 2.0 * (0.38 * module) ** 2 * (math.tan(corner) - corner)
    assert outline_area(tooth) == pytest.approx(width * 2.25 * module + roots, rel=near)


def test_a_blank_by_hand():
    """Rim 100/80, web 6 mm, hub 30/20, width 20 mm: π (3600·20 + 5500·6 + 500·20) mm³."""
    blank = Blank(0.100, 0.080, 0.030, 0.020, 0.020, 0.006)
    assert blank_volume(blank) == pytest.approx(math.pi * (3600 * 20 + 5500 * 6 + 500 * 20) * 1e-9, rel=1e-12)


def test_holes_in_a_web_by_hand():
    """Six of 30 mm, 0.6 of the 50 mm between rim and hub, on 55 mm; twelve are narrower, 0.6 of 110 mm sin 15°."""
    blank = Blank(0.100, 0.080, 0.030, 0.020, 0.020, 0.006)
    six, twelve = blank._replace(holes=6), blank._replace(holes=12)
    assert (six.hole_radius, six.hole_circle) == (pytest.approx(15e-3), pytest.approx(55e-3))
    assert blank_volume(blank) - blank_volume(six) == pytest.approx(6 * math.pi * 15e-3**2 * 6e-3, rel=1e-12)
    assert twelve.hole_radius == pytest.approx(0.3 * 110e-3 * math.sin(math.radians(15.0)))
    assert blank._replace(rim_radius=0.03, holes=6).hole_radius == 0.0


def test_a_wheel_with_holes_weighs_less_and_keeps_a_share_that_is_given():
    plain, bored = (sized("off-set", (("gears.web_holes", count),)) for count in (0, 6))
    blank = gear_blanks(bored)["second.wheel"]
    taken = STEEL * 6 * math.pi * blank.hole_radius**2 * blank.web_width
    lighter = item(complete_mass(plain), "second.wheel").each - item(complete_mass(bored), "second.wheel").each
    assert lighter == pytest.approx(taken) and taken > 1.0
    assert gear_blanks(bored)["second.pinion"].holes == 0
    shared = [sized("off-set", (("gears.web_ratio", 0.6), ("gears.web_holes", count))) for count in (0, 6)]
    assert len({round(item(complete_mass(each), "second.wheel").each, 9) for each in shared}) == 1
    webs = [gear_blanks(each)["second.wheel"].web_width for each in shared]
    assert webs[1] > webs[0]


def test_a_rim_that_reaches_the_hub_leaves_a_solid_disc():
    blank = Blank(0.100, 0.030, 0.030, 0.020, 0.020, 0.006)
    assert blank_volume(blank) == pytest.approx(math.pi * (0.1**2 - 0.02**2) * 0.02, rel=1e-12)
    thick = sized("off-set", (("gears.web_thickness_ratio", 1.0),))
    wheel = next(gear for gear in thick.gears if gear.name == "second.wheel")
    bore = next(shaft.diameter for shaft in thick.shafts if shaft.name == "output")
    solid = wheel.mass - STEEL * math.pi / 4.0 * bore**2 * wheel.face_width
    assert item(complete_mass(thick), "second.wheel").each == pytest.approx(solid, rel=0.01)  # teeth: d is their middle


def test_a_wheel_by_hand():
    """Off-set's second wheel: teeth, rim 1.2 · 2.25 m_n, web 0.3 b, hub 1.25 d around the shaft."""
    sizing = sized("off-set")
    wheel = next(gear for gear in sizing.gears if gear.name == "second.wheel")
    shaft = next(shaft for shaft in sizing.shafts if shaft.name == "output").diameter / 2.0
    module, width = wheel.module, wheel.face_width
    root = wheel.pitch_diameter / 2.0 - 1.25 * module
    rim, hub = root - 1.2 * 2.25 * module, 1.25 * shaft
    teeth = wheel.teeth * outline_area(TransverseTooth(wheel.teeth, module, wheel.helix_angle))
    body = (root**2 - rim**2 + hub**2 - shaft**2) + 0.3 * (rim**2 - hub**2)
    by_hand = STEEL * width * (teeth + math.pi * body)
    assert item(complete_mass(sizing), "second.wheel").each == pytest.approx(by_hand, rel=1e-9)
    middle = math.pi * ((root + 2.25 * module) ** 2 - root**2)
    assert 0.5 < teeth / middle < 0.56  # of a rack 0.536: 1.25 m below the pitch line, 1 m above it, and roots


def test_a_stated_web_ratio_is_that_of_the_whole_body():
    part = item(complete_mass(sized("off-set", (("gears.web_ratio", 0.45),))), "second.wheel")
    sizing = sized("off-set")
    wheel = next(gear for gear in sizing.gears if gear.name == "second.wheel")
    bore = next(shaft.diameter for shaft in sizing.shafts if shaft.name == "output") / 2.0
    root = wheel.pitch_diameter / 2.0 - 1.25 * wheel.module
    teeth = wheel.teeth * outline_area(TransverseTooth(wheel.teeth, wheel.module, wheel.helix_angle))
    by_hand = STEEL * wheel.face_width * (teeth + 0.45 * math.pi * (root**2 - bore**2))
    assert part.each == pytest.approx(by_hand, rel=1e-9)


def cylinder(start, length, radius):
    from gearwright.identity import Kind, PartId

    stations = (Station(0.0, radius / 1.06), Station(length, radius / 1.06))
    return Body(PartId(Kind.GEAR, "a"), "a", "", Point(start, 0.0, 0.0), (1.0, 0.0, 0.0), stations)


def test_the_shell_around_a_cylinder():
    shell = shell_around([cylinder(0.0, 0.5, 0.2)])
    assert shell.lateral == pytest.approx(2.0 * math.pi * 0.2 * 0.5, rel=2e-3)  # a polygon of 48 sides
    assert shell.ends == pytest.approx(2.0 * math.pi * 0.2**2, rel=2e-3)
    assert shell.volume == pytest.approx(math.pi * 0.2**2 * 0.5, rel=2e-3)


def test_the_shell_does_not_follow_a_neck_but_follows_a_nose():
    wide = [cylinder(0.0, 0.1, 0.2), cylinder(0.2, 0.1, 0.2)]
    necked = shell_around([*wide, cylinder(0.1, 0.1, 0.05)])
    assert necked.lateral == pytest.approx(2.0 * math.pi * 0.2 * 0.3, rel=2e-3)
    nosed = shell_around([wide[0], cylinder(0.1, 0.1, 0.05)])
    assert nosed.lateral == pytest.approx(2.0 * math.pi * (0.2 + 0.05) * 0.1, rel=2e-3)
    assert nosed.ends == pytest.approx(2.0 * math.pi * 0.2**2, rel=2e-3)


def scaled(factor):
    """Off-set with lengths `factor` times as large at the same stresses: torques as the cube, speeds as they are."""
    design = gw.read("off-set")
    lengths = {"shafting.bearing_length_mm": 15.0 * factor, "shafting.end_length_mm": 100.0 * factor}
    power = {"turbines.gas-turbine.power_kw": 2051.0 * factor**3}
    return gw.size(edited(design, lengths | power))


def test_twice_the_lengths_weigh_eight_times_but_for_walls_which_castings_have_thinner():
    """Area four times, L twice: the shell grows as 4 (t_0 + 2 κ L)/(t_0 + κ L) where nothing limits."""
    one, two = scaled(1.5), scaled(3.0)
    small, large = complete_mass(one), complete_mass(two)
    for group in ("gears", "shafts"):
        assert large.of(group) / small.of(group) == pytest.approx(8.0, rel=1e-3)
    assert large.of("bearings") / small.of("bearings") == pytest.approx(8.0, rel=0.01)
    rule = housing_materials()["aluminium"].casting
    length = math.sqrt(shell_of(one).area / 4.0)
    more = 4.0 * (rule.base + 2.0 * rule.slope * length) / (rule.base + rule.slope * length)
    shells = [item(mass, "housing shell", "housing").total for mass in (small, large)]
    assert shells[1] / shells[0] == pytest.approx(more, rel=0.01) and 4.0 < more < 8.0
    assert {weighed_wall(one).why, weighed_wall(two).why} == {"casting"}


def test_the_section_across_a_cylinder_is_a_circle_or_its_length_times_its_width():
    length, radius = 0.3, 0.1
    circles = (Station(0.0, radius), Station(length, radius))
    body = Body(PartId(Kind.GEAR, "g"), "s", "", Point(0.1, 0.2, 0.3), Direction(1.0, 0.0, 0.0), circles)
    assert section_across([body], Direction(1.0, 0.0, 0.0)) == pytest.approx(math.pi * (1.06 * radius) ** 2, rel=2e-3)
    for way in (Direction(0.0, 1.0, 0.0), Direction(0.0, 0.0, -1.0)):
        assert section_across([body], way) == pytest.approx(length * 2.0 * 1.06 * radius, rel=2e-3)


def test_walls_are_by_each_torque_in_the_section_across_its_own_axis():
    """The mast of EC120B stands square to all other shafts; the rotor's torque is held across it.

    Castings of that size are thicker than torque asks; fifty times the torque asks for more.
    """
    sizing = gw.size(gw.read("ec120b"))
    (along, small), (up, large) = held_torques(sizing)
    assert (abs(along.x), abs(up.z)) == (pytest.approx(1.0), pytest.approx(1.0))
    assert large == abs(sizing.reference.machine_torques["main-rotor"]) > 10.0 * small
    material = housing_materials()["aluminium"]
    asked = large / (2.0 * section_across(housed(sizing), up) * material.shear_strength)
    cast = material.casting.base + material.casting.slope * math.sqrt(shell_of(sizing).area / 4.0)
    assert asked < cast and weighed_wall(sizing) == (pytest.approx(cast), "casting")
    one = gw.size(gw.read("off-set"))
    (only,) = held_torques(one)
    assert only[1] == reaction_torque(one), "parallel axes"
    narrow = shell_of(one)._replace(section=1e-3)
    assert wall_of(one, narrow) == (pytest.approx(only[1] / (2e-3 * material.shear_strength)), "its torque")


@pytest.mark.parametrize("name", ["in-line", "off-set", "twin-engine-helicopter"])
def test_more_torque_never_makes_a_wall_thinner(name):
    sizing = gw.size(gw.read(name))
    shell, flow = shell_of(sizing), sizing.reference
    walls = []
    for factor in (0.1, 1.0, 3.0, 10.0, 30.0, 100.0):
        torques = {machine: factor * torque for machine, torque in flow.machine_torques.items()}
        first, *others = sizing.flows
        flows = {first: replace(flow, machine_torques=torques)} | {case: sizing.flows[case] for case in others}
        walls.append(wall_of(replace(sizing, flows=flows), shell).thickness)
    assert walls == sorted(walls) and walls[-1] > walls[0]


def test_stages_behind_each_other_have_one_wall_between_them_and_a_stage_alone_none():
    sizing = sized("in-line")
    wall = weighed_wall(sizing).thickness
    (only,) = inner_walls(sizing, wall)
    assert only.span[1] - only.span[0] == pytest.approx(wall)
    first, second = (next(body for body in sizing.arrangement.bodies if str(body.part) == f"{stage}.ring")
                     for stage in ("first", "second"))  # fmt: skip
    assert first.origin.x + first.length < only.span[0] < only.span[1] < second.origin.x
    radius = max(abs(point) for point in np.ravel(only.outer))
    hole = 1.6 * max(body.radius for body in sizing.arrangement.bodies if str(body.part) == "intermediate")
    disc = math.pi * (radius**2 - hole**2) * wall
    assert only.volume == pytest.approx(disc, rel=0.01)
    weighed = item(complete_mass(sizing), "housing inner walls", "housing")
    assert weighed.total == pytest.approx(only.volume * housing_materials()["aluminium"].density)
    assert only.fits and not inner_walls(sized("in-line"), 0.05)[0].fits, "a wall thicker than the gap is not drawn"
    assert not inner_walls(sized("single-planetary"), wall)
    assert not inner_walls(sized("ec120b"), wall), "webs carry its bosses"


def test_a_bolted_ring_is_wall_itself():
    """Its shell goes, but for a tenth of its width on either side; two flanges come; no land, no splines, no keeper."""
    splined, bolted = sized("in-line"), sized("in-line", (("housing.rings", "bolted"),))
    before, after = shell_of(splined), shell_of(bolted)
    rings = [gear for gear in bolted.gears if gear.rim]
    around = sum(2.0 * math.pi * 1.06 * ring_radii(bolted.design, ring)[1] * 0.8 * ring.face_width for ring in rings)
    assert after.rings == pytest.approx(around, rel=5e-3)
    assert after.area + after.rings == pytest.approx(before.area) == after.outside
    assert weighed_flanges(bolted).number == weighed_flanges(splined).number + 4
    names = {part.part for part in complete_mass(bolted).parts}
    assert not [name for name in names if "splines" in name or "keeper" in name or "lands" in name]
    assert weighed_wall(bolted).thickness == pytest.approx(weighed_wall(splined).thickness)


def test_torque_arms_are_weighed_where_the_design_asks_for_them_alone():
    """6 T ρ/σ and 0.35 kg/(kN m), the whole torque of the rotor held: 4.5 MN m of the reference turbine's nominal."""
    sizing = sized("wind-turbine-5mw")
    mass, torque = complete_mass(sizing), reaction_torque(sizing)
    iron = housing_materials()["cast-iron"]
    arms, disc = item(mass, "torque arms", "reaction").total, item(mass, "shrink disc", "reaction").total
    assert arms == pytest.approx(6.0 * torque * iron.density / iron.bending_strength)
    assert disc == pytest.approx(0.35e-3 * torque)
    assert mass.of("reaction") == pytest.approx(arms + disc)
    lugs = complete_mass(sized("wind-turbine-5mw", (("housing.reaction", "lugs"),)))
    assert lugs.of("reaction") == 0.0 and lugs.of("housing") == pytest.approx(mass.of("housing"))


def test_the_factor_of_a_class_is_told_and_is_in_no_sum():
    wind, aircraft = mass_classes()["wind"], mass_classes()["aircraft"]
    assert (aircraft.factor, aircraft.gearboxes) == (1.0, 0)
    sizing = sized("wind-turbine-5mw")
    mass = complete_mass(sizing)
    assert mass.scatter == wind.scatter and complete_mass(sized("in-line")).scatter == aircraft.scatter
    assert mass.total == pytest.approx(sum(part.total for part in mass.parts))
    said = statistics_beside(sizing, mass).sentence
    assert f"weigh {wind.factor:.2f} times their sums of parts" in said and "not in this sum" in said
    assert "times their sums" not in statistics_beside(sized("in-line"), complete_mass(sized("in-line"))).sentence


@pytest.mark.parametrize("name", ["in-line", "off-set"])
def test_more_power_weighs_more(name):
    design = gw.read(name)
    power = design.turbines["gas-turbine"].power / 1e3
    masses = [
        complete_mass(gw.size(edited(design, {"turbines.gas-turbine.power_kw": factor * power}))).total
        for factor in (0.5, 0.8, 1.0, 1.5, 3.0)
    ]
    assert masses == sorted(masses)


def test_a_given_housing_and_a_given_whole_stand_as_given():
    given = complete_mass(sized("off-set", (("housing.mass_kg", 31.0),)))
    assert given.of("housing") == 31.0
    whole = complete_mass(sized("off-set", (("gearbox.mass_kg", 190.0),)))
    assert whole.total == 190.0 and len(whole.parts) == 1


def test_magnesium_is_lighter_than_iron_and_no_housing_than_any():
    masses = {
        material: complete_mass(sized("off-set", (("housing.material", material),))).of("housing")
        for material in ("magnesium", "cast-iron")
    }
    assert masses["magnesium"] < masses["cast-iron"]
    assert complete_mass(sized("off-set", (("housing.own", False),))).of("housing") == 0.0


def test_bearings_of_built_shafts_are_the_catalogue_s():
    sizing = sized("single-planetary")
    built = list(sizing.bearings)
    parts = [item for item in complete_mass(sizing).parts if item.source == "catalogue of bearings"]
    assert {part.part for part in parts} >= {bearing.name for bearing in built}


@pytest.mark.parametrize("name", [*shipped_designs(), "split path"])
def test_a_complete_gearbox_weighs_no_less_than_its_train_as_the_headline_and_the_review_tell_both(name):
    """Gears, shafts and carriers are weighed as manufactured in both; solid wheels are told as what is sized."""
    sizing = gw.size(parse(SPLIT_PATH)) if name == "split path" else sized(name)
    whole = complete_mass(sizing)
    assert whole.total > whole.train > 0.0
    assert whole.train == pytest.approx(sum(whole.of(group) for group in TRAIN), rel=1e-12)
    total, *_, train = map(float, re.findall(r"([\d.]+) kg", with_band(whole)))
    assert total >= train == pytest.approx(whole.train, rel=5e-3)
    assert mass_sentence(whole, statistics_beside(sizing, whole)).startswith(f"Sum {with_band(whole)}; ")
    if sizing.level != "concept":
        assert summary(particulars(sizing)).startswith(f"Complete mass {with_band(whole)}. Train as sized ")
    answer = plain(size_answer(particulars(sizing)))
    assert answer["complete_total_kg"] > answer["complete_train_kg"] == answer["complete_mass"]["train_kg"]
