"""Flanges of a housing: where along it they stand, their halves, and where their screws are."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from gearwright.arrays import Floats
from gearwright.ranking import largest
from gearwright.shape.solids import Chamber, without
from gearwright.sizing.casing import HEAD, LENGTH, THICKNESS, WASHER, Flanges, Stretch
from gearwright.sizing.casing.loops import NEAR, SAME, inside_of, loop_around, ways_of

SIDES = 48
"""Directions in which loops around a housing are measured [-]."""
FLANGES = "flange"
"""What halves of flanges are named."""
NEARLY = (0.8, 0.6, 0.4, 0.0)
"""Perimeter over the longest one from which a cross-section carries flanges [-]: the width of flanges grows with it."""
ENDS = ((THICKNESS + WASHER[1] + HEAD[1]) / THICKNESS, (LENGTH - WASHER[1]) / THICKNESS - 1.0)
"""From the joint to the outside of a screw's head and to the end of its thread, over the thickness of a half [-]."""
ROOM = 1.05 * sum(ENDS)
"""From flange to flange over the thickness of a half [-]: halves, heads and ends of screws, and some air."""


Span = tuple[float, float]


def flange_halves(
    flanges: Flanges, stretches: Sequence[Stretch], wall: float, taken: Sequence[Sequence[Span]]
) -> Iterator[tuple[float, str, Chamber]]:
    """Yield place, key and solid of both halves of every flange, as heavy as they are weighed.

    Args:
        flanges: As they are weighed.
        stretches: Cross-sections of the housing, each within the wider one beside it.
        wall: Thickness of the wall [m].
        taken: Of every cross-section, between which places something stands outside of its wall [m].
    """
    for k, place in _joints(stretches, flanges.number, flanges.thickness, wall, taken):
        solid = _flange(inside_of(stretches[k], wall) + wall, flanges.face, flanges.thickness)
        yield place - flanges.thickness, f" {k + 1}", solid
        yield place, f" {k + 1}", solid


def _joints(
    stretches: Sequence[Stretch], count: int, thick: float, wall: float, taken: Sequence[Sequence[Span]]
) -> list[tuple[int, float]]:
    """Return number of the cross-section and place of every flange, from the first end to the last [m].

    They stand apart around cross-sections nearly as long around as the longest one; where there is no room for screws
    between them, around shorter ones, too.
    """
    longest, found = max(one.perimeter for one in stretches), list[tuple[int, float]]()
    room = 1.05 * ENDS[1] * thick
    plain = [_beside_plates(stretches, k, room + wall) for k in range(len(stretches))]
    clear = [_beside(span, held, room) for span, held in zip(plain, taken, strict=True)]
    free = clear if any(low <= high for low, high in clear) else plain
    for least in NEARLY:
        wide = [k for k, one in enumerate(stretches) if one.perimeter >= least * longest and free[k][0] <= free[k][1]]
        if not wide:
            continue
        ends = np.cumsum([stretches[k].length for k in wide])
        found = []
        for share in np.linspace(0.0, float(ends[-1]), count):
            j = int(np.searchsorted(ends, share - NEAR))
            place = stretches[wide[j]].end + share - float(ends[j])
            low, high = free[wide[j]]
            found.append((wide[j], min(max(place, low), high)))
        if all(other[1] - one[1] > ROOM * thick for one, other in pairwise(found)):
            break
    return found


def _beside_plates(stretches: Sequence[Stretch], k: int, room: float) -> tuple[float, float]:
    """Return from where to where a flange may stand: away from plates of wider chambers beside its own [m]."""
    own, low, high = stretches[k], stretches[k].start, stretches[k].end
    if k > 0 and np.any(stretches[k - 1].reach > own.reach + SAME):
        low += room
    if k + 1 < len(stretches) and np.any(stretches[k + 1].reach > own.reach + SAME):
        high -= room
    return low, high


def _beside(free: Span, taken: Sequence[Span], room: float) -> Span:
    """Return the longest piece of a stretch on which a flange is clear of what stands outside of the wall [m]."""
    if not taken or free[0] > free[1]:
        return free
    left = without([free], [(low - room, high + room) for low, high in taken])
    return largest(left, lambda span: span[1] - span[0]) if left else (free[0], free[0] - room)


def _flange(reach: Floats, face: float, thick: float) -> Chamber:
    """Return one half of a flange around a wall: as wide as its face is large [m²]."""
    inner = loop_around(reach)
    around = float(np.sum(np.linalg.norm(np.roll(inner, -1, axis=0) - inner, axis=1)))
    more = len(reach) * math.tan(math.pi / len(reach))
    wide = (math.sqrt(around**2 + 4.0 * more * face) - around) / (2.0 * more)
    return Chamber(loop_around(reach + wide), inner, (0.0, thick))


def screw_loop(half: Chamber) -> Floats:
    """Return the middle of a flange's face, along which its screws stand [m], shape (n, 2).

    Args:
        half: One half of the flange.
    """
    ways = ways_of(SIDES)
    return loop_around(np.asarray([(ways @ one.T).max(axis=1) for one in (half.outer, half.inner)]).mean(axis=0))


def screw_places(half: Chamber, number: int) -> Floats:
    """Return where the screws of a flange stand, equally far apart along the middle of its face [m], shape (n, 2).

    Args:
        half: One half of the flange.
        number: Of screws.
    """
    loop = screw_loop(half)
    closed = np.concatenate([loop, loop[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    at = (np.arange(number) + 0.5) * along[-1] / number
    return np.stack([np.interp(at, along, closed[:, 0]), np.interp(at, along, closed[:, 1])], axis=1)
