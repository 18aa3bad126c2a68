"""Intervals become a flight: histories by name, oil, and the balance of energies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.machines import PropellerMap, stored_energy
from gearwright.mission.flight import Balance, Flight, fuel_energy
from gearwright.mission.gearbox import Array, Gearbox, Point
from gearwright.mission.supply import Supply
from gearwright.parts.losses import cooler_conductance, oil_flow
from gearwright.spec import Mission

_LEAST_COOLING = 1.0
"""By how much the oil in a cooler must be warmer than the air [K]."""


class Interval(NamedTuple):
    """One flown interval."""

    phase: str
    """Name of its phase."""
    values: Mapping[str, float]
    """What is recorded, by name."""
    point: Point
    """Of the gearbox."""


class Flown(NamedTuple):
    """What flew."""

    gearbox: Gearbox
    mission: Mission
    supply: Supply


def collect(flown: Flown, intervals: Sequence[Interval], chart: PropellerMap | None) -> Flight:
    """Return the flight of its intervals.

    Args:
        flown: Gearbox, mission and machines.
        intervals: In their order.
        chart: Map of the propeller.
    """
    gearbox, mission, _ = flown
    history = {name: np.array([interval.values[name] for interval in intervals]) for name in intervals[0].values}
    powers = {name: history.pop(f"power.{name}") for name in gearbox.machines}
    heat = history["gearbox_heat"]
    history["oil_outlet"] = mission.oil.inlet_temperature_k + mission.oil.rise_k * heat / heat.max()
    train = gearbox.sizing.train
    speeds, shafts, meshes = (
        np.array([getattr(interval.point, name) for interval in intervals])
        for name in ("speeds", "shaft_torques", "mesh_torques")
    )
    return Flight(
        mission=mission,
        sizing=gearbox.sizing,
        phase=tuple(interval.phase for interval in intervals),
        history=history,
        speeds=dict(zip(train.nodes, speeds.T, strict=True)),
        shaft_torques=dict(zip(train.nodes, shafts.T, strict=True)),
        machine_powers=powers,
        mesh_torques={mesh.name: row for mesh, row in zip(train.meshes, meshes.T, strict=True)},
        mesh_forces={mesh.name: row for mesh, row in zip(train.meshes, meshes.T / gearbox.radii[:, None], strict=True)},
        balance=_balance(flown, history),
        oil_flow=oil_flow(float(heat.max()), mission.oil.rise_k),
        cooler_conductance=_cooler(mission, history, heat),
        inertia=gearbox.inertia,
        propeller_map=chart,
    )


def _cooler(mission: Mission, history: Mapping[str, Array], heat: Array) -> float:
    """The largest conductance that any interval needs [W/K]."""
    oil = 0.5 * (mission.oil.inlet_temperature_k + history["oil_outlet"])
    if float((oil - history["air_temperature"]).min()) < _LEAST_COOLING:
        message = (
            f"{mission.oil.inlet_temperature_k:g} K: the air, of up to {float(history['air_temperature'].max()):.4g} K,"
            " does not cool this oil; let it be warmer"
        )
        raise DesignError([Problem("oil.inlet_temperature_k", message)])
    rows = zip(heat, oil, history["air_temperature"], strict=True)
    return max(cooler_conductance(float(power), float(warm), float(cold)) for power, warm, cold in rows)


def _balance(flown: Flown, history: Mapping[str, Array]) -> Balance:
    gearbox, mission, supply = flown

    def total(name: str) -> float:
        return float((history[name] * history["duration"]).sum())

    first = next(iter(mission.phases.values())).propeller_speed
    last = float(history["propeller_speed"][-1] + 0.5 * history["propeller_gain"][-1])
    fuel = fuel_energy(total("fuel_flow"))
    return Balance(
        fuel=fuel,
        battery=_drawn(mission, supply, float(history["state_of_charge"][-1])),
        propeller=total("propeller_power"),
        turbine_heat=fuel - total("turbine_power"),
        mesh_loss=total("mesh_loss"),
        bearing_loss=total("bearing_loss"),
        windage_loss=total("windage_loss"),
        churning_loss=total("churning_loss"),
        motor_loss=total("motor_loss"),
        battery_loss=total("battery_loss"),
        stored=0.5 * gearbox.inertia * (last**2 - first**2),
    )


def _drawn(mission: Mission, supply: Supply, end: float) -> float:
    """What the battery's store has lost [J]: its state, and not the sum of what it gave."""
    if supply.battery is None or mission.battery is None:
        return 0.0
    return stored_energy(supply.battery, mission.battery.start_charge) - stored_energy(supply.battery, end)
