"""The optimal share: dynamic programming over the state of charge, backwards from the end of a mission."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats

FORBIDDEN = 1e9
"""Fuel of what cannot be flown [kg]."""
SHORT = 1e6
"""Fuel for a state of charge that lacks 1 at the end [kg]: more than any engine saves by it."""


class Stage(NamedTuple):
    """What shares cost in an interval."""

    fuel: Floats
    """Of every share; `FORBIDDEN` where a machine cannot give it, shape (shares,) [kg]."""
    after: Callable[[Floats], Floats]
    """States of charge, shape (charges,) -> after the interval, shape (charges, shares) [-]; NaN: cannot be."""


class Plan(NamedTuple):
    """Shares that burn least."""

    shares: tuple[int, ...]
    """Of every interval the place of its share among those that were tried."""
    charge: tuple[float, ...]
    """State of charge after it [-]."""
    fuel: float
    """[kg]"""


def optimal_plan(stages: Sequence[Stage], charges: Floats, *, start: float, end: float) -> Plan:
    """Return the shares with the least fuel that leave a state of charge at the end.

    Args:
        stages: Intervals in their order.
        charges: States of charge at which the least fuel from there on is kept, rising, shape (charges,) [-].
        start: State of charge at the start [-].
        end: At least left at the end [-].

    Source: Bellman 1957: J_k(s) = min_u (g_k(u) + J_(k+1)(f_k(s, u))), linear between the states of charge.
    """
    costs = [SHORT * np.maximum(end - charges, 0.0)]
    for stage in reversed(stages):
        costs.append(_whole(stage, charges, costs[-1], charges).min(axis=1))
    costs.reverse()
    places, states, fuel, now = list[int](), list[float](), 0.0, start
    for stage, later in zip(stages, costs[1:], strict=True):
        at = np.array([now])
        place = int(np.argmin(_whole(stage, charges, later, at)[0]))
        fuel += float(stage.fuel[place])
        now = float(stage.after(at)[0, place])
        places.append(place)
        states.append(now)
    return Plan(tuple(places), tuple(states), fuel)


def _whole(stage: Stage, charges: Floats, later: Floats, at: Floats) -> Floats:
    """Return the fuel of every share from some states of charge to the end, shape (at, shares) [kg]."""
    after = stage.after(at)
    inside = (after >= charges[0] - 1e-12) & (after <= charges[-1] + 1e-12)
    cost = np.interp(np.where(inside, after, charges[0]), charges, later) + stage.fuel
    return np.minimum(np.where(inside, cost, FORBIDDEN), FORBIDDEN)
