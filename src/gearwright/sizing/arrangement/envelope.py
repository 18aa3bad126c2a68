"""The space that gears, shafts and carriers take: a box around their tip circles, and how long the axes are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

from gearwright.identity import Role
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import Pair
from gearwright.units import Origin, Quantity, Volume


@dataclass(frozen=True)
class Envelope:
    """A box around the gearbox without its housing; the shafts run along its length."""

    width: Annotated[float, Quantity("length"), Origin("tip circles around the axes, along y", "geometry")]
    """Across the shafts, along y [m]."""
    height: Annotated[float, Quantity("length"), Origin("tip circles around the axes, along z", "geometry")]
    """Across the shafts, along z [m]."""
    length: Annotated[
        float, Quantity("length"), Origin("longest axis: its shafts and planetary sets in a row", "layout")
    ]
    """Along the shafts [m]."""

    @property
    def volume(self) -> Volume:
        """Of the box [m³]."""
        return self.width * self.height * self.length


def envelope(sizing: Sizing) -> Envelope:
    """Return the box around all gears and shafts.

    Args:
        sizing: What was sized; its axes stand where its layout says.
    """
    discs = list(_discs(sizing))
    sides = [(min(disc[k] - disc[2] for disc in discs), max(disc[k] + disc[2] for disc in discs)) for k in (0, 1)]
    (left, right), (low, high) = sides
    return Envelope(right - left, high - low, max(_lengths(sizing).values()))


def _discs(sizing: Sizing) -> Iterator[tuple[float, float, float]]:
    """Yield y, z and radius of every gear on a shaft, of every ring, and of every shaft [m]."""
    axis = {shaft.name: shaft.axis for shaft in sizing.shafts}
    for shaft in sizing.shafts:
        yield (*shaft.axis, shaft.diameter / 2.0)
    for gear in sizing.gears:
        for shaft_name in _carriers_of(sizing, gear):
            yield (*axis[shaft_name], gear.pitch_diameter / 2.0 + (gear.rim or _addendum(gear)))


def _addendum(gear: GearSizing) -> float:
    """Return how far the tip circle of a disc stands outside its pitch circle [m]."""
    return gear.module * (1.0 + gear.profile_shift + gear.tip_alteration)


def _carriers_of(sizing: Sizing, gear: GearSizing) -> Iterator[str]:
    """Yield the shafts around which a gear turns or stands; a ring on the ground stands around its set's shafts."""
    stage = sizing.design.stages[gear.stage]
    carried = not isinstance(stage, Pair)
    members = gear.shafts if isinstance(stage, Pair) else stage.members
    names = {shaft.name for shaft in sizing.shafts}
    if gear.role is not Role.PLANET:
        borne = [shaft for shaft in members if shaft in names]
        yield from borne[:1] if carried else borne


def _set_length(sizing: Sizing, name: str) -> float:
    """Return how long a planetary set is: the longest planet, or the longest of each plane of steps in a row [m]."""
    longest: dict[str, float] = {}
    for gear in sizing.train.gears:
        if gear.stage == name and gear.role is Role.PLANET:
            width = next(sized.face_width for sized in sizing.gears if sized.name == gear.name)
            longest[gear.group] = max(longest.get(gear.group, 0.0), width)
    return sum(longest.values())


def _lengths(sizing: Sizing) -> dict[tuple[float, float], float]:
    """Return the length of every axis: its shafts in a row and the face widths of its planetary sets [m]."""
    length: dict[tuple[float, float], float] = {}
    axis = {shaft.name: shaft.axis for shaft in sizing.shafts}
    for shaft in sizing.shafts:
        length[shaft.axis] = length.get(shaft.axis, 0.0) + shaft.length
    for name, stage in sizing.design.sets.items():
        place = next(axis[member] for member in stage.members if member in axis)
        length[place] += _set_length(sizing, name)
    return length
