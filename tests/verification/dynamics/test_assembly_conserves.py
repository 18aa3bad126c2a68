"""What an assembly must keep, whatever its train: inertia, energy, the passing of the teeth, springs in series."""

import cmath
import math

import numpy as np
import pytest
from scipy.integrate import quad

from gearwright.catalogue import materials
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.assembly.assemble import pin_stiffness
from gearwright.dynamics.equations import line_state
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing import size
from gearwright.spec import parse


def sized(name, more=""):
    return size(parse(f"{shipped_design(name).read_text(encoding='utf-8')}\n{more}"))


def turning_parts(sizing):
    """Yield inertia and speed of every part that turns; planets, with their bearings, about themselves and the axis."""
    speeds = next(iter(sizing.flows.values())).speeds
    yield from ((shaft.inertia, speeds[shaft.name]) for shaft in sizing.shafts)
    if sizing.design.dynamics.machines == "inertia":
        yield from ((machine.inertia, speeds[machine.shaft]) for machine in sizing.machines)
    for carrier in sizing.carriers:
        if carrier.shaft in speeds and carrier.shaft != "ground":
            planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role == "planet"]
            carried = sum(gear.bodies * gear.turning_mass * place(sizing, gear, carrier) ** 2 for gear in planets)
            yield carrier.inertia + carried, speeds[carrier.shaft]
    for gear in sizing.gears:
        nodes = [name for name in gear.shafts if name != "ground"]
        yield from ((gear.turning_inertia * gear.bodies / len(nodes), speeds[node]) for node in nodes)


def place(sizing, planet, carrier):
    """Return how far from the axis a planet turns; in a compound set by a sun or ring that it meshes with."""
    if planet.stage in sizing.design.planetaries:
        return carrier.radius
    mates = {name for mesh in sizing.train.meshes if planet.name in mesh.gears for name in mesh.gears}
    central = next(gear for gear in sizing.gears if gear.name in mates and gear.role != "planet")
    return (central.pitch_diameter + (1.0 if central.role == "sun" else -1.0) * planet.pitch_diameter) / 2.0


@pytest.mark.parametrize("name", shipped_designs())
def test_the_bodies_of_a_system_have_the_inertia_and_the_energy_of_the_parts_that_turn(name):
    """Nothing is counted twice and nothing is left out: Σ J and ½ Σ J ω², to rounding."""
    sizing = sized(name)
    system = assemble(sizing, next(iter(sizing.flows)))
    turns = np.array(system.labels.coordinate_units) == "rad"
    mass, rate = system.arrays.mass[turns], system.arrays.speed[turns]
    inertia, speed = np.array(list(turning_parts(sizing))).T
    assert np.sum(mass) == pytest.approx(np.sum(inertia), rel=1e-12)
    assert np.sum(mass * rate**2) == pytest.approx(np.sum(inertia * speed**2), rel=1e-12)


def parallel_rows(sizing):
    """Yield the shared gear's shaft and the meshes around it, for each stage with several."""
    for stage in sizing.design.pairs:
        row = [mesh for mesh in sizing.train.meshes if mesh.stage == stage]
        if len(row) > 1:
            yield (0 if len({mesh.nodes[0] for mesh in row}) == 1 else 1), row


@pytest.mark.parametrize("name", ["off-set", "off-set-h1", "off-set-h2", "off-set-h3", "twin-engine-sprag"])
def test_a_tooth_of_a_shared_gear_brings_to_its_second_mesh_what_the_first_one_felt(name):
    """Parallel meshes are one mesh seen later: by the angle between them in the sense of turning, over the speed.

    The stiffness of each mesh over ten cycles, read from the system; 1e-9 is the rounding of thousands of radians.
    """
    sizing = sized(name)
    system = assemble(sizing, "rated", stiffness="varying")
    axis = {shaft.name: complex(*shaft.axis) for shaft in sizing.shafts}
    zero, lopsided = np.zeros(len(system.labels.coordinates)), 0
    for shared, row in parallel_rows(sizing):
        speed = sizing.flows["rated"].speeds[row[0].nodes[shared]]
        seen = [axis[mesh.nodes[1 - shared]] - axis[mesh.nodes[shared]] for mesh in row]
        cycle = 2.0 * math.pi / (sizing.teeth[row[0].gears[shared]] * abs(speed))
        lines = [system.labels.lines.index(mesh.name) for mesh in row]
        for place, line in zip(seen[1:], lines[1:], strict=True):
            turn = math.copysign(1.0, speed) * cmath.phase(place / seen[0])
            later = turn / abs(speed)
            lopsided += min(2.0 * later / cycle % 1.0, -2.0 * later / cycle % 1.0) > 0.01
            for time in np.linspace(0.0, cycle, 7):
                before = line_state(system.arrays, time, zero, zero).stiffness[lines[0]]
                after = line_state(system.arrays, time + later, zero, zero).stiffness[line]
                assert after == pytest.approx(before, rel=1e-9)
    # Where all stand opposite each other, a wrong sense would look the same.
    assert lopsided or name == "twin-engine-sprag"


def test_a_clutch_is_as_soft_as_the_softer_of_the_shafts_that_it_joins():
    """Two shafts of 1 and 3 units of compliance: what joins them is no stiffer than the weaker one, and no softer."""
    sizing = sized("twin-engine-sprag")
    system = assemble(sizing, "rated")
    stiffness = {shaft.name: shaft.stiffness for shaft in sizing.shafts}
    ends = [(stiffness[joint.driving], stiffness[joint.driven]) for joint in sizing.train.joints]
    clutches = [
        system.arrays.stiffness[system.labels.lines.index(f"{joint.name} clutch")] for joint in sizing.train.joints
    ]
    assert clutches == [one if one < other else other for one, other in ends]
    assert all(one != other for one, other in ends)


@pytest.mark.parametrize("stage", ["first", "second"])
def test_a_pin_gives_way_as_the_bending_energy_of_a_cantilever_says(stage):
    """Castigliano: δ = ∫ M²/(E I F) dx with M = F x over half of the planet's width; the integral to 1e-9."""
    sizing = sized("in-line-h2", '[dynamics]\nfidelity = "translational"')
    width = next(gear.face_width for gear in sizing.gears if gear.name == f"{stage}.planet")
    diameter = next(carrier.pin_diameter for carrier in sizing.carriers if carrier.stage == stage)
    modulus = materials()[sizing.design.rules(stage).material].elastic_modulus
    # Of a circle of radius 1 and a beam of length 1, in strips.
    area_moment, _ = quad(lambda angle: 2.0 * (math.sin(angle) * math.cos(angle)) ** 2, -math.pi / 2.0, math.pi / 2.0)
    bending, _ = quad(lambda x: x**2, 0.0, 1.0)
    expected = modulus * area_moment * (diameter / 2.0) ** 4 / (bending * (width / 2.0) ** 3)
    assert pin_stiffness(sizing, stage) == pytest.approx(expected, rel=1e-9)
