"""Result of a mission: time histories with units and sources, and energies."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Generic, NamedTuple, TypeVar

import numpy as np

from gearwright.base import (
    Bools,
    Energy,
    Floats,
    Length,
    Marks,
    Mass,
    Origin,
    Quantity,
    Ratio,
    Shown,
    Time,
    frame,
    marks_of,
    si_unit,
    verb,
)
from gearwright.machines import HEATING_VALUE, EngineDeck, MachMap, PropellerMap
from gearwright.mission.plant import DryRun
from gearwright.mission.profile import Paths
from gearwright.sizing import Sizing
from gearwright.spec import GROUND, Mission

# ----------------------------------------------------------------------------------------------------------------------
# What is recorded of a flight: a field per quantity with its unit and, where a law makes it, its source.
# ----------------------------------------------------------------------------------------------------------------------


T = TypeVar("T")

MESH_LOSS = Origin("P μ H_V", "Ohlendorf 1958; Schlenk 1994, or Niemann and Winter 2003; ISO/TR 14179-2")
BEARING_LOSS = Origin("M = μ P d/2, μ = 0.0011", "SKF, constant coefficient")
WINDAGE_LOSS = Origin("n^2.8 R^4.6", "Anderson and Loewenthal, NASA TP-1622")
CHURNING_LOSS = Origin("f_g ν n³ D^5.7", "ISO/TR 14179-1")
MOTOR_LOSS = Origin("k_c T² + k_i ω + k_w ω³ + C", "Larminie and Lowry 2012, eq. 7.23")
BATTERY_LOSS = Origin("R I²", "open-circuit voltage behind a resistance")
TURBINE_FUEL = Origin("Willans line, P ∝ δ_t θ_t^n; or the deck of [engine]", "Saravanamuttoo et al., ch. 8")
EXHAUST_STATE = Origin("(ṁ_a + ṁ_f) h(T, f) = ṁ_a h(T_0) + ṁ_f H − P − Q̇_c", "steady energy of the engine")
EXHAUST_HEAT = Origin("(ṁ_a + ṁ_f) h(T, f) − ṁ_a h(T_0)", "Walsh and Fletcher 2004, F3.26: states of gas and air")
CASING_HEAT = Origin("c ṁ_f H", "engine.casing_loss, an assumption")
TURBINE_HEAT = Origin("exhaust + casing", "heat balance")
WARMTH = Origin("C dT/dt = Q − K T + G T_out", "network of heat, exact over an interval")
_AIR = "ISA, ISO 2533:1975"
_MAP = "propeller map"


@dataclass(frozen=True, kw_only=True)
class History(Generic[T]):
    """Of one gearbox; powers and losses are means of their interval."""

    time: Annotated[T, Quantity("time")]
    """Of the interval's middle, from the start of the mission."""
    duration: Annotated[T, Quantity("time")]
    altitude: Annotated[T, Quantity("altitude")]
    """Pressure altitude."""
    true_airspeed: Annotated[T, Quantity("velocity")]
    mach: Annotated[T, Quantity("ratio"), Origin("V/a", _AIR)]
    air_temperature: Annotated[T, Quantity("absolute_temperature"), Origin("T(h) + ΔT", _AIR)]
    air_density: Annotated[T, Quantity("density"), Origin("p/(R T)", _AIR)]
    propeller_speed: Annotated[T, Quantity("speed")]
    """Mean of the interval."""
    propeller_gain: Annotated[T, Quantity("speed")]
    """Change of the propeller's speed over the interval."""
    propeller_power: Annotated[T, Quantity("power")]
    """Of the propeller's shaft."""
    advance_ratio: Annotated[T, Quantity("ratio"), Origin("J = V/(n D)", _MAP)]
    pitch: Annotated[T | None, Quantity("angle"), Origin("β(J, C_P)", _MAP)]
    """Of the blades; like thrust and compressibility None where powers are schedules."""
    compressibility: Annotated[T | None, Quantity("ratio"), Origin("F_t", "Worobel and Mayo, NASA CR-114399")]
    """Factor on the thrust."""
    thrust: Annotated[T | None, Quantity("force"), Origin("F_t C_T ρ n² D⁴", _MAP)]
    electric_share: Annotated[T, Quantity("ratio"), Origin("P_motors/(P_turbines + P_motors)", "mode or strategy")]
    """As the interval was driven; negative charges."""
    fuel_flow: Annotated[T, Quantity("mass_flow"), TURBINE_FUEL]
    turbine_power: Annotated[T, Quantity("power")]
    """Of all turbines."""
    turbine_available: Annotated[T, Quantity("power"), TURBINE_FUEL]
    """What the turbines could give."""
    air_flow: Annotated[T, Quantity("mass_flow"), Origin("ṁ_0 δ_t θ_t^−½ (i + (1 − i) P/P_core)", "choked turbine")]
    """Through all turbines that run."""
    exhaust_temperature: Annotated[T, Quantity("absolute_temperature"), EXHAUST_STATE]
    """Of their gas, mixed; stagnation. Where none runs, that of the air."""
    exhaust_heat: Annotated[T, Quantity("power"), EXHAUST_HEAT]
    """That leaves with the gas."""
    casing_heat: Annotated[T, Quantity("power"), CASING_HEAT]
    battery_power: Annotated[T, Quantity("power")]
    """Of its chemistry: at the terminals and its own loss."""
    battery_current: Annotated[T, Quantity("current")]
    battery_voltage: Annotated[T, Quantity("voltage"), Origin("U(SoC) − R I", BATTERY_LOSS.source)]
    """At the terminals."""
    state_of_charge: Annotated[T, Quantity("ratio")]
    """At the end of the interval."""
    battery_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    """Of the cells at the end of the interval; None where a mission does not follow it, like that of windings."""
    winding_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    """Of the hottest motor's winding at the end of the interval."""
    mesh_loss: Annotated[T, Quantity("power"), MESH_LOSS]
    bearing_loss: Annotated[T, Quantity("power"), BEARING_LOSS]
    windage_loss: Annotated[T, Quantity("power"), WINDAGE_LOSS]
    churning_loss: Annotated[T, Quantity("power"), CHURNING_LOSS]
    oil_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    """At the end of the interval, like those below; None where a mission does not follow them."""
    gears_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    bearings_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    housing_temperature: Annotated[T | None, Quantity("absolute_temperature"), WARMTH]
    gearbox_heat: Annotated[T, Quantity("power"), Origin("meshes + bearings + windage + churning", "heat balance")]
    motor_loss: Annotated[T, Quantity("power"), MOTOR_LOSS]
    """Motors and inverters, and motors that are dragged without current."""
    battery_loss: Annotated[T, Quantity("power"), BATTERY_LOSS]
    spin_up: Annotated[T, Quantity("power"), Origin("I ω dω/dt", "kinetic energy")]
    """Into everything that turns."""


@dataclass(frozen=True)
class MachineHistory:
    """A machine, with drag and spin-up."""

    power: Annotated[Floats, Quantity("power")]
    """Into the train."""
    speed: Annotated[Floats, Quantity("speed")]
    """Of its shaft, signed."""

    @property
    def torque(self) -> Floats:
        """On its shaft [N m]."""
        return self.power / self.speed


@dataclass(frozen=True)
class NodeHistory:
    """A shaft, or the planets of a stage."""

    speed: Annotated[Floats, Quantity("speed")]
    torque: Annotated[Floats, Quantity("torque"), Origin("½ Σ |T|", "power flow")]
    """That it transmits."""


@dataclass(frozen=True)
class MeshHistory:
    """One single mesh of a row."""

    torque: Annotated[Floats, Quantity("torque"), Origin("z λ", "power flow")]
    """On gear a."""
    force: Annotated[Floats, Quantity("force"), Origin("T/r", "power flow")]
    """Tangential, signed as its torque."""


class Series(NamedTuple):
    """One recorded quantity, as tables, files and figures name it."""

    name: str
    """Such as ``propeller_power``."""
    values: Floats
    """One per interval, in SI."""
    marks: Marks
    """Dimension and origin."""


def marked_series(history: History[Floats]) -> Iterator[Series]:
    """Yield every quantity that is recorded, with its marks.

    Args:
        history: Of a flight.
    """
    for name, marks in marks_of(History).items():
        values = getattr(history, name)
        if values is not None:
            yield Series(name, values, marks)


# ----------------------------------------------------------------------------------------------------------------------
# A flown mission: histories over its intervals, and the energies that they add up to.
# ----------------------------------------------------------------------------------------------------------------------


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
