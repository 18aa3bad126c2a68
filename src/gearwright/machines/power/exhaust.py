"""What leaves a turbine beside its shaft: exhaust, by flow and temperature, and heat through the casing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from gearwright.machines.gas_turbine import HEATING_VALUE
from gearwright.machines.power.gases import AIR, Gas, enthalpy, temperature_of


class Breathing(NamedTuple):
    """How much air a turbine breathes that is known by its fuel flow alone, and what heats its surroundings."""

    air_flow: float
    """At its thermal power, at sea level on a standard day [kg/s]."""
    idle_air: float
    """Part of it that flows without power [-]."""
    casing_loss: float
    """Part of the fuel's heat that leaves through casing and oil [-]."""


class Exhaust(NamedTuple):
    """The state of what leaves one turbine, or several whose gas mixes."""

    air_flow: float = 0.0
    """[kg/s]"""
    fuel_flow: float = 0.0
    """[kg/s]"""
    temperature: float = 0.0
    """Stagnation temperature of the gas [K]; of one that is off, that of the air."""
    casing: float = 0.0
    """Heat through the casing [W]."""


def air_flow(breathing: Breathing, theta: float, delta: float, part: float) -> float:
    """Return the air that a turbine breathes [kg/s].

    Args:
        breathing: The turbine.
        theta: Stagnation temperature over that of the standard sea level θ_t [-].
        delta: Stagnation pressure, likewise δ_t [-].
        part: Power over what its core gives in this air [-].

    Source: m = m_0 δ_t θ_t^-1/2 (i + (1 - i) P/P_core): choked turbine; linear in power as an assumption.
    """
    return breathing.air_flow * delta / math.sqrt(theta) * (breathing.idle_air + (1.0 - breathing.idle_air) * part)


def exhaust_of(breathing: Breathing, air: float, inlet: float, *, fuel: float, power: float) -> Exhaust:
    """Return the state in which a turbine's gas must leave it.

    Args:
        breathing: The turbine.
        air: Its air flow [kg/s].
        inlet: Stagnation temperature of the air [K].
        fuel: Fuel flow [kg/s].
        power: At its shaft [W].

    Source: steady energy of the engine: (m_a + m_f) h(T, f) = m_a h(T_0) + m_f H - P - Q_casing, solved for T.
    """
    if not fuel:
        return Exhaust(0.0, 0.0, inlet, 0.0)
    return _burning(breathing, air, inlet, fuel, power)


def _burning(breathing: Breathing, air: float, inlet: float, fuel: float, power: float) -> Exhaust:
    casing = breathing.casing_loss * fuel * HEATING_VALUE
    left = air * enthalpy(AIR, inlet) + fuel * HEATING_VALUE - power - casing
    return Exhaust(air, fuel, temperature_of(Gas(fuel / air), left / (air + fuel)), casing)


def mixed(flows: Iterable[Exhaust]) -> Exhaust:
    """Return the gas of several turbines mixed into one.

    Args:
        flows: Of every turbine, at least one.

    Source: conservation of mass and enthalpy.
    """
    known = list(flows)
    running = [flow for flow in known if flow.fuel_flow]
    if len(running) < 2:
        return running[0] if running else known[0]
    return _joined(running)


def _joined(running: Sequence[Exhaust]) -> Exhaust:
    air, fuel = sum(flow.air_flow for flow in running), sum(flow.fuel_flow for flow in running)
    carried = sum((gas.air_flow + gas.fuel_flow) * enthalpy(_gas(gas), gas.temperature) for gas in running)
    warm = temperature_of(Gas(fuel / air), carried / (air + fuel))
    return Exhaust(air, fuel, warm, sum(flow.casing for flow in running))


def exhaust_heat(exhaust: Exhaust, inlet: float) -> float:
    """Return what the exhaust carries away over what the air brought, by their states alone [W].

    Args:
        exhaust: Flows and temperature.
        inlet: Stagnation temperature of the air [K].

    Source: (m_a + m_f) h(T, f) - m_a h(T_0).
    """
    if not exhaust.fuel_flow:
        return 0.0
    return _gained(exhaust, inlet)


def _gained(exhaust: Exhaust, inlet: float) -> float:
    away = (exhaust.air_flow + exhaust.fuel_flow) * enthalpy(_gas(exhaust), exhaust.temperature)
    return away - exhaust.air_flow * enthalpy(AIR, inlet)


def _gas(exhaust: Exhaust) -> Gas:
    return Gas(exhaust.fuel_flow / exhaust.air_flow)
