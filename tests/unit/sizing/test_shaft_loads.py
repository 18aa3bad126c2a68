"""Mesh forces on a shaft as vectors in space."""

import math

import numpy as np
import pytest
from shaft_designs import INTERNAL, OFF_SET, SINGLE_HELIX, sized

from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.rating import context_of


def loads_on(text, shaft):
    """Return point loads, axial forces, plan, axes and the sizing."""
    sizing = sized(text)
    given = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    plan, axes = sizing.arrangement.plans[shaft], sizing.arrangement.axes
    loads, axial = shaft_loads(given, shaft, plan, axes=axes, gears={gear.name: gear for gear in sizing.gears})
    return loads, axial, plan, axes, sizing


@pytest.mark.parametrize(
    ("text", "outward", "uneven"),
    [(SINGLE_HELIX, -1.0, 1.0), (INTERNAL, 1.0, 1.0), (SINGLE_HELIX + "mesh_load_factor = 1.3\n", -1.0, 1.3)],
)
def test_a_mesh_force_stands_square_to_the_teeth_and_turns_its_shaft(text, outward, uneven):
    """Force and lever as vectors: r × F gives K_γ times the torque, and couples; F has no part along the tooth.

    The radial part is F_t tan α_n / cos β, outwards on a ring. Closed forms; rounding only.
    """
    loads, axial, _, axes, sizing = loads_on(text, "output")
    gear = sizing.gears[-1]
    radius = gear.pitch_diameter / 2.0
    mate = next(axes[mesh.nodes[0]] for mesh in sizing.train.meshes if mesh.nodes[1] == "output")
    first = next(k for k, force in enumerate(loads.force[0, 0]) if force != 0.0)
    force = loads.force[0, 0, first] + 1j * loads.force[0, 1, first]
    normal = (mate - axes["output"]) / abs(mate - axes["output"])
    radial, tangential = (force / normal).real, (force / normal).imag
    assert tangential * radius == pytest.approx(uneven * loads.torque[0, first])
    slope = math.tan(sizing.design.gears.pressure_angle) / math.cos(gear.helix_angle)
    assert radial == pytest.approx(outward * abs(tangential) * slope)
    meshes = np.count_nonzero(loads.force[0, 0])
    hand = math.copysign(1.0, sizing.flows["rated"].speeds["output"])
    assert axial[0] / meshes == pytest.approx(-hand * tangential * math.tan(gear.helix_angle))
    couple = loads.couple[0, 0, first] + 1j * loads.couple[0, 1, first]
    assert couple == pytest.approx(-normal * radius * axial[0] / meshes)


def test_the_halves_of_a_double_helix_share_force_and_torque_and_leave_no_thrust():
    """Two halves, a face width apart, each with half; their axial forces meet in the gear."""
    loads, axial, plan, _, sizing = loads_on(OFF_SET, "input")
    gear = sizing.gears[0]
    halves = loads.position[loads.force[0, 0] != 0.0]
    assert sorted(set(halves)) == pytest.approx([plan.places[gear.name] - gear.face_width / 2.0,
                                                 plan.places[gear.name] + gear.face_width / 2.0])  # fmt: skip
    assert axial[0] == 0.0 and not loads.couple.any()
    assert loads.torque[0].sum() == pytest.approx(0.0, abs=1e-9)


def test_driven_and_driving_helices_on_a_layshaft_push_against_each_other():
    """All helices of a shaft have one hand: the thrust left over is the difference of the two stages, not the sum."""
    loads, axial, _, _, sizing = loads_on(SINGLE_HELIX, "left")
    radii = {gear.name: gear.pitch_diameter / 2.0 for gear in sizing.gears}
    torque = abs(loads.torque[0]).max()
    one, other = (torque / radii[name] * math.tan(math.radians(20.0)) for name in ("first.wheel", "second.pinion"))
    assert abs(axial[0]) == pytest.approx(abs(one - other))
