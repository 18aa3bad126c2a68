"""What is recorded of a flight: a field per quantity with its unit and, where a law makes it, its source.

One declaration serves the interval that is being flown, whose fields are numbers, and the flight, whose fields are
arrays with one value per interval.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from typing import Annotated, Any, Generic, NamedTuple, TypeVar

import numpy as np

from gearwright.arrays import Floats
from gearwright.units import Marks, Origin, Quantity, marks_of

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


def stacked(history: Sequence[History[float]]) -> History[Floats]:
    """Return the histories of intervals as arrays.

    Args:
        history: Of each interval, in their order.
    """
    columns = {field.name: [getattr(interval, field.name) for interval in history] for field in fields(History)}
    arrays: dict[str, Any] = {name: None if None in values else np.array(values) for name, values in columns.items()}
    return History(**arrays)


def marked_series(history: History[Floats]) -> Iterator[Series]:
    """Yield every quantity that is recorded, with its marks.

    Args:
        history: Of a flight.
    """
    for name, marks in marks_of(History).items():
        values = getattr(history, name)
        if values is not None:
            yield Series(name, values, marks)
