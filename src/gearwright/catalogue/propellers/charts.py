"""The Hamilton Standard charts from their data file, and what they say of a propeller at a blade angle."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

import numpy as np

from gearwright.catalogue.tables import data_text
from gearwright.errors import Problem, SolveError
from gearwright.machines import Blades, Charts, performance
from gearwright.machines.propellers import BladeShape

_CHARTED: tuple[tuple[str, float, float], ...] = (
    ("number", 2, 8), ("activity_factor", 80.0, 200.0), ("design_lift", 0.3, 0.8)
)  # fmt: skip
"""What the charts know of blades."""


def charted_problems(blades: Blades | BladeShape) -> list[Problem]:
    """Return why the charts say nothing of a propeller.

    Args:
        blades: The propeller.
    """
    if not isinstance(blades, Blades):
        return [Problem("by", "charts know no stations of a blade; give activity factor and design lift")]
    return spanned(blades, _CHARTED)


def spanned(blades: Blades | BladeShape, spans: Iterable[tuple[str, float, float]]) -> list[Problem]:
    """Return what of generic blades lies outside its span.

    Args:
        blades: The propeller.
        spans: Name, least and most.
    """
    given = spans if isinstance(blades, Blades) else ()
    values = [(name, getattr(blades, name), low, high) for name, low, high in given]
    return [
        Problem(f"blades.{name}", f"{value:g}: give {low:g} to {high:g}, or a blade file")
        for name, value, low, high in values
        if not low <= value <= high
    ]


@cache
def hamilton_standard_charts() -> Charts:
    """Return the charts of NASA CR-114399, with two misprints read as their file says."""
    raw = json.loads(data_text("hamilton_standard.json"))
    for correction in raw["corrections"]:
        *path, last = correction["place"]
        table = raw
        for part in path:
            table = table[part]
        table[last] = correction["read_as"]
    return _charts(raw)


def _charts(raw: Mapping[str, Any]) -> Charts:
    number, lift, squeeze, activity = raw["blade_number"], raw["lift"], raw["compressibility"], raw["activity_factor"]
    return Charts(
        blade_counts=np.array(raw["blade_counts"], dtype=float),
        advance_ratio=np.array(raw["advance_ratio"], dtype=float),
        blade_angle=_rows(raw["blade_angle_deg"]),
        power=tuple(_rows(rows) for rows in raw["power_coefficient"]),
        thrust=tuple(_rows(rows) for rows in raw["thrust_coefficient"]),
        activity_factor=np.array(activity["activity_factor"]),
        activity_power=np.array(activity["power_at_J0_and_J_half_and_above"]),
        activity_thrust=np.array(activity["thrust_at_J0_and_J_half_and_above"]),
        number_power=(
            np.array(number["effective_power_coefficient"]),
            np.array(number["power_factor_by_blade_count"]),
        ),
        number_thrust=(
            np.array(number["effective_thrust_coefficient"]),
            np.array(number["thrust_factor_by_blade_count"]),
        ),
        lift=np.array(lift["integrated_design_lift"]),
        lift_power=(_rows(lift["power_coefficient"]), _rows(lift["power_factor"])),
        lift_thrust=(_rows(lift["thrust_coefficient"]), _rows(lift["thrust_factor"])),
        lift_scale=np.array([lift["power_scale_by_advance_ratio"], lift["thrust_scale_by_advance_ratio"]]),
        critical_mach=(
            np.array(squeeze["advance_ratio"]),
            np.array(squeeze["critical_flight_mach_by_lift"]),
            np.array(squeeze["critical_tip_mach_static_by_lift"]),
        ),
        compressibility=(
            np.array(squeeze["excess_mach"]),
            np.array(squeeze["effective_thrust_coefficient"]),
            np.array(squeeze["factor"]),
        ),
    )


def _rows(lists: Iterable[list[float]]) -> tuple[np.ndarray[Any, np.dtype[np.float64]], ...]:
    return tuple(np.array(row, dtype=float) for row in lists)


def charted_point(blades: Blades, advance_ratio: float, blade_angle: float) -> tuple[float, float] | None:
    """Return C_P and C_T by the Hamilton Standard method at a blade angle, without compressibility.

    Args:
        blades: The propeller.
        advance_ratio: J [-].
        blade_angle: β at three quarters of the radius [rad].

    Returns:
        C_P and C_T [-], or None where the charts do not hold the point.
    """
    from scipy.optimize import brentq

    charts = hamilton_standard_charts()

    def excess(power: float) -> float:
        return performance(charts, blades, advance_ratio, power_coefficient=power).blade_angle - blade_angle

    low, high = 0.005, 3.0
    try:
        if excess(low) > 0.0 or excess(high) < 0.0:
            return None
        power = float(brentq(excess, low, high, xtol=1e-10))
        point = performance(charts, blades, advance_ratio, power_coefficient=power)
    except SolveError:
        return None
    if point.held or point.thrust_coefficient <= 0.0 or abs(excess(power)) > 1e-7:
        return None
    return power, point.thrust_coefficient
