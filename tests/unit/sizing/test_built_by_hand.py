"""Stretches, sections and sums of built shafts, laid out by hand."""

import math
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from designs import changed
from gearwright.catalogue import bearings, materials
from gearwright.errors import DesignError
from gearwright.identity import Kind
from gearwright.parts.shaft_fatigue import Shoulder
from gearwright.sizing import ShaftPlan, size
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.rating import context_of
from gearwright.sizing.shafts.building import ShaftTask, items_on, seat_of
from gearwright.sizing.shafts.sections import (
    JointSeat,
    Section,
    Strength,
    keyway_depth,
    sections_of,
    size_joint,
    strengths,
)
from gearwright.sizing.shafts.stretches import (
    BEARING_SLOPES,
    GEAR_SLOPE,
    SeatedPart,
    ShaftStretch,
    Wanted,
    bend,
    lay,
    slope_excess,
)
from gearwright.spec import parse
from gearwright.spec.design import BearingSeat, Joint, ShaftRules
from mounted_designs import HELICOPTER, PAIR, ROTOR, sized

STEEL = materials()["carburised-9310"]


def ring(bore, outer, width=0.016):
    """Return what of a bearing a seat needs."""
    return SimpleNamespace(bore=bore, outer_diameter=outer, width=width)


def laid(items, needed, *, length=0.2, fixed=None, core=None, rings=None):
    """Return name -> diameter of the stretches [mm], in order, and what was asked of the bearings."""
    asked = {}

    def choose(name, smallest, largest):
        asked[name] = (smallest, largest)
        return rings[name]

    wanted = Wanted(tuple(items), length, needed, fixed or {}, core, (0.03, 0.17))
    stretches, chosen = lay("shaft", wanted, choose)
    assert chosen == rings
    assert stretches[0].start == 0.0 and stretches[-1].end == pytest.approx(length)
    for one, other in pairwise(stretches):
        assert one.end == pytest.approx(other.start)
    return [(stretch.name, pytest.approx(1e3 * stretch.diameter)) for stretch in stretches], asked, stretches


A, B = SeatedPart("a", "bearing", 0.03, 0.016), SeatedPart("b", "bearing", 0.17, 0.016)
RINGS = {"a": ring(0.040, 0.080), "b": ring(0.045, 0.085)}


def test_a_plain_shaft_is_a_neck_between_the_shoulders_of_its_bearings():
    """Shoulders stand 0.175 (D − d) above the bore, in whole millimetres: 47 and 52, and are a tenth of that wide; an
    end that carries nothing is as thick as the bearing beside it."""
    found, asked, stretches = laid([A, B], {"after a": 0.0441}, rings=RINGS)
    assert found == [
        ("after", 40.0), ("a", 40.0), ("collar of a", 47.0), ("after a", 45.0), ("collar of b", 52.0), ("b", 45.0),
        ("after b", 45.0),
    ]  # fmt: skip
    assert [1e3 * stretches[k].length for k in (2, 4)] == pytest.approx([4.7, 5.2])
    assert asked == {"a": (0.0, math.inf), "b": (0.0, math.inf)}
    assert [stretch.fillet for stretch in stretches if stretch.fillet] == [pytest.approx(1e-3), pytest.approx(1e-3)]
    one_sided, _, _ = laid([A, B], {"after a": 0.0475}, rings=RINGS)
    assert one_sided[2:4] == [("after a", 48.0), ("collar of b", 52.0)]
    thick, _, _ = laid([A, B], {"after a": 0.0603}, rings=RINGS)
    assert thick[2] == ("after a", 61.0)
    given, _, _ = laid([A, B], {"after a": 0.0603}, rings=RINGS, core=0.05)
    assert given[2] == ("after a", 50.0)
    with pytest.raises(DesignError, match=r"44 mm is thinner than the seats beside it, 45 mm"):
        laid([A, B], {}, rings=RINGS, core=0.044)


def test_of_two_free_stretches_the_longer_one_is_the_thickest_place():
    """A third bearing parts the shaft between the radial ones; it is slid on over the thinner side."""
    third = SeatedPart("c", "bearing", 0.13, 0.016)
    rings = {**RINGS, "c": ring(0.046, 0.080)}
    found, _, _ = laid([A, third, B], {"after a": 0.0551}, rings=rings)
    assert dict(found)["after a"] == 56.0 and dict(found)["c"] == 46.0
    early = SeatedPart("c", "bearing", 0.07, 0.016)
    rings = {**RINGS, "c": ring(0.041, 0.080)}
    found, _, _ = laid([A, early, B], {"after c": 0.0551}, rings=rings)
    assert dict(found)["after c"] == 56.0


def test_bearings_are_asked_for_what_must_pass_through_them():
    """An end that carries torque is grown first; what is further in is not thinner."""
    found, asked, _ = laid([A, B], {"after": 0.0331, "b": 0.0412}, rings=RINGS)
    assert found[0] == ("after", 34.0)
    assert asked == {"a": (0.034, math.inf), "b": (0.0412, math.inf)}
    with pytest.raises(DesignError, match=r"a has a seat of 40 mm on 'shaft' and must be slid over 41 mm further out"):
        laid([A, B], {"after": 0.0401}, rings=RINGS)


def test_a_hub_between_the_bearings_leans_on_a_collar_on_its_longer_side():
    """A collar is 1.15 of the seat, at least the shoulder of the bearing beyond it; the other side stays as it is."""
    hub = SeatedPart("hub", "hub", 0.08, 0.04)
    found, _, _ = laid([A, hub, B], {"hub": 0.0502}, rings=RINGS)
    assert found == [
        ("after", 40.0), ("a", 40.0), ("after a", 47.0), ("hub", 51.0), ("after hub", 59.0), ("b", 45.0),
        ("after b", 45.0),
    ]  # fmt: skip
    early = SeatedPart("hub", "hub", 0.13, 0.04)
    found, _, _ = laid([A, early, B], {"hub": 0.0502}, rings=RINGS)
    assert found[2] == ("after a", 59.0) and found[4] == ("after hub", 45.0)
    thin, _, _ = laid([A, hub, B], {}, rings=RINGS)
    assert thin[3] == ("hub", 45.0) and thin[4] == ("after hub", 52.0)


def test_a_hub_that_fills_all_between_its_bearings_has_no_collar():
    hub = SeatedPart("hub", "hub", 0.1, 0.124)
    found, _, _ = laid([A, hub, B], {"hub": 0.0502}, rings=RINGS)
    assert found == [("after", 40.0), ("a", 40.0), ("hub", 51.0), ("b", 45.0), ("after b", 45.0)]


def test_the_hub_that_needs_most_is_the_thickest_place():
    first, second = SeatedPart("first", "hub", 0.07, 0.03), SeatedPart("second", "hub", 0.13, 0.03)
    found, _, _ = laid([A, first, second, B], {"first": 0.055, "second": 0.05}, rings=RINGS)
    by_name = dict(found)
    assert by_name["first"] == 55.0 and by_name["second"] == 50.0
    given, _, _ = laid([A, first, second, B], {"first": 0.055}, fixed={"second": 0.060}, rings=RINGS)
    assert dict(given)["second"] == 60.0 and dict(given)["first"] == 55.0


def test_a_gear_of_one_piece_counts_with_half_more_than_the_shaft_beside_it():
    """Its body stiffens up to 1.5 of the shaft, or its root circle; what is beside it grows, the gear does not."""
    gear = SeatedPart("gear", "integral", 0.1, 0.05, 0.09)
    found, _, _ = laid([A, gear, B], {"gear": 0.041}, rings=RINGS)
    assert dict(found)["gear"] == 1.5 * 45.0
    small = SeatedPart("gear", "integral", 0.1, 0.05, 0.058)
    found, asked, _ = laid([A, small, B], {}, rings=RINGS)
    assert dict(found)["gear"] == 58.0 and asked["a"] == (0.0, 0.058)
    assert dict(found)["after a"] == 47.0 and dict(found)["after gear"] == 52.0
    given, _, _ = laid([A, gear, B], {}, core=0.06, rings=RINGS)
    assert dict(given)["after a"] == 60.0 and dict(given)["after gear"] == 60.0
    with pytest.raises(DesignError, match=r"needs 62 mm beside this gear, which has a root circle of 58 mm"):
        laid([A, small, B], {"after gear": 0.062}, rings=RINGS)


def test_nothing_can_be_slid_between_two_gears_of_one_piece():
    gears = [
        SeatedPart("g", "integral", 0.06, 0.02, 0.09),
        SeatedPart("hub", "hub", 0.1, 0.02),
        SeatedPart("h", "integral", 0.14, 0.02, 0.09),
    ]
    with pytest.raises(DesignError, match=r"joints\.hub: it lies between gears of one piece"):
        laid([A, *gears, B], {}, rings=RINGS)
    found, _, _ = laid([A, gears[0], gears[2], B], {"after g": 0.0503}, rings=RINGS)
    assert dict(found)["after g"] == 51.0


def forces_of(positions, bending, torsion, places=None):
    """Return forces of one case with given moments at stations [N m]."""
    drawn = SimpleNamespace(
        position=np.array(positions),
        bending=np.array([[bending, [0.0] * len(bending)]]),
        torsion=np.array([torsion]),
        shear=np.zeros((1, 2, len(positions))),
    )
    plan = ShaftPlan(positions[-1], (0.0, positions[-1]), places or {})
    return ShaftForces(plan, None, drawn, np.zeros(1), True)


def test_every_step_hub_and_load_is_a_section():
    """Steps below 0.98; the fillet is the bearing's, or its share of the thinner side, at least 0.03 of the step; a hub
    at both ends, in its middle and at each load inside; loads elsewhere on the stretch that they stand on."""
    stretches = [
        ShaftStretch("after", "between", 0.0, 0.02, 0.030),
        ShaftStretch("a", "bearing", 0.02, 0.04, 0.040, 0.047, 0.001),
        ShaftStretch("after a", "between", 0.04, 0.06, 0.0405),
        ShaftStretch("hub", "hub", 0.06, 0.10, 0.050),
        ShaftStretch("after hub", "between", 0.10, 0.12, 0.090),
    ]
    forces = forces_of([0.0, 0.03, 0.07, 0.12], [0.0, 10.0, 5.0, 0.0], [0.0, 1.0, 1.0, 0.0], {"m": 0.11, "n": 0.0})
    stations = [0.0, 0.03, 0.07, 0.12]
    rules = ShaftRules(fillet_ratio=0.02)
    found = sections_of(stretches, forces, {"hub": "spline"}, {"hub": 0.046}, stations=stations, rules=rules)
    assert [(section.place, section.owner, round(section.position, 9)) for section in found] == [
        ("at n", "after", 0.0), ("shoulder at a", "after", 0.02), ("seat of a", "a", 0.03),
        ("shoulder at hub", "after a", 0.06), ("spline at hub", "hub", 0.06), ("spline at hub", "hub", 0.07),
        ("spline at hub", "hub", 0.08), ("shoulder at hub", "hub", 0.1), ("spline at hub", "hub", 0.1),
        ("at m", "after hub", 0.12),
    ]  # fmt: skip
    assert {section.blank for section in found} == {0.090}
    assert {section.diameter for section in found if section.hub == "spline"} == {0.046}
    fillets = [section.shoulder.radius for section in found if section.shoulder is not None]
    assert fillets == pytest.approx([0.02 * 0.030, 0.02 * 0.0405, 0.02 * 0.05])
    steep = [
        ShaftStretch("a", "bearing", 0.0, 0.1, 0.040, 0.0, 1e-4),
        ShaftStretch("after a", "between", 0.1, 0.2, 0.060),
    ]
    idle = forces_of([0.0, 0.2], [0.0, 0.0], [0.0, 0.0], {"m": 0.0})
    found = sections_of(steep, idle, {}, {}, stations=[0.0, 0.2], rules=rules)
    (only,) = [section for section in found if section.shoulder is not None]
    assert only.shoulder == Shoulder(0.040, 0.060, pytest.approx(0.03 * 0.01))
    assert only.place == "shoulder at a"
    found = sections_of(steep, idle, {}, {}, stations=[0.0, 0.2], rules=ShaftRules(shoulders="undercut"))
    (only,) = [section for section in found if section.shoulder is not None]
    assert (only.place, only.diameter) == ("undercut at a", pytest.approx(0.0396))
    assert only.shoulder == pytest.approx(Shoulder(0.0396, 0.060, 1.2e-3, 0.2e-3))


def judged(section, moment, torque, *, text=PAIR, bore=0.0):
    """Return the strength of one section under one bending moment and torque [N m]."""
    forces = forces_of([0.0, 1.0], [moment, moment], [torque, torque])
    judge = Strength("shaft", parse(text), STEEL, ("rated",))
    (found,) = strengths([section], forces, judge, bore=bore)
    return found


PLAIN = Section("here", "stretch", 0.5, 0.050, 0.060)


def test_stresses_of_a_section_are_those_of_its_own_moments():
    """Without notch, hollow: σ = 32 M d/π(d⁴ − d_i⁴), and its steady torque by von Mises against the yield point."""
    service = parse(PAIR).service
    for bore in (0.0, 0.03):
        second = math.pi / 64.0 * (0.05**4 - bore**4)
        bending, shear = 2000.0 * 0.025 / second, 3000.0 * 0.025 / (2.0 * second)
        found = judged(PLAIN, 2000.0, 3000.0, bore=bore)
        top = math.sqrt(bending**2 + 3.0 * (shear * (1.0 + service.torque_swing)) ** 2)
        assert found.yield_safety == pytest.approx(STEEL.yield_strength / top / service.application_factor, rel=1e-6)
        assert (found.bending_moment, found.torque) == (2000.0, 3000.0)
        assert (found.bending_notch, found.torsion_notch, found.fillet) == (1.0, 1.0, 0.0)


def test_a_section_that_bears_nothing_is_as_safe_as_can_be_told():
    found = judged(PLAIN, 0.0, 0.0)
    assert (found.fatigue_safety, found.yield_safety, found.din743_safety) == (99.0, 99.0, 99.0)


def test_a_wall_thinner_than_three_hundredths_counts_as_that():
    thin, thinner = judged(PLAIN, 50.0, 20.0, bore=0.97 * 0.05), judged(PLAIN, 50.0, 20.0, bore=0.99 * 0.05)
    assert thin.yield_safety == thinner.yield_safety
    assert judged(PLAIN, 50.0, 20.0, bore=0.96 * 0.05).yield_safety > thin.yield_safety


def test_notches_lower_fatigue_by_asme_and_by_din_743():
    """A shoulder, a key, a spline, a press fit: each against the plain section; a blunter fillet is safer."""
    plain = judged(PLAIN, 800.0, 900.0)
    sharp, blunt = (
        judged(Section("s", "s", 0.5, 0.05, 0.06, Shoulder(0.05, 0.06, radius)), 800.0, 900.0)
        for radius in (5e-4, 4e-3)
    )
    assert sharp.fatigue_safety < blunt.fatigue_safety < plain.fatigue_safety
    assert sharp.din743_safety < blunt.din743_safety < plain.din743_safety
    assert (sharp.fillet, blunt.fillet) == (5e-4, 4e-3)
    for kind in ("key", "spline", "press-fit"):
        found = judged(Section("h", "h", 0.5, 0.05, 0.06, hub=kind), 800.0, 900.0)
        assert found.fatigue_safety < plain.fatigue_safety and found.din743_safety < plain.din743_safety
        assert found.bending_notch > 1.0


def test_a_thicker_blank_is_weaker_by_din_743():
    """Heat treatment reaches less deep: K_1 of the blank's diameter, not of the section's."""
    thick = judged(Section("here", "stretch", 0.5, 0.05, 0.25), 800.0, 900.0)
    thin = judged(PLAIN, 800.0, 900.0)
    assert thick.din743_safety < 0.97 * thin.din743_safety
    assert thick.fatigue_safety == thin.fatigue_safety


def test_a_built_shaft_is_bent_as_its_beam():
    """A uniform shaft in two bearings under a force in its middle: F L³/48 E I, slopes F L²/16 E I; over its limits."""
    stretches = [ShaftStretch("a", "bearing", 0.0, 0.01, 0.04), ShaftStretch("g", "integral", 0.01, 0.39, 0.04),
                 ShaftStretch("b", "bearing", 0.39, 0.4, 0.04)]  # fmt: skip
    position = [0.0, 0.2, 0.4]
    forces = forces_of(position, [0.0, 100.0, 0.0], [0.0, 0.0, 0.0])
    bent = bend(forces, stretches, STEEL, bore=0.02)
    inertia = math.pi / 64.0 * (0.04**4 - 0.02**4)
    force = 4.0 * 100.0 / 0.4
    rigid = STEEL.elastic_modulus * inertia
    assert bent.deflection(0.2) == pytest.approx(force * 0.4**3 / (48.0 * rigid), rel=1e-6)
    assert bent.slope(0.0) == pytest.approx(force * 0.4**2 / (16.0 * rigid), rel=1e-6)
    seats = {"a": BearingSeat(shaft="s", position=0.0, kind="cylindrical", locates="none"),
             "x": BearingSeat(shaft="s", position=0.2, kind="four-point", locates="both", radial=False)}  # fmt: skip
    assert slope_excess(bent, seats, {}) == pytest.approx(bent.slope(0.0) / BEARING_SLOPES["cylindrical"])
    assert slope_excess(bent, seats, {"g": 0.1}) == pytest.approx(
        max(bent.slope(0.1) / GEAR_SLOPE, bent.slope(0.0) / BEARING_SLOPES["cylindrical"])
    )
    assert (GEAR_SLOPE, BEARING_SLOPES["deep-groove"], BEARING_SLOPES["taper"]) == (0.5e-3, 3e-3, 1.2e-3)
    assert slope_excess(bent, {}, {}) == 0.0
    straight = forces._replace(bends=False)
    assert bend(straight, stretches, STEEL, bore=0.0).slope(0.1) == 0.0
    assert bend(straight, stretches, STEEL, bore=0.0).critical_speed({}, {}) is None
    # A gear of 20 kg in the middle: √(48 E I/(m + 0.486 m_shaft) L³), Rayleigh.
    area = math.pi / 4.0 * (0.04**2 - 0.02**2)
    mass = 20.0 + 17.0 / 35.0 * area * 0.4 * STEEL.density
    expected = math.sqrt(48.0 * rigid / (mass * 0.4**3))
    assert bent.critical_speed({"g": 0.2}, {"g": 20.0}) == pytest.approx(expected, rel=0.01)


def task_of(text, name):
    """Return what a shaft of a design is built from."""
    from gearwright.sizing.loads import shaft_forces

    sizing = sized(text)
    given = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    plan = sizing.arrangement.plans[name]
    forces = shaft_forces(given, name, plan, axes=sizing.arrangement.axes, gears=gears)
    borne = {place: gears[place] for place in plan.places if place in gears}
    joints = {gear: given.design.joints.get(gear, Joint(kind="integral")) for gear in borne}
    joints |= {part: joint for part, joint in given.design.joints.items() if part in plan.places}
    return ShaftTask(given, name, forces, STEEL, borne, None, joints), sizing


def test_what_sits_on_a_shaft_has_its_place_and_its_width():
    task, sizing = task_of(PAIR, "output")
    wheel = next(gear for gear in sizing.gears if gear.name == "helical.wheel")
    items = {item.name: item for item in items_on(task, {})}
    assert list(items) == ["2a", "helical.wheel", "2b"]
    assert [item.width for item in items.values()] == [0.0, wheel.face_width, 0.0]
    assert items["helical.wheel"].middle == 0.09 and items["helical.wheel"].kind == "hub"
    chosen = {name: bearings()[taken.designation] for name, taken in
              ((bearing.name, bearing) for bearing in sizing.bearings) if name in ("2a", "2b")}  # fmt: skip
    assert [item.width for item in items_on(task, chosen) if item.kind == "bearing"] == [
        chosen["2a"].width, chosen["2b"].width,
    ]  # fmt: skip


def test_a_machines_hub_stands_on_the_shaft_and_not_beyond_its_end():
    text = PAIR + '[joints.rotor]\nkind = "spline"\nhub_length_mm = 60\n'
    task, _ = task_of(changed(text, "position_mm = 260", "position_mm = 290"), "output")
    hub = next(item for item in items_on(task, {}) if item.name == "rotor")
    assert (hub.kind, hub.width, hub.middle) == ("hub", 0.06, pytest.approx(0.27))
    seat = seat_of(task, "rotor", 0.01)
    assert (seat.position, seat.hub_length, seat.root, seat.bore, seat.tooth) == (0.29, 0.06, math.inf, 0.01, 0.0)
    flow = task.context.flows["rated"]
    asked = abs(flow.machine_torques["rotor"]) * task.context.design.service.application_factor
    assert seat.torque == pytest.approx(asked)


def test_a_gears_joint_bears_what_its_mesh_does():
    """Torque of the mesh with the application factor, root of its gear, teeth 2.25 m high."""
    task, sizing = task_of(PAIR, "output")
    wheel = next(gear for gear in sizing.gears if gear.name == "helical.wheel")
    seat = seat_of(task, "helical.wheel", 0.02)
    torque = abs(task.context.flows["rated"].meshes["helical"].torques[1])
    assert seat.torque == pytest.approx(torque * task.context.design.service.application_factor)
    assert seat.tooth == pytest.approx(2.25 * wheel.module)
    assert seat.root == pytest.approx(wheel.pitch_diameter - 2.5 * wheel.module)
    assert seat.hub_length == wheel.face_width


def test_halves_of_a_double_helix_are_as_wide_as_both():
    text = changed(PAIR, 'wheel = "output"\n', 'wheel = "output"\nhalves = 2\nmodule_mm = 3\nface_width_mm = 20\n')
    task, sizing = task_of(text, "output")
    wheel = next(gear for gear in sizing.gears if gear.name == "helical.wheel")
    item = next(item for item in items_on(task, {}) if item.name == "helical.wheel")
    assert (wheel.bodies, wheel.face_width, item.width) == (2, 0.02, pytest.approx(0.04))


@pytest.mark.parametrize("text", [PAIR, ROTOR, HELICOPTER])
def test_a_built_shaft_is_the_sum_of_its_steps(text):
    """Mass and inertia of what lies outside of gears, whose discs are counted solid: the bore takes from them, too."""
    sizing = sized(text)
    gears = {gear.name for gear in sizing.gears}
    for built, shaft in zip(sizing.built_shafts, sizing.shafts, strict=True):
        steps = [(step.end - step.start, step.diameter, step.seat in gears) for step in built.steps]
        bore, steel = built.bore, sizing.design.shaft_material
        outside = [(length, 0.0 if gear else d) for length, d, gear in steps]
        masses = [math.pi / 4.0 * (d**2 - bore**2) * length * steel.density for length, d in outside]
        turning = [math.pi / 32.0 * (d**4 - bore**4) * length * steel.density for length, d in outside]
        twist = [32.0 * length / (math.pi * (d**4 - bore**4) * steel.shear_modulus) for length, d, _ in steps]
        assert any(gear for _, _, gear in steps)
        assert shaft.mass == pytest.approx(sum(masses))
        assert shaft.inertia == pytest.approx(sum(turning))
        assert shaft.stiffness == pytest.approx(1.0 / sum(twist))
        assert shaft.diameter == max(d for _, d, gear in steps if not gear)
        assert shaft.bore == built.bore
        stresses = [
            math.hypot(section.bending_moment, section.torque) * 16.0 * section.diameter
            / (math.pi * (section.diameter**4 - bore**4)) * 2.0
            for section in built.sections
        ]  # fmt: skip
        assert shaft.stress == pytest.approx(max(stresses))
        checks = [check for check in sizing.checks if check.part.kind is Kind.SHAFT and check.part.name == shaft.name]
        critical = next((check for check in checks if check.mode == "first critical speed"), None)
        if critical is not None:
            assert critical.limit == pytest.approx(2.0 * abs(sizing.flows["rated"].speeds[shaft.name]))


def test_of_two_ways_to_build_a_shaft_the_lighter_is_taken():
    """Small bores or light bearings first: the bearings that were taken, given, make the same shaft."""
    for text in (PAIR, ROTOR):
        sizing = sized(text)
        own = weight(sizing)
        lines = {bearing.name: f'designation = "{bearing.designation}"' for bearing in sizing.bearings}
        fixed = text
        for name, line in lines.items():
            fixed = fixed.replace(f"[bearings.{name}]\n", f"[bearings.{name}]\n{line}\n")
        assert weight(sized(fixed)) == pytest.approx(own, rel=0.02)


def weight(sizing):
    """Return the mass of shafts and bearings [kg]."""
    return sizing.shaft_mass + sum(bearing.bearing.mass for bearing in sizing.bearings)


def test_a_key_cuts_into_its_hub_and_a_gear_keeps_what_is_left():
    seat = JointSeat("g.wheel", "s", 0.1, hub_length=0.07, root=0.09, torque=300.0, bore=0.0, tooth=0.005)
    for kind, cut in (("key", 0.0038), ("spline", 0.0)):
        joint = Joint(kind=kind)
        assert keyway_depth(joint, 0.05) == cut
        assert size_joint(joint, seat, 0.05, STEEL).rim == pytest.approx((0.02 - cut) / 0.005)
    assert size_joint(Joint(kind="integral"), seat, 0.05, STEEL).rim is None


def test_shares_of_life_reach_only_their_own_cases():
    """A case without a share takes nothing of a bearing's life, however heavy."""
    cases = "[cases.full.engine]\npower_kw = 322\n[cases.boost.engine]\npower_kw = 640\n"
    cases += "[cases.cruise.engine]\npower_kw = 250\n"
    fixed = '[overrides]\n"helical.module_mm" = 3\n"helical.face_width_mm" = 50\n'
    text = changed(PAIR, "power_kw = 322", "power_kw = 640") + fixed + cases
    for name in ("1a", "1b"):
        text = text.replace(f"[bearings.{name}]\n", f'[bearings.{name}]\ndesignation = "NU 210"\n')
    shares = "[service]\nshares = { full = 0.5, cruise = 0.5 }\n"
    text = changed(text, "[service]\n", shares)
    with_boost, without = (
        size(parse(one)) for one in (text, text.replace("[cases.boost.engine]\npower_kw = 640\n", ""))
    )
    lives = [{bearing.name: bearing.life for bearing in sizing.bearings} for sizing in (with_boost, without)]
    for name in ("1a", "1b"):
        assert lives[0][name] == pytest.approx(lives[1][name], rel=1e-9)
