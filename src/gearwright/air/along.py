"""Air and airspeeds along a flight: the formulas for one place, over arrays of places."""

from __future__ import annotations

from typing import cast

import numpy as np

from gearwright.air import airspeed, atmosphere
from gearwright.air.airspeed import _subsonic
from gearwright.air.atmosphere import Air, check_air
from gearwright.arrays import Floats
from gearwright.lanes import rebound


def _all_subsonic(mach: Floats) -> Floats:
    for value in (np.min(mach), np.max(mach)):
        _subsonic(float(value))
    return mach


_AIR = rebound(atmosphere)
_SPEED = rebound(airspeed, _subsonic=_all_subsonic)


def air_along(altitude: Floats, offset: float | Floats = 0.0) -> Air:
    """Return the air at many pressure altitudes; its fields are arrays of their shape.

    Args:
        altitude: Geopotential pressure altitudes, shape (n,) [m].
        offset: Temperature above the standard one, one or shape (n,) [K].

    Source: `air_at`.

    Raises:
        DesignError: As `air_at`, for the least and the largest of them.
    """
    offsets = (offset, offset) if isinstance(offset, float) else (float(np.min(offset)), float(np.max(offset)))
    for height, warmer in zip((altitude.min(), altitude.max()), offsets, strict=True):
        check_air(float(height), warmer)
    return cast(Air, _AIR._state(altitude, offset))


def true_along(calibrated: Floats, air: Air) -> Floats:
    """Return the true airspeeds of calibrated ones, shape (n,) [m/s].

    Args:
        calibrated: CAS, shape (n,) [m/s].
        air: Where they are flown; its fields are arrays.

    Source: `true_of_calibrated`.

    Raises:
        DesignError: Mach 1 or above.
    """
    return cast(Floats, _SPEED.true_of_calibrated(calibrated, air))


def stagnation_along(air: Air, mach: Floats) -> tuple[Floats, Floats]:
    """Return stagnation temperatures and pressures over those of the standard sea level, each of shape (n,) [-].

    Args:
        air: Where it is flown; its fields are arrays.
        mach: Flight Mach numbers, shape (n,) [-].

    Source: `stagnation_ratios`.
    """
    return cast(tuple[Floats, Floats], _SPEED.stagnation_ratios(air, mach))
