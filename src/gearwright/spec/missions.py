"""Mission files: phases, aircraft or rotorcraft, power plant, heat and event windows.

The checks of a whole mission and its reader are in `spec/flying`.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from typing import Literal

from pydantic import Field

from gearwright.base import (
    Angle,
    Area,
    Distance,
    Energy,
    Inertia,
    Length,
    Mass,
    Power,
    Problem,
    Ratio,
    Shown,
    Speed,
    Time,
    Torque,
    Velocity,
    near,
)
from gearwright.spec.design import FrictionName, SealName, TorqueName, WindageName
from gearwright.spec.record import Record

# ----------------------------------------------------------------------------------------------------------------------
# The aircraft of a mission: a point mass with a drag polar, flaps, wheels and fuel.
# ----------------------------------------------------------------------------------------------------------------------


Setting = Literal["clean", "take-off", "landing"]
"""Of flaps and gear."""
PhaseKind = Literal[
    "taxi", "take-off", "climb", "speed-change", "cruise", "descent", "approach", "landing", "hold"
]  # fmt: skip
"""What an aircraft does in a phase."""
GROUND_KINDS = ("taxi", "take-off", "landing")
"""Kinds that begin on the wheels."""


class Flaps(Record):
    """Flaps and landing gear of one setting."""

    highest_lift: float = Field(gt=0, le=6, description="C_L at the stall")
    extra_drag: Ratio = Field(0.0, ge=0, le=1, description="C_D0 beyond that of the clean aircraft, with gear")


class Aircraft(Record):
    """The aircraft, where phases ask for the thrust that flight needs, or fly with the thrust that they are given."""

    mass: Mass = Field(gt=0, le=1e6, description="At the start")
    wing_area: Area = Field(gt=0, le=1e4, description="Reference area S")
    zero_lift_drag: Ratio = Field(gt=0, le=1, description="C_D0")
    induced_drag: Ratio | None = Field(
        None, ge=0, le=1, description="k of C_D = C_D0 + k C_L²; or aspect_ratio and oswald: k = 1/(π A e)"
    )
    aspect_ratio: float | None = Field(None, gt=0.5, le=60, description="A = b²/S")
    oswald: Ratio | None = Field(None, gt=0.2, le=1.2, description="e")
    highest_lift: float | None = Field(
        None, gt=0, le=6, description="C_L at the stall, clean; left out: not looked at but for lift that no wing has"
    )
    take_off: Flaps | None = Field(None, description="Flaps and gear in take-off; left out: clean")
    landing: Flaps | None = Field(None, description="Flaps and gear in approach and landing; left out: clean")
    roll_lift: float = Field(0.3, ge=0, le=6, description="C_L while it rolls on its wheels; an assumption")
    rolling_friction: Ratio = Field(0.02, ge=0, le=0.5, description="μ of wheels that roll; an assumption")
    braking_friction: Ratio = Field(0.3, ge=0, le=1, description="μ of wheels that brake; an assumption")
    rotation_over_stall: float = Field(
        1.1, ge=1, le=2, description="Speed of rotation over that of the stall, where a take-off names none"
    )
    rotation: Time = Field(2.0, ge=0.1, le=10, description="From rotation until the wheels carry nothing")
    fuel: Mass | None = Field(None, gt=0, le=1e6, description="Fuel on board, part of the mass; left out: any")
    ceiling: Length | None = Field(None, gt=0, le=20e3, description="Highest altitude; left out: that of the map")

    @property
    def induced(self) -> float:
        """k of C_D = C_D0 + k C_L² [-]."""
        if self.induced_drag is not None:
            return self.induced_drag
        return 1.0 / (math.pi * (self.aspect_ratio or 1.0) * (self.oswald or 1.0))

    def flaps(self, setting: Setting) -> Flaps | None:
        """Return flaps and gear of a setting; None where the aircraft says nothing of them.

        Args:
            setting: Of them.
        """
        named = {"take-off": self.take_off, "landing": self.landing}.get(setting)
        if named is not None or self.highest_lift is None:
            return named
        return Flaps(highest_lift=self.highest_lift)


# ----------------------------------------------------------------------------------------------------------------------
# The helicopter of a mission: a mass under a rotor that drags a fuselage, and a tail rotor that holds it straight.
# ----------------------------------------------------------------------------------------------------------------------


class TailRotor(Record):
    """The tail rotor, and what drives it."""

    machine: str = Field(description="Rotor or load of the design that it is, such as tail-drive")
    diameter: Length = Field(gt=0, le=50, description="Diameter")
    speed: Speed = Field(gt=0.1, le=2e4, description="With the main rotor at the speed of the first phase")
    arm: Length = Field(gt=0, le=100, description="From the mast to its shaft")
    solidity: Ratio = Field(gt=0, le=1, description="Area of the blades over that of the disc")
    profile_drag: Ratio = Field(0.012, gt=0, le=0.1, description="c_d0 of its blades; an assumption")
    induced_factor: float = Field(
        1.25, ge=0.5, le=3, description="κ; about 0.85 in a duct, whose disc moves twice the air; assumptions"
    )


class Rotorcraft(Record):
    """A helicopter, where phases leave their power to the trim of its rotors."""

    mass: Mass = Field(gt=0, le=1e6, description="At the start; fuel that burns is taken off")
    flat_plate_area: Area = Field(gt=0, le=100, description="f: drag of the fuselage over the dynamic pressure")
    solidity: Ratio = Field(gt=0, le=1, description="Of the main rotor: area of the blades over that of the disc")
    profile_drag: Ratio = Field(0.010, gt=0, le=0.1, description="c_d0 of its blades; an assumption")
    induced_factor: float = Field(1.15, ge=1, le=3, description="κ over the ideal induced power; an assumption")
    download: Ratio = Field(0.03, ge=0, le=0.5, description="Of the wake on the fuselage in hover, over the weight")
    highest_loading: Ratio = Field(0.12, gt=0, le=0.3, description="C_T/σ at which blades stall; an assumption")
    tail: TailRotor | None = Field(None, description="Left out: what the design's case says it takes")


# ----------------------------------------------------------------------------------------------------------------------
# Windows of a mission file: seconds of flight in which propeller, governor and machines move the elastic train.
# ----------------------------------------------------------------------------------------------------------------------


class GovernorRules(Record):
    """The propeller's governor; its defaults come to rest within seconds on shipped propellers."""

    gain_deg_s: float = Field(1.0, ge=0, le=1000, description="K_p: pitch for a speed error, deg/(rad/s)")
    integral_deg_rad: float = Field(0.5, ge=0, le=1000, description="K_i: pitch for its integral, deg/rad")
    time_constant: Time = Field(0.1, gt=0, le=100, description="Of the actuator; of second order 1/ω_0")
    damping: Ratio = Field(0.7, ge=0, le=10, description="ζ of an actuator of second order; 0: first order")
    rate_deg_s: float = Field(10.0, gt=0, le=1e6, description="Fastest pitch change, deg/s")
    lowest_pitch: Angle | None = Field(
        None, ge=-0.5, le=1.6, description="Fine stop; left out: the pitch that the phase holds, or the map's end"
    )
    highest_pitch: Angle | None = Field(None, ge=-0.5, le=1.6, description="Coarse stop; left out: the map's end")
    reference_pitch: Angle | None = Field(
        None, ge=-0.5, le=1.6, description="Pitch without a speed error; left out: that at the window's start"
    )


EVENTS: Mapping[str, tuple[str, ...]] = {
    "none": (),
    "motor-cut": (),
    "turbine-cut": (),
    "mode-change": ("mode",),
    "pitch-step": ("pitch_step",),
    "speed-step": ("speed_step",),
    "gust": ("gust",),
    "clutch-engagement": ("clutch", "slip"),
    "motor-short-circuit": ("back_emf_v", "inductance_mh", "pole_pairs"),
    "engine-out": ("lag",),
    "pitch-runaway": ("overspeed",),
    "power-slam": ("power",),
    "propeller-strike": ("lasts",),
    "sudden-stop": (),
}
"""Event -> what a window must say about it."""


SHORTEST_STOP = 0.01
"""Stop that is sudden for a train whose lowest torsional mode is some tens of Hz [s]."""


class WindowRules(Record):
    """One window; what the mission does goes on in it, and its event comes on top."""

    phase: str = Field(description="Phase in which it starts")
    at: Time = Field(0.0, ge=0, le=1e6, description="Its start, from the start of the phase")
    duration: Time = Field(10.0, gt=0, le=1e4, description="Its length")
    event: Literal[
        "none", "motor-cut", "turbine-cut", "mode-change", "pitch-step", "speed-step", "gust", "clutch-engagement",
        "motor-short-circuit", "engine-out", "pitch-runaway", "power-slam", "propeller-strike",
        "sudden-stop",
    ] = Field("none", description="What happens in it")  # fmt: skip
    event_at: Time = Field(1.0, ge=0, le=1e4, description="When, from the window's start")
    over: Time = Field(0.1, gt=0, le=1e3, description="Time that the change takes; a phase's change of power, too")
    mode: Literal["conventional", "hybrid", "electric"] | None = Field(
        None, description="Who drives after a mode change"
    )
    electric_share: Ratio | None = Field(None, ge=-0.9, le=1, description="Motors' part of the power after it")
    power: Power | None = Field(None, gt=0, le=1e9, description="Power of all machines after it; left out: as before")
    pitch_step: Angle | None = Field(None, ge=-0.5, le=0.5, description="Step of the governor's reference pitch")
    speed_step: Speed | None = Field(None, ge=-1e3, le=1e3, description="Step of the set speed of the propeller")
    gust: Velocity | None = Field(None, ge=-100, le=100, description="Gust along the axis: its top, or its step")
    gust_shape: Literal["1-cos", "step"] = Field("1-cos", description="1-cos lasts `over`; a step stays")
    clutch: str | None = Field(None, description="Clutch that engages")
    slip: Speed | None = Field(None, gt=0, le=1e4, description="By how much its driving shaft is slower at first")
    capacity: Torque | None = Field(
        None, gt=0, le=1e9, description="Torque at which a friction clutch slips once engaged"
    )
    machine: str | None = Field(
        None,
        description="Motor or turbine that fails, left out: the only one; or what a sudden stop holds: the propeller",
    )
    back_emf_v: float | None = Field(
        None, ge=0, le=1e5, description="E of the motor: rms voltage of a phase, without load at the rated speed, V"
    )
    inductance_mh: float | None = Field(
        None, ge=1e-6, le=1e6, description="L of the motor: synchronous, of a phase without saliency, mH"
    )
    resistance_ohm: float | None = Field(
        None, ge=0, le=1e3, description="R of a phase; left out: estimated from the motor's copper loss"
    )
    pole_pairs: int | None = Field(None, ge=1, le=200, description="p of the motor")
    lag: Time | None = Field(
        None,
        gt=0,
        le=100,
        description="Time constant of a turbine that fails or speeds up; left out in a slam: by engine.spool;"
        " in a sudden stop of all, left out: they go on",
    )
    overspeed: Ratio | None = Field(
        None, gt=1, le=2, description="Speed that the overspeed governor holds, over the set speed"
    )
    strike_torque: Torque | None = Field(None, gt=0, le=1e9, description="That stops the propeller when it strikes")
    brake_torque: Torque | None = Field(None, gt=0, le=1e9, description="That holds the shaft in a sudden stop")
    stop_time: Time | None = Field(
        None, gt=0, le=1e6, description="In place of one: in which such a torque would stop everything that turns"
    )
    lasts: Time | None = Field(None, gt=0, le=1e4, description="How long the propeller strikes")
    stiffness: Literal["constant", "varying"] | None = Field(
        None, description="Mesh stiffness; left out: as the design says"
    )
    turbine_slope: Ratio = Field(
        1.0, ge=0, le=5, description="κ of T = u (1 + κ (1 − ω/ω_r)) of turbines; 0: sources of torque"
    )
    losses: bool = Field(True, description="Mesh losses as torques on the shafts; false: a train without losses")
    governor: GovernorRules | None = Field(None, description="In place of the mission's governor")


def window_problems(windows: Mapping[str, WindowRules], phases: Collection[str], *, spools: bool) -> Iterator[Problem]:
    """Yield what does not fit together in the windows of a mission.

    Args:
        windows: By name.
        phases: Names of the mission's phases.
        spools: Whether its turbines have a gas generator.
    """
    for name, window in windows.items():
        at = f"windows.{name}"
        if window.phase not in phases:
            yield Problem(f"{at}.phase", f"no such phase: {window.phase}; {near(window.phase, phases)}")
        for field in EVENTS[window.event]:
            if getattr(window, field) is None:
                yield Problem(at, f"{window.event} without {field}; give one")
        if window.event == "power-slam" and window.lag is None and not spools:
            yield Problem(at, "power-slam without lag; give one, or [engine.spool]")
        if window.mode == "hybrid" and window.electric_share is None:
            yield Problem(at, "hybrid without electric_share; give the motors' part of the power, such as 0.3")
        if window.event == "propeller-strike":
            yield from _strike(at, window)
        if window.event == "sudden-stop":
            yield from _stop(at, window)
        if window.event != "none" and window.event_at >= window.duration:
            yield Problem(
                f"{at}.event_at", f"{window.event_at:g} s, but the window ends at {window.duration:g} s; start earlier"
            )


def _strike(at: str, window: WindowRules) -> Iterator[Problem]:
    """Yield what is wrong with a propeller that strikes."""
    if (window.strike_torque is None) == (window.stop_time is None):
        yield Problem(at, "propeller-strike takes either strike_torque or stop_time; give one of them")
    if window.stop_time is not None and window.lasts is not None and window.lasts >= window.stop_time:
        yield Problem(
            f"{at}.lasts",
            f"{window.lasts:g} s, but everything stands still after stop_time, {window.stop_time:g} s; give less, or"
            ' event = "sudden-stop"',
        )


def _stop(at: str, window: WindowRules) -> Iterator[Problem]:
    """Yield what is wrong with a stop to rest."""
    if (window.brake_torque is None) == (window.stop_time is None):
        yield Problem(at, "sudden-stop takes either brake_torque or stop_time; give one of them")
    if window.stop_time is not None and window.stop_time < SHORTEST_STOP:
        yield Problem(
            f"{at}.stop_time",
            f"{window.stop_time:g} s is less than {SHORTEST_STOP:g} s, in which shafts hardly begin to twist: what is"
            " shorter loads them no more; give that",
        )


# ----------------------------------------------------------------------------------------------------------------------
# Hybrid strategies by name: how turbines and motors divide the power of a phase, interval by interval.
# ----------------------------------------------------------------------------------------------------------------------


Rule = Literal["share", "boost", "turbine-alone", "electric-taxi", "regenerate", "charge", "optimal"]
"""Rules by which a strategy divides power."""


class StrategyRules(Record):
    """A strategy that phases name."""

    rule: Rule = Field(description="How power is divided")
    electric_share: Ratio | None = Field(
        None, ge=-0.9, le=1, description="Of `share`: motors' part of the machines' power; negative charges"
    )
    turbine_power: Power | None = Field(
        None, gt=0, le=1e9,
        description="Of `boost`: turbines give up to this, motors what is more; left out: what the turbines can give",
    )  # fmt: skip
    charge_power: Power | None = Field(
        None, gt=0, le=1e9, description="Of `charge`: what the motors take from the gearbox, as far as turbines give it"
    )
    until_charge: Ratio | None = Field(
        None, gt=0, le=1, description="Of `charge` and `regenerate`: state of charge that ends it; left out: 0.95"
    )
    end_charge: Ratio | None = Field(
        None, ge=0, le=1, description="Of `optimal`: state of charge at its last phase's end; left out: minimum_charge"
    )
    shares: int | None = Field(
        None, ge=3, le=401, description="Of `optimal`: shares that are tried, from the lowest to 1; left out: 41"
    )
    lowest_share: Ratio | None = Field(
        None, ge=-0.9, le=0, description="Of `optimal`: lowest of them; negative charges; left out: 0"
    )
    charges: int | None = Field(
        None, ge=3, le=1001, description="Of `optimal`: states of charge that are looked at; left out: 101"
    )


KEYS_OF: dict[str, tuple[str, ...]] = {
    "share": ("electric_share",),
    "boost": ("turbine_power",),
    "turbine-alone": (),
    "electric-taxi": (),
    "regenerate": ("until_charge",),
    "charge": ("charge_power", "until_charge"),
    "optimal": ("end_charge", "shares", "lowest_share", "charges"),
}
"""Rule -> the keys that it reads."""
NEEDED = {"share": "electric_share", "charge": "charge_power"}
"""Rule -> the key that it cannot do without."""


# ----------------------------------------------------------------------------------------------------------------------
# What warms up beside the gearbox: cells of a battery, windings of motors.
# ----------------------------------------------------------------------------------------------------------------------


class CellRules(Record):
    """The battery as an equivalent circuit that warms and ages."""

    ocv_charge: list[float] | None = Field(
        None, min_length=2, max_length=101, description="States of charge from 0 to 1, rising; with ocv_v"
    )
    ocv_v: list[float] | None = Field(
        None, min_length=2, max_length=101, description="Open-circuit voltages there; left out: a line between the two"
    )
    slow_resistance_ohm: float = Field(0.0, ge=0, le=100, description="R_1 of the pair of R and C")
    slow_time: Time = Field(30.0, ge=0.01, le=1e5, description="τ = R_1 C_1 of the pair")
    activation_k: float = Field(0.0, ge=0, le=2e4, description="B of R = R_25 e^(B (1/T - 1/298.15 K))")
    start_temperature_k: float = Field(298.15, ge=180, le=400, description="Of the cells at the start")
    specific_energy_wh_kg: float = Field(180.0, gt=1, le=2000, description="Of the pack: says its mass")
    heat_capacity_j_kg_k: float = Field(1000.0, gt=1, le=1e4, description="Of the pack")
    cooling_w_k: float = Field(0.0, ge=0, le=1e7, description="From the cells to coolant or air")
    coolant_temperature_k: float | None = Field(
        None, ge=180, le=400, description="Of the coolant; left out: the air around the aircraft cools"
    )
    highest_temperature_k: float = Field(333.15, ge=180, le=500, description="Of the cells, where a flight ends")
    lowest_temperature_k: float = Field(253.15, ge=150, le=400, description="Of the cells, where a flight ends")
    cycle_life: float | None = Field(
        None, gt=0, le=1e7, description="Equivalent full cycles at 25 °C until the pack is worn; left out: not counted"
    )
    calendar_years: float | None = Field(
        None, gt=0, le=1e3, description="Years at 25 °C until the pack is worn; left out: not counted"
    )
    doubling_k: float = Field(10.0, gt=0, le=100, description="Rise of temperature that doubles ageing")
    bus_resistance_ohm: float = Field(0.0, ge=0, le=10, description="Of the DC bus between pack and inverters")


class WindingRules(Record):
    """The warmth of a motor: winding and case; all motors of a gearbox are alike."""

    winding_capacity_j_k: float = Field(gt=0, le=1e8, description="Of copper and insulation")
    case_capacity_j_k: float = Field(gt=0, le=1e8, description="Of iron and case")
    winding_to_case_w_k: float = Field(gt=0, le=1e6, description="Between them")
    case_to_coolant_w_k: float = Field(ge=0, le=1e6, description="From the case to coolant or air")
    coolant_temperature_k: float | None = Field(
        None, ge=180, le=450, description="Of the coolant; left out: the air around the aircraft cools"
    )
    start_temperature_k: float | None = Field(None, ge=180, le=450, description="At the start; left out: the coolant's")
    rated_winding_k: float = Field(393.15, ge=200, le=600, description="Of the winding at which motor.efficiency holds")
    derate_from_k: float | None = Field(
        None, ge=180, le=700, description="From here on the limits fall, to nothing at the highest; left out: they hold"
    )
    highest_winding_k: float = Field(
        453.15, ge=180, le=700, description="Of the winding; 453.15 K is class H of IEC 60085"
    )
    winding_loss: Ratio = Field(1.0, ge=0, le=1, description="Part of the copper loss that warms the winding itself")


# ----------------------------------------------------------------------------------------------------------------------
# What warms up in the gearbox: oil, gears, bearings and housing, and how long it runs without oil.
# ----------------------------------------------------------------------------------------------------------------------


class OilNetworkRules(Record):
    """Temperatures of oil, gears, bearings and housing through a flight, in place of a stated oil temperature."""

    oil_mass: Mass = Field(gt=0, le=1e4, description="Of the oil in sump, gearbox and cooler")
    housing_mass: Mass = Field(gt=0, le=1e5, description="Of the housing")
    bearing_mass: Mass = Field(gt=0, le=1e4, description="Of all bearings")
    oil_heat_j_kg_k: float = Field(2000.0, ge=500, le=5000, description="Heat capacity of the oil")
    housing_heat_j_kg_k: float = Field(900.0, ge=100, le=5000, description="Of the housing; 900 for aluminium")
    steel_heat_j_kg_k: float = Field(470.0, ge=100, le=5000, description="Of gears, shafts and bearings")
    gears_to_oil_w_k: float = Field(gt=0, le=1e6, description="From gears to the oil that cools them")
    bearings_to_oil_w_k: float = Field(gt=0, le=1e6, description="From bearings to the oil")
    bearings_to_housing_w_k: float = Field(20.0, ge=0, le=1e6, description="From bearings to the housing")
    gears_to_housing_w_k: float = Field(2.0, ge=0, le=1e6, description="From gears, by air and radiation")
    oil_to_housing_w_k: float = Field(50.0, ge=0, le=1e6, description="From the oil to the housing")
    housing_to_air_w_k: float = Field(15.0, ge=0, le=1e6, description="From the housing to the air")
    cooler_w_k: float = Field(ge=0, le=1e6, description="From the oil to the air, with the cooler's valve open")
    cooler_opens_k: float = Field(343.15, ge=200, le=450, description="Of the oil, where the cooler's valve opens")
    cooler_range_k: float = Field(10.0, gt=0, le=200, description="Above that, until it is open")
    oil_share: Ratio = Field(
        0.5, ge=0, le=1, description="Part of the heat of meshes and bearings that oil takes at once"
    )
    start_temperature_k: float | None = Field(
        None, ge=190, le=450, description="Of everything at the start; left out: oil.inlet_temperature_k"
    )
    highest_oil_k: float = Field(413.15, ge=250, le=700, description="Of the oil, where a flight ends")
    highest_gears_k: float = Field(
        523.15, ge=250, le=1500, description="Of the gears, where a flight or dry running ends"
    )
    highest_bearings_k: float = Field(
        473.15, ge=250, le=1500, description="Of the bearings, where a flight or dry running ends"
    )
    dry_friction: float = Field(
        3.0, ge=1, le=100, description="Losses of meshes and bearings without oil over those with"
    )
    dry_from: str | None = Field(None, description="Phase at whose end the oil is lost, to see how long it then runs")


# ----------------------------------------------------------------------------------------------------------------------
# The gas generator of a turbine as a mission's user describes it.
# ----------------------------------------------------------------------------------------------------------------------


class SpoolRules(Record):
    """The gas generator of the turbines, which speeds up before power comes; power slams in windows follow it."""

    pressure_ratio: float = Field(ge=3, le=40, description="p_3/p_2 at thermal power at sea level")
    speed: Speed = Field(gt=100, le=1e4, description="N1 there")
    inertia: Inertia = Field(gt=0, le=100, description="Of the gas generator")
    compressor: Ratio = Field(0.81, gt=0.5, lt=1, description="Isentropic efficiency of the compressor; an assumption")
    turbine: Ratio = Field(0.86, gt=0.5, lt=1, description="Of the turbine that drives it; an assumption")
    acceleration: Ratio = Field(
        1.0,
        ge=0.6,
        le=2,
        description="Most fuel over p_3, over that at thermal power: keeps it from surge",
    )
    deceleration: Ratio = Field(0.3, ge=0.05, le=0.6, description="Least of it: keeps the fire")
    valve: Time = Field(0.05, gt=0, le=10, description="Time constant of the fuel's metering valve")


# ----------------------------------------------------------------------------------------------------------------------
# The mission file: what the aircraft does with one gearbox, phase by phase.
# ----------------------------------------------------------------------------------------------------------------------


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
