"""What sizing yields: every value with its unit and the equation and source that made it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated

from gearwright.checks import Check, worst
from gearwright.identity import PartId, Role, gear_part
from gearwright.parts.bearings import system_life, weibull_slope
from gearwright.showing import Shown
from gearwright.sizing.arranged import Arrangement
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.chosen import TeethSearch
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing
from gearwright.sizing.pinned import PlanetBearingSizing
from gearwright.spec import Design
from gearwright.spec.design import Given
from gearwright.train import PowerFlow, Train
from gearwright.units import (
    Inertia,
    Mass,
    Number,
    Origin,
    Power,
    Quantity,
    Torque,
)

_THESIS = "Pulvirenti 2023"
PRELIMINARY = "preliminary"
"""Level at which gears weigh what they are made of, and planet bearings with them."""


@dataclass(frozen=True)
class GearSizing:
    """One kind of gear body."""

    stage: str
    """Pair or planetary set that owns it."""
    role: Role
    """What it is in its stage."""
    shafts: tuple[str, ...]
    """What carries it."""
    bodies: int
    """Number of equal bodies."""
    teeth: int
    """Tooth number z."""
    module: Annotated[
        float, Quantity("length"), Origin("m_n ≥ max(bending, contact) of its stage's meshes", "rating of the meshes")
    ]
    """Normal module m_n [m]."""
    helix_angle: Annotated[float, Quantity("angle"), Origin("β", "design")]
    """Helix angle on the pitch cylinder [rad]."""
    face_width: Annotated[
        float, Quantity("length"), Origin("b = λ m_n, or the least that serves", "rating of the meshes")
    ]
    """Face width of one body [m]."""
    pitch_diameter: Annotated[float, Quantity("length"), Origin("d = m_n z / cos β", "ISO 21771:2007")]
    """Pitch diameter [m]."""
    rim: Annotated[
        float,
        Quantity("length"),
        Origin("s = (k − x) m_n outside the pitch circle, k of the rules", "3.95: AGMA 2001-D04, backup ratio 1.2"),
    ]
    """Wall of a ring outside its pitch circle [m]; zero for discs."""
    mass: Annotated[
        float,
        Quantity("mass"),
        Origin(
            "m = π (r² − r_b²) b ρ, r_b under a planet's bearing, wheels times their web ratio; rings "
            "π ((d/2 + s)² − r²) b ρ; r = d/2 ± x m_n; preliminary: A_z b ρ and annuli of rim, web and hub",
            f"{_THESIS}, eq. 3.3; annulus",
        ),
    ]
    """Mass of one body [kg]."""
    inertia: Annotated[
        float,
        Quantity("inertia"),
        Origin(
            "I = m (r² + r_b²)/2, r_b under a planet's bearing; rings m (r² + (d/2 + s)²)/2; r = d/2 ± x m_n",
            f"{_THESIS}, eq. 3.6; annulus",
        ),
    ]
    """Polar inertia of one body about its own axis [kg m²]."""
    profile_shift: Annotated[float, Quantity("ratio"), Origin("x", "design; DIN 3992 where balanced")]
    """Profile shift coefficient x, positive where it thickens the tooth [-]."""
    tip_alteration: Annotated[
        float, Quantity("ratio"), Origin("k m_n = a_w − a − m_n Σx; rings: off the involute", "DIN 3960:1987")
    ]
    """Tip alteration coefficient k [-]; negative shortens the tooth."""
    own: str = ""
    """What the design calls it, in a compound set."""
    runs_on: PlanetBearingSizing | None = None
    """Of a planet, what it turns on; None where the design does not say."""

    @property
    def turning_mass(self) -> Mass:
        """Of one body with what of its bearings turns with it [kg]."""
        return self.mass + (self.runs_on.turning_mass if self.runs_on else 0.0)

    @property
    def turning_inertia(self) -> Inertia:
        """Of one body with what of its bearings turns with it, about its own axis [kg m²]."""
        return self.inertia + (self.runs_on.turning_inertia if self.runs_on else 0.0)

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return gear_part(self.stage, self.role, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun``."""
        return str(self.part)

    def body(self, shaft: str) -> PartId:
        """Return the body on one of its shafts; the gear itself where it has one.

        Args:
            shaft: That carries the body.
        """
        return self.part if len(self.shafts) == 1 else gear_part(self.stage, self.role, shaft)


@dataclass(frozen=True)
class MachineSizing:
    """One machine at the end of a shaft."""

    name: str
    kind: str
    """turbine, motor, propeller, rotor, generator, accessory or load."""
    shaft: str
    torque: Torque
    """At rated power and speed; of what has no rating the largest of all cases [N m]."""
    mass: Annotated[
        float | None,
        Quantity("mass"),
        Origin("0.3928 Q^0.8587 lb, or k T^0.33", "NDARC (NASA/TP-2015-218751); Pulvirenti 2023"),
    ]
    """Of a motor, generator or accessory; None where the gearbox does not size it [kg]."""
    inertia: Inertia
    """Polar inertia of what turns [kg m²]."""
    inertia_is_given: bool
    """True if the design gives it, False if it is estimated."""


@dataclass(frozen=True, repr=False)
class Sizing(Shown):
    """A sized transmission."""

    design: Design
    train: Train
    teeth: Mapping[str, int]
    """Gear -> tooth number."""
    flows: Mapping[str, PowerFlow]
    """Case -> speeds, torques and powers; the first one speaks for the design."""
    gears: tuple[GearSizing, ...]
    meshes: tuple[MeshSizing, ...]
    arrangement: Arrangement
    """Where the axes of all shafts stand, and what sits where along them."""
    shafts: tuple[ShaftSizing, ...]
    carriers: tuple[CarrierSizing, ...]
    machines: tuple[MachineSizing, ...]
    built_shafts: tuple[BuiltShaft, ...] = ()
    """Shafts that the design gives bearings, as they are built."""
    bearings: tuple[BearingSizing, ...] = ()
    joints: tuple[JointSizing, ...] = ()
    checks: tuple[Check, ...] = ()
    """Every check of gears, shafts, carriers, bearings and joints, the worst first."""
    given: Mapping[str, Given] = field(default_factory=dict)
    """Path -> value that the user gave instead of the computed one, such as ``first.module``."""
    search: TeethSearch | None = None
    """How the teeth were chosen; None where the design gives them all."""

    @property
    def level(self) -> str:
        """How far the design is worked out: ``concept``, ``preliminary``, or ``built`` where it has bearings."""
        return self.design.level

    @property
    def gear_mass(self) -> Mass:
        """Mass of all gears [kg]."""
        return sum(gear.mass * gear.bodies for gear in self.gears)

    @property
    def shaft_mass(self) -> Mass:
        """Mass of all shafts [kg]."""
        return sum(shaft.mass for shaft in self.shafts)

    @property
    def carrier_mass(self) -> Mass:
        """Mass of all carriers [kg]."""
        return sum(carrier.mass for carrier in self.carriers)

    @property
    def bearing_mass(self) -> Mass:
        """Mass of all bearings of built shafts [kg]; not in `mass`, which compares designs with and without them."""
        return sum(bearing.bearing.mass for bearing in self.bearings)

    @property
    def planet_bearing_mass(self) -> Mass:
        """Mass of all bearings of planets that the design asks for; in `mass` of a preliminary sizing alone [kg]."""
        return sum(gear.runs_on.mass * gear.bodies for gear in self.gears if gear.runs_on)

    @property
    def system_life(
        self,
    ) -> Annotated[float | None, Quantity("life"), Origin("Σ (L/L_i)^e_i = 1", "Weibull's product")]:
        """Life that 90 % reach with no bearing failed [s]; None where no bearings are sized."""
        slopes = [weibull_slope(bearing.bearing.kind) for bearing in self.bearings]
        return system_life([bearing.judged_life for bearing in self.bearings], slopes) if self.bearings else None

    @property
    def mass(self) -> Mass:
        """Mass of gears, shafts and carriers, at a preliminary level with what planets turn on; or as weighed [kg].

        Motors, housing, bearings of shafts and oil are not in it.
        """
        weighed = self.given.get("gearbox.mass")
        return self.parts_mass if weighed is None else weighed.value

    @property
    def parts_mass(self) -> Mass:
        """Sum of gears, shafts and carriers, of a preliminary sizing with the bearings in its planets [kg]."""
        turning = self.planet_bearing_mass if self.level == PRELIMINARY else 0.0
        return self.gear_mass + self.shaft_mass + self.carrier_mass + turning

    @property
    def motor_mass(self) -> Mass:
        """Mass of all motors, generators and accessories [kg]."""
        return sum(machine.mass or 0.0 for machine in self.machines)

    @property
    def power_density(self) -> Annotated[float, Quantity("specific_power")]:
        """Rated power over the mass of gears, shafts and carriers [W/kg]."""
        return self.rated_power / self.mass

    @property
    def total_power_density(self) -> Annotated[float, Quantity("specific_power")]:
        """Rated power over gearbox and motors, as Pulvirenti 2023, appendix, has it [W/kg]."""
        return self.rated_power / (self.mass + self.motor_mass)

    @property
    def rated_power(self) -> Power:
        """What the machines put into the train in the case that speaks for the design [W]."""
        return sum(power for power in self.reference.machine_powers.values() if power > 0.0)

    @property
    def reference(self) -> PowerFlow:
        """The case that speaks for the design: ``rated``, or its first one that lasts."""
        return next(iter(self.flows.values()))

    @property
    def worst_margin(self) -> Number:
        """Margin of the worst check [-]: its reserve, or its ratio to the limit where it fails and no load moves it."""
        first = worst(self.checks)
        return math.inf if first is None or first.margin is None else first.margin
