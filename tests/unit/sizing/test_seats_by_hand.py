"""What bearings bear, as the shafts are sized and put together of unit torques; pins and rotors by hand."""

import math

import numpy as np
import pytest
from shaft_designs import ASKEW, INTERNAL, OFF_SET, SINGLE_HELIX, WITH_MOTOR

from designs import HYBRID, PAIR, changed
from gearwright.parts.shafts import diagram, supported
from gearwright.sizing import size
from gearwright.sizing.bearing_seats import bearing_seats, seat_forces
from gearwright.sizing.loads import shaft_forces
from gearwright.sizing.rating import context_of
from gearwright.spec import parse
from mounted_designs import HELICOPTER, ROTOR, sized

UNEVEN = "mesh_load_factor = 1.3\n"


def seats(sizing):
    """Return seat -> its radial force, and the meshes' force along its shaft, in the rated case [N]."""
    flow = sizing.reference
    torques = np.array([flow.meshes[mesh.name].torques[0] / mesh.count for mesh in sizing.train.meshes])
    found = {}
    for seat in bearing_seats(sizing):
        radial, axial = seat_forces(seat, torques, np.array(flow.speeds[seat.carrier]))
        found[seat.name] = (float(radial), float(axial))
    return found


def context(sizing):
    """Return what sizing reads, anew."""
    return context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)


@pytest.mark.parametrize("text", [OFF_SET, ASKEW, SINGLE_HELIX, WITH_MOTOR, INTERNAL, SINGLE_HELIX + UNEVEN])
def test_unit_torques_make_up_what_the_shafts_were_sized_for(text):
    """The reactions of a shaft grow in proportion to the torques of its meshes."""
    sizing = size(parse(text))
    found = seats(sizing)
    tried = 0
    for shaft in sizing.shafts:
        for end, bearing in zip(("first", "second"), shaft.bearings, strict=False):
            radial, axial = found[f"{shaft.name}.{end}"]
            assert radial == pytest.approx(math.hypot(*bearing.force), rel=1e-9, abs=1e-6)
            assert axial == pytest.approx(shaft.axial_force, rel=1e-9, abs=1e-6)
            tried += 1
    assert tried == len(found) > 0


@pytest.mark.parametrize("text", [ROTOR, HELICOPTER])
def test_seats_of_built_shafts_bear_the_meshes_and_the_rotor_at_its_worst(text):
    """A rotor may point anywhere: what it puts on a bearing is added to what the meshes do."""
    sizing = sized(text)
    found, given = seats(sizing), context(sizing)
    sides = {seat.name: seat.rotor_side for seat in bearing_seats(sizing)}
    gears = {gear.name: gear for gear in sizing.gears}
    for shaft, plan in sizing.arrangement.plans.items():
        forces = shaft_forces(given, shaft, plan, axes=sizing.arrangement.axes, gears=gears)
        rotors = [rotor for rotor in sizing.design.airscrews.values() if rotor.shaft == shaft]
        radial = iter(forces.largest_radial()[0])
        for name, seat in plan.seats.items():
            bears = next(radial) if seat.radial else 0.0
            assert found[name][0] == pytest.approx(bears, rel=1e-9, abs=1e-6), name
            side = sides[name]
            thrust = sum(side * rotor.thrust for rotor in rotors)
            assert found[name][1] + thrust == pytest.approx(forces.axial[0], rel=1e-9, abs=1e-6)
            assert abs(side) == (1.0 if rotors else 0.0)


def test_a_pin_bears_both_meshes_and_the_planet_that_swings():
    """2 F_t along the path, K_γ on it, and m r ω² across; inside it a rim of 3.95 m is left."""
    text = HYBRID.replace("[cases", f"[gears]\n{UNEVEN}[cases", 1)
    sizing = size(parse(text))
    found = seats(sizing)
    gears = {gear.name: gear for gear in sizing.gears}
    for name in ("first", "second"):
        planet, stage = gears[f"{name}.planet"], sizing.design.planetaries[name]
        mesh = next(mesh for mesh in sizing.meshes if mesh.stage == name)
        radius = (gears[f"{name}.sun"].pitch_diameter + planet.pitch_diameter) / 2.0
        swung = planet.mass * radius * sizing.reference.speeds[stage.carrier] ** 2
        torque = abs(sizing.reference.meshes[mesh.name].torques[0]) / stage.planets
        tangential = 1.3 * 2.0 * torque / gears[f"{name}.sun"].pitch_diameter
        seat = next(seat for seat in bearing_seats(sizing) if seat.name == f"{name}.planet")
        assert found[seat.name][0] == pytest.approx(math.hypot(2.0 * tangential, swung), rel=1e-9)
        assert seat.room == pytest.approx(planet.pitch_diameter - 2.0 * 3.95 * planet.module)
        assert seat.count == stage.planets and seat.carrier == stage.carrier
        carrier = next(carrier for carrier in sizing.carriers if carrier.stage == name)
        assert seat.bore == carrier.pin_diameter and seat.nodes == (stage.carrier, planet.name)


def test_shifted_teeth_push_a_planet_outwards_by_their_unequal_angles():
    """(sin α_ws − sin α_wr)/(cos α_ws + cos α_wr) of the sum of both tangential forces."""
    given = "sun_teeth = 25\nplanet_teeth = 31\nring_teeth = 86\nsun_shift = 0.3\nplanet_shift = -0.1\n"
    sizing = size(parse(changed(HYBRID, "planets = 3\n", f"planets = 3\n{given}")))
    angles = [mesh.working_pressure_angle for mesh in sizing.meshes if mesh.stage == "first"]
    assert angles[0] != pytest.approx(angles[1], rel=1e-3)
    push = (math.sin(angles[0]) - math.sin(angles[1])) / (math.cos(angles[0]) + math.cos(angles[1]))
    seat = next(seat for seat in bearing_seats(sizing) if seat.name == "first.planet")
    across, along = seat.forward[:, 1], seat.forward[:, 0]
    assert across[along != 0.0] == pytest.approx(push * along[along != 0.0])


def test_no_seat_is_made_of_what_bears_nothing():
    """Shafts of planetary sets carry torque only: a seat in every planet, none on a shaft."""
    assert sorted(seats(size(parse(HYBRID)))) == ["first.planet", "second.planet"]
    assert sorted(seats(size(parse(PAIR)))) == ["fast.first", "fast.second", "slow.first", "slow.second"]


def test_a_rotor_points_where_it_bends_its_shaft_most():
    """Every direction in steps of a degree: none bends the shaft more, at any of its stations."""
    sizing = sized(ROTOR)
    given, plan = context(sizing), sizing.arrangement.plans["output"]
    gears = {gear.name: gear for gear in sizing.gears}
    forces = shaft_forces(given, "output", plan, axes=sizing.arrangement.axes, gears=gears)
    meshes, rotor = (part.loads for part in forces.apart)
    most = np.hypot(forces.drawn.bending[:, 0], forces.drawn.bending[:, 1]).max()
    by_hand = 0.0
    for angle in np.linspace(0.0, 2.0 * np.pi, 361):
        turn = np.array([math.cos(angle), math.sin(angle)])[None, :, None]
        position = np.append(meshes.position[:-2], rotor.position[-3])
        force = np.concatenate([meshes.force[..., :-2], rotor.force[:, :1, -3:-2] * turn], axis=-1)
        couple = np.concatenate([meshes.couple[..., :-2], rotor.couple[:, :1, -3:-2] * turn], axis=-1)
        torque = np.append(meshes.torque[..., :-2], np.zeros((1, 1)), axis=-1)
        loads = type(meshes)(position, force, couple, torque)
        bent = diagram(supported(loads, plan.bearings, length=plan.length)).bending
        by_hand = max(by_hand, np.hypot(bent[:, 0], bent[:, 1]).max())
    assert most == pytest.approx(by_hand, rel=1e-4)
