"""What a reader wants to know of a train's dynamics beside modes and forces, as tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.dynamics.assembly import Assumption
from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import SWING, CriticalSpeed, Response, RunUp, SpeedCase, loudest_speeds, peaks
from gearwright.render.grid.table import Table, table
from gearwright.units import Frequency, Origin, Quantity, Speed


@dataclass(frozen=True)
class Critical:
    """One critical speed, in words."""

    order: str
    mode: str
    frequency: Frequency
    """[Hz]"""
    speed: Speed
    """Of the first machine's shaft [rad/s]."""
    margin: Annotated[float, Quantity("percent"), Origin("n_crit/n − 1", "definition")]
    """[-]"""
    dynamic_force: Annotated[float, Quantity("percent"), Origin("q = φᵀf/(2 ζ ω²)", "first order, at resonance")]
    """Amplitude over mean [-]."""
    verdict: str


@dataclass(frozen=True)
class ByMachine:
    """One critical speed of an order that no line makes, in words."""

    order: str
    why: str
    mode: str
    frequency: Frequency
    """[Hz]"""
    speed: Speed
    """Of the first machine's shaft [rad/s]."""
    margin: Annotated[float, Quantity("percent"), Origin("n_crit/n − 1", "definition")]
    """[-]"""
    dynamic_force: Annotated[float, Quantity("percent"), Origin("q = φᵀf/(2 ζ ω²)", "first order, at resonance")]
    """Amplitude over mean, of an assumed swing [-]."""
    verdict: str


def critical_table(speeds: SpeedCase, *, maximum: int = 25) -> Table:
    """Return the critical speeds of one set of speeds, worst first.

    Args:
        speeds: From `critical_speeds`.
        maximum: Rows at most; what is not excited stands last.
    """
    rows = critical_rows(speeds.critical)
    note = (
        "n: critical speed of the first machine's shaft; f: damped frequency there. Margin: over the operating speed,"
        " less 1. Dynamic force: estimated amplitude of the worst mesh force at the resonance over its mean, from the"
        f" stiffness variation and errors of the design.{_left_out(len(rows), maximum)}"
    )
    fields = ("order", "mode", "frequency", "speed", "margin", "dynamic_force", "verdict")
    return table(f"Critical speeds, case {speeds.cases}", rows[:maximum], fields, note=note)


def machine_table(speeds: SpeedCase, *, maximum: int = 25) -> Table:
    """Return the critical speeds of blades, poles, slots, teeth and planets that pass, worst first.

    Args:
        speeds: From `critical_speeds`.
        maximum: Rows at most; what is not excited stands last.
    """
    rows = machine_rows(speeds)
    note = (
        f"Nobody states how hard they shake: dynamic force is what follows if {100.0 * SWING:g} % of the mean torque of"
        " the machine, or of the force of one mesh, swings. In resonance: within 10 % (API 617)."
        f"{_left_out(len(rows), maximum)}"
    )
    fields = ("order", "why", "mode", "frequency", "speed", "margin", "dynamic_force", "verdict")
    return table(f"Orders of machines, teeth and planets, case {speeds.cases}", rows[:maximum], fields, note=note)


def _left_out(rows: int, maximum: int) -> str:
    """Return how many rows a table does not show, as the last sentence of its note."""
    return f" {rows - maximum} more are left out." if rows > maximum else ""


def machine_rows(speeds: SpeedCase) -> tuple[ByMachine, ...]:
    """Return the critical speeds of orders that no line makes in words, worst first.

    Args:
        speeds: From `critical_speeds`.
    """
    return tuple(ByMachine(critical.order, critical.why, *_met(critical)) for critical in speeds.assumed)


def critical_rows(critical_speeds: Sequence[CriticalSpeed]) -> tuple[Critical, ...]:
    """Return critical speeds in words, in their order.

    Args:
        critical_speeds: Of one set of speeds.
    """
    return tuple(Critical(critical.order, *_met(critical)) for critical in critical_speeds)


def _met(critical: CriticalSpeed) -> tuple[str, float, float, float, float, str]:
    """Return the mode that is met, its frequency, speed, margin and dynamic force, and the verdict."""
    force = critical.dynamic_force
    return critical.mode, critical.frequency, critical.speed, critical.margin, force, _verdict(critical)


def _verdict(critical: CriticalSpeed) -> str:
    if not critical.excited:
        return "not excited"
    return "in resonance" if critical.in_resonance else "clear"


def assumption_table(listed: Sequence[Assumption]) -> Table:
    """Return what the dynamic model rests on.

    Args:
        listed: From `assumptions`.
    """
    return table("Assumptions of the dynamic model", listed, ("subject", "value", "origin", "path"))


def peak_table(response: Response, lines: Sequence[str], *, maximum: int = 12) -> Table:
    """Return the highest peaks of a frequency response.

    Args:
        response: Of the train.
        lines: Whose forces count.
        maximum: Rows at most.
    """
    return table("Peaks", peaks(response, lines)[:maximum], ("line", "frequency", "force"))


def loudest_table(run_up: RunUp, speed: float) -> Table:
    """Return for each line the speed at which its force swings most, and the order that does it.

    Args:
        run_up: Speeds and spectra.
        speed: Operating speed of the first machine's shaft [rad/s].
    """
    worst = Error(float(np.max(run_up.error)), float(np.max(run_up.rms_error)))
    note = f"Steady running at each speed with the torques of the case; {worst.words()}, at the worst speed."
    note = " ".join([note, *(f"{less[0].upper()}{less[1:]}." for less in run_up.notes)])
    return table(
        "Loudest speeds", loudest_speeds(run_up, speed), ("line", "speed", "swing", "mean", "order"), note=note
    )
