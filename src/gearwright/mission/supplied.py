"""The machines of a design as the rules of a mission make them fly."""

from __future__ import annotations

from gearwright.machines import Engine, EngineDeck, MotorLosses, rated_losses, shared_losses
from gearwright.machines.power import Breathing
from gearwright.mission.plant import pack_of
from gearwright.mission.supply import Supply
from gearwright.sizing import Sizing
from gearwright.spec import EngineRules, Machine, Mission, Motor, MotorRules
from gearwright.spec.design import allowed_for
from gearwright.units import KWH

SPECIFIC_POWER = 250e3
"""Power over air flow where a mission does not say it [J/kg]; an assumption."""


def supply_of(sizing: Sizing, mission: Mission, deck: EngineDeck | None) -> Supply:
    """Return the machines of a design as the mission's rules make them fly.

    Args:
        sizing: With its design.
        mission: With the rules of engine, motor and battery.
        deck: Of the turbines, as its file has it; None: a Willans line.
    """
    rules, motor, deck = mission.engine, mission.motor, _scaled(deck, mission.engine)
    core, burnt = (None, rules.fuel_kg_kwh / KWH) if deck is None else _of_deck(deck)
    engines = {
        name: Engine(
            (most := allowed_for(turbine, None)).power or turbine.power,
            core or rules.thermal_power or most.power or turbine.power,
            max(most.torque or 0.0, (most.power or turbine.power) / turbine.speed * (1.0 + _TOLERANCE)),
            burnt,
            rules.idle_fuel,
            rules.temperature_exponent,
            rules.hot_exponent,
        )
        for name, turbine in sizing.design.turbines.items()
    }
    motors = {name: _losses(machine, motor) for name, machine in sizing.design.motors.items()}
    ratings = {name: turbine.power for name, turbine in sizing.design.turbines.items()}
    ratings |= {name: machine.power for name, machine in sizing.design.motors.items()}
    breathing = {
        name: Breathing(rules.air_flow_kg_s or engine.thermal_power / SPECIFIC_POWER, rules.idle_air, rules.casing_loss)
        for name, engine in engines.items()
    }
    pack = pack_of(mission.battery) if mission.battery and motors else None
    return Supply(engines, motors, pack, ratings, breathing, mission.motor.heat, deck)


def _scaled(deck: EngineDeck | None, rules: EngineRules) -> EngineDeck | None:
    """Return a deck of the thermal power that a mission asks for."""
    if deck is None or rules.thermal_power is None:
        return deck
    return deck.scaled(rules.thermal_power / deck.reference[0])


def _of_deck(deck: EngineDeck) -> tuple[float, float]:
    """Return the thermal power of a deck [W], and the specific fuel consumption there [kg/J]."""
    power, fuel = deck.reference
    return power, fuel / power


def _losses(machine: Motor, rules: MotorRules) -> MotorLosses:
    overload = _overload(machine, rules.overload)
    if rules.loss_shares is None:
        return rated_losses(machine.power, machine.speed, efficiency=rules.efficiency, overload=overload)
    lost = machine.power * (1.0 / rules.efficiency - 1.0)
    return shared_losses(machine.power, machine.speed, lost=lost, shares=rules.loss_shares, overload=overload)


def _overload(machine: Machine, said: float) -> float:
    """Return the largest power or torque of a motor over the rated one, by the mission or for a time by its limits."""
    most, rated = allowed_for(machine, None), machine.rating or 1.0
    torque = (most.torque or 0.0) * (machine.asked_speed or 0.0)
    return max(said, (most.power or 0.0) / rated, torque / rated)


_TOLERANCE = 0.05
"""Part by which a torque may exceed power over rated speed, as teeth let a speed yield by so much [-]."""
