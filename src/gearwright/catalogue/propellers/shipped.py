"""Propeller maps that come with gearwright, and the air's compressibility on their thrust."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from gearwright.catalogue.propellers.charts import hamilton_standard_charts
from gearwright.catalogue.propellers.maps import map_of
from gearwright.catalogue.tables import data_text
from gearwright.errors import DesignError, Problem, near
from gearwright.machines import SMALL_THRUST, Blades, PropellerMap, compressibility

MAPS: Mapping[str, Blades] = {
    "6-blades-af115": Blades(6, 115.0, 0.5),
    "4-blades-af114": Blades(4, 114.0, 0.5),
}
"""Shipped maps by name -> blades; activity factor and lift are assumptions for a propeller of the ATR 72's class."""
ALL_STATES: Mapping[str, str] = {f"{name}-all-states": name for name in MAPS}
"""Maps that blade elements carry on to windmilling, feather and reverse -> the shipped map that they carry on."""


@cache
def propeller_map(name: str) -> PropellerMap:
    """Return a shipped propeller map.

    Args:
        name: Such as ``6-blades-af115``, which ends with the charts at positive thrust, or
            ``6-blades-af115-all-states``, which blade elements carry on.

    Raises:
        DesignError: There is none of this name; with the nearest one.
    """
    known = [*MAPS, *ALL_STATES]
    if name not in known:
        raise DesignError([Problem("propeller_map", f"there is no shipped map {name!r}; {near(name, known)}")])
    return map_of(data_text(f"propeller_{name}.csv"), name)


def compressed(name: str, advance_ratio: float, thrust_coefficient: float, *, mach: float, tip_mach: float) -> float:
    """Return the factor of the air's compressibility on the thrust of a propeller map [-].

    Args:
        name: Of a shipped map; a map of the user's own stays as it is: 1.
        advance_ratio: J [-].
        thrust_coefficient: C_T of the map [-].
        mach: Flight Mach number [-].
        tip_mach: π n D over the speed of sound [-].

    Source: Worobel and Mayo, NASA CR-114399 (1971).

    Raises:
        DesignError: The charts do not hold the Mach number.
    """
    name = ALL_STATES.get(name, name)
    if name not in MAPS or thrust_coefficient <= 0.0:
        return 1.0
    factor, left = compressibility(
        hamilton_standard_charts(),
        MAPS[name],
        advance_ratio,
        thrust_coefficient=thrust_coefficient,
        mach=mach,
        tip_mach=tip_mach,
    )
    outside = [table for table in left if table != SMALL_THRUST]
    if outside:
        message = (
            f"Mach {mach:.3f}, {tip_mach:.3f} at the tips, at advance ratio {advance_ratio:.3g} lies outside the charts"
            f" ({', '.join(outside)}); fly slower, turn slower, or give a map of your own"
        )
        raise DesignError([Problem("propeller.map", message)])
    return factor
