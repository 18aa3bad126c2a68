"""Transient simulation of event windows with propeller, governor and elastic drive train."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.air import sound_speed
from gearwright.base import DesignError, Floats, Problem, Shown, Time, near, verb
from gearwright.dynamics import Outputs, System, Trace, simulate, statics
from gearwright.dynamics.assembly import Driving, assemble
from gearwright.dynamics.model import TORQUE, MachineDrive, PropellerDrive, holding, line_matrix
from gearwright.dynamics.motion import followed, with_profile
from gearwright.dynamics.vibration import DynamicLoad, ShaftLoad, dynamic_loads, shaft_loads
from gearwright.machines import (
    INSIDE,
    Governor,
    GovernorState,
    LimitCycle,
    PropellerMap,
    Rotor,
    angle_near,
    blade_angles,
    governor_rates,
    governs,
    limit_cycle,
    look_up,
    map_at,
    marched,
)
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import flown_airscrew
from gearwright.mission.supply import supply_of
from gearwright.mission.windows.background import Background, Curve, background, value_at
from gearwright.mission.windows.events import (
    brake_drive,
    caught,
    changed,
    failing,
    freewheels,
    rest_time,
    seized,
    stream_map,
)
from gearwright.spec import GovernorRules, WindowRules

# ----------------------------------------------------------------------------------------------------------------------
# A window of a flight with its governor: propeller, governor and a rigid drive train, seconds long.
#
# The train's own elasticity is left out: what it does in milliseconds is the matter of the dynamic model.
# ----------------------------------------------------------------------------------------------------------------------


_NUDGE = 5e-3
"""Part of the speed, and angle in rad, over which slopes of the map are taken [-]; [rad]"""


class PropellerTrim(NamedTuple):
    """A propeller in equilibrium at a moment of a flight."""

    chart: PropellerMap
    density: float
    """ρ [kg/m³]."""
    true_airspeed: float
    """V [m/s]."""
    diameter: float
    """D [m]."""
    speed: float
    """ω [rad/s]."""
    pitch: float
    """β [rad]."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""

    def torque(self, speed: float, pitch: float) -> float:
        """Return what the propeller takes from its shaft [N m].

        Args:
            speed: ω [rad/s].
            pitch: β [rad].

        Raises:
            DesignError: The point lies outside the map.
        """
        turns = speed / (2.0 * np.pi)
        coefficients = look_up(self.chart, self.true_airspeed / (turns * self.diameter), pitch)
        if coefficients.status != INSIDE:
            message = f"{turns * 60:.0f} rpm and {np.degrees(pitch):.1f}° lie outside the map in this window"
            raise DesignError(
                [Problem("propeller.map", f"{message}; start from another moment, or with a smaller step")]
            )
        return float(coefficients.power * self.density * turns**2 * self.diameter**5 / (2.0 * np.pi))


@dataclass(frozen=True)
class Window:
    """Histories of a governed propeller, shape (steps + 1,)."""

    time: Floats
    """[s]"""
    speed: Floats
    """Of the propeller [rad/s]."""
    pitch: Floats
    """[rad]"""
    torque: Floats
    """Of the propeller [N m]."""
    limit_cycle: LimitCycle | None
    """What the governor sustains; None where it comes to rest."""

    @property
    def overshoot(self) -> float:
        """Largest torque beyond the last one, as a part of it [-]."""
        return float(self.torque.max() / self.torque[-1] - 1.0)


@verb
def trim_at(flight: Flight, time: float) -> PropellerTrim:
    """Return the propeller in equilibrium at a time of a flight.

    Args:
        flight: As flown.
        time: From the start of the mission [s]; the nearest interval counts.

    Raises:
        DesignError: The flight has no propeller map.
    """
    history = flight.history
    if flight.propeller_map is None or history.pitch is None:
        raise DesignError([Problem("propeller_map", "the mission flies by schedules; a governor needs a map")])
    k = int(np.argmin(np.abs(history.time - time)))
    diameter = flight.sizing.design.airscrews[flown_airscrew(flight.sizing)].diameter
    return PropellerTrim(
        chart=chart_at(flight, k),
        density=float(history.air_density[k]),
        true_airspeed=float(history.true_airspeed[k]),
        diameter=diameter,
        speed=float(history.propeller_speed[k]),
        pitch=float(history.pitch[k]),
        inertia=flight.inertia,
    )


def chart_at(flight: Flight, interval: int) -> PropellerMap:
    """Return the propeller's map in an interval of a flight: of maps over the Mach number that of its tips there.

    Args:
        flight: As flown, with a map.
        interval: Of its histories.

    Raises:
        DesignError: The Mach number is beyond the last map.
    """
    assert flight.propeller_map is not None  # refused before
    history = flight.history
    diameter = flight.sizing.design.airscrews[flown_airscrew(flight.sizing)].diameter
    sound = sound_speed(float(history.air_temperature[interval]))
    return map_at(flight.propeller_map, 0.5 * float(history.propeller_speed[interval]) * diameter / sound)


@verb
def rotor_at(trim: PropellerTrim) -> Rotor:
    """Return the propeller linear about its equilibrium, driven by a constant torque.

    Args:
        trim: The equilibrium.

    Source: central differences of the map.
    """
    ahead, behind = ((1.0 + sign * _NUDGE) * trim.speed for sign in (1.0, -1.0))
    speeding = (trim.torque(ahead, trim.pitch) - trim.torque(behind, trim.pitch)) / (ahead - behind)
    pitching = (
        trim.torque(trim.speed, trim.pitch + _NUDGE) - trim.torque(trim.speed, trim.pitch - _NUDGE)
    ) / (2.0 * _NUDGE)  # fmt: skip
    return Rotor(trim.inertia, -speeding, pitching, trim.pitch)


@verb
def governed_window(
    trim: PropellerTrim, governor: Governor, *, duration: float, torque_step: float = 0.0, speed_step: float = 0.0,
    step: float = 2e-3,
) -> Window:  # fmt: skip
    """Return how propeller and governor answer to a step of the driving torque or of the set speed.

    Args:
        trim: The equilibrium before the step.
        governor: Its settings; its reference is the pitch that it has without a speed error.
        duration: [s].
        torque_step: Part by which the driving torque changes, as when a motor is cut [-].
        speed_step: Change of the set speed [rad/s].
        step: Of the Runge-Kutta method of fourth order [s].

    Source: I ω̇ = Q_drive - Q(ω, β) with `governor_rates`; the drive is a torque source, as in Pulvirenti 2023, §3.3.

    Raises:
        DesignError: The window leaves the propeller map.
    """
    drive = trim.torque(trim.speed, trim.pitch) * (1.0 + torque_step)
    target = trim.speed + speed_step

    def rates(state: Floats) -> Floats:
        speed, pitch, pitch_rate, error_sum = (float(value) for value in state)
        moved = governor_rates(governor, GovernorState(pitch, pitch_rate, error_sum), target - speed)
        return np.array([(drive - trim.torque(speed, pitch)) / trim.inertia, *moved])

    start = (trim.speed, trim.pitch, 0.0, _settled_sum(trim, governor))
    time, states = marched(rates, start, duration=duration, step=step)
    torque = np.array([trim.torque(float(speed), float(pitch)) for speed, pitch in states[:, :2]])
    return Window(time, states[:, 0], states[:, 1], torque, limit_cycle(time, states[:, 0]))


def _settled_sum(trim: PropellerTrim, governor: Governor) -> float:
    """The integral with which the governor holds the pitch of the equilibrium."""
    return (governor.reference - trim.pitch) / governor.integral if governor.integral else 0.0


# ----------------------------------------------------------------------------------------------------------------------
# What is kept of a window's motion.
# ----------------------------------------------------------------------------------------------------------------------


BINS = 400
"""Time bins of a window's statistics."""
CLOSE_CYCLES = 4.0
"""Cycles of the slowest mesh at the end of a window of which every step is kept [-]."""
START = 0.05
"""Time from which on statistics look [s]: teeth that change their stiffness at once shake a train that was at rest."""


def window_outputs(system: System, rules: WindowRules) -> Outputs:
    """Return what is kept of a window: its time bins, and every step of its last cycles.

    Bins begin when what changing stiffness shook at the start has died, at half the time of the event at the latest.

    Args:
        system: With its speed profile.
        rules: Of the window.
    """
    turning = np.abs(system.arrays.tone_rate[system.arrays.tone_rate != 0.0])
    last = 0 if rules.event == "sudden-stop" else -1  # a train at rest has no cycles
    slowest = float(np.min(turning)) * float(system.arrays.profile.factor[last]) if len(turning) else 0.0
    close = min(2.0 * math.pi * CLOSE_CYCLES / slowest, rules.duration) if slowest else min(0.02, rules.duration)
    until = rules.duration if rules.event == "none" else rules.event_at
    start = min(START, 0.5 * until) if len(turning) else 0.0
    return Outputs(bins=BINS, start=start, windows=((rules.duration - close, rules.duration),))


# ----------------------------------------------------------------------------------------------------------------------
# Dynamic windows: seconds of a mission in which propeller, governor and machines move the elastic train.
# ----------------------------------------------------------------------------------------------------------------------


NOTICED = 1e-4
"""Swing of a propeller's speed over the speed itself from which on it is called a limit cycle [-]."""
MACHINE_EVENTS = ("motor-short-circuit", "engine-out")
"""Events of one machine."""
_PILOTS: Mapping[str, None] = {"lowest_pitch": None, "highest_pitch": None, "reference_pitch": None}
"""Stops and reference of a governor where the pilot holds the blades."""
NEVER_SLIPS = 1e12
"""Capacity of an overrunning clutch in the sense in which it holds [N m]."""


@dataclass(frozen=True, eq=False, repr=False)
class DynamicWindow(Shown):
    """A window as it was flown."""

    name: str
    rules: WindowRules
    start: float
    """From the start of the mission [s]."""
    system: System
    """With its drives, and the speed profile that the rigid pass found."""
    trace: Trace
    """Time runs from the window's start."""
    limit_cycle: LimitCycle | None
    """What the governor sustains; None where it comes to rest."""
    meshes: tuple[DynamicLoad, ...] = ()
    """Peak of every mesh row beside what it is sized for, the worst first."""
    shafts: tuple[ShaftLoad, ...] = ()
    """Peak of every shaft beside what it is sized for, the worst first."""
    rest: Time | None = None
    """When a sudden stop has come to rest, from the window's start [s]; None where it has not."""


class BegunWindow(NamedTuple):
    """A window that has not moved yet."""

    name: str
    rules: WindowRules
    back: Background
    """What goes on around it."""
    system: System
    """With its drives, and the speed profile that the rigid pass found."""
    start: tuple[Floats, Floats]
    """q and q̇."""


class _Blade(NamedTuple):
    """Blade angles between which a governor turns the blades: those of the map, or one alone that the pilot holds."""

    lowest: float
    """[rad]"""
    highest: float
    """[rad]"""


@verb
def window_rules(flight: Flight, name: str) -> WindowRules:
    """Return the rules of a window of a flight's mission.

    Args:
        flight: As flown.
        name: Of the window.

    Raises:
        DesignError: There is no such window; with the nearest one.
    """
    if name not in flight.mission.windows:
        raise DesignError([Problem(f"windows.{name}", f"no such window; {near(name, flight.mission.windows)}")])
    return flight.mission.windows[name]


@verb
def fly_window(flight: Flight, name: str, rules: WindowRules | None = None) -> DynamicWindow:
    """Return a window of a flight, with propeller, governor and machines coupled to the elastic train.

    It starts in the equilibrium of the quasi-steady flight, its pitch the one that balances the torques. Mesh losses
    are torques on the first shaft of their stage, which follow the mission and a change of mode, not a cut; drag stays
    in the machines.

    Args:
        flight: As flown, with a propeller map.
        name: Of the window.
        rules: What happens in it; left out: those of the mission's window of this name.

    Raises:
        DesignError: The flight flies by schedules, or the window does not lie in its phase.
        SolveError: The propeller leaves its map.
    """
    begun = begun_window(flight, name, rules)
    rules, back, system = begun.rules, begun.back, begun.system
    trace = simulate(system, rules.duration, start=begun.start, outputs=window_outputs(system, rules))
    loads = dynamic_loads(flight.sizing, trace), shaft_loads(flight.sizing, trace)
    cycle = None if back.brake else _cycle(back, trace)
    return DynamicWindow(name, rules, back.start, system, trace, cycle, *loads, _rest(back, trace))


@verb
def begun_window(flight: Flight, name: str, rules: WindowRules | None = None) -> BegunWindow:
    """Return a window before it moves, for simulators of others.

    Args:
        flight: As flown, with a propeller map.
        name: Of the window.
        rules: What happens in it; left out: those of the mission's window of this name.

    Raises:
        DesignError: The flight flies by schedules, or the window does not lie in its phase.
        SolveError: The propeller leaves its map.
    """
    rules = rules or window_rules(flight, name)
    _check(flight, name, rules)
    back = changed(background(flight, rules), rules)
    system = _system(back, rules)
    state = _start(system, back, rules)
    system = followed(system, rules.duration) if np.all(state[1] == 0.0) else system
    governed = caught(back, rules, system)
    if governed is not None:
        system = followed(_system(governed, rules), rules.duration)
    return BegunWindow(name, rules, back, system, state)


def _check(flight: Flight, name: str, rules: WindowRules) -> None:
    at = f"windows.{name}"
    if flight.propeller_map is None:
        raise DesignError([Problem(at, "the mission flies by schedules; a window needs a propeller_map")])
    phase_duration = float(flight.history.duration[np.array(flight.phase) == rules.phase].sum())
    if rules.at >= phase_duration:
        message = (
            f"{rules.at:g} s, but {rules.phase} ends after {phase_duration:g} s; start earlier, or in the next phase"
        )
        raise DesignError([Problem(f"{at}.at", message)])
    if rules.event == "sudden-stop":
        seized(rules, flown_airscrew(flight.sizing), flight.machines)
    if rules.event in MACHINE_EVENTS:
        failing(supply_of(flight.sizing, flight.mission, flight.engine_deck), rules, at)
    joints = {joint.name for joint in flight.sizing.train.joints}
    if rules.clutch is not None and rules.clutch not in joints:
        raise DesignError([Problem(f"{at}.clutch", f"no such clutch: {rules.clutch}; {near(rules.clutch, joints)}")])


def _system(back: Background, rules: WindowRules) -> System:
    flight, design = back.flight, back.flight.sizing.design
    machines = [_machine(back, rules, name) for name in back.gearbox.machines]
    if back.strike is not None:
        machines.append(MachineDrive("strike", back.gearbox.propeller, back.strike, value_at(back.speed, 0.0)))
    if back.brake is not None:
        machines.append(brake_drive(back.brake))
    carried = freewheels(back, rules)
    held: dict[str, float | Curve] = dict.fromkeys(carried, NEVER_SLIPS)
    if rules.clutch is not None:
        held[rules.clutch] = _capacity(back, rules)
    driving = Driving([_propeller(back, rules), *machines], back.resistances, held, carried)
    system = assemble(
        flight.sizing,
        flight.sizing.reference.case,
        stiffness=rules.stiffness or design.dynamics.stiffness,
        driving=driving,
    )
    column = system.labels.coordinates.index(_body(system, back.gearbox.propeller))
    factor = value_at(back.speed, 0.0) / abs(float(system.arrays.speed[column]))
    return with_profile(system, [(0.0, factor)])


def _body(system: System, drive: str) -> str:
    """Return the coordinate that a drive acts on."""
    place, table = 2, system.arrays.drives.table
    for owner in system.labels.drive_owners:
        if owner.what == TORQUE and owner.part is not None:
            if owner.part.name == drive:
                break
            place += int(table[place])
    return system.labels.coordinates[int(table[place + 2])]


def _machine(back: Background, rules: WindowRules, name: str) -> MachineDrive:
    """Return a machine whose torque at the set speed is the mission's."""
    supply = back.supply
    turning = abs(float(back.flight.machines[name].speed[back.interval]))
    mean_speed = back.flight.history.propeller_speed[back.interval]
    reference = turning * value_at(back.speed, 0.0) / float(mean_speed)
    if name in supply.motors:
        motor = supply.motors[name]
        limits = (motor.peak_torque, motor.peak_power) if back.limits else (math.inf, math.inf)
        return MachineDrive(name, name, back.torques[name], reference, 0.0, *limits)
    if name not in supply.engines:
        return MachineDrive(name, name, back.torques[name], reference, 0.0)
    engine = supply.engines[name]
    slope, ratio = rules.turbine_slope, value_at(back.speed, 0.0)
    times = sorted({time for curve in (back.torques[name], back.speed) for time, _ in curve})
    command = [
        (time, value_at(back.torques[name], time) / (1.0 + slope * (1.0 - value_at(back.speed, time) / ratio)))
        for time in times
    ]
    return MachineDrive(name, name, command, reference, slope, engine.rated_torque, engine.rated_power)


def _propeller(back: Background, rules: WindowRules) -> PropellerDrive:
    chart, stops = chart_at(back.flight, back.interval), back.brake is not None
    chart = stream_map(back.flight.mission.propeller_map, chart) if stops else chart
    name = back.gearbox.propeller
    diameter = back.flight.sizing.design.airscrews[name].diameter
    speed, density, airspeed = (value_at(curve, 0.0) for curve in (back.speed, back.density, back.airspeed))
    turns = speed / (2.0 * math.pi)
    ratio = airspeed / (turns * diameter)
    flown = back.flight.history.pitch
    assert flown is not None  # there is a map
    taken = _taken(back, rules) / (density * turns**3 * diameter**5)
    pitch = angle_near(chart, ratio, taken, float(flown[back.interval]))
    free = governs(chart, ratio, pitch) and not stops
    blade = _Blade(*blade_angles(chart, ratio)) if free else _Blade(pitch, pitch)
    governor = _governor(rules.governor or back.flight.mission.governor, pitch, back, blade)
    settled = (governor.reference - pitch) / governor.integral if governor.integral else 0.0
    start = GovernorState(pitch, 0.0, settled)
    return PropellerDrive(
        name, name, chart, diameter, governor, start, back.density, back.airspeed, back.held_speed or back.speed,
        back.pitch, stops,
    )  # fmt: skip


def _taken(back: Background, rules: WindowRules) -> float:
    """Return the power that is left for the propeller at the window's start [W]."""
    train, k = back.flight.sizing.train, back.interval
    speed = value_at(back.speed, 0.0)
    scale = speed / float(back.flight.history.propeller_speed[k])
    turning = {node: abs(float(history.speed[k])) * scale for node, history in back.flight.nodes.items()}
    driven = sum(value_at(back.torques[name], 0.0) * turning[train.machines[name]] for name in back.gearbox.machines)
    lost = sum(value_at(curve, 0.0) * turning[shaft] for shaft, curve in back.resistances.items())
    small = 1e-3
    gain = (value_at(back.speed, small) - speed) / small
    return driven - lost - back.gearbox.inertia * speed * gain


def _governor(rules: GovernorRules, pitch: float, back: Background, blade: _Blade) -> Governor:
    free = blade.lowest < blade.highest  # else finer than the angle of least power, where no governor works
    rules = rules if free else rules.model_copy(update=_PILOTS)
    held = back.flight.mission.phases[back.phase].pitch
    lowest = rules.lowest_pitch if rules.lowest_pitch is not None or not free else held
    return Governor(
        reference=rules.reference_pitch if rules.reference_pitch is not None else pitch,
        proportional=math.radians(rules.gain_deg_s),
        integral=math.radians(rules.integral_deg_rad),
        time_constant=rules.time_constant,
        damping=rules.damping,
        lower=min(pitch, blade.lowest if lowest is None else lowest),
        upper=blade.highest if rules.highest_pitch is None else rules.highest_pitch,
        rate=math.radians(rules.rate_deg_s),
    )


def _capacity(back: Background, rules: WindowRules) -> float | Curve:
    """Return an overrunning clutch's, which never slips forwards, or a friction clutch's, which grows at the event."""
    joint = next(clutch for clutch in back.flight.sizing.train.joints if clutch.name == rules.clutch)
    if joint.overrunning:
        return NEVER_SLIPS
    carried = float(back.flight.nodes[joint.driving].torque[back.interval])
    full = rules.capacity or 2.0 * carried
    return [(rules.event_at, 0.0), (rules.event_at + rules.over, full)]


def _start(system: System, back: Background, rules: WindowRules) -> tuple[Floats, Floats]:
    """Return the equilibrium; what stands before a clutch that engages later turns slower by its slip."""
    arrays, labels = system.arrays, system.labels
    velocity = np.zeros(len(arrays.mass))
    if rules.clutch is not None and rules.slip is not None:
        joint = next(clutch for clutch in back.flight.sizing.train.joints if clutch.name == rules.clutch)
        machine = [name for name, shaft in back.flight.sizing.train.machines.items() if shaft == joint.driving]
        before_clutch = _joined(system, labels.coordinates.index(_body(system, machine[0])))
        leading = abs(float(arrays.speed[before_clutch][np.argmax(np.abs(arrays.speed[before_clutch]))]))
        velocity[before_clutch] = -rules.slip / leading * arrays.speed[before_clutch]
    return statics(system, balance="accelerate").position, velocity


def _joined(system: System, first: int) -> Floats:
    """Return the coordinates that lines join with one, as a mask."""
    matrix = line_matrix(system.arrays)[holding(system.arrays)] != 0.0
    joined = np.zeros(matrix.shape[1], bool)
    joined[first] = True
    while True:
        grown = joined | np.any(matrix[np.any(matrix & joined, axis=1)], axis=0)
        if np.array_equal(grown, joined):
            return joined
        joined = grown


def _rest(back: Background, trace: Trace) -> float | None:
    """Return when a brake has brought its shaft to rest [s]."""
    if back.brake is None:
        return None
    assert trace.drive is not None  # every window has drives
    edges = trace.drive.edges
    return rest_time(0.5 * (edges[1:] + edges[:-1]), trace.drive.of("brake speed")["mean"], back.brake.creep)


def _cycle(back: Background, trace: Trace) -> LimitCycle | None:
    """Return the oscillation that the speed keeps, by the means of time bins: teeth are averaged out."""
    assert trace.drive is not None  # every window has drives
    edges = trace.drive.edges
    speed = trace.drive.of(f"{back.gearbox.propeller} speed")["mean"]
    cycle = limit_cycle(0.5 * (edges[1:] + edges[:-1]), speed - value_at(back.speed, 0.0))
    return cycle if cycle is not None and cycle.amplitude > NOTICED * float(np.mean(speed)) else None
