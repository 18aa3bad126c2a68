"""Flight path of an aircraft as a point mass: phases, integration, forces and mass.

What a thrust needs in power, and what that costs, is the flight's; nothing here knows gears.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import Annotated, NamedTuple

from gearwright.air import air_at, height, true_of_calibrated
from gearwright.base import (
    GRAVITY,
    DesignError,
    Distance,
    Force,
    Mass,
    Origin,
    Problem,
    Quantity,
    Shown,
    Time,
    apart,
    verb,
)
from gearwright.mission.flight import Flight
from gearwright.mission.intervals import Flown, loaded
from gearwright.mission.profile import (
    Energy,
    Moment,
    Node,
    Path,
    Paths,
    edges,
    moments,
    phase_duration,
    ramped,
    speed_by_law,
)
from gearwright.mission.thrust import Attitude, lowest_speed, performed, resistance, thrust_at, wanted_of
from gearwright.spec import Aircraft, Mission, Phase

# ----------------------------------------------------------------------------------------------------------------------
# Phases whose path is stated: rate or angle of climb, speed, time or distance; the thrust follows from them.
# ----------------------------------------------------------------------------------------------------------------------


LEAST = 4
"""Intervals of a climb at an angle, at least [-]."""


def stated_path(mission: Mission, phase: Phase, start: Node) -> Path:
    """Return the path of a phase that states it.

    Args:
        mission: With its steps and air.
        phase: The phase.
        start: Where the phase before ended, and at which speed.

    Raises:
        DesignError: A speed that is not flown where it is asked.
    """

    def speed(altitude: float) -> float:
        return speed_by_law(phase, air_at(altitude, mission.isa_offset_k))

    if phase.kind == "speed-change":
        nodes = _changing(mission, phase, start, speed(start.altitude))
    elif phase.path_angle is not None:
        nodes = _inclined(mission, phase, start.altitude, speed)
    else:
        duration = _duration(phase, start.altitude, speed)
        times = edges(duration, phase.ramp, mission.step)
        climb = (phase.altitude - start.altitude) / duration
        heights = [start.altitude + climb * time for time in times[:-1]] + [phase.altitude]
        nodes = [Node(time, height, speed(height)) for time, height in zip(times, heights, strict=True)]
    stage = "roll" if phase.kind == "taxi" else "flight"
    return Path(tuple(nodes), (stage,) * (len(nodes) - 1))


def _duration(phase: Phase, altitude: float, speed: Callable[[float], float]) -> float:
    if phase.duration is not None:
        return phase.duration
    if phase.distance is not None:
        flown = speed(altitude)
        if flown <= 0.0:
            raise DesignError([Problem("speed", f"{flown:g} m/s never flies a distance; fly faster")])
        return phase.distance / flown
    return (phase.altitude - altitude) / (phase.rate_of_climb or math.nan)


def _changing(mission: Mission, phase: Phase, start: Node, speed: float) -> list[Node]:
    """Return the nodes of a steady change of speed on the level."""
    duration = phase.duration or math.nan
    times = edges(duration, phase.ramp, mission.step)
    return [Node(time, start.altitude, start.speed + (speed - start.speed) * time / duration) for time in times]


def _inclined(mission: Mission, phase: Phase, altitude: float, speed: Callable[[float], float]) -> list[Node]:
    """Return the nodes of a path at an angle, whose speed of climb follows the airspeed."""
    slope, rise = math.sin(phase.path_angle or math.nan), phase.altitude - altitude
    longest = abs(rise / slope) / min(speed(altitude), speed(phase.altitude))
    count = max(math.ceil(longest / mission.step), LEAST)
    nodes = [Node(0.0, altitude, speed(altitude))]
    for k in range(1, count + 1):
        height = altitude + rise * k / count if k < count else phase.altitude
        flown, last = speed(height), nodes[-1]
        time = last.time + (height - last.altitude) / (slope * 0.5 * (flown + last.speed))
        nodes.append(Node(time, height, flown))
    return nodes


# ----------------------------------------------------------------------------------------------------------------------
# Integration of a path: classical Runge-Kutta steps over speed, height, time or distance, whichever ends it.
# ----------------------------------------------------------------------------------------------------------------------


class State(NamedTuple):
    """Of an aircraft on its path."""

    time: float
    """From the start of the phase [s]."""
    altitude: float
    """[m]"""
    speed: float
    """True airspeed [m/s]."""
    distance: float
    """[m]"""
    mass: float
    """[kg]"""
    thrust_work: float
    """Of all propellers [J]."""
    drag_work: float
    """Of air and wheels [J]."""
    carried: float
    """Height and speed of the fuel that was burnt [J]."""

    @property
    def energy(self) -> float:
        """Of height and speed [J]."""
        return self.mass * (GRAVITY * self.altitude + 0.5 * self.speed**2)


Rates = Callable[[State], State]
"""State -> its derivatives over what is marched along."""


def march(rates: Rates, state: State, *, length: float, count: int, inner: int = 1) -> list[State]:
    """Return the states at the ends of equal steps, the first among them.

    Args:
        rates: Derivatives.
        state: At the start.
        length: Of the way, negative backwards.
        count: Steps that are returned.
        inner: Steps within each of them.

    Source: the classical Runge-Kutta method of fourth order.
    """
    states, step = [state], length / (count * inner)
    for _ in range(count):
        for _ in range(inner):
            state = _step(rates, state, step)
        states.append(state)
    return states


def _step(rates: Rates, state: State, step: float) -> State:
    first = rates(state)
    second = rates(_moved(state, first, 0.5 * step))
    third = rates(_moved(state, second, 0.5 * step))
    fourth = rates(_moved(state, third, step))
    mean = State(*((a + 2.0 * b + 2.0 * c + d) / 6.0 for a, b, c, d in zip(first, second, third, fourth, strict=True)))
    return _moved(state, mean, step)


def _moved(state: State, rate: State, step: float) -> State:
    return State(*(value + step * change for value, change in zip(state, rate, strict=True)))


def books(start: State, end: State) -> Energy:
    """Return where the energy of a path went.

    Args:
        start: Its first state.
        end: Its last state.
    """
    return Energy(
        end.thrust_work - start.thrust_work,
        end.drag_work - start.drag_work,
        end.carried - start.carried,
        end.energy - start.energy,
    )


# ----------------------------------------------------------------------------------------------------------------------
# Phases that fly with the power that they are given: what speed, height and distance follow from the thrust.
# ----------------------------------------------------------------------------------------------------------------------


TRIAL = 16
"""Steps of a first pass, which says how long the intervals would be [-]."""
LEAST_INTERVALS, LEAST_STEPS = 4, 64
"""Of every stretch: intervals, and steps of integration in them [-]."""
ROUNDS = 4
"""In which climb and lift agree: lift is m g cos γ [-]."""
LANDED = 5.0
"""True airspeed at which a landing's roll ends where the phase does not say it [m/s]."""
_ROUNDING = 1e-9
"""Part of a step that is none [-]."""
_SMALL = 1e-3
"""Height over which the change of a schedule's speed is taken [m]."""


class Push(NamedTuple):
    """What the propellers give at a point."""

    thrust: float
    """Of all of them [N]."""
    fuel_flow: float
    """Of all engines [kg/s]."""


@dataclass(frozen=True)
class Powered:
    """A phase under its power."""

    aircraft: Aircraft
    phase: Phase
    push: Callable[[State], Push]
    """What the propellers give in a state."""
    isa_offset: float
    """[K]"""
    step: float
    """Longest interval [s]."""

    def force(self, state: State, slope: float, rolls: float) -> tuple[Push, float]:
        """Return what pushes and what holds, in a state.

        Args:
            state: Of the aircraft.
            slope: sin γ [-].
            rolls: Part of the load that the wheels bear [-].
        """
        return self.pushed(state), self.held(state, slope, rolls)

    def pushed(self, state: State) -> Push:
        """Return what pushes in a state, however steep.

        Args:
            state: Of the aircraft.
        """
        if state.speed < 0.0 or state.mass <= 0.0:
            message = "slows to a stand" if state.mass > 0.0 else "burns more fuel than it weighs"
            raise DesignError([Problem("power", f"the aircraft {message}; give more power, or fly shorter")])
        return self.push(state)

    def held(self, state: State, slope: float, rolls: float) -> float:
        """Return what holds in a state [N].

        Args:
            state: Of the aircraft.
            slope: sin γ [-].
            rolls: Part of the load that the wheels bear [-].
        """
        at = Attitude(air_at(state.altitude, self.isa_offset), state.speed, slope, rolls)
        return resistance(self.aircraft, self.phase, state.mass * GRAVITY, at)


def _rates(time: float, altitude: float, speed: float, state: State, forces: tuple[Push, float]) -> State:
    """Return derivatives over any way from those of time, height and speed over it."""
    (thrust, fuel_flow), held = forces
    way, burnt = state.speed * time, fuel_flow * time
    carried = burnt * (GRAVITY * state.altitude + 0.5 * state.speed**2)
    return State(time, altitude, speed, way, -burnt, thrust * way, held * way, carried)


def _over_speed(powered: Powered, rolls: float) -> Rates:
    """Return derivatives over the speed, level or on the ground."""

    def rates(state: State) -> State:
        forces = powered.force(state, 0.0, rolls)
        time = state.mass / (forces[0].thrust - forces[1])
        return _rates(time, 0.0, 1.0, state, forces)

    return rates


def _over_time(powered: Powered, rolls: Callable[[float], float]) -> Rates:
    """Return derivatives over time, level."""

    def rates(state: State) -> State:
        forces = powered.force(state, 0.0, rolls(state.time))
        return _rates(1.0, 0.0, (forces[0].thrust - forces[1]) / state.mass, state, forces)

    return rates


def _over_distance(powered: Powered) -> Rates:
    """Return derivatives over the distance, level."""
    timed = _over_time(powered, lambda _: 0.0)
    return lambda state: State(*(rate / state.speed for rate in timed(state)))


def _over_height(powered: Powered, speed: Callable[[float], float]) -> Rates:
    """Return derivatives over the height, at the speeds of a schedule."""

    def rates(state: State) -> State:
        state = state._replace(speed=speed(state.altitude))
        change = (speed(state.altitude + _SMALL) - speed(max(state.altitude - _SMALL, 0.0))) / (
            _SMALL + min(_SMALL, state.altitude)
        )
        weight, slope, push = state.mass * GRAVITY, 0.0, powered.pushed(state)
        for _ in range(ROUNDS):
            held = powered.held(state, slope, 0.0)
            slope = (push.thrust - held) / (weight * (1.0 + state.speed / GRAVITY * change))
            slope = min(max(slope, -1.0), 1.0)
        return _rates(1.0 / (state.speed * slope), 1.0, change, state, (push, held))

    return rates


def stretch(powered: Powered, rates: Rates, state: State, length: float, *, trial: int = TRIAL) -> list[State]:
    """Return the states of a stretch, at the ends of intervals that are no longer than a step.

    Args:
        powered: With the longest interval.
        rates: Derivatives.
        state: At its start.
        length: Of the way.
        trial: Steps of the pass that finds how long intervals are.
    """
    longest = max(end.time - start.time for start, end in pairwise(march(rates, state, length=length, count=trial)))
    count = max(math.ceil(trial * longest / powered.step - _ROUNDING), LEAST_INTERVALS)
    return march(rates, state, length=length, count=count, inner=max(math.ceil(LEAST_STEPS / count), 1))


def path_by_power(powered: Powered, start: State) -> tuple[Path, State]:
    """Return the path of a phase under its power, and the state at its end.

    Args:
        powered: The phase.
        start: Where it starts.

    Raises:
        DesignError: The power does not do what the phase asks.
    """
    kind = powered.phase.kind
    stretches = {"take-off": _take_off, "landing": _landing, "cruise": _cruise, "speed-change": _speed_change}
    parts = stretches.get(kind or "", _climb)(powered, start)
    nodes, stages = [_node(start)], list[str]()
    for stage, states in parts:
        nodes += [_node(state) for state in states[1:]]
        stages += [stage] * (len(states) - 1)
    end = parts[-1][1][-1]
    return Path(tuple(nodes), tuple(stages), books(start, end)), end


Stretches = list[tuple[str, list[State]]]


def _node(state: State) -> Node:
    return Node(state.time, state.altitude, state.speed)


def rotation_speed(powered: Powered, state: State) -> float:
    """Return the true airspeed at which a take-off rotates [m/s].

    Args:
        powered: The take-off.
        state: At its start.
    """
    phase, air = powered.phase, air_at(state.altitude, powered.isa_offset)
    if any(value is not None for value in (phase.cas, phase.tas, phase.mach)):
        return speed_by_law(phase, air)
    lowest = lowest_speed(powered.aircraft, phase, air, state.mass * GRAVITY)
    assert lowest is not None  # `mission_problems` refuses it
    return powered.aircraft.rotation_over_stall * lowest


def _take_off(powered: Powered, start: State) -> Stretches:
    """Roll, rotation, and the climb at the speed of lift-off to the height of the screen."""
    aircraft, phase = powered.aircraft, powered.phase
    rotates = rotation_speed(powered, start)
    if rotates <= start.speed:
        message = "rotates at {}, and starts at {}; start slower".format(*apart(rotates, start.speed, "velocity"))
        raise DesignError([Problem("speed", message)])
    parts = [("roll", _changed(powered, start, rotates, rolls=1.0))]
    begun, lasts = parts[0][1][-1], aircraft.rotation
    unloaded = _over_time(powered, lambda time: 1.0 - (time - begun.time) / lasts)
    parts.append(("rotation", stretch(powered, unloaded, begun, lasts)))
    lifted = parts[1][1][-1]
    lowest = lowest_speed(aircraft, phase, air_at(lifted.altitude, powered.isa_offset), lifted.mass * GRAVITY)
    if lowest is not None and lifted.speed < lowest:
        speed, stall = apart(lifted.speed, lowest, "velocity")
        message = f"lifts off at {speed}, and stalls below {stall}; rotate later"
        raise DesignError([Problem("speed", message)])
    if phase.altitude > lifted.altitude:
        parts.append(("flight", _risen(powered, lifted, lambda _: lifted.speed)))
    return parts


def _landing(powered: Powered, start: State) -> Stretches:
    end = LANDED if powered.phase.end_speed is None else powered.phase.end_speed
    return [("roll", _changed(powered, start, end, rolls=1.0))]


def _speed_change(powered: Powered, start: State) -> Stretches:
    speed = speed_by_law(powered.phase, air_at(start.altitude, powered.isa_offset))
    return [("flight", _changed(powered, start, speed, rolls=0.0))]


def _cruise(powered: Powered, start: State) -> Stretches:
    """Level flight whose speed its power finds; a trial in long steps would swing about it."""
    distance, duration = powered.phase.distance, powered.phase.duration or 0.0
    rates = _over_time(powered, lambda _: 0.0) if distance is None else _over_distance(powered)
    if start.speed <= 0.0:
        raise DesignError([Problem("speed", "a cruise starts at a standstill; put a take-off before it")])
    trial = max(math.ceil((duration if distance is None else distance / start.speed) / powered.step), TRIAL)
    return [("flight", stretch(powered, rates, start, duration if distance is None else distance, trial=trial))]


def _climb(powered: Powered, start: State) -> Stretches:
    """Climb or descent at the speeds of a schedule."""

    def speed(altitude: float) -> float:
        return speed_by_law(powered.phase, air_at(altitude, powered.isa_offset))

    return [("flight", _risen(powered, start, speed))]


def _changed(powered: Powered, start: State, speed: float, rolls: float) -> list[State]:
    """Return the states of a change of speed on the level."""
    for at in _between(start.speed, speed):
        thrust, held = powered.force(start._replace(speed=at), 0.0, rolls)
        if (thrust.thrust - held) * (speed - start.speed) <= 0.0:
            message = (
                f"does not come from {start.speed:.4g} to {speed:.4g} m/s: at {at:.4g} m/s its propellers give"
                f" {thrust.thrust / 1e3:.4g} kN, and {held / 1e3:.4g} kN hold it; give"
                f" {'more' if speed > start.speed else 'less'} power"
            )
            raise DesignError([Problem("power", message)])
    return stretch(powered, _over_speed(powered, rolls), start, speed - start.speed)


def _risen(powered: Powered, start: State, speed: Callable[[float], float]) -> list[State]:
    """Return the states of a climb or a descent to the altitude of the phase."""
    end, rates = powered.phase.altitude, _over_height(powered, speed)
    for at in _between(start.altitude, end):
        slower = rates(start._replace(altitude=at)).time
        if slower * (end - start.altitude) <= 0.0:
            way, rate = ("climb" if end > start.altitude else "sink"), 1.0 / slower
            fix = "give less power, or flaps"
            if end > start.altitude:
                lower = "that is its ceiling: stop lower, " if at > start.altitude else ""
                fix = f"{lower}be lighter, or give more power"
            message = f"does not {way} at {height(at)} with this power ({rate:.3g} m/s); {fix}"
            raise DesignError([Problem("power", message)])
    states = stretch(powered, rates, start, end - start.altitude)
    return [state._replace(speed=speed(state.altitude)) for state in states]  # across a corner of the schedule, too


def _between(first: float, last: float) -> Sequence[float]:
    return [first + (last - first) * part / TRIAL for part in range(TRIAL + 1)]


# ----------------------------------------------------------------------------------------------------------------------
# The paths of all phases that an aircraft flies, one after the other, with the mass that is left for each.
# ----------------------------------------------------------------------------------------------------------------------


SMOOTH = 0.5
"""Difference of two airspeeds that is no jump: rounding of knots [m/s]."""
USUAL_EFFICIENCY = 0.98
"""Of a gearbox, for the fuel that phases before one under its power burn: an estimate of its mass only [-]."""


class _Before(NamedTuple):
    """How the phase before ended."""

    altitude: float
    """[m]"""
    speed: float | None
    """True airspeed [m/s]; None at the start of a mission."""
    propeller: float
    """Speed of the propeller [rad/s]."""
    burnt: float
    """Fuel of all engines, as it is estimated [kg]."""


def paths_of(flown: Flown) -> Paths:
    """Return phase -> path, for the phases that an aircraft flies.

    A path that is stated needs no thrust to be known; one that follows from its power is integrated, with the
    propeller's map, the efficiency of the gearbox at the phase's start, and the fuel that is burnt up to there.

    Args:
        flown: Gearbox, propeller, mission and machines.

    Raises:
        DesignError: A path that its power does not fly, or a speed that jumps; with the phase.
    """
    mission = flown.mission
    if all(phase.kind is None for phase in mission.phases.values()):
        return {}
    first = next(iter(mission.phases.values()))
    altitude = first.altitude if first.from_altitude is None else first.from_altitude
    before, paths = _Before(altitude, None, first.propeller_speed, 0.0), dict[str, Path]()
    left = sum(_is_given(phase) for phase in mission.phases.values())
    for name, phase in mission.phases.items():
        try:
            if phase.kind is not None:
                paths[name] = _path(flown, phase, before)
        except DesignError as error:
            problems = [Problem(f"phases.{name}", f"{problem.path}: {problem.message}") for problem in error.problems]
            raise DesignError(problems) from None
        left -= _is_given(phase)
        burnt = before.burnt + (_burnt(flown, name, phase, paths, before) if left else 0.0)
        before = _after(mission, phase, paths.get(name), before)._replace(burnt=burnt)
    return paths


def _is_given(phase: Phase) -> bool:
    """Tell whether a phase's path follows from its power or pitch."""
    return phase.kind is not None and (phase.power is not None or phase.pitch is not None) and phase.kind != "taxi"


def _path(flown: Flown, phase: Phase, before: _Before) -> Path:
    mission = flown.mission
    _refuse_high(mission, phase)
    start = Node(0.0, before.altitude, _start_speed(mission, phase, before))
    _refuse_jump(mission, phase, start, before)
    if not _is_given(phase):
        return stated_path(mission, phase, start)
    assert mission.aircraft is not None  # `mission_problems` refuses it
    mass = mission.aircraft.mass - before.burnt
    state = State(0.0, start.altitude, start.speed, 0.0, mass, 0.0, 0.0, 0.0)
    powered = Powered(
        mission.aircraft, phase, _pusher(flown, phase, before).__call__, mission.isa_offset_k, mission.step
    )
    return path_by_power(powered, state)[0]


def _start_speed(mission: Mission, phase: Phase, before: _Before) -> float:
    """Return the true airspeed at which a phase starts [m/s]."""
    air = air_at(before.altitude, mission.isa_offset_k)
    if phase.from_tas is not None:
        return phase.from_tas
    if phase.from_cas is not None:
        return float(true_of_calibrated(phase.from_cas, air))
    stated = any(value is not None for value in (phase.cas, phase.tas, phase.mach))
    if stated and phase.kind not in ("take-off", "speed-change", "landing"):
        return speed_by_law(phase, air)
    return before.speed if before.speed is not None else 0.0


def _refuse_high(mission: Mission, phase: Phase) -> None:
    ceiling = mission.aircraft.ceiling if mission.aircraft else None
    if ceiling is not None and phase.altitude > ceiling:
        message = f"{height(phase.altitude)} is above the ceiling of {height(ceiling)}; fly lower"
        raise DesignError([Problem("altitude", message)])


def _refuse_jump(mission: Mission, phase: Phase, start: Node, before: _Before) -> None:
    """Refuse an airspeed that jumps from one phase to the next; what it would mean is told."""
    if before.speed is None or abs(start.speed - before.speed) <= SMOOTH:
        return
    change = start.speed - before.speed
    message = (
        f"starts at {start.speed:.4g} m/s, and the phase before ended at {before.speed:.4g} m/s: within a step of"
        f" {mission.step:g} s that is {change / mission.step:.3g} m/s²; make them equal, or put a phase of kind"
        ' "speed-change" between them'
    )
    raise DesignError([Problem("speed", message)])


def _after(mission: Mission, phase: Phase, path: Path | None, before: _Before) -> _Before:
    """Return how a phase ended."""
    if path is not None:
        end, speed = path.nodes[-1], path.nodes[-1].speed
        return _Before(end.altitude, speed, float(ramped(phase, end.time, before.propeller)), 0.0)
    speed = speed_by_law(phase, air_at(phase.altitude, mission.isa_offset_k))
    propeller = float(ramped(phase, phase_duration(phase, before.altitude), before.propeller))
    return _Before(phase.altitude, speed, propeller, 0.0)


class _Pusher(NamedTuple):
    """What turns the power of a phase into thrust and fuel."""

    flown: Flown
    phase: Phase
    before: _Before
    efficiency: float
    """Of gearbox, drag and dragged motors: power of the propeller over that of the machines [-]."""

    def __call__(self, state: State, /) -> Push:
        flown, phase = self.flown, self.phase
        moment, count = self.at(state), phase.engines or flown.mission.engines
        if phase.pitch is not None:
            power, held = thrust_at(flown.blades, moment, phase.pitch)
            return Push(count * held, count * _fuel(flown, phase, moment, power / self.efficiency))
        machines = phase.power or 0.0
        work = self.efficiency * (machines - self.spun(state))
        thrust = performed(flown.blades, moment, work).thrust
        assert thrust is not None  # `mission_problems` refuses it without a map
        return Push(count * thrust, count * _fuel(flown, phase, moment, machines))

    def spun(self, state: State) -> float:
        """Return what spins the train up [W]."""
        if state.time >= self.phase.ramp:
            return 0.0
        gain = (self.phase.propeller_speed - self.before.propeller) / self.phase.ramp
        return self.flown.gearbox.inertia * self.at(state).propeller_speed * gain

    def at(self, state: State) -> Moment:
        """Return a state as a moment of the mission."""
        air = air_at(state.altitude, self.flown.mission.isa_offset_k)
        speed = float(ramped(self.phase, state.time, self.before.propeller))
        return Moment(
            phase="", starts_phase=False, time=state.time, duration=1.0, altitude=state.altitude, air=air,
            true_airspeed=state.speed, acceleration=0.0, climb=0.0, propeller_speed=speed, propeller_gain=0.0,
            power=None,
        )  # fmt: skip


def _pusher(flown: Flown, phase: Phase, before: _Before) -> _Pusher:
    """Return what pushes in a phase, with the efficiency of the gearbox at its power."""
    pusher = _Pusher(flown, phase, before, 1.0)
    state = State(phase.ramp, before.altitude, before.speed or 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    moment = pusher.at(state)
    if phase.power is None:
        return pusher._replace(efficiency=USUAL_EFFICIENCY)
    parts, speed = flown.supply.parts(phase), moment.propeller_speed
    found = loaded(flown.gearbox, flown.supply, parts, power=phase.power, speed=speed)
    return pusher._replace(efficiency=float(found.point.work[0]) / phase.power)


def _fuel(flown: Flown, phase: Phase, moment: Moment, power: float) -> float:
    """Return the fuel flow of one gearbox's turbines at a power of all its machines [kg/s]."""
    supply = flown.supply
    parts = supply.parts(phase) if phase.strategy is None else dict.fromkeys(supply.engines, 1.0 / len(supply.engines))
    given = {name: part * power for name, part in parts.items() if name in supply.engines}
    return sum(supply.fuel(name, moment, max(share, 0.0)) for name, share in given.items())


def _burnt(flown: Flown, name: str, phase: Phase, paths: Paths, before: _Before) -> float:
    """Return what all engines burn in a phase, as an estimate [kg]; what cannot be flown is refused in flight."""
    mission, total = flown.mission, 0.0
    alone = mission.model_copy(update={"phases": {name: phase.model_copy(update={"from_altitude": before.altitude})}})
    try:
        for moment in moments(alone, paths):
            wanted = wanted_of(flown.blades, mission, moment, burnt=before.burnt + total).power
            power = moment.power or (wanted or 0.0) / USUAL_EFFICIENCY
            total += _fuel(flown, phase, moment, power) * moment.duration * (phase.engines or mission.engines)
    except DesignError:
        return total
    return total


# ----------------------------------------------------------------------------------------------------------------------
# Forces of a flight, phase by phase: thrust beside drag, what is left over, and airspeeds that jump.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_LIFT = 1.5
"""C_L beyond which an aircraft that says nothing of its stall stands on its wheels [-]; an assumption."""


@dataclass(frozen=True, repr=False)
class PhaseForces(Shown):
    """Mean forces of a phase of a flight, of the whole aircraft."""

    name: str
    duration: Time
    """[s]"""
    distance: Distance
    """Through the air [m]."""
    roll: Annotated[float, Quantity("ground_roll")]
    """On the wheels [m]."""
    mass: Mass
    """At its start [kg]."""
    thrust: Force | None
    """Of all propellers [N]; None without a propeller map."""
    drag: Annotated[Force, Origin("q S (C_D0 + k C_L²) + μ (m g − L)", "drag polar of the mission")]
    """Of air and wheels [N]."""
    path: Annotated[Force, Origin("m (g sin γ + dV/dt)", "Newton")]
    """What height and speed of the path take [N]."""
    jump: Annotated[float, Quantity("velocity")]
    """Of the true airspeed, from the end of the phase before to its start [m/s]."""
    jump_acceleration: Annotated[float, Quantity("acceleration"), Origin("ΔV/Δt", "over one step of the mission")]
    """What the jump means if it takes one interval [m/s²]."""
    reserve: bool
    """True where it is flown for its fuel only."""

    @property
    def left_over(self) -> Force | None:
        """Thrust that the path does not explain [N]; near 0 where an aircraft flies the phase."""
        return None if self.thrust is None else self.thrust - self.drag - self.path

    @property
    def implied(self) -> Annotated[float | None, Quantity("acceleration")]:
        """Acceleration along the path that the thrust left over would mean [m/s²]."""
        return None if self.left_over is None else self.left_over / self.mass


class _Row(NamedTuple):
    """Of one interval, or sums over them times the duration."""

    duration: float
    distance: float
    roll: float
    thrust: float
    drag: float
    path: float


@verb
def phase_forces(flight: Flight) -> tuple[PhaseForces, ...]:
    """Return what thrust, drag and path of each phase come to; nothing where the mission has no aircraft.

    Args:
        flight: As flown; a phase that states its power is held against the drag polar too.

    Source: Newton along the path: T = D + μ (m g − L) + m g sin γ + m dV/dt.
    """
    aircraft = flight.mission.aircraft
    return () if aircraft is None else tuple(_phases(flight, aircraft))


def _phases(flight: Flight, aircraft: Aircraft) -> Iterator[PhaseForces]:
    mission, burnt, last = flight.mission, 0.0, None
    for name, group in groupby(enumerate(moments(mission, flight.paths)), key=lambda row: row[1].phase):
        flown, phase, mass = list(group), mission.phases[name], aircraft.mass - burnt
        engines = phase.engines or mission.engines
        sums = list[_Row]()
        for (k, moment), stage in zip(flown, _stages(flight, aircraft, [moment for _, moment in flown]), strict=True):
            sums.append(_row(flight, aircraft, k, moment, stage=stage, mass=aircraft.mass - burnt))
            burnt += float(flight.history.fuel_flow[k]) * moment.duration * engines
        total = _Row(*(sum(column) for column in zip(*sums, strict=True)))
        starts, ends = (_at_end(flown[place][1], sense) for place, sense in ((0, -1.0), (-1, 1.0)))
        jump, last = 0.0 if last is None else starts - last, ends
        yield PhaseForces(
            name=name,
            duration=total.duration,
            distance=total.distance,
            roll=total.roll,
            mass=mass,
            thrust=None if flight.history.thrust is None else total.thrust / total.duration,
            drag=total.drag / total.duration,
            path=total.path / total.duration,
            jump=jump,
            jump_acceleration=jump / mission.step,
            reserve=phase.reserve,
        )


def _at_end(moment: Moment, sense: float) -> float:
    """Return the true airspeed at the end of an interval, or at its start where the sense is -1 [m/s]."""
    return moment.true_airspeed + sense * 0.5 * moment.acceleration * moment.duration


def _stages(flight: Flight, aircraft: Aircraft, flown: list[Moment]) -> tuple[str, ...]:
    """Return what the aircraft does in the intervals of a phase: on its wheels where no wing bears it."""
    name, weight = flown[0].phase, aircraft.mass * GRAVITY
    if name in flight.paths:
        return flight.paths[name].stages
    highest = (aircraft.highest_lift or USUAL_LIFT) * aircraft.wing_area
    lifts = (highest * 0.5 * moment.air.density * moment.true_airspeed**2 for moment in flown)
    return tuple("flight" if lift >= weight else "roll" for lift in lifts)


def _row(flight: Flight, aircraft: Aircraft, k: int, moment: Moment, *, stage: str, mass: float) -> _Row:
    """Return the share of the k-th interval in the sums: what the aircraft does there, and its mass [kg]."""
    phase, weight, duration = flight.mission.phases[moment.phase], mass * GRAVITY, moment.duration
    slope = moment.climb / moment.true_airspeed if moment.true_airspeed else 0.0
    rolls = {"roll": 1.0, "rotation": 0.5}.get(stage, 0.0)
    held = resistance(aircraft, phase, weight, Attitude(moment.air, moment.true_airspeed, slope, rolls))
    engines = phase.engines or flight.mission.engines
    thrust = 0.0 if flight.history.thrust is None else engines * float(flight.history.thrust[k])
    way = moment.true_airspeed * duration
    path = weight * slope + mass * moment.acceleration
    return _Row(duration, way, way if stage == "roll" else 0.0, thrust * duration, held * duration, path * duration)
