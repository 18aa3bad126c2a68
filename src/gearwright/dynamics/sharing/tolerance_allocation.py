"""Tolerance allocation: which tolerance to tighten, and how far, so that paths share as asked at least cost."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.equations import Redundancy
from gearwright.dynamics.sharing.effects_of_errors import effect_gains, random_peaks
from gearwright.dynamics.sharing.error_sources import ErrorSource
from gearwright.errors import DesignError, Problem

SETS = 2000
"""Random gearboxes that judge an allocation."""
HALVINGS = 40
"""Halvings of the search: sizes within a billionth."""
WIDEST = 1e16
"""Range of the multiplier that is searched [-]: sizes down to a hundred-millionth of the given ones."""


class Tightened(NamedTuple):
    """One tolerance."""

    error: str
    """Part and kind."""
    kind: str
    """Of the error."""
    given: float
    """Its size as given [m or rad]."""
    allowed: float
    """What is allowed of it [m or rad]."""


@dataclass(frozen=True)
class Allocation:
    """How tight every tolerance must be for a share, at least cost."""

    target: float
    """Share of the most loaded line [-]."""
    percent: float
    """Percentage of gearboxes that keep it."""
    sizes: tuple[Tightened, ...]
    """Every tolerance."""
    reached: float
    """Share that the allowed sizes keep for that percentage [-]."""
    cost: float
    """Σ given/allowed over all errors, less their number: 0 if nothing must be tightened [-]."""


def allocate(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, target: float, percent: float = 95.0,
    seed: int = 1,
) -> Allocation:  # fmt: skip
    """Return the tolerances that keep a share in most gearboxes at least cost.

    The cost of a tolerance is taken to grow as its reciprocal, and the peak as the sum of effects: then the cheapest
    sizes are t = min(t₀, √(t₀/(λ g))), g the influence of a unit. One number λ is left, and chance decides it.

    Args:
        train: From `redundancy`.
        sources: Every single error, with the sizes from which to tighten.
        lines: Places of the n parallel lines.
        target: Largest share that is allowed [-], such as 0.52.
        percent: Percentage of gearboxes that must keep it.
        seed: Of the random numbers.

    Raises:
        DesignError: If the target is no share, or below what the train gives without any error.

    Source: reciprocal cost model and its Lagrange multiplier, Chase & Greenwood 1988, Manufacturing Review 1(1).
    """
    drawn = np.array([abs(source.size) for source in sources])
    gain = effect_gains(train, sources, lines)
    perfect = float(np.max(train.perfect[lines]) / np.sum(train.perfect[lines]))
    if not perfect < target < 1.0:
        message = (
            f"{target:.4g} cannot be kept: without any error the most loaded path has {perfect:.4g}; "
            "give more, or clock the gears so that the paths share equally"
        )
        raise DesignError([Problem("target", message)])

    def share(sizes: Floats) -> float:
        peaks = random_peaks(train, sources, lines, count=SETS, seed=seed, sizes=sizes)
        return float(np.percentile(peaks, percent))

    sizes = drawn if share(drawn) <= target else _tightened(drawn, gain, share, target=target)
    rows = tuple(
        Tightened(source.name, source.kind, float(given), float(allowed))
        for source, given, allowed in zip(sources, drawn, sizes, strict=True)
    )
    return Allocation(target, percent, rows, share(sizes), float(np.sum(drawn / sizes) - len(drawn)))


def _tightened(drawn: Floats, gain: Floats, share: Callable[[Floats], float], *, target: float) -> Floats:
    """Return the largest sizes of the family t(λ) that keep the target, by bisection in the logarithm of λ."""

    def sizes(multiplier: float) -> Floats:
        with np.errstate(divide="ignore"):
            return np.asarray(np.minimum(drawn, np.sqrt(drawn / (multiplier * gain))))

    low = 1.0 / float(np.max(gain * drawn))
    high = low * WIDEST
    for _ in range(HALVINGS):
        middle = float(np.sqrt(low * high))
        low, high = (low, middle) if share(sizes(middle)) <= target else (middle, high)
    return sizes(high)
