"""Reynolds' equation of a full journal bearing by finite differences, which the closed laws are held against."""

from typing import NamedTuple

import numpy as np


class Film(NamedTuple):
    """What a film does at an eccentricity."""

    load: float
    """So [-]."""
    attitude: float
    """β [rad]."""
    flow: float
    """Over D³ ψ ω [-]."""


def solved(eccentricity: float, width_ratio: float, *, around: int = 240, across: int = 20) -> Film:
    """Return a film whose pressure is nowhere below zero, by successive over-relaxation of a half bearing.

    Args:
        eccentricity: ε [-].
        width_ratio: B/D [-].
        around: Cells along the circumference, from widest gap to widest gap.
        across: Cells from the middle to the edge.
    """
    angle, place = np.linspace(0.0, 2.0 * np.pi, around + 1), np.linspace(0.0, 1.0, across + 1)
    step, deep = angle[1], place[1] * width_ratio
    gap = 1.0 + eccentricity * np.cos(angle)
    after, before = ((1.0 + eccentricity * np.cos(angle + side * step / 2.0)) ** 3 / step**2 for side in (1, -1))
    after, before, cross = (part[:, None] for part in (after, before, gap**3 / deep**2))
    pushed = (6.0 * eccentricity * np.sin(angle))[:, None]
    inside = np.zeros((around + 1, across + 1), dtype=bool)
    inside[1:-1, :-1] = True
    even = np.add.outer(np.arange(around + 1), np.arange(across + 1)) % 2 == 0
    over = 2.0 / (1.0 + np.sin(np.pi / max(around / 2, 2 * across)))
    pressure = np.zeros_like(cross * place)
    for _ in range(5000):
        last = pressure.copy()
        for colour in (inside & even, inside & ~even):
            ahead, behind = np.roll(pressure, -1, axis=0), np.roll(pressure, 1, axis=0)
            out, inner = np.roll(pressure, -1, axis=1), np.roll(pressure, 1, axis=1)
            inner[:, 0] = pressure[:, 1]
            wanted = (after * ahead + before * behind + cross * (out + inner) + pushed) / (after + before + 2.0 * cross)
            pressure = np.where(colour, np.maximum(pressure + over * (wanted - pressure), 0.0), pressure)
        if np.abs(pressure - last).max() < 1e-6 * pressure.max():
            break
    mean = np.trapezoid(pressure, place, axis=1)
    along, side = (np.trapezoid(mean * law(angle), angle) for law in (np.cos, np.sin))
    edge = (3.0 * pressure[:, -1] - 4.0 * pressure[:, -2] + pressure[:, -3]) / (2.0 * deep)
    flow = 2.0 * np.trapezoid(-edge * gap**3 / 12.0, angle) / 8.0
    return Film(float(np.hypot(along, side)) / 2.0, float(np.arctan2(side, -along)), float(flow))
