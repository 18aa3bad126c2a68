"""How much thinner than without backlash a tooth is made, and how much the maker may miss it."""

from __future__ import annotations

import math
from dataclasses import replace

from gearwright.errors import DesignError, Problem
from gearwright.parts.gears.cylindrical_gear import CylindricalGear

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


def span_allowance(thickness: float, *, pressure_angle: float) -> float:
    """Return by how much a span measurement is shorter where teeth are thinner.

    Args:
        thickness: Allowance of the normal tooth thickness E_sn, negative [m].
        pressure_angle: α_n [rad].

    Returns:
        E_bn [m], negative; of two gears that mesh the sum is their normal backlash −j_bn.

    Source: DIN 3967:1978, A_W = A_sn cos α_n.

    >>> round(1e6 * span_allowance(-70e-6, pressure_angle=math.radians(20.0)))
    -66
    """
    return thickness * math.cos(pressure_angle)


def thinned(gear: CylindricalGear, thickness: float) -> CylindricalGear:
    """Return a gear whose teeth are thinner, of the same tip circle: its shift is the one with which it is cut.

    Args:
        gear: Without backlash.
        thickness: Allowance of the normal tooth thickness E_sn, negative [m].

    Source: DIN 3960:1987, x_E = x + A_s/(2 m_n tan α_n).

    >>> round(thinned(CylindricalGear(51, 1e-3, 0.017, profile_shift=0.2034), -278e-6 / math.cos(math.radians(20.0)))
    ...       .profile_shift, 4)
    -0.203
    """
    less = thickness / (2.0 * gear.module * math.tan(gear.rack.pressure_angle))
    shift, tip = gear.profile_shift + less, gear.tip_alteration - less
    return replace(gear, profile_shift=shift, tip_alteration=tip)


def centre_play(further: float, *, working_angle: float, helix_angle: float) -> float:
    """Return the normal backlash that an external mesh gains where its axes stand further apart; a ring loses it.

    Args:
        further: By which the centre distance is larger [m].
        working_angle: Working transverse pressure angle α_wt [rad].
        helix_angle: At the base cylinder β_b [rad].

    Returns:
        Δj_bn [m].

    Source: DIN 3967:1978, Δj = 2 A_a tan α_wt on the working circles, times cos α_wt cos β_b along the flank's normal.
    Valid for: changes that are small against the centre distance.

    >>> round(1e6 * centre_play(15e-6, working_angle=math.radians(21.46), helix_angle=0.0))
    11
    """
    return 2.0 * further * math.sin(working_angle) * math.cos(helix_angle)


def circumferential_play(normal: float, *, working_angle: float, helix_angle: float) -> float:
    """Return a normal backlash along the working pitch circles.

    Args:
        normal: j_bn [m].
        working_angle: Working transverse pressure angle α_wt [rad].
        helix_angle: At the base cylinder β_b [rad].

    Returns:
        j_wt [m].

    Source: ISO 21771:2007, j_bn = j_wt cos α_wt cos β_b.

    >>> round(1e6 * circumferential_play(485e-6, working_angle=math.radians(21.46), helix_angle=0.0))
    521
    """
    return normal / (math.cos(working_angle) * math.cos(helix_angle))
