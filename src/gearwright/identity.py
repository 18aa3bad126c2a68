"""Who a part is: kind, stage, role and number as fields, and the one label that people read.

A label is made from the fields and is never taken apart again: who needs the stage of ``first.sun-planet-1`` has it.
Only the reader of files turns what a user wrote (``off.wheel``) into fields.
"""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache
from typing import NamedTuple


class Kind(StrEnum):
    """What a part is; the groups in which parts are listed."""

    GEARBOX = "gearbox"
    STAGE = "stage"
    MESH = "mesh"
    GEAR = "gear"
    CARRIER = "carrier"
    SHAFT = "shaft"
    BEARING = "bearing"
    JOINT = "joint"
    CLUTCH = "clutch"
    DAMPER = "damper"
    MACHINE = "machine"
    BATTERY = "battery"


class Role(StrEnum):
    """What a gear is in its stage."""

    SUN = "sun"
    PLANET = "planet"
    RING = "ring"
    PINION = "pinion"
    WHEEL = "wheel"


SIDES = (Role.PINION, Role.WHEEL)
"""The gears of a pair."""
MEMBERS = (Role.SUN, Role.RING, Kind.CARRIER)
"""What of a planetary set is on a shaft, or on the ground."""


class Row(StrEnum):
    """Which meshes of a stage a row holds."""

    SUN_PLANET = "sun-planet"
    PLANET_RING = "planet-ring"
    PLANET_PLANET = "planet-planet"
    PAIR = "pair"
    """Pinion and wheel."""


class PartId(NamedTuple):
    """A part of a transmission."""

    kind: Kind
    name: str = ""
    """Stage of a gear, a mesh and a carrier, in the design's words; of anything else its own name."""
    role: Role | Row | None = None
    """Of a gear or a mesh row."""
    branch: str = ""
    """Shaft of one of several parallel gears or meshes; of a joint the shaft that it sits on."""
    number: int | None = None
    """One of several planets, from 1."""
    own: str = ""
    """What the design calls a gear of a compound set, or the two of a mesh; empty where the role says it."""

    def __str__(self) -> str:
        """Return the label: ``first.sun``, ``first.sun-planet-1``, ``off.left``, ``first.carrier``, ``mast``."""
        return _label(self)

    def is_of(self, whole: PartId) -> bool:
        """Tell whether this is a part, or one of its several planets.

        Args:
            whole: Without number it means them all.
        """
        return whole in (self, self._replace(number=None))


@lru_cache(maxsize=4096)
def _label(part: PartId) -> str:
    """Return the label of a part; sizing asks for it again and again."""
    if part.kind is Kind.JOINT and part.branch:
        return f"{part.name} on {part.branch}"
    role = "carrier" if part.kind is Kind.CARRIER else "" if part.role in (None, Row.PAIR) else str(part.role)
    label = ".".join(word for word in (part.name, part.own or role, part.branch) if word)
    return label if part.number is None else f"{label}-{part.number}"


GEARBOX = PartId(Kind.GEARBOX, "gearbox")
"""All of it."""
HOUSING = PartId(Kind.GEARBOX, "housing")
"""What stands around it."""


def gear_part(stage: str, role: Role, branch: str = "", *, number: int | None = None, own: str = "") -> PartId:
    """Return a gear.

    Args:
        stage: Pair or planetary set that owns it.
        role: What it is there.
        branch: Shaft of one of several bodies.
        number: Of one planet, from 1.
        own: What the design calls it in a compound set.

    >>> str(gear_part("first", Role.PLANET, number=2))
    'first.planet-2'
    """
    return PartId(Kind.GEAR, stage, role, branch, number, own)


def mesh_part(stage: str, row: Row, branch: str = "", *, number: int | None = None, own: str = "") -> PartId:
    """Return a mesh row, or one of its meshes.

    Args:
        stage: Pair or planetary set that it belongs to.
        row: Which meshes of the stage.
        branch: Shaft of one of several parallel rows.
        number: Of one planet, from 1.
        own: What the design calls its two gears in a compound set, joined by a dash.

    >>> str(mesh_part("first", Row.SUN_PLANET, number=1)), str(mesh_part("off", Row.PAIR, "left-out"))
    ('first.sun-planet-1', 'off.left-out')
    """
    return PartId(Kind.MESH, stage, row, branch, number, own)


def member_part(stage: str, member: Role | Kind) -> PartId:
    """Return a member of a planetary set.

    Args:
        stage: Name of the set.
        member: Sun, ring, planet, or carrier.

    >>> str(member_part("first", Role.RING)), str(member_part("first", Kind.CARRIER))
    ('first.ring', 'first.carrier')
    """
    return gear_part(stage, member) if isinstance(member, Role) else PartId(member, stage)


def carrier_part(stage: str) -> PartId:
    """Return the carrier of a planetary set.

    Args:
        stage: Name of the set.

    >>> str(carrier_part("first"))
    'first.carrier'
    """
    return PartId(Kind.CARRIER, stage)
