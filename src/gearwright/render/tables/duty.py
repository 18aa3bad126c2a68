"""Table of a measured duty: its classes of torque."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated

from gearwright.mission import DutySpectrum
from gearwright.parts.shafts import LoadCycle, Residue
from gearwright.render.grid.table import Table, table
from gearwright.units import Origin, Quantity, Ratio, Speed, Time, Torque

RULE = (
    "Classes of equal width from 0 to the largest torque, without sign; each counts with its upper end"
    " (ISO 6336-6), and empty ones are left out"
)
"""How a duty is counted."""
MOST_ROWS = 20
"""Cycles that are shown on the screen [-]."""
RESIDUES: Mapping[Residue, str] = MappingProxyType({
    "half-cycles": "Rainflow by ASTM E1049-85, 5.4.4: each range of what closes no loop is half a cycle",
    "repeated": "Rainflow by ASTM E1049-85, 5.4.5: the record repeats, from its largest torque on",
})  # fmt: skip
"""Rule of the residue -> in words."""


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


@dataclass(frozen=True)
class TorqueCycle:
    """Cycles of torque of one size."""

    range: Torque
    """From the smallest to the largest torque of the cycle."""
    mean: Torque
    """Half of both."""
    cycles: Annotated[float, Quantity("number"), Origin("rainflow", "ASTM E1049-85")]
    """Half ones count as 0.5."""


def cycle_rows(cycles: Iterable[LoadCycle]) -> tuple[TorqueCycle, ...]:
    """Return cycles of torque as rows, the largest range first.

    Args:
        cycles: As counted.
    """
    return tuple(TorqueCycle(float(cycle.range), float(cycle.mean), cycle.count) for cycle in cycles)


def cycle_table(cycles: Iterable[LoadCycle], residue: Residue) -> Table:
    """Return the largest cycles of torque of a duty.

    Args:
        cycles: As counted.
        residue: By which rule.
    """
    rows = cycle_rows(cycles)
    more = f" {len(rows) - MOST_ROWS} smaller ones are not shown." if len(rows) > MOST_ROWS else ""
    return table("Cycles of torque", rows[:MOST_ROWS], ("range", "mean", "cycles"), note=f"{RESIDUES[residue]}.{more}")


def duty_table(spectrum: DutySpectrum) -> Table:
    """Return the classes of a duty.

    Args:
        spectrum: As counted.
    """
    rows = list(duty_classes(spectrum))
    return table("Measured duty", rows, ("number", "torque", "speed", "time", "share", "turns"), note=f"{RULE}.")
