"""Phases that fly with the power that they are given: what speed, height and distance follow from the thrust."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from gearwright.air import air_at, height
from gearwright.errors import DesignError, Problem
from gearwright.mission.aircraft.march import Rates, State, books, march
from gearwright.mission.moments import Attitude, Node, Path, lowest_speed, resistance, speed_by_law
from gearwright.spec import Aircraft, Phase
from gearwright.units import GRAVITY, apart

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
