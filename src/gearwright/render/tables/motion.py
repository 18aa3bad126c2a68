"""What a reader wants to see of Modes and of a Trace, as tables."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.dynamics import Modes, Trace
from gearwright.render.grid.table import Table, table
from gearwright.units import Energy, Force, Frequency, Origin, Quantity, Torque

ALONG = "Mesh forces act along the line of action; F_t = F cos α_t."
"""What tells simulated mesh forces from the tangential ones of the sizing."""


@dataclass(frozen=True)
class Mode:
    """One natural frequency."""

    number: str
    """Of the mode, or of the first and last that share the frequency."""
    frequency: Frequency
    """[Hz]"""
    highest_kinetic_energy: str
    """Coordinate of the largest kinetic energy."""
    highest_strain_energy: str
    """Line of the largest share of the elastic energy."""
    energy: Annotated[float, Quantity("percent"), Origin("½ k δ² of the line over that of all", "K φ = ω² M φ")]
    """That line's share [-]."""


@dataclass(frozen=True)
class LineForce:
    """Force of one mesh or support over the time of the statistics."""

    name: str
    mean: Force
    """[N]"""
    minimum: Force
    """[N]"""
    maximum: Force
    """[N]"""
    rms: Force
    """[N]"""
    peak_to_peak: Force
    """[N]"""


@dataclass(frozen=True)
class LineTorque:
    """Torque of one shaft over the time of the statistics."""

    name: str
    mean: Torque
    """[N m]"""
    minimum: Torque
    """[N m]"""
    maximum: Torque
    """[N m]"""
    rms: Torque
    """[N m]"""
    peak_to_peak: Torque
    """[N m]"""


@dataclass(frozen=True)
class EnergyBook:
    """Where the energy of a run came from and went."""

    driven: Energy
    """[J]"""
    braked: Energy
    """[J]"""
    dissipated: Energy
    """[J]"""
    stored: Energy
    """[J]"""
    imbalance: float
    """[-]"""


def mode_table(modes: Modes, *, case: str = "", maximum: int = 30) -> Table:
    """Return natural frequencies with what moves and what is strained.

    Args:
        modes: As found.
        case: Load case, if they are of a design.
        maximum: Modes that are listed at most.
    """
    rows = mode_rows(modes)
    left = f" {len(rows) - maximum} higher ones are left out." if len(rows) > maximum else ""
    note = f"{modes.rigid} rigid. Undamped, at the mean stiffness.{left}"
    fields = ("number", "frequency", "highest_kinetic_energy", "highest_strain_energy", "energy")
    return table(f"Natural frequencies{f', case {case}' if case else ''}", rows[:maximum], fields, note=note)


def mode_rows(modes: Modes) -> list[Mode]:
    """Return a row for every natural frequency, the lowest first.

    Args:
        modes: As found.
    """
    rows, first = [], 0
    for frequency, count in modes.groups():
        rows.append(_mode(modes, frequency, first, count))
        first += count
    return rows


def _mode(modes: Modes, frequency: float, first: int, count: int) -> Mode:
    number = str(first + 1) if count == 1 else f"{first + 1}–{first + count}"
    strain = np.mean(modes.line_energy[:, first : first + count], axis=1)
    if frequency == 0.0:
        return Mode(number, frequency, "rigid", "none", 0.0)
    motion = np.sum(modes.shapes[:, first : first + count] ** 2, axis=1)
    holds = int(np.argmax(strain))
    moves = modes.labels.coordinates[int(np.argmax(motion))]
    return Mode(number, frequency, moves, modes.labels.lines[holds], float(strain[holds]))


def motion_tables(trace: Trace) -> tuple[Table, ...]:
    """Return the statistics of forces and of torques, over all bins together; nothing where there are none.

    Args:
        trace: As simulated.
    """
    if not trace.force.bins:
        return ()
    fields = ("name", "mean", "minimum", "maximum", "rms", "peak_to_peak")
    span = f"From every step between {trace.force.edges[0]:.4g} and {trace.force.edges[-1]:.4g} s."
    tables = (
        table("Forces", line_forces(trace), fields, note=f"{span} {ALONG}"),
        table("Shaft torques", line_torques(trace), fields, note=span),
    )
    return tuple(listed for listed in tables if listed.rows)


def line_forces(trace: Trace) -> tuple[LineForce, ...]:
    """Return the statistics of every mesh and support over all bins together; none where there are no bins.

    Args:
        trace: As simulated.
    """
    return tuple(LineForce(*statistics) for statistics in _statistics(trace, "m"))


def line_torques(trace: Trace) -> tuple[LineTorque, ...]:
    """Return the statistics of every shaft over all bins together; none where there are no bins.

    Args:
        trace: As simulated.
    """
    return tuple(LineTorque(*statistics) for statistics in _statistics(trace, "rad"))


def _statistics(trace: Trace, deflects_in: str) -> Iterator[tuple[str, float, float, float, float, float]]:
    """Yield name, mean, minimum, maximum, rms and peak-to-peak of the lines that deflect in m or in rad."""
    for name, unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if unit == deflects_in and trace.force.bins:
            mean, minimum, maximum, rms = trace.force.whole(name)
            yield name, mean, minimum, maximum, rms, maximum - minimum


def energy_table(trace: Trace) -> Table:
    """Return the energy balance of a run.

    Args:
        trace: As simulated.
    """
    return table("Energy", [energy_book(trace)], ("driven", "braked", "dissipated", "stored", "imbalance"))


def energy_book(trace: Trace) -> EnergyBook:
    """Return where the energy of a run came from and went.

    Args:
        trace: As simulated.
    """
    work = trace.work
    return EnergyBook(work.driven, work.braked, work.dissipated, work.stored, work.imbalance)
