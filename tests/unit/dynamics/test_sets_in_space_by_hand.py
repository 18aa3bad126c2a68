"""Planetary sets as rigid bodies in space, frames that turn, and what is recorded of drives."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest
from test_planetary import model_of, planetary

from gearwright.dynamics.assembly.meshes import planet_bodies, planet_body, set_directions
from gearwright.dynamics.model import Model
from gearwright.dynamics.model.elements import ClutchDrive, MachineDrive, drive_columns
from gearwright.identity import Kind
from gearwright.train import EXTERNAL
from shipped_work import sized

MESHES = ("sun-planet", "planet-ring", "pin")
ANGLES = (math.radians(23.0), math.radians(18.0))
ARM = (0.04 + 0.05) / math.cos(ANGLES[0])
"""Radius of the pins at which sun and planet roll; the ring's base radius follows."""


def shifted(flank, **changes):
    """A set whose sun meshes at another angle than its ring, its planets anywhere."""
    base = planetary(positions=(0.3, 2.1, 4.4), pressure_angles=ANGLES, flank=flank)
    ring = replace(base.ring, radius=0.05 + ARM * math.cos(ANGLES[1]))
    return replace(base, ring=ring, carrier=replace(base.carrier, radius=ARM), **changes)


def deflections(model, motion):
    """Return what the meshes and the pins deflect in a motion of the coordinates."""
    lines = [line for line in model.lines if any(part in line.name for part in MESHES)]
    return [sum(weight * motion[name] for name, weight in line.weights.items()) for line in lines]


@pytest.mark.parametrize("flank", [1, -1])
def test_a_set_that_moves_as_one_body_strains_no_tooth_and_no_pin(flank):
    """It goes aside as a whole, or turns as a whole: a planet's pin then goes along, r_c θ."""
    given_set = shifted(flank)
    model = model_of(given_set)
    aside, turned = {}, {}
    for member in ("sun", "ring", "carrier"):
        aside |= {member: 0.0, f"{member}.x": 2.0, f"{member}.y": -3.0}
        turned |= {member: 1.0, f"{member}.x": 0.0, f"{member}.y": 0.0}
    for number, psi in enumerate(given_set.positions, start=1):
        planet = f"planet-{number}"
        aside |= {planet: 0.0, f"{planet}.radial": 2.0 * math.cos(psi) - 3.0 * math.sin(psi)}
        aside[f"{planet}.tangential"] = -2.0 * math.sin(psi) - 3.0 * math.cos(psi)
        turned |= {planet: 1.0, f"{planet}.radial": 0.0, f"{planet}.tangential": ARM}
    assert len(deflections(model, aside)) == 4 * 3
    assert deflections(model, aside) == pytest.approx([0.0] * 12, abs=1e-14)
    assert deflections(model, turned) == pytest.approx([0.0] * 12, abs=1e-14)


@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize("member", ["sun", "ring"])
def test_an_eccentric_gear_is_one_that_stands_aside_in_a_direction_that_turns(member, flank):
    """δ = d·q − e(φ): the error is what the centre's way around does to the line, φ from the carrier's y axis."""
    base = shifted(flank)
    given_set = replace(base, **{member: replace(getattr(base, member), run_out=1e-5)})
    row = "sun-planet" if member == "sun" else "planet-ring"
    lines = [line for line in model_of(given_set).lines if line.name.startswith(row)]
    assert len(lines) == 3
    for line in lines:
        (error,) = line.errors
        assert dict(error.phase) == {member: 1, "carrier": -1}
        cosine, sine = error.harmonics()
        for phase in (0.0, 0.7, 2.9, 5.1):
            value = error.constant + cosine[0] * math.cos(phase) + sine[0] * math.sin(phase)
            way = line.weights[f"{member}.x"] * math.cos(phase) + line.weights[f"{member}.y"] * math.sin(phase)
            assert -value == pytest.approx(1e-5 * way, abs=1e-17)


def test_a_free_mass_flies_straight_on_as_seen_from_a_frame_that_turns():
    """r(t) = R(−Ω t)(a + v t) solves M q̈ + G q̇ − C q = 0 with the frame's own Coriolis and centripetal terms."""
    model, speed = Model(), 3.0
    model.rotation("clock", inertia=1.0, speed=speed)
    for name in ("x", "y"):
        model.translation(name, mass=2.0)
        model.support(f"{name} spring", name, stiffness=1.0)
    model.rotating_frame("x", "y", speed=speed)
    arrays = model.build().arrays
    coriolis, centripetal = np.zeros((3, 3)), np.zeros((3, 3))
    np.add.at(coriolis, (arrays.gyroscopic.row, arrays.gyroscopic.column), arrays.gyroscopic.value)
    np.add.at(centripetal, (arrays.centripetal.row, arrays.centripetal.column), arrays.centripetal.value)
    start, velocity = 0.4 - 0.2j, -1.3 + 0.8j
    for time in (0.0, 0.3, 1.1):
        turn, spin = np.exp(-1j * speed * time), -1j * speed
        at = start + velocity * time
        place, pace = at * turn, (velocity + spin * at) * turn
        push = (2.0 * spin * velocity + spin**2 * at) * turn
        left = arrays.mass * np.array([0.0, push.real, push.imag])
        left = left + coriolis @ [0.0, pace.real, pace.imag] - centripetal @ [0.0, place.real, place.imag]
        assert left == pytest.approx(np.zeros(3), abs=1e-12)


def test_what_is_recorded_of_a_drive_belongs_to_its_machine_or_clutch():
    machine, clutch = MachineDrive("turbine", "sun", 10.0, 100.0), ClutchDrive("sprag", "sun", "ring", 1e5, 10.0, 300.0)
    columns = [(column.name, column.owner.part.kind, column.unit) for column in drive_columns((machine, clutch))]
    assert columns == [
        ("sprag twist", Kind.CLUTCH, "rad"),
        ("turbine torque", Kind.MACHINE, "N m"),
        ("turbine speed", Kind.MACHINE, "rad/s"),
        ("turbine limited", Kind.MACHINE, "-"),
        ("sprag torque", Kind.CLUTCH, "N m"),
        ("sprag slip", Kind.CLUTCH, "rad/s"),
        ("sprag slipping", Kind.CLUTCH, "-"),
    ]


@pytest.mark.parametrize("name", ["ravigneaux-automatic", "wolfrom-reducer"])
def test_compound_sets_are_numbered_forwards_and_mesh_where_their_planets_stand(name):
    """Set k + 1 stands 2π k/N ahead of the first; teeth that mesh are r_1 + r_2 apart, with a ring r_2 − r_1."""
    sizing = sized(name)
    for stage, epicyclic in sizing.design.epicyclics.items():
        bodies = {str(body.part): body.place for body in planet_bodies(sizing, stage)}
        firsts = [place for part, place in bodies.items() if part.endswith("-1")]
        assert len(bodies) == epicyclic.sets * len(firsts)
        for part, place in bodies.items():
            number = int(part.rpartition("-")[2])
            turn = cmath.rect(1.0, 2.0 * math.pi * (number - 1) / epicyclic.sets)
            assert min(abs(place - first * turn) for first in firsts) < 1e-12
        for mesh in (mesh for mesh in sizing.train.meshes if mesh.stage == stage):
            gears = [next(gear for gear in sizing.gears if gear.name == end) for end in mesh.gears]
            centre = next(row.centre_distance for row in sizing.meshes if row.name == mesh.name)
            for number, direction, places in set_directions(sizing, mesh):
                ends = [0j, 0j]
                for k in places:
                    ends[k] = bodies[str(planet_body(sizing, gears[k].part, number))]
                assert abs(ends[1] - ends[0]) == pytest.approx(centre)
                for k, place in places.items():
                    assert place == pytest.approx(ends[k] / abs(ends[k]))
                away = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
                assert direction / abs(direction) == pytest.approx(away if mesh.sign == EXTERNAL else -away)
