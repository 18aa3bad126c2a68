"""What a planet turns on."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Force


class PlanetBearing(Record):
    """The rolling bearing between a planet and its pin."""

    designation: str = Field(description="Name in the catalogue, such as NU 2212")
    side_by_side: int = Field(1, ge=1, le=4, description="Equal bearings that share a pin")
    dynamic_rating: Force | None = Field(None, gt=0, description="Maker's C, instead of the catalogue's")
    static_rating: Force | None = Field(None, gt=0, description="Maker's C_0, instead of the catalogue's")
