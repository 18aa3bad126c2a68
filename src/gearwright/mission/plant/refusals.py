"""Why a battery cannot give or take a power, and what helps."""

from __future__ import annotations

from gearwright.machines import EMPTY, FULL, Battery, BatteryStep, highest_current
from gearwright.units import apart


def less(mode: str) -> str:
    """Return what makes the motors' power less; only a hybrid phase divides it.

    Args:
        mode: Of the phase.
    """
    return "lower electric_share or power" if mode == "hybrid" else "ask for less power"


def faulty(battery: Battery, charge: float, power: float, *, step: BatteryStep, mode: str) -> str:
    """Return what is wrong with a power that a battery cannot give or take, its limit, and what helps.

    Args:
        battery: The battery.
        charge: State of charge at the start [-].
        power: At its terminals [W].
        step: With the fault.
        mode: Of the phase.
    """
    said = f"{step.fault}: {power / 1e3:.0f} kW at a state of charge of {charge:.3f}"
    lower = less(mode)
    if step.fault == FULL:
        return f"{said} (maximum 1); start with a lower start_charge, charge less or shorter, or give more energy_kwh"
    if step.fault == EMPTY:
        return f"{said} (minimum {battery.minimum:g}); {lower}, fly shorter, or give more energy_kwh"
    highest = highest_current(battery)
    if abs(step.current) <= highest:  # no current gives this power behind the resistance
        limit = f"more than its resistance of {battery.resistance:g} Ω lets through"
        return f"{said}, {limit}; {lower}, or lower resistance_ohm"
    current, most = apart(abs(step.current), highest, "current")
    limit = f"{current}, of {most} (highest_c_rate {battery.highest_rate:g})"
    return f"{said}: {limit}; {lower}, or give more energy_kwh or highest_c_rate"
