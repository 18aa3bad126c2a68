"""Faults in windows against what they must become in limits: no flux, no time, a rigid train."""

from functools import cache

import numpy as np
import pytest

from gearwright.machines import Winding, short_circuit_torque
from gearwright.mission import fly
from gearwright.mission.windows import fly_window
from gearwright.shipped import find_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import WindowRules, read, read_mission

SHORT = {"event": "motor-short-circuit", "back_emf_v": 250.0, "inductance_mh": 0.1, "pole_pairs": 6}


@cache
def thesis():
    """Return the thesis's mission flown by its hybrid."""
    return fly(size(read(find_design("in-line-h2"))), read_mission(shipped_mission("thesis")))


@cache
def flown(**rules):
    """Return half a second of cruise, at constant stiffness, with an event after 0.05 s."""
    given = {"phase": "cruise", "at": 600.0, "duration": 0.5, "event_at": 0.05, "stiffness": "constant"}
    return fly_window(thesis(), "fault", WindowRules(**given | rules))


def test_a_short_circuit_puts_the_torque_of_its_closed_form_on_the_rotor():
    """Straight lines between 32 points of a cycle, and the bins' extremes at steps: 1 %."""
    trace = flown(**SHORT, resistance_ohm=0.01).trace
    rated = thesis().sizing.design.motors["electric"].speed
    torque = trace.drive.of("electric torque")
    speed, before = float(trace.samples.drive("electric speed")[0]), float(torque["mean"][0])
    expected = short_circuit_torque(
        Winding(250.0, 0.1e-3, 0.01, 6, rated), abs(speed), before=before, time=np.linspace(0.0, 0.45, 100_000)
    )
    assert torque["minimum"].min() == pytest.approx(expected.min(), rel=1e-2)
    assert torque["maximum"].max() == pytest.approx(expected.max(), rel=1e-2)
    assert torque["mean"][-1] == pytest.approx(expected[-1], rel=1e-2)
    assert trace.work.imbalance < 1e-5


def test_a_short_circuit_without_flux_is_a_motor_cut():
    """Torque falls at once; the cut takes a microsecond. 1e-3 of the torque: one line between two points."""
    cut = flown(event="motor-cut", over=1e-6).trace
    short = flown(**SHORT | {"back_emf_v": 0.0}).trace
    assert short.drive.of("electric torque")["mean"][-1] == 0.0
    for line in ("electric shaft", "output shaft"):
        assert short.force.of(line)["mean"] == pytest.approx(
            cut.force.of(line)["mean"], abs=1e-3 * np.abs(cut.force.of(line)["mean"]).max()
        )


def test_a_window_names_the_peak_of_every_mesh_and_shaft_beside_what_they_are_sized_for():
    """The shaft of a machine carries what its statistics say; margins fall as torque rises."""
    window = flown(**SHORT)
    assert {load.mesh for load in window.meshes} == {mesh.name for mesh in thesis().sizing.meshes}
    shaft = next(load for load in window.shafts if load.shaft == "input")
    history, sized = window.trace.force.of("input shaft"), thesis().sizing.shafts[0]
    assert shaft.peak_torque == max(history["maximum"].max(), -history["minimum"].min())
    assert shaft.margin == pytest.approx(sized.margin * sized.torque / shaft.peak_torque, rel=1e-12)
