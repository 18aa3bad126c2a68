"""Mesh load factors K_γ of planets and of parallel paths: one pin out of place, tolerances of all, clocking."""

from __future__ import annotations

import math
from statistics import NormalDist


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


RARE = 0.01
"""Part of the sets whose most loaded planet may bear more than K_γ says [-]."""
CLOCKED = 0.0375
"""Load that moves from one of two paths to the other for each mrad of clocking at `CLOCKED_TORQUE` [1/mrad]."""
CLOCKED_TORQUE = 367.0
"""Torque of the input of the split that was measured [N m]."""


def path_stiffness(meshes: float, width: float, *, bearing: float, pressure_angle: float) -> float:
    """Return the tangential force on a planet's teeth for each metre that its pin stands out of place [N/m].

    Args:
        meshes: c_γ of one mesh, as a mean of both [N/m²].
        width: Face width b [m].
        bearing: Radial stiffness of a planet's bearing on its pin [N/m].
        pressure_angle: Working transverse pressure angle α [rad].

    Source: both meshes in parallel behind the bearing in series, c_γ b cos² α/(1 + 2 c_γ b cos² α/k).

    >>> round(path_stiffness(20e9, 57e-3, bearing=1e9, pressure_angle=math.radians(20.0)) / 1e6)
    334
    """
    mesh = meshes * width * math.cos(pressure_angle) ** 2
    return mesh / (1.0 + 2.0 * mesh / bearing)


def tolerance_load_factor(planets: int, deviation: float, force: float, *, stiffness: float, floating: bool) -> float:
    """Return K_γ of a set whose pins stand out of place at random: 99 of 100 sets share better [-].

    Args:
        planets: Number of planets p [-].
        deviation: Standard deviation of the tangential place of a planet: of pin, runout and tooth thickness [m].
        force: Tangential force of one mesh F_t where all share alike [N].
        stiffness: From `path_stiffness` [N/m].
        floating: Whether a central member is free to move across.

    Returns:
        1 + z √((p − f)/p) s k/F_t, f = 3 with a floating member and 1 without, z the normal deviate that one planet
        surpasses in 0.01/p of all cases: p planets together do so in at most one set of a hundred.

    Source: projection of random errors onto what the free motions cannot take up, with Bonferroni's bound on the
        largest of p; from five planets on it is the 99th percentile of random sets within 0.001, for four 0.025 above.

    Valid for: all planets loaded, K_γ below 2.

    >>> round(tolerance_load_factor(5, 10e-6, 28500.0, stiffness=334e6, floating=True), 2)
    1.21
    """
    free = 3 if floating else 1
    deviate = NormalDist().inv_cdf(1.0 - RARE / planets)
    return 1.0 + deviate * math.sqrt(max(planets - free, 0) / planets) * deviation * stiffness / force


def clocking_load_factor(clocking: float, torque: float) -> float:
    """Return K_γ of two paths that are clocked to each other [-].

    Args:
        clocking: By how much their clocking misses [rad].
        torque: Of the input of the split [N m].

    Source: Krantz & Delgado 1996, NASA TM-107202: 53 % at most in one of two paths within 0.8 mrad at 367 N m; K_γ − 1
        falls with the torque.

    >>> round(clocking_load_factor(0.8e-3, 367.0), 2)
    1.06
    """
    return 1.0 + 2.0 * CLOCKED * 1e3 * clocking * CLOCKED_TORQUE / torque
