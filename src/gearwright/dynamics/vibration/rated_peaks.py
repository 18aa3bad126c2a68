"""Simulated peaks beside the rated loads: what is left of the margins when the peak of a run counts."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.dynamics.motion import Trace
from gearwright.identity import Kind, PartId, Row
from gearwright.ranking import smallest_first
from gearwright.sizing import MeshSizing, Sizing
from gearwright.units import Origin, Quantity


@dataclass(frozen=True)
class DynamicLoad:
    """One mesh row in a run."""

    mesh: str
    peak_over_mean: Annotated[float, Quantity("ratio"), Origin("F_max / F_mean", "run")]
    """Dynamic factor of the run [-]."""
    peak_force: Annotated[float, Quantity("force"), Origin("F_t = F cos α_t", "run")]
    """Largest tangential force of one mesh [N]."""
    rated_force: Annotated[
        float, Quantity("force"), Origin("F_t of the worst case, times the factors for peaks in its rating", "sizing")
    ]
    """Tangential force that the mesh is sized for [N]."""
    bending_margin: Annotated[float, Quantity("ratio"), Origin("margin · F_t / F_t,max", "root stress ∝ force")]
    """Bending margin at the peak [-]."""
    contact_margin: Annotated[float, Quantity("ratio"), Origin("margin · √(F_t / F_t,max)", "flank stress ∝ √force")]
    """Contact margin at the peak [-]."""


@dataclass(frozen=True)
class ShaftLoad:
    """One shaft in a run."""

    shaft: str
    peak_torque: Annotated[float, Quantity("torque"), Origin("T_max", "run")]
    """Largest torque of its lines, without sign [N m]."""
    rated_torque: Annotated[float, Quantity("torque"), Origin("T at the section that governs", "sizing")]
    """Torque that it is sized for [N m]."""
    margin: Annotated[float, Quantity("ratio"), Origin("margin · T / T_max", "stress ∝ torque")]
    """Against yield at the peak, with the bending moment that grows with the torque [-]."""


def shaft_loads(sizing: Sizing, trace: Trace) -> tuple[ShaftLoad, ...]:
    """Return the peak of every shaft beside what it is sized for, the worst first.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    loads = list[ShaftLoad]()
    for shaft in sizing.shafts if trace.force.bins else ():
        lines = trace.labels.lines_of(PartId(Kind.SHAFT, shaft.name))
        peak = max((_peak(trace, line) for line in lines), default=0.0)
        if peak and shaft.torque:
            rated = abs(shaft.torque)
            loads.append(ShaftLoad(shaft.name, peak, rated, shaft.margin * rated / peak))
    return tuple(smallest_first(loads, lambda load: load.margin))


def _peak(trace: Trace, line: str) -> float:
    history = trace.force.of(line)
    return max(abs(float(history["maximum"].max())), abs(float(history["minimum"].min())))


def dynamic_loads(sizing: Sizing, trace: Trace) -> tuple[DynamicLoad, ...]:
    """Return the peak of every mesh row beside what it is sized for, the worst first.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    meshes = sizing.meshes if trace.force.bins else ()
    loads = [load for mesh in meshes if (load := _load(sizing, mesh, trace)) is not None]
    return tuple(smallest_first(loads, lambda load: min(load.bending_margin, load.contact_margin)))


def _load(sizing: Sizing, mesh: MeshSizing, trace: Trace) -> DynamicLoad | None:
    lines = trace.labels.lines_of(mesh.part)
    if not lines or not mesh.tangential_force:
        return None
    # The halves of a double-helical gear are one line; planets have a line each.
    together = mesh.count if mesh.row is Row.PAIR else 1
    statistics = [trace.force.of(name) for name in lines]
    peak = max(_peak(trace, name) for name in lines)
    mean = max(abs(float(line["mean"].mean())) for line in statistics)
    force, sized_for = (
        peak * math.cos(mesh.working_pressure_angle) / together,
        mesh.tangential_force * mesh.rating.peaks,
    )
    return DynamicLoad(
        mesh=mesh.name,
        peak_over_mean=peak / mean if mean else math.inf,
        peak_force=force,
        rated_force=sized_for,
        bending_margin=mesh.bending_margin * sized_for / force,
        contact_margin=mesh.contact_margin * math.sqrt(sized_for / force),
    )
