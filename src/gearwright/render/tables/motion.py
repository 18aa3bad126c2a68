"""What a reader wants to see of Modes and of a Trace, as tables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from gearwright.dynamics import Modes, Trace
from gearwright.render.tables.tables import Table, table
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
    moves_most: str
    """Coordinate of the largest kinetic energy."""
    holds_most: str
    """Line of the largest share of the elastic energy."""
    energy: Annotated[float, Quantity("percent"), Origin("½ k δ² of the line over that of all", "K φ = ω² M φ")]
    """That line's share [-]."""


@dataclass(frozen=True)
class LineForce:
    """Force of one mesh or support over the time of the statistics."""

    name: str
    mean: Force
    """[N]"""
    least: Force
    """[N]"""
    most: Force
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
    least: Torque
    """[N m]"""
    most: Torque
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


def mode_table(modes: Modes, *, most: int = 30) -> Table:
    """Return natural frequencies with what moves and what is strained.

    Args:
        modes: As found.
        most: Modes that are listed at most.
    """
    rows, first = [], 0
    for frequency, count in modes.groups():
        rows.append(_mode(modes, frequency, first, count))
        first += count
    left = f" {len(rows) - most} higher ones are left out." if len(rows) > most else ""
    note = f"{modes.rigid} rigid. Undamped, at the mean stiffness.{left}"
    fields = ("number", "frequency", "moves_most", "holds_most", "energy")
    return table("Natural frequencies", rows[:most], fields, note=note)


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
    forces, torques = [], []
    for name, unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        mean, least, most, rms = trace.force.whole(name)
        if unit == "m":
            forces.append(LineForce(name, mean, least, most, rms, most - least))
        else:
            torques.append(LineTorque(name, mean, least, most, rms, most - least))
    fields = ("name", "mean", "least", "most", "rms", "peak_to_peak")
    span = f"From every step between {trace.force.edges[0]:.4g} and {trace.force.edges[-1]:.4g} s."
    tables = (
        table("Forces", forces, fields, note=f"{span} {ALONG}"),
        table("Shaft torques", torques, fields, note=span),
    )
    return tuple(listed for listed in tables if listed.rows)


def energy_table(trace: Trace) -> Table:
    """Return the energy book of a run.

    Args:
        trace: As simulated.
    """
    work = trace.work
    book = EnergyBook(work.driven, work.braked, work.dissipated, work.stored, work.imbalance)
    return table("Energy", [book], ("driven", "braked", "dissipated", "stored", "imbalance"))
