"""How lips of seals and oil age: lives by temperature and sliding, and what a tight seal lets through."""

from __future__ import annotations

LIP_TESTED = 1000.0 * 3600.0
"""For which elastomers keep half of their elongation at the temperature that makers name [s]: usual, from memory."""
LIP_HALVES = 10.0
"""Warmer, and an elastomer lives half as long [K]: rule of thumb after Arrhenius."""
LIP_SLIDES = 2.5e8
"""Distance that a lip slides before it is worn [m]: estimate, 5000 h at 14 m/s."""
LEAKAGE = 3e-3 / (240.0 * 3600.0)
"""That one radial seal may let through in a test of 240 h [kg/s]: 3 g, DIN 3761 as makers' catalogues cite it, from
memory."""
OIL_YEAR = 8760.0 * 3600.0
"""Life of oil up to 50 °C [s]: a year, SKF, Rolling bearings (oil bath), from memory."""
OIL_COOL, OIL_QUARTERS = 50.0, 50.0
"""Temperature up to which it lasts so long [°C], and by how much warmer oil lives a quarter [K]: a year at 50 °C, three
months at 100 °C, of the same source."""


def lip_life(hottest: float, warm: float) -> float:
    """Return how long heat lets the lip of a seal live [s].

    Args:
        hottest: That its elastomer bears [°C].
        warm: Of the lip [°C].

    Source: rule of thumb after Arrhenius, half for 10 K: L = 1000 h 2^((T_max − T)/10 K); an estimate.

    >>> lip_life(200.0, 180.0) / 3600.0
    4000.0
    """
    return float(LIP_TESTED * 2.0 ** ((hottest - warm) / LIP_HALVES))


def lip_wear_life(velocity: float) -> float:
    """Return how long wear lets the lip of a seal live [s].

    Args:
        velocity: Of the shaft under it, above 0 [m/s].

    Source: a distance of 250 000 km, an estimate.

    >>> round(lip_wear_life(14.0) / 3600.0)
    4960
    """
    return LIP_SLIDES / velocity


def oil_life(warm: float) -> float:
    """Return how long oil lasts until it is changed [s].

    Args:
        warm: Of the oil [°C].

    Source: SKF, Rolling bearings, oil bath: a year up to 50 °C, three months at 100 °C, from memory; a straight line
        between the logarithms, L = 1 a 4^(−(T − 50 °C)/50 K).

    Valid for: up to about 120 °C, little dirt; mineral oil, of which synthetic ones last longer.

    >>> round(oil_life(100.0) / 3600.0), round(oil_life(20.0) / 3600.0)
    (2190, 8760)
    """
    return float(OIL_YEAR * 4.0 ** (-max(warm - OIL_COOL, 0.0) / OIL_QUARTERS))
