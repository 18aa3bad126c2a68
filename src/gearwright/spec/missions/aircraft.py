"""The aircraft of a mission: a point mass with a drag polar, flaps, wheels and fuel."""

from __future__ import annotations

import math
from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Area, Length, Mass, Ratio, Time

Setting = Literal["clean", "take-off", "landing"]
"""Of flaps and gear."""
PhaseKind = Literal[
    "taxi", "take-off", "climb", "speed-change", "cruise", "descent", "approach", "landing", "hold"
]  # fmt: skip
"""What an aircraft does in a phase."""
GROUND_KINDS = ("taxi", "take-off", "landing")
"""Kinds that begin on the wheels."""


class Flaps(Record):
    """Flaps and landing gear of one setting."""

    highest_lift: float = Field(gt=0, le=6, description="C_L at the stall")
    extra_drag: Ratio = Field(0.0, ge=0, le=1, description="C_D0 beyond that of the clean aircraft, with gear")


class Aircraft(Record):
    """The aircraft, where phases ask for the thrust that flight needs, or fly with the thrust that they are given."""

    mass: Mass = Field(gt=0, le=1e6, description="At the start")
    wing_area: Area = Field(gt=0, le=1e4, description="Reference area S")
    zero_lift_drag: Ratio = Field(gt=0, le=1, description="C_D0")
    induced_drag: Ratio | None = Field(
        None, ge=0, le=1, description="k of C_D = C_D0 + k C_L²; or aspect_ratio and oswald: k = 1/(π A e)"
    )
    aspect_ratio: float | None = Field(None, gt=0.5, le=60, description="A = b²/S")
    oswald: Ratio | None = Field(None, gt=0.2, le=1.2, description="e")
    highest_lift: float | None = Field(
        None, gt=0, le=6, description="C_L at the stall, clean; left out: not looked at but for lift that no wing has"
    )
    take_off: Flaps | None = Field(None, description="Flaps and gear in take-off; left out: clean")
    landing: Flaps | None = Field(None, description="Flaps and gear in approach and landing; left out: clean")
    roll_lift: float = Field(0.3, ge=0, le=6, description="C_L while it rolls on its wheels; an assumption")
    rolling_friction: Ratio = Field(0.02, ge=0, le=0.5, description="μ of wheels that roll; an assumption")
    braking_friction: Ratio = Field(0.3, ge=0, le=1, description="μ of wheels that brake; an assumption")
    rotation_over_stall: float = Field(
        1.1, ge=1, le=2, description="Speed of rotation over that of the stall, where a take-off names none"
    )
    rotation: Time = Field(2.0, ge=0.1, le=10, description="From rotation until the wheels carry nothing")
    fuel: Mass | None = Field(None, gt=0, le=1e6, description="Fuel on board, part of the mass; left out: any")
    ceiling: Length | None = Field(None, gt=0, le=20e3, description="Highest altitude; left out: that of the map")

    @property
    def induced(self) -> float:
        """k of C_D = C_D0 + k C_L² [-]."""
        if self.induced_drag is not None:
            return self.induced_drag
        return 1.0 / (math.pi * (self.aspect_ratio or 1.0) * (self.oswald or 1.0))

    def flaps(self, setting: Setting) -> Flaps | None:
        """Return flaps and gear of a setting; None where the aircraft says nothing of them.

        Args:
            setting: Of them.
        """
        named = {"take-off": self.take_off, "landing": self.landing}.get(setting)
        if named is not None or self.highest_lift is None:
            return named
        return Flaps(highest_lift=self.highest_lift)
