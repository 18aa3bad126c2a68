"""Table of a measured duty: its classes of torque."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.mission import DutySpectrum
from gearwright.render.grid.table import Table, table
from gearwright.units import Origin, Quantity, Ratio, Speed, Time, Torque

RULE = (
    "Classes of equal width from 0 to the largest torque, without sign; each counts with its upper end"
    " (ISO 6336-6), and empty ones are left out"
)
"""How a duty is counted."""


@dataclass(frozen=True)
class DutyClass:
    """One class of a measured duty."""

    number: int
    torque: Torque
    """Its upper end, without sign."""
    speed: Speed
    """Mean over its time, without sign."""
    time: Time
    share: Annotated[Ratio, Origin("t_i/Σ t", "time at level")]
    """Of the time."""
    turns: Annotated[float, Quantity("number"), Origin("n_i t_i", "revolutions")]
    """Revolutions of the shaft."""


def duty_classes(spectrum: DutySpectrum) -> Iterator[DutyClass]:
    """Yield the classes of a duty, the smallest torque first.

    Args:
        spectrum: As counted.
    """
    for k, (torque, speed, share) in enumerate(zip(spectrum.torque, spectrum.speed, spectrum.share, strict=True), 1):
        time = float(share) * spectrum.time
        yield DutyClass(k, float(torque), float(speed), time, float(share), float(speed) * time / (2.0 * math.pi))


def duty_table(spectrum: DutySpectrum) -> Table:
    """Return the classes of a duty.

    Args:
        spectrum: As counted.
    """
    rows = list(duty_classes(spectrum))
    return table("Measured duty", rows, ("number", "torque", "speed", "time", "share", "turns"), note=f"{RULE}.")
