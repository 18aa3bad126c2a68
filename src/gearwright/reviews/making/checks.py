"""All of these checks of a design."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check
from gearwright.reviews.making.bridges import bridge_checks
from gearwright.reviews.making.grinding import grinding_checks
from gearwright.reviews.making.order import order_checks, stack_checks
from gearwright.reviews.making.running import running_checks
from gearwright.reviews.making.spanner import spanner_checks
from gearwright.sizing import Sizing


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
