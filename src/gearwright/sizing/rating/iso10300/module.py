"""The mean normal module that bevel meshes ask for by ISO 10300."""

from __future__ import annotations

import math
from functools import partial

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelRating, rate_bevel
from gearwright.parts.iso6336 import GearSteel
from gearwright.sizing.rating.iso6336.inputs import steel_of
from gearwright.sizing.rating.iso10300.inputs import bevel_duty, bevel_surfaces
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.search import by_teeth
from gearwright.sizing.rating.standard_teeth import bevel_pair

_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""


def bevel_modules(ask: Ask, rating: Rating) -> tuple[Floats, Floats]:
    """Return the modules at which S_F = S_Fmin and S_H = S_Hmin [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.
    """
    return by_teeth(ask, partial(_one_bevel, rating, steel_of(rating)))


def _one_bevel(
    rating: Rating, steel: GearSteel, teeth: tuple[int, int], torque: float, speed: float, ratio: float
) -> tuple[float, float]:
    rules, surfaces = rating.rules.iso6336, bevel_surfaces(rating)

    def rated(module: float) -> BevelRating:
        pair = bevel_pair(teeth, module, ratio * module, rating)
        duty = bevel_duty(rating, pair, torque, speed)
        return rate_bevel(pair, (steel, steel), duty, rating.service.life, surfaces=surfaces)

    def bending(found: BevelRating) -> float:
        return rules.bending_safety / min(root.safety for root in found.bending)

    def contact(found: BevelRating) -> float:
        return (rules.pitting_safety / min(found.pitting.safeties)) ** 2

    start = 1e-3 * _START * math.cbrt(torque)
    first = rated(start)  # the same for both
    modules = [start * math.cbrt(gap(first)) for gap in (bending, contact)]
    for _ in range(_STEPS - 1):
        modules = [
            module * math.cbrt(gap(rated(module))) for module, gap in zip(modules, (bending, contact), strict=True)
        ]
    return modules[0], modules[1]
