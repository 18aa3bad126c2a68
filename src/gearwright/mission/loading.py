"""An interval's loads: the operating point for what is asked, and what each machine gives with drag and spin-up."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.mission.collect import Flown
from gearwright.mission.gearbox import Drag, Point, drag, efficiencies, operate
from gearwright.mission.moments import Moment

TRIAL_POWER = 1e5
"""Power at which an operating point is found before it is scaled [W]; torques and powers are proportional."""
MET = 1e-12
"""Difference of the propeller's power from the asked one that is met, over all that is given [-]."""
MOST_TRIALS = 20
"""Trials for it: the power is nearly linear in what is given, and two or three do."""


class Asked(NamedTuple):
    """What an interval asks of the gearbox."""

    parts: Mapping[str, float]
    """Machine -> part of the power [-]."""
    propeller: float | None
    """Power of its shaft [W]; None where the machines' power is given."""
    spin_up: float
    """Power into everything that turns [W]."""


class Loaded(NamedTuple):
    """A gearbox under the loads of an interval."""

    point: Point
    """Of the gearbox."""
    friction: Drag
    """Beside its meshes."""
    dragged: float
    """What motors without current take [W]."""
    powers: Mapping[str, float]
    """Machine -> power into the train, with drag and spin-up [W]."""

    @property
    def total(self) -> float:
        """Of all machines that give or take by their parts [W]."""
        return sum(self.powers.values())


def loaded(flown: Flown, moment: Moment, asked: Asked, before: Point | None) -> Loaded:
    """Return the loads of an interval.

    Args:
        flown: Gearbox, propeller, mission and machines.
        moment: Where it is flown.
        asked: Of the gearbox.
        before: Point of the interval before; None at the start.
    """
    gearbox, supply = flown.gearbox, flown.supply
    # Losses are those of the last interval's loads; where the loads change at once, they are found twice.
    point = _operating(flown, moment, asked, before)
    if before is None or moment.starts_phase:
        point = _operating(flown, moment, asked, point)
    friction, dragged = drag(gearbox, point), supply.dragged(gearbox, point, asked.parts)
    carried = sum(friction) + dragged + asked.spin_up
    rigid = zip(gearbox.machines, point.machine_powers.tolist(), strict=True)
    powers = {name: power + asked.parts.get(name, 0.0) * carried for name, power in rigid}
    return Loaded(point, friction, dragged, powers)


def _operating(flown: Flown, moment: Moment, asked: Asked, last: Point | None) -> Point:
    """Return the operating point for a propeller power, or for the machines' power where that is given.

    A propeller that the air drives has a negative power: it is found with machines that take power, so that losses
    stay losses.
    """
    gearbox, supply = flown.gearbox, flown.supply
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
    rubbed, dragged = sum(drag(gearbox, at(moment.power or 0.0))), supply.dragged(gearbox, point, asked.parts)
    left = (moment.power or 0.0) - asked.spin_up - rubbed - dragged
    if left <= 0.0:
        raise DesignError([Problem("power", _eaten(moment.power or 0.0, asked.spin_up, rubbed, dragged))])
    return at(left)


def _eaten(power: float, spin_up: float, rubbed: float, dragged: float) -> str:
    """Return what takes a power before it reaches the propeller."""
    parts = (("bearings and oil", rubbed), ("motors that are dragged", dragged), ("spinning the train up", spin_up))
    taken = ", ".join(f"{name} {1e-3 * value:.3g} kW" for name, value in parts if value > 0.0)
    fix = "give more, or a longer ramp_s" if spin_up > 0.0 else "give more"
    return f"of {1e-3 * power:.4g} kW nothing reaches the propeller: {taken}; {fix}"


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
