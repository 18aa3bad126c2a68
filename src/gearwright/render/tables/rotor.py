"""Tables of a helicopter's rotors over its speed: thrust and stream, and where the power goes."""

from __future__ import annotations

from gearwright.catalogue import RotorTrim
from gearwright.render.grid.table import Table, table

THRUST = ("airspeed", "advance_ratio", "thrust", "loading", "tilt", "induced_velocity", "tail_thrust")
POWER = ("airspeed", "induced", "profile", "parasite", "climb", "power", "tail_power", "total", "torque")
OF_TAIL = {"tail_thrust", "tail_power"}
"""Columns that nothing stands in without a tail rotor."""


def rotor_tables(found: RotorTrim) -> tuple[Table, Table]:
    """Return what the rotors lift, and what they take.

    Args:
        found: Over the speed.
    """
    without = OF_TAIL if found.helicopter.tail is None else set[str]()
    thrust, power = ([name for name in fields if name not in without] for fields in (THRUST, POWER))
    return table("Rotors", found.rows, thrust), table("Their power", found.rows, power)
