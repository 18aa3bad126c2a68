"""Selection of the lightest catalogue bearing for a duty, and modified rating life with its oil."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from types import MappingProxyType
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import DesignError, Force, Length, Origin, Problem, Quantity, Ratio, Speed, Time, refuse
from gearwright.catalogue.bearings import Bearing, bearings
from gearwright.catalogue.tables import data_rows
from gearwright.parts.bearings import (
    DEEP_GROOVE_STATIC,
    FOUR_POINT,
    FOUR_POINT_STATIC,
    BearingGeometry,
    BearingKind,
    Cleanliness,
    LoadFactors,
    OilFilter,
    StaticFactors,
    ball_static_factor,
    basic_life,
    cleanliness_factor,
    contamination_factor,
    deep_groove_factors,
    equivalent_load,
    life_exponent,
    life_modification,
    life_time,
    mean_load,
    reference_viscosity,
    reliability_factor,
    static_equivalent_load,
    static_safety,
    taper_factors,
    taper_static_factors,
)
from gearwright.parts.losses import SeriesFriction

# ----------------------------------------------------------------------------------------------------------------------
# The lightest standard bearing that bears a duty, and what its margins are.
# ----------------------------------------------------------------------------------------------------------------------


_HOUR = 3600.0
_LEAST_LOAD = 0.98
"""P over F_r that no force along a bearing goes below [-]; X + Y e of ISO 281 is 0.99 at least."""


@dataclass(frozen=True)
class BearingDuty:
    """What a bearing has to bear, and for how long."""

    radial: Force
    """F_r, mean over the spectrum [N]."""
    axial: Force
    """F_a, mean over the spectrum [N]."""
    speed: Speed
    """Of the inner ring against the outer one [rad/s]."""
    life: Time
    """Wanted basic rating life L_10h [s]."""
    static_safety: Ratio = 1.5
    """Wanted s_0 at the limit load [-]."""
    limit_factor: Ratio = 1.0
    """Limit load over mean load [-]."""

    def __post_init__(self) -> None:
        """Refuse what no bearing can be asked."""
        problems = []
        if self.radial < 0.0:
            problems.append(Problem("radial", f"{self.radial:g} N given; allowed: 0 or more"))
        for name, value in {"life": self.life, "static_safety": self.static_safety}.items():
            if value <= 0.0:
                problems.append(Problem(name, f"{value:g} given; allowed: above 0"))
        if not (self.radial or self.axial):
            problems.append(Problem("radial", "nothing loads the bearing; give a radial or an axial force"))
        refuse(problems)


@dataclass(frozen=True)
class BearingSpectrum:
    """What a bearing has to bear in every load case, and for which share of its life."""

    radial: tuple[Force, ...]
    """F_r of every case [N]."""
    axial: tuple[Force, ...]
    """F_a of every case [N]."""
    speed: tuple[Speed, ...]
    """Of the inner ring against the outer one in every case [rad/s]."""
    share: tuple[Ratio, ...]
    """Of the life that every case lasts [-]; with 0 it counts for the static safety alone."""
    life: Time
    """Wanted basic rating life L_10h [s]."""
    static_safety: Ratio = 1.5
    """Wanted s_0 at the limit load [-]."""
    mean_factor: Ratio = 1.0
    """Mean over stated load, for the life [-]."""
    limit_factor: Ratio = 1.0
    """Limit over stated load, for the static safety [-]."""
    viscosity: tuple[float, ...] | None = None
    """ν of the oil in every case, where it is as warm as it runs [m²/s]; None: that of its oil in all."""

    @cached_property
    def turns(self) -> tuple[Speed, ...]:
        """Part of the mean speed that every case makes [rad/s]."""
        return tuple([abs(speed) * share for speed, share in zip(self.speed, self.share, strict=True)])

    @cached_property
    def mean_speed(self) -> Speed:
        """Over the life [rad/s]."""
        return sum(self.turns)

    @cached_property
    def forces(self) -> tuple[tuple[Force, Force], ...]:
        """F_r and F_a of every case [N]."""
        return tuple(zip(self.radial, self.axial, strict=True))


Duty = BearingDuty | BearingSpectrum


@dataclass(frozen=True)
class BearingCheck:
    """A bearing under a duty."""

    bearing: Bearing
    """Which one."""
    equivalent_load: Annotated[float, Quantity("force"), Origin("P = X F_r + Y F_a", "ISO 281:2007, 5.2 and 7.2")]
    """P [N]."""
    life: Annotated[float, Quantity("time"), Origin("L_10h = (C/P)^p 10⁶/(60 n)", "ISO 281:2007, 5.3 and 7.3")]
    """Basic rating life [s]."""
    static_safety: Annotated[float, Quantity("ratio"), Origin("s_0 = C_0/P_0", "ISO 76:2006, clause 9")]
    """At the limit load [-]."""
    life_margin: Annotated[float, Quantity("ratio"), Origin("L_10h / wanted", "ISO 281:2007")]
    """Life over the wanted one [-]."""
    static_margin: Annotated[float, Quantity("ratio"), Origin("s_0 / wanted", "ISO 76:2006")]
    """Static safety over the wanted one [-]."""


def check_bearing(bearing: Bearing, duty: Duty) -> BearingCheck:
    """Return life and static safety of a bearing under a duty.

    Args:
        bearing: From the catalogue.
        duty: Loads, speed and wanted life.

    Raises:
        DesignError: If the bearing cannot bear the kind of load.
    """
    spectrum = duty if isinstance(duty, BearingSpectrum) else _steady(duty)
    known = {force: equivalent_loads(bearing, *force) for force in dict.fromkeys(spectrum.forces)}  # of a case and of
    loads = [known[force] for force in spectrum.forces]  # its levels, often the same
    load = spectrum.mean_factor * _mean(bearing, [dynamic for dynamic, _ in loads], spectrum)
    static = spectrum.limit_factor * max([at_rest for _, at_rest in loads])
    life = life_time(basic_life(bearing.dynamic_rating, load, bearing.kind), spectrum.mean_speed) if load else math.inf
    safety = static_safety(bearing.static_rating, static) if static else math.inf
    return BearingCheck(bearing, load, life, safety, life / spectrum.life, safety / spectrum.static_safety)


def least_ratings(kind: BearingKind, spectrum: BearingSpectrum) -> tuple[float, float]:
    """Return C and C_0 below which no bearing of a kind bears even the forces across it [N].

    Args:
        kind: Of bearing [-].
        spectrum: Loads, speeds and wanted life.

    Source: ISO 281:2007, 5.3 and 7.3, solved for C with P = 0.98 F_r; ISO 76:2006, P_0 ≥ F_r.
    """
    exponent, static = life_exponent(kind), spectrum.static_safety * spectrum.limit_factor * max(spectrum.radial)
    if not any(spectrum.turns):
        return 0.0, (1.0 - 1e-9) * static
    load = _LEAST_LOAD * spectrum.mean_factor * mean_load(spectrum.radial, spectrum.turns, exponent)
    turned = spectrum.life / life_time(1.0, spectrum.mean_speed)
    return load * math.pow(turned, 1.0 / exponent), (1.0 - 1e-9) * static


def _steady(duty: BearingDuty) -> BearingSpectrum:
    return BearingSpectrum(
        (duty.radial,),
        (duty.axial,),
        (duty.speed,),
        (1.0,),
        duty.life,
        duty.static_safety,
        limit_factor=duty.limit_factor,
    )


def _mean(bearing: Bearing, loads: list[float], spectrum: BearingSpectrum) -> float:
    """Return the load that tires a bearing as all cases do; none where it does not turn."""
    turning = [load for load, turn in zip(loads, spectrum.turns, strict=True) if turn > 0.0]
    if len(turning) == 1:
        return turning[0]
    return mean_load(loads, spectrum.turns, life_exponent(bearing.kind)) if any(spectrum.turns) else 0.0


def equivalent_loads(bearing: Bearing, radial: float, axial: float) -> tuple[float, float]:
    """Return the dynamic and the static equivalent load of a bearing, P and P_0 [N].

    Args:
        bearing: From the catalogue.
        radial: F_r [N].
        axial: F_a, its sign does not count [N].

    Raises:
        DesignError: If the bearing cannot bear the kind of load.
    """
    axial, inside = abs(axial), bearing.geometry
    if inside.kind is BearingKind.CYLINDRICAL:
        if axial:
            message = f"{axial:.4g} N along the shaft; an NU bearing bears none: give it to a ball or taper bearing"
            raise DesignError([Problem(bearing.designation, message)])
        return radial, radial
    if inside.kind is BearingKind.DEEP_GROOVE:
        factors = deep_groove_factors(_static_factor(inside) * axial / bearing.static_rating)
        static = DEEP_GROOVE_STATIC
    elif inside.kind is BearingKind.FOUR_POINT:
        factors, static = FOUR_POINT, FOUR_POINT_STATIC
    else:
        factors, static = _taper(inside.contact_angle)
    return equivalent_load(radial, axial, factors), static_equivalent_load(radial, axial, static)


@cache
def _static_factor(inside: BearingGeometry) -> float:
    """Return f_0 of a bearing of the catalogue, once."""
    return ball_static_factor(inside)


@cache
def _taper(contact_angle: float) -> tuple[LoadFactors, StaticFactors]:
    """Return the factors of taper bearings of the catalogue, once for each contact angle."""
    return taper_factors(contact_angle), taper_static_factors(contact_angle)


def fitting_bearings(
    kind: BearingKind,
    duty: Duty,
    *,
    bore: Length,
    largest_bore: Length = math.inf,
    largest_outer: Length = math.inf,
) -> tuple[BearingCheck, ...]:
    """Return every bearing of a kind that fits, the lightest first, whether it bears the duty or not.

    Args:
        kind: Of bearing.
        duty: Loads, speed and wanted life.
        bore: Smallest bore, the diameter of the shaft [m].
        largest_bore: Of the shaft's shoulder, or none [m].
        largest_outer: Room in the housing, or none [m].

    Raises:
        DesignError: If no size has that bore; the nearest is named.
    """
    fitting = [
        bearing
        for bearing in bearings().values()
        if bearing.kind is kind
        and bore - 1e-9 <= bearing.bore <= largest_bore + 1e-9
        and bearing.outer_diameter <= largest_outer + 1e-9
    ]
    if not fitting:
        raise DesignError([Problem("bore", _no_bore(kind, bore))])
    return tuple(sorted((check_bearing(bearing, duty) for bearing in fitting), key=lambda check: check.bearing.mass))


def bore_around(kind: BearingKind, diameter: Length) -> Length:
    """Return the bore of bearings of a kind around a shaft: its diameter, or the next that the catalogue has [m].

    Args:
        kind: Of bearing.
        diameter: Of the shaft at its seat [m].

    Raises:
        DesignError: No bore is as large; the nearest is named.
    """
    bores = [bearing.bore for bearing in bearings().values() if bearing.kind is kind]
    around = [bore for bore in bores if bore >= diameter - 1e-9]
    if not around:
        raise DesignError([Problem("bore", _no_bore(kind, diameter))])
    return min(around)


def _no_bore(kind: BearingKind, bore: float) -> str:
    bores = sorted({bearing.bore for bearing in bearings().values() if bearing.kind is kind})
    closest = min(bores, key=lambda size: abs(size - bore))
    return (
        f"no {kind} bearing for {1e3 * bore:.4g} mm within the room given; the catalogue has {1e3 * bores[0]:g} to "
        f"{1e3 * bores[-1]:g} mm, the nearest {1e3 * closest:g} mm"
    )


# ----------------------------------------------------------------------------------------------------------------------
# What a rolling bearing weighs before one is chosen: by the load that it must bear, and by the shaft that it holds.
# ----------------------------------------------------------------------------------------------------------------------


SIMILARITY = "similarity through the catalogue's cylindrical roller bearings (ISO 15, ISO 281)"
_LIGHT = 0.25
"""Share of those sizes that are the lightest around their shaft [-]."""
_SIMILAR, _BORES = ("NU 2", "NU 22", "NU 3", "NU 23"), (0.03, 0.15)
"""Series and bores [m] between which similarity holds: beyond, cages are of brass, and NU 10 is of another make."""


class Similar(NamedTuple):
    """How the mass of similar bearings grows."""

    by_load: float
    """C/m^(2/3) [N/kg^(2/3)]: at equal stress ratings grow as areas and masses as volumes."""
    by_bore: float
    """m/d³ of light series [kg/m³]."""


@cache
def similar() -> Similar:
    """Return the geometric means over the catalogue's cylindrical roller bearings of usual series and bores."""
    of_series = (size for size in bearings().values() if size.designation[:-2] in _SIMILAR)
    rollers = [size for size in of_series if _BORES[0] <= size.bore <= _BORES[1]]
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


# ----------------------------------------------------------------------------------------------------------------------
# What oil does to the bearings of the catalogue: their modified life, and what a series loses.
# ----------------------------------------------------------------------------------------------------------------------


USUAL_RELIABILITY = 0.9
"""Of a basic rating life [-]; ISO 281."""


@dataclass(frozen=True)
class BearingOil:
    """The oil in bearings, at their temperature."""

    viscosity: float
    """Kinematic viscosity ν [m²/s]."""
    dirt: Cleanliness | OilFilter = Cleanliness.NORMAL
    """How clean it is."""
    reliability: Ratio = USUAL_RELIABILITY
    """Part of the bearings that reach the life [-]."""


@dataclass(frozen=True)
class ModifiedLife:
    """Life of a bearing with its oil."""

    life: Time
    """L_nmh over the spectrum [s]."""
    factor: Ratio
    """Over the basic rating life: a_1 a_ISO, of a spectrum as it makes of them together [-]."""
    viscosity_ratio: Ratio
    """κ = ν/ν_1, the least of all levels that turn [-]."""
    contamination: Ratio
    """e_C, the least of all levels that turn [-]."""


class _Level(NamedTuple):
    """One level of a spectrum."""

    share: float
    basic: float
    """L_10h [s]."""
    modified: float
    """L_nmh [s]."""
    viscosity_ratio: float
    contamination: float


def modified_life(bearing: Bearing, spectrum: BearingSpectrum, oil: BearingOil) -> ModifiedLife | None:
    """Return the modified rating life of a bearing; None where nothing loads it while it turns.

    Args:
        bearing: From the catalogue.
        spectrum: What it bears.
        oil: In it.

    Source: ISO 281:2007, 9.3: L_nm = a_1 a_ISO L_10 at every level, and Palmgren's linear damage over them.

    Raises:
        DesignError: The oil is too thin for the standard (κ < 0.1), or the bearing cannot bear its kind of load.
    """
    levels = [
        _level(bearing, spectrum, k, oil) for k, share in enumerate(spectrum.share) if share and spectrum.speed[k]
    ]
    loaded = [level for level in levels if level is not None]
    if not loaded:
        return None
    damage = sum(level.share / level.modified for level in loaded)
    basic = sum(level.share / level.basic for level in loaded)
    kappa, dirt = min(level.viscosity_ratio for level in loaded), min(level.contamination for level in loaded)
    return ModifiedLife(1.0 / damage, basic / damage, kappa, dirt)


def _level(bearing: Bearing, spectrum: BearingSpectrum, k: int, oil: BearingOil) -> _Level | None:
    """Return what one level of a spectrum does; None where it loads nothing."""
    speed, pitch = spectrum.speed[k], bearing.geometry.pitch_diameter
    load = spectrum.mean_factor * equivalent_loads(bearing, spectrum.radial[k], spectrum.axial[k])[0]
    if not load:
        return None
    thick = oil.viscosity if spectrum.viscosity is None else spectrum.viscosity[k]
    kappa = thick / reference_viscosity(speed, pitch)
    dirt = (
        contamination_factor(oil.dirt, kappa, pitch)
        if isinstance(oil.dirt, OilFilter)
        else cleanliness_factor(oil.dirt, pitch)
    )
    factor = life_modification(dirt * bearing.fatigue_limit / load, kappa, bearing.kind)
    basic = life_time(basic_life(bearing.dynamic_rating, load, bearing.kind), speed)
    return _Level(spectrum.share[k], basic, reliability_factor(oil.reliability) * factor * basic, kappa, dirt)


def bearing_friction(bearing: Bearing) -> SeriesFriction:
    """Return what makers' catalogues and ISO 15312 say of the friction of a bearing's series.

    Args:
        bearing: From the catalogue.
    """
    return _series_friction()[_series_of(bearing.designation)]


def _series_of(designation: str) -> str:
    """Return the longest series with which a designation begins."""
    return max((name for name in _series_friction() if designation.startswith(name)), key=len)


@cache
def _series_friction() -> Mapping[str, SeriesFriction]:
    return MappingProxyType(
        {
            row["series"]: SeriesFriction(
                float(row["oil_factor"]),
                float(row["load_factor"]),
                (float(row["rolling_1"]), float(row["rolling_2"]), float(row["rolling_3"])),
                (float(row["sliding_1"]), float(row["sliding_2"]), float(row["sliding_3"])),
            )
            for row in data_rows("bearing_friction.csv")
        }
    )
