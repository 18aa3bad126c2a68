"""What gears lose in oil and mist, and shafts in their seals."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from gearwright.parts.losses import (
    NITRILE,
    VITON,
    churning_power,
    seal_power_14179_1,
    seal_power_14179_2,
    seal_power_oil,
    windage_power,
    windage_power_dawson,
)
from gearwright.sizing.losses.limits import churning_limits, seal_limits
from gearwright.sizing.losses.oil import Oil
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.sizing.sealing import exits_of

_DEDENDUM = 1.25
"""Of the rack in modules, for root diameters [-] (ISO 53, profile A)."""


@dataclass(frozen=True)
class BodyLoss:
    """What one part of the gearbox loses beside what it carries."""

    part: str
    origin: str
    """windage, churning or seals."""
    count: int
    """Equal parts [-]."""
    power: float
    """Of all of them [W]."""
    limit: str = ""
    """Limits of its formula at which it is taken; empty where it holds."""


def gear_losses(sizing: Sizing, speeds: Mapping[str, float], oil: Oil) -> Iterator[BodyLoss]:
    """Yield the windage, or the churning, of every gear; one that dips churns the bath instead of the mist.

    Args:
        sizing: As sized.
        speeds: Node -> its speed [rad/s].
        oil: Around them.
    """
    for gear in sizing.gears:
        turning, dip = speeds.get(gear.shafts[0], 0.0), oil.dip.get(gear.name, 0.0)
        if dip:
            power = churning_power(
                gear.pitch_diameter, gear.face_width, turning,
                viscosity=oil.viscosity, dip=dip, module=gear.module / math.cos(gear.helix_angle),
                helix_angle=gear.helix_angle,
            )  # fmt: skip
        else:
            power = _windage(gear, turning, oil)
        origin, limit = ("churning", churning_limits(gear)) if dip else ("windage", "")
        yield BodyLoss(gear.name, origin, gear.bodies, gear.bodies * power, limit)


def _windage(gear: GearSizing, turning: float, oil: Oil) -> float:
    if oil.windage == "dawson":
        root = gear.pitch_diameter - 2.0 * (_DEDENDUM - gear.profile_shift) * gear.module
        return windage_power_dawson(root, gear.face_width, turning, module=gear.module, enclosure=oil.enclosure)
    viscosity = oil.viscosity * oil.density
    return windage_power(gear.pitch_diameter / 2.0, gear.face_width, turning, viscosity=viscosity)


def seal_losses(sizing: Sizing, speeds: Mapping[str, float], oil: Oil) -> Iterator[BodyLoss]:
    """Yield what the seal of every machine's shaft loses; nothing where no seals are counted.

    A chosen seal counts with its shaft and its lip, all others as FKM on the shaft's one diameter.

    Args:
        sizing: As sized.
        speeds: Node -> its speed [rad/s].
        oil: Before them.
    """
    if oil.seals == "none":
        return
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    chosen = {leaves.machine: leaves for leaves in exits_of(sizing) if leaves.seal is not None}
    for machine in sizing.machines:
        leaves = chosen.get(machine.name)
        diameter = diameters[machine.shaft] if leaves is None else leaves.diameter
        nitrile = leaves is not None and leaves.elastomer is not None and leaves.elastomer.name == "nbr"
        power = _seal(diameter, speeds[machine.shaft], oil, torque=NITRILE if nitrile else VITON)
        yield BodyLoss(f"seal at {machine.name}", "seals", 1, power, seal_limits(oil))


def _seal(diameter: float, speed: float, oil: Oil, *, torque: float) -> float:
    if oil.seals == "iso-tr-14179-1":
        return seal_power_14179_1(diameter, speed, torque_per_mm=torque)
    if oil.seals == "iso-tr-14179-2":
        return seal_power_14179_2(diameter, speed)
    return seal_power_oil(diameter, speed, temperature=oil.temperature, viscosity_40=oil.grade[0])
