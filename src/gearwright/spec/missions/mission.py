"""The mission file: what the aircraft does with one gearbox, phase by phase."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.showing import Shown
from gearwright.spec.design import FrictionName, SealName, TorqueName, WindageName
from gearwright.spec.missions.aircraft import Aircraft, PhaseKind, Setting
from gearwright.spec.missions.rotorcraft import Rotorcraft
from gearwright.spec.missions.windows import GovernorRules, WindowRules
from gearwright.spec.power import CellRules, OilNetworkRules, SpoolRules, StrategyRules, WindingRules
from gearwright.spec.record import Record
from gearwright.units import Angle, Distance, Energy, Length, Power, Ratio, Speed, Time, Velocity

NO_MAP = "none"
"""Name that stands for no propeller map."""
Kind = Literal["deep-groove", "cylindrical", "taper", "four-point"]
"""Kinds of rolling bearing in the catalogue."""


class Phase(Record):
    """One stretch of the mission: a speed law from the altitude of the last phase to its own."""

    altitude: Length = Field(ge=0, le=20e3, description="Pressure altitude at its end")
    from_altitude: Length | None = Field(
        None, ge=0, le=20e3, description="Pressure altitude at its start; left out: where the last phase ended"
    )
    cas: Velocity | None = Field(None, ge=0, le=340, description="Calibrated airspeed; one of cas, tas, mach")
    tas: Velocity | None = Field(None, ge=0, le=340, description="True airspeed; one of cas, tas, mach")
    mach: Ratio | None = Field(None, ge=0, lt=1, description="Mach number; one of cas, tas, mach")
    from_cas: Velocity | None = Field(
        None, ge=0, le=340, description="Calibrated airspeed at its start; the true one then changes linearly"
    )
    from_tas: Velocity | None = Field(None, ge=0, le=340, description="The same as true airspeed")
    duration: Time | None = Field(None, ge=0.01, le=1e6, description="Duration; or rate_of_climb")
    rate_of_climb: Velocity | None = Field(
        None, ge=-100, le=100, description="Rate of climb, negative in descent; or duration"
    )
    mode: Literal["conventional", "hybrid", "electric", "rated"] = Field(
        "conventional", description="Who drives: turbines, both, motors, or every machine by its part of the ratings"
    )
    strategy: str | None = Field(None, description="One of [strategies], in place of mode and electric_share")
    electric_share: Ratio | None = Field(
        None, ge=-0.9, le=1, description="Motors' part of the machines' power in hybrid mode; negative charges"
    )
    power: Power | None = Field(
        None, gt=0, le=1e9, description="Power of all machines of a gearbox; or pitch, or the aircraft's need"
    )
    end_power: Power | None = Field(None, gt=0, le=1e9, description="The same at its end, where it changes linearly")
    pitch: Angle | None = Field(None, ge=-0.5, le=1.6, description="Blade angle that is held, as at a stop")
    propeller_speed: Speed = Field(gt=0.1, le=2e4, description="Speed of the propeller")
    ramp: Time = Field(10.0, ge=0.01, le=1e4, description="Time in which the propeller comes to this speed")
    engines: int | None = Field(None, ge=1, le=20, description="Gearboxes that work; left out: all of them")
    inoperative: list[str] = Field(default_factory=list, description="Turbines and motors of a gearbox that are out")
    kind: PhaseKind | None = Field(
        None, description="What the aircraft does; left out: altitude, speed and power as they are written"
    )
    distance: Distance | None = Field(None, ge=1, le=2e7, description="Flown in a cruise; or duration")
    path_angle: Angle | None = Field(
        None, ge=-0.5, le=0.5, description="Angle of the path, negative down; or rate_of_climb, or power"
    )
    flaps: Setting | None = Field(
        None, description="Left out: take-off in take-off, landing in approach and landing, else clean"
    )
    end_speed: Velocity | None = Field(
        None, ge=0, le=340, description="True airspeed at which a landing's roll ends; left out: 5 m/s"
    )
    extra_drag: Ratio = Field(
        0.0, ge=0, le=1, description="C_D0 beyond that of flaps and gear: propellers that stand or windmill, ice, doors"
    )
    reserve: bool = Field(False, description="Flown for its fuel, which is a reserve and no part of the block fuel")


class EngineRules(Record):
    """The turbine in flight, where it is more than its rating; all turbines of a gearbox are alike."""

    thermal_power: Power | None = Field(
        None, gt=0, le=1e9, description="Sea-level power of the core; left out: the rated power"
    )
    fuel_kg_kwh: float = Field(0.28, gt=0, le=2, description="Specific fuel consumption at thermal power")
    idle_fuel: Ratio = Field(0.2, ge=0, lt=1, description="Part of that fuel flow that burns without power")
    contingency: Ratio = Field(
        1.0, ge=1, le=1.5, description="Rating over the rated power and torque while an engine is out"
    )
    temperature_exponent: float = Field(
        -2.5, ge=-5, le=2, description="n of P ∝ δ_t θ_t^n, where the air that comes in has 15 °C at most"
    )
    hot_exponent: float = Field(-3.9, ge=-8, le=2, description="n where it is warmer")
    air_flow_kg_s: float | None = Field(
        None, gt=0, le=1e4, description="Air at thermal power at sea level; left out: that power over 250 kJ/kg"
    )
    idle_air: Ratio = Field(0.5, gt=0, le=1, description="Part of that air flow that flows without power")
    casing_loss: Ratio = Field(
        0.01, ge=0, lt=0.3, description="Part of the fuel's heat that leaves through casing and oil"
    )
    deck: str | None = Field(
        None, description="CSV file of power and fuel over altitude and Mach number; thermal_power then scales it"
    )
    spool: SpoolRules | None = Field(
        None, description="Gas generator, for power slams in windows; left out: they follow a lag"
    )


class MotorRules(Record):
    """The motors in flight."""

    efficiency: Ratio = Field(0.95, gt=0.5, lt=1, description="At the rated point, with inverter")
    overload: Ratio = Field(1.0, ge=1, le=3, description="Torque and power limits over the ratings")
    loss_shares: list[float] | None = Field(
        None, min_length=6, max_length=6,
        description="Parts of the rated loss: copper, hysteresis, eddy, windage, stray, constant; sum 1;"
        " left out: 0.5, 0.3, 0, 0.1, 0, 0.1",
    )  # fmt: skip
    heat: WindingRules | None = Field(None, description="How they warm up; left out: not followed")


class BatteryRules(Record):
    """The battery of one gearbox's motors."""

    energy: Energy = Field(ge=1e3, le=1e12, description="Open-circuit energy from full to no charge")
    full_voltage_v: float = Field(840.0, ge=1, le=1e5, description="Open-circuit voltage when full")
    empty_voltage_v: float = Field(620.0, ge=1, le=1e5, description="Open-circuit voltage at no charge")
    resistance_ohm: float = Field(0.01, ge=0, le=100, description="Internal resistance")
    highest_c_rate: float = Field(4.0, gt=0, le=100, description="Highest current over capacity, 1/h")
    start_charge: Ratio = Field(0.95, ge=0, le=1, description="State of charge at the start")
    minimum_charge: Ratio = Field(0.1, ge=0, lt=1, description="State of charge that must remain")
    cells: CellRules | None = Field(None, description="Equivalent circuit, warmth, ageing; left out: a line and R")


class OilRules(Record):
    """The oil that the losses heat."""

    inlet_temperature_k: float = Field(353.15, ge=233, le=450, description="Of the oil into the gearbox")
    rise_k: float = Field(25.0, gt=0, le=150, description="Of its temperature at the greatest heat: sets the flow")
    roughness: Length | None = Field(
        None, ge=1e-8, le=1e-4, description="R_a of the flanks; left out: that of the design's [losses]"
    )
    friction: FrictionName | None = Field(
        None,
        description="Friction of the teeth: Schlenk, Niemann and Winter, ISO/TR 14179-1, or Anderson and Loewenthal;"
        " left out: that of the design's [losses]",
    )
    bearings: TorqueName | None = Field(
        None, description="Friction of bearings; left out: that of the design's [losses]"
    )
    windage: WindageName | None = Field(None, description="Windage of gears; left out: that of the design's [losses]")
    seals: SealName | None = Field(None, description="Friction of seals; left out: that of the design's [losses]")
    dip: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Gear -> part of it that dips into an oil bath, 0 to 1: it churns; left out: as in the design",
    )
    network: OilNetworkRules | None = Field(
        None, description="Temperatures of oil, gears, bearings and housing; left out: the oil is as warm as stated"
    )


class GearLifeRules(Record):
    """The steel of gears that the design does not rate by ISO 6336, for the damage of a flight."""

    steel: str | None = Field(
        None, description="Class in the table of ISO 6336-5; left out: that of the design's material"
    )
    grade: Literal["ML", "MQ", "ME"] | None = Field(
        None, description="Material quality; left out: that of the material, MQ for another class"
    )
    hardness_hv: float | None = Field(
        None, ge=100, le=1000, description="Surface hardness; left out: that of the material, 700 for another class"
    )
    flank_class: int = Field(5, ge=1, le=11, description="Flank tolerance class of ISO 1328-1")


class BearingLifeRules(Record):
    """How bearings are chosen from the catalogue where the design names none."""

    life: Time = Field(ge=3600, le=1e10, description="Basic rating life that they must reach, in flight")
    kind: Kind = Field("cylindrical", description="Of bearings without axial force that the design leaves open")
    thrust_kind: Kind = Field("deep-groove", description="Of bearings with axial force that the design leaves open")
    side_by_side: int = Field(1, ge=1, le=4, description="Equal bearings that share a seat")
    static_safety: Ratio = Field(1.5, gt=0, le=20, description="Minimum C_0 over the largest load")
    reliability: Ratio = Field(0.9, ge=0.9, le=0.999, description="Part of the bearings that reach the life")


class Mission(Shown, Record):
    """A mission as its user wrote it."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the mission")
    description: str = Field("", description="Where it comes from")
    engines: int = Field(1, ge=1, le=20, description="Number of gearboxes with propellers on the aircraft")
    isa_offset_k: float = Field(0.0, ge=-60, le=60, description="Temperature above the standard atmosphere")
    step: Time = Field(10.0, ge=0.01, le=600, description="Longest interval")
    propeller_map: str = Field("6-blades-af115", description="Shipped map, a CSV file, or none: powers are schedules")
    engine: EngineRules = Field(default_factory=EngineRules, description="Turbine in flight")
    motor: MotorRules = Field(default_factory=MotorRules, description="Motors in flight")
    battery: BatteryRules | None = Field(None, description="Battery of one gearbox")
    aircraft: Aircraft | None = Field(None, description="For phases without power and pitch")
    rotorcraft: Rotorcraft | None = Field(None, description="For phases of a helicopter without power")
    oil: OilRules = Field(default_factory=OilRules, description="Oil of one gearbox")
    gears: GearLifeRules = Field(default_factory=GearLifeRules, description="Steel, for damage and life")
    bearings: BearingLifeRules | None = Field(
        None, description="Choose bearings for a life; left out: only those that the design names are known"
    )
    strategies: dict[str, StrategyRules] = Field(
        default_factory=dict, description="How turbines and motors divide power, by name, for phases"
    )
    phases: dict[str, Phase] = Field(min_length=1, description="Phases in their order")
    governor: GovernorRules = Field(default_factory=GovernorRules, description="Of the propeller, in windows")
    windows: dict[str, WindowRules] = Field(default_factory=dict, description="Stretches flown dynamically")


def engine_out(mission: Mission, phase: Phase) -> bool:
    """Return whether a phase flies with a gearbox or a machine that does not work.

    Args:
        mission: With the number of gearboxes.
        phase: Of it.
    """
    return bool(phase.inoperative) or (phase.engines or mission.engines) < mission.engines
