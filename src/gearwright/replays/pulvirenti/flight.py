"""The dynamic model of Pulvirenti (2023) as printed, and measures of the figures in chapter 4."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics import Samples, System, simulate
from gearwright.dynamics.equations import statics
from gearwright.dynamics.model import Arrays
from gearwright.identity import Kind, PartId, Role, Row, gear_part, mesh_part
from gearwright.mission.windows import DynamicWindow, window_outputs
from gearwright.sizing import Sizing

# ----------------------------------------------------------------------------------------------------------------------
# The dynamic model of Pulvirenti (2023) as it is printed: every departure from the right one is a change of its own.
#
# Chapter 4 is judged with all of them; one at a time they tell which makes which number.
# ----------------------------------------------------------------------------------------------------------------------


DAMPING = 0.1
"""eps of (3.13), (3.29) and (3.30), as the thesis prints it [-]."""
PROPELLER_INERTIA = 100.0
"""I_prop of the appendix, Inertia.m [kg m²]."""
CARRIER = 5.0
"""Numerator over π of the carriers' inertia in the appendix, Inertia.m; (3.11) has 4.5 [-]."""
_MESHES = (Row.SUN_PLANET, Row.PLANET_RING)

Change = Callable[[System, Sizing], System]
"""From a system and the sizing that it was assembled from."""


@dataclass(frozen=True)
class Printed:
    """One place in which the printed model differs from the right one."""

    equation: str
    """Where it is printed."""
    words: str
    """What is printed, in our words."""
    change: Change
    """Makes it of the right system."""


def in_phase(system: System, sizing: Sizing) -> System:
    """Return a system whose planets mesh all at once, as (3.34) has it where z_s is a multiple of N − 1.

    Args:
        system: With planetary sets.
        sizing: Of it.
    """
    return spaced(system, sizing, lambda planets: 0.0)


def spaced(system: System, sizing: Sizing, spacing: Callable[[int], float]) -> System:
    """Return a system in which each planet of a set follows the one before by an angle.

    Args:
        system: With planetary sets.
        sizing: Of it.
        spacing: Number of planets -> angle between neighbours [rad].
    """
    for stage, planetary in sizing.design.planetaries.items():
        for row in _MESHES:
            angle = sizing.teeth[str(gear_part(stage, Role.SUN))] * spacing(planetary.planets)
            system = _followed(system, mesh_part(stage, row), angle)
    return system


def square_wave(system: System, sizing: Sizing) -> System:
    """Return a system whose mesh stiffness is the cut square wave of (3.35), each line in the phase that it has.

    Args:
        system: With planetary sets and varying stiffness.
        sizing: Of it.
    """
    series = system.arrays.variation
    cosine, sine = series.cosine.copy(), series.sine.copy()
    for first, last in zip(series.start[:-1], series.start[1:], strict=True):
        if last > first:
            phase = math.atan2(-cosine[first], sine[first]) if cosine[first] or sine[first] else 0.0
            order = np.arange(1, last - first + 1)
            wave = np.where(order % 2 == 1, 1.0 / (math.pi * order), 0.0)
            cosine[first:last], sine[first:last] = -wave * np.sin(order * phase), wave * np.cos(order * phase)
    return replace(system, arrays=system.arrays._replace(variation=series._replace(cosine=cosine, sine=sine)))


def summed_stiffness(system: System, sizing: Sizing) -> System:
    """Return a system in which every mesh has the stiffness of all planets together, as (3.26) sums it.

    Args:
        system: With planetary sets.
        sizing: Of it.
    """
    stiffness, damping = system.arrays.stiffness.copy(), system.arrays.damping.copy()
    for stage, planetary in sizing.design.planetaries.items():
        for row in _MESHES:
            lines = list(system.labels.places_of(mesh_part(stage, row)))
            stiffness[lines] *= planetary.planets
            damping[lines] *= math.sqrt(planetary.planets)
    return replace(system, arrays=system.arrays._replace(stiffness=stiffness, damping=damping))


def printed_damping(system: System, sizing: Sizing) -> System:
    """Return a system damped by 2 eps √(K m), with masses [kg] also where inertias belong: (3.13), (3.29), (3.30).

    Args:
        system: With planetary sets.
        sizing: Of it.
    """
    arrays, labels = system.arrays, system.labels
    damping = arrays.damping.copy()
    masses = {gear.name: gear.mass for gear in sizing.gears}
    for stage in sizing.design.planetaries:
        sun, planet = (masses[str(gear_part(stage, role))] for role in (Role.SUN, Role.PLANET))
        for row, mass in zip(_MESHES, (sun * planet / (sun + planet), planet), strict=True):
            lines = list(labels.places_of(mesh_part(stage, row)))
            damping[lines] = 2.0 * DAMPING * np.sqrt(arrays.stiffness[lines] * mass)
    for shaft in sizing.shafts:
        lines = [line for line, name in enumerate(labels.lines) if name == f"{shaft.name} shaft"]
        damping[lines] = 2.0 * DAMPING * np.sqrt(arrays.stiffness[lines] * shaft.mass)
    return replace(system, arrays=system.arrays._replace(damping=damping))


def relative_planets(system: System, sizing: Sizing) -> System:
    """Return a system whose planets' spin inertia is tied to their angle relative to the carrier, as Fig. 3.9 has it.

    The coordinate of a planet becomes θ_c − θ_p, with a diagonal mass matrix; right would be J_p (θ̇_c − θ̇_rel)²/2.

    Args:
        system: With planetary sets.
        sizing: Of it.
    """
    arrays, places = system.arrays, _places(system)
    weight, speed = arrays.line_weight.copy(), arrays.speed.copy()
    for stage, planetary in sizing.design.planetaries.items():
        carrier = places[f"{stage}.{Kind.CARRIER}"]
        for number in range(1, planetary.planets + 1):
            planet = places[f"{gear_part(stage, Role.PLANET)}-{number}"]
            speed[planet] = speed[carrier] - speed[planet]
            for at in _weights(arrays):
                if planet in at:
                    weight[at[carrier]] += weight[at[planet]]
                    weight[at[planet]] *= -1.0
    return replace(system, arrays=system.arrays._replace(line_weight=weight, speed=speed))


def _weights(arrays: Arrays) -> Iterator[Mapping[int, int]]:
    """Yield coordinate -> place of its weight, line by line."""
    for first, last in pairwise(arrays.line_start.tolist()):
        yield {int(arrays.line_dof[place]): place for place in range(first, last)}


def printed_rotors(system: System, sizing: Sizing) -> System:
    """Return a system with the appendix's I_prop of 100 kg m², and its I_GT of m d²/2 where a disc has m d²/8.

    Args:
        system: With propeller and gas turbine.
        sizing: Of it.
    """
    mass, places = system.arrays.mass.copy(), _places(system)
    mass[places["propeller"]] = PROPELLER_INERTIA
    mass[places["gas-turbine"]] *= 4.0
    return replace(system, arrays=system.arrays._replace(mass=mass))


def printed_carriers(system: System, sizing: Sizing) -> System:
    """Return a system whose carriers have the inertias that the appendix's formula gives as a number [kg m²].

    Args:
        system: With planetary sets.
        sizing: Of it.
    """
    mass, places = system.arrays.mass.copy(), _places(system)
    for stage, inertia in _carriers(sizing).items():
        mass[places[f"{stage}.{Kind.CARRIER}"]] = inertia
    return replace(system, arrays=system.arrays._replace(mass=mass))


def _places(system: System) -> Mapping[str, int]:
    return {name: place for place, name in enumerate(system.labels.coordinates)}


def _carriers(sizing: Sizing) -> Mapping[str, float]:
    """Return stage -> 5 π/(256 τ²) N b d_s² (d_s + d_p)² [kg m²], b that of stage 1 in mm, as the appendix has it."""
    gears = {gear.name: gear for gear in sizing.gears}
    width = 1e3 * gears[str(gear_part("first", Role.SUN))].face_width
    found = dict[str, float]()
    for stage, planetary in sizing.design.planetaries.items():
        sun, planet, ring = (gears[str(gear_part(stage, role))] for role in (Role.SUN, Role.PLANET, Role.RING))
        ratio = 1.0 + ring.teeth / sun.teeth
        arms = sun.pitch_diameter**2 * (sun.pitch_diameter + planet.pitch_diameter) ** 2
        found[stage] = CARRIER * math.pi / (256.0 * ratio**2) * planetary.planets * width * arms
    return found


PRINTED: Sequence[Printed] = (
    Printed("(3.35)", "a square wave of ± a quarter of the stiffness, cut at its fifth harmonic", square_wave),
    Printed("(3.34)", "planets 360°/(N − 1) apart, z_s a multiple of N − 1: all in phase", in_phase),
    Printed("(3.41), figure 3.9", "a planet's inertia turns with its angle relative to the carrier", relative_planets),
    Printed("appendix, Inertia.m", "I_prop = 100 kg m², and I_GT with d for r", printed_rotors),
)  # fmt: skip
"""Departures that have a value as they are printed: chapter 4 is flown with all of them."""
UNITLESS: Sequence[Printed] = (
    Printed("(3.26)", "each mesh has the stiffness of all planets together", summed_stiffness),
    Printed("(3.13), (3.29), (3.30)", "damping of 2 eps √(K m), kilograms for inertias", printed_damping),
    Printed("appendix, Inertia.m", "carriers of 5 π N b d_s² (d_s + d_p)²/(256 τ²), b of stage 1 in mm",
            printed_carriers),
)  # fmt: skip
"""Departures whose units do not fit, or which may be meant otherwise: they are flown on top, one at a time."""


def as_printed(window: DynamicWindow, sizing: Sizing) -> DynamicWindow:
    """Return a window flown again with the printed model.

    Args:
        window: As it should be.
        sizing: Of the flight.
    """
    return reflown(window, sizing, [printed.change for printed in PRINTED])


def reflown(
    window: DynamicWindow, sizing: Sizing, changes: Sequence[Change], *, duration: float | None = None
) -> DynamicWindow:
    """Return a window flown again, with a changed system.

    Args:
        window: As flown.
        sizing: Of the flight.
        changes: One after another.
        duration: [s]; left out: that of the window.
    """
    rules = window.rules if duration is None else window.rules.model_copy(update={"duration": duration})
    system = window.system
    for change in changes:
        system = change(system, sizing)
    start = statics(system, balance="accelerate").position
    trace = simulate(system, rules.duration, start=(start, np.zeros_like(start)), outputs=window_outputs(system, rules))
    return replace(window, rules=rules, system=system, trace=trace)


def _followed(system: System, row: PartId, angle: float) -> System:
    """Return a system in which each line of a row follows the one before by a mesh phase [rad]."""
    series = system.arrays.variation
    lines = system.labels.places_of(row)
    cosine, sine = series.cosine.copy(), series.sine.copy()
    first = slice(series.start[lines[0]], series.start[lines[0] + 1])
    wave = series.cosine[first] - 1j * series.sine[first]
    for number, line in enumerate(lines):
        turned = wave * np.exp(1j * number * angle * np.arange(1, len(wave) + 1))
        part = slice(series.start[line], series.start[line + 1])
        cosine[part], sine[part] = turned.real, -turned.imag
    return replace(system, arrays=system.arrays._replace(variation=series._replace(cosine=cosine, sine=sine)))


# ----------------------------------------------------------------------------------------------------------------------
# What chapter 4 of Pulvirenti (2023) reads off its figures, measured in a dynamic window.
# ----------------------------------------------------------------------------------------------------------------------


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
