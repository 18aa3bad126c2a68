"""Seals, sensors, drives of accessories, what holds bearings, and the rest that no rule counts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.sizing.mass.calibration import Calibration
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts import holders_of

SEAL = 40.0
"""Shaft seal with its cover over the square of the shaft's diameter [kg/m²], an estimate."""
SENSORS = 0.8
"""Chip detector, pressure and temperature sensors with their leads [kg], an estimate."""
PAD = 1.5
"""Pad, gear and bearings of an accessory's drive [kg], an estimate."""
SURE = 0.5
"""One standard deviation of details over their value, an estimate [-]."""
HELD = 0.2
"""The same of parts that hold bearings, which are sized, an estimate [-]."""


def detail_items(sizing: Sizing, counted: Sequence[MassItem], fitted: Calibration) -> Iterator[MassItem]:
    """Yield seals, sensors, drives of accessories and the rest.

    Args:
        sizing: As sized.
        counted: Every other part.
        fitted: What published gearboxes set.
    """
    diameters = {shaft.name: shaft.diameter for shaft in sizing.shafts}
    housing = sizing.design.housing
    if housing.own:
        for machine in sizing.machines:
            seal = SEAL * diameters.get(machine.shaft, 0.0) ** 2
            yield MassItem(f"{machine.name} seal", "details", 1, seal, SURE, "40 kg/m² d²", "estimate")
    if housing.oil_system == "own":
        yield MassItem("sensors", "details", 1, SENSORS, SURE, "0.8 kg", "estimate")
    if housing.accessory_drives:
        yield MassItem("accessory drives", "details", housing.accessory_drives, PAD, SURE, "1.5 kg each", "estimate")
    held = {holder.name: holder.mass for holder in holders_of(sizing)}
    for name, mass in held.items():
        yield MassItem(name, "details", 1, mass, HELD, "as drawn; nuts: catalogue", "parts that hold bearings")
    share = fitted.details * sum(item.total for item in counted if item.group not in ("lubrication", "details"))
    rest = max(share - sum(held.values()), 0.0)
    yield MassItem("fasteners and small parts", "details", 1, rest, SURE, "a share, less what is sized", "held against")
