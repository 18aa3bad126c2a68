"""One element of a round shaft: consistent mass, stiffness and gyroscopic matrices of bending, axial and torsion."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model.beam import Segment

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)
_AT, _SHARE = 0.5 * (_NODES + 1.0), 0.5 * _WEIGHTS
"""Places ξ and weights of the integration over an element, exact to ξ⁷."""


class Element(NamedTuple):
    """Matrices of one segment; bending in (deflection, slope) of both ends, axial and torsion in one of each."""

    mass: Floats
    """Bending [kg, kg m, kg m²], shape (4, 4)."""
    stiffness: Floats
    """Bending [N/m, N, N m], shape (4, 4)."""
    polar: Floats
    """Gyroscopic terms over the speed: ∫ ρ J_p of the slopes [kg m²], shape (4, 4)."""
    axial_mass: Floats
    """[kg], shape (2, 2)."""
    axial_stiffness: Floats
    """[N/m], shape (2, 2)."""
    torsion_mass: Floats
    """[kg m²], shape (2, 2)."""
    torsion_stiffness: Floats
    """[N m/rad], shape (2, 2)."""


def element(segment: Segment) -> Element:
    """Return the matrices of one segment.

    Args:
        segment: Stretch of round shaft.

    Source: Nelson 1980, J. Mech. Des. 102, 793-803: Timoshenko element, interpolated by its exact static deflection.
    """
    length, bending = segment.length, segment.elasticity * segment.second_moment
    shear = segment.shear_coefficient * segment.area * segment.shear_modulus
    softness = 12.0 * bending / (shear * length**2)
    deflection, slope, curvature = _interpolation(length, softness)
    sliding = _strain(length, softness)
    tilting = segment.density * segment.second_moment * _integral(slope, length)
    equal, against = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0, np.array([[1.0, -1.0], [-1.0, 1.0]])
    mass, polar_moment = segment.density * segment.area * length, 2.0 * segment.second_moment
    return Element(
        mass=segment.density * segment.area * _integral(deflection, length) + tilting,
        stiffness=bending * _integral(curvature, length) + shear * _integral(sliding, length),
        polar=2.0 * tilting,
        axial_mass=mass * equal,
        axial_stiffness=segment.elasticity * segment.area / length * against,
        torsion_mass=segment.density * polar_moment * length * equal,
        torsion_stiffness=segment.shear_modulus * polar_moment / length * against,
    )


def _integral(rows: Floats, length: float) -> Floats:
    return np.asarray(length * np.einsum("ag,bg,g->ab", rows, rows, _SHARE))


def _interpolation(length: float, shear: float) -> tuple[Floats, Floats, Floats]:
    """Return deflection, slope and curvature at the places of the integration by the coordinates of the ends."""
    x, one = _AT, np.ones_like(_AT)
    deflection = np.array([
        one - 3.0 * x**2 + 2.0 * x**3 + shear * (1.0 - x),
        length * (x - 2.0 * x**2 + x**3 + 0.5 * shear * (x - x**2)),
        3.0 * x**2 - 2.0 * x**3 + shear * x,
        length * (x**3 - x**2 - 0.5 * shear * (x - x**2)),
    ])  # fmt: skip
    slope = np.array([
        6.0 * (x**2 - x) / length, one - 4.0 * x + 3.0 * x**2 + shear * (1.0 - x),
        6.0 * (x - x**2) / length, 3.0 * x**2 - 2.0 * x + shear * x,
    ])  # fmt: skip
    curvature = np.array([
        6.0 * (2.0 * x - 1.0) / length, 6.0 * x - 4.0 - shear, 6.0 * (1.0 - 2.0 * x) / length, 6.0 * x - 2.0 + shear,
    ])  # fmt: skip
    return deflection / (1.0 + shear), slope / (1.0 + shear), curvature / ((1.0 + shear) * length)


def _strain(length: float, shear: float) -> Floats:
    """Return the shear strain, the same all along."""
    ends = np.array([-1.0 / length, -0.5, 1.0 / length, -0.5]) * shear / (1.0 + shear)
    return np.repeat(ends[:, None], len(_AT), axis=1)
