"""Which tooth numbers make a planetary set that can be put together."""

from __future__ import annotations

import math

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

    Source: (z_s + z_r)/N integer; VDI 2157, any text on epicyclic gears.
    """
    return np.asarray((np.asarray(sun_teeth) + np.asarray(ring_teeth)) % planets == 0)


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


def most_planets(sun_teeth: int, planet_teeth: int) -> int:
    """Return the largest number of planets whose tips stay clear [-].

    Args:
        sun_teeth: z_s [-].
        planet_teeth: z_p [-].

    Source: N = floor(π / asin((z_p + 2)/(z_s + z_p))), which replaces Pulvirenti 2023, eq. (1.4).

    >>> most_planets(18, 27)
    4
    """
    sine = (planet_teeth + ADDENDUMS) / (sun_teeth + planet_teeth)
    if sine >= 1.0:
        return 1
    count = int(math.pi / math.asin(sine))
    return count if bool(neighbours_clear(sun_teeth, planet_teeth, count)) else count - 1
