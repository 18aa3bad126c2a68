"""The constant that published gearboxes set, and how well sums then agree with gearboxes that were left out."""

from __future__ import annotations

from typing import NamedTuple


class Calibration(NamedTuple):
    """What no rule of parts gives."""

    stress_share: float
    """Shear stress in a housing at rated torque over the working stress of its material [-]."""
    details: float
    """What no rule counts (splines, nuts, spacers, plugs) over the parts that are counted [-]; an estimate: a fit of it
    beside the other gives nothing more than zero."""
    scatter: float
    """Factor of one standard deviation of sums over published masses, each left out of its own fit [-]."""


CALIBRATED = Calibration(0.107, 0.05, 1.27)
"""Fitted to published gearboxes; the scatter with each left out of its fit (benchmarks/gearbox_masses.py --fit)."""
