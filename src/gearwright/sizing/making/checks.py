"""All of these checks of a design."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check
from gearwright.sizing import Sizing
from gearwright.sizing.making.bosses import boss_checks, web_checks
from gearwright.sizing.making.bridges import bridge_checks
from gearwright.sizing.making.grinding import grinding_checks
from gearwright.sizing.making.order import order_checks, stack_checks
from gearwright.sizing.making.ring_seats import ring_seat_checks
from gearwright.sizing.making.running import running_checks
from gearwright.sizing.making.spanner import spanner_checks
from gearwright.sizing.shafts import (
    groove_checks,
    holding_checks,
    pressure_centre_checks,
    retention_checks,
    seal_checks,
)


def making_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield whether parts run clear of each other, can be ground and can be put together.

    Args:
        sizing: As sized.
    """
    yield from running_checks(sizing)
    yield from grinding_checks(sizing)
    yield from stack_checks(sizing)
    yield from order_checks(sizing)
    yield from spanner_checks(sizing)
    yield from bridge_checks(sizing)
    yield from boss_checks(sizing)
    yield from web_checks(sizing)
    yield from ring_seat_checks(sizing)


def built_checks(sizing: Sizing) -> Iterator[Check]:
    """Yield every check of what holds parts, of seals, pressure centres and making, beside those of a sizing.

    Args:
        sizing: As sized.
    """
    yield from retention_checks(sizing)
    yield from holding_checks(sizing)
    yield from groove_checks(sizing)
    yield from seal_checks(sizing)
    yield from pressure_centre_checks(sizing)
    yield from making_checks(sizing)
