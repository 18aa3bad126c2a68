"""A measured duty in words: what was read, its classes, and the lines for a design file."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.mission import DutySpectrum, MeasuredDuty
from gearwright.mission.lives import torque_cycles
from gearwright.parts.shafts import LoadCycle, Residue
from gearwright.render.tables.duty import cycle_table, duty_table
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


def cycles_text(duty: MeasuredDuty, residue: Residue) -> RenderableType:
    """Return the cycles of torque of a duty for the terminal, and what a shaft needs for the largest of them.

    Args:
        duty: As read.
        residue: Rule of what closes no loop.
    """
    cycles = torque_cycles(duty, residue=residue)
    return Group(table_text(cycle_table(cycles, residue)), Text(swing_words(cycles)))


def swing_words(cycles: Sequence[LoadCycle]) -> str:
    """Return which swing of the torque a shaft must bear so that it bears every cycle.

    Args:
        cycles: As counted.
    """
    swings = [cycle.range / 2.0 / abs(cycle.mean) if cycle.mean else math.inf for cycle in cycles]
    largest = max(swings, default=0.0)
    if largest <= 1.0:
        return f"For shafts: torque_swing = {largest:.4g} in [service], alternating over mean torque of the worst cycle"
    return "For shafts: torque reverses within a cycle; torque_swing = 1, the most that [service] has, is less"


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
