"""Whether what is sized runs clear, can be ground and can be put together: checks of a review, from places and bodies.

Bodies that stand into each other are `sizing`'s to find; strength of what holds parts is its too.
"""

from gearwright.sizing.making.bridges import bridge_checks
from gearwright.sizing.making.checks import built_checks, making_checks
from gearwright.sizing.making.grinding import grinding_checks, largest_wheel
from gearwright.sizing.making.order import Withdrawn, order_checks, stack_checks, withdrawals
from gearwright.sizing.making.ring_seats import ring_seat_checks
from gearwright.sizing.making.running import running_checks
from gearwright.sizing.making.spanner import spanner_checks

__all__ = [
    "Withdrawn",
    "bridge_checks",
    "built_checks",
    "grinding_checks",
    "largest_wheel",
    "making_checks",
    "order_checks",
    "ring_seat_checks",
    "running_checks",
    "spanner_checks",
    "stack_checks",
    "withdrawals",
]
