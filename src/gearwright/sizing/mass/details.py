"""Seals, sensors, drives of accessories, what holds and seals bearings, and the rest that no rule counts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.sizing.mass.calibration import Calibration
from gearwright.sizing.mass.record import MassItem
from gearwright.sizing.result import Sizing
from gearwright.sizing.shafts import holders_of, unsealed_exits

SEAL = 40.0
"""Seal that is not chosen, with its cover, over the square of the shaft's diameter, an estimate [kg/m²]."""
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
    housing = sizing.design.housing
    for leaves in unsealed_exits(sizing):
        yield MassItem(
            f"{leaves.machine} seal", "details", 1, SEAL * leaves.diameter**2, SURE, "40 kg/m² d²", "estimate"
        )
    if housing.oil_system == "own":
        yield MassItem("sensors", "details", 1, SENSORS, SURE, "0.8 kg", "estimate")
    if housing.accessory_drives:
        yield MassItem("accessory drives", "details", housing.accessory_drives, PAD, SURE, "1.5 kg each", "estimate")
    held = {holder.name: holder.mass for holder in holders_of(sizing)}
    for name, mass in held.items():
        yield MassItem(
            name, "details", 1, mass, HELD, "as drawn; nuts: catalogue", "parts that hold bearings and seal shafts"
        )
    share = fitted.details * sum(item.total for item in counted if item.group not in ("lubrication", "details"))
    rest = max(share - sum(held.values()), 0.0)
    yield MassItem("fasteners and small parts", "details", 1, rest, SURE, "a share, less what is sized", "held against")
