"""Simulated peaks beside the rated loads: what is left of the margins when the peak of a run counts."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.dynamics.motion import Trace
from gearwright.identity import Row
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


def dynamic_loads(sizing: Sizing, trace: Trace) -> tuple[DynamicLoad, ...]:
    """Return the peak of every mesh row beside what it is sized for, the worst first.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    meshes = sizing.meshes if trace.force.bins else ()
    loads = [load for mesh in meshes if (load := _load(sizing, mesh, trace)) is not None]
    return tuple(sorted(loads, key=lambda load: min(load.bending_margin, load.contact_margin)))


def _load(sizing: Sizing, mesh: MeshSizing, trace: Trace) -> DynamicLoad | None:
    lines = trace.labels.lines_of(mesh.part)
    if not lines or not mesh.tangential_force:
        return None
    # The halves of a double-helical gear are one line; planets have a line each.
    together = mesh.count if mesh.row is Row.PAIR else 1
    statistics = [trace.force.of(name) for name in lines]
    peak = max(max(abs(float(line["maximum"].max())), abs(float(line["minimum"].min()))) for line in statistics)
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
