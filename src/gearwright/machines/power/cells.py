"""A battery as an equivalent circuit: a curve of open-circuit voltage, a resistance, a pair of R and C, warmth."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.machines.battery import EMPTY, FULL, OVERLOADED, Battery, BatteryStep, highest_current

REFERENCE = 298.15
"""Temperature at which resistances are stated [K]."""
_MOST_ROUNDS = 60
_SETTLED = 1e-15
"""Change of a current that has settled, over the largest one [-]."""


class Cells(NamedTuple):
    """What a battery is beyond a straight line behind a resistance."""

    charges: tuple[float, ...]
    """States of charge of the curve, rising from 0 to 1 [-]."""
    voltages: tuple[float, ...]
    """Open-circuit voltages there [V]."""
    slow_resistance: float
    """R_1 of the pair [Ω]."""
    time: float
    """τ = R_1 C_1 of the pair [s]."""
    activation: float
    """B of R = R_25 e^(B (1/T - 1/298.15 K)) [K]; 0: whatever the temperature."""


class CellState(NamedTuple):
    """What cells remember."""

    charge: float
    """State of charge [-]."""
    polarisation: float = 0.0
    """Voltage of the pair v_1 [V]."""


class CellStep(NamedTuple):
    """Cells over one interval of constant power."""

    step: BatteryStep
    """As of a plain battery; its loss is the heat of both resistances."""
    state: CellState
    """At its end."""


def resistance_factor(cells: Cells, temperature: float) -> float:
    """Return by what the resistances are larger than at 25 °C [-].

    Args:
        cells: The cells.
        temperature: Theirs [K].

    Source: Arrhenius.
    """
    return math.exp(cells.activation * (1.0 / temperature - 1.0 / REFERENCE))


def held_energy(battery: Battery, cells: Cells, state: CellState) -> float:
    """Return the energy that cells hold, with that of the pair's capacity [J].

    Args:
        battery: With its charge.
        cells: With its curve.
        state: Of them.

    Source: Q ∫ U ds over the straight pieces of the curve; C_1 v_1²/2 with C_1 = τ/R_1 at 25 °C.
    """
    total, s = 0.0, min(max(state.charge, 0.0), 1.0)
    pieces = zip(cells.charges, cells.charges[1:], cells.voltages, cells.voltages[1:], strict=False)
    for low, high, first, last in pieces:
        if s <= low:
            break
        end = min(s, high)
        slope = (last - first) / (high - low)
        total += (end - low) * (first + 0.5 * slope * (end - low))
    slow = 0.5 * cells.time / cells.slow_resistance * state.polarisation**2 if cells.slow_resistance else 0.0
    beyond = (state.charge - s) * (cells.voltages[-1] if state.charge > 1.0 else cells.voltages[0])
    return battery.charge * (total + beyond) + slow


def open_voltage(cells: Cells, charge: float) -> float:
    """Return the open-circuit voltage [V].

    Args:
        cells: With their curve.
        charge: State of charge [-].
    """
    pieces = zip(cells.charges, cells.charges[1:], cells.voltages, cells.voltages[1:], strict=False)
    for low, high, first, last in pieces:
        if charge <= high:
            return first + (last - first) * max(charge - low, 0.0) / (high - low)
    return cells.voltages[-1]


def cell_step(
    battery: Battery, cells: Cells, state: CellState, *, power: float, duration: float, temperature: float
) -> CellStep:
    """Return cells after an interval of constant power at their terminals.

    The current is constant in the interval; open-circuit voltage and the pair's voltage are their exact means for it,
    so that what the chemistry gives is power, heat and the pair's energy, to rounding.

    Args:
        battery: Capacity, resistance and limits.
        cells: Curve, pair, activation.
        state: At the start.
        power: At the terminals; negative charges [W].
        duration: [s].
        temperature: Of the cells [K].

    Source: (U_mean - R_0 I - v_mean) I = P; v_1' = (R_1 I - v_1)/τ, whose mean is R_1 I + (v_0 - R_1 I) φ(Δt/τ).
    """
    warm = resistance_factor(cells, temperature)
    fast, slow = battery.resistance * warm, cells.slow_resistance  # the pair stays: its capacity would warm up, too
    x = duration / cells.time
    phi = -math.expm1(-x) / x
    held = CellState(state.charge)
    current, square, mean = 0.0, 0.0, open_voltage(cells, state.charge)
    for _ in range(_MOST_ROUNDS):
        voltage, effective = mean - state.polarisation * phi, fast + slow * (1.0 - phi)
        square = voltage * voltage - 4.0 * effective * power
        after = 2.0 * power / (voltage + math.sqrt(max(square, 0.0)))
        settled = abs(after - current) <= _SETTLED * highest_current(battery)
        current = after
        passed = current * duration / battery.charge
        if abs(passed) > 1e-12:
            there = held_energy(battery, cells, CellState(state.charge - passed))
            mean = (held_energy(battery, cells, held) - there) / (battery.charge * passed)
        if settled:
            break
    final = state.charge - current * duration / battery.charge
    last = slow * current + (state.polarisation - slow * current) * math.exp(-x)
    terminal = power / current if current else mean - state.polarisation * phi
    gained = 0.5 * cells.time / slow * (last**2 - state.polarisation**2) if slow else 0.0
    heat = (mean - terminal) * current - gained / duration
    fault = _fault(battery, current, final, square)
    return CellStep(BatteryStep(final, current, mean * current, heat, terminal, fault), CellState(final, last))


def _fault(battery: Battery, current: float, final: float, square: float) -> str:
    if square < 0.0 or abs(current) > highest_current(battery) * (1.0 + 1e-9):
        return OVERLOADED
    if final < battery.minimum:
        return EMPTY
    return FULL if final > 1.0 + 1e-12 else ""


def straight(battery: Battery, *, slow_resistance: float = 0.0, time: float = 1.0, activation: float = 0.0) -> Cells:
    """Return cells whose curve is a battery's straight line.

    Args:
        battery: With its two voltages.
        slow_resistance: R_1 [Ω].
        time: τ [s].
        activation: B [K].
    """
    return Cells((0.0, 1.0), (battery.empty_voltage, battery.full_voltage), slow_resistance, time, activation)
