"""Reference right-hand side in numpy, mesh stiffness and errors over time, and the energy balance."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import Bools, Energy, Floats, Origin, Quantity, SolveError
from gearwright.dynamics.model import (
    Acting,
    Arrays,
    Profile,
    Schedules,
    Series,
    System,
    along_lines,
    drive_effects,
    entry_matrix,
    onto_coordinates,
)
from gearwright.train.graph import null_space

# ----------------------------------------------------------------------------------------------------------------------
# The right-hand side in plain numpy: the oracle that every compiled one must agree with.
# ----------------------------------------------------------------------------------------------------------------------


class LineState(NamedTuple):
    """What every line does at one instant; arrays of shape (lines,)."""

    deflection: Floats
    """δ [m or rad]."""
    rate: Floats
    """δ̇ with the slip of dampers [m/s or rad/s]."""
    contact: Floats
    """g(δ): deflection in contact [m or rad]."""
    stiffness: Floats
    """k(φ) [N/m or N m/rad]."""
    stiffness_rate: Floats
    """dk/dt [N/(m s) or N m/(rad s)]."""
    error_rate: Floats
    """ė [m/s or rad/s]."""
    force: Floats
    """f = k g + c δ̇ [N or N m]."""


def speed_factor(profile: Profile, time: float) -> tuple[float, float, float]:
    """Return speed factor s [-], its rate [1/s] and the travel τ = ∫ s dt [s].

    Args:
        profile: Speed factor against time.
        time: [s].
    """
    t, s = profile.time, profile.factor
    i = int(np.searchsorted(t, time, side="right")) - 1
    if i < 0:
        return float(s[0]), 0.0, float(s[0] * time)
    elapsed = time - t[i]
    slope = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if i + 1 < len(t) else 0.0
    factor = s[i] + slope * elapsed
    return float(factor), float(slope), float(profile.travel[i] + 0.5 * (s[i] + factor) * elapsed)


def line_state(arrays: Arrays, time: float, position: Floats, velocity: Floats) -> LineState:
    """Return deflections, stiffnesses and forces of all lines.

    Args:
        arrays: The system's numbers.
        time: [s].
        position: q [rad or m], shape (coordinates,).
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
    """
    factor, _, travel = speed_factor(arrays.profile, time)
    angle, rate = arrays.tone_rate * travel, arrays.tone_rate * factor
    error, error_rate = _sums(arrays.error, angle, rate)
    variation, variation_rate = _sums(arrays.variation, angle, rate)
    deflection = along_lines(arrays, position) - error
    deflection_rate = along_lines(arrays, velocity) - error_rate + factor * arrays.slip
    contact = dead_zone(deflection, arrays.backlash)
    stiffness = arrays.stiffness * (1.0 + variation)
    force = stiffness * contact + arrays.damping * deflection_rate
    stiffness_rate = arrays.stiffness * variation_rate
    return LineState(deflection, deflection_rate, contact, stiffness, stiffness_rate, error_rate, force)


def dead_zone(deflection: Floats, backlash: Floats) -> Floats:
    """Return the deflection in contact: δ over zero, nothing in the gap, δ + B on the back flank.

    Args:
        deflection: δ [m or rad].
        backlash: B [m or rad].
    """
    back = deflection < -backlash
    return np.where(deflection > 0.0, deflection, 0.0) + np.where(back, deflection + np.where(back, backlash, 0.0), 0.0)


def _sums(series: Series, angle: Floats, rate: Floats) -> tuple[Floats, Floats]:
    """Return each line's Fourier sum and its time derivative."""
    lines = len(series.start) - 1
    row = np.arange(lines).repeat(series.start[1:] - series.start[:-1])
    cos, sin = np.cos(angle)[series.tone], np.sin(angle)[series.tone]
    value = series.cosine * cos + series.sine * sin
    slope = (series.sine * cos - series.cosine * sin) * rate[series.tone]
    value, slope = (np.bincount(row, part, lines).astype(float, copy=False) for part in (value, slope))
    return value, slope


def driven(arrays: Arrays, time: float, velocity: Floats, states: Floats | None = None) -> Acting:
    """Return what the drives do at one instant.

    Args:
        arrays: The system's numbers.
        time: [s].
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    total = arrays.speed * speed_factor(arrays.profile, time)[0] + velocity
    inputs = _scheduled(arrays.drives.inputs, time)
    return drive_effects(arrays.drives, total, inputs, arrays.drives.start if states is None else states)


def external_load(arrays: Arrays, time: float, velocity: Floats, states: Floats | None = None) -> Floats:
    """Return the external load on each coordinate [N or N m], shape (coordinates,).

    Args:
        arrays: The system's numbers.
        time: [s].
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    loads = arrays.loads
    total = arrays.speed * speed_factor(arrays.profile, time)[0] + velocity
    load = loads.constant - loads.damping * velocity - loads.quadratic * np.abs(total) * total
    np.add.at(load, loads.schedules.dof, _scheduled(loads.schedules, time))
    return load + driven(arrays, time, velocity, states).torque


def _scheduled(schedules: Schedules, time: float) -> Floats:
    rows = [slice(*pair) for pair in zip(schedules.start[:-1], schedules.start[1:], strict=True)]
    return np.array([np.interp(time, schedules.time[row], schedules.value[row]) for row in rows], dtype=float)


def acceleration(
    arrays: Arrays, time: float, position: Floats, velocity: Floats, states: Floats | None = None
) -> Floats:
    """Return q̈ of each coordinate [rad/s² or m/s²], shape (coordinates,).

    Args:
        arrays: The system's numbers.
        time: [s].
        position: q [rad or m], shape (coordinates,).
        velocity: q̇ [rad/s or m/s], shape (coordinates,).
        states: Of the drives, shape (states,); left out: as at time 0.
    """
    size = len(arrays.mass)
    factor, slope, _ = speed_factor(arrays.profile, time)
    force = external_load(arrays, time, velocity, states) - arrays.mass * arrays.speed * slope
    force -= onto_coordinates(arrays, line_state(arrays, time, position, velocity).force)
    force -= factor * (entry_matrix(arrays.gyroscopic, size) @ velocity)
    force += factor**2 * (entry_matrix(arrays.centripetal, size) @ position)
    return force / arrays.mass


# ----------------------------------------------------------------------------------------------------------------------
# Instants: how fast a system runs, and the stiffness and error of each of its lines, at many times at once.
# ----------------------------------------------------------------------------------------------------------------------


def speed_factors(profile: Profile, time: Floats) -> tuple[Floats, Floats, Floats]:
    """Return s [-], ṡ [1/s] and τ [s] at many times; `reference.speed_factor` does it for one.

    Args:
        profile: Speed factor against time.
        time: Rising [s], shape (times,).
    """
    t, s = profile.time, profile.factor
    factor, slope, travel = np.empty((3, len(time)))
    first, last = (int(np.searchsorted(t, end, side="right")) - 1 for end in (time[0], time[-1]))
    cuts = [0, *np.searchsorted(time, t[first + 1 : last + 1]).tolist(), len(time)]
    for piece, (low, high) in zip(range(first, last + 1), pairwise(cuts), strict=True):
        i = max(piece, 0)
        elapsed = time[low:high] - t[i]
        rate = (s[i + 1] - s[i]) / (t[i + 1] - t[i]) if 0 <= piece < len(t) - 1 else 0.0
        factor[low:high], slope[low:high] = s[i] + rate * elapsed, rate
        travel[low:high] = profile.travel[i] + 0.5 * (s[i] + factor[low:high]) * elapsed
    return factor, slope, travel


def stiffness_at(system: System, time: Floats) -> Floats:
    """Return the stiffnesses of all lines at some instants [N/m or N m/rad], shape (instants, lines).

    Args:
        system: Whose lines.
        time: [s], shape (instants,).
    """
    arrays = system.arrays
    _, _, travel = speed_factors(arrays.profile, time)
    return np.asarray(arrays.stiffness * (1.0 + _series(arrays, arrays.variation, travel)))


def errors_at(system: System, time: Floats) -> Floats:
    """Return the errors of all lines at some instants [m or rad], shape (instants, lines).

    Args:
        system: Whose errors.
        time: [s], shape (instants,).
    """
    _, _, travel = speed_factors(system.arrays.profile, time)
    return _series(system.arrays, system.arrays.error, travel)


def _series(arrays: Arrays, series: Series, travel: Floats) -> Floats:
    """Fourier sums of all lines at many travels, shape (travels, lines)."""
    lines = len(series.start) - 1
    angle = np.outer(travel, arrays.tone_rate)
    cosine, sine = np.zeros((2, angle.shape[1], lines))
    line = np.repeat(np.arange(lines), np.diff(series.start))
    np.add.at(cosine, (series.tone, line), series.cosine)
    np.add.at(sine, (series.tone, line), series.sine)
    return np.asarray(np.cos(angle) @ cosine + np.sin(angle) @ sine)


# ----------------------------------------------------------------------------------------------------------------------
# Energy: where the work of a run came from and where it went, and whether it adds up.
# ----------------------------------------------------------------------------------------------------------------------


WORKS = 6
"""Energies that run along with the state: all of `Work` but what is stored."""


ENERGY_ROUNDING = 1e-11
"""Share of the energy that is held which counts as rounding: a train at rest on its rigid motion moves none [-]."""


@dataclass(frozen=True)
class Work:
    """Energy balance of a run, from its start to its end."""

    driven: Energy
    """Work of loads that drive their coordinate [J]."""
    braked: Energy
    """Work taken out by loads that resist [J]."""
    dissipated: Annotated[float, Quantity("energy"), Origin("∫ Σ c δ̇² dt", "energy balance of the lines")]
    """Heat in the lines' dampers [J]."""
    stiffness: Annotated[float, Quantity("energy"), Origin("∫ Σ ½ k̇ g² dt", "energy balance of the lines")]
    """Work of the changing stiffness [J]."""
    error: Annotated[float, Quantity("energy"), Origin("−∫ Σ ė f dt", "energy balance of the lines")]
    """Work of errors that move under force [J]."""
    frame: Energy
    """Work that keeps a rotating frame at its speed [J]."""
    stored: Energy
    """Growth of kinetic and elastic energy [J]."""
    held: Energy
    """Kinetic and elastic energy at the end [J]: what rounding is measured by."""

    @property
    def imbalance(self) -> float:
        """What does not add up, over all the work that was moved [-]; zero where it is only rounding."""
        gain = self.driven - self.braked - self.dissipated + self.stiffness + self.error + self.frame
        moved = sum(abs(work) for work in (self.driven, self.braked, self.dissipated, self.stored))
        missing = abs(gain - self.stored)
        return missing / moved if missing > ENERGY_ROUNDING * self.held else 0.0


# ----------------------------------------------------------------------------------------------------------------------
# Potential: the least of the elastic energy of lines with dead zones under loads, and why there may be none.
#
# The energy ½ Σ k g(δ)² of lines that part is convex and piecewise quadratic, so that every train whose loads some
# forces of its lines can carry has an equilibrium, and only those. Newton's method finds it from where it would be
# with all teeth in contact, with a trace of the stiffness of lines that stand open, and each step as long as brings
# the energy to its least along it.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 200
"""Rounds in which contact must settle; three are usual."""
SETTLED = 1e-11
"""Forces that are left over, over those that act, at which contact has settled [-]."""
FORCE_ROUNDING = 1e-14
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
        if np.linalg.norm(left) <= SETTLED * acting + FORCE_ROUNDING * moved:
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
