"""What drives a transmission and what it drives, and what each machine does in a load case."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Force, Inertia, Length, Mass, Power, Speed, Torque


class Turbine(Record):
    """A gas turbine's output (power turbine) that drives a shaft."""

    shaft: str = Field(description="Shaft that it drives")
    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")
    diameter: Length | None = Field(None, gt=0, le=100, description="Disc diameter, for the inertia estimate")


class Motor(Record):
    """An electric motor on a shaft; with negative power in a case it generates."""

    shaft: str = Field(description="Shaft that it drives")
    power: Power = Field(gt=0, le=1e9, description="Rated power")
    speed: Speed = Field(ge=0.1, le=2e4, description="Speed at rated power")
    flux: Literal["radial", "axial"] = Field("radial", description="Flux topology, for its proportions")
    mass_law: Literal["ndarc", "thesis"] = Field(
        "ndarc", description="Mass from torque: NDARC's law, or the thesis's k T^0.33"
    )
    mass: Mass | None = Field(None, gt=0, description="Known mass, instead of the law")
    reverse: bool = Field(False, description="Its shaft turns against the first machine's, as seen from one end")
    balances: bool = Field(
        False,
        description="Its torque follows from equilibrium, as on one member of a differential; power is its rating",
    )
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia of its rotor; estimated if left out")


class Propeller(Record):
    """A propeller or rotor; it takes the power that the machines give."""

    shaft: str = Field(description="Shaft that carries it")
    speed: Speed = Field(ge=0.1, le=2e4, description="Asked speed; the teeth may let it yield")
    diameter: Length = Field(gt=0, le=100, description="Diameter")
    blades: int = Field(4, ge=2, le=12, description="Number of blades")
    inertia: Inertia | None = Field(None, gt=0, description="Polar inertia; estimated if left out")
    thrust: Force = Field(0.0, description="Along its shaft, positive away from the gears")
    in_plane_force: Force = Field(0.0, ge=0, description="Across its shaft, turning with the flow, not with the shaft")
    hub_moment: Torque = Field(0.0, ge=0, description="Bending moment at its hub, in the plane of the force across")


class Drive(Record):
    """What one machine does in a case."""

    power: Power | None = Field(
        None,
        ge=-1e9,
        le=1e9,
        description="Power into the train; negative takes power out; left out: it balances the rest",
    )
    speed: Speed | None = Field(None, ge=0.1, le=2e4, description="Speed, where it is not the rated one")


class SpeedRules(Record):
    """Which speed holds where the teeth make the asked ratio only nearly."""

    keep: list[str] | None = Field(
        None, description="Machines whose speed is kept, in order; left out: turbines, then motors, then propellers"
    )
