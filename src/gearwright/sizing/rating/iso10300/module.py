"""The mean normal module that bevel meshes ask for by ISO 10300."""

from __future__ import annotations

import math

import numpy as np

from gearwright.arrays import Floats
from gearwright.parts.bevel import BevelRating, rate_bevel
from gearwright.parts.iso6336 import GearSteel
from gearwright.sizing.rating.iso6336.inputs import steel_of
from gearwright.sizing.rating.iso10300.inputs import bevel_duty, bevel_surfaces
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.sizing.rating.standard_teeth import bevel_pair

_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""
_LEAST_TORQUE = 1e-9
"""Below it a mesh asks for no module [N m]."""


def bevel_modules(ask: Ask, rating: Rating) -> tuple[Floats, Floats]:
    """Return the modules at which S_F = S_Fmin and S_H = S_Hmin [m].

    There is one search for each pair of tooth numbers, scaled by m³ ∝ T to its loads.

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.
    """
    torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
    if not np.any(torque > _LEAST_TORQUE):
        return np.zeros_like(torque), np.zeros_like(torque)
    pinion, wheel, load, speed, ratio = np.broadcast_arrays(*ask.teeth, torque, ask.speed, ask.width_ratio)
    pairs, first, index = np.unique(
        np.stack([pinion.ravel(), wheel.ravel()]).astype(np.int64), axis=1, return_index=True, return_inverse=True
    )
    steel = steel_of(rating)
    factors = np.array(
        [
            _one_bevel((int(z1), int(z2)), rating, steel, *(float(column.flat[at]) for column in (load, speed, ratio)))
            for z1, z2, at in zip(*pairs, first, strict=True)
        ]
    )
    scale = np.cbrt(load.ravel() / load.flat[first][index.ravel()])
    bending, contact = (factors[index.ravel(), mode] * scale for mode in (0, 1))
    return bending.reshape(load.shape), contact.reshape(load.shape)


def _one_bevel(
    teeth: tuple[int, int], rating: Rating, steel: GearSteel, torque: float, speed: float, ratio: float
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
