"""Miner's sum over the stress cycle factors of AGMA 2001: damage of a spectrum, and the safety that it leaves."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gearwright.errors import SolveError
from gearwright.parts.agma2001.factors import CycleCurve, cycle_factor

_MOST = 1e3
"""Factor on stresses within which the safety of a spectrum is looked for [-]."""

_ENDLESS = 600.0
"""Natural logarithm of cycles beyond which a load does nothing [-]."""


def endured_cycles(curve: CycleCurve, factor: float) -> float:
    """Return the cycles at which a stress cycle factor is reached, the inverse of `cycle_factor`.

    Args:
        curve: Curve of the material.
        factor: Y_N or Z_N that the stress asks for [-].

    Source: AGMA 2001-D04, clause 17; the upper curves beyond the corner (general use).

    >>> from gearwright.parts.agma2001 import PITTING
    >>> round(endured_cycles(PITTING, float(cycle_factor(PITTING, 1e8))) / 1e8, 6)
    1.0
    """
    corner = float(cycle_factor(curve, curve.corner))
    constant, exponent = curve.low if factor >= corner else curve.high
    if factor <= 0.0:
        return math.inf
    logarithm = math.log(constant / factor) / exponent
    return math.exp(logarithm) if logarithm < _ENDLESS else math.inf


def miner_parts(curve: CycleCurve, ratios: Sequence[float], cycles: Sequence[float]) -> list[float]:
    """Return Miner's part of every load of a spectrum [-].

    Args:
        curve: Curve of the material.
        ratios: Stress of every load over its limit at a stress cycle factor of 1 [-].
        cycles: Of every load [-].

    Source: Miner 1945, n_i/N_i, N_i by AGMA 2001-D04, clause 17.
    """
    loads = zip(ratios, cycles, strict=True)
    return [count / endured_cycles(curve, ratio) if ratio > 0.0 else 0.0 for ratio, count in loads]


def miner_sum(curve: CycleCurve, ratios: Sequence[float], cycles: Sequence[float]) -> float:
    """Return Miner's sum of a spectrum [-]; 1 is failure.

    Args:
        curve: Curve of the material.
        ratios: Stress of every load over its limit at a stress cycle factor of 1 [-].
        cycles: Of every load [-].

    Source: Miner 1945, Σ n_i/N_i.
    """
    return sum(miner_parts(curve, ratios, cycles))


def spectrum_safety(curve: CycleCurve, ratios: Sequence[float], cycles: Sequence[float]) -> float:
    """Return the factor on all stresses at which Miner's sum becomes 1, S_F or S_H [-].

    Args:
        curve: Curve of the material.
        ratios: Stress of every load over its limit at a stress cycle factor of 1 [-].
        cycles: Of every load [-].

    Source: Miner 1945, with the stress cycle factors of AGMA 2001-D04, clause 17.

    Raises:
        SolveError: No factor between a thousandth and a thousandfold brings the sum to 1.
    """
    low, high = 1.0 / _MOST, _MOST

    def total(factor: float) -> float:
        return miner_sum(curve, [factor * ratio for ratio in ratios], cycles)

    if not total(low) <= 1.0 <= total(high):
        raise SolveError("spectrum: the stresses are beyond a thousandth or a thousandfold of the strength")
    while high / low > 1.0 + 1e-13:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if total(middle) <= 1.0 else (low, middle)
    return low
