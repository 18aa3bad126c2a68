"""What drives a transmission and what it drives: machines of every kind, and what each of them may do.

Every kind says in the same words (`Machine`) what it does where a case says nothing of it, and what it can do; the
layers above ask for that, and never for the kind.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import ClassVar, Literal

from pydantic import Field

from gearwright.spec.design.duty.cases import BALANCES, IDLES, Drive
from gearwright.spec.record import Record
from gearwright.units import Force, Inertia, Length, Mass, Power, Speed, Time, Torque


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
    mass_law: Literal["ndarc", "thesis"] = Field(
        "ndarc", description="Mass from torque: NDARC's law, or the thesis's k T^0.33"
    )
    mass: Mass | None = Field(None, gt=0, description="Known mass, instead of the law")
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


class Airscrew(Machine):
    """What propellers and rotors share; driven by the flow they give power."""

    gives: ClassVar[bool] = True

    speed: Speed = Field(ge=0.1, le=2e4, description="Asked speed; the teeth may let it yield")
    diameter: Length = Field(gt=0, le=300, description="Diameter")
    blades: int = Field(4, ge=2, le=12, description="Number of blades")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; estimated if left out")
    thrust: Force = Field(0.0, description="Along its shaft, positive away from the gears")
    in_plane_force: Force = Field(0.0, ge=0, description="Across its shaft, turning with the flow, not with the shaft")
    hub_moment: Torque = Field(0.0, ge=0, description="Bending moment at its hub, in the plane of the force across")

    @property
    def unsaid(self) -> Drive:
        """It takes what the others leave."""
        return BALANCES


class Propeller(Airscrew):
    """A propeller; it takes the power that the machines give, and drives where a case says so."""

    shaft: str = Field(description="Shaft that carries it")


class Rotor(Airscrew):
    """A rotor of a helicopter, main or tail, or of a wind turbine, which drives where a case says so; one that a case
    gives a power leaves the balance to the other."""

    shaft: str = Field(description="Shaft that carries it")


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
