"""By whose formulas power is lost: teeth, bearings, windage, seals."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Length, Ratio

FrictionName = Literal["schlenk", "niemann-winter", "iso-tr-14179-1", "anderson-loewenthal"]
"""Whose friction of teeth; Schlenk's is that of ISO/TR 14179-2."""
TorqueName = Literal["constant", "palmgren", "skf"]
"""Whose friction of bearings."""
WindageName = Literal["anderson-loewenthal", "dawson"]
"""Whose windage of gears."""
SealName = Literal["none", "iso-tr-14179-1", "iso-tr-14179-2", "simrit"]
"""Whose friction of seals."""


class LossRules(Record):
    """By whose formulas power is lost; a mission takes them where its [oil] says nothing else."""

    friction: FrictionName = Field(
        "schlenk",
        description="Friction of the teeth: Schlenk (ISO/TR 14179-2), Niemann and Winter, ISO/TR 14179-1, or Anderson"
        " and Loewenthal",
    )
    lubricant_factor: Ratio = Field(
        1.0,
        gt=0,
        le=2,
        description="X_L of Schlenk, Niemann and Winter; left out: that of the stage's oil_type, 1 for mineral oils",
    )
    roughness: Length = Field(
        0.4e-6,
        ge=1e-8,
        le=1e-4,
        description="R_a of the flanks; left out: by the flank_roughness of the stage's rating where that is given",
    )
    bearings: TorqueName = Field(
        "constant",
        description="Friction of bearings: μ = 0.0011, Palmgren's two parts, or SKF's model; without a bearing's size"
        " μ = 0.0011",
    )
    windage: WindageName = Field("anderson-loewenthal", description="Windage of gears: in oil mist, or in air (Dawson)")
    enclosure: Ratio = Field(1.0, gt=0, le=1, description="λ of Dawson: 1 in the open, 0.6 to 0.7 in a housing")
    seals: SealName = Field("none", description="One shaft seal at each machine, and whose formula")
    dip: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Gear -> part of it that dips into an oil bath, 0 to 1: it churns; left out: a dry sump",
    )
