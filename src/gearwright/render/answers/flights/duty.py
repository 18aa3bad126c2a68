"""Answer about a measured duty: its classes, and the lines for a design file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.mission import DutySpectrum, MeasuredDuty
from gearwright.mission.lives import torque_cycles
from gearwright.parts.shafts import Residue
from gearwright.render.tables.duty import RESIDUES, RULE, DutyClass, TorqueCycle, cycle_rows, duty_classes
from gearwright.render.words.flights.duty import notes, work
from gearwright.units import Quantity, Speed, Time, Torque


@dataclass(frozen=True)
class DutyAnswer:
    """A measured duty as a load spectrum."""

    rows_read: int
    """Of the file, without the last, which only ends the one before."""
    duration: Time
    largest_torque: Torque
    """Without sign."""
    mean_speed: Speed
    """Over the whole time, without sign."""
    work: Annotated[float, Quantity("electric_energy")]
    """That in the other direction taken off."""
    lowest_temperature: Annotated[float | None, Quantity("absolute_temperature")]
    """Null where none was measured; temperatures are not used."""
    highest_temperature: Annotated[float | None, Quantity("absolute_temperature")]
    rule: str
    """How classes are counted."""
    classes: tuple[DutyClass, ...]
    """The smallest torque first."""
    text: str
    """Load case and spectrum as a design file has them; shares are parts of the revolutions."""
    notes: tuple[str, ...]
    residue: str | None
    """Rule by which cycles were counted; null where none were asked for."""
    cycles: tuple[TorqueCycle, ...]
    """Of torque, by rainflow, the largest range first; empty where none were asked for."""


def duty_answer(duty: MeasuredDuty, spectrum: DutySpectrum, text: str, residue: Residue | None = None) -> DutyAnswer:
    """Return what `gearwright duty --json` answers.

    Args:
        duty: As read.
        spectrum: Its classes.
        text: Lines for a design file.
        residue: Rule by which cycles of torque are counted; None: they are not.
    """
    temperature = duty.temperature
    return DutyAnswer(
        rows_read=len(duty.time),
        duration=spectrum.time,
        largest_torque=float(abs(duty.torque).max()),
        mean_speed=float((spectrum.speed * spectrum.share).sum()),
        work=work(duty),
        lowest_temperature=None if temperature is None else float(temperature.min()),
        highest_temperature=None if temperature is None else float(temperature.max()),
        rule=RULE,
        classes=tuple(duty_classes(spectrum)),
        text=text,
        notes=tuple(notes(duty)),
        residue=residue and RESIDUES[residue],
        cycles=() if residue is None else cycle_rows(torque_cycles(duty, residue=residue)),
    )
