"""Load factor of planets with one pin out of place: the closed form of the translational analogy."""

from __future__ import annotations

import math


def pin_error_share(
    planets: int, error: float, force: float, *, stiffness: tuple[float, float], pressure_angle: float, floating: bool
) -> float:
    """Return the share of the planet whose pin stands out of place, L_1 [-].

    Args:
        planets: Number of evenly spaced planets N [-].
        error: Tangential error of its pin, positive where it loads the planet more e [m].
        force: Carrier torque over the pin radius F [N].
        stiffness: Mean mesh stiffness with the sun and with the ring k_sp, k_rp [N/m].
        pressure_angle: Working transverse pressure angle of both meshes α [rad].
        floating: One central member is free to move across.

    Returns:
        L_1 = 1/N + c K e/F with K = 4 cos² α/(1/k_sp + 1/k_rp); c = (N − 3)/N with a floating member, else
        (N − 1)/N.

    Source: Ligata, Kahraman & Singh 2009, J. Mech. Des. 131, 041010 (N = 4: 1/4 + K e/(4 F)); for every N by projection
        onto what the free motions cannot take up.

    Valid for: rigid ring, carrier and pins; all planets loaded; N ≥ 3.

    >>> set_up = dict(stiffness=(5e8, 5e8), pressure_angle=math.radians(24.6), floating=True)
    >>> [round(pin_error_share(n, 1e-5, 4e4, **set_up), 6) for n in (3, 4, 5, 6)]
    [0.333333, 0.301669, 0.282671, 0.270005]
    """
    free = 3 if floating else 1
    loop = 4.0 * math.cos(pressure_angle) ** 2 / (1.0 / stiffness[0] + 1.0 / stiffness[1])
    return 1.0 / planets + (planets - free) / planets * loop * error / force


def pin_error_within(
    planets: int, load_factor: float, force: float, *, stiffness: tuple[float, float], pressure_angle: float,
    floating: bool,
) -> float:  # fmt: skip
    """Return by how much one pin may stand out of place along the circle, so that a load factor is kept [m].

    Args:
        planets: Number of evenly spaced planets N [-].
        load_factor: K_γ = N L_1, at least 1 [-].
        force: Carrier torque over the pin radius F [N].
        stiffness: Mean mesh stiffness with the sun and with the ring k_sp, k_rp [N/m].
        pressure_angle: Working transverse pressure angle of both meshes α [rad].
        floating: One central member is free to move across.

    Returns:
        e = (K_γ − 1) F/(N c K); without limit for three planets with a floating member.

    Source: `pin_error_share`, solved for the error.

    Valid for: as `pin_error_share`.

    >>> round(1e6 * pin_error_within(4, 1.15, 4e4, stiffness=(5e8, 5e8), pressure_angle=0.42, floating=False), 3)
    2.399
    """
    reach = 1e-6
    per = pin_error_share(planets, reach, force, stiffness=stiffness, pressure_angle=pressure_angle, floating=floating)
    rise = (planets * per - 1.0) / reach
    return (load_factor - 1.0) / rise if rise > 0.0 else math.inf
