"""Stage by stage: kind, ratio, meshes that share the torque, size and mass, to hold designs beside each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.identity import Role, gear_part
from gearwright.sizing.result import Sizing
from gearwright.spec import Epicyclic, Planetary
from gearwright.units import Origin, Quantity


@dataclass(frozen=True)
class StageSummary:
    """One stage of one design."""

    design: str
    stage: str
    kind: str
    """planetary, star, differential, pair or parallel pairs."""
    ratio: Annotated[float, Quantity("ratio"), Origin("z_2/z_1 or 1 + z_r/z_s", "teeth")]
    """[-]"""
    meshes: int
    """Meshes that share the torque of its first gear."""
    torque: Annotated[float, Quantity("torque"), Origin("T K_γ / N at its worst case", "power flow")]
    """On pinion or sun, of one mesh [N m]."""
    module: Annotated[float, Quantity("length"), Origin("m_n ≥ max(bending, contact)", "rating of its meshes")]
    """[m]"""
    face_width: Annotated[
        float, Quantity("length"), Origin("b = λ m_n, or the least that serves", "rating of its meshes")
    ]
    """[m]"""
    mass: Annotated[float, Quantity("mass"), Origin("its gears", "geometry")]
    """[kg]"""


def stage_summaries(sizing: Sizing, design: str) -> Iterator[StageSummary]:
    """Yield what every stage of a design does and weighs.

    Args:
        sizing: As sized.
        design: What the design is called beside others.
    """
    gears = {gear.name: gear for gear in sizing.gears}
    for stage in sizing.design.stages:
        rows = [mesh for mesh in sizing.meshes if mesh.stage == stage]
        first = gears[rows[0].gears[0]]
        planetary = stage in sizing.design.sets
        yield StageSummary(
            design=design,
            stage=stage,
            kind=_kind(sizing, stage, len(rows)),
            ratio=_ratio(sizing, stage),
            meshes=rows[0].count * (1 if planetary else len(rows)),
            torque=max(row.tangential_force * row.working_diameter / 2.0 for row in rows if row.gears[0] == first.name),
            module=first.module,
            face_width=first.face_width,
            mass=sum(gear.mass * gear.bodies for gear in sizing.gears if gear.stage == stage),
        )


def _kind(sizing: Sizing, stage: str, rows: int) -> str:
    record = sizing.design.stages[stage]
    if isinstance(record, Epicyclic):
        return "compound set"
    if isinstance(record, Planetary):
        if "ground" not in (record.sun, record.ring, record.carrier):
            return "differential"
        return "star" if record.carrier == "ground" else "planetary"
    return "parallel pairs" if rows > 1 else "pair"


def _ratio(sizing: Sizing, stage: str) -> float:
    record, teeth = sizing.design.stages[stage], sizing.teeth
    if isinstance(record, Epicyclic):
        return _fastest_over_slowest(sizing, record)
    if isinstance(record, Planetary):
        sun, ring = (teeth[str(gear_part(stage, role))] for role in (Role.SUN, Role.RING))
        ratio = ring / sun
        return ratio if record.carrier == "ground" else 1.0 + ratio
    mesh = next(mesh for mesh in sizing.train.meshes if mesh.stage == stage)
    return teeth[mesh.gears[1]] / teeth[mesh.gears[0]]


def _fastest_over_slowest(sizing: Sizing, epicyclic: Epicyclic) -> float:
    """Return the largest speed of a compound set's members over the smallest but zero, in the first case [-]."""
    flow = next(iter(sizing.flows.values()))
    speeds = [abs(flow.speeds[shaft]) for shaft in epicyclic.members if flow.speeds[shaft]]
    return max(speeds, default=0.0) / min(speeds, default=1.0)
