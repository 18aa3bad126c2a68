"""The module that meets asked safeties, for methods without a closed form."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwright.arrays import Floats

_STEPS = 4
"""Corrections of the module; each closes the gap to the asked safety to a tenth or better."""
_START = 0.3
"""Module over the cube root of the torque where the search begins [mm/(N m)^⅓]."""
_LEAST_TORQUE = 1e-9
"""Torque per tooth below which a mesh asks for no module [N m]."""


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
