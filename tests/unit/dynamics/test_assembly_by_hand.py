"""Lines, phases, dampers and assumptions of an assembled design, worked out by hand."""

import cmath
import math

import numpy as np
import pytest

from designs import PAIR, changed
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.assemble import Driving, assumptions
from gearwright.dynamics.assembly.meshes import bodies_of, contacts_of
from gearwright.dynamics.model import ClutchDrive, Line, MachineDrive, Model, Periodic
from gearwright.dynamics.model.elements import DampingRatio, encoded
from gearwright.dynamics.model.model import profile_of
from gearwright.dynamics.model.system import check_structure, envelope, own_groups, stacked
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse, read


def weights_of(system):
    """Return line -> coordinate -> weight."""
    arrays, names = system.arrays, system.labels.coordinates
    ends = zip(system.labels.lines, arrays.line_start, arrays.line_start[1:], strict=False)
    return {
        line: {names[dof]: weight for dof, weight in zip(arrays.line_dof[a:b], arrays.line_weight[a:b], strict=True)}
        for line, a, b in ends
    }  # fmt: skip


@pytest.mark.parametrize("name", ["off-set", "in-line-h2", "star", "mixed", "ec120b"])
def test_a_contact_in_space_turns_its_gears_as_its_line_does(name):
    """Levers of a contact are the weights of its line on the two gears: base radii, signed so that the force is
    positive; and their torques are those of the case."""
    sizing = size(read(shipped_design(name)))
    flow = sizing.reference
    lines, bodies = weights_of(assemble(sizing, flow.case)), bodies_of(sizing)
    for contact in contacts_of(sizing, flow):
        for side in contact.sides:
            assert side.gear in bodies
            if side.gear in lines[contact.line]:
                assert side.lever == pytest.approx(lines[contact.line][side.gear], rel=1e-12)
        assert math.hypot(*contact.direction) == pytest.approx(1.0)
    for mesh in sizing.train.meshes:
        own = [name for name in lines if name == mesh.name or name.startswith(f"{mesh.name}-")]
        first = next(iter(lines[own[0]]))
        radius = next(gear.pitch_diameter / 2.0 for gear in sizing.gears if gear.name == mesh.gears[0])
        push = lines[own[0]][first]
        assert math.copysign(1.0, push) == -math.copysign(1.0, flow.meshes[mesh.name].torques[0])
        gear = next(gear for gear in sizing.gears if gear.name == mesh.gears[0])
        tilt = math.tan(sizing.design.rules(mesh.stage).pressure_angle) / math.cos(gear.helix_angle)
        assert abs(push) == pytest.approx(radius * math.cos(math.atan(tilt)), rel=1e-9)


TWINS = """\
schema = 1
name = "two pinions on a wheel"
level = "concept"
shafts = ["one", "other", "slow"]
[{kind}.drive]
shaft = "{driver}"
power_kw = 100
speed_rpm = {speed}
[propellers.propeller]
shaft = "slow"
speed_rpm = 2000
diameter_m = 2
[motors.second]
shaft = "other"
power_kw = 50
speed_rpm = 6000
[pairs.stage]
pinion = ["one", "other"]
wheel = "slow"
pinion_teeth = 23
wheel_teeth = 69
[gears]
helix_angle_deg = 20
[layout.one]
angle_deg = 0
[layout.other]
angle_deg = 100
"""


@pytest.mark.parametrize("reverse", [False, True])
def test_a_tooth_passes_parallel_meshes_one_after_the_other(reverse):
    """The wheel needs ψ/ω from one pinion to the other, in the sense in which it turns: the second mesh lags by z ψ."""
    text = TWINS.format(kind="motors", driver="one", speed=6000)
    if reverse:
        text = text.replace('shaft = "one"\n', 'shaft = "one"\nreverse = true\n').replace(
            'shaft = "other"\n', 'shaft = "other"\nreverse = true\n'
        )
    sizing = size(parse(text))
    places = sizing.arrangement.axes
    speed = sizing.flows["rated"].speeds["slow"]
    assert (speed > 0.0) == reverse
    turn = cmath.phase((places["other"] - places["slow"]) / (places["one"] - places["slow"]))
    assert abs(math.degrees(turn)) > 10.0
    travel = (turn if speed > 0.0 else -turn) % (2.0 * math.pi)
    system = assemble(sizing, stiffness="varying")
    series = system.arrays.variation
    first, second = (
        complex(series.cosine[at], series.sine[at])
        for at in (series.start[system.labels.lines.index(line)] for line in ("stage.one", "stage.other"))
    )
    lag = cmath.phase(first / second) + 69 * travel
    assert cmath.rect(1.0, lag) == pytest.approx(1.0, abs=1e-9)


CLUTCHED = changed(PAIR, '["fast", "slow"]', '["engine", "fast", "slow"]').replace(
    'shaft = "fast"\npower_kw', 'shaft = "engine"\npower_kw'
)
CLUTCHED += '[clutches.joint]\ndriving = "engine"\ndriven = "fast"\nkind = "engaged"\n'


def test_a_slipping_clutch_is_as_stiff_as_its_softer_shaft_and_damped_by_what_it_joins():
    """c = 2 ζ √(k m), 1/m = 1/J_1 + 1/J_2."""
    sizing = size(parse(CLUTCHED))
    system = assemble(sizing, driving=Driving((), {}, {"joint": 500.0}))
    stiffness = min(shaft.stiffness for shaft in sizing.shafts if shaft.name in ("engine", "fast"))
    plain = assemble(sizing)
    line = plain.labels.lines.index("joint clutch")
    assert plain.arrays.stiffness[line] == pytest.approx(stiffness)
    ends = [plain.labels.coordinates.index(name) for name in weights_of(plain)["joint clutch"]]
    mobility = sum(1.0 / plain.arrays.mass[end] for end in ends)
    damping = 2.0 * sizing.design.dynamics.shaft_damping * math.sqrt(stiffness / mobility)
    assert plain.arrays.damping[line] == pytest.approx(damping)
    assert pytest.approx(stiffness) in system.arrays.drives.table.tolist()
    assert pytest.approx(damping) in system.arrays.drives.table.tolist()
    assert "joint clutch" not in system.labels.lines


def test_a_shaft_that_carries_planets_moves_with_them():
    """Mass of the shaft, of its carrier and of all its planets; in the carrier's frame."""
    text = shipped_design("single-planetary").read_text(encoding="utf-8")
    stage, planetary = next(iter(parse(text).planetaries.items()))
    shaft = planetary.carrier
    sizing = size(parse(f"{text}\n[supports.{shaft}]\nradial_n_um = 200\n"))
    system = assemble(sizing)
    carrier = sizing.carriers[0]
    planet = next(gear for gear in sizing.gears if gear.name == f"{stage}.planet")
    alone = next(sized.mass for sized in sizing.shafts if sized.name == shaft)
    moving = {
        name: mass
        for name, mass, unit in zip(
            system.labels.coordinates, system.arrays.mass, system.labels.coordinate_units, strict=True
        )
        if unit == "m"
    }
    expected = alone + carrier.mass + planet.bodies * planet.mass
    assert moving == {f"{shaft}.y": pytest.approx(expected), f"{shaft}.z": pytest.approx(expected)}


def test_a_given_mesh_stiffness_keeps_the_shape_of_its_curve():
    """Twice the mean is twice every harmonic; a given swing is one cosine."""
    text = PAIR + "pinion_teeth = 23\nwheel_teeth = 69\n"
    plain = assemble(size(parse(text)), stiffness="varying")
    mean = float(plain.arrays.stiffness[plain.labels.lines.index("stage")])
    given = assemble(size(parse(text + f"mesh_stiffness_n_m = {2.0 * mean}\n")), stiffness="varying")
    line = given.labels.lines.index("stage")
    assert given.arrays.stiffness[line] == pytest.approx(2.0 * mean)
    for part in ("cosine", "sine"):
        assert getattr(given.arrays.variation, part) == pytest.approx(getattr(plain.arrays.variation, part))
    assert np.abs(plain.arrays.variation.sine).max() > 1e-3
    swing = assemble(size(parse(text + "stiffness_swing = 0.3\n")), stiffness="varying")
    assert swing.arrays.variation.cosine.tolist() == pytest.approx([0.3])
    assert swing.arrays.variation.sine.tolist() == [0.0]


def told(text, **options):
    """Return subject -> value of every assumption."""
    sizing = size(parse(text))
    return {row.subject: row for row in assumptions(sizing, assemble(sizing, **options))}


def test_assumptions_say_what_the_model_has():
    rows = told(PAIR)
    assert rows["torque of machines"].value == "constant: does not change with speed"
    assert (rows["errors of gears and shafts"].value, rows["errors of gears and shafts"].origin) == (
        "none: as drawn", "default",
    )  # fmt: skip
    assert "harmonics of the mesh frequency kept" not in told(PAIR + '[dynamics]\nstiffness = "constant"\n')
    assert "harmonics of the mesh frequency kept" in told(PAIR + '[dynamics]\nstiffness = "varying"\n')
    wobbling = told(PAIR + '[errors."stage.wheel"]\neccentricity_um = 5\n')
    assert wobbling["errors of gears and shafts"].origin == "given"
    assert rows["bearings and pins"].value == "rigid"
    assert rows["backlash of stage"].value.startswith("none")
    assert told(PAIR + "backlash_um = 120\n")["backlash of stage"].value == "120 µm"
    assert told(PAIR + "backlash_um = 120\n")["backlash of stage"].origin == "given"


def test_a_machine_that_slows_its_shaft_depends_on_speed():
    system = assemble(size(parse(PAIR)))
    sizing = size(parse(PAIR))
    for kind in ("damping", "quadratic"):
        drag = np.zeros_like(getattr(system.arrays.loads, kind))
        drag[0] = 0.5
        loads = system.arrays.loads._replace(**{kind: drag})
        slowed = type(system)(system.arrays._replace(loads=loads), system.labels)
        values = [row.value for row in assumptions(sizing, slowed) if row.subject == "torque of machines"]
        assert values == ["depends on speed"]


def test_a_periodic_quantity_is_smallest_where_its_derivative_says():
    """a cos ψ + b sin ψ ≥ −√(a² + b²), whatever the offset; 64 points of the highest order: 1.2e-3."""
    for a, b, offset in ((0.3, 0.0, 0.0), (0.0, 0.3, 0.7), (0.2, -0.4, 2.0)):
        wave = Periodic({"x": 1}, (a,), (b,), offset=offset, constant=0.1)
        assert wave.minimum() == pytest.approx(0.1 - math.hypot(a, b), abs=1.3e-3 * math.hypot(a, b))
    second = Periodic({"x": 1}, (0.0, 0.2), (0.0, 0.1))
    assert second.minimum() == pytest.approx(-math.hypot(0.2, 0.1), abs=1.3e-3)
    mixed = Periodic({"x": 1}, (0.0,), (0.5, 0.3))
    turn = np.linspace(0.0, 2.0 * np.pi, 20001)
    brute = np.min(0.5 * np.sin(turn) + 0.3 * np.sin(2.0 * turn))
    assert mixed.minimum() == pytest.approx(brute, abs=2e-3)
    assert Periodic(constant=0.25).minimum() == 0.25


def test_harmonics_turn_with_the_offset():
    """a cos(ψ + nδ) + b sin(ψ + nδ), order by order, at any angle."""
    wave = Periodic({"x": 1}, (0.3, 0.1), (0.2,), offset=0.7)
    a, b = wave.harmonics()
    for angle in (0.0, 0.4, 2.5):
        direct = 0.3 * math.cos(angle + 0.7) + 0.2 * math.sin(angle + 0.7) + 0.1 * math.cos(2.0 * (angle + 0.7))
        orders = np.arange(1, 3)
        assert float(a @ np.cos(orders * angle) + b @ np.sin(orders * angle)) == pytest.approx(direct)


def test_damping_by_ratio_is_twice_the_ratio_of_the_critical_one():
    assert DampingRatio(0.05).damper(4e6, 1.0 / 9.0) == pytest.approx(2.0 * 0.05 * math.sqrt(4e6 * 9.0))


def small(**changes):
    """Return the arrays of two discs on a spring, with changes."""
    model = Model()
    model.rotation("a", inertia=1.0, speed=10.0)
    model.rotation("b", inertia=2.0, speed=10.0)
    line = {"stiffness": 1e4, "damping": 0.0, "backlash": 0.0, **changes}
    model.add(Line("spring", {"a": 1.0, "b": -1.0}, **line))
    model.load("a", constant=5.0)
    model.load("b", constant=-5.0)
    return model.build().arrays


@pytest.mark.parametrize("changes", [{"damping": 0.5}, {"backlash": 1e-5}])
def test_systems_of_another_structure_do_not_run_side_by_side(changes):
    """However small: a damper or a dead zone in one of them is another code."""
    check_structure(stacked([small(), small(stiffness=2e4)]))
    with pytest.raises(DesignError, match=r"systems\.1"):
        check_structure(stacked([small(), small(**changes)]))
    both = {**changes, "stiffness": 3e4}
    check_structure(stacked([small(**changes), small(**both)]))


@pytest.mark.parametrize("kind", ["constant", "damping", "quadratic"])
def test_loads_of_another_kind_are_another_structure(kind):
    plain = small()
    values = np.zeros_like(getattr(plain.loads, kind))
    if kind == "constant":
        values = plain.loads.constant * 0.0
    values[0] = 0.5 if kind != "constant" else 0.0
    other = plain._replace(loads=plain.loads._replace(**{kind: values}))
    with pytest.raises(DesignError, match=r"systems\.1"):
        check_structure(stacked([plain, other]))


def test_equal_weights_of_one_system_that_differ_in_another_are_another_structure():
    def pair(first, second):
        model = Model()
        for name in ("a", "b", "c"):
            model.rotation(name, inertia=1.0)
        model.mesh("one", {"a": first, "b": 0.05}, stiffness=1e8)
        model.mesh("two", {"b": 0.05, "c": second}, stiffness=1e8)
        model.bodies[0] = type(model.bodies[0])("a", 1.0, "rad", 10.0, model.bodies[0].owner)
        return model.build().arrays

    check_structure(stacked([pair(0.03, 0.04), pair(0.02, 0.041)]))
    with pytest.raises(DesignError, match=r"systems\.1"):
        check_structure(stacked([pair(0.03, 0.04), pair(0.03, 0.03)]))


def test_the_envelope_of_systems_has_the_largest_of_each():
    members = [
        small(stiffness=2e4, damping=1.0, variation=Periodic({"a": 20}, (0.1,), (0.2,))),
        small(stiffness=1e4, damping=3.0, variation=Periodic({"a": 20}, (0.3,), (0.0,))),
    ]
    widest = envelope(members[0], stacked(members))
    assert widest.stiffness.tolist() == [2e4] and widest.damping.tolist() == [3.0]
    assert widest.variation.cosine.tolist() == pytest.approx([0.3]) and widest.variation.sine.tolist() == [0.0]


def test_a_line_measures_an_angle_only_between_rotations():
    """Shafts, supports and dampers of rotations in rad; meshes and what moves across in m."""
    model = Model()
    for name in ("a", "b"):
        model.rotation(name, inertia=1.0, speed=5.0)
    model.translation("a.y", mass=3.0)
    model.shaft("shaft", "a", "b", stiffness=1e5)
    model.support("held", "a.y", stiffness=1e8)
    model.damper("drag", "a", "b", damping=2.0)
    model.add(Line("other", {"a": 1.0, "b": -1.0}, 1e3))
    units = dict(zip(model.build().labels.lines, model.build().labels.line_units, strict=True))
    assert units == {"shaft": "rad", "held": "m", "drag": "rad", "other": "m"}


def test_a_motor_drives_in_the_sense_in_which_its_shaft_turns():
    drives = [
        MachineDrive("m", "a", 1.0, speed=100.0, slope=2.0, highest_torque=9.0, highest_power=8.0),
        ClutchDrive("c", "a", "b", 1e4, 3.0, 50.0, one_way=True),
        ClutchDrive("d", "b", "a", 1e4, 3.0, 50.0, one_way=False),
    ]
    table = encoded(drives, {"a": 0, "b": 1}, np.array([-5.0, 7.0])).table.tolist()
    assert table[:2] == [3.0, 2.0]
    machine = table[2 : 2 + int(table[2])]
    assert machine[:6] == [13.0, 1.0, 0.0, -5.0, -1.0, 0.0] and machine[8:] == [-1.0, 100.0, 2.0, 9.0, 8.0]
    clutch = table[15 : 15 + int(table[15])]
    assert clutch[:8] == [11.0, 2.0, 0.0, -5.0, 1.0, 7.0, 0.0, 1.0] and clutch[8:] == [1e4, 3.0, 0.0]
    other = table[26:]
    assert other[:8] == [11.0, 2.0, 1.0, 7.0, 0.0, -5.0, 1.0, 2.0] and other[8:] == [1e4, 3.0, -1.0]


def test_losses_hold_each_shaft_against_its_sense():
    """A resistance of 3 N m is −3 N m on a shaft that turns forwards, +3 on one that turns backwards."""
    sizing = size(parse(PAIR))
    system = assemble(sizing, driving=Driving((), {"fast": ((0.0, 3.0), (1.0, 4.0)), "slow": 5.0}, {}))
    schedules, names = system.arrays.loads.schedules, system.labels.coordinates
    held = {
        names[dof]: schedules.value[start:end].tolist()
        for dof, start, end in zip(schedules.dof, schedules.start, schedules.start[1:], strict=False)
    }
    speeds = sizing.flows["rated"].speeds
    assert speeds["fast"] > 0.0 > speeds["slow"]
    assert held == {"stage.pinion": [-3.0, -4.0], "stage.wheel": [5.0]}
    assert not np.any(system.arrays.loads.constant)


def test_clocks_of_systems_differ_where_their_tones_or_profiles_do():
    first, second = small(), small()
    layout, names = (0, 2), ("stiffness", "inertia")
    rows = np.array([[1.0, 2.0, 3.0], [1.0, 5.0, 3.0]])
    alike = stacked([first, second])
    assert own_groups(alike, layout, names, rows) == {"stiffness"}
    profile = second.profile._replace(factor=second.profile.factor * 2.0)
    other = stacked([first, second._replace(profile=profile)])
    assert own_groups(other, layout, names, rows) == {"stiffness", "clock"}


def test_a_speed_profile_travels_by_its_trapezoids_from_where_it_is_held():
    """0.5 before 2 s, then to 1.5 at 4 s and to 1 at 5 s: 1, 1 + 2 and 3 + 1.25 reference seconds."""
    profile = profile_of([(2.0, 0.5), (4.0, 1.5), (5.0, 1.0)])
    assert profile[0].tolist() == [2.0, 4.0, 5.0] and profile[1].tolist() == [0.5, 1.5, 1.0]
    assert profile[2].tolist() == pytest.approx([1.0, 3.0, 4.25])
