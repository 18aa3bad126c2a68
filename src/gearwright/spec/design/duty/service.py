"""What a transmission must live through."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Ratio, Time

_HOUR = 3600.0


class Service(Record):
    """The life that is asked, and the loads in it."""

    life: Time = Field(3500 * _HOUR, gt=0, description="Life of gears")
    bearing_life: Time = Field(5000 * _HOUR, gt=0, description="Minimum basic rating life L_10h of each bearing")
    application_factor: Ratio = Field(1.25, ge=1, le=5, description="K_A: what the outside adds to the nominal load")
    shares: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Share of the life that each case lasts, with sum 1; left out: all of it at rated power",
    )
    spectrum: str | None = Field(
        None, description="Load spectrum of every case that lasts and names none, [spectra.NAME]; left out: none"
    )
    mean_load: Ratio = Field(
        1.0,
        gt=0,
        le=1,
        description="Cubic mean load over the rated one, for bearings; with shares or a spectrum it follows from them",
    )
    static_safety: Ratio = Field(1.5, ge=0.5, le=5, description="Minimum static safety s_0 of bearings (ISO 76)")
    shaft_fatigue_safety: Ratio = Field(1.5, ge=1, le=5, description="Minimum safety of shafts against fatigue")
    shaft_yield_safety: Ratio = Field(1.5, ge=1, le=5, description="Minimum safety of shafts against yield")
    torque_swing: Ratio = Field(0.15, ge=0, le=1, description="Alternating part of the torque over its mean")
