"""What oil does to the bearings of the catalogue: their modified life, and what a series loses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from gearwright.catalogue.bearing_choice import BearingSpectrum, equivalent_loads
from gearwright.catalogue.bearings import Bearing
from gearwright.catalogue.tables import data_rows
from gearwright.parts.bearings import (
    Cleanliness,
    OilFilter,
    basic_life,
    cleanliness_factor,
    contamination_factor,
    life_modification,
    life_time,
    reference_viscosity,
    reliability_factor,
)
from gearwright.parts.losses import SeriesFriction
from gearwright.units import Ratio, Time

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
