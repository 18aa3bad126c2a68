"""Potential: the least of the elastic energy of lines with dead zones under loads, and why there may be none.

The energy ½ Σ k g(δ)² of lines that part is convex and piecewise quadratic, so that every train whose loads some forces
of its lines can carry has an equilibrium, and only those. Newton's method finds it from where it would be with all
teeth in contact, with a trace of the stiffness of lines that stand open, and each step as long as brings the energy to
its least along it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.dynamics.equations.reference import dead_zone
from gearwright.errors import SolveError
from gearwright.train.algebra import null_space

ROUNDS = 200
"""Rounds in which contact must settle; three are usual."""
SETTLED = 1e-11
"""Forces that are left over, over those that act, at which contact has settled [-]."""
ROUNDING = 1e-14
"""Share of the deflections that rounding may leave in those of lines that touch [-]."""
HELD_BACK = 1e-7
"""Share of the whole stiffness that open lines keep in Newton's steps, since bodies may hang on them alone [-]."""
CARRIED = 1e-9
"""Share of the loads that lines may leave over and still carry them: rounding [-]."""


class Potential(NamedTuple):
    """Lines and loads in the elastic motions x."""

    matrix: Floats
    """Deflection per motion, shape (lines, motions)."""
    error: Floats
    """[m or rad], shape (lines,)."""
    backlash: Floats
    """[m or rad], shape (lines,)."""
    stiffness: Floats
    """[N/m or N m/rad], shape (lines,)."""
    pull: Floats
    """Loads on the motions, shape (motions,)."""
    centripetal: Floats
    """What speed takes from the stiffness, shape (motions, motions)."""


def escape(potential: Potential) -> Floats:
    """Return the motion in which the loads drive bodies away from every line that could hold them; zeros if in none.

    Args:
        potential: Lines and loads.

    Source: Farkas' lemma: the loads are carried by forces, not negative in lines that only press, or there is a motion
        that stretches no line, presses none and on which the loads do work; least squares leave over just that motion.
    """
    held = potential.stiffness > 0.0
    lines = potential.matrix[held] / np.linalg.norm(potential.matrix[held], axis=1, keepdims=True)
    presses = np.isinf(potential.backlash[held])
    free = null_space(lines[~presses])
    pull = free.T @ potential.pull
    pressing = (lines[presses] @ free).T
    if not pull.size or not np.any(pull):
        return np.zeros_like(potential.pull)
    from scipy.optimize import nnls  # a third of a second to load, and only this needs it

    left = pull - pressing @ nnls(pressing, pull)[0] if np.any(presses) else pull
    carried = np.linalg.norm(left) <= CARRIED * np.linalg.norm(potential.pull)
    return np.zeros_like(potential.pull) if carried else free @ left


def least(potential: Potential) -> Floats:
    """Return the motions at the least of the potential, shape (motions,).

    Args:
        potential: Lines and loads that they carry (`escape`).

    Raises:
        SolveError: If speed takes more stiffness than the lines have.
    """
    root = np.sqrt(potential.stiffness)
    # Motions in which all lines together have unit stiffness, so that soft and stiff ones count alike.
    basis, scale = np.linalg.qr(root[:, None] * potential.matrix)
    inverse = np.linalg.inv(scale)
    scaled = potential._replace(
        matrix=basis, error=root * potential.error, backlash=root * potential.backlash, stiffness=np.ones_like(root),
        pull=inverse.T @ potential.pull, centripetal=inverse.T @ potential.centripetal @ inverse,
    )  # fmt: skip
    if np.max(np.linalg.eigvalsh(scaled.centripetal), initial=0.0) >= 1.0:
        raise SolveError("at this speed bodies fly outwards harder than their lines hold them; there is no equilibrium")
    return np.asarray(inverse @ _newton(scaled))


def _newton(scaled: Potential) -> Floats:
    """Return the least place of a potential whose lines have unit stiffness, all together too."""
    place = np.linalg.solve(np.eye(len(scaled.pull)) - scaled.centripetal, scaled.pull + scaled.matrix.T @ scaled.error)
    for _ in range(ROUNDS):
        deflection = scaled.matrix @ place - scaled.error
        contact = dead_zone(deflection, scaled.backlash)
        turned = scaled.centripetal @ place
        left = scaled.pull + turned - scaled.matrix.T @ contact
        acting = np.linalg.norm(scaled.pull) + np.linalg.norm(contact) + np.linalg.norm(turned)
        moved = np.linalg.norm(scaled.matrix @ place) + np.linalg.norm(scaled.error)
        if np.linalg.norm(left) <= SETTLED * acting + ROUNDING * moved:
            return np.asarray(place, dtype=np.float64)
        way = _way(scaled, touching(deflection, scaled.backlash), left)
        slope = Slope(deflection, scaled.matrix @ way, scaled.backlash)
        bend = -float(way @ scaled.centripetal @ way)
        place = place + reach(slope, float(way @ (scaled.pull + turned)), bend) * way
    raise SolveError(
        f"contact did not settle in {ROUNDS} rounds; forces of {np.linalg.norm(left) / acting:.1e} are left over"
    )


def _way(scaled: Potential, touching: Bools, left: Floats) -> Floats:
    """Return the step of Newton's method, held back by a share of the stiffness that open lines would have."""
    size, touched = len(left), scaled.matrix[touching]
    held_back = HELD_BACK
    while held_back < 1.0:
        tangent = touched.T @ touched * (1.0 - held_back) + held_back * np.eye(size) - scaled.centripetal
        try:
            np.linalg.cholesky(tangent)
            return np.asarray(np.linalg.solve(tangent, left))
        except np.linalg.LinAlgError:  # speed takes more than the lines that touch have; all of them have enough
            held_back *= 10.0
    return np.asarray(np.linalg.solve(np.eye(size) - scaled.centripetal, left))


def touching(deflection: Floats, backlash: Floats) -> Bools:
    """Return which lines carry: linear ones always, others outside their gap."""
    return np.asarray((backlash == 0.0) | (deflection >= 0.0) | (deflection < -backlash))


class Slope(NamedTuple):
    """What decides the potential's slope along a direction."""

    deflection: Floats
    rate: Floats
    backlash: Floats

    def elastic(self, distance: float) -> float:
        """Return the elastic forces' part of the slope."""
        return float(self.rate @ dead_zone(self.deflection + distance * self.rate, self.backlash))


def reach(slope: Slope, pull: float, bend: float) -> float:
    """Return the distance at which the slope vanishes: straight between the points where a line opens or closes."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        points = np.concatenate([-slope.deflection / slope.rate, -(slope.deflection + slope.backlash) / slope.rate])
    points = np.unique(points[np.isfinite(points) & (points > 0.0)])
    ends = np.append(points, 2.0 * np.max(points, initial=0.5) + 1.0)
    low, at_low = 0.0, slope.elastic(0.0) - pull
    for high in ends.tolist():
        at_high = slope.elastic(high) - pull + bend * high
        if at_high >= 0.0:
            break
        if high < ends[-1]:
            low, at_low = high, at_high
    # Only rounding keeps a slope from rising along a way down.
    return float(low - at_low * (high - low) / (at_high - at_low)) if at_high > at_low else 1.0
