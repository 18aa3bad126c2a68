"""Held energy: what a system's bodies and lines hold at an instant, in translated Python."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.codegen import address
from gearwright.dynamics.codegen.loops import library, packed
from gearwright.dynamics.equations import speed_factor
from gearwright.dynamics.model import Arrays, planned


class Springs(NamedTuple):
    """Numbers of a system, as `Arrays` has them."""

    size: int
    """Coordinates."""
    lines: int
    mass: Floats
    speed: Floats
    stiffness: Floats
    backlash: Floats
    start: Ints
    """Of each line's weights, shape (lines + 1,)."""
    dof: Ints
    weight: Floats
    rate: Floats
    """Of the tones [rad/s]."""
    variation_start: Ints
    variation_tone: Ints
    variation_cosine: Floats
    variation_sine: Floats
    error_start: Ints
    error_tone: Ints
    error_cosine: Floats
    error_sine: Floats


def stored(c: Springs, factor: float, travel: float, state: Floats) -> float:
    """Return kinetic energy at absolute speed plus elastic energy [J] of (q, q̇) at a speed factor and its travel."""
    twice = 0.0
    for i in range(c.size):
        speed = c.speed[i] * factor + state[c.size + i]
        twice += c.mass[i] * speed * speed
    for j in range(c.lines):
        deflection, varied = 0.0, 1.0
        for i in range(c.start[j], c.start[j + 1]):
            deflection += c.weight[i] * state[c.dof[i]]
        for i in range(c.error_start[j], c.error_start[j + 1]):
            angle = c.rate[c.error_tone[i]] * travel
            deflection -= c.error_cosine[i] * math.cos(angle) + c.error_sine[i] * math.sin(angle)
        for i in range(c.variation_start[j], c.variation_start[j + 1]):
            angle = c.rate[c.variation_tone[i]] * travel
            varied += c.variation_cosine[i] * math.cos(angle) + c.variation_sine[i] * math.sin(angle)
        contact = max(deflection, 0.0)
        if deflection < -c.backlash[j]:
            contact = deflection + c.backlash[j]
        twice += c.stiffness[j] * varied * contact * contact
    return 0.5 * twice


def stored_energy(arrays: Arrays, time: float, state: Floats) -> float:
    """Return kinetic energy at absolute speed plus elastic energy [J].

    Args:
        arrays: The system's numbers.
        time: [s].
        state: q [rad or m] and q̇ [rad/s or m/s], shape (2 coordinates, …).
    """
    factor, _, travel = speed_factor(arrays.profile, time)
    _, place = _springs(arrays)
    return float(library(stored).function("stored")(place, factor, travel, address(state)))


@planned
def _springs(arrays: Arrays) -> tuple[Ints, int]:
    """Return the numbers as translated Python reads them, and where they stand."""
    a = arrays
    series = (*a.variation, *a.error)
    numbers = (a.mass, a.speed, a.stiffness, a.backlash, a.line_start, a.line_dof, a.line_weight, a.tone_rate, *series)
    given = packed(Springs(len(a.mass), len(a.stiffness), *numbers))
    return given, address(given)
