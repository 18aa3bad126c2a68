"""Bearings inside planets: compound sets as simple ones, stepped planets by statics, room, lives, what is refused."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from designs import ONE_SET, problem
from gearwright.catalogue import bearing
from gearwright.errors import DesignError
from gearwright.mission import bearing_lives, fly
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.bearing_seats import bearing_seats, seat_forces
from gearwright.sizing.gear_geometry import pins_of
from gearwright.sizing.loads import mesh_place
from gearwright.spec import edited, parse, parse_mission, read

SIMPLE = (
    ONE_SET.format(speed=1500)
    + """\
sun = "fast"
ring = "{}"
carrier = "{}"
planets = 3
sun_teeth = 30
planet_teeth = 30
module_mm = 3
face_width_mm = 40
pin_diameter_mm = 20
[gears]
mesh_load_factor = 1.3
"""
)
COMPOUND = (
    ONE_SET.format(speed=1500).replace("[planetaries.set]", "[epicyclics.set]")
    + """\
carrier = "{}"
sets = 3
pin_diameter_mm = 20
suns.sun = {{ shaft = "fast", teeth = 30, module_mm = 3, face_width_mm = 40 }}
rings.ring = {{ shaft = "{}", teeth = 90, module_mm = 3, face_width_mm = 40 }}
{}
[gears]
mesh_load_factor = 1.3
"""
)
ONE_PIECE = 'planets.planet = { teeth = 30, meshes = ["sun", "ring"] }'
EQUAL_STEPS = """\
planets.planet = { teeth = 30, meshes = ["sun"] }
planets.other = { teeth = 30, meshes = ["ring"], in_one_piece_with = "planet" }
"""
KINDS = ("slow", "ground"), ("ground", "slow")
"""Ring and carrier of a star set, and of a planetary one."""
STEPPED = shipped_design("wolfrom-reducer").read_text(encoding="utf-8")


def forces(sizing, speed=0.0):
    """Return seat -> its force in the rated case, with carriers at a speed [N]."""
    flow = sizing.reference
    torques = np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])
    return {seat.name: float(seat_forces(seat, torques, np.array(speed))[0]) for seat in bearing_seats(sizing)}


@pytest.mark.parametrize(("ring", "carrier"), KINDS)
def test_a_compound_set_of_one_planet_has_the_seats_of_a_simple_set(ring, carrier):
    """One train in two words: force, centrifugal force, room, bore and count are the same to the last digits."""
    speed = f"= {1500 if ring == 'ground' else 2000}"
    texts = SIMPLE.format(ring, carrier), COMPOUND.format(carrier, ring, ONE_PIECE)
    simple, compound = (size(parse(text.replace("= 1500", speed))) for text in texts)
    for swing in (0.0, 157.0):
        assert forces(compound, swing) == pytest.approx(forces(simple, swing), rel=1e-13)
    (one,), (other,) = (bearing_seats(sizing) for sizing in (simple, compound))
    assert (one.count, one.nodes, one.name) == (other.count, other.nodes, other.name)
    assert (one.bore, one.room, one.swung) == pytest.approx((other.bore, other.room, other.swung), rel=1e-13)


def test_equal_steps_of_a_planet_bear_what_one_planet_does():
    """The sun pushes one step and the ring the other: by symmetry the same force on the pin; twice the mass swings."""
    whole, stepped = (size(parse(COMPOUND.format("slow", "ground", planets))) for planets in (ONE_PIECE, EQUAL_STEPS))
    assert forces(stepped) == pytest.approx(forces(whole), rel=1e-13)
    (one,), (two,) = (bearing_seats(sizing) for sizing in (whole, stepped))
    assert two.swung == pytest.approx(2.0 * one.swung, rel=1e-13)
    assert two.room == pytest.approx(one.room, rel=1e-13)


def fitted(wide="", narrow="", text=STEPPED):
    """Return the stepped planets of the Wolfrom reducer with keys of both steps."""
    text = text.replace('meshes = ["sun", "held"]', f'meshes = ["sun", "held"]\n{wide}')
    return text.replace('in_one_piece_with = "wide"', f'in_one_piece_with = "wide"\n{narrow}')


def by_hand(sizing, places):
    """Return the force on a pin, and its moment about the plate, of its meshes and its mass, y + i z outwards first.

    Every mesh: F_t = T/r around, F_t tan 25° off the mate; the sun's side is the inner one.
    """
    gears, flow = {gear.own: gear for gear in sizing.gears}, sizing.reference
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes}
    radius = abs(pins_of(sizing.design.epicyclics["wolfrom"], gears, centres)["wide"])
    force = moment = 0j
    for mesh in sizing.train.meshes:
        central, planet = (gears[name.split(".")[1]] for name in mesh.gears)
        if planet.own not in ("wide", "narrow"):
            central, planet = planet, central
        # the torque on the carrier is that of a force at the pin, so that a mesh puts T_c/(N r_c) on it
        around = flow.meshes[mesh.name].torques[2] / 3 * 1.2 / radius
        outwards = (1.0 if central.own == "sun" else -1.0) * abs(around) * math.tan(math.radians(25.0))
        force += outwards + 1j * around
        moment += (outwards + 1j * around) * places[planet.own]
    for own, place in places.items():
        swung = gears[own].turning_mass * radius * flow.speeds["cage"] ** 2
        force, moment = force + swung, moment + swung * place
    return force, moment


@pytest.mark.parametrize("places", [{"wide": 0.02, "narrow": 0.05}, {"wide": 0.06, "narrow": 0.02}])
def test_two_bearings_of_a_stepped_planet_bear_by_statics_with_the_moment_that_tilts_it(places):
    """R_1 = (M − F x_2)/(x_1 − x_2), in both directions; one pair in one step, spread by its spacing. By hand."""
    keys = [f"place_mm = {1e3 * places[step]}" for step in places]
    text = fitted(f'{keys[0]}\nbearing = {{ designation = "NU 202", side_by_side = 2, spacing_mm = 16 }}', keys[1])
    sizing = size(edited(parse(text), {"gears.mesh_efficiency": 1.0}))
    force, moment = by_hand(sizing, places)
    first, second = places["wide"] - 0.008, places["wide"] + 0.008
    expected = {
        "wolfrom.wide-1": abs((moment - force * second) / (first - second)),
        "wolfrom.wide-2": abs((moment - force * first) / (second - first)),
    }
    found = forces(sizing, sizing.reference.speeds["cage"])
    assert found == pytest.approx(expected, rel=1e-9)
    assert max(expected.values()) > abs(force)  # the two rings push in opposite planes


def test_a_bearing_in_each_step_bears_the_meshes_of_its_step():
    """Forces in the planes of the bearings: none of a step's force reaches the bearing of the other. By hand."""
    places = {"wide": 0.02, "narrow": 0.05}
    keys = [f'place_mm = {1e3 * place}\nbearing = {{ designation = "NU 202" }}' for place in places.values()]
    sizing = size(edited(parse(fitted(*keys)), {"gears.mesh_efficiency": 1.0}))
    found = forces(sizing, sizing.reference.speeds["cage"])
    force, moment = by_hand(sizing, places)
    narrow = (moment - force * places["wide"]) / (places["narrow"] - places["wide"])
    assert found == pytest.approx({"wolfrom.wide": abs(force - narrow), "wolfrom.narrow": abs(narrow)}, rel=1e-9)


def test_the_root_of_a_pin_bears_the_moment_of_all_forces_at_their_places():
    """32 M/(π d³) of a cantilever; without places the resultant stands in the middle of the pin."""
    places = {"wide": 0.02, "narrow": 0.05}
    text = fitted(*(f"place_mm = {1e3 * place}" for place in places.values()))
    design = edited(parse(text), {"gears.mesh_efficiency": 1.0, "epicyclics.wolfrom.pin_diameter_mm": 10})
    sizing = size(design)
    (carrier,) = sizing.carriers
    assert carrier.pin_stress == pytest.approx(32.0 * abs(by_hand(sizing, places)[1]) / (math.pi * 0.01**3), rel=1e-9)


def test_a_long_planet_meshes_where_its_mates_lie():
    """Long planet of a Ravigneaux set: ring and large sun in one plane, the short planet in the other."""
    text = shipped_design("ravigneaux-automatic").read_text(encoding="utf-8")
    keys = 'place_mm = 40\nbearing = { designation = "NU 202", side_by_side = 2, spacing_mm = 30 }'
    text = text.replace('meshes = ["large", "ring"]', f'meshes = ["large", "ring"]\n{keys}')
    apart = text.replace('meshes = ["small", "long"]', 'meshes = ["small", "long"]\nplace_mm = 25')
    alike = apart.replace("place_mm = 25", "place_mm = 40")
    tilted, level = (forces(size(parse(each))) for each in (apart, alike))
    assert level["gear.long-1"] == pytest.approx(level["gear.long-2"], rel=1e-12)
    assert abs(tilted["gear.long-1"] - tilted["gear.long-2"]) > 0.1 * level["gear.long-1"]
    assert tilted["gear.short"] == pytest.approx(level["gear.short"])


def test_sizing_judges_named_bearings_of_planets_of_both_kinds_of_sets():
    """L = (C/P)^p 10⁶/(2π n): of a star set, whose planets swing not; two side by side bear 2^(7/9). By hand."""
    named = '{ designation = "NU 206", side_by_side = 2 }'
    planets = ONE_PIECE.replace(" }", f", bearing = {named} }}")
    simple = SIMPLE.format("slow", "ground").replace("[gears]", f"planet_bearing = {named}\n[gears]")
    texts = [simple, COMPOUND.format("ground", "slow", planets)]
    one, other = (size(parse(text.replace("= 1500", "= 2000"))) for text in texts)
    lives = [{check.mode: check.value for check in sizing.checks if check.place == "NU 206"} for sizing in (one, other)]
    assert lives[0] == pytest.approx(lives[1], rel=1e-12)
    radial, made = forces(one)["set.planet"], bearing("NU 206")
    speed = abs(one.reference.speeds["set.planet"])
    by_hand = (2.0 ** (7.0 / 9.0) * made.dynamic_rating / radial) ** (10.0 / 3.0) * 1e6 * 2.0 * math.pi / speed
    assert lives[0]["life"] == pytest.approx(by_hand, rel=1e-9)
    assert lives[0]["static safety"] == pytest.approx(2.0 * made.static_rating / (1.25 * radial), rel=1e-9)
    assert lives[0]["room around the pin"] == made.bore
    assert lives[0]["room in the rim"] == made.outer_diameter


BEARING = 'bearing = { designation = "NU 202" }'


@pytest.mark.parametrize(
    ("wide", "narrow", "path", "words"),
    [
        ('bearing = { designation = "NU 20299" }', "", "wide.bearing.designation", "NU 20299"),
        ('bearing = { designation = "NU 202", dynamic_rating_kn = 5 }', "", "wide.bearing", "one rating without"),
        ('bearing = { designation = "NU 202", spacing_mm = 20 }', "", "wide.bearing.spacing", "no effect on one"),
        ('bearing = { designation = "NU 202", side_by_side = 2, spacing_mm = 9 }', "", "wide.bearing.spacing", "11 mm"),
        ("place_mm = 20", "", "narrow.place", "every step, or of none"),
        (BEARING, BEARING, "wide.place", "every step"),
        (f"place_mm = 20\n{BEARING}", "place_mm = 50", "wide.bearing", "one bearing cannot hold"),
    ],
)
def test_what_cannot_be_held_is_refused_with_what_would_do(wide, narrow, path, words):
    found = problem(fitted(wide, narrow))
    assert path in found.path and words in found.message


def test_a_sun_with_a_place_beside_planets_without_one_is_told():
    found = problem(STEPPED.replace('shaft = "fast"\nteeth = 12', 'shaft = "fast"\nteeth = 12\nplace_mm = 20'))
    assert found.path == "epicyclics.wolfrom.suns.sun.place" and "wide" in found.message


def test_bearings_and_planets_have_room_beside_each_other():
    """Half a face fits beside the plate; one bearing has the width of both steps, one in each that of its own."""
    design = read(shipped_design("wolfrom-reducer"))
    keys = {"epicyclics.wolfrom.planets.wide.place_mm": 1, "epicyclics.wolfrom.planets.narrow.place_mm": 50}
    checks = {check.name: check for check in size(edited(design, keys)).checks}
    wide = checks["wolfrom.wide room beside the plate"]
    assert (
        wide.fails and wide.limit == pytest.approx(0.001) and not checks["wolfrom.narrow room beside the plate"].fails
    )


MISSION = """
schema = 1
name = "steady"
propeller_map = "none"
[engine]
thermal_power_kw = 2000
[bearings]
life_h = 3000
[phases.one]
altitude_ft = 0
tas_kt = 100
duration_min = 60
power_kw = 400
propeller_speed_rpm = 1500
"""


@pytest.mark.parametrize("named", ["", 'designation = "NU 2206"'])
def test_planets_of_compound_sets_live_in_a_flight_as_those_of_simple_ones(named):
    """One train in two words, with a bearing that is named and one that the mission chooses: one row but for losses.

    Of a simple set the torque of the sun stands for both meshes; in a compound one the ring's lacks what friction in
    the sun's took, under a percent; the life goes with its power 10/3."""
    simple, planets = SIMPLE.format("ground", "slow"), ONE_PIECE
    if named:
        simple = simple.replace("[gears]", f"planet_bearing = {{ {named} }}\n[gears]")
        planets = planets.replace(" }", f", bearing = {{ {named} }} }}")
    sizings = [size(parse(text)) for text in (simple, COMPOUND.format("slow", "ground", planets))]
    (one,), (other,) = (bearing_lives(fly(sizing, parse_mission(MISSION))).rows for sizing in sizings)
    assert (one.seat, one.bearing, one.count, one.asked) == (other.seat, other.bearing, other.count, other.asked)
    assert (one.mean_load, one.static_safety) == pytest.approx((other.mean_load, other.static_safety), rel=3e-3)
    assert one.damage == pytest.approx(other.damage, rel=0.01)


def test_a_named_bearing_that_has_no_room_is_told_by_its_own_path():
    planets = ONE_PIECE.replace(" }", ', bearing = { designation = "NU 2220" } }')
    flight = fly(size(parse(COMPOUND.format("slow", "ground", planets))), parse_mission(MISSION))
    with pytest.raises(DesignError, match=r"epicyclics\.set\.planets\.planet\.bearing: NU 2220 has a bore of"):
        bearing_lives(flight)


def test_a_review_says_what_it_does_not_know_of_a_stepped_planet():
    mode = "moment that tilts a stepped planet"
    known = fitted(f"place_mm = 15\n{BEARING}", f"place_mm = 40\n{BEARING}")
    open_, known = ([check.mode for check in review_of(size(parse(text))).open] for text in (STEPPED, known))
    assert mode in open_ and mode not in known


def test_bearings_of_one_step_have_the_width_of_the_body_and_those_of_several_that_of_their_own():
    """Room beside each other: both steps carry one bearing, or each of them its own."""
    places = "place_mm = 15", "place_mm = 40"
    pair = 'bearing = { designation = "NU 202", side_by_side = 2, spacing_mm = 14 }'
    for narrow in ("", BEARING):
        wide = BEARING if narrow else pair
        sizing = size(parse(fitted(f"{places[0]}\n{wide}", f"{places[1]}\n{narrow}")))
        widths = {gear.own: gear.face_width for gear in sizing.gears}
        limits = [check.limit for check in sizing.checks if check.mode == "room for its bearing"]
        both = widths["wide"] + widths["narrow"]
        assert limits == pytest.approx([widths["wide"], widths["narrow"]] if narrow else [both])
        values = [check.value for check in sizing.checks if check.mode == "room for its bearing"]
        assert values == pytest.approx([0.011, 0.011] if narrow else [0.014 + 0.011])


@pytest.mark.parametrize(
    ("place", "mate", "expected"),
    [(0.040, None, 0.040), (None, 0.030, None), (0.040, 0.026, 0.026), (0.040, 0.024, 0.025), (0.040, 0.058, 0.056)],
)
def test_a_mesh_lies_in_the_middle_of_the_width_that_both_gears_have(place, mate, expected):
    """A planet of 20 to 60 mm: 20 to 32 mm lie inside, of 18 to 30 it has 20 to 30. By hand."""
    design = read(shipped_design("ravigneaux-automatic"))
    keys = {"planets.long": place, "planets.short": mate}
    changes = {f"epicyclics.gear.{gear}.place_mm": 1e3 * at for gear, at in keys.items() if at is not None}
    epicyclic = edited(design, changes).epicyclics["gear"]
    gears = {"long": SimpleNamespace(face_width=0.040), "short": SimpleNamespace(face_width=0.012)}
    found = mesh_place(epicyclic, gears, "long", "short")
    assert found == (None if expected is None else pytest.approx(expected))
