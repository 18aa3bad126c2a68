"""What a rolling bearing weighs before one is chosen: by the load that it must bear, and by the shaft that it holds."""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np

from gearwright.catalogue import bearings
from gearwright.parts.bearings import BearingKind

SOURCE = "similarity through the catalogue's cylindrical roller bearings (ISO 15, ISO 281)"
SURE = 0.30
"""One standard deviation of a bearing that is not chosen, over its value [-]: its series, and what its thrust adds."""
_LIGHT = 0.25
"""Share of the catalogue's sizes that are the lightest around their shaft [-]."""


class Similar(NamedTuple):
    """How the mass of similar bearings grows."""

    by_load: float
    """C/m^(2/3) [N/kg^(2/3)]: at equal stress ratings grow as areas and masses as volumes."""
    by_bore: float
    """m/d³ of light series [kg/m³]."""


@cache
def similar() -> Similar:
    """Return the geometric means over the catalogue's cylindrical roller bearings."""
    rollers = [size for size in bearings().values() if size.kind == BearingKind.CYLINDRICAL and size.bore >= 0.03]
    loads = np.log([size.dynamic_rating / size.mass ** (2.0 / 3.0) for size in rollers])
    bores = np.sort(np.log([size.mass / size.bore**3 for size in rollers]))
    return Similar(float(np.exp(loads.mean())), float(np.exp(np.quantile(bores, _LIGHT))))


def rating_for(load: float, life: float, speed: float) -> float:
    """Return the dynamic rating that a roller bearing needs [N].

    Args:
        load: Equivalent dynamic load P [N].
        life: L_10h [s].
        speed: Of its rings against each other [rad/s].

    Source: ISO 281:2007, L_10 = (C/P)^(10/3).
    """
    turns = life * abs(speed) / (2.0 * math.pi)
    return float(load * max(turns / 1e6, 0.0) ** 0.3)


def loaded_mass(rating: float) -> float:
    """Return the mass of a roller bearing with a rating [kg].

    Args:
        rating: C [N].
    """
    return float((rating / similar().by_load) ** 1.5)


def bored_mass(bore: float) -> float:
    """Return the mass of a bearing of light series on a shaft [kg].

    Args:
        bore: d [m].
    """
    return similar().by_bore * bore**3
