"""Blade angle and thrust of a propeller by the Hamilton Standard method, from its charts.

The charts hold for an activity factor of 150 and an integrated design lift coefficient of 0.5; factors carry them to
other blades. The charts themselves are data and are read by the catalogue.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.machines.chart_reading import Blades, Charts, Look


class Performance(NamedTuple):
    """A propeller at one advance ratio and power coefficient."""

    blade_angle: float
    """β at three quarters of the radius [rad]."""
    thrust_coefficient: float
    """C_T with compressibility [-]."""
    compressibility: float
    """Factor on the incompressible C_T [-]."""
    held: tuple[str, ...]
    """Tables that were left and held at their end, and laws that the point breaks; empty for a point to trust."""


def performance(
    charts: Charts, blades: Blades, advance_ratio: float, *, power_coefficient: float, mach: float = 0.0,
    tip_mach: float = 0.0,
) -> Performance:  # fmt: skip
    """Return blade angle and thrust coefficient of a propeller that takes a power.

    Args:
        charts: From the catalogue.
        blades: The propeller.
        advance_ratio: J = V/(n D) [-].
        power_coefficient: C_P = P/(ρ n³ D⁵) [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971). The jump of the critical Mach number between standstill and
        motion is smoothed: the static excess fades out linearly until J = 0.5.

    Valid for: where `held` of the result is empty.

    Raises:
        SolveError: No thrust coefficient answers to the chart's value.
    """
    look = Look(charts, blades)
    if not 0.0 <= advance_ratio <= charts.advance_ratio[-1]:
        look.held.add("advance ratio")
        advance_ratio = min(max(advance_ratio, 0.0), float(charts.advance_ratio[-1]))
    angle, thrusts = look.incompressible(advance_ratio, power_coefficient)
    thrust = look.over_counts(thrusts)
    if not look.held:
        look.guard(advance_ratio, power_coefficient, thrust)
    factor = look.compressibility(advance_ratio, thrusts, mach=mach, tip_mach=tip_mach)
    return Performance(math.radians(angle), float(thrust * factor), float(factor), tuple(sorted(look.held)))


def compressibility(
    charts: Charts, blades: Blades, advance_ratio: float, *, thrust_coefficient: float, mach: float, tip_mach: float
) -> tuple[float, tuple[str, ...]]:
    """Return the factor of the air's compressibility on C_T [-], and the tables that were left.

    Args:
        charts: From the catalogue.
        blades: The propeller.
        advance_ratio: J = V/(n D) [-].
        thrust_coefficient: C_T without compressibility [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971); as in `performance`.

    Valid for: where no table was left.
    """
    look = Look(charts, blades)
    thrusts = [thrust_coefficient] * len(look.counts)
    factor = look.compressibility(advance_ratio, thrusts, mach=mach, tip_mach=tip_mach)
    return float(factor), tuple(sorted(look.held))
