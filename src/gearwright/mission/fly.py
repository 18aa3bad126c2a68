"""The verb: a mission flown quasi-steadily by a sized gearbox."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

from gearwright.catalogue import propeller_map, read_propeller_map
from gearwright.errors import DesignError, Problem, SolveError, refuse
from gearwright.machines import PropellerMap
from gearwright.mission.collect import Flown, Interval, Lost, collect, recorded
from gearwright.mission.consumers import flown_airscrew
from gearwright.mission.endurance import Clocks, bounds_of, endured
from gearwright.mission.flight import Flight
from gearwright.mission.gearbox import Point, drag, efficiencies, gearbox_of, operate
from gearwright.mission.oil import flown_oil
from gearwright.mission.profile import Moment, moments
from gearwright.mission.supply import Given, Terms, machine_speeds, supply_of
from gearwright.mission.thrust import Blades, performed, propeller_power
from gearwright.sizing import Sizing
from gearwright.spec import NO_MAP, Mission, engine_out, is_map_file, mission_problems
from gearwright.verbs import verb

TRIAL_POWER = 1e5
"""Power at which an operating point is found before it is scaled [W]; torques and powers are proportional."""
MET = 1e-12
"""Difference of the propeller's power from the asked one that is met, over all that is given [-]."""
MOST_TRIALS = 20
"""Trials for it: the power is nearly linear in what is given, and two or three do."""


class _Before(NamedTuple):
    """What an interval takes over from the one before it."""

    point: Point | None
    """Of the gearbox; None at the start."""
    charge: float
    """State of charge [-]."""
    burnt: float
    """Fuel of all engines [kg]."""
    clocks: Clocks
    """How long limits of machines have been passed."""


class _Asked(NamedTuple):
    """What an interval asks of the gearbox."""

    parts: Mapping[str, float]
    """Machine -> part of the power [-]."""
    propeller: float | None
    """Power of its shaft [W]; None where the machines' power is given."""
    spin_up: float
    """Power into everything that turns [W]."""


@verb
def fly(sizing: Sizing, mission: Mission, *, folder: Path | None = None) -> Flight:
    """Return the flight: what a mission asks of every shaft and mesh, and what it burns.

    Every interval is in equilibrium, with the power that spins the train up; the aircraft's own acceleration between
    two phases is left out. Drag and spin-up load the machines, not the meshes.

    Args:
        sizing: The sized transmission; it has one propeller.
        mission: What is flown, with one such gearbox for each of its engines.
        folder: Where a propeller map is looked for that is a file; left out: where the program runs.

    Raises:
        DesignError: A power that the machines cannot give, a battery that is empty or overloaded, a point outside the
            propeller map; with phase and time.

    Valid for: steady flight; a propeller map of one's own has the compressibility that it was measured with.
    """
    problems = mission_problems(mission)
    refuse(problems)
    gearbox = gearbox_of(sizing, flown_airscrew(sizing), flown_oil(sizing, mission))
    blades = Blades(mission.propeller_map, _chart(mission, folder), sizing.design.airscrews[gearbox.propeller].diameter)
    flown = Flown(gearbox, blades, mission, supply_of(sizing, mission))
    before, intervals = (
        _Before(None, mission.battery.start_charge if mission.battery else 0.0, 0.0, {}),
        list[Interval](),
    )
    for moment in moments(mission):
        try:
            interval = _interval(flown, moment, before)
            clocks = _clocks(flown, moment, interval, before.clocks)
        except DesignError as error:
            raise _placed(error, moment) from None
        intervals.append(interval)
        engines = mission.phases[moment.phase].engines or mission.engines
        burnt = before.burnt + interval.values.fuel_flow * moment.duration * engines
        before = _Before(interval.point, interval.values.state_of_charge, burnt, clocks)
    return collect(flown, intervals)


def _chart(mission: Mission, folder: Path | None) -> PropellerMap | None:
    name = mission.propeller_map
    if name == NO_MAP:
        return None
    return read_propeller_map((folder or Path()) / name) if is_map_file(name) else propeller_map(name)


def _placed(error: DesignError, moment: Moment) -> DesignError:
    at = f"phases.{moment.phase}"
    return DesignError(
        [Problem(at, f"at {moment.time:.0f} s, {problem.path}: {problem.message}") for problem in error.problems]
    )


def _interval(flown: Flown, moment: Moment, before: _Before) -> Interval:
    """Return what is recorded of an interval."""
    gearbox, blades, mission, supply = flown
    phase = mission.phases[moment.phase]
    parts = supply.parts(phase)
    wanted = propeller_power(blades, mission, moment, burnt=before.burnt)
    spin_up = gearbox.inertia * moment.propeller_speed * moment.propeller_gain / moment.duration
    # Losses are those of the last interval's loads; where the loads change at once, they are found twice.
    point = _operating(flown, moment, _Asked(parts, wanted, spin_up), before.point)
    if before.point is None or moment.starts_phase:
        point = _operating(flown, moment, _Asked(parts, wanted, spin_up), point)
    friction, dragged = drag(gearbox, point), supply.dragged(gearbox, point, parts)
    carried = sum(friction) + dragged + spin_up
    rigid = zip(gearbox.machines, point.machine_powers.tolist(), strict=True)
    powers = {name: power + parts.get(name, 0.0) * carried for name, power in rigid}
    rating = mission.engine.contingency if engine_out(mission, phase) else 1.0
    drawn = supply.drive(gearbox, moment, Given(point, powers), Terms(before.charge, rating, phase.mode))
    performance = performed(blades, moment, point.work)
    lost = Lost(point.mesh_loss, friction, drawn.motor_loss + dragged, spin_up)
    return Interval(moment.phase, recorded(moment, point.work, performance, drawn, lost), powers, point)


def _clocks(flown: Flown, moment: Moment, interval: Interval, before: Clocks) -> Clocks:
    """Return how long limits of machines have been passed after an interval."""
    gearbox, _, mission, supply = flown
    contingency = mission.engine.contingency if engine_out(mission, mission.phases[moment.phase]) else 1.0
    overload = dict.fromkeys(supply.motors, mission.motor.overload) | dict.fromkeys(supply.engines, contingency)
    ratings = {name: rating * overload[name] for name, rating in supply.ratings.items()}
    speeds = machine_speeds(gearbox, interval.point)
    points = {name: (power, speeds[name]) for name, power in interval.powers.items()}
    return endured(bounds_of(gearbox.sizing.design.machines, ratings), before, moment.duration, points)


def _operating(flown: Flown, moment: Moment, asked: _Asked, last: Point | None) -> Point:
    """Return the operating point for a propeller power, or for the machines' power where that is given.

    A propeller that the air drives has a negative power: it is found with machines that take power, so that losses
    stay losses.
    """
    gearbox, _, _, supply = flown
    efficiency = efficiencies(gearbox, last) if last is not None else {}

    def given(power: float) -> Point:
        """Return the point at which the machines give a power [W]."""
        machines = {name: part * power for name, part in asked.parts.items()}
        return operate(gearbox, machines, moment.propeller_speed, efficiency)

    if asked.propeller is not None and gearbox.demand:
        return _met(given, asked.propeller, asked.propeller + gearbox.demand)
    point = given(math.copysign(TRIAL_POWER, asked.propeller or 0.0))
    if asked.propeller is not None:
        return point.scaled(asked.propeller / point.work)
    at = given if gearbox.demand else lambda power: point.scaled(power / TRIAL_POWER)
    left = (moment.power or 0.0) - asked.spin_up - sum(drag(gearbox, at(moment.power or 0.0)))
    left -= supply.dragged(gearbox, point, asked.parts)
    if left <= 0.0:
        message = f"{(moment.power or 0.0) / 1e3:.4g} kW only spin the train up; give more, or a longer ramp_s"
        raise DesignError([Problem("power", message)])
    return at(left)


def _met(given: Callable[[float], Point], wanted: float, power: float) -> Point:
    """Return the point at which the propeller has its power, by secants from a first guess of what is given [W]."""
    point, slope = given(power), 1.0
    for _ in range(MOST_TRIALS):
        missing = wanted - point.work
        if abs(missing) <= MET * (abs(wanted) + abs(power)):
            return point
        power += missing / slope
        before, point = point, given(power)
        slope *= (point.work - before.work) / missing
        if not slope:
            break
    raise SolveError(f"no power of the machines gives the propeller its {wanted / 1e3:.4g} kW")
