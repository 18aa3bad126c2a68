"""What chapter 4 of Pulvirenti (2023) reads off its figures, measured in a dynamic window."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics import Samples
from gearwright.identity import Row, mesh_part
from gearwright.mission.windows import DynamicWindow

SETTLED = 0.5
"""Time of a window before which a steady phase may still ring from its start [s]."""
CLIMB_ENDS = 6.0
"""End of the climb in the window of take-off [s]."""
FIRST = 3.0
"""The first seconds of a second-order pitch, as the thesis counts them [s]."""
REST = 0.5
"""Time about a change of power in which shafts and governor answer to it [s]."""


class Torques(NamedTuple):
    """Torques of In-Line H2 against time [N m], shape (instants,)."""

    turbine: Floats
    """On the first sun, in the input shaft."""
    motor: Floats
    """In the motor's shaft."""
    carrier: Floats
    """In the shaft from the first carrier to the second sun."""
    output: Floats
    """From the second carrier to the propeller."""
    propeller: Floats
    """That the air takes."""
    ideal: Floats
    """Of turbine and motor, by the ratios of the teeth."""


def torques(window: DynamicWindow, samples: Samples) -> Torques:
    """Return the torques of a window.

    Args:
        window: Of In-Line H2.
        samples: Its evenly spaced instants, or its end at every step.
    """
    speeds = dict(zip(window.system.labels.coordinates, np.abs(window.system.arrays.speed), strict=True))
    machines = ("gas-turbine", "electric")
    ideals = [samples.drive(f"{name} torque") * speeds[name] / speeds["propeller"] for name in machines]
    turbine, motor, carrier, output = (
        samples.force(f"{name} shaft") for name in ("input", "electric", "intermediate", "output")
    )
    return Torques(turbine, motor, carrier, output, np.abs(samples.drive("propeller torque")), ideals[0] + ideals[1])


def steady(window: DynamicWindow) -> Torques:
    """Return the torques at a window's end, every step.

    Args:
        window: Of In-Line H2.
    """
    return torques(window, window.trace.windows[-1])


def mesh_means(window: DynamicWindow, stage: str) -> Floats:
    """Return the mean force of each sun-planet mesh of a stage behind the start's ringing [N], shape (planets,).

    Args:
        window: Of In-Line H2.
        stage: ``first`` or ``second``.
    """
    force = window.trace.force
    late = force.edges[:-1] >= SETTLED
    names = window.trace.labels.lines_of(mesh_part(stage, Row.SUN_PLANET))
    return np.array([float(np.mean(force.of(name)["mean"][late])) for name in names])


def mesh_swing(window: DynamicWindow, stage: str) -> float:
    """Return the swing of the sun-planet forces of a stage at a window's end, greatest less least [N].

    Args:
        window: Of In-Line H2.
        stage: ``first`` or ``second``.
    """
    samples = window.trace.windows[-1]
    names = samples.labels.lines_of(mesh_part(stage, Row.SUN_PLANET))
    return max(float(np.ptp(samples.force(name))) for name in names)


def off_ideal(window: DynamicWindow) -> float:
    """Return the largest difference of output and ideal torque at a window's end [-].

    Args:
        window: Of In-Line H2.
    """
    end = steady(window)
    return float(np.max(np.abs(end.output / end.ideal - 1.0)))


def mean_off_ideal(window: DynamicWindow) -> float:
    """Return the mean absolute difference of output and ideal torque at a window's end [-].

    Args:
        window: Of In-Line H2.
    """
    end = steady(window)
    return float(np.mean(np.abs(end.output / end.ideal - 1.0)))


def propeller_off_ideal(window: DynamicWindow, start: float, end: float) -> Floats:
    """Return the difference of the propeller's and the ideal torque in a part of a window [-], shape (instants,).

    Args:
        window: Of In-Line H2.
        start: [s].
        end: [s].
    """
    flown, time = torques(window, window.trace.samples), window.trace.samples.time
    part = (time >= start) & (time <= end)
    return np.asarray(np.abs(flown.propeller[part] / flown.ideal[part] - 1.0))


def output_swing(window: DynamicWindow) -> float:
    """Return the swing of the output torque at a window's end over the ideal one [-].

    Args:
        window: Of In-Line H2.
    """
    end = steady(window)
    return float(np.ptp(end.output) / np.mean(end.ideal))


def pitch(window: DynamicWindow) -> Floats:
    """Return the propeller's pitch [rad], shape (instants,).

    Args:
        window: With a propeller of that name.
    """
    return window.trace.samples.drive("propeller pitch")


def overshoot(window: DynamicWindow) -> float:
    """Return how far the pitch goes beyond its last value [°].

    Args:
        window: With a propeller of that name.
    """
    angle = pitch(window)
    return float(np.degrees(np.max(angle) - angle[-1]))


def departure_from_line(window: DynamicWindow) -> float:
    """Return the largest departure of a stage-one force from a straight line over the climb, over its rise [-].

    Args:
        window: Of the climb.
    """
    force, mean = window.trace.force, window.trace.force.of("first.sun-planet-1")["mean"]
    middle = 0.5 * (force.edges[1:] + force.edges[:-1])
    part = (middle > REST) & (middle < CLIMB_ENDS - REST)
    line = np.polyval(np.polyfit(middle[part], mean[part], 1), middle[part])
    return float(np.max(np.abs(mean[part] - line)) / np.ptp(mean[part]))
