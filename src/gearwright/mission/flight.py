"""A flown mission: histories over its intervals, and the energies that they add up to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.machines import HEATING_VALUE, EngineDeck, MachMap, PropellerMap
from gearwright.mission.history import (
    BATTERY_LOSS,
    BEARING_LOSS,
    CASING_HEAT,
    CHURNING_LOSS,
    EXHAUST_HEAT,
    MESH_LOSS,
    MOTOR_LOSS,
    TURBINE_HEAT,
    WINDAGE_LOSS,
    History,
    MachineHistory,
    MeshHistory,
    NodeHistory,
    Series,
    marked_series,
)
from gearwright.mission.moments import Paths
from gearwright.mission.plant import DryRun
from gearwright.showing import Shown, frame
from gearwright.sizing import Sizing
from gearwright.spec import GROUND, Mission
from gearwright.units import Energy, Length, Mass, Origin, Quantity, Ratio, Time, marks_of, si_unit
from gearwright.verbs import verb


@dataclass(frozen=True)
class Balance:
    """Where the energy of one gearbox came from and where it went."""

    fuel: Energy
    """Chemical energy of the fuel [J]."""
    battery: Energy
    """Taken from the battery's store, by its state of charge [J]."""
    propeller: Energy
    """Work of the propeller's shaft [J]."""
    consumers: Energy
    """Work of what else takes power: accessories, tail rotors, generators, loads [J]."""
    turbine_heat: Annotated[Energy, TURBINE_HEAT]
    """That leaves the turbines beside their shafts, by the states of their gas [J]."""
    exhaust_heat: Annotated[Energy, EXHAUST_HEAT]
    """Of it, with the exhaust [J]."""
    casing_heat: Annotated[Energy, CASING_HEAT]
    """Of it, through casing and oil [J]."""
    mesh_loss: Annotated[Energy, MESH_LOSS]
    """[J]"""
    bearing_loss: Annotated[Energy, BEARING_LOSS]
    """[J]"""
    windage_loss: Annotated[Energy, WINDAGE_LOSS]
    """Gears in the oil mist [J]."""
    churning_loss: Annotated[Energy, CHURNING_LOSS]
    """Gears that dip into the oil [J]."""
    motor_loss: Annotated[Energy, MOTOR_LOSS]
    """Motors and inverters, and motors that are dragged without current [J]."""
    battery_loss: Annotated[Energy, BATTERY_LOSS]
    """[J]"""
    stored: Energy
    """Gain of kinetic energy of everything that turns, by the speeds at start and end [J]."""

    @property
    def gearbox_loss(self) -> Energy:
        """Meshes, bearings, windage and churning: what heats the oil [J]."""
        return self.mesh_loss + self.bearing_loss + self.windage_loss + self.churning_loss

    @property
    def residual(self) -> Ratio:
        """What is missing between two books, as a part of what came in [-].

        One book has what stores lose: fuel by its mass, charge by its state. The other has what work, losses and the
        states of the gas add up to; neither is made from the other.
        """
        spent = self.propeller + self.consumers + self.turbine_heat + self.gearbox_loss
        spent += self.motor_loss + self.battery_loss + self.stored
        return abs(self.fuel + self.battery - spent) / (self.fuel + abs(self.battery))

    @property
    def came_in(self) -> Energy:
        """Fuel, charge, what slows down, and the air where it drives a propeller [J]."""
        return self.fuel + sum(max(energy, 0.0) for energy in (self.battery, -self.stored, -self.propeller))


@dataclass(frozen=True)
class PackWear:
    """What a flight takes from a battery whose cells are followed."""

    mass: Mass
    """Of the pack, by its specific energy [kg]."""
    throughput: Annotated[float, Quantity("number")]
    """Charge in and out [C]."""
    cycles: Annotated[float, Quantity("number"), Origin("∫|I| dt/(2 Q)", "definition of a full cycle")]
    """Equivalent full cycles [-]."""
    worn: Annotated[Ratio, Origin("2^((T − 25 °C)/ΔT) (cycles/cycle life + time/calendar life)", "Miner's sum")]
    """Part of its life that is spent [-]; 0 where a mission states no lives."""


@dataclass(frozen=True, repr=False)
class Flight(Shown):
    """Histories of one gearbox over a mission; every array has one value per interval, shape (n,)."""

    mission: Mission
    sizing: Sizing
    phase: tuple[str, ...]
    """Phase of each interval."""
    history: History[Floats]
    """Air, propeller, machines, battery and losses."""
    oil_outlet: Annotated[Floats, Quantity("absolute_temperature"), Origin("T_in + ΔT P/P_max", "heat balance")]
    """Of the oil behind the gearbox [K]."""
    nodes: Mapping[str, NodeHistory]
    """Shaft, or planets of a stage -> speed and torque."""
    machines: Mapping[str, MachineHistory]
    """Machine without the propeller -> power and speed."""
    meshes: Mapping[str, MeshHistory]
    """Mesh row -> torque and force."""
    balance: Balance
    pack: PackWear | None
    """None for a plain battery, or none."""
    oil_flow: float
    """Through the gearbox [m³/s]."""
    cooler_conductance: float
    """U A that cools the oil at its hottest [W/K]."""
    dry: DryRun | None
    """Without oil, from the end of a phase that the mission names."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""
    propeller_map: PropellerMap | MachMap | None
    """As read; None where powers are schedules."""
    engine_deck: EngineDeck | None
    """Of its turbines, at their size; None: a Willans line."""
    paths: Paths
    """Phase -> path, where an aircraft flies it."""

    @property
    def duration(self) -> Time:
        """Of the whole mission [s]."""
        return float(self.history.duration.sum())

    @property
    def fuel(self) -> Mass:
        """Burnt by one gearbox's turbines [kg]."""
        return float((self.history.fuel_flow * self.history.duration).sum())

    @property
    def distance(self) -> Length:
        """Flown through the air [m]."""
        return float((self.history.true_airspeed * self.history.duration).sum())

    @property
    def hottest_oil(self) -> float:
        """Temperature of the oil behind the gearbox where it is hottest [K]."""
        return float(self.oil_outlet.max())

    @property
    def hottest_supply(self) -> float:
        """Temperature of the oil that reaches teeth and bearings where it is hottest [K]."""
        followed = self.history.oil_temperature
        return self.mission.oil.inlet_temperature_k if followed is None else float(followed.max())

    @property
    def has_battery(self) -> bool:
        """True where a battery flies: the mission has one, and the design a motor."""
        return self.mission.battery is not None and bool(self.sizing.design.motors)

    def speed(self, node: str) -> Floats:
        """Return the speed of a node of the train, also of the ground, per interval [rad/s].

        Args:
            node: Shaft, planets of a stage, or ``ground``.
        """
        return self.nodes[node].speed if node != GROUND else np.zeros(len(self.phase))

    def efficiency(self, counted: Bools | None = None) -> Ratio:
        """Return the efficiency of the gearbox over some intervals [-]; left out: over all of them.

        Args:
            counted: True for the intervals that count.
        """
        taken, given = self.passed()
        weights = self.history.duration if counted is None else np.where(counted, self.history.duration, 0.0)
        return float((given * weights).sum() / (taken * weights).sum())

    def to_dataframe(self) -> Any:
        """Return a pandas ``DataFrame``: everything recorded, in SI, over time; units in ``attrs["units"]``."""
        series: dict[str, tuple[Iterable[Any], str]] = {
            entry.name: (entry.values, si_unit(entry.marks.dimension)) for entry in flight_series(self)
        }
        return frame({"phase": (self.phase, ""), **series}, "time")

    def passed(self) -> tuple[Floats, Floats]:
        """Return what the gearbox takes and gives in every interval [W]; a propeller that the air drives gives.

        What accessories and other machines take is given, like the propeller's power.
        """
        taken = consumed(self.sizing, self.machines, self.history.time)
        work, loss = self.history.propeller_power + taken, self.history.gearbox_heat
        return np.maximum(work + loss, -work), np.maximum(np.maximum(work, -work - loss), 0.0)


def consumed(sizing: Sizing, machines: Mapping[str, MachineHistory], time: Floats) -> Floats:
    """Return the power that accessories, tail rotors, generators and loads take in every interval [W].

    Args:
        sizing: What flew.
        machines: Its machines without the propeller.
        time: Of the intervals [s].
    """
    drives = {name: machine.drives for name, machine in sizing.design.machines.items()}
    taken = [-history.power for name, history in machines.items() if not drives[name]]
    return sum(taken, np.zeros_like(time))


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


def _summary(flight: Flight, name: str, within: Bools) -> PhaseSummary:
    history = flight.history

    def total(power: Floats) -> float:
        return float((power * history.duration)[within].sum())

    return PhaseSummary(
        name=name,
        duration=float(history.duration[within].sum()),
        fuel=total(history.fuel_flow),
        battery=total(history.battery_power),
        propeller=total(history.propeller_power),
        loss=total(history.gearbox_heat),
        efficiency=flight.efficiency(within),
    )


@verb
def flight_series(flight: Flight) -> tuple[Series, ...]:
    """Return everything that is recorded of a flight, as tables, files and figures name it, with unit and source.

    Args:
        flight: As flown.
    """
    oil = Series("oil_outlet", flight.oil_outlet, marks_of(Flight)["oil_outlet"])
    return (*marked_series(flight.history), oil, *_series_of_parts(flight))


def _series_of_parts(flight: Flight) -> Iterator[Series]:
    for group, field, records in (
        ("speed", "speed", flight.nodes),
        ("torque", "torque", flight.nodes),
        ("power", "power", flight.machines),
        ("force", "force", flight.meshes),
    ):
        for name, record in records.items():
            yield Series(f"{group}.{name}", getattr(record, field), marks_of(type(record))[field])


def fuel_energy(mass: float) -> float:
    """Return the chemical energy of fuel [J].

    Args:
        mass: [kg].
    """
    return mass * HEATING_VALUE
