"""A flown mission: histories over its intervals, and the energies that they add up to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearwright.machines import HEATING_VALUE, PropellerMap
from gearwright.sizing import Sizing
from gearwright.spec import Mission
from gearwright.units import Energy, Length, Mass, Ratio, Time
from gearwright.verbs import verb

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Balance:
    """Where the energy of one gearbox came from and where it went."""

    fuel: Energy
    """Chemical energy of the fuel [J]."""
    battery: Energy
    """Taken from the battery's store, by its state of charge [J]."""
    propeller: Energy
    """Work of the propeller's shaft [J]."""
    turbine_heat: Energy
    """Of the fuel, what does not reach the shaft [J]."""
    mesh_loss: Energy
    """[J]"""
    bearing_loss: Energy
    """[J]"""
    windage_loss: Energy
    """Gears in the oil mist [J]."""
    churning_loss: Energy
    """Gears that dip into the oil [J]."""
    motor_loss: Energy
    """Motors and inverters, and motors that are dragged without current [J]."""
    battery_loss: Energy
    """[J]"""
    stored: Energy
    """Gain of kinetic energy of everything that turns, by the speeds at start and end [J]."""

    @property
    def gearbox_loss(self) -> Energy:
        """Meshes, bearings, windage and churning: what heats the oil [J]."""
        return self.mesh_loss + self.bearing_loss + self.windage_loss + self.churning_loss

    @property
    def residual(self) -> Ratio:
        """What is missing, as a part of what came in [-]."""
        spent = self.propeller + self.turbine_heat + self.gearbox_loss
        spent += self.motor_loss + self.battery_loss + self.stored
        return abs(self.fuel + self.battery - spent) / (self.fuel + abs(self.battery))

    @property
    def came_in(self) -> Energy:
        """Fuel, charge, what slows down, and the air where it drives a propeller [J]."""
        return self.fuel + sum(max(energy, 0.0) for energy in (self.battery, -self.stored, -self.propeller))


@dataclass(frozen=True)
class Flight:
    """Histories of one gearbox over a mission; every array has one value per interval, shape (n,)."""

    mission: Mission
    sizing: Sizing
    phase: tuple[str, ...]
    """Phase of each interval."""
    history: Mapping[str, Array]
    """Name -> values in SI: time, duration, altitude, air_temperature, air_density, true_airspeed, mach,
    advance_ratio, pitch, thrust, propeller_power, propeller_speed, fuel_flow, turbine_available, state_of_charge (at
    the end of the interval), battery_current, battery_voltage, mesh_loss, bearing_loss, windage_loss, churning_loss,
    gearbox_heat (their sum), motor_loss, battery_loss, oil_outlet."""
    speeds: Mapping[str, Array]
    """Node of the train -> speed [rad/s]."""
    shaft_torques: Mapping[str, Array]
    """Node of the train -> torque that it transmits [N m]."""
    machine_powers: Mapping[str, Array]
    """Machine -> power into the train, with drag and spin-up [W]."""
    mesh_torques: Mapping[str, Array]
    """Mesh row -> torque on gear a of one single mesh [N m]."""
    mesh_forces: Mapping[str, Array]
    """Mesh row -> tangential force of one single mesh, signed as its torque [N]."""
    balance: Balance
    oil_flow: float
    """Through the gearbox [m³/s]."""
    cooler_conductance: float
    """U A that cools the oil at its hottest [W/K]."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""
    propeller_map: PropellerMap | None
    """As read; None where powers are schedules."""

    @property
    def duration(self) -> Time:
        """Of the whole mission [s]."""
        return float(self.history["duration"].sum())

    @property
    def fuel(self) -> Mass:
        """Burnt by one gearbox's turbines [kg]."""
        return float((self.history["fuel_flow"] * self.history["duration"]).sum())

    @property
    def distance(self) -> Length:
        """Flown through the air [m]."""
        return float((self.history["true_airspeed"] * self.history["duration"]).sum())

    @property
    def hottest_oil(self) -> float:
        """Temperature of the oil behind the gearbox where it is hottest [K]."""
        return float(self.history["oil_outlet"].max())

    @property
    def has_battery(self) -> bool:
        """True where a battery flies: the mission has one, and the design a motor."""
        return self.mission.battery is not None and bool(self.sizing.design.motors)

    def efficiency(self, counted: NDArray[np.bool_] | None = None) -> Ratio:
        """Return the efficiency of the gearbox over some intervals [-]; left out: over all of them.

        Args:
            counted: True for the intervals that count.
        """
        taken, given = self.passed()
        weights = self.history["duration"] if counted is None else np.where(counted, self.history["duration"], 0.0)
        return float((given * weights).sum() / (taken * weights).sum())

    def passed(self) -> tuple[Array, Array]:
        """Return what the gearbox takes and gives in every interval [W]; a propeller that the air drives gives."""
        work, loss = self.history["propeller_power"], self.history["gearbox_heat"]
        return np.maximum(work + loss, -work), np.maximum(np.maximum(work, -work - loss), 0.0)


@dataclass(frozen=True)
class PhaseSummary:
    """One phase of a flight."""

    name: str
    duration: Time
    """[s]"""
    fuel: Mass
    """[kg]"""
    battery: Energy
    """From the battery's terminals and its own loss [J]; negative charges it."""
    propeller: Energy
    """Work of the propeller's shaft [J]."""
    loss: Energy
    """Of the gearbox: meshes, bearings, windage, churning [J]."""
    efficiency: Ratio
    """Of the gearbox: what it gives over what it takes [-]."""


@verb
def phase_summaries(flight: Flight) -> tuple[PhaseSummary, ...]:
    """Return fuel, energies and efficiency of each phase.

    Args:
        flight: As flown.
    """
    names = np.array(flight.phase)
    return tuple(_summary(flight, name, names == name) for name in flight.mission.phases)


def _summary(flight: Flight, name: str, within: NDArray[np.bool_]) -> PhaseSummary:
    def total(key: str) -> float:
        return float((flight.history[key] * flight.history["duration"])[within].sum())

    return PhaseSummary(
        name=name,
        duration=float(flight.history["duration"][within].sum()),
        fuel=total("fuel_flow"),
        battery=total("battery_power"),
        propeller=total("propeller_power"),
        loss=total("gearbox_heat"),
        efficiency=flight.efficiency(within),
    )


def fuel_energy(mass: float) -> float:
    """Return the chemical energy of fuel [J].

    Args:
        mass: [kg].
    """
    return mass * HEATING_VALUE
