"""Bodies at their places in space: frames, meshes, shafts that cross, bearings in wheels, open axes, keep-outs."""

import cmath
import math

import numpy as np
import pytest

import gearwright as gw
from designs import problem
from gearwright.checks import Status
from gearwright.sizing import size
from gearwright.spec import edited
from shipped_work import coarse

TWO_WHEELS = """schema = 1
name = "Two wheels on one pinion"
level = "concept"
shafts = ["input", "out", "tail"]
[turbines.turbine]
shaft = "input"
power_kw = 300
speed_rpm = 6000
[propellers.propeller]
shaft = "out"
speed_rpm = 2000
diameter_m = 3
[loads.fan]
shaft = "tail"
speed_rpm = 3000
power_kw = 30
[pairs.main]
pinion = "input"
wheel = "out"
pinion_teeth = 25
wheel_teeth = 75
[pairs.aux]
pinion = "main.pinion"
wheel = "tail"
wheel_teeth = 50
[layout.out]
angle_deg = 0
"""
"""Both wheels mesh with one pinion in one plane; left open, the second would stand where the first does."""
FLOOR = """[keep_out.floor]
reason = "cabin floor"
start = { x_mm = -500, y_mm = -500, z_mm = -300 }
end = { x_mm = 500, y_mm = 500, z_mm = -100 }
"""
FACE_GEAR = """schema = 1
name = "A face gear, and a second pinion on its mate's shaft"
level = "concept"
shafts = ["input", "middle", "side"]
[turbines.turbine]
shaft = "input"
power_kw = 300
speed_rpm = 6000
[propellers.propeller]
shaft = "middle"
speed_rpm = 2000
diameter_m = 3
[loads.fan]
shaft = "side"
speed_rpm = 6000
power_kw = 30
[pairs.face]
kind = "face"
axis_angle_deg = 90
pinion = "input"
wheel = "middle"
pinion_teeth = 25
wheel_teeth = 75
[pairs.aux]
pinion = "input"
wheel = "side"
pinion_teeth = 60
wheel_teeth = 60
[layout.side]
angle_deg = 180
[overrides]
"face.module_mm" = 3
"face.face_width_mm" = 20
"aux.module_mm" = 2
"aux.face_width_mm" = 20
"""


def vector(place):
    return np.array(place, dtype=float)


def rooms(sizing):
    """Return the checks of room between bodies and of keep-outs."""
    return [check for check in sizing.checks if check.clause == "bodies in space"]


def shipped(name):
    return gw.size(gw.read(gw.shipped_design(name)))


@pytest.fixture(scope="module")
def ec120b():
    return shipped("ec120b")


@pytest.mark.parametrize("name", ["ec120b", "twin-engine-helicopter", "off-set-h2", "face-gear-split-torque"])
def test_every_frame_is_square_and_right_handed(name):
    for frame in shipped(name).arrangement.frames.values():
        axes = np.array([frame.along, frame.across, frame.up])
        assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)
        assert np.linalg.det(axes) == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["ec120b", "twin-engine-helicopter", "off-set-h2", "mixed-h1", "wind-turbine-5mw"])
def test_gears_in_mesh_touch_in_the_direction_in_which_loads_act(name):
    """Both frames show one direction in space: each gear's, towards its mate in its own cross-section."""
    sizing = shipped(name)
    axes, frames = sizing.arrangement.axes, sizing.arrangement.frames
    for mesh in sizing.train.meshes:
        one, other = mesh.nodes[:2]
        if mesh.stage not in sizing.design.pairs:
            continue
        towards = (axes[other] - axes[one]) / abs(axes[other] - axes[one])
        first, second = (
            way.real * vector(frames[node].across) + way.imag * vector(frames[node].up)
            for node, way in ((one, towards), (other, -towards))
        )
        if sizing.design.pairs[mesh.stage].kind == "cylindrical":
            assert first == pytest.approx(-second, abs=1e-9)
            off = vector(frames[other].origin) - vector(frames[one].origin)
            across = off - (off @ vector(frames[one].along)) * vector(frames[one].along)
            row = next(row for row in sizing.meshes if row.name == mesh.name)
            assert across == pytest.approx(row.centre_distance * first, abs=1e-9)
        else:  # square axes: each touches the other along the other's axis
            assert abs(first @ vector(frames[other].along)) == pytest.approx(1.0)
            assert abs(second @ vector(frames[one].along)) == pytest.approx(1.0)


def test_bevel_shafts_meet_in_their_apex(ec120b):
    """By hand: R_m cos δ_1 = r_m2 from the pinion's mean point and r_m1 from the wheel's, on square axes."""
    frames, plans = ec120b.arrangement.frames, ec120b.arrangement.plans
    pinion, wheel = (next(g for g in ec120b.gears if g.name == name) for name in ("bevel.pinion", "bevel.wheel"))
    ends = [
        vector(frames[shaft].origin) + (plans[shaft].places[gear.name] + mate.pitch_diameter / 2.0)
        * vector(frames[shaft].along)
        for shaft, gear, mate in (("intermediate", pinion, wheel), ("mast", wheel, pinion))
    ]  # fmt: skip
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_the_input_of_ec120b_stands_off_the_plane_of_its_mast_and_is_drawn_as_turned_into_it(ec120b):
    """Sized at 90° to it: the intermediate shaft lies beside the input, the mast above the intermediate one."""
    from gearwright.render.drawings.assembly_sheets import arrangement_content

    frames = ec120b.arrangement.frames
    assert vector(frames["mast"].along) == pytest.approx([0.0, 0.0, -1.0], abs=1e-12)
    off = frames["input"].origin.y - frames["mast"].origin.y
    distance = next(mesh.centre_distance for mesh in ec120b.meshes if mesh.stage == "helical")
    assert abs(off) == pytest.approx(distance)
    words = f"Shaft input is turned into this plane: it stands {1e3 * distance:.4g} mm off it."
    assert words in arrangement_content(ec120b, coarse(ec120b)).notes


def test_a_bearing_moved_into_a_bevel_wheel_fails_by_as_much_as_it_is_moved_beyond_touching():
    """At 25 mm its clearance is c; every millimetre nearer takes one, and beyond touching it fails by the rest."""
    design = gw.read(gw.shipped_design("ec120b"))
    (clear,) = [check for check in rooms(size(design)) if "mast-lower" in check.place]
    near = size(edited(design, {"bearings.mast-lower.position_mm": 25.0 + 5.0}))
    (fails,) = [check for check in rooms(near) if "mast-lower" in check.place]
    assert clear.status is Status.PASSES
    assert fails.fails
    assert str(fails.part) == "mast"
    gaps = [check.value - check.limit for check in (clear, fails)]
    assert gaps[0] - gaps[1] == pytest.approx(5e-3, abs=1e-9)


def test_shafts_that_cross_are_found():
    """By hand: as reported, the intermediate shaft ends beyond the apex, and the mast does, too: each runs through the
    other's axis."""
    sizing = shipped("ec120b-as-reported")
    failing = {(str(check.part), check.mode): check for check in rooms(sizing) if check.status is Status.FAILS}
    check = failing["mast", "room beside intermediate"]
    assert "intermediate and mast" in check.place
    wheel = next(gear for gear in sizing.gears if gear.name == "bevel.wheel")
    assert 0.270 + wheel.pitch_diameter / 2.0 < 0.540
    assert ("intermediate", "room beside input") in failing


@pytest.mark.parametrize("name", [name for name in gw.shipped_designs() if name != "ec120b-as-reported"])
def test_shipped_designs_have_room_for_all_their_bodies(name):
    assert [check.name for check in rooms(shipped(name)) if check.status is Status.FAILS] == []


def test_an_open_axis_turns_about_its_mate_until_the_wheels_clear_and_no_farther():
    """By the law of cosines: tips touch where a_1² + a_2² − 2 a_1 a_2 cos φ = (r_1 + r_2)²; 1 mm at most more."""
    sizing = size(gw.parse(TWO_WHEELS))
    (turn,) = sizing.arrangement.turns
    place = sizing.arrangement.axes
    one, other = abs(place["out"]), abs(place["tail"])
    tips = [body.radius for body in sizing.arrangement.bodies if str(body.part) in ("main.wheel", "aux.wheel")]
    least = math.acos((one**2 + other**2 - sum(tips) ** 2) / (2.0 * one * other))
    assert turn.shaft == "tail"
    assert turn.before == 0.0
    assert cmath.phase(place["tail"]) == pytest.approx(turn.after)
    assert least <= abs(turn.after) <= least + 1e-3 / other + math.radians(0.01)
    assert [check.name for check in rooms(sizing) if check.fails] == []
    assert "into each other" in turn.why


def test_turning_does_not_depend_on_how_often_it_is_asked():
    one, other = (size(gw.parse(TWO_WHEELS)) for _ in range(2))
    assert one.arrangement == other.arrangement


def test_a_side_keeps_an_axis_there():
    below = size(gw.parse(TWO_WHEELS + '[layout.tail]\nside = "below"\n'))
    assert below.arrangement.turns == () or math.sin(below.arrangement.turns[0].after) < 0.0
    assert below.arrangement.axes["tail"].imag < 0.0
    above = size(gw.parse(TWO_WHEELS + '[layout.tail]\nside = "above"\n'))
    assert above.arrangement.axes["tail"].imag > 0.0


def test_given_angles_are_kept_and_what_stands_into_each_other_fails():
    """Both wheels at 0°: their tips overlap by r_1 + r_2 − (a_1 − a_2)."""
    sizing = size(gw.parse(TWO_WHEELS + "[layout.tail]\nangle_deg = 0\n"))
    assert sizing.arrangement.turns == ()
    worst = min((check for check in rooms(sizing) if check.fails), key=lambda check: check.ratio)
    assert worst.fails


def test_an_open_axis_stays_out_of_a_keep_out():
    free = size(gw.parse(TWO_WHEELS.replace("[layout.out]\nangle_deg = 0\n", "[layout.tail]\nangle_deg = 180\n")))
    kept = size(
        gw.parse(TWO_WHEELS.replace("[layout.out]\nangle_deg = 0\n", "[layout.tail]\nangle_deg = 180\n") + FLOOR)
    )
    lowest = [min(body.origin.z - body.radius for body in sizing.arrangement.bodies) for sizing in (free, kept)]
    assert lowest[0] < -0.1 <= lowest[1]
    (check,) = [check for check in kept.checks if check.mode == "keep-out floor"]
    assert check.status is Status.PASSES
    assert check.value - check.limit == pytest.approx(lowest[1] + 0.1, abs=1e-6)
    assert [turn.shaft for turn in kept.arrangement.turns] == ["out"]


def test_a_keep_out_that_leaves_no_room_fails_with_its_name_the_overlap_and_the_reason():
    """The input does not move: a cylinder around its axis stands into its pinion."""
    around = """[keep_out.engine]
reason = "engine"
start = { x_mm = -100 }
end = { x_mm = 400 }
radius_mm = 20
"""
    (check,) = [check for check in size(gw.parse(TWO_WHEELS + around)).checks if check.mode == "keep-out engine"]
    assert check.fails
    assert check.name == "gearbox keep-out engine"
    assert "engine" in check.why
    assert "mm into it" in check.why


def test_wishes_that_contradict_each_other_are_refused():
    def said(more):
        found = problem(TWO_WHEELS + more)
        return f"{found.path}: {found.message}"

    words = said('[layout.tail]\nangle_deg = 90\nside = "below"\n')
    assert "layout.tail.side" in words
    assert "contradicts angle_deg = 90" in words
    assert "the box is flat" in said(FLOOR.replace("z_mm = -100", "z_mm = -300"))
    assert "give it a length" in said('[keep_out.rod]\nreason = "x"\nstart = {}\nend = {}\nradius_mm = 5\n')
    assert "write what is there" in said(FLOOR.replace("cabin floor", " "))


def test_bodies_say_who_they_are_and_none_lies_outside_the_shaft_that_carries_it(ec120b):
    for body in ec120b.arrangement.bodies:
        assert body.length > 0.0
        assert body.radius > body.bore >= 0.0
    parts = {str(body.part) for body in ec120b.arrangement.bodies}
    assert parts >= {gear.name for gear in ec120b.gears} | {bearing.name for bearing in ec120b.bearings}
    assert parts >= set(ec120b.design.shafts)


@pytest.mark.parametrize("name", gw.shipped_designs())
def test_every_part_of_every_shipped_design_has_a_place(name):
    sizing = shipped(name)
    parts = {str(body.part) for body in sizing.arrangement.bodies}
    gears = {
        str(gear.body(shaft)) for gear in sizing.gears if gear.stage in sizing.design.pairs for shaft in gear.shafts
    }
    assert parts >= gears | {str(gear.part) for gear in sizing.gears if gear.stage in sizing.design.sets}
    assert parts >= {bearing.name for bearing in sizing.bearings} | {str(carrier.part) for carrier in sizing.carriers}


@pytest.mark.parametrize("name", ["left", "right"])
def test_the_teeth_of_a_face_gear_reach_to_its_pinion_from_their_side(name):
    """By hand, m = 1.6 mm, z = 32, 124: tips 25.6 − 1.6 mm from the pinion's axis, roots 25.6 + 2, the back 4.32 on."""
    sizing = shipped("face-gear-split-torque")
    frames, bodies = sizing.arrangement.frames, sizing.arrangement.bodies
    teeth, blank = (body for body in bodies if str(body.part) == f"first.wheel.{name}")
    pinion = next(body for body in bodies if str(body.part) == "first.pinion")
    middle = vector(pinion.origin) + pinion.length / 2.0 * vector(pinion.direction)
    along = vector(frames[name].along)
    planes = [
        abs((vector(body.origin) + station.place * vector(body.direction) - middle) @ along)
        for body in (teeth, blank)
        for station in body.stations
    ]
    assert sorted(planes) == pytest.approx([24e-3, 27.6e-3, 27.6e-3, 31.92e-3])
    assert (teeth.bore, teeth.radius, blank.bore, blank.radius) == pytest.approx((89.2e-3, 109.2e-3, 0.0, 109.2e-3))
    away = middle - vector(teeth.origin)
    across = away - (away @ along) * along
    assert across @ across == pytest.approx(99.2e-3**2)  # the middle of its face is on the pitch circle


def test_a_gear_that_runs_into_a_face_gear_fails_by_what_it_needs_to_get_out():
    """By hand: a tip radius of 60 + 2 mm, the root plane 37.5 + 3.75 mm from the axis: 20.75 mm; m = 1.2 clears."""
    (check,) = [check for check in rooms(size(gw.parse(FACE_GEAR))) if check.fails]
    assert check.name == "middle room beside input"
    assert check.place == "face.wheel and aux.pinion"
    assert check.limit - check.value == pytest.approx(20.75e-3)
    clear = size(gw.parse(FACE_GEAR.replace('"aux.module_mm" = 2', '"aux.module_mm" = 1.2')))
    assert [check.name for check in rooms(clear) if check.fails] == []


def off_set_with(*shafts):
    """Return Off-Set with the second pinion of some layshafts given a place, of the first one 2 mm on."""
    design = gw.read(gw.shipped_design("off-set"))
    plans, text = size(design).arrangement.plans, gw.shipped_design("off-set").read_text(encoding="utf-8")
    for shaft in shafts:
        place = 1e3 * plans[shaft].places["second.pinion"] + (2.0 if shaft == shafts[0] else 0.0)
        text += f'\n[layout.{shaft}.places]\n"second.pinion".position_mm = {place}\n'
    return size(gw.parse(text))


def test_gears_whose_places_do_not_meet_are_told():
    """Two layshafts between two gears: one of four places moved by 2 mm leaves one mesh 2 mm apart."""
    assert off_set_with().arrangement.apart == {}
    moved = off_set_with("left", "right")
    assert [abs(off) for off in moved.arrangement.apart.values()] == [pytest.approx(2e-3)]
    (check,) = [check for check in moved.checks if check.mode == "gears beside each other"]
    assert check.fails
    assert check.value == pytest.approx(2e-3)


def test_a_gear_whose_place_is_open_moves_to_its_mate():
    """The other layshaft follows by the same 2 mm, and is longer by them; nothing else moves along x."""
    stood, moved = off_set_with(), off_set_with("left")
    assert moved.arrangement.apart == {}
    before, after = stood.arrangement.plans["right"], moved.arrangement.plans["right"]
    assert after.places["second.pinion"] - before.places["second.pinion"] == pytest.approx(2e-3)
    assert after.length - before.length == pytest.approx(2e-3)
    assert after.places["first.wheel"] == before.places["first.wheel"]


def span(body, along):
    """Return where a body begins and ends along a direction [m]."""
    ends = [vector(body.origin) @ along, (vector(body.origin) + body.length * vector(body.direction)) @ along]
    return min(ends), max(ends)


@pytest.mark.parametrize("name", gw.shipped_designs())
def test_gears_in_mesh_overlap_along_their_axes_by_the_narrower_one(name):
    """Of every pair of parallel axes the narrower face lies within the wider one, to the 0.05 mm of the check."""
    sizing = shipped(name)
    bodies = {str(body.part): body for body in sizing.arrangement.bodies}
    gears = {gear.name: gear for gear in sizing.gears}
    for mesh in sizing.train.meshes:
        if mesh.stage in sizing.design.pairs and sizing.design.pairs[mesh.stage].kind == "cylindrical":
            one, other = (
                bodies[str(gears[gear].body(shaft))] for gear, shaft in zip(mesh.gears, mesh.nodes, strict=False)
            )
            (start, end), (first, last) = (span(body, vector(one.direction)) for body in (one, other))
            assert min(end, last) - max(start, first) >= min(one.length, other.length) - 5e-5, mesh.name


def test_both_pinions_of_a_split_torque_stand_in_the_plane_of_their_wheel():
    """By hand: the face wheels stand 2 × 25.6 mm apart about the pinion, so the right shaft is longer by as much."""
    plans = shipped("face-gear-split-torque").arrangement.plans
    assert plans["right"].length - plans["left"].length == pytest.approx(51.2e-3)


@pytest.mark.parametrize("name", ["star", "in-line-star", "in-line-h1-star", "geared-turbofan-star", "wolfrom-reducer"])
def test_a_plate_without_a_shaft_stands_away_from_the_ring_that_turns_and_lets_the_sun_s_shaft_through(name):
    sizing = shipped(name)
    assert not [check.name for check in sizing.checks if check.ratio is None]
    stage = next(carrier.stage for carrier in sizing.carriers if sizing.design.sets[carrier.stage].carrier != "output")
    bodies = sizing.arrangement.bodies
    plate = next(body for body in bodies if body.part.name == stage and body.part.kind == "carrier")
    sun = next(gear for gear in sizing.gears if gear.stage == stage and gear.role == "sun")
    shaft = next(shaft for shaft in sizing.shafts if shaft.name == sun.shafts[0])
    assert shaft.diameter / 2.0 + 0.005 == pytest.approx(plate.bore, abs=1e-12)  # PLATE_GAP; rounding
    assert plate.origin.x + plate.length == pytest.approx(sizing.arrangement.plans[shaft.name].length - 0.005, abs=1e-9)
