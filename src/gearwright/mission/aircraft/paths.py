"""The paths of all phases that an aircraft flies, one after the other, with the mass that is left for each."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.air import air_at, height, true_of_calibrated
from gearwright.errors import DesignError, Problem
from gearwright.mission.aircraft.given import Powered, Push, path_by_power
from gearwright.mission.aircraft.march import State
from gearwright.mission.aircraft.stated import stated_path
from gearwright.mission.collect import Flown
from gearwright.mission.loading import Asked, loaded
from gearwright.mission.moments import (
    Moment,
    Node,
    Path,
    Paths,
    moments,
    performed,
    phase_duration,
    ramped,
    speed_by_law,
    thrust_at,
    wanted_of,
)
from gearwright.spec import Mission, Phase

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
        return true_of_calibrated(phase.from_cas, air)
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
    point = loaded(flown, moment._replace(power=phase.power), Asked(flown.supply.parts(phase), None, 0.0), None).point
    return pusher._replace(efficiency=point.work / phase.power)


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
