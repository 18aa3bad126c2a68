"""Rooms of a housing: cross-sections that can be cast, without short steps, each within the wider one beside it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gearwright.ranking import smallest
from gearwright.sizing.arranged import Body
from gearwright.sizing.casing.loops import SAME, loop_size
from gearwright.sizing.casing.shell import Stretch, stretches_around

LEAST, SHORTEST = 2.0, 0.02
"""Length of a room over the wall's thickness [-], and in metres, below which it is one with its neighbour."""


def rooms_around(bodies: Sequence[Body], wall: float) -> list[Stretch]:
    """Return the rooms around bodies, from the first end to the last.

    Args:
        bodies: That stand in the housing.
        wall: Thickness [m].
    """
    return _nested(_long_enough(list(stretches_around(bodies)), wall))


def _long_enough(stretches: list[Stretch], wall: float) -> list[Stretch]:
    """Return cross-sections without steps that are too short to cast: one with the neighbour that grows least."""
    found = list(stretches)
    while len(found) > 1:
        k = smallest(range(len(found)), lambda k: found[k].length)
        if found[k].length >= max(LEAST * wall, SHORTEST):
            break
        beside = [_joined(found[j], found[k]) for j in (k - 1, k + 1) if 0 <= j < len(found)]
        _, one = smallest(beside, lambda choice: choice[0])
        low = next(j for j, each in enumerate(found) if each.start == one.start)
        found[low : low + 2] = [one]
    return found


def _joined(one: Stretch, other: Stretch) -> tuple[float, Stretch]:
    """Return by how much two neighbours grow when they become one [m³], and that one."""
    reach, least = np.maximum(one.reach, other.reach), np.maximum(one.least, other.least)
    whole = min(one, other, key=lambda each: each.start)
    around, area = loop_size(reach)
    whole = Stretch(whole.start, max(one.end, other.end), reach, least, around, area)
    return whole.area * whole.length - one.area * one.length - other.area * other.length, whole


def _nested(stretches: list[Stretch]) -> list[Stretch]:
    """Return cross-sections of which, side by side, one lies in the other: the larger one reaches around both."""
    found, again = list(stretches), True
    while again:
        again = False
        for k, (one, other) in enumerate(pairwise(found)):
            if all(np.any(a.reach > b.reach + SAME) for a, b in ((one, other), (other, one))):
                j = k if one.area >= other.area else k + 1
                reach, least = np.maximum(one.reach, other.reach), np.maximum(one.least, other.least)
                found[j], again = found[j]._replace(reach=reach, least=least), True
    return found
