"""Scales of a gear pair's motion: the frequency and the length that make its equations dimensionless."""

from __future__ import annotations

import math


def mesh_frequency_scale(stiffness: float, inertias: tuple[float, float], base_radii: tuple[float, float]) -> float:
    """Return the natural circular frequency of a gear pair alone on its mesh stiffness, ω_n [rad/s].

    Args:
        stiffness: Mean mesh stiffness along the line of action k [N/m].
        inertias: Polar inertias of the two gears I_1, I_2 [kg m²].
        base_radii: Base radii r_1, r_2 [m]; pitch radii, as printed, give 1/cos α too much.

    Returns:
        ω_n = √(k (I_1 r_2² + I_2 r_1²)/(I_1 I_2)).

    Source: Wang, Zhao, Tao, Jia & Guo, "Floating shaft load sharing method for face gear split torque transmission
        system", text above eq. 12.

    >>> round(mesh_frequency_scale(4e8, (5e-4, 0.033), (0.0256 * 0.9396926, 0.0992 * 0.9396926)))
    23839
    """
    one, other = inertias
    return math.sqrt(stiffness * (one * base_radii[1] ** 2 + other * base_radii[0] ** 2) / (one * other))


def mesh_length_scale(torque: float, radius: float, stiffness: float) -> float:
    """Return the deflection of one of two equal meshes under half the torque, b_c [m].

    Args:
        torque: Of the pinion between two wheels [N m].
        radius: Of the pinion: its pitch radius as printed, or its base radius, along the line of action [m].
        stiffness: Mean mesh stiffness [N/m].

    Returns:
        b_c = T/(2 r k).

    Source: Wang, Zhao, Tao, Jia & Guo, text above eq. 12.

    >>> round(1e6 * mesh_length_scale(786.48, 0.0256, 4e8), 1)
    38.4
    """
    return torque / (2.0 * radius * stiffness)
