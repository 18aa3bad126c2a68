"""Flanges of a housing: how many screws of which thread hold two halves together, how wide and thick those are."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.sizing.casing.shell import Shell
from gearwright.sizing.result import Sizing

WIDTH, THICKNESS = 2.5, 1.2
"""Of each of the two halves of a flange, over its screws [-]: usual proportions of cast housings."""
THREADS = (6e-3, 8e-3, 10e-3, 12e-3, 16e-3, 20e-3, 24e-3, 30e-3, 36e-3, 42e-3, 48e-3, 56e-3, 64e-3)
"""Coarse threads of the first choice of ISO 261, from the thinnest that is usual in housings [m]."""
PITCH = 5.0
"""Largest distance of screws over their diameter [-]: room for a spanner, and no gap between."""
PRELOAD = 700e6
"""Of screws of class 10.9, in their section [Pa]: three quarters of R_p0.2 = 940 MPa (ISO 898-1)."""
FRICTION = 0.15
"""Of a flange's faces [-]: dry steel or iron."""
LENGTH, HEAD, NUT, WASHER = 4.0, (1.6, 0.65), (1.6, 0.87), (2.0, 0.25)
"""Over its diameter [-]: length of a screw, which reaches through both halves, nut and two washers; across flats and
height of head and nut, diameter and thickness of a washer: M6 to M20 of ISO 4017, ISO 4032 and ISO 7089, rounded."""
HOLE = 1.1
"""Clearance hole over the screw [-]: ISO 273, medium, from M6 to M20."""


class Flanges(NamedTuple):
    """Equal flanges of a housing."""

    number: int
    """How many of them [-]."""
    thread: float
    """Diameter of their screws [m]."""
    screws: int
    """Of each [-]."""
    girth: float
    """Perimeter of the wall that they are weighed around [m]."""

    @property
    def thickness(self) -> float:
        """Of each half [m]."""
        return THICKNESS * self.thread

    @property
    def face(self) -> float:
        """Area of each half's face, the holes of its screws not taken off [m²]."""
        return WIDTH * self.thread * self.girth


def flanges_of(sizing: Sizing, shell: Shell, torque: float) -> Flanges:
    """Return the flanges of a housing: one for every stage, at least both ends of one.

    Args:
        sizing: As sized.
        shell: Around it.
        torque: That each holds by its grip [N m].

    Source: n π/4 d² σ μ r = T with n = U/(5 d) screws on r = U/(2 π), rounded up to a thread and to whole screws.
    """
    wanted = 8.0 * PITCH * torque / (FRICTION * PRELOAD * shell.girth**2)
    thread = next((thread for thread in THREADS if thread >= wanted), wanted)
    return Flanges(max(len(sizing.design.stages), 2), thread, math.ceil(shell.girth / (PITCH * thread)), shell.girth)


def screw_volume(thread: float) -> float:
    """Return the volume of a screw with nut and two washers [m³].

    Args:
        thread: Its diameter [m].

    >>> round(screw_volume(1.0), 2)
    6.92
    """
    heights = LENGTH * math.pi / 4.0
    heads = HEAD[1] * hexagon(HEAD[0]) + NUT[1] * (hexagon(NUT[0]) - math.pi / 4.0)
    washers = 2.0 * WASHER[1] * math.pi / 4.0 * (WASHER[0] ** 2 - HOLE**2)
    return (heights + heads + washers) * thread**3


def hexagon(flats: float) -> float:
    """Return the area of a hexagon [m²].

    Args:
        flats: Across them [m].
    """
    return math.sqrt(3.0) / 2.0 * flats**2
