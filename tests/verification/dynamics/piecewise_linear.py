"""A mesh with backlash solved piece by piece in closed form, contact times by root finding: nothing of gearwright.

In units of mesh stiffness and mass, δ the deflection: δ̈ + 2ζ δ̇ + g(δ) = F + a cos(Ωt), with g(δ) = δ, 0 and δ + B on
the one flank, between the flanks and on the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq, fsolve

GRID = 200
"""Instants of a period, or of one of the mesh if that is shorter, between which at most one contact begins or ends."""


class Case(NamedTuple):
    """A mesh with backlash."""

    damping: float
    """ζ."""
    load: float
    """F."""
    shake: float
    """a."""
    rate: float
    """Ω."""
    backlash: float
    """B."""

    @property
    def period(self) -> float:
        """2 π/Ω."""
        return 2.0 * math.pi / self.rate


class Piece(NamedTuple):
    """Motion on one flank, or between them."""

    place: Callable[[np.ndarray | float], np.ndarray | float]
    speed: Callable[[np.ndarray | float], np.ndarray | float]
    least: float
    most: float


def piece(case: Case, time: float, place: float, speed: float) -> Piece:
    """Return the motion that goes on from a state until it leaves its flank."""
    zeta, omega = case.damping, case.rate
    above = place > 0.0 or (place == 0.0 and speed > 0.0)
    below = place < -case.backlash or (place == -case.backlash and speed < 0.0)
    stiffness, force = (1.0, case.load - case.backlash * below) if above or below else (0.0, case.load)
    wave = case.shake / (stiffness - omega**2 + 2j * zeta * omega)

    def forced(t):
        return (wave * np.exp(1j * omega * t)).real

    def forced_rate(t):
        return (1j * omega * wave * np.exp(1j * omega * t)).real

    rest = speed - forced_rate(time)
    if stiffness:
        own, left = math.sqrt(1.0 - zeta**2), place - forced(time) - force
        swing = (rest + zeta * left) / own

        def at(t):
            x = t - time
            return np.exp(-zeta * x) * (left * np.cos(own * x) + swing * np.sin(own * x)) + forced(t) + force

        def rate(t):
            x = t - time
            sine = (zeta * rest + left) / own
            return np.exp(-zeta * x) * (rest * np.cos(own * x) - sine * np.sin(own * x)) + forced_rate(t)

        return Piece(at, rate, *((0.0, math.inf) if above else (-math.inf, -case.backlash)))
    drift = force / (2.0 * zeta)
    left, rest = place - forced(time), rest - drift

    def free(t):
        return left - rest / (2.0 * zeta) * np.expm1(-2.0 * zeta * (t - time)) + drift * (t - time) + forced(t)

    def free_rate(t):
        return rest * np.exp(-2.0 * zeta * (t - time)) + drift + forced_rate(t)

    return Piece(free, free_rate, -case.backlash, 0.0)


def leave(case: Case, time: float, place: float, speed: float, until: float) -> tuple[Piece, float, bool]:
    """Return the motion from a state on, the instant at which it leaves its flank or that is asked for, and which."""
    now = piece(case, time, place, speed)
    grid = np.linspace(time, until, max(8, int(GRID * (until - time) / min(case.period, 2.0 * math.pi))))[1:]
    values = now.place(grid)
    out = np.flatnonzero((values > now.most) | (values < now.least))
    if not len(out):
        return now, until, False
    edge = now.most if values[out[0]] > now.most else now.least
    since = grid[out[0] - 1] if out[0] else time + 1e-9 * (grid[0] - time)
    return now, brentq(lambda t: now.place(t) - edge, since, grid[out[0]], xtol=1e-15, rtol=1e-15), True


def flown(case: Case, place: float, speed: float, instants: np.ndarray) -> tuple[float, float, np.ndarray, int]:
    """Return the state after a period, the deflection at instants of it, and how often contact begins or ends."""
    time, seen, crossings = 0.0, np.full(len(instants), np.nan), 0
    while time < case.period:
        now, end, crossed = leave(case, time, place, speed, case.period)
        inside = (instants >= time) & (instants <= end)
        seen[inside] = now.place(instants[inside])
        edge = now.most if abs(now.place(end) - now.most) < abs(now.place(end) - now.least) else now.least
        time, place, speed, crossings = (
            end,
            edge if crossed else float(now.place(end)),
            now.speed(end),
            crossings + crossed,
        )
    return place, speed, seen, crossings


def orbit(case: Case, near: tuple[float, float], instants: np.ndarray) -> tuple[np.ndarray, int]:
    """Return the deflection of the periodic motion near a start, and how often contact begins or ends in it."""

    def gap(state):
        return np.array(flown(case, *state, instants[:0])[:2]) - state

    start = fsolve(gap, near, xtol=1e-12, full_output=True)[0]  # the next line, not its own words, judges it
    assert np.max(np.abs(gap(start))) < 1e-10
    return flown(case, *start, instants)[2:]


def exponent(case: Case, start: tuple[float, float], periods: int) -> float:
    """Return the largest Lyapunov exponent: two motions side by side, brought together again after each period."""
    none, nudge, total = np.zeros(0), 1e-8, 0.0
    one, other = start, (start[0] + nudge, start[1])
    for _ in range(periods):
        one, other = flown(case, *one, none)[:2], flown(case, *other, none)[:2]
        away = np.subtract(other, one)
        distance = float(np.hypot(*away))
        total += math.log(distance / nudge)
        other = tuple(np.add(one, away * nudge / distance))
    return total / (periods * case.period)


CASES = (
    Case(0.05, 1.0, 0.8, 0.8, 1e3),
    Case(0.05, 1.0, 0.5, 0.75, 1e3),
    Case(0.05, 1.0, 0.8, 0.6, 2.0),
    Case(0.1, 0.2, 1.0, 1.2, 1.0),
    Case(0.05, 0.1, 0.5, 0.5, 0.2),
    Case(0.02, 1.0, 0.3, 1.1, 1e3),
)
"""Contact that is lost on one flank, and on both; near the mode, and below it."""
