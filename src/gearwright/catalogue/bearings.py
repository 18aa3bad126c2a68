"""Standard rolling bearings: boundary dimensions of ISO 15 and ISO 355, and ratings of a plain design of that size.

A standard fixes the outside of a bearing and not its inside. The ratings here are those of ISO 281 and ISO 76 for
rolling elements that fill the room between the rings as usual; ``bearing_series.csv`` says how, by range of bores:
element diameter over (D − d), share of the circle that elements take, roller length over width (of the cup, for taper
rollers), steel over room where that of its kind does not hold. The shares were fitted to the mean of a public
catalogue: a maker's own rating differs by 4 % (balls) to 8 % (rollers) as a rule, and by 22 % at most; reinforced
makes of NU 10 carry 41 to 57 % more. Take the maker's number where the maker is known, with `with_ratings`.

Dimensions: SKF, General Catalogue (of 1129 pages); those of bores from 160 mm on and of series 618, 619 and NU 10 also
as NSK (Rolling Bearings) and JTEKT (Koyo, Ball & Roller Bearings) print them: all that they list alike, without
exception.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import MappingProxyType

from gearwright.base import DesignError, Force, Length, Mass, Problem, near
from gearwright.catalogue.tables import data_rows
from gearwright.parts.bearings import (
    STEEL_DENSITY,
    BearingGeometry,
    BearingKind,
    dynamic_rating,
    fatigue_load_limit,
    static_rating,
)

_MM = 1e3
"""Millimetres in a metre."""
FOUR_POINT_ANGLE = math.radians(35.0)
"""Nominal contact angle of four-point contact bearings [rad]."""
STEEL_SHARE = {
    BearingKind.DEEP_GROOVE: 0.67,
    BearingKind.FOUR_POINT: 0.85,
    BearingKind.CYLINDRICAL: 0.69,
    BearingKind.TAPER: 0.72,
}
"""Steel over the room between bore, outside and faces [-]: 6209, QJ 312, NU 212 and 30209 as makers weigh them."""


@dataclass(frozen=True)
class Bearing:
    """A rolling bearing of standard size, with its ratings."""

    designation: str
    """Such as ``NU 2212``."""
    bore: Length
    """d [m]."""
    outer_diameter: Length
    """D [m]."""
    width: Length
    """B, of a taper roller bearing T [m]."""
    geometry: BearingGeometry
    """What is assumed inside."""
    dynamic_rating: Force
    """C [N]."""
    static_rating: Force
    """C_0 [N]."""
    fatigue_limit: Force
    """C_u [N]."""
    mass: Mass
    """[kg]"""
    source: str
    """Where dimensions and ratings come from."""

    @property
    def kind(self) -> BearingKind:
        """Kind of bearing."""
        return self.geometry.kind


@dataclass(frozen=True)
class _Series:
    """How the rolling elements of a series fill their room."""

    name: str
    kind: BearingKind
    outer_column: str
    width_column: str
    smallest: float
    """Bore from which the shares hold [mm]."""
    largest: float
    """And to which [mm]."""
    element_ratio: float
    circle_share: float
    length_ratio: float
    steel_share: float
    """Steel over the room between bore, outside and faces [-]."""


@cache
def bearings() -> Mapping[str, Bearing]:
    """Return every bearing of the catalogue by designation."""
    return MappingProxyType({standard.designation: standard for standard in (*_radial(), *_taper())})


def bearing(designation: str) -> Bearing:
    """Return a bearing of the catalogue.

    Args:
        designation: Such as ``6209``.

    Raises:
        DesignError: If the catalogue does not have it.
    """
    if designation not in bearings():
        message = f"this bearing is not in the catalogue; {_nearest(designation)}"
        raise DesignError([Problem("bearing", f"{designation!r}: {message}")])
    return bearings()[designation]


def with_ratings(standard: Bearing, dynamic: float, static: float, *, source: str) -> Bearing:
    """Return a bearing with the ratings of its maker.

    Args:
        standard: From `bearing`.
        dynamic: C [N].
        static: C_0 [N].
        source: Maker and catalogue.

    Raises:
        DesignError: If a rating is not positive.
    """
    if min(dynamic, static) <= 0.0:
        message = f"C = {dynamic:g} N and C_0 = {static:g} N given; both are above 0"
        raise DesignError([Problem(standard.designation, message)])
    limit = fatigue_load_limit(static, standard.geometry)
    return replace(standard, dynamic_rating=dynamic, static_rating=static, fatigue_limit=limit, source=source)


def pressure_centre(standard: Bearing) -> Length:
    """Return how far a bearing's load acts beside the middle of its width, towards the back of its inner ring [m].

    Args:
        standard: From `bearing`; 0 for all but taper rollers.

    Source: geometry: rollers in the middle of the cup, from there D_pw/2 tan α towards the open side of the cup, less
        (T − C)/2 by which the cup stands back. Makers print a of their own bearings.

    >>> round(1e3 * pressure_centre(bearing("33118")), 1)
    11.0
    """
    cup = _cups().get(standard.designation)
    if cup is None:
        return 0.0
    inside = standard.geometry
    return inside.pitch_diameter / 2.0 * math.tan(inside.contact_angle) - (standard.width - cup) / 2.0


@cache
def _cups() -> Mapping[str, Length]:
    """Return taper roller bearing -> width C of its outer ring [m]."""
    rows = data_rows("taper_bearing_sizes.csv")
    return MappingProxyType({row["designation"]: float(row["cup_width_mm"]) / _MM for row in rows})


def _nearest(designation: str) -> str:
    known = near(designation, bearings())
    return known if known.startswith("did") else f"series: {', '.join(dict.fromkeys(row.name for row in _series()))}"


@cache
def _series() -> tuple[_Series, ...]:
    return tuple(
        _Series(
            row["series"],
            BearingKind(row["kind"]),
            row["outer_column"],
            row["width_column"],
            float(row["from_mm"] or 0.0),
            float(row["to_mm"] or math.inf),
            float(row["element_ratio"]),
            float(row["circle_share"]),
            float(row["length_ratio"] or 0.0),
            float(row["steel_share"] or STEEL_SHARE[BearingKind(row["kind"])]),
        )
        for row in data_rows("bearing_series.csv")
    )


def _radial() -> Iterator[Bearing]:
    """Yield bearings of ISO 15, series by series."""
    source = "dimensions ISO 15; ratings ISO 281 and ISO 76 for the assumed inside"
    sizes = data_rows("bearing_sizes.csv")
    for series in _series():
        for row in sizes if series.outer_column else ():
            if row[series.outer_column] and series.smallest <= float(row["bore_mm"]) <= series.largest:
                bore, outer = float(row["bore_mm"]) / _MM, float(row[series.outer_column]) / _MM
                width = float(row[series.width_column]) / _MM
                angle = FOUR_POINT_ANGLE if series.kind is BearingKind.FOUR_POINT else 0.0
                inside = _inside(series, bore, outer, angle=angle, length=width)
                name = f"{series.name}{row['code']}"
                yield _rated(name, inside, series, source, bore=bore, outer=outer, width=width)


def _taper() -> Iterator[Bearing]:
    """Yield taper roller bearings of ISO 355."""
    source = "dimensions ISO 355; contact angle from e as printed in catalogues; ratings ISO 281 and ISO 76"
    by_name = {series.name: series for series in _series()}
    for row in data_rows("taper_bearing_sizes.csv"):
        bore, outer = float(row["bore_mm"]) / _MM, float(row["outer_mm"]) / _MM
        angle = math.atan(float(row["axial_limit"]) / 1.5)
        cup, width = float(row["cup_width_mm"]) / _MM, float(row["width_mm"]) / _MM
        series = by_name[row["designation"][:3]]
        inside = _inside(series, bore, outer, angle=angle, length=cup)
        yield _rated(row["designation"], inside, series, source, bore=bore, outer=outer, width=width)


def _inside(series: _Series, bore: float, outer: float, *, angle: float, length: float) -> BearingGeometry:
    """Return rolling elements that fill the room between the rings as their series does."""
    element, pitch = series.element_ratio * (outer - bore), (outer + bore) / 2.0
    places = series.circle_share * math.pi / math.asin(element / pitch)
    first = 1 if series.kind is BearingKind.DEEP_GROOVE else 0
    return BearingGeometry(
        kind=series.kind,
        elements=math.floor(places) + first,
        diameter=element,
        pitch_diameter=pitch,
        contact_angle=angle,
        roller_length=series.length_ratio * length,
        rows=2 if series.kind is BearingKind.FOUR_POINT else 1,
    )


def _rated(
    name: str, inside: BearingGeometry, series: _Series, source: str, *, bore: float, outer: float, width: float
) -> Bearing:
    static = static_rating(inside)
    steel = STEEL_DENSITY * series.steel_share
    return Bearing(
        designation=name,
        bore=bore,
        outer_diameter=outer,
        width=width,
        geometry=inside,
        dynamic_rating=dynamic_rating(inside),
        static_rating=static,
        fatigue_limit=fatigue_load_limit(static, inside),
        mass=steel * math.pi / 4.0 * (outer**2 - bore**2) * width,
        source=source,
    )
