"""Whether the pins of a carrier fit inside the planets on them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from gearwright.checks import Check
from gearwright.identity import Role
from gearwright.sizing.carrying import CarrierSizing
from gearwright.sizing.result import GearSizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec import Design


def pin_checks(design: Design, gears: Mapping[str, GearSizing], carriers: Sequence[CarrierSizing]) -> Iterator[Check]:
    """Yield whether the pin of every planet is thinner than the planet's root circle.

    Args:
        design: With the rules of its stages.
        gears: By name.
        carriers: As sized.
    """
    pins = {carrier.stage: carrier.pin_diameter for carrier in carriers}
    for gear in gears.values():
        if gear.role is Role.PLANET and gear.stage in pins:
            root = 2.0 * cylindrical_gear(design, gear).root_radius
            yield Check(
                gear.part, "pin in its bore", "ISO 21771, d_f", pins[gear.stage], root, "length",
                at_most=True, exponent=None,
            )  # fmt: skip
