"""How long machines may give more than their ratings: limits for a time, held against flights without a break."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from gearwright.errors import Problem, refuse
from gearwright.spec import Machine
from gearwright.units import apart

_SLACK = 1e-6
"""Part by which a bound may be passed: drag is that of the loads one round before."""


class Bound(NamedTuple):
    """A power or torque of a machine, and for how long without a break it may be reached."""

    machine: str
    name: str
    """``power`` or ``torque``."""
    value: float
    """[W] or [N m]"""
    duration: float
    """[s]; infinite for any time."""


Clocks = Mapping[Bound, float]
"""Bound -> time without a break for which it has been passed [s]."""


def bounds_of(machines: Mapping[str, Machine], ratings: Mapping[str, float]) -> tuple[Bound, ...]:
    """Return the bounds of machines that have limits; the others' are their ratings, which hold for any time.

    Args:
        machines: By name.
        ratings: Machine -> power that the mission lets it give for any time [W].
    """
    bounds = list[Bound]()
    for name, machine in machines.items():
        if machine.limits and name in ratings:
            bounds.append(Bound(name, "power", ratings[name], math.inf))
        for limit in machine.limits.values():
            for what, value in (("power", limit.power), ("torque", limit.torque)):
                if value is not None:
                    bounds.append(Bound(name, what, value, limit.duration or math.inf))
    return tuple(bounds)


def endured(
    bounds: tuple[Bound, ...], clocks: Clocks, duration: float, points: Mapping[str, tuple[float, float]]
) -> Clocks:
    """Return for how long each bound has been passed after an interval.

    Args:
        bounds: From `bounds_of`.
        clocks: Before the interval.
        duration: Of the interval [s].
        points: Machine -> power [W] and speed [rad/s].

    Raises:
        DesignError: If one is passed for longer than a higher one allows.
    """
    after, problems = dict[Bound, float](), dict[str, Problem]()
    for bound in bounds:
        power, speed = points[bound.machine]
        value = abs(power) if bound.name == "power" else abs(power) / speed if speed else 0.0
        if value <= bound.value * (1.0 + _SLACK):
            continue
        after[bound] = clocks.get(bound, 0.0) + duration
        higher = [other for other in bounds if other[:2] == bound[:2] and other.value > bound.value]
        allowed = max((other.duration for other in higher), default=0.0)
        if after[bound] > allowed * (1.0 + _SLACK):
            problems.setdefault(bound.machine, _worn(bound, value, after[bound], allowed))
    refuse(problems.values())
    return after


def _worn(bound: Bound, value: float, held: float, allowed: float) -> Problem:
    """Return what is wrong with a machine that gives or takes too much, or for too long."""
    amount = "{}; more than {}".format(*apart(value, bound.value, bound.name))
    if not allowed:
        return Problem(bound.machine, f"{amount} is beyond every limit that it has; ask for less, or add a limit")
    lasts, may = apart(held, allowed, "flight_time")
    message = f"{amount} lasts {lasts} without a break, and its limits allow {may}"
    return Problem(bound.machine, f"{message}; shorten the phase, or ask for less")
