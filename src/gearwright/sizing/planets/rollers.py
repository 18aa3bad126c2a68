"""Rollers that run between a pin and a planet: proportioned to the pin, and rated as the standards do."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.catalogue import Bearing
from gearwright.parts.bearings import (
    CERAMIC_DENSITY,
    STEEL_DENSITY,
    BearingGeometry,
    BearingKind,
    ceramic_share,
    dynamic_rating,
    fatigue_load_limit,
    rolling_weights,
    static_rating,
    turning_inertia,
)
from gearwright.sizing.pinned import PlanetBearingSizing


class Proportions(NamedTuple):
    """How rollers of a kind fill the room between pin and planet; assumptions."""

    roller: float
    """Diameter over that of the pin [-]."""
    length: float
    """Of the rollers, over the width: cage and ribs take the rest [-]."""
    circle: float
    """Part of the pitch circle that rollers take; the cage's bars have the rest [-]."""
    density: float = STEEL_DENSITY
    """Of the rollers [kg/m³]."""
    share: float = 1.0
    """Of the ratings with steel rollers [-]."""


PROPORTIONS = {
    "needle": Proportions(0.10, 0.85, 0.85),
    "integral": Proportions(0.25, 0.80, 0.85),
    "ceramic": Proportions(0.25, 0.80, 0.85, CERAMIC_DENSITY, ceramic_share()),
}
"""Kind -> how it is proportioned."""
FEWEST = 6
"""Rollers of an integral bearing, at least [-]."""


def roller_of(kind: str, pin: float, given: float | None) -> float:
    """Return the diameter of the rollers on a pin [m].

    Args:
        kind: needle, integral or ceramic.
        pin: Its diameter [m].
        given: Of the rollers, by the user [m].
    """
    return given or PROPORTIONS[kind].roller * pin


def integral(kind: str, pin: float, roller: float, *, width: float) -> Bearing | None:
    """Return rollers between a pin and a planet as a bearing without rings; None where too few have room.

    Args:
        kind: needle, integral or ceramic.
        pin: Diameter of the pin, the inner raceway [m].
        roller: Diameter of the rollers [m].
        width: Of their room [m].

    Source: ISO 281:2007, 7.1 and ISO 76:2006 for the rollers that fill the circle; both for steel on steel.
    """
    way, pitch = PROPORTIONS[kind], pin + roller
    count = math.floor(way.circle * math.pi / math.asin(roller / pitch))
    if count < FEWEST:
        return None
    inside = BearingGeometry(BearingKind.CYLINDRICAL, count, roller, pitch, roller_length=way.length * width)
    static = way.share * static_rating(inside)
    weights = rolling_weights(inside, pin, pitch + roller, width, density=way.density)
    return Bearing(
        designation=f"{kind} {1e3 * pin:.4g}x{1e3 * (pitch + roller):.4g}x{1e3 * width:.4g}",
        bore=pin,
        outer_diameter=pitch + roller,
        width=width,
        geometry=inside,
        dynamic_rating=way.share * dynamic_rating(inside),
        static_rating=static,
        fatigue_limit=fatigue_load_limit(static, inside),
        mass=weights.total,
        source="rollers in the room of the planet; ratings ISO 281 and ISO 76",
    )


def on_rollers(kind: str, made: Bearing, side_by_side: int) -> PlanetBearingSizing:
    """Return what a planet turns on with what of it turns.

    Args:
        kind: As the design asks.
        made: One of the bearings.
        side_by_side: Equal ones on a pin [-].
    """
    density = PROPORTIONS[kind].density if kind in PROPORTIONS else STEEL_DENSITY
    parts = rolling_weights(made.geometry, made.bore, made.outer_diameter, made.width, density=density)
    return PlanetBearingSizing(
        kind=kind,
        bearing=made,
        side_by_side=side_by_side,
        pin_diameter=made.bore,
        outer_diameter=made.outer_diameter,
        width=side_by_side * made.width,
        clearance=0.0,
        turning_mass=side_by_side * (parts.outer_ring + parts.elements + parts.cage),
        turning_inertia=side_by_side * turning_inertia(parts, made.geometry, made.outer_diameter),
        standing_mass=side_by_side * parts.inner_ring,
    )
