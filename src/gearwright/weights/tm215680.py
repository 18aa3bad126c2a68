"""The straight line that NASA/TM-2009-215680 draws through its gearbox weights."""

from __future__ import annotations

from gearwright.errors import DesignError, Problem
from gearwright.units import POUND

INTERCEPT = -37.4262
"""Weight at β = 0 [lb] (NASA/TM-2009-215680)."""
SLOPE = 116.3297
"""Weight per unit of β [lb] (same source)."""
LEAST_BETA = 0.627
"""The lightest gearbox of the figure; the line is negative below β = 0.322."""
GREATEST_BETA = 65.9
"""The heaviest gearbox of the figure."""


def mass_tm215680(beta: float) -> float:
    """Return the mass of a gearbox with its lubrication by a line in β, -37.4262 + 116.3297 β lb.

    Args:
        beta: Weight parameter (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15, in the units of the report.

    Source:
        NASA/TM-2009-215680, figure of gearbox weights; constants as read from the figure in AeroSandbox.

    Valid for:
        0.627 ≤ β ≤ 65.9, the weights of the figure.

    Raises:
        DesignError: The line is not positive there.

    >>> from gearwright.weights import beta
    >>> from gearwright.units import RPM
    >>> round(mass_tm215680(beta(2051e3, 20204 * RPM, 1212 * RPM)), 1)
    131.8
    """
    weight = INTERCEPT + SLOPE * beta
    if weight <= 0.0:
        message = (
            f"{beta:.3g} makes the line negative; allowed {LEAST_BETA} to {GREATEST_BETA}: use the power-law refit"
        )
        raise DesignError([Problem("beta", message)])
    return weight * POUND
