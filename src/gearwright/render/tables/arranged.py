"""A design whose shafts were put into bearings, as tables: bearings, shafts, and masses before and after."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.base import Endless, Force, Length, Life, Mass, Quantity
from gearwright.closure import Arranged
from gearwright.render.grid import Table, table
from gearwright.sizing.bearing_arrangement import items_on
from gearwright.sizing.mass import GROUPS
from gearwright.spec import Airscrew

_BEARINGS = (
    "Position: middle of the width, from the first end of the shaft. F_r and F_a: in the case with the largest static"
    " load. Life: as it is asked, basic or modified."
)
_SHAFTS = (
    "Diameter: the largest. Mass: without what lies inside gears, which count as solid where they are of one piece."
)


@dataclass(frozen=True)
class ArrangedBearing:
    """One bearing of a shaft, whether the design gave it or not."""

    shaft: str
    bearing: str
    kind: str
    """As the design calls it."""
    locates: str
    """Axial force that it takes: none, both ways, or only towards that end of the shaft."""
    designation: str
    position: Length
    """From the shaft's first end [m]."""
    radial: Force
    """In the case with the largest static load [N]."""
    axial: Force
    """In that case [N]."""
    life: Annotated[Life, Endless()]
    """Basic or modified, as it is asked [s]."""
    asked: Life
    """[s]"""
    static_safety: Annotated[float, Quantity("ratio"), Endless()]
    """At the largest load [-]."""
    mass: Mass
    """[kg]"""
    given: bool
    """Whether it stood in the design before."""


@dataclass(frozen=True)
class ArrangedShaft:
    """One shaft before and after."""

    shaft: str
    length: Length
    """[m]"""
    diameter: Length
    """Largest one [m]."""
    bore: Length
    """Zero where it is solid [m]."""
    span: Length | None
    """Between the middles of its radial bearings; None where it has none [m]."""
    mass_before: Mass
    """[kg]"""
    mass_after: Mass
    """[kg]"""


@dataclass(frozen=True)
class MassChange:
    """A group of parts of the complete mass, or their sum, before and after."""

    group: str
    before: Mass
    """[kg]"""
    after: Mass
    """[kg]"""


@dataclass(frozen=True)
class Unborne:
    """A shaft that was put into no bearings."""

    shaft: str
    why: str


SUM = "sum"
"""What stands in place of a group for all of them."""


def arranged_bearings(arranged: Arranged) -> tuple[ArrangedBearing, ...]:
    """Return all bearings, shaft by shaft.

    Args:
        arranged: From `arrange`.
    """
    seats, given = arranged.design.bearings, arranged.before.design.bearings
    return tuple(
        ArrangedBearing(
            own.shaft, own.name, seats[own.name].kind, seats[own.name].locates, own.designation, own.position,
            own.radial, own.axial, own.judged_life, own.wanted_life, own.static_safety, own.mass, own.name in given,
        )
        for own in arranged.sizing.bearings
    )  # fmt: skip


def arranged_shafts(arranged: Arranged) -> tuple[ArrangedShaft, ...]:
    """Return all shafts with what they weigh of the complete mass, before and after.

    Args:
        arranged: From `arrange`.
    """
    before, after = (
        {item.part: item.total for item in mass.parts if item.group == "shafts"} for mass in arranged.masses
    )
    plans, borne = arranged.sizing.arrangement.plans, {seat.shaft for seat in arranged.design.bearings.values()}
    return tuple(
        ArrangedShaft(
            own.name, own.length, own.diameter, own.bore,
            abs(plans[own.name].bearings[1] - plans[own.name].bearings[0]) if own.name in borne else None,
            before.get(own.name, 0.0), after.get(own.name, 0.0),
        )
        for own in arranged.sizing.shafts
    )  # fmt: skip


def mass_changes(arranged: Arranged) -> tuple[MassChange, ...]:
    """Return the groups of the complete mass before and after, and their sum.

    Args:
        arranged: From `arrange`.
    """
    before, after = arranged.masses
    groups = [MassChange(group, before.of(group), after.of(group)) for group in GROUPS]
    return (*(row for row in groups if row.before or row.after), MassChange(SUM, before.total, after.total))


def unforced(arranged: Arranged) -> tuple[tuple[str, str], ...]:
    """Return propellers and rotors of which the design states no force, each with its shaft in bearings.

    Args:
        arranged: From `arrange`.
    """
    borne = {seat.shaft for seat in arranged.design.bearings.values()}
    screws = ((name, one) for name, one in arranged.design.machines.items() if isinstance(one, Airscrew))
    return tuple((name, one.shaft) for name, one in screws if one.shaft in borne and not one.stated_loads)


def unborne(arranged: Arranged) -> tuple[Unborne, ...]:
    """Return the shafts that were put into no bearings, and why.

    Args:
        arranged: From `arrange`.
    """
    return tuple(_unborne(arranged))


def _unborne(arranged: Arranged) -> Iterator[Unborne]:
    borne = {stood.line.name for stood in arranged.shafts}
    given = {seat.shaft for seat in arranged.before.design.bearings.values()}
    for shaft in arranged.before.shafts:
        if shaft.name in borne:
            continue
        kinds = {item.kind for item in items_on(arranged.before, shaft.name)}
        if shaft.name in given:
            why = "stands in the bearings of the design"
        elif "gear" in kinds:
            why = "floats between the face gears that its pinions drive"
        elif "set" in kinds:
            why = "floats between its planets"
        else:
            why = "carries no gear"
        yield Unborne(shaft.name, why)


def arranged_tables(arranged: Arranged) -> tuple[Table, ...]:
    """Return the tables of bearings, shafts and masses.

    Args:
        arranged: From `arrange`.
    """
    bearings = ("bearing", "kind", "locates", "designation", "position", "radial", "axial", "life", "asked",
                "static_safety", "mass")  # fmt: skip
    shafts = ("shaft", "length", "diameter", "bore", "span", "mass_before", "mass_after")
    return (
        table("Bearings", arranged_bearings(arranged), bearings, note=_BEARINGS),
        table("Shafts", arranged_shafts(arranged), shafts, note=_SHAFTS),
        table("Complete mass", mass_changes(arranged), ("group", "before", "after")),
    )
