"""Bands of frequencies at which teeth shall not pass: a wish of the search, and a check of every design."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Frequency


class ForbiddenBand(Record):
    """Frequencies at which no teeth, or no planets, may pass in some load cases."""

    lowest: Frequency = Field(0.0, ge=0, description="Lower end of the band; at its ends a frequency is allowed")
    highest: Frequency = Field(gt=0, description="Upper end of the band")
    of: Literal["mesh", "planet-pass"] = Field(
        "mesh",
        description="mesh: how often teeth mesh, z |ω − ω_c|/2π of every pair and set; planet-pass: how often planets"
        " pass a tooth of their ring, N |ω_c − ω_r|/2π",
    )
    harmonics: int = Field(1, ge=1, le=20, description="Multiples of it that stay out, itself included")
    cases: list[str] | None = Field(
        None, description="Load cases in which it holds; left out: all that are not static, or rated without any"
    )
    reason: str = Field("", description="What would be shaken")
