"""Checks of electric machines: powers at speeds that no rotor bears."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.base import RPM, Problem
from gearwright.machines import largest_power
from gearwright.spec.design import Design, ElectricMachine, given_values

_ROUNDING = 1e-9


def electric_problems(design: Design) -> Iterator[Problem]:
    """Find motors and generators of unknown mass whose rotor would burst at their rated power and speed.

    Args:
        design: As typed.
    """
    given = given_values(design).values
    for table in ("motors", "generators"):
        for name, machine in getattr(design, table).items():
            if f"{name}.mass" not in given:
                yield from _bursting(f"{table}.{name}", machine)


def _bursting(path: str, machine: ElectricMachine) -> Iterator[Problem]:
    """Find a power above that of the largest rotor that bears the speed."""
    most = largest_power(machine.speed, machine.tip_speed)
    if machine.power <= most * (1.0 + _ROUNDING):
        return
    excess = machine.power / most
    tip, fastest = machine.tip_speed * math.cbrt(excess), machine.speed / math.sqrt(excess)
    asked, here = f"{machine.power / 1e3:.4g} kW", f"{machine.speed / RPM:.5g} rpm"
    yield Problem(
        f"{path}.speed_rpm",
        f"{asked} at {here} ask for a rotor whose surface runs at {tip:.0f} m/s, and it bears tip_speed_m_s ="
        f" {machine.tip_speed:.4g}; allowed are at most {fastest / RPM:.0f} rpm for {asked}, or {most / 1e3:.4g} kW at"
        f" {here}; a machine that is built may have its mass_kg instead",
    )
