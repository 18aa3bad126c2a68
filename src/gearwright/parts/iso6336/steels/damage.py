"""Damage of a gear under a load spectrum by ISO 6336-6: Miner's sum over the S-N curves of flank and root."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated

from gearwright.errors import DesignError, Problem
from gearwright.parts.iso6336.steels.life import endurable_cycles, life_factor
from gearwright.parts.iso6336.steels.strength import LifeCurve
from gearwright.units import Origin, Quantity

_PART6 = "ISO 6336-6:2019"
STEPS = 12
"""Secants after which the root is looked for by bisection alone [-]."""
_CLOSE = 1e-11
"""How near to the root secants come, as a part of it [-]."""
_FARTHEST = 4.0
"""Natural logarithm of a step beyond which no secant goes [-]."""


@dataclass(frozen=True)
class StressBin:
    """One level of a spectrum as the gear feels it."""

    stress: Annotated[
        float, Quantity("stress"), Origin("σ_H or σ_F with the K factors of the bin", f"{_PART6}, clause 4")
    ]
    """Contact or root stress with K_V, K_Hβ, K_Hα of the bin and K_A = 1 [Pa]."""
    cycles: Annotated[float, Quantity("number"), Origin("n_i", f"{_PART6}, clause 4")]
    """Load cycles at this level n_i [-]."""


@dataclass(frozen=True)
class Damage:
    """What a spectrum does to one gear."""

    parts: tuple[float, ...]
    """Damage n_i/N_i of each bin [-]."""
    total: Annotated[float, Quantity("ratio"), Origin("U = Σ n_i/N_i", f"{_PART6}, clause 5")]
    """Miner's sum U [-]; 1 is failure at the safety of the curve."""
    safety: Annotated[float, Quantity("ratio"), Origin("S: U(S σ) = 1", f"{_PART6}, clause 6")]
    """Factor on all stresses at which the sum becomes 1, S_H or S_F [-]."""


def damage_parts(bins: Sequence[StressBin], reference: float, curve: LifeCurve) -> tuple[float, ...]:
    """Return the damage of every bin.

    Args:
        bins: The spectrum.
        reference: Stress limit at a life factor of 1, σ_HG or σ_FG with Z_NT = 1 or Y_NT = 1 [Pa].
        curve: S-N curve of the flank or the root.

    Returns:
        n_i/N_i [-], shape (bins,); ∞ above the static limit.

    Source: ISO 6336-6:2019, clause 5. Stresses below the endurance corner damage along the last slope of the curve
        (Z_NT or Y_NT = 0.85 at 1e10), and not at all where it is flat.
    """
    return tuple([damage_part(level.cycles, level.stress / reference, curve) for level in bins])


def damage_part(cycles: float, factor: float, curve: LifeCurve) -> float:
    """Return the damage of load cycles under one stress, n/N; ∞ above the static limit [-].

    Args:
        cycles: n [-].
        factor: Stress over its limit at a life factor of 1 [-].
        curve: S-N curve of the flank or the root.

    Source: ISO 6336-6:2019, clause 5.
    """
    endured = endurable_cycles(curve, factor) if factor > 0.0 else math.inf
    return cycles / endured if endured > 0.0 else math.inf


def spectrum_damage(bins: Sequence[StressBin], reference: float, curve: LifeCurve) -> Damage:
    """Return Miner's sum of a spectrum and the safety that it leaves.

    The safety lies between that of all cycles under the greatest stress and that of the greatest stress once.

    Args:
        bins: The spectrum, at least one bin with cycles and stress.
        reference: Stress limit at a life factor of 1 [Pa].
        curve: S-N curve.

    Source: ISO 6336-6:2019, clauses 5 and 6: the safety scales all stresses until U = 1.

    Raises:
        DesignError: an empty spectrum.

    >>> from gearwright.parts.iso6336 import contact_life_curve
    >>> from gearwright.parts.iso6336 import Treatment
    >>> curve = contact_life_curve(Treatment.CASE_HARDENED)
    >>> round(spectrum_damage([StressBin(1000e6, 5e7)], 1500e6, curve).safety, 6)
    1.5
    """
    loads = [(level.stress, level.cycles) for level in bins if level.cycles > 0.0 and level.stress > 0.0]
    if not loads:
        raise DesignError([Problem("spectrum", "no bin has both stress and cycles; give at least one")])
    parts = damage_parts(bins, reference, curve)

    unit = reference / max([stress for stress, _ in loads])
    low, high = unit * float(life_factor(curve, sum([cycles for _, cycles in loads]))), unit * curve.factors[0]
    near = partial(_near, loads, reference, curve, low)
    safety = _unit_root(lambda factor: _lasts(loads, reference / factor, curve), near, low, high)
    return Damage(parts, sum(parts), safety)


def _lasts(loads: Sequence[tuple[float, float]], reference: float, curve: LifeCurve) -> bool:
    """Tell whether stresses and their cycles damage by 1 or less; no further than the sum is above it."""
    total = 0.0
    for stress, cycles in loads:
        endured = endurable_cycles(curve, stress / reference)
        total += cycles / endured if endured > 0.0 else math.inf
        if total > 1.0:
            return False
    return True


def _near(loads: Sequence[tuple[float, float]], reference: float, curve: LifeCurve, start: float) -> float:
    """Return about the factor at which the sum is 1, by secants in double logarithmic scale; the start if they fail."""
    at, value, moved = math.log(start), 0.0, 0.0
    slope = max([longer / weaker for _, _, _, longer, weaker in curve.lines], default=1.0)
    for step in range(STEPS):
        factor = math.exp(at)
        total = sum([damage_part(cycles, factor * stress / reference, curve) for stress, cycles in loads])
        if not 0.0 < total < math.inf:
            return start
        before, value = value, math.log(total)
        if step and value != before:
            slope = (value - before) / moved
        moved = -value / slope
        if abs(value) < _CLOSE or not abs(moved) < _FARTHEST:
            return factor
        at += moved
    return factor


def _unit_root(lasts: Callable[[float], bool], near: Callable[[], float], low: float, high: float) -> float:
    """Factor at which a growing sum passes 1, between two; bisection, as the sum jumps at the static limit.

    Where the sum passes 1 close to `near`, only what lies there is tried, which leaves the root as it is.
    """
    guess = near()
    holds, fails = guess * (1.0 - _CLOSE), guess * (1.0 + _CLOSE)
    holds, fails = holds if lasts(holds) else low, fails if not lasts(fails) else high
    while high / low > 1.0 + 1e-12:
        middle = (low * high) ** 0.5
        within = middle <= holds or (middle < fails and lasts(middle))
        low, high = (middle, high) if within else (low, middle)
    return low
