"""What has teeth: a kind of gear body, and a row of equal meshes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from gearwright.identity import Kind, PartId, Role, Row, gear_part, mesh_part

EXTERNAL, INTERNAL = -1, 1


@dataclass(frozen=True)
class Gear:
    """One kind of toothed body; several equal ones count together."""

    stage: str
    """Pair or planetary set that owns it."""
    role: Role
    """What it is in its stage."""
    nodes: tuple[str, ...]
    """Shafts that carry it (one body, or one per half, on each), or the planet's own node."""
    bodies: int
    """Number of equal bodies."""
    own: str = ""
    """What the design calls it, in a compound set."""
    group: str = ""
    """Gears of its stage that have one module, in a compound set: the first of them; empty where all have one."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return gear_part(self.stage, self.role, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun``."""
        return str(self.part)

    @property
    def sized(self) -> str:
        """What has one module with it: its stage, or a group of gears of a compound set."""
        return _sized(self.stage, self.group)


@dataclass(frozen=True)
class Mesh:
    """A row of the graph: one mesh, or several equal ones that share a load."""

    stage: str
    """Pair or planetary set that it belongs to."""
    row: Row
    """Which meshes of the stage it holds."""
    gears: tuple[str, str]
    """Names of gear a and gear b."""
    nodes: tuple[str, str, str]
    """Node of gear a, of gear b, and of the carrier of their axes."""
    sign: int
    """−1 external, +1 internal."""
    count: int
    """Number of equal meshes of the row (planets, halves)."""
    branch: str = ""
    """Shaft that tells it from the other rows of a pair; empty where the pair has one."""
    own: str = ""
    """What the design calls its two gears, in a compound set."""
    group: str = ""
    """As of its gears."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return mesh_part(self.stage, self.row, self.branch, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun-planet``."""
        return str(self.part)

    @property
    def sized(self) -> str:
        """What has one module with it: its stage, or a group of gears of a compound set."""
        return _sized(self.stage, self.group)


def _sized(stage: str, group: str) -> str:
    return str(PartId(Kind.GEAR, stage, own=group)) if group else stage
