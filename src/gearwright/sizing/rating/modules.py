"""The module that bending and contact each ask of a mesh, by the method that its stage is rated with."""

from __future__ import annotations

import math

import numpy as np

from gearwright.parts.bevel import rate_bevel
from gearwright.parts.iso6336 import GearSteel, rate_mesh
from gearwright.sizing.rating.rules import Array, Ask, Rating, first_modules
from gearwright.sizing.rating.standard_teeth import (
    bevel_duty,
    bevel_pair,
    bevel_surfaces,
    cylindrical_mesh,
    duty_of,
    quality_of,
    steel_of,
)

_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""
_LEAST_LOAD = 1e-9
"""Torque per tooth below which a mesh asks for no module [N m]."""


def modules(ask: Ask, rating: Rating) -> tuple[Array, Array]:
    """Return the modules that bending and contact ask of a mesh [m].

    Args:
        ask: Load, teeth and width; numbers, or arrays over choices.
        rating: Resolved rules.

    Source: Lewis and Hertz as Pulvirenti 2023; or the module at which S_F = S_Fmin and S_H = S_Hmin by ISO 6336 or
        ISO 10300: at given λ, S_F goes with m³ and S_H² with m³ but for the load factors, hence few corrections do.
    """
    if not rating.by_standard:
        return first_modules(ask, rating)
    torque = np.asarray(ask.per_tooth, dtype=float) * np.asarray(ask.teeth[0], dtype=float)
    if not np.any(np.asarray(ask.per_tooth) > _LEAST_LOAD):
        return np.zeros_like(torque), np.zeros_like(torque)
    if rating.kind == "bevel":
        return _bevel_modules(ask, rating, torque)
    rules = rating.rules.iso6336
    wanted = np.array([rules.bending_safety, rules.pitting_safety**2]).reshape(2, *(1,) * torque.ndim)
    module = np.stack([np.cbrt(torque) * 1e-3 * _START] * 2)
    for _ in range(_STEPS):
        safeties = _cylindrical_safeties(ask, rating, torque, module)
        module = np.asarray(module * np.cbrt(wanted / np.stack([safeties[0], safeties[1] ** 2])))
    return module[0], module[1]


def _cylindrical_safeties(ask: Ask, rating: Rating, torque: Array, module: Array) -> tuple[Array, Array]:
    """Least S_F of the first module and least S_H of the second."""
    mesh = cylindrical_mesh(ask.teeth, module, module * np.asarray(ask.width_ratio), rating, internal=ask.internal)
    duty = duty_of(rating, torque, ask.speed, life=rating.service.life, passes=ask.passes)
    steel = steel_of(rating)
    rated = rate_mesh(mesh, (steel, steel), duty, quality=quality_of(rating, idlers=ask.idlers))
    bending = np.minimum(rated.bending[0].safety, rated.bending[1].safety)
    contact = np.minimum(*rated.pitting.safeties)
    return np.broadcast_to(bending, module.shape)[0], np.broadcast_to(contact, module.shape)[1]


def _bevel_modules(ask: Ask, rating: Rating, torque: Array) -> tuple[Array, Array]:
    """Return the modules of bevel meshes: one search for each pair of tooth numbers, scaled by m³ ∝ T to its loads."""
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
    needed = []
    for mode in (0, 1):
        module = 1e-3 * _START * math.cbrt(torque)
        for _ in range(_STEPS):
            pair = bevel_pair(teeth, module, ratio * module, rating)
            duty = bevel_duty(rating, pair, torque, speed)
            rated = rate_bevel(pair, (steel, steel), duty, rating.service.life, surfaces=surfaces)
            if mode == 0:
                module *= math.cbrt(rules.bending_safety / min(root.safety for root in rated.bending))
            else:
                module *= math.cbrt((rules.pitting_safety / min(rated.pitting.safeties)) ** 2)
        needed.append(module)
    return needed[0], needed[1]
