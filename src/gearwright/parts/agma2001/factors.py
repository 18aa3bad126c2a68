"""Factors of ANSI/AGMA 2001-D04: dynamics, size, load distribution, life, reliability, hardness ratio; SI outside.

The standard's empirical formulas are written in inches, feet per minute and Brinell hardness; they are converted here.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gearwright.parts.iso6336 import LifeCurve, Value, as_value
from gearwright.units import FOOT, INCH

_SOURCE = "ANSI/AGMA 2001-D04"


@dataclass(frozen=True)
class Mounting:
    """Empirical constants of the mesh alignment factor C_ma = A + B F + C F², F in inches."""

    constant: float
    """A [-]."""
    linear: float
    """B [1/in]."""
    square: float
    """C [1/in²]."""


OPEN_GEARING = Mounting(0.247, 0.0167, -0.765e-4)
"""Open gearing (AGMA 2001-D04, table 2)."""
COMMERCIAL = Mounting(0.127, 0.0158, -1.093e-4)
"""Commercial enclosed units; Shigley, table 14-9, prints −0.930e-4."""
PRECISION = Mounting(0.0675, 0.0128, -0.926e-4)
"""Precision enclosed units."""
EXTRA_PRECISION = Mounting(0.0380, 0.0102, -0.822e-4)
"""Extra-precision enclosed units; Shigley prints 0.00360."""


Line = tuple[float, float]
"""c and e of c N^−e [-]."""


def stress_cycle_curve(start: float, low: Line, high: Line) -> LifeCurve:
    """Return a stress cycle factor Y_N or Z_N over cycles: two lines that meet where they cross.

    Args:
        start: Cycles at which the figure begins; fewer bear no more [-].
        low: c and e of the line from there on [-].
        high: c and e of the line beyond the crossing, which goes on [-].

    Source: AGMA 2001-D04, figures 17 and 18, whose corners, 3e6 and 1e7 cycles, are rounded crossings.

    >>> round(stress_cycle_curve(1e4, (2.466, 0.056), (1.4488, 0.023)).cycles[1], -5)
    10000000.0
    """
    (c_1, e_1), (c_2, e_2) = low, high
    crossing = math.exp(math.log(c_1 / c_2) / (e_1 - e_2))
    return LifeCurve((start, crossing, _LAST), (c_1 * start**-e_1, c_2 * crossing**-e_2, c_2 * _LAST**-e_2))


_LAST = 1e10
"""Cycles at which the figures end [-]."""
_BENDING_HIGH = (1.3558, 0.0178)
BENDING_HB160 = stress_cycle_curve(1e3, (2.3194, 0.0538), _BENDING_HIGH)
"""Y_N of steels around 160 HB (AGMA 2001-D04, figure 17)."""
BENDING_HB250 = stress_cycle_curve(1e3, (4.9404, 0.1045), _BENDING_HIGH)
"""Y_N around 250 HB."""
BENDING_HB400 = stress_cycle_curve(1e3, (9.4518, 0.148), _BENDING_HIGH)
"""Y_N around 400 HB."""
BENDING_CARBURISED = stress_cycle_curve(1e3, (6.1514, 0.1192), _BENDING_HIGH)
"""Y_N of carburised cases."""
BENDING_NITRIDED = stress_cycle_curve(1e3, (3.517, 0.0817), _BENDING_HIGH)
"""Y_N of nitrided cases."""
PITTING = stress_cycle_curve(1e4, (2.466, 0.056), (1.4488, 0.023))
"""Z_N of steels other than nitrided (figure 18)."""
PITTING_NITRIDED = stress_cycle_curve(1e4, (1.249, 0.0138), (1.4488, 0.023))
"""Z_N of nitrided steels."""


def dynamic_factor_agma(speed: Value, quality: Value) -> Value:
    """Return the dynamic factor K_v.

    Args:
        speed: Pitch-line velocity v_t [m/s].
        quality: Transmission accuracy Q_v, 5 to 11 [-].

    Source: AGMA 2001-C95/-D04 as Shigley 9th ed., eqs 14-27 and 14-28: ((A + √V)/A)^B, V in ft/min,
        A = 50 + 56 (1 − B), B = 0.25 (12 − Q_v)^(2/3).
    Valid for: V up to (A + Q_v − 3)².

    >>> round(float(dynamic_factor_agma(801.1 * 0.3048 / 60.0, 6.0)), 3)
    1.377
    """
    exponent = 0.25 * (12.0 - quality) ** (2.0 / 3.0)
    base = 50.0 + 56.0 * (1.0 - exponent)
    return as_value(((base + np.sqrt(speed * 60.0 / FOOT)) / base) ** exponent)


def size_factor(face_width: Value, module: Value, form_factor: Value) -> Value:
    """Return the size factor K_s, at least 1.

    Args:
        face_width: F [m].
        module: Transverse module m_t = 25.4 mm/P [m].
        form_factor: Lewis form factor Y [-].

    Source: Shigley 9th ed., section 14-10, 1.192 (F √Y/P)^0.0535, lengths in inches.

    >>> round(float(size_factor(1.5 * 0.0254, 0.00254, 0.303)), 3)
    1.043
    """
    size = face_width / INCH * np.sqrt(form_factor) * module / INCH
    return as_value(np.maximum(1.0, 1.192 * size**0.0535))


def load_distribution_factor(
    face_width: Value,
    pinion_diameter: Value,
    *,
    mounting: Mounting = COMMERCIAL,
    crowning: float = 1.0,
    offset: float = 1.0,
    adjustment: float = 1.0,
) -> Value:
    """Return the load distribution factor K_m = 1 + C_mc (C_pf C_pm + C_ma C_e).

    Args:
        face_width: F [m].
        pinion_diameter: d [m].
        mounting: Constants of C_ma.
        crowning: C_mc, 1 uncrowned, 0.8 crowned [-].
        offset: C_pm, 1 with the pinion within a sixth of the span from its middle, else 1.1 [-].
        adjustment: C_e, 0.8 when adjusted at assembly or lapped, else 1 [-].

    Source: AGMA 2001-D04, clause 15.3; F/d ≤ 2, F ≤ 40 in.

    >>> round(float(load_distribution_factor(1.5 * 0.0254, 1.7 * 0.0254)), 2)
    1.22
    """
    width = np.asarray(face_width / INCH)
    slender = np.maximum(0.05, np.asarray(face_width / pinion_diameter) / 10.0)
    wide = -0.1109 + 0.0207 * width - 0.000228 * width**2
    proportion = slender + np.select([width <= 1.0, width <= 17.0], [-0.025, -0.0375 + 0.0125 * width], wide)
    alignment = mounting.constant + mounting.linear * width + mounting.square * width**2
    return as_value(1.0 + crowning * (proportion * offset + alignment * adjustment))


def reliability_factor(reliability: Value) -> Value:
    """Return the reliability factor K_R.

    Args:
        reliability: R, 0.5 to 0.9999 [-].

    Source: AGMA 2001-D04, table 11: 0.70 at 0.5, 0.85 at 0.9, 1 at 0.99, 1.25 at 0.999, 1.5 at 0.9999; between its rows
        straight over the logarithm of 1 − R.

    >>> round(float(reliability_factor(0.9)), 3)
    0.85
    """
    rows = -np.log10([0.5, 0.1, 0.01, 0.001, 0.0001])
    return as_value(np.interp(-np.log10(1.0 - np.asarray(reliability)), rows, [0.70, 0.85, 1.0, 1.25, 1.5]))


def hardness_ratio_factor(pinion: float, wheel: float, ratio: float) -> float:
    """Return the hardness ratio factor C_H of the gear against a harder through-hardened pinion.

    Args:
        pinion: HB of the pinion [-].
        wheel: HB of the gear [-].
        ratio: m_G = N_G/N_P [-].

    Source: AGMA 2001-D04, clause 14.1: 1 + A (m_G − 1), A = 0.00898 HB_P/HB_G − 0.00829 for HB_P/HB_G from 1.2 to 1.7,
        0 below, 0.00698 above.

    >>> round(hardness_ratio_factor(240.0, 200.0, 52.0 / 17.0), 3)
    1.005
    """
    harder = pinion / wheel
    if harder < 1.2 - 1e-12:
        return 1.0
    slope = 0.00698 if harder > 1.7 else 0.00898 * harder - 0.00829
    return 1.0 + slope * (ratio - 1.0)
