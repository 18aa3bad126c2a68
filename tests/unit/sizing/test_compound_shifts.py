"""Profile shifts of compound sets in what is sized: as of a simple set, and on the common pins of all meshes."""

import math

import pytest

from designs import changed
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.meshes import compound_phases, gear_pairs
from gearwright.dynamics.equations import modes
from gearwright.parts.planetary import even_positions, planet_phases
from gearwright.sizing import pins_of, size
from gearwright.spec import parse

MACHINES = """\
schema = 1
name = "shifted"
level = "concept"
shafts = ["fast", "slow"]
motors.motor = { shaft = "fast", power_kw = 500, speed_rpm = 3000, balances = false }
loads.drum = { shaft = "slow", speed_rpm = 486.486 }
"""
RATED = '[gears]\nrating = "iso6336"\nmaterial = "carburised-9310"\n'
SIMPLE = f"""{MACHINES}{RATED}
[planetaries.set]
sun = "fast"
ring = "ground"
carrier = "slow"
planets = 3
sun_teeth = 18
planet_teeth = 36
ring_teeth = 93
module_mm = 5
face_width_mm = 60
sun_shift = 0.389
planet_shift = 0.504
ring_shift = 0.117
"""
COMPOUND = f"""{MACHINES}{RATED}
[epicyclics.set]
carrier = "slow"
sets = 3
suns.sun = {{ shaft = "fast", teeth = 18, module_mm = 5, face_width_mm = 60, shift = 0.389 }}
rings.ring = {{ shaft = "ground", teeth = 93, shift = 0.117 }}
planets.planet = {{ teeth = 36, meshes = ["sun", "ring"], shift = 0.504 }}
"""
"""18/36/93 with the shifts of the second set of the 5 MW reference gearbox: the ring has three teeth too many."""


def test_a_shifted_set_is_the_same_gearbox_as_a_simple_and_as_a_compound_one():
    """Two ways to write one set: forces, strength, masses and the carrier to rounding."""
    simple, compound = size(parse(SIMPLE)), size(parse(COMPOUND))
    for one, other in zip(simple.meshes, compound.meshes, strict=True):
        for field in ("tangential_force", "radial_force", "centre_distance", "working_pressure_angle",
                      "working_diameter", "bending_margin", "contact_margin"):  # fmt: skip
            assert getattr(other, field) == pytest.approx(getattr(one, field), rel=1e-12)
    gears = {gear.name: gear for gear in compound.gears}
    for gear in simple.gears:
        for field in ("mass", "inertia", "profile_shift", "tip_alteration", "rim"):
            assert getattr(gears[gear.name], field) == pytest.approx(getattr(gear, field), rel=1e-12)
    for field in ("tangential_force", "radial_force", "pin_force", "radius", "mass"):
        assert getattr(compound.carriers[0], field) == pytest.approx(getattr(simple.carriers[0], field), rel=1e-12)
    one, other = (ratios(sizing) for sizing in (simple, compound))
    assert other == pytest.approx(one, rel=1e-9)


def ratios(sizing):
    """Return every judged check, in an order of its own; "planets apart" is one of simple sets only."""
    judged = [check for check in sizing.checks if check.ratio is not None and check.mode != "planets apart"]
    order = sorted(judged, key=lambda check: (str(check.part), check.mode, check.ratio))
    return {f"{k} {check.part} {check.mode} {check.clause}": check.ratio for k, check in enumerate(order)}


def test_a_shifted_set_moves_alike_as_a_simple_and_as_a_compound_one():
    """Natural frequencies of the two models, and the phases of Parker & Lin with the working angles of both meshes."""
    simple, compound = size(parse(SIMPLE)), size(parse(COMPOUND))
    one, other = (modes(assemble(sizing)).frequency for sizing in (simple, compound))
    assert sorted(other) == pytest.approx(sorted(one), rel=1e-9, abs=1e-3)
    pairs = gear_pairs(compound)
    wanted = planet_phases(pairs["set.sun-planet"], pairs["set.planet-ring"], even_positions(3))
    found = compound_phases(compound, compound.reference, "set")
    for row, phases in (("set.sun-planet", wanted.sun), ("set.planet-ring", wanted.ring)):
        for phase, expected in zip(found[row], phases, strict=True):
            assert abs((phase - expected + 0.5) % 1.0 - 0.5) < 1e-9


def involute_sum(teeth: int, centre: float, angle: float = 20.0) -> float:
    """Return x_1 + x_2 by hand: (z_1 + z_2)(inv α_w − inv α)/(2 tan α), cos α_w = (z_1 + z_2)/2 cos α/a."""
    alpha = math.radians(angle)
    working = math.acos(abs(teeth) / 2.0 * math.cos(alpha) / centre)
    return teeth * (math.tan(working) - working - math.tan(alpha) + alpha) / (2.0 * math.tan(alpha))


STEPPED = """\
schema = 1
name = "stepped"
level = "concept"
shafts = ["fast", "slow", "cage"]
motors.motor = { shaft = "fast", power_kw = 5, speed_rpm = 3000, balances = false }
loads.drum = { shaft = "slow", speed_rpm = 19.2308 }
[epicyclics.set]
carrier = "cage"
sets = 3
suns.sun = { shaft = "fast", teeth = 18, module_mm = 2, face_width_mm = 30 }
rings.held = { shaft = "ground", teeth = 90 }
rings.turned = { shaft = "slow", teeth = 78, module_mm = 2.2, face_width_mm = 40 }
planets.wide = { teeth = 36, meshes = ["sun", "held"] }
planets.narrow = { teeth = 30, meshes = ["turned"], in_one_piece_with = "wide" }
[gears]
mesh_efficiency = 0.99
"""
"""Wide and narrow want their pin at 54 and 52.8 mm: (18 + 36) 2/2, (90 - 36) 2/2 and (78 - 30) 2.2/2."""


@pytest.mark.parametrize("rule", ["", 'balanced_shifts = "sliding"\n', 'balanced_shifts = "strength"\n'])
def test_every_mesh_of_a_stepped_planet_closes_on_one_pin_circle(rule):
    """On the mean of 54, 54 and 52.8 mm, by the involute equation at all three meshes, without backlash."""
    sizing = size(parse(STEPPED + rule))
    gears = {gear.own: gear for gear in sizing.gears}
    shift = {name: gear.profile_shift for name, gear in gears.items()}
    assert shift["sun"] + shift["wide"] == pytest.approx(involute_sum(54, 53.6 / 2.0), abs=1e-9)
    assert shift["wide"] + shift["held"] == pytest.approx(involute_sum(36 - 90, 53.6 / 2.0), abs=1e-9)
    assert shift["narrow"] + shift["turned"] == pytest.approx(involute_sum(30 - 78, 53.6 / 2.2), abs=1e-9)
    for mesh in sizing.meshes:
        assert mesh.centre_distance == pytest.approx(53.6e-3, rel=1e-12)
        assert abs(gear_pairs(sizing)[mesh.name].backlash) < 1e-9
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes}
    pins = pins_of(sizing.design.epicyclics["set"], gears, centres)
    assert [abs(place) for place in pins.values()] == pytest.approx([53.6e-3])
    assert sizing.carriers[0].radius == pytest.approx(53.6e-3)
    assert assemble(sizing).labels.lines


def test_mesh_forces_of_a_stepped_planet_stand_at_its_working_circles():
    """F_t = T/r_w with r_w = a_w z_s/(z_s + z_p), and both steps hold the pin in balance: the carrier is free."""
    sizing = size(parse(changed(STEPPED, "mesh_efficiency = 0.99", "")))
    meshes = {mesh.own: mesh for mesh in sizing.meshes}
    torque = sizing.reference.meshes["set.sun-wide"].torques[0]
    assert meshes["sun-wide"].tangential_force == pytest.approx(abs(torque) / 3.0 / (53.6e-3 * 18.0 / 54.0))
    assert meshes["narrow-turned"].working_diameter == pytest.approx(2.0 * 53.6e-3 * 30.0 / 48.0)
    assert sizing.carriers[0].tangential_force == pytest.approx(0.0, abs=1e-6 * meshes["wide-held"].tangential_force)
    outwards = [
        meshes["sun-wide"].radial_force,
        -meshes["wide-held"].radial_force,
        -meshes["narrow-turned"].radial_force,
    ]
    assert sizing.carriers[0].radial_force == pytest.approx(sum(outwards), rel=1e-12)


RAVIGNEAUX = """\
schema = 1
name = "Ravigneaux"
level = "concept"
shafts = ["in", "out", "idle"]
motors.engine = { shaft = "in", power_kw = 50, speed_rpm = 3000, balances = false }
loads.load = { shaft = "out", speed_rpm = 1285.71 }
layout.idle.diameter_mm = 20
[epicyclics.set]
carrier = "ground"
suns.small = { shaft = "in", teeth = 36, module_mm = 2, face_width_mm = 30, shift = 0.3 }
suns.large = { shaft = "idle", teeth = 42 }
rings.ring = { shaft = "out", teeth = 84 }
planets.short = { teeth = 21, meshes = ["small", "long"], shift = 0.2 }
planets.long = { teeth = 21, meshes = ["large", "ring"], shift = 0.4 }
"""


def test_planets_that_mesh_stand_where_their_shifts_close():
    """By hand: both pins and the distance between them from inv α_w = inv α + 2 tan α Σx/Σz, and the cosine rule."""
    sizing = size(parse(RAVIGNEAUX))
    gears = {gear.own: gear for gear in sizing.gears}
    centres = {mesh.own: mesh.centre_distance for mesh in sizing.meshes}
    pins = pins_of(sizing.design.epicyclics["set"], gears, centres)
    assert involute_sum(57, 1e3 * abs(pins["short"]) / 2.0) == pytest.approx(0.5)
    assert involute_sum(42, 1e3 * abs(pins["short"] - pins["long"]) / 2.0) == pytest.approx(0.6)
    assert gears["large"].profile_shift == gears["ring"].profile_shift == -0.4
    assert abs(pins["long"]) == 63e-3
    assert gears["long"].tip_alteration == pytest.approx(1e3 * abs(pins["short"] - pins["long"]) / 2.0 - 21.0 - 0.6)
    assert all(abs(gear_pairs(sizing)[mesh.name].backlash) < 1e-9 for mesh in sizing.meshes)
    assert assemble(sizing).labels.lines
