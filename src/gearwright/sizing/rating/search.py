"""The module that meets asked safeties, for methods without a closed form."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from gearwright.base import Floats, Problem
from gearwright.parts.gears import FEWEST_TEETH, virtual_teeth
from gearwright.sizing.rating.rules import Ask, Rating
from gearwright.spec.design import RATINGS

_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""
_LEAST_TORQUE = 1e-9
"""Torque per tooth below which a mesh asks for no module [N m]."""


def untabulated(rating: Rating, teeth: tuple[int, int]) -> Iterator[Problem]:
    """Yield external gears of a mesh with fewer teeth than the table of Lewis form factors, by their virtual number.

    Args:
        rating: Resolved rules, of a method that reads the table.
        teeth: Of both gears, negative for a ring [-].
    """
    for count in dict.fromkeys(count for count in teeth if count > 0):
        virtual = virtual_teeth(count, rating.rules.pressure_angle, rating.helix_angle)
        if virtual < FEWEST_TEETH:
            like = "" if math.isclose(virtual, count) else f", like {virtual:.3g} of a spur gear,"
            table = f"{RATINGS[rating.method].title} reads Lewis form factors, tabulated from {FEWEST_TEETH} teeth on"
            fix = 'give it more, or write rating = "iso6336"'
            yield Problem("gears", f"{table}, and a gear has {count}{like}: {fix}")


def module_for(
    safeties: Callable[[Floats], tuple[Floats, Floats]], torque: Floats, asked: tuple[float, float]
) -> tuple[Floats, Floats]:
    """Return the modules at which the asked safeties are met in bending and contact [m].

    Args:
        safeties: Modules of shape (2, *torque's) -> S_F and S_H of each at given λ [-].
        torque: On the first gear [N m].
        asked: S_F and S_H that are asked [-].

    Source: at given λ, S_F goes with m³ and S_H² with m³ but for the load factors, hence few corrections do.
    """
    if not np.any(torque > _LEAST_TORQUE):
        return np.zeros_like(torque), np.zeros_like(torque)
    wanted = np.array([asked[0], asked[1] ** 2]).reshape(2, *(1,) * torque.ndim)
    module = np.stack([np.cbrt(torque) * 1e-3 * _START] * 2)
    for _ in range(_STEPS):
        bending, contact = (np.broadcast_to(values, module.shape) for values in safeties(module))
        module = np.asarray(module * np.cbrt(wanted / np.stack([bending[0], contact[1] ** 2])))
    return module[0], module[1]


def by_teeth(
    ask: Ask, search: Callable[[tuple[int, int], float, float, float], tuple[float, float]]
) -> tuple[Floats, Floats]:
    """Return the modules of bending and contact by one search for each pair of tooth numbers, scaled to its loads [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        search: Teeth, torque on the first gear [N m], its speed [rad/s] and λ -> modules of bending and contact [m].

    Source: m³ ∝ T at given teeth and λ, but for the load factors.
    """
    torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
    if not np.any(torque > _LEAST_TORQUE):
        return np.zeros_like(torque), np.zeros_like(torque)
    pinion, wheel, load, speed, ratio = np.broadcast_arrays(*ask.teeth, torque, ask.speed, ask.width_ratio)
    pairs, first, index = np.unique(
        np.stack([pinion.ravel(), wheel.ravel()]).astype(np.int64), axis=1, return_index=True, return_inverse=True
    )
    found = np.array(
        [
            search((int(z_1), int(z_2)), *(float(column.flat[at]) for column in (load, speed, ratio)))
            for z_1, z_2, at in zip(*pairs, first, strict=True)
        ]
    )
    scale = np.cbrt(load.ravel() / load.flat[first][index.ravel()])
    bending, contact = (found[index.ravel(), mode] * scale for mode in (0, 1))
    return bending.reshape(load.shape), contact.reshape(load.shape)
