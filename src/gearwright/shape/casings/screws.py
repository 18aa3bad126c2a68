"""The screws of flanges as bodies: hexagon head, shank, nut and two washers, as heavy as they are weighed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.shape.casings.flanges import screw_places
from gearwright.shape.solids import Chamber, Fastener, Layer
from gearwright.sizing.casing import HEAD, HOLE, LENGTH, NUT, THICKNESS, WASHER, Flanges

SCREW = "screw"
"""What screws of flanges are named, and painted as."""


def flange_screw(thread: float) -> Fastener:
    """Return a screw about its own axis, the joint of its flange at z = 0, its head before it.

    Args:
        thread: Its diameter [m].
    """
    radius, washer, nut = thread / 2.0, WASHER[1] * thread, NUT[1] * thread
    face, head = THICKNESS * thread, HEAD[1] * thread
    below = -face - washer
    return Fastener((
        Layer(below - head, below, HEAD[0] * radius, is_hexagon=True),
        Layer(below, below + LENGTH * thread, radius),
        Layer(below, -face, WASHER[0] * radius, HOLE * radius),
        Layer(face, face + washer, WASHER[0] * radius, HOLE * radius),
        Layer(face + washer, face + washer + nut, NUT[0] * radius, radius, is_hexagon=True),
    ))  # fmt: skip


def placed_screws(flanges: Flanges, halves: Sequence[tuple[float, Chamber]]) -> Iterator[tuple[str, Floats]]:
    """Yield name and place of every screw: along the first shaft, then across it [m], shape (3,).

    Args:
        flanges: As they are weighed.
        halves: Where the joint of every flange stands along the first shaft [m], and a half of it.
    """
    for k, (joint, half) in enumerate(halves):
        for j, place in enumerate(screw_places(half, flanges.screws)):
            yield f"housing, {SCREW} {k + 1}.{j + 1}", np.array([joint, *place])
