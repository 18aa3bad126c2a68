"""Statics: the equilibrium of loads, line forces and errors at one instant, with contact found line by line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.dynamics.equations.modes import split_rigid
from gearwright.dynamics.equations.reference import dead_zone, external_load, line_state, speed_factor
from gearwright.dynamics.model import (
    Arrays,
    Labels,
    System,
    entry_matrix,
    finite_numbers,
    line_matrix,
    refuse_not_finite,
)
from gearwright.errors import SolveError
from gearwright.verbs import verb

BALANCE_TOLERANCE = 1e-6
"""Largest power of the loads on a rigid motion, over the sum of its parts [-]: room for rounded radii."""
CONTACT_ROUNDS = 200
"""Rounds in which contact must settle; lines open or close in each."""
WHOLE = 1e-6
"""How near to one whole step Newton's last, in which no line opened or closed, must be [-]."""
TRACE = 1e-9
"""Share of a line's stiffness that is used to look for contact while it stands open [-]."""

Balance = Literal["required", "accelerate"]


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Static equilibrium, measured from the rigid motion."""

    position: Floats
    """q [rad or m], shape (coordinates,); of least kinetic norm where rigid motions leave it open."""
    force: Floats
    """Line forces [N or N m], shape (lines,)."""
    labels: Labels
    """Names of coordinates and lines."""


@verb
def statics(system: System, *, time: float = 0.0, balance: Balance = "required") -> Equilibrium:
    """Return the elastic equilibrium under the loads, stiffnesses and errors of one instant.

    Args:
        system: Bodies, lines, loads.
        time: Instant [s].
        balance: ``"required"`` refuses loads that would set a rigid motion going; ``"accelerate"`` lets it go and finds
            the shape that it keeps under that steady acceleration (inertia relief).

    Raises:
        SolveError: If loads do not balance on a motion that no line holds, or contact does not settle.
    """
    with finite_numbers(system):
        equilibrium = _equilibrium(system, time, balance)
    refuse_not_finite(equilibrium.position, system.labels.coordinates, "static position")
    refuse_not_finite(equilibrium.force, system.labels.lines, "static force")
    return equilibrium


def _equilibrium(system: System, time: float, balance: Balance) -> Equilibrium:
    arrays = system.arrays
    elastic = split_rigid(arrays)[1]
    load = steady_load(arrays, time)
    left = unbalanced(system, time=time) if balance == "required" else ""
    if left:
        raise SolveError(f"{left}; balance the loads or add a support")
    position = _settle(arrays, time, elastic, load)
    return Equilibrium(position, line_state(arrays, time, position, np.zeros_like(position)).force, system.labels)


def unbalanced(system: System, *, time: float = 0.0) -> str:
    """Return what the loads leave over on a motion that nothing holds, in words; empty if they balance.

    Args:
        system: Bodies, lines, loads.
        time: Instant [s].
    """
    arrays = system.arrays
    load = steady_load(arrays, time)
    for motion in split_rigid(arrays)[0].T:
        parts = motion * load
        if abs(np.sum(parts)) > BALANCE_TOLERANCE * np.sum(np.abs(parts)):
            scale = motion[np.argmax(np.abs(motion))]
            shape = motion / scale
            names = system.labels.coordinates
            moving = ", ".join(f"{names[i]} {shape[i]:.3g}" for i in np.flatnonzero(np.abs(shape) > 1e-9))
            left = np.sum(parts) / scale
            return f"nothing holds the motion ({moving}) and the loads on it do not balance: they leave {left:.4g} N m"
    return ""


def steady_load(arrays: Arrays, time: float) -> Floats:
    """Return what acts on the coordinates in the rigid motion: external loads, and dampers by their slip [N or N m].

    Args:
        arrays: The system's numbers.
        time: Instant [s].
    """
    slipping = arrays.damping * arrays.slip * speed_factor(arrays.profile, time)[0]
    return external_load(arrays, time, np.zeros(len(arrays.mass))) - line_matrix(arrays).T @ slipping


def _settle(arrays: Arrays, time: float, elastic: Floats, load: Floats) -> Floats:
    """Minimise the potential, which contact makes convex and piecewise quadratic: Newton with an exact line search."""
    start = line_state(arrays, time, np.zeros_like(load), np.zeros_like(load))
    matrix, error = line_matrix(arrays) @ elastic, -start.deflection
    centripetal = speed_factor(arrays.profile, time)[0] ** 2 * entry_matrix(arrays.centripetal, len(load))
    centripetal = elastic.T @ centripetal @ elastic
    place, pull = np.zeros(elastic.shape[1]), elastic.T @ load
    touching = _touching(-error, arrays.backlash)
    for _ in range(CONTACT_ROUNDS):
        deflection = matrix @ place - error
        force = matrix.T @ (start.stiffness * dead_zone(deflection, arrays.backlash))
        # A trace of the stiffness of open lines lets bodies whose teeth all stand open move until they touch.
        tangent = matrix.T @ (np.where(touching, 1.0, TRACE)[:, None] * start.stiffness[:, None] * matrix) - centripetal
        way = np.linalg.solve(tangent, pull + centripetal @ place - force)
        bend = -float(way @ centripetal @ way)
        slope = _Slope(deflection, matrix @ way, arrays.backlash, start.stiffness)
        reach = _reach(slope, float(way @ (pull + centripetal @ place)), bend)
        place = place + reach * way
        before, touching = touching, _touching(matrix @ place - error, arrays.backlash)
        if np.array_equal(before, touching) and abs(reach - 1.0) < WHOLE:
            return np.asarray(elastic @ place)
    raise SolveError(f"contact did not settle in {CONTACT_ROUNDS} rounds at {time:g} s; lines open and close in turn")


def _touching(deflection: Floats, backlash: Floats) -> Bools:
    """Return which lines carry: linear ones always, others outside their gap."""
    return np.asarray((backlash == 0.0) | (deflection >= 0.0) | (deflection < -backlash))


class _Slope(NamedTuple):
    """What decides the potential's slope along a direction."""

    deflection: Floats
    rate: Floats
    backlash: Floats
    stiffness: Floats

    def elastic(self, distance: float) -> float:
        """Return the elastic forces' part of the slope."""
        contact = dead_zone(self.deflection + distance * self.rate, self.backlash)
        return float(np.sum(self.stiffness * contact * self.rate))


def _reach(slope: _Slope, pull: float, bend: float) -> float:
    """Return the distance at which the slope vanishes: straight between the points where a line opens or closes."""
    if not np.any(slope.rate):
        return 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        points = np.concatenate([-slope.deflection / slope.rate, -(slope.deflection + slope.backlash) / slope.rate])
    points = np.sort(points[np.isfinite(points) & (points > 0.0)])
    low, at_low = 0.0, slope.elastic(0.0) - pull
    for high in (*points, 2.0 * np.max(points, initial=0.5) + 1.0):
        at_high = slope.elastic(high) - pull + bend * high
        if at_high >= 0.0 or high > np.max(points, initial=0.0):
            break
        low, at_low = high, at_high
    if at_high <= at_low:
        raise SolveError("the loads push a body away from every line that could hold it; add a support")
    return float(low - at_low * (high - low) / (at_high - at_low))
