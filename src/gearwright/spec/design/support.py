"""How a shaft is held where its motion on its bearings counts."""

from __future__ import annotations

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Mass, Ratio, Stiffness


class Support(Record):
    """Bearings of a shaft as springs to the housing; a shaft without this entry turns in rigid bearings."""

    radial: Stiffness = Field(gt=0, description="Stiffness in every direction across the shaft, all bearings together")
    axial: Stiffness | None = Field(None, gt=0, description="Stiffness along the shaft; left out: rigid")
    mass: Mass | None = Field(None, gt=0, description="What moves; left out: the shaft and its gears")
    damping: Ratio = Field(0.05, ge=0, lt=1, description="Damping ratio ζ of each direction")
