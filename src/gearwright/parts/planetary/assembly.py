"""Which tooth numbers make a planetary set that can be put together, and where its planets stand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from gearwright.arrays import Bools

ADDENDUMS = 2
"""Tip circles of neighbouring planets stand two modules outside the pitch circle's diameter."""


def assembles(sun_teeth: ArrayLike, ring_teeth: ArrayLike, planets: int) -> Bools:
    """Tell whether equally spaced planets can be assembled.

    Args:
        sun_teeth: z_s [-].
        ring_teeth: z_r [-].
        planets: N [-].

    Source: (z_s + z_r)/N integer, whatever the profile shifts; VDI 2157, any text on epicyclic gears.
    """
    return np.asarray((np.asarray(sun_teeth) + np.asarray(ring_teeth)) % planets == 0)


def even_positions(planets: int) -> tuple[float, ...]:
    """Return the angles of equally spaced planets, the first at zero.

    Args:
        planets: Number of planets N [-].

    Returns:
        ψ_n = 2π n/N [rad]; Pulvirenti 2023, eq. (3.34), prints N − 1.

    Source: Parker & Lin 2004, J. Mech. Des. 126, 365-370.
    """
    return tuple(2.0 * math.pi * n / planets for n in range(planets))


def nearest_positions(sun_teeth: int, ring_teeth: int, planets: int) -> tuple[float, ...]:
    """Return the angles at which planets can be put in, nearest to equal ones, the first at zero.

    Args:
        sun_teeth: z_s [-].
        ring_teeth: z_r [-].
        planets: N [-].

    Returns:
        ψ_n = 2π/(z_s + z_r) · round(n (z_s + z_r)/N) [rad]; planets that are opposite each other stay so.

    Source: teeth of sun and ring meet a planet at whole multiples of 2π/(z_s + z_r); VDI 2157.

    >>> places = nearest_positions(27, 99, 4)
    >>> [round(math.degrees(second - first), 2) for first, second in zip(places, places[1:])]
    [91.43, 88.57, 91.43]
    """
    total = sun_teeth + ring_teeth
    if total % planets == 0:
        return even_positions(planets)
    return tuple(2.0 * math.pi / total * math.floor(n * total / planets + 0.5) for n in range(planets))


def tip_gap(centre: float, tip_radius: float, positions: Sequence[float]) -> float:
    """Return the least gap between the tip circles of neighbouring planets, in the unit of the radii.

    Args:
        centre: Radius of the pin circle a_w [m], or over the module.
        tip_radius: Of a planet r_a [m], or over the module.
        positions: Angles of the planets [rad], in order.

    Returns:
        2 a_w sin(Δψ/2) − 2 r_a of the nearest two; infinite for one planet.

    Source: chord of the pin circle; VDI 2157.

    >>> round(tip_gap(27.0, 19.0, even_positions(3)), 3)
    8.765
    """
    if len(positions) < 2:
        return math.inf
    closed = [*positions, positions[0] + 2.0 * math.pi]
    nearest = min(after - before for before, after in pairwise(closed))
    return 2.0 * centre * math.sin(0.5 * min(nearest, math.pi)) - 2.0 * tip_radius


def neighbours_clear(sun_teeth: ArrayLike, planet_teeth: ArrayLike, planets: int) -> Bools:
    """Tell whether the tips of neighbouring planets stay clear of each other.

    Args:
        sun_teeth: z_s [-].
        planet_teeth: z_p [-].
        planets: N [-].

    Source: (z_s + z_p) sin(π/N) > z_p + 2 for standard addenda.
    """
    if planets == 1:
        return np.ones(np.broadcast(sun_teeth, planet_teeth).shape, dtype=bool)
    reach = (np.asarray(sun_teeth) + np.asarray(planet_teeth)) * math.sin(math.pi / planets)
    return np.asarray(reach > np.asarray(planet_teeth) + ADDENDUMS)


def most_planet_teeth(sun_teeth: int, planets: int) -> float:
    """Return the tooth number below which planets must stay to pass their neighbours [-].

    Args:
        sun_teeth: z_s [-].
        planets: N, at least 3; two planets pass each other whatever their teeth [-].

    Source: z_p = (z_s sin(π/N) − 2)/(1 − sin(π/N)), the limit of `neighbours_clear`.

    >>> round(most_planet_teeth(18, 4), 2)
    36.63
    """
    sine = math.sin(math.pi / planets)
    return (sun_teeth * sine - ADDENDUMS) / (1.0 - sine)


def most_planets(centre: float, tip_radius: float) -> int:
    """Return the largest number of equally spaced planets whose tips stay clear [-].

    Args:
        centre: Radius of the pin circle a_w [m], or over the module.
        tip_radius: Of a planet r_a [m], or over the module.

    Source: N = floor(π / asin(r_a/a_w)), which replaces Pulvirenti 2023, eq. (1.4).

    >>> most_planets(22.5, 14.5)
    4
    """
    sine = tip_radius / centre
    if sine >= 1.0:
        return 1
    count = int(math.pi / math.asin(sine))
    return count if tip_gap(centre, tip_radius, even_positions(count)) > 0.0 else count - 1
