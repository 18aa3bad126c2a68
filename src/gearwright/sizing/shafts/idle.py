"""Shafts that no load case loads: strength asks nothing of them, so that they have no size but a given one."""

from __future__ import annotations

import math
from collections.abc import Iterable

from gearwright.errors import DesignError, Problem
from gearwright.sizing.result import ShaftSizing

NOTHING = 1e-9
"""Load over the largest one below which it is rounding [-]."""


def refuse_idle_shafts(shafts: Iterable[ShaftSizing]) -> None:
    """Raise where nothing loads a shaft whose diameter is not given.

    Args:
        shafts: As sized.

    Raises:
        DesignError: For every such shaft, with what to give.
    """
    sized = list(shafts)
    load = {shaft.name: math.hypot(shaft.torque, shaft.bending_moment) for shaft in sized}
    largest, thickest = max(load.values()), max(shaft.diameter for shaft in sized)
    problems = [
        Problem(
            f"layout.{shaft.name}.diameter_mm",
            f"no load case loads the shaft {shaft.name!r}, so that strength asks for no diameter; give one, such as"
            f" {1e3 * thickest:.3g}, or a case that loads it",
        )
        for shaft in sized
        if load[shaft.name] <= NOTHING * largest and shaft.diameter <= math.cbrt(NOTHING) * thickest
    ]
    if problems:
        raise DesignError(problems)
