"""A shaft as a beam on two bearings: reactions, shear, bending and torsion under point loads, by equilibrium alone.

Planes and load cases are leading axes of the arrays, so that one call serves both planes of every case. A bearing
gives a force and no couple; bearings and loads may stand anywhere along the shaft, in any order.

Signs: x runs along the shaft from its left end. The shear force at a section is the sum of the forces left of it, the
bending moment is the moment of these forces about the section, dM/dx = V, and the torsion is the sum of the torques
left of it. A couple is positive if it turns as a positive force does that acts right of the origin.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem


class PointLoads(NamedTuple):
    """What acts on a shaft at points."""

    position: Floats
    """x of every load [m], (n,)."""
    force: Floats
    """Transverse forces [N], (..., n)."""
    couple: Floats
    """Bending couples, such as an axial force times its lever [N m], (..., n)."""
    torque: Floats
    """Torques about the shaft's axis [N m], (..., n)."""


class Diagram(NamedTuple):
    """Shear, bending and torsion just left and just right of every load; straight lines lie between."""

    position: Floats
    """x, each one twice [m], (2 n,)."""
    shear: Floats
    """[N], (..., 2 n)."""
    bending: Floats
    """[N m], (..., 2 n)."""
    torsion: Floats
    """[N m], (..., 2 n)."""


def bearing_reactions(loads: PointLoads, bearings: ArrayLike) -> Floats:
    """Return the forces of two bearings on a shaft [N], (..., 2).

    Args:
        loads: What acts on the shaft [m, N, N m].
        bearings: x of the two bearings [m], (2,).

    Source: equilibrium of forces and moments; Pulvirenti 2023, eqs (2.43) and (2.45), the latter corrected.

    Raises:
        DesignError: If there are not two bearings at two places.

    >>> middle = PointLoads(np.array([0.5]), np.array([-100.0]), np.zeros(1), np.zeros(1))
    >>> bearing_reactions(middle, [0.0, 1.0]).tolist()
    [50.0, 50.0]
    """
    first, second = _two(np.asarray(bearings, dtype=float))
    moment = loads.force @ (loads.position - first) + loads.couple.sum(axis=-1)
    right = -moment / (second - first)
    return np.stack([-loads.force.sum(axis=-1) - right, right], axis=-1)


def _two(bearings: Floats) -> tuple[float, float]:
    if bearings.size != 2:
        message = (
            f"{bearings.size} given; two bearings hold a shaft: with fewer it falls, with more statics is not enough"
        )
        raise DesignError([Problem("bearings", message)])
    if bearings[0] == bearings[1]:
        raise DesignError([Problem("bearings", f"both stand at {1e3 * bearings[0]:g} mm; give two different places")])
    return float(bearings[0]), float(bearings[1])


def supported(loads: PointLoads, bearings: ArrayLike, *, length: float) -> PointLoads:
    """Return the loads with the reactions of the bearings among them, in balance.

    Args:
        loads: What acts on the shaft [m, N, N m].
        bearings: x of the two bearings [m], (2,).
        length: Of the shaft [m]; every load and bearing stands between 0 and it.

    Source: equilibrium; Pulvirenti 2023, eqs (2.43) and (2.45), the latter corrected.

    Raises:
        DesignError: If a load or a bearing stands outside the shaft.
    """
    seats = np.asarray(bearings, dtype=float)
    reactions = bearing_reactions(loads, seats)
    for entry, places in (("loads", loads.position), ("bearings", seats)):
        outside = places[(places < 0.0) | (places > length)]
        if outside.size:
            message = f"{1e3 * outside[0]:.6g} mm is outside the shaft; allowed: 0 to {1e3 * length:.6g} mm"
            raise DesignError([Problem(entry, message)])
    return PointLoads(
        np.concatenate([loads.position, seats]),
        np.concatenate([loads.force, reactions], axis=-1),
        _padded(loads.couple),
        _padded(loads.torque),
    )


def _padded(values: Floats) -> Floats:
    """Return values with zeros for the two bearings."""
    return np.concatenate([values, np.zeros((*values.shape[:-1], 2))], axis=-1)


def diagram(loads: PointLoads) -> Diagram:
    """Return shear, bending and torsion along a shaft under all that acts on it, reactions included.

    The largest bending moment stands at one of the stations, also that of both planes together, because the moment runs
    straight between them. Loads at one place keep their order.

    Args:
        loads: In balance [m, N, N m].

    Source: Pulvirenti 2023, eqs (2.44) and (2.46), the latter corrected: M(x) = Σ F_k (x − x_k) − Σ C_k over x_k < x.
    """
    order = np.argsort(loads.position, kind="stable")
    position, torque = loads.position[order], loads.torque[..., order]
    torsion = torque.cumsum(axis=-1)
    stations, twisted = position.repeat(2), _both_sides(torsion - torque, torsion)
    if not (loads.force.any() or loads.couple.any()):
        straight = np.zeros((*loads.force.shape[:-1], len(stations)))
        return Diagram(stations, straight, straight, twisted)
    force, couple = loads.force[..., order], loads.couple[..., order]
    shear = force.cumsum(axis=-1)
    carried = np.zeros(shear.shape)
    carried[..., 1:] = (shear[..., :-1] * (position[1:] - position[:-1])).cumsum(axis=-1)
    bending = carried - couple.cumsum(axis=-1)
    return Diagram(stations, _both_sides(shear - force, shear), _both_sides(bending + couple, bending), twisted)


def _both_sides(left: Floats, right: Floats) -> Floats:
    return np.stack([left, right], axis=-1).reshape(*left.shape[:-1], -1)
