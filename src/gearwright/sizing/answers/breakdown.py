"""Breakdown: masses part by part, forces on bearings, and speeds that the teeth give only nearly."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearwright.ranking import largest_first
from gearwright.sizing.result import PRELIMINARY, Sizing
from gearwright.units import Length, Mass, Origin, Quantity, Speed

KEPT = 1e-9
"""Deviation of a speed below which it counts as kept [-]; rounding is far below."""
ROUNDING = 1e-9
"""Force beside the largest that counts as rounding [-]."""


@dataclass(frozen=True)
class MassPart:
    """One line of the mass breakdown."""

    part: str
    group: str
    """gears, shafts, carriers or planet bearings."""
    count: int
    """How many of it [-]."""
    each: Mass
    """Of one [kg]."""
    total: Mass
    """Of all [kg]."""
    share: Annotated[float, Quantity("percent")]
    """Of the sum of these parts [-]."""


@dataclass(frozen=True)
class AskedSpeed:
    """A speed that the teeth give only nearly."""

    case: str
    machine: str
    asked: Speed
    """[rad/s]"""
    actual: Speed
    """[rad/s]"""
    deviation: Annotated[float, Quantity("percent"), Origin("actual / asked − 1", "kinematics of the teeth")]
    """[-]"""


@dataclass(frozen=True)
class BearingForce:
    """What one bearing carries in the case that governs its shaft."""

    shaft: str
    case: str
    position: Length
    """From the shaft's first end [m]."""
    radial_force: Annotated[float, Quantity("force"), Origin("√(F_y² + F_z²)", "equilibrium in both planes")]
    """[N]"""


def mass_parts(sizing: Sizing) -> tuple[MassPart, ...]:
    """Return the mass breakdown of gears, shafts, carriers and weighed planet bearings, heaviest first.

    Args:
        sizing: As sized.
    """
    return tuple(largest_first(_parts(sizing), lambda row: row.total))


def mass_groups(sizing: Sizing) -> dict[str, Mass]:
    """Return the mass of gears, shafts, carriers and weighed planet bearings, of those that there are [kg].

    Args:
        sizing: As sized.
    """
    groups = dict[str, Mass]()
    for row in _parts(sizing):
        groups[row.group] = groups.get(row.group, 0.0) + row.total
    return groups


def _parts(sizing: Sizing) -> list[MassPart]:
    """Return the parts group by group."""
    parts = [(gear.name, "gears", gear.bodies, gear.mass) for gear in sizing.gears]
    parts += [(shaft.name, "shafts", 1, shaft.mass) for shaft in sizing.shafts]
    parts += [(str(carrier.part), "carriers", 1, carrier.mass) for carrier in sizing.carriers]
    if sizing.level == PRELIMINARY:
        parts += [(f"{gear.name} bearing", "planet bearings", gear.bodies, gear.runs_on.mass)
                  for gear in sizing.gears if gear.runs_on]  # fmt: skip
    return [
        MassPart(part, group, count, mass, count * mass, count * mass / sizing.parts_mass)
        for part, group, count, mass in parts
    ]


def asked_speeds(sizing: Sizing) -> tuple[AskedSpeed, ...]:
    """Return every asked speed that the teeth do not give exactly.

    Args:
        sizing: As sized.
    """
    return tuple(
        AskedSpeed(case, yielded.machine, yielded.asked, yielded.actual, yielded.deviation)
        for case, flow in sizing.flows.items()
        for yielded in flow.yielded
        if abs(yielded.deviation) > KEPT
    )


def bearing_forces(sizing: Sizing) -> tuple[BearingForce, ...]:
    """Return the load of every bearing on shafts of one diameter, shaft by shaft.

    Args:
        sizing: As sized.
    """
    built = {shaft.name for shaft in sizing.built_shafts}
    largest = max((bearing.radial_force for shaft in sizing.shafts for bearing in shaft.bearings), default=0.0)
    return tuple(
        BearingForce(shaft.name, shaft.case, bearing.position, _above_rounding(bearing.radial_force, largest))
        for shaft in sizing.shafts
        for bearing in shaft.bearings
        if shaft.name not in built
    )


def _above_rounding(value: float, largest: float) -> float:
    return value if value > ROUNDING * largest else 0.0
