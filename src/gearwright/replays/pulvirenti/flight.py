"""The dynamic model of Pulvirenti (2023) as printed, and measures of the figures in chapter 4."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Floats, Kind, PartId, Role, Row, gear_part, mesh_part
from gearwright.dynamics import Arrays, Samples, System, modes, simulate, statics
from gearwright.mission import fly
from gearwright.mission.windows import DynamicWindow, fly_window, window_outputs
from gearwright.replays.pulvirenti.claims import sized
from gearwright.shipped import shipped_mission
from gearwright.sizing import Sizing
from gearwright.spec import read_mission

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


def steady_level(window: DynamicWindow) -> Torques:
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
    end = steady_level(window)
    return float(np.max(np.abs(end.output / end.ideal - 1.0)))


def mean_off_ideal(window: DynamicWindow) -> float:
    """Return the mean absolute difference of output and ideal torque at a window's end [-].

    Args:
        window: Of In-Line H2.
    """
    end = steady_level(window)
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
    end = steady_level(window)
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


# ----------------------------------------------------------------------------------------------------------------------
# Figures 4.2 to 4.23 of Pulvirenti (2023): what the thesis says of each, and what In-Line H2 does in the same window.
#
# Every window is flown with constant and with varying mesh stiffness, as printed and as it should be. A claim is judged
# by the printed model, with the stiffness of its figure.
# ----------------------------------------------------------------------------------------------------------------------


DESIGN, MISSION = "in-line-h2", "thesis-chapter-4"
CONSTANT, VARYING = "constant", "varying"
ROUNDING = 1e-9
"""Swing of a torque over its mean that is none [-]."""

Runs = Mapping[tuple[str, str], DynamicWindow]
"""(Window, stiffness) -> as flown."""
Measure = Callable[[Runs, str], float]
"""From the runs and a stiffness, in the claim's unit."""


@dataclass(frozen=True)
class FlightClaim:
    """One thing that the thesis says of a figure."""

    figure: str
    """Such as ``4.5``."""
    window: str
    """Window of the shipped mission."""
    stiffness: str
    """Of the thesis's figure."""
    says: str
    """In our words."""
    low: float
    """Smallest number that the wording covers, in the unit."""
    high: float
    """Largest one."""
    unit: str
    """Of the numbers; empty for ratios."""
    measure: Measure
    why: str
    """Reason, or what the number is."""
    setting: str = ""
    """What the number hangs on and the thesis does not print; a claim with one cannot be tested as printed."""


class Judgement(StrEnum):
    """What becomes of a claim when the printed model is flown."""

    REPRODUCED = "reproduced"
    NOT_REPRODUCED = "not reproduced"
    NOT_TESTABLE = "not testable as printed"


@dataclass(frozen=True)
class JudgedClaim:
    """A claim and its numbers, with the stiffness of its figure and in its unit."""

    claim: FlightClaim
    printed: float
    """Of the printed model."""
    right: float
    """Of the model as it should be."""

    @property
    def judgement(self) -> Judgement:
        """Whether the wording covers the number of the printed model."""
        if self.claim.setting:
            return Judgement.NOT_TESTABLE
        return Judgement.REPRODUCED if self.covers(self.printed) else Judgement.NOT_REPRODUCED

    def covers(self, value: float) -> bool:
        """Tell whether the claim's wording covers a number.

        Args:
            value: In the claim's unit.
        """
        return self.claim.low <= value <= self.claim.high


@cache
def chapter_runs(duration: float = 10.0) -> Runs:
    """Return every window of the chapter with both stiffnesses, as it should be; takes some 60 s.

    Args:
        duration: Of each window [s]; the climb ends after 6 s.
    """
    flight = fly(sized(DESIGN), read_mission(shipped_mission(MISSION)))
    return {
        (name, stiffness): fly_window(
            flight, name, rules.model_copy(update={"stiffness": stiffness, "duration": duration})
        )
        for name, rules in flight.mission.windows.items()
        for stiffness in (CONSTANT, VARYING)
    }


def printed_runs(runs: Runs) -> Runs:
    """Return the windows flown again with the printed model; takes as long.

    Args:
        runs: Of `chapter_runs`.
    """
    return {key: as_printed(window, sized(DESIGN)) for key, window in runs.items()}


def flight_claims(printed: Runs, right: Runs) -> tuple[JudgedClaim, ...]:
    """Return every claim of the chapter with its numbers.

    Args:
        printed: Of `printed_runs`.
        right: Of `chapter_runs`.
    """
    return tuple(
        JudgedClaim(claim, claim.measure(printed, claim.stiffness), claim.measure(right, claim.stiffness))
        for claim in CLAIMS
    )


def _in(window: str, measure: Callable[[DynamicWindow], float], scale: float = 1.0) -> Measure:
    return lambda runs, stiffness: scale * measure(runs[window, stiffness])


def _percent(window: str, measure: Callable[[DynamicWindow], float]) -> Measure:
    return _in(window, measure, 100.0)


def _swing(stage: str) -> Callable[[DynamicWindow], float]:
    return lambda window: mesh_swing(window, stage) / float(np.mean(mesh_means(window, stage)))


def _ratio(window: DynamicWindow) -> float:
    second, first = (float(np.mean(mesh_means(window, stage))) for stage in ("second", "first"))
    return second / first


def _torque_ratio(upper: str, lower: str) -> Callable[[DynamicWindow], float]:
    def ratio(window: DynamicWindow) -> float:
        steady = steady_level(window)
        return float(np.mean(getattr(steady, upper)) / np.mean(getattr(steady, lower)))

    return ratio


def _swings(name: str) -> Callable[[DynamicWindow], float]:
    def swings(window: DynamicWindow) -> float:
        steady = steady_level(window)
        turbine = float(np.ptp(steady.turbine))
        return (
            float(np.ptp(getattr(steady, name))) / turbine
            if turbine > ROUNDING * float(np.mean(steady.turbine))
            else 0.0
        )

    return swings


def _pitch_range(window: DynamicWindow) -> float:
    return float(np.degrees(np.ptp(pitch(window))))


def _late_pitch(runs: Runs, stiffness: str) -> float:
    climb, cruise = (pitch(runs[name, stiffness])[-1] for name in ("take-off", "cruise"))
    return float(np.degrees(abs(climb - cruise)))


def _beside_constant(stage: str, window: str) -> Measure:
    def beside(runs: Runs, stiffness: str) -> float:
        means = [float(np.mean(mesh_means(runs[window, kind], stage))) for kind in (stiffness, CONSTANT)]
        return 100.0 * abs(means[0] / means[1] - 1.0)

    return beside


def _stage_one_in_taxi(window: DynamicWindow) -> float:
    first, second = (mesh_means(window, stage) for stage in ("first", "second"))
    return float(np.max(np.abs(first)) / np.mean(second))


def _idle_turbine(window: DynamicWindow) -> float:
    steady = steady_level(window)
    return float(abs(np.mean(steady.turbine)) / np.mean(steady.motor))


def _between(start: float, end: float) -> Callable[[DynamicWindow], float]:
    return lambda window: float(np.max(propeller_off_ideal(window, start, end)))


def _climbing(window: DynamicWindow) -> float:
    start, end = REST, CLIMB_ENDS - REST
    return float(np.mean(propeller_off_ideal(window, start, end)))


_NO_LOSS = "The train has no losses and its machines are sources of torque, so that equilibrium is the ratio itself"
_STAGES = "A torque 3.87 times as large meets a sun 1.88 times as large; see the claims of the first sizing"
_SHARE = "the motor's share of the power, which sets it"
_KICK = "the actuator's numbers and what disturbs it"
_PACE = "the time that the climb takes: half of it doubles the number"
_TEETH = "Square wave and planets in phase together; as they are placed, fluctuations cancel (table below)"
_C, _V, _T = CONSTANT, VARYING, "take-off"

CLAIMS: Sequence[FlightClaim] = (
    FlightClaim("4.2", "cruise", _C, "stage-1 sun forces are constant: swing over mean", 0, 0.01, "%",
                _percent("cruise", _swing("first")), "Constant stiffness leaves nothing that excites"),
    FlightClaim("4.3", "cruise", _C, "stage-2 forces are about 2.5 times those of stage 1", 2.25, 2.75, "",
                _in("cruise", _ratio), _STAGES, _SHARE),
    FlightClaim("4.4", "cruise", _C, "motor over turbine torque about 2", 1.8, 2.2, "",
                _in("cruise", _torque_ratio("motor", "turbine")), "The motor gives 31 % of the power here", _SHARE),
    FlightClaim("4.4", "cruise", _C, "carrier 1 over turbine about 6", 5.5, 6.5, "",
                _in("cruise", _torque_ratio("carrier", "turbine")), "Ratio of stage 1 plus the motor's part", _SHARE),
    FlightClaim("4.4", "cruise", _C, "output over turbine above 20", 20, np.inf, "",
                _in("cruise", _torque_ratio("output", "turbine")), "Follows from the speeds and the motor's share",
                _SHARE),
    FlightClaim("4.5", "cruise", _C, "output against ideal torque below 0.3 %", 0, 0.3, "%",
                _percent("cruise", off_ideal), _NO_LOSS),
    FlightClaim("4.6", "cruise", _C, "pitch of first order is constant: range", 0, 0.01, "°",
                _in("cruise", _pitch_range), "The window starts in equilibrium, by our choice",
                "where the simulation starts"),
    FlightClaim("4.7", "second-order", _C, "pitch of second order overshoots its last value: by", 0.01, np.inf, "°",
                _in("second-order", overshoot),
                "Kicked by 0.25° with 1 deg/(rad/s); with the thesis's 20 this actuator limit-cycles", _KICK),
    FlightClaim("4.8", "second-order", _C, "propeller torque off by 1 to 3 % in the first 3 s", 1, 3, "%",
                _percent("second-order", _between(0.0, FIRST)), "In proportion to the kick, which is ours",
                _KICK),
    FlightClaim("4.8", "second-order", _C, "and by less than 0.3 % after that", 0, 0.3, "%",
                _percent("second-order", _between(FIRST, 1e3)), "The oscillation is damped", _KICK),
    FlightClaim("4.9", _T, _C, "propeller against ideal torque in the climb about 0.61 %", 0.4, 0.8, "%",
                _percent(_T, _climbing),
                "A proportional governor gives way in speed as the pitch rises, and the train takes J ω̇ to follow",
                _PACE),
    FlightClaim("4.10", _T, _C, "stage-1 forces rise linearly: departure over rise", 0, 2, "%",
                _percent(_T, departure_from_line), "Torques are asked to rise linearly, by our choice",
                "how the torques rise"),
    FlightClaim("4.11", _T, _C, "stage-2 forces about 2.5 times those of stage 1", 2.25, 2.75, "",
                _in(_T, _ratio), _STAGES, _SHARE),
    FlightClaim("4.12", _T, _C, "pitch ends at that of cruise: difference", 0, 0.5, "°", _late_pitch,
                "The climb ends at the airspeed of cruise; what is left is what a proportional governor gives up"),
    FlightClaim("4.13", "cruise", _V, "mean stage-1 forces are those of constant stiffness: difference", 0, 0.1, "%",
                _beside_constant("first", "cruise"), "The mean carries the torque"),
    FlightClaim("4.13", "cruise", _V, "stage-2 forces vary: swing over mean", 1, np.inf, "%",
                _percent("cruise", _swing("second")), "Every mesh passes from one pair of teeth to two"),
    FlightClaim("4.14", "cruise", _V, "carrier 1 is affected most: swing over the turbine's", 1, np.inf, "",
                _in("cruise", _swings("carrier")), "The shaft between the stages feels the teeth of both"),
    FlightClaim("4.14", "cruise", _V, "and so is carrier 2: the same of the output", 1, np.inf, "",
                _in("cruise", _swings("output")), _TEETH),
    FlightClaim("4.15", "cruise", _V, "output off the ideal torque by 0.8 % at most", 0.4, 1.2, "%",
                _percent("cruise", off_ideal), _TEETH),
    FlightClaim("4.15", "cruise", _V, "and by 0.6 % on average", 0.3, 0.9, "%",
                _percent("cruise", mean_off_ideal), _TEETH),
    FlightClaim("4.16", _T, _V, "propeller against ideal torque 1.88 % in the climb", 1.4, 2.4, "%",
                _percent(_T, _climbing),
                "As 4.9: varying stiffness adds nothing, for the propeller's inertia keeps the teeth from the air",
                _PACE),
    FlightClaim("4.16", _T, _V, "and by no more than 0.43 % in the cruise behind it", 0, 0.43, "%",
                _percent(_T, _between(CLIMB_ENDS + 2.0, 1e3)), _NO_LOSS),
    FlightClaim("4.16", _T, _V, "amplitude of the output torque 1.13 % of its mean", 0.6, 1.7, "%",
                _percent(_T, lambda window: 0.5 * output_swing(window)), _TEETH),
    FlightClaim("4.17", "taxi", _C, "stage-1 forces are zero: over stage 2", 0, 1e-3, "",
                _in("taxi", _stage_one_in_taxi), "Nothing drives stage 1"),
    FlightClaim("4.18", "taxi", _C, "stage-2 forces are constant: swing over mean", 0, 0.01, "%",
                _percent("taxi", _swing("second")), "Constant stiffness leaves nothing that excites"),
    FlightClaim("4.19", "taxi", _C, "output against ideal torque no more than 0.8 %", 0, 0.8, "%",
                _percent("taxi", off_ideal), _NO_LOSS),
    FlightClaim("4.20", "taxi", _C, "no torque from the turbine: over the motor's", 0, 1e-3, "",
                _in("taxi", _idle_turbine), "The turbine turns without torque"),
    FlightClaim("4.21", "taxi", _V, "mean stage-1 forces are zero: over stage 2", 0, 1e-3, "",
                _in("taxi", _stage_one_in_taxi), "Stage 2's fluctuation shakes stage 1 about zero"),
    FlightClaim("4.22", "taxi", _V, "mean torque on sun 1 is zero: over the motor's", 0, 1e-3, "",
                _in("taxi", _idle_turbine), "As above"),
    FlightClaim("4.22", "taxi", _V, "carrier 1's mean torque is the motor's: ratio", 0.999, 1.001, "",
                _in("taxi", _torque_ratio("carrier", "motor")), "All of it comes from the motor"),
    FlightClaim("4.23", "taxi", _V, "output torque swings by 0.5 % of the ideal one", 0.25, 0.75, "%",
                _percent("taxi", output_swing),
                "Stage 2 meshes at 0.93 kHz here, next to a mode at 770 Hz (674 Hz as printed): how far the output"
                " follows hangs on that distance, hence on teeth and stiffness that are not printed"),
)  # fmt: skip
"""What the thesis says of its figures 4.2 to 4.23."""


# ----------------------------------------------------------------------------------------------------------------------
# Which departure of the printed model makes which number: the output torque with each of them, and with all.
# ----------------------------------------------------------------------------------------------------------------------


DURATION = 1.0
"""Of the runs with one departure [s]."""
WINDOWS = ("cruise", "taxi")
"""Quiet windows, in which only teeth move the output torque."""
SHOWN = 12
"""Natural frequencies that are compared [-]."""


@dataclass(frozen=True)
class Departed:
    """The output torque of a quiet window with some of the thesis's departures."""

    window: str
    equation: str
    """Where they are printed; empty for the model as it should be."""
    words: str
    maximum: float
    """Largest difference to the ideal torque [-]."""
    mean: float
    """Mean absolute difference [-]."""
    swing: float
    """Greatest less least over the ideal torque [-]."""


@dataclass(frozen=True)
class _Way:
    equation: str
    words: str
    changes: Sequence[Change]


def departed(runs: Runs) -> tuple[Departed, ...]:
    """Return the output torque of cruise and taxi with each departure alone, and with all.

    Args:
        runs: Of `chapter_runs`: those with varying stiffness are flown again, a second each.
    """
    return tuple(_row(runs[window, VARYING], way) for window in WINDOWS for way in _ways())


def _ways() -> Sequence[_Way]:
    every = [printed.change for printed in PRINTED]
    return (
        _Way("", "as it should be", []),
        *(_Way(printed.equation, printed.words, [printed.change]) for printed in PRINTED),
        _Way("(3.34)", "planets 360°/(N − 1) apart, with the 54 and 57 teeth of the suns here", [_thesis_spacing]),
        _Way("(3.35), (3.34)", "the square wave, in phase", [square_wave, in_phase]),
        _Way("all of these", "as printed", every),
        *(_Way(f"and {printed.equation}", printed.words, [*every, printed.change]) for printed in UNITLESS),
    )


def _thesis_spacing(system: System, sizing: Sizing) -> System:
    return spaced(system, sizing, lambda planets: 2.0 * np.pi / (planets - 1))


def _row(window: DynamicWindow, way: _Way) -> Departed:
    flown = reflown(window, sized(DESIGN), way.changes, duration=DURATION)
    return Departed(window.name, way.equation, way.words, off_ideal(flown), mean_off_ideal(flown), output_swing(flown))


@dataclass(frozen=True)
class Frequencies:
    """Natural frequencies of In-Line H2, with the planets' inertia as it should be and as printed [Hz]."""

    right: tuple[float, ...]
    printed: tuple[float, ...]


def frequencies(runs: Runs) -> Frequencies:
    """Return the lowest natural frequencies with the planets' inertia as it should be and as printed.

    Args:
        runs: Of `chapter_runs`.
    """
    system = runs["cruise", VARYING].system
    pair = [modes(shown).frequency[:SHOWN] for shown in (system, relative_planets(system, sized(DESIGN)))]
    return Frequencies(tuple(map(float, pair[0])), tuple(map(float, pair[1])))
