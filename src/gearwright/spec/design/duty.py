"""Machines with their ratings and time limits, load cases and service life.

Which case speaks for a design is in `spectrum`, which knows the design.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import ClassVar, Literal, NamedTuple

from pydantic import ConfigDict, Field

from gearwright.base import (
    Angle,
    Force,
    Inertia,
    Length,
    Mass,
    Power,
    Ratio,
    SpecificMass,
    SpecificPower,
    Speed,
    Time,
    Torque,
    Velocity,
)  # fmt: skip
from gearwright.machines import TIP_SPEED
from gearwright.spec.record import Record

# ----------------------------------------------------------------------------------------------------------------------
# Load cases: what each machine does, how long, and what is engaged.
# ----------------------------------------------------------------------------------------------------------------------


class Drive(Record):
    """What one machine does in a case."""

    power: Power | None = Field(
        None,
        ge=-1e9,
        le=1e9,
        description="Power into the train; negative takes power out; of a propeller, rotor or load more than 0 asks for"
        " drives = true; left out, and no other: it balances the rest",
    )
    torque: Torque | None = Field(
        None,
        description="Torque into the train, instead of power; negative takes power out; it may stand still; of a"
        " propeller, rotor or load more than 0 asks for drives = true",
    )
    rating: Ratio | None = Field(
        None, ge=-1, le=1, description="Part of its rated power, instead of power; -1 takes all of it"
    )
    balances: bool = Field(
        False, description="Its torque follows from equilibrium, also where it takes a power of its own otherwise"
    )
    drives: bool = Field(
        False,
        description="Of a propeller, rotor or load, which take power: in this case it gives what is said, driven by the"
        " air or by what it moves",
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Speed, where it is not the rated one")

    @property
    def stated(self) -> bool:
        """True where it says what the machine gives or takes."""
        return self.power is not None or self.torque is not None or self.rating is not None

    @property
    def idles(self) -> bool:
        """True where the machine neither gives nor takes anything."""
        return self.power == 0.0 or self.torque == 0.0 or self.rating == 0.0


IDLES, BALANCES = Drive(power=0.0), Drive(balances=True)


class Spectrum(Record):
    """A load spectrum, said once for all cases that name it: levels of their loads, and how long each lasts."""

    load: list[Ratio] = Field(min_length=1, description="Levels: parts of the loads of the case that names it, 0 to 1")
    share: list[Ratio] = Field(min_length=1, description="Share of the time of that case for each level, with sum 1")


class Case(Record):
    """A load case: besides its own keys one table for each machine that does something else than usual."""

    model_config: ClassVar[ConfigDict] = ConfigDict(extra="allow")
    others: ClassVar[type[Record] | None] = Drive
    __pydantic_extra__: dict[str, Drive] = Field(init=False)

    duration: Time | None = Field(
        None, gt=0, description="How long it lasts in one flight or other cycle of use; all of them make up the life"
    )
    share: Ratio | None = Field(
        None, ge=0, le=1, description="Share of the life that it lasts, instead of durations; their sum is 1"
    )
    static: bool = Field(
        False, description="A limit load: it is judged against static strength and yield, and counts no cycles"
    )
    spectrum: str | None = Field(
        None,
        description="Name of a load spectrum, [spectra.NAME]; what the case says is its level 1;"
        " left out: that of [service], else this level all the time",
    )
    engaged: list[str] | None = Field(
        None,
        description="Clutches and brakes that hold, the others are open; left out: as their kind says;"
        " overrunning ones act by themselves",
    )

    @property
    def machines(self) -> Mapping[str, Drive]:
        """Machine -> what it does; one left out does what it does usually."""
        return self.__pydantic_extra__ or {}


# ----------------------------------------------------------------------------------------------------------------------
# What drives a transmission and what it drives: machines of every kind, and what each of them may do.
#
# Every kind says in the same words (`Machine`) what it does where a case says nothing of it, and what it can do; the
# layers above ask for that, and never for the kind.
# ----------------------------------------------------------------------------------------------------------------------


class Limit(Record):
    """What a machine may do for a time, beyond its rating."""

    power: Power | None = Field(None, gt=0, le=1e9, description="Largest power, given or taken")
    torque: Torque | None = Field(None, gt=0, description="Largest torque, given or taken")
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Largest speed")
    duration: Time | None = Field(None, gt=0, description="For how long without a break; left out: for any time")


class Machine(Record):
    """What every machine has."""

    gives: ClassVar[bool] = False
    """Whether a case may let it give power."""
    takes: ClassVar[bool] = True
    """Whether a case may let it take power."""
    drives: ClassVar[bool] = False
    """Whether it is there to drive: it sits at the first end of its shaft, what it drives at the second."""

    shaft: str
    limits: dict[str, Limit] = Field(
        default_factory=dict, description="What it may do for a time, by name, such as [turbines.NAME.limits.take-off]"
    )

    @property
    def rating(self) -> float | None:
        """Power that it gives or takes for any time [W]; None where it takes what comes."""
        return getattr(self, "power", None)

    @property
    def asked_speed(self) -> float | None:
        """Speed that the teeth are to give it [rad/s]; None where it turns as its shaft does."""
        return getattr(self, "speed", None)

    @property
    def highest_speed(self) -> float | None:
        """Speed that it may not pass [rad/s]; None where none is said."""
        return max((limit.speed for limit in self.limits.values() if limit.speed is not None), default=None)

    @property
    def unsaid(self) -> Drive:
        """What it does in a case that says nothing of it."""
        return IDLES

    @property
    def fully(self) -> Drive:
        """What it does in the case of a design without cases."""
        return self.unsaid


class Turbine(Machine):
    """A gas turbine's output (power turbine) that drives a shaft."""

    gives: ClassVar[bool] = True
    takes: ClassVar[bool] = False
    drives: ClassVar[bool] = True

    shaft: str = Field(description="Shaft that it drives")
    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")
    diameter: Length | None = Field(None, gt=0, le=100, description="Disc diameter, for the inertia estimate")

    @property
    def fully(self) -> Drive:
        """Its rated power."""
        return Drive.model_construct(power=self.power)


class ElectricMachine(Machine):
    """What motors and generators share."""

    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    flux: Literal["radial", "axial"] = Field("radial", description="Flux topology, for its proportions")
    mass_law: Literal["public", "ndarc", "thesis"] = Field(
        "public",
        description="Its own mass, where none is known: from torque and speed as public machines for aircraft, from"
        " torque alone by NDARC's law, or by the thesis's k T^0.33",
    )
    mass: Mass | None = Field(None, gt=0, description="Known mass of its own, instead of the law")
    inverter: SpecificPower | None = Field(
        None,
        ge=100,
        le=1e6,
        description="Rated power over mass of its inverter; left out: 12 beside a mass by the public law, else none",
    )
    inverter_mass: Mass | None = Field(None, ge=0, description="Known mass of its inverter; 0: none, or in its own")
    cooling: SpecificMass | None = Field(
        None,
        ge=0,
        le=0.1,
        description="Mass of its cooling over the heat of motor and inverter, a nineteenth of the rated power; left"
        " out: 0.8 beside a mass by the public law, else none",
    )
    cooling_mass: Mass | None = Field(None, ge=0, description="Known mass of its cooling; 0: none, or in its own")
    tip_speed: Velocity = Field(
        TIP_SPEED,
        gt=0,
        le=500,
        description="Of the rotor's surface, which bounds power at a speed where the mass is not known: 220 in a carbon"
        " sleeve, 150 without one",
    )
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")
    poles: int | None = Field(
        None, ge=2, le=400, description="Number of poles, an even number, for its electrical orders"
    )
    slots: int | None = Field(None, ge=3, le=2000, description="Number of stator slots, for its slot orders")


class Motor(ElectricMachine):
    """An electric motor on a shaft; with negative power in a case it generates."""

    gives: ClassVar[bool] = True
    drives: ClassVar[bool] = True

    shaft: str = Field(description="Shaft that it drives")
    reverse: bool = Field(False, description="Its shaft turns against the first machine's, as seen from one end")
    balances: bool = Field(
        False,
        description="Its torque follows from equilibrium, as on one member of a differential; power is its rating",
    )

    @property
    def unsaid(self) -> Drive:
        """It idles, unless it balances."""
        return BALANCES if self.balances else IDLES

    @property
    def fully(self) -> Drive:
        """Its rated power, unless it balances."""
        return BALANCES if self.balances else Drive.model_construct(power=self.power)


class Generator(ElectricMachine):
    """A generator on a shaft: it takes what the case says, or what the others leave, up to its rating."""

    shaft: str = Field(description="Shaft that drives it")

    @property
    def unsaid(self) -> Drive:
        """It takes what the others leave."""
        return BALANCES


AIRSCREW_LOADS = ("thrust", "in_plane_force", "hub_moment")
"""Keys of the loads that a propeller or rotor may state."""
FLIGHTS = ("take-off", "climb", "cruise")
"""Cases of flight that propellers are loaded in by default."""


class FlightLoads(Record):
    """How a propeller flies in one case, for its loads."""

    incidence: Angle | None = Field(None, ge=0, le=math.radians(30), description="Of its axis against the stream")
    airspeed: Velocity | None = Field(None, gt=0, le=340, description="True airspeed")


class PropellerLoads(Record):
    """What the loads of a propeller on its shaft are taken from, where they are not stated; each has a default."""

    cases: dict[str, FlightLoads] = Field(
        default_factory=dict,
        description="Incidence and airspeed by case: take-off, climb or cruise, or a load case of the design; left out:"
        " 10°, 6° and 2°, at 1.51, 2.13 and 3.14 times the velocity (P/(2 ρ A))^(1/3)",
    )
    excitation_factor: Ratio = Field(
        3.0, ge=0, le=10, description="EF = α[°] (V_EAS/348 kt)² in climb that the shaft bears without end"
    )
    gyroscopic: Literal["cs25", "cs23"] | list[float] = Field(
        "cs25",
        description="Turning of the aircraft as a limit load: 0.3 rad/s in pitch and yaw (cs25), 1.0 and 2.5 (cs23), or"
        " [pitch, yaw] in rad/s",
    )
    mass: Mass | None = Field(None, gt=0, description="Of the propeller; left out: twice that of its blades")
    blade_mass: Mass | None = Field(
        None, gt=0, description="Of one blade, for weight and inertia; left out: a composite bar of its diameter"
    )
    overhang: Length = Field(0.0, ge=0, le=10, description="Of the blades' plane beyond its place on the shaft")


class RotorLoads(Record):
    """What the loads of a helicopter's rotor on its mast are taken from, where they are not stated."""

    hub: Literal["teetering", "articulated", "hingeless"] = Field(
        "articulated", description="Kind of hub, for its moment: 0.01, 0.03 or 0.06 T R in usual flight, twice as limit"
    )
    h_force: Ratio = Field(0.1, ge=0, le=1, description="Force in the plane of the disc over the thrust")
    load_factor: Ratio = Field(3.5, ge=1, le=10, description="Thrust over weight as a limit load")


class Airscrew(Machine):
    """What propellers and rotors share; driven by the flow they give power.

    Where none of thrust, force across and hub moment is stated, bearings of its shaft bear loads by default; one that
    is stated holds in every case, and where all three are, nothing is assumed beside them.
    """

    gives: ClassVar[bool] = True

    speed: Speed = Field(ge=0.1, le=2e4, description="Asked speed; the teeth may let it yield")
    diameter: Length = Field(gt=0, le=300, description="Diameter")
    blades: int = Field(4, ge=2, le=12, description="Number of blades")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; estimated if left out")
    thrust: Force = Field(
        0.0, description="Along its shaft, positive away from the gears; left out on a shaft in bearings: by `loads`"
    )
    in_plane_force: Force = Field(
        0.0,
        ge=0,
        description="Across its shaft, turning with the flow, not with the shaft; left out in bearings: by `loads`",
    )
    hub_moment: Torque = Field(
        0.0,
        ge=0,
        description="Bending moment at its hub, in the plane of the force across; left out in bearings: by `loads`",
    )

    @property
    def stated_loads(self) -> frozenset[str]:
        """Which of its loads are stated."""
        return frozenset(self.model_fields_set & set(AIRSCREW_LOADS))

    @property
    def unsaid(self) -> Drive:
        """It takes what the others leave."""
        return BALANCES


class Propeller(Airscrew):
    """A propeller; it takes the power that the machines give, and drives where a case says so."""

    shaft: str = Field(description="Shaft that carries it")
    loads: PropellerLoads = Field(
        default_factory=PropellerLoads, description="What its loads are taken from, where they are not stated"
    )


class Rotor(Airscrew):
    """A rotor of a helicopter, main or tail, or of a wind turbine, which drives where a case says so; one that a case
    gives a power leaves the balance to the other."""

    shaft: str = Field(description="Shaft that carries it")
    loads: RotorLoads = Field(
        default_factory=RotorLoads, description="What its loads are taken from, where they are not stated"
    )


class Accessory(Machine):
    """A pump, fan or other accessory: it takes its power whenever its shaft turns."""

    shaft: str = Field(description="Shaft that drives it")
    power: Power = Field(
        ge=0,
        le=1e9,
        description="Power that it takes where a case says nothing else; a case writes what it takes with a minus",
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Largest speed that it may turn at; left out: any")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; left out: none, as it is not stated")
    mass: Mass | None = Field(None, gt=0, description="Its mass; left out: none, as it is not stated")

    @property
    def rating(self) -> None:
        """What it takes is no limit."""
        return None

    @property
    def asked_speed(self) -> None:
        """It turns as its shaft does."""
        return None

    @property
    def highest_speed(self) -> float | None:
        """Its own largest speed, or that of its limits [rad/s]."""
        return self.speed if self.speed is not None else super().highest_speed

    @property
    def unsaid(self) -> Drive:
        """It takes its power."""
        return Drive.model_construct(power=-self.power)


class Load(Machine):
    """Anything else that takes power: a wheel, a pump, a brake; driven by what it moves it gives power, where a case
    says so."""

    gives: ClassVar[bool] = True

    shaft: str = Field(description="Shaft that drives it")
    power: Power | None = Field(
        None,
        gt=0,
        le=1e9,
        description="Power that it takes where a case says nothing else; a case writes what it takes with a minus",
    )
    torque: Torque | None = Field(
        None, gt=0, description="Torque that it takes where a case says nothing else; a case writes it with a minus"
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Asked speed; left out: as the teeth give it")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; left out: none, as it is not stated")

    @property
    def rating(self) -> None:
        """What it takes is no limit."""
        return None

    @property
    def unsaid(self) -> Drive:
        """It takes its power or torque, or what the others leave."""
        if self.power is not None:
            return Drive.model_construct(power=-self.power)
        return BALANCES if self.torque is None else Drive.model_construct(torque=-self.torque)


MACHINES: Mapping[str, type[Machine]] = MappingProxyType({
    "turbines": Turbine, "motors": Motor, "propellers": Propeller, "rotors": Rotor, "generators": Generator,
    "accessories": Accessory, "loads": Load,
})  # fmt: skip
"""Table of the file -> kind of machine in it, in the order in which speeds are kept."""


class SpeedRules(Record):
    """Which speed holds where the teeth make the asked ratio only nearly."""

    keep: list[str] | None = Field(
        None,
        description="Machines whose speed is kept, met exactly, in order; left out: turbines, motors, propellers,"
        " rotors, generators, loads",
    )


# ----------------------------------------------------------------------------------------------------------------------
# What a machine may do while a case lasts: its rating, and the limits that hold for so long.
# ----------------------------------------------------------------------------------------------------------------------


class Allowed(NamedTuple):
    """The most that a machine may do; None where nothing is said."""

    power: float | None
    """Given or taken [W]."""
    torque: float | None
    """Given or taken [N m]."""
    speed: float | None
    """[rad/s]"""


def allowed_in_case(machine: Machine, case: Case) -> Allowed:
    """Return what a machine may do in a case; one that says no duration may last as long as any limit.

    Args:
        machine: With its rating and limits.
        case: With its duration.
    """
    return allowed_for(machine, case.duration)


def allowed_for(machine: Machine, duration: float | None) -> Allowed:
    """Return what a machine may do for a time.

    Args:
        machine: With its rating and limits.
        duration: How long [s]; None: not said, and no limit is left out for its time.
    """
    limits = [limit for limit in machine.limits.values() if _holds(limit, duration)]
    powers = [limit.power for limit in limits if limit.power is not None]
    torques = [limit.torque for limit in limits if limit.torque is not None]
    rating = [] if machine.rating is None else [machine.rating]
    return Allowed(max([*rating, *powers], default=None), max(torques, default=None), machine.highest_speed)


def _holds(limit: Limit, duration: float | None) -> bool:
    return limit.duration is None or duration is None or duration <= limit.duration


# ----------------------------------------------------------------------------------------------------------------------
# What a transmission must live through.
# ----------------------------------------------------------------------------------------------------------------------


_HOUR = 3600.0


class Service(Record):
    """The life that is asked, and the loads in it."""

    life: Time = Field(3500 * _HOUR, gt=0, description="Life of gears")
    bearing_life: Time = Field(5000 * _HOUR, gt=0, description="Minimum basic rating life L_10h of each bearing")
    application_factor: Ratio = Field(1.25, ge=1, le=5, description="K_A: what the outside adds to the nominal load")
    shares: dict[str, Ratio] = Field(
        default_factory=dict,
        description="Share of the life that each case lasts, with sum 1; left out: all of it at rated power",
    )
    spectrum: str | None = Field(
        None, description="Load spectrum of every case that lasts and names none, [spectra.NAME]; left out: none"
    )
    mean_load: Ratio = Field(
        1.0,
        gt=0,
        le=1,
        description="Cubic mean load over the rated one, for bearings; with shares or a spectrum it follows from them",
    )
    static_safety: Ratio = Field(1.5, ge=0.5, le=5, description="Minimum static safety s_0 of bearings (ISO 76)")
    shaft_fatigue_safety: Ratio = Field(1.5, ge=1, le=5, description="Minimum safety of shafts against fatigue")
    shaft_yield_safety: Ratio = Field(1.5, ge=1, le=5, description="Minimum safety of shafts against yield")
    torque_swing: Ratio = Field(0.15, ge=0, le=1, description="Alternating part of the torque over its mean")
