"""The thesis's hybrid gearbox in motion: what Pulvirenti 2023, chapter 4, states of it, and what must hold besides."""

from __future__ import annotations

import numpy as np
import pytest

from gearwright.dynamics import Outputs, modes, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.shipped import shipped_design
from gearwright.sizing import Sizing, size
from gearwright.spec import edited, read
from gearwright.train import PowerFlow


@pytest.fixture(scope="module")
def sizing() -> Sizing:
    return size(read(shipped_design("in-line-h2")))


def ideal_torque(sizing: Sizing) -> float:
    """Pulvirenti 2023, eq. (2.65): [T_GT (1 + z_r1/z_s1) + T_EM] (1 + z_r2/z_s2), in cruise."""
    torque, teeth = sizing.flows["cruise"].machine_torques, sizing.teeth
    first, second = (1.0 + teeth[f"{stage}.ring"] / teeth[f"{stage}.sun"] for stage in ("first", "second"))
    return (torque["gas-turbine"] * first + torque["electric"]) * second


@pytest.mark.parametrize(("stiffness", "most"), [("constant", 1e-6), ("varying", 0.003)])
def test_the_mean_output_torque_in_cruise_is_the_ideal_one(sizing: Sizing, stiffness: str, most: float) -> None:
    """Pulvirenti 2023, figure 4.5: less than 0.3 %; a conservative model in equilibrium has no deviation at all."""
    system = assemble(sizing, "cruise", stiffness=stiffness)
    trace = simulate(system, 0.1, outputs=Outputs(start=0.025))
    mean = float(trace.force.of("output shaft")["mean"][0])
    assert mean == pytest.approx(ideal_torque(sizing), rel=most)


def test_stage_forces_stand_in_the_ratio_that_the_teeth_give(sizing: Sizing) -> None:
    """Pulvirenti 2023, figures 4.2 and 4.3 state about 2.5; ours is 2.06 in cruise and 2.78 at rated power.

    F_2/F_1 = (3/5) (T_s2/T_GT) r_s1/r_s2: it follows from the motor's share and from the suns, which the thesis does
    not print; 2.5 lies between our two cases.
    """
    ratio = {
        case: _force(sizing, flow, "second.sun-planet") / _force(sizing, flow, "first.sun-planet")
        for case, flow in sizing.flows.items()
    }
    assert ratio["cruise"] == pytest.approx(2.06, abs=0.005)
    assert ratio["rated"] == pytest.approx(2.78, abs=0.005)


def _force(sizing: Sizing, flow: PowerFlow, row: str) -> float:
    """Return the tangential force of one mesh, 2 λ / (N m) [N]."""
    mesh = next(mesh for mesh in sizing.meshes if mesh.name == row)
    module = next(gear.module for gear in sizing.gears if gear.name == mesh.gears[0])
    return 2.0 * abs(flow.meshes[row].multiplier) / (mesh.count * module)


def test_torques_in_cruise_stand_as_the_thesis_says(sizing: Sizing) -> None:
    """Pulvirenti 2023, figure 4.4: T_EM ≈ 2 T_GT, T_C1 ≈ 6 T_GT ≈ 3 T_EM, T_C2 > 20 T_GT."""
    flow = sizing.flows["cruise"]
    turbine, motor = flow.machine_torques["gas-turbine"], flow.machine_torques["electric"]
    sun_2 = -flow.meshes["second.sun-planet"].torques[0]
    assert motor / turbine == pytest.approx(2.0, rel=1e-3)
    assert sun_2 / turbine == pytest.approx(6.44, abs=0.01)
    assert sun_2 / motor == pytest.approx(3.22, abs=0.01)
    assert -flow.machine_torques["propeller"] / turbine == pytest.approx(23.7, abs=0.1)


@pytest.mark.parametrize("mode", [1, 3, 5, 9, 14])
def test_a_mode_swings_at_its_natural_frequency(sizing: Sizing, mode: int) -> None:
    """Time response against eigenvalues within 0.1 %: released in a mode's shape, undamped, zero crossings counted."""
    design = edited(sizing.design, {"dynamics.mesh_damping": 0.0, "dynamics.shaft_damping": 0.0})
    system = assemble(size(design), "cruise", stiffness="constant")
    found = modes(system)
    frequency, shape = float(found.frequency[mode]), found.shapes[:, mode]
    shape = shape / np.abs(shape).max() * 1e-4
    still = simulate(system, 1e-4, outputs=Outputs(samples=2)).samples.position[0]
    periods = 25.0
    trace = simulate(
        system, periods / frequency, step=0.01 / frequency, start=(still + shape, np.zeros_like(shape)),
        outputs=Outputs(samples=4000),
    )  # fmt: skip
    place = int(np.argmax(np.abs(shape)))
    motion = trace.samples.position[:, place] - still[place]
    signs = np.flatnonzero(np.diff(np.signbit(motion)))
    part = motion[signs] / (motion[signs] - motion[signs + 1])
    crossings = trace.samples.time[signs] + part * np.diff(trace.samples.time)[signs]
    measured = (len(crossings) - 1) / 2.0 / (crossings[-1] - crossings[0])
    assert measured == pytest.approx(frequency, rel=1e-3)


@pytest.mark.parametrize("stiffness", ["constant", "varying"])
def test_work_in_is_work_out_and_dissipated_and_stored(sizing: Sizing, stiffness: str) -> None:
    """Within 1e-6 of the work in; parametric work of the changing stiffness is booked as what it is."""
    trace = simulate(assemble(sizing, "cruise", stiffness=stiffness), 0.05)
    work = trace.work
    left = work.driven - work.braked - work.dissipated - work.stored + work.stiffness + work.error + work.frame
    assert abs(left) <= 1e-6 * work.driven


def test_an_optimal_split_makes_the_conventional_gearbox_lighter() -> None:
    """Free of the equal split the gears weigh 39.3 kg instead of 40.4 kg."""
    design = read(shipped_design("in-line"))
    assert size(edited(design, {"teeth.split": "optimal"})).gear_mass == pytest.approx(39.29, abs=0.01)
