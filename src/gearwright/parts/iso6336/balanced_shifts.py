"""How profile shift is divided between two gears: equal specific sliding, or equal strength of the roots."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from gearwright.errors import DesignError, Problem, SolveError
from gearwright.parts.iso6336.geometry import MeshGeometry
from gearwright.parts.iso6336.root import outer_single_contact, root_section

_HALVINGS = 50
_EDGE = 1e-6
"""Curvature of a flank over the module below which its sliding has no bound [-]."""
Balance = Callable[[MeshGeometry], float]


def specific_slidings(mesh: MeshGeometry) -> tuple[float, float]:
    """Return the largest specific sliding at the roots of both gears, as positive numbers [-].

    Args:
        mesh: The pair, external or internal.

    Returns:
        −ζ_f1 where the wheel's tip touches the pinion, −ζ_f2 where the pinion's tip touches the wheel; infinite where
        a tip reaches past the mate's involute.

    Source: ISO 21771:2007, ζ_f1 = 1 − ρ_A2/(u ρ_A1), ζ_f2 = 1 − u ρ_E1/ρ_E2.

    >>> geometry = MeshGeometry((20.0, 20.0), 1.0, 10.0, 20.0, (11.0, 11.0))
    >>> first, second = specific_slidings(geometry)
    >>> first == second
    True
    """
    side, ratio = float(mesh.side), abs(float(mesh.ratio))
    reach = float(mesh.centre_distance * np.sin(mesh.working_angle))
    tips = [0.5 * float(base * tangent) for base, tangent in zip(mesh.base_diameters, mesh.tip_tangents, strict=True)]
    root_first = side * (reach - tips[1])
    root_second = reach - tips[0] if side > 0.0 else reach + tips[0]
    edge = _EDGE * float(mesh.module)
    first = tips[1] / (ratio * root_first) - 1.0 if root_first > edge else math.inf
    second = ratio * tips[0] / root_second - 1.0 if root_second > edge else math.inf
    return first, second


def sliding_balance(mesh: MeshGeometry) -> float:
    """Return by how much the pinion's root slides more than the wheel's [-]; negative where it slides less.

    Args:
        mesh: The pair.

    Source: DIN 3992:1964 and Niemann & Winter, Maschinenelemente II: equal specific sliding at both ends.
    """
    first, second = specific_slidings(mesh)
    return 0.0 if first == second else first - second


def strength_balance(mesh: MeshGeometry) -> float:
    """Return by how much the nominal root stress of the pinion is above the wheel's, ln of their ratio [-].

    Args:
        mesh: The pair.

    Source: ISO 6336-3:2019, σ_F0 ~ Y_F Y_S, both at the outer point of single contact; gears of one steel.
    """
    first, second = (root_section(outer_single_contact(mesh, gear)) for gear in (0, 1))
    return math.log(float(first.form * first.stress_correction / (second.form * second.stress_correction)))


BALANCES: dict[str, Balance] = {"sliding": sliding_balance, "strength": strength_balance}
"""Name in a design file -> what is to be nothing."""


def balanced_shift(shape: Callable[[float], MeshGeometry], least: float, most: float, *, by: str) -> float:
    """Return the profile shift of the pinion at which both gears are balanced [-]; a limit where none balances them.

    Args:
        shape: x_1 [-] -> the pair, whose other shift follows.
        least: Smallest x_1 that is looked at [-].
        most: Largest x_1 [-].
        by: A name of `BALANCES`.

    Source: bisection; more shift of the pinion lowers its sliding and its root stress, and raises the wheel's.

    Raises:
        DesignError: If no shift between the limits makes teeth.
    """
    balance = BALANCES[by]
    for _ in range(_HALVINGS):
        middle = 0.5 * (least + most)
        try:
            above = balance(shape(middle)) > 0.0
        except SolveError as error:
            raise DesignError([Problem("profile_shift", f"x_1 = {middle:.3f} makes no teeth: {error}")]) from None
        least, most = (middle, most) if above else (least, middle)
    return round(0.5 * (least + most), 4)
