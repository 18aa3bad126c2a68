"""A measured duty in words: what was read, its classes, and the lines for a design file."""

from __future__ import annotations

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.mission import DutySpectrum, MeasuredDuty
from gearwright.render.tables.duty import duty_table
from gearwright.render.words.text import table_text
from gearwright.units import CELSIUS, KWH, text


def duty_text(duty: MeasuredDuty, spectrum: DutySpectrum) -> RenderableType:
    """Return a measured duty for the terminal.

    Args:
        duty: As read.
        spectrum: Its classes.
    """
    lines = [summary(duty), *notes(duty)]
    return Group(*map(Text, lines), Text(), table_text(duty_table(spectrum)))


def summary(duty: MeasuredDuty) -> str:
    """Return how long a record is, and what it reaches.

    Args:
        duty: As read.
    """
    torque, speed = float(abs(duty.torque).max()), float(abs(duty.speed).max())
    return (
        f"{len(duty.time)} rows over {text(float(duty.duration.sum()), 'time')}; at most {text(torque, 'torque')} and"
        f" {text(speed, 'speed')}; work {work(duty) / KWH:.4g} kWh"
    )


def work(duty: MeasuredDuty) -> float:
    """Return the work of a record, that in its other direction taken off [J].

    Args:
        duty: As read.
    """
    return float((duty.power * duty.duration).sum())


def notes(duty: MeasuredDuty) -> list[str]:
    """Return what of a record is not used, or is used in a way that its reader must know.

    Args:
        duty: As read.
    """
    told = []
    if duty.temperature is not None:
        low, high = (float(value) - CELSIUS for value in (duty.temperature.min(), duty.temperature.max()))
        told.append(f"Temperatures, {low:.4g} to {high:.4g} °C, were read and are not used: a load spectrum has none")
    if (duty.torque < 0.0).any() and (duty.torque > 0.0).any():
        told.append("Torque changes its sign; both directions are counted together, as if on one flank of the teeth")
    return told
