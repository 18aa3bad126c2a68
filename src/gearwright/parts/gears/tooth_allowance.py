"""How much thinner than without backlash a tooth is made, and how much the maker may miss it."""

from __future__ import annotations

import math

from gearwright.errors import DesignError, Problem

_MM = 1e-3
_FEED = {4: (7, 1.26), 5: (8, 1.0), 6: (8, 1.26), 7: (9, 1.0), 8: (9, 1.26), 9: (10, 1.0)}
"""Flank tolerance class -> grade of ISO 286 and factor of the tolerance on the radial feed (ISO/TR 10064-2:1996)."""


def least_backlash(centre_distance: float, module: float) -> float:
    """Return the least normal backlash that steel gears in steel or iron housings usually have.

    Args:
        centre_distance: a [m].
        module: m_n [m].

    Returns:
        j_bn [m].

    Source: ISO/TR 10064-2:1996, annex: j_bn = 2/3 (0.06 + 0.0005 a + 0.03 m_n) in mm.
    Valid for: pitch-line speeds up to 15 m/s and usual tolerances of the housing.

    >>> round(1e6 * least_backlash(0.171, 2.5e-3))
    147
    """
    return _MM * 2.0 / 3.0 * (0.06 + 0.0005 * centre_distance / _MM + 0.03 * module / _MM)


def runout_tolerance(diameter: float, module: float, grade: int) -> float:
    """Return the tolerance of the runout of a gear.

    Args:
        diameter: Reference diameter d [m].
        module: m_n [m].
        grade: Flank tolerance class A [-].

    Returns:
        F_rT [m].

    Source: ISO 1328-1:2013: F_pT = (0.002 d + 0.55 √d + 0.7 m_n + 12) √2^(A−5) in µm with d and m_n in mm, and
        F_rT = 0.9 F_pT of annex F.
    """
    d, m = diameter / _MM, module / _MM
    return 0.9e-6 * (0.002 * d + 0.55 * math.sqrt(d) + 0.7 * m + 12.0) * math.sqrt(2.0) ** (grade - 5)


def feed_grade(grade: int) -> tuple[int, float]:
    """Return what tolerance the radial feed of the cutter has: a grade of ISO 286 and a factor on it.

    Args:
        grade: Flank tolerance class A [-].

    Source: ISO/TR 10064-2:1996, 4 to 9: 1.26 IT7, IT8, 1.26 IT8, IT9, 1.26 IT9, IT10 at the reference diameter.

    Raises:
        DesignError: If the report has none for this class.
    """
    if grade not in _FEED:
        raise DesignError([Problem("tolerance_class", f"{grade} given; a tolerance on the feed is known for 4 to 9")])
    return _FEED[grade]


def span_allowances(backlash: float, runout: float, feed: float, *, pressure_angle: float) -> tuple[float, float]:
    """Return lower and upper allowance of a span measurement, where both gears give half of the least backlash.

    Args:
        backlash: Least normal backlash j_bn [m].
        runout: Tolerance F_r [m].
        feed: Tolerance of the radial feed b_r [m].
        pressure_angle: α_n [rad].

    Returns:
        E_bni and E_bns [m], both negative.

    Source: ISO/TR 10064-2:1996: E_bns = −j_bn/2, T_sn = 2 tan α_n √(F_r² + b_r²), E_bni = E_bns − T_sn cos α_n.

    >>> low, high = span_allowances(147e-6, 17e-6, 46e-6, pressure_angle=math.radians(20.0))
    >>> round(1e6 * low), round(1e6 * high)
    (-107, -74)
    """
    upper = -backlash / 2.0
    width = 2.0 * math.tan(pressure_angle) * math.hypot(runout, feed) * math.cos(pressure_angle)
    return upper - width, upper
