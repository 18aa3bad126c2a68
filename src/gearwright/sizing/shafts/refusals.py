"""Shafts that come out without a diameter, as no load case loads them, or with too thin a wall: refused."""

from __future__ import annotations

import math
from collections.abc import Iterable

from gearwright.errors import Problem, refuse
from gearwright.sizing.carrying import ShaftSizing
from gearwright.units import text

NOTHING = 1e-9
"""Load over the largest one below which it is rounding [-]."""
MOST_HOLLOW = 0.95
"""Largest bore over diameter, as for bore_ratio [-]."""


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
    refuse(problems)


def refuse_bores(shafts: Iterable[ShaftSizing]) -> None:
    """Raise where a given bore leaves too thin a wall in a shaft.

    Args:
        shafts: As sized.

    Raises:
        DesignError: With the bore and the diameter of every such shaft.
    """
    problems = [
        Problem(
            f"layout.{shaft.name}.bore_mm",
            f"the bore {text(shaft.bore, 'length')} leaves too thin a wall in a shaft of"
            f" {text(shaft.diameter, 'length')}; it may be {MOST_HOLLOW:.0%} of the diameter: give a smaller bore",
        )
        for shaft in shafts
        if shaft.diameter and shaft.bore > MOST_HOLLOW * shaft.diameter
    ]
    refuse(problems)
