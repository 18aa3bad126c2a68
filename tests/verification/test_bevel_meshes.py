"""Bevel meshes inside a train: both shafts feel the same force, and the dynamic model carries the statics' torque."""

import math

import numpy as np
import pytest

from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.parts.bevel_geometry import Hand, Rotation, bevel_forces
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.rating import context_of
from gearwright.spec import edited, read

DESIGN = read(shipped_design("ec120b"))
SIZING = size(DESIGN)


def loads_on(sizing, shaft):
    """Return the point loads of the bevel gear on a shaft (force y, z; couple; torque; all axial force), first case."""
    given = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    plan, axes = sizing.arrangement.plans[shaft], sizing.arrangement.axes
    loads, axial = shaft_loads(given, shaft, plan, axes=axes, gears={gear.name: gear for gear in sizing.gears})
    name = next(each for each in plan.places if each.startswith("bevel."))
    k = int(np.argmin(np.abs(loads.position - plan.places[name])))
    return loads.force[0, :, k], loads.couple[0, :, k], loads.torque[0, k], axial[0]


def test_both_shafts_of_a_bevel_mesh_feel_one_force():
    """Same length of the force in space; F_a of one is F_r of the other on square axes (ISO 23509); rounding only."""
    pair = next(mesh for mesh in SIZING.meshes if mesh.name == "bevel").rating.factors.virtual.bevel
    torque = SIZING.reference.meshes["bevel"].torques[0]
    forces = bevel_forces(pair, abs(torque), hand=Hand.LEFT, rotation=Rotation.CLOCKWISE)
    lengths = []
    for shaft, side in (("intermediate", 0), ("mast", 1)):
        across, couple, _, _ = loads_on(SIZING, shaft)
        radius = pair.mean_diameters[side] / 2.0
        axial = math.hypot(*couple) / radius
        assert axial == pytest.approx(abs(forces.axial[side]), rel=1e-9)
        assert math.hypot(*across) == pytest.approx(math.hypot(forces.tangential, forces.radial[side]), rel=1e-9)
        lengths.append(math.hypot(*across, axial))
    assert lengths[0] == pytest.approx(lengths[1], rel=1e-9)
    assert forces.axial[0] == pytest.approx(forces.radial[1], rel=1e-9)


def test_the_bevel_wheel_turns_its_shaft_with_the_torque_of_the_power_flow():
    across, _, torque, _ = loads_on(SIZING, "mast")
    assert torque == pytest.approx(SIZING.reference.meshes["bevel"].torques[1], rel=1e-12)
    assert math.hypot(*across) > 0.0


def test_helical_and_bevel_gears_on_one_shaft_push_against_each_other_wherever_the_apex_lies():
    for apex in ("first", "second"):
        sizing = size(edited(DESIGN, {"pairs.bevel.pinion_apex": apex, **_without_bearings()}))
        shaft = next(each for each in sizing.shafts if each.name == "intermediate")
        bevel = next(mesh for mesh in sizing.meshes if mesh.name == "bevel").axial_force
        helical = next(mesh for mesh in sizing.meshes if mesh.name == "helical").axial_force
        assert abs(shaft.axial_force) == pytest.approx(bevel - helical, rel=1e-6)


def _without_bearings():
    return {"bearings": {}, "joints": {}}


def test_the_dynamic_model_of_a_bevel_train_is_at_rest_under_the_torques_of_the_power_flow():
    """The lines' weights are base radii at the mean cones: rotations by the train's speeds deflect no mesh."""
    system = assemble(SIZING)
    found = modes(system)
    assert found.frequency[0] == pytest.approx(0.0, abs=1e-3)
    assert found.frequency[1] > 0.1
