"""Mesh forces as vectors: a flank without friction pushes along its normal, and what it does comes back on its mate."""

import math

import numpy as np
import pytest

import shipped_work
from gearwright.shipped import shipped_designs
from gearwright.sizing.loads import shaft_loads
from gearwright.sizing.rating import context_of
from mounted_designs import PAIR, ROTOR, sized


@pytest.mark.parametrize("name", shipped_designs())
def test_the_three_forces_of_a_mesh_make_the_normal_force_of_its_flank(name):
    """F_t² + F_r² + F_a² = (F_t/(cos α_n cos β))², also of bevel gears at the mean cone: rounding only."""
    sizing = shipped_work.sized(name)
    helix = {gear.name: gear.helix_angle for gear in sizing.gears}
    shifted = {gear.stage for gear in sizing.gears if gear.profile_shift}
    for mesh in sizing.meshes:
        stage = mesh.name.partition(".")[0]
        pair = sizing.design.pairs.get(stage)
        if pair is not None and pair.kind == "face":
            continue
        normal = (
            mesh.tangential_force / math.cos(sizing.design.rules(stage).pressure_angle) / math.cos(helix[mesh.gears[0]])
        )
        if stage in shifted:  # the transverse force leans by the working pressure angle
            normal = math.hypot(mesh.tangential_force / math.cos(mesh.working_pressure_angle), mesh.axial_force)
        forces = (mesh.tangential_force, mesh.radial_force, mesh.axial_force)
        assert math.hypot(*forces) == pytest.approx(normal, rel=1e-9)
        if pair is None or pair.kind == "cylindrical":
            lead = mesh.tangential_force * math.tan(helix[mesh.gears[0]])
            if stage in shifted:  # tan β_w over tan β is r_w over r
                flat = math.tan(sizing.design.rules(stage).pressure_angle) / math.cos(helix[mesh.gears[0]])
                lead *= math.cos(math.atan(flat)) / math.cos(mesh.working_pressure_angle)
            assert mesh.axial_force == pytest.approx(lead, rel=1e-9, abs=1e-9)
            assert mesh.radial_force > 0.0 or not mesh.tangential_force


def point_loads(sizing, shaft):
    """Return the point loads and the axial force on a shaft."""
    given = context_of(sizing.design, sizing.train, sizing.teeth, sizing.flows, sizing.given)
    gears = {gear.name: gear for gear in sizing.gears}
    return shaft_loads(given, shaft, sizing.arrangement.plans[shaft], axes=sizing.arrangement.axes, gears=gears)


def test_what_a_pinion_does_to_its_wheel_the_wheel_does_to_its_pinion():
    """One single-helical pair: forces across and along sum to nothing over both shafts, and the wheel's torque over the
    pinion's is 107/27. Rounding only.
    """
    sizing = sized(PAIR)
    (first, thrust), (second, back) = (point_loads(sizing, shaft) for shaft in ("input", "output"))
    assert first.force.sum(axis=-1) == pytest.approx(-second.force.sum(axis=-1), rel=1e-9)
    assert np.abs(first.force).max() > 1e3 and np.abs(thrust).min() > 1e2
    assert thrust == pytest.approx(-back, rel=1e-9)


@pytest.mark.parametrize("shaft", ["input", "output"])
def test_the_force_on_a_helical_tooth_stands_square_to_its_trace(shaft):
    """On a right-hand helix the trace turns with the sense of a right-hand screw: r φ = x tan β. No friction: no force
    along it. The pinion turns forwards and has a right-hand helix, its wheel the other way and a left-hand one.
    """
    sizing = sized(PAIR)
    _, axial = point_loads(sizing, shaft)
    gear = next(gear for gear in sizing.gears if shaft in gear.shafts)
    speed = sizing.flows["rated"].speeds[shaft]
    torque = next(flow.torques[0 if shaft == "input" else 1] for flow in sizing.flows["rated"].meshes.values())
    tangential = torque / (gear.pitch_diameter / 2.0)
    trace = np.array([math.cos(gear.helix_angle), math.copysign(1.0, speed) * math.sin(gear.helix_angle)])
    factor = sizing.meshes[0].load_factor
    assert np.array([axial[0], tangential * factor]) @ trace == pytest.approx(0.0, abs=1e-6)
    # A driving right-hand helix that turns forwards is pushed towards its second end: it is held back by its mate.
    assert axial[0] * (1.0 if shaft == "input" else -1.0) > 0.0


def test_a_rotor_pulls_its_shaft_out_of_the_gearbox():
    """8 kN of thrust, the rotor beyond the second bearing: what the bearings must hold grows by them, to that side."""
    with_rotor, without = (
        next(shaft.axial_force for shaft in sized(text).shafts if shaft.name == "output") for text in (ROTOR, PAIR)
    )
    assert with_rotor - without == pytest.approx(8e3, rel=1e-6)
