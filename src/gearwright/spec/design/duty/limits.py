"""What a machine may do while a case lasts: its rating, and the limits that hold for so long."""

from __future__ import annotations

from typing import NamedTuple

from gearwright.spec.design.duty.cases import Case
from gearwright.spec.design.duty.machines import Limit, Machine


class Allowed(NamedTuple):
    """The most that a machine may do; None where nothing is said."""

    power: float | None
    """Given or taken [W]."""
    torque: float | None
    """Given or taken [N m]."""
    speed: float | None
    """[rad/s]"""


def allowed_in_case(machine: Machine, case: Case) -> Allowed:
    """Return what a machine may do in a case; one that says no duration may last as long as any limit.

    Args:
        machine: With its rating and limits.
        case: With its duration.
    """
    return allowed_for(machine, case.duration)


def allowed_for(machine: Machine, duration: float | None) -> Allowed:
    """Return what a machine may do for a time.

    Args:
        machine: With its rating and limits.
        duration: How long [s]; None: not said, and no limit is left out for its time.
    """
    limits = [limit for limit in machine.limits.values() if _holds(limit, duration)]
    powers = [limit.power for limit in limits if limit.power is not None]
    torques = [limit.torque for limit in limits if limit.torque is not None]
    rating = [] if machine.rating is None else [machine.rating]
    return Allowed(max([*rating, *powers], default=None), max(torques, default=None), machine.highest_speed)


def _holds(limit: Limit, duration: float | None) -> bool:
    return limit.duration is None or duration is None or duration <= limit.duration
