"""How large gears are made that a standard rates: standard modules, face widths, what a load spectrum asks of them.

The sizing asks it once for every stage, the search for teeth once for every pair of tooth numbers of bevel gears.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from gearwright.sizing.rating.rules import Rating
from gearwright.sizing.rating.standard_teeth import cone_ratio, mean_module

STANDARD_MODULES = (
    1.0, 1.125, 1.25, 1.375, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0, 8.0, 9.0, 10.0,
    11.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 25.0, 28.0, 32.0, 36.0, 40.0, 45.0, 50.0,
)  # fmt: skip
"""Modules of series I and II [mm] (ISO 54:1996; ISO 678:1996 for bevel gears, outer transverse)."""
_MM = 1e-3
CORRECTIONS = 6
"""Corrections of a module under the load spectrum; each closes most of what is left."""
LARGER = (1.02, 1.06, 1.18)
"""By what a module is tried larger that is not rounded; a standard one, by as many steps [-]."""
JUST = 1e-6
"""Part by which a gap may miss: what an exact module leaves of rounding and of its last correction [-]."""
NEXT = 1e-6
"""Part by which more is asked than a module to have the next one rounded [-]."""
LEFT = 2.0
"""How far later corrections may lead, over the last one [-]: twice as far as where each closed but half."""

Gap = Callable[[float, float], float]
"""Module and face width [m] -> by what factor the loads of a stage could grow [-]."""


def next_standard(needed: float) -> float:
    """Return the next standard module [m]; above all of them the needed one.

    Args:
        needed: Module that meshes ask for [m].
    """
    return next((standard * _MM for standard in STANDARD_MODULES if standard * _MM >= needed * (1.0 - 1e-9)), needed)


def under_spectrum(module: float, ratio: float, gap: Gap, rounded: Callable[[float], float] | None = None) -> float:
    """Return the module with which every asked safety is just met under all cases of the life [m].

    Args:
        module: That meets them in the heaviest case [m].
        ratio: λ = b/m_n [-].
        gap: Of the stage.
        rounded: To what a module is rounded afterwards; no more corrections are made than it can tell apart.
    """
    for _ in range(CORRECTIONS):
        before, module = module, module / math.cbrt(gap(module, ratio * module))
        left = LEFT * abs(module - before)
        if rounded is not None and left < module / 2.0 and rounded(module - left) == rounded(module + left):
            break
    return module


def strong_enough(module: float, gap: Callable[[float], float], *, standard: bool) -> float:
    """Return a module, or a larger one that meets the safeties at its greatest face width [m].

    Near a resonance of the mesh a standard module may bear less than the smaller one that is needed; and a face that
    is cut to whole millimetres bears less than the one for which a module was found. The first stays where none of the
    next few bears what is asked.

    Args:
        module: That is needed, rounded where it is to be a standard one [m].
        gap: Module [m] -> by what factor the loads of its stage could grow at its greatest face width [-].
        standard: Modules are standard ones; else the least that is strong enough is found.
    """
    weak = module
    for tried in _tries(module, standard=standard):
        if gap(tried) >= 1.0 - JUST:
            return tried if standard else _least(weak, tried, gap)
        weak = tried
    return module


def _tries(module: float, *, standard: bool) -> list[float]:
    """Return a module and the next larger ones to try [m]."""
    tries = [module]
    for larger in LARGER:
        tries.append(next_standard(tries[-1] * (1.0 + NEXT)) if standard else larger * module)
    return tries


def _least(weak: float, strong: float, gap: Callable[[float], float]) -> float:
    """Return a module that is just strong enough between one that is too weak and one that is not [m]."""
    while strong - weak > JUST * strong:
        middle = (weak + strong) / 2.0
        weak, strong = (weak, middle) if gap(middle) >= 1.0 else (middle, strong)
    return strong


def overlap_width(rating: Rating, module: float) -> float:
    """Return the face width that gives the asked overlap ratio [m]; one module for straight teeth.

    Args:
        rating: Resolved rules.
        module: m_n [m].
    """
    lean = math.sin(rating.helix_angle)
    return rating.rules.overlap_ratio * math.pi * module / lean if lean else module


def narrowest(least: float, widest: float, gap: Callable[[float], float]) -> float:
    """Return the least face width in whole millimetres that meets the safeties, or the most that is allowed [m].

    Args:
        least: To look from [m].
        widest: To look to [m].
        gap: Factor by which the loads could grow at a face width [-].
    """
    low, high = math.ceil(min(least, widest) / _MM - 1e-9), max(math.floor(widest / _MM + 1e-9), 1)
    while low < high:
        middle = (low + high) // 2
        if gap(middle * _MM) >= 1.0:
            high = middle
        else:
            low = middle + 1
    return high * _MM


def whole(width: float) -> float:
    """Return the most whole millimetres in a face width, one at least [m].

    Args:
        width: [m].
    """
    return narrowest(width, width, lambda _: 1.0)


def bevel_module(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating, gap: Gap) -> float:
    """Return an outer module of a bevel pair, or a larger one that meets the safeties at its widest face [m].

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et, rounded where the rules ask for standard ones [m].
        ratio: λ = b/m_mn of the widest [-].
        rating: Resolved rules.
        gap: Of the stage.
    """

    def bears(tried: float) -> float:
        width = _widest_bevel(teeth, tried, ratio, rating)
        width = whole(width) if rating.width_is_open else width
        return gap(mean_module(teeth, tried, width, rating), width)

    rules = rating.proportions
    return outer if rules is None else strong_enough(outer, bears, standard=rules.standard_modules)


def bevel_width(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating, gap: Gap) -> float:
    """Return the face width of a bevel pair of an outer module: the widest, or the least that meets the safeties [m].

    A narrower face of the same outer module has a larger mean module, hence bears little less and weighs less.

    Args:
        teeth: z_1, z_2 [-].
        outer: Outer transverse module m_et [m].
        ratio: λ = b/m_mn of the widest [-].
        rating: Resolved rules.
        gap: Of the stage.
    """
    width = _widest_bevel(teeth, outer, ratio, rating)
    if not rating.width_is_open:
        return width
    least = overlap_width(rating, mean_module(teeth, outer, width, rating))
    return narrowest(least, width, lambda tried: gap(mean_module(teeth, outer, tried, rating), tried))


def _widest_bevel(teeth: tuple[int, int], outer: float, ratio: float, rating: Rating) -> float:
    """Return the widest face of a bevel pair of an outer module [m]."""
    cone = float(cone_ratio(*teeth)) * outer
    return ratio * outer / (1.0 / math.cos(rating.helix_angle) + 0.5 * ratio * outer / cone)
