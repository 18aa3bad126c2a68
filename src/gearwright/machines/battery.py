"""A battery as an open-circuit voltage that falls with its charge, behind a resistance."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeVar

import numpy as np

T = TypeVar("T", float, Any)

EMPTY, OVERLOADED, FULL = "empty", "overloaded", "full"
"""What stops a battery."""


class Battery(NamedTuple):
    """A battery pack."""

    charge: float
    """Capacity Q [C]."""
    full_voltage: float
    """Open-circuit voltage at full charge [V]."""
    empty_voltage: float
    """Open-circuit voltage at no charge [V]."""
    resistance: float
    """R [Ω]."""
    highest_rate: float
    """Highest current over the capacity, charging or discharging: C-rate [1/h]."""
    minimum: float
    """State of charge below which it must not go [-]."""


class BatteryStep(NamedTuple):
    """A battery over one interval of constant power."""

    state_of_charge: float
    """At the end of the interval [-]."""
    current: float
    """Positive discharges [A]."""
    open_power: float
    """Power of its chemistry, V_oc I [W]; its integral is the change of the stored energy."""
    loss: float
    """R I² [W]."""
    terminal_voltage: float
    """V [V]."""
    fault: str
    """Empty, or ``empty``, ``overloaded``, ``full``: then the interval cannot be flown."""


def stored_energy(battery: Battery, state_of_charge: float) -> float:
    """Return the energy that a battery holds [J].

    Args:
        battery: The battery.
        state_of_charge: s [-].

    Source: Q ∫ V_oc ds with V_oc linear in s.
    """
    rise = battery.full_voltage - battery.empty_voltage
    return battery.charge * (battery.empty_voltage * state_of_charge + 0.5 * rise * state_of_charge**2)


def highest_current(battery: Battery) -> float:
    """Return the largest current that its C-rate allows, charging or discharging [A].

    Args:
        battery: The battery.

    Source: definition of the C-rate: current over capacity, per hour.
    """
    return battery.highest_rate * battery.charge / 3600.0


def current_of(battery: Battery, state_of_charge: T, power: T, duration: float) -> tuple[T, T]:
    """Return the current of constant power at a battery's terminals [A], and V² - 4 R P, negative where there is none.

    Args:
        battery: The battery.
        state_of_charge: At the start [-]; a number or an array.
        power: At the terminals; negative charges [W]; a number or an array.
        duration: [s].

    Source: (V_oc - R I) I = P with V_oc at s - I Δt/(2 Q): a quadratic in I.
    """
    rise = battery.full_voltage - battery.empty_voltage
    voltage = battery.empty_voltage + rise * state_of_charge
    effective = battery.resistance + 0.5 * rise * duration / battery.charge
    square = voltage * voltage - 4.0 * effective * power
    return 2.0 * power / (voltage + np.sqrt(np.maximum(square, 0.0))), square  # holds without any resistance, too


def battery_step(battery: Battery, state_of_charge: float, power: float, duration: float) -> BatteryStep:
    """Return a battery after an interval of constant power at its terminals.

    The current is that of the middle of the interval, where the open-circuit voltage is its mean: what the chemistry
    gives is then exactly the change of the stored energy.

    Args:
        battery: The battery.
        state_of_charge: At the start [-].
        power: At the terminals; negative charges [W].
        duration: [s].

    Source: `current_of`.
    """
    rise = battery.full_voltage - battery.empty_voltage
    current, square = map(float, current_of(battery, state_of_charge, power, duration))
    final = state_of_charge - current * duration / battery.charge
    middle = battery.empty_voltage + rise * 0.5 * (state_of_charge + final)
    fault = ""
    if square < 0.0 or abs(current) > highest_current(battery) * (1.0 + 1e-9):
        fault = OVERLOADED
    elif final < battery.minimum:
        fault = EMPTY
    elif final > 1.0 + 1e-12:
        fault = FULL
    terminal = middle - battery.resistance * current
    return BatteryStep(final, current, middle * current, battery.resistance * current * current, terminal, fault)
