"""Results of a sizing: values with unit, equation and source, tooth selection, meshes and arrangement."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from functools import cache, cached_property
from types import NoneType
from typing import Annotated, Any, NamedTuple, get_type_hints

from gearwright.base import (
    Angle,
    Check,
    DesignError,
    Inertia,
    Length,
    Mass,
    Number,
    Origin,
    OriginOf,
    PartId,
    Power,
    Problem,
    Quantity,
    Ratio,
    Role,
    Row,
    Shown,
    Torque,
    gear_part,
    marks_of,
    mesh_part,
    worst,
)
from gearwright.parts.bearings import system_life, weibull_slope
from gearwright.shipped import shipped_design, shipped_designs
from gearwright.sizing.rating import MeshRating
from gearwright.sizing.shaft_results import (
    BearingSizing,
    BuiltShaft,
    CarrierSizing,
    JointSizing,
    PlanetBearingSizing,
    ShaftSizing,
)
from gearwright.spec import Design, Record, parse
from gearwright.spec.design import CONCEPT, BearingSeat, Given
from gearwright.train import PowerFlow, Train

# ----------------------------------------------------------------------------------------------------------------------
# How the teeth of a sizing were chosen: how many combinations there were, and how far the next one is.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class TeethSearch:
    """What the search for teeth looked at."""

    combinations: Annotated[float, Quantity("number"), Origin("Π of candidates within the rules of [teeth]", "search")]
    """Combinations of tooth numbers and planets that were told apart; what cannot win before all stages have teeth
    counts once [-]."""
    weighed: int
    """Candidates of single stages that were weighed for it [-]."""
    gear_mass: Mass
    """What the gears weigh by the search's own estimate [kg]."""
    next_mass: Mass
    """What the gears of the next-lightest combination weigh by it; infinite where there is none [kg]."""
    proven: bool
    """True where none of the combinations can be lighter by that estimate; False where there were too many to hold."""
    sized: int = 1
    """Combinations, those of the lightest gears first, that were sized in full and came out; where sizes are compared,
    those whose gears were sized [-]."""
    failing: int = 0
    """How many of these fail a check; where sizes are compared, a check of their gears [-]."""
    refused: int = 0
    """Combinations that were sized and are refused [-]."""
    next_sized_mass: Mass = math.inf
    """What the next-lightest complete gearbox weighs of those from which one is taken; infinite where there is none
    [kg]."""


# ----------------------------------------------------------------------------------------------------------------------
# What sizing yields of a row of meshes: its forces, and what the method of its stage makes of them.
# ----------------------------------------------------------------------------------------------------------------------


_PULVIRENTI = "Pulvirenti 2023"


@dataclass(frozen=True)
class MeshSizing:
    """One row of equal meshes at its worst case."""

    stage: str
    """Pair or planetary set that it belongs to."""
    row: Row
    """Which meshes of the stage it holds."""
    gears: tuple[str, str]
    """Names of the two gears."""
    count: int
    """Number of equal meshes."""
    case: str
    """Load case that governs."""
    load_factor: Ratio
    """Mesh load factor K_γ [-]."""
    tangential_force: Annotated[float, Quantity("force"), Origin("F_t = 2 T K_γ / (N d_w)", f"{_PULVIRENTI}, eq. 2.9")]
    """Tangential force of one mesh at its working pitch circles [N]."""
    radial_force: Annotated[
        float,
        Quantity("force"),
        Origin(
            "F_r = F_t tan α_wt; bevel: F_t (tan α_n cos δ ∓ sin β_m sin δ) / cos β_m",
            "ISO 21771:2007; ISO 23509:2016",
        ),
    ]
    """Radial force of one mesh [N]; of a bevel mesh on its pinion."""
    axial_force: Annotated[
        float,
        Quantity("force"),
        Origin(
            "F_a = F_t (d_w/d) tan β; bevel: F_t (tan α_n sin δ ± sin β_m cos δ) / cos β_m",
            "ISO 21771:2007; ISO 23509:2016",
        ),
    ]
    """Axial force of one mesh [N]; balanced inside a double-helical gear; of a bevel mesh on its pinion."""
    pitch_line_velocity: Annotated[float, Quantity("velocity"), Origin("v = (ω − ω_c) d_w/2", "kinematics")]
    """Pitch-line velocity relative to the carrier [m/s]."""
    centre_distance: Annotated[
        float,
        Quantity("length"),
        Origin("a_w: given, or where x_1 + x_2 leave no backlash; bevel: r_1 + r_2", "ISO 21771:2007"),
    ]
    """Working centre distance a_w [m]; of a bevel mesh what the drawn shafts stand apart."""
    working_pressure_angle: Annotated[
        float,
        Quantity("angle"),
        Origin("cos α_wt = a cos α_t/a_w", "ISO 21771:2007"),
    ]
    """Transverse pressure angle at the working pitch circles α_wt [rad]."""
    working_diameter: Annotated[
        float, Quantity("length"), Origin("d_w1 = 2 a_w z_1/(z_1 + z_2)", "ISO 21771:2007, z_2 < 0 in a ring")
    ]
    """Working pitch diameter of the first gear d_w1 [m]; of bevel and face gears d."""
    rating: MeshRating
    """What the method of its stage makes of it, with that method's equations and sources."""

    @property
    def module_bending(self) -> Annotated[float, Quantity("length"), OriginOf("rating")]:
        """Module that bending asks for [m]."""
        return self.rating.module_bending

    @property
    def module_contact(self) -> Annotated[float, Quantity("length"), OriginOf("rating")]:
        """Module that contact asks for [m]."""
        return self.rating.module_contact

    @property
    def bending_stress(self) -> Annotated[float, Quantity("stress"), OriginOf("rating")]:
        """Of the higher stressed root [Pa]."""
        return self.rating.bending_stress

    @property
    def bending_margin(self) -> Annotated[float, Quantity("ratio"), OriginOf("rating")]:
        """Allowable over actual bending stress, or safety over the asked one [-]; 1 is just enough."""
        return self.rating.bending_margin

    @property
    def contact_stress(self) -> Annotated[float, Quantity("stress"), OriginOf("rating")]:
        """Of the higher stressed flank [Pa]."""
        return self.rating.contact_stress

    @property
    def contact_margin(self) -> Annotated[float, Quantity("ratio"), OriginOf("rating")]:
        """Allowable over actual contact stress, or safety over the asked one [-]; 1 is just enough."""
        return self.rating.contact_margin

    branch: str = ""
    """Shaft that tells it from the other rows of a pair; empty where the pair has one."""
    own: str = ""
    """What the design calls its two gears, in a compound set."""

    @cached_property
    def part(self) -> PartId:
        """Who it is."""
        return mesh_part(self.stage, self.row, self.branch, own=self.own)

    @cached_property
    def name(self) -> str:
        """Its label, such as ``first.sun-planet``."""
        return str(self.part)


# ----------------------------------------------------------------------------------------------------------------------
# Where everything in a sized transmission stands, as records: axes, places along every shaft, bodies in space.
#
# Axes and plans are found once, by `arrangement`, before shafts are sized; frames and bodies once, by `places`, when
# all is sized. Loads, checks, drawings, flights and reports read them. The origin is the first end of the design's
# first shaft, x runs along it, y and z are those of its cross-section.
# ----------------------------------------------------------------------------------------------------------------------


class Point(NamedTuple):
    """A place in space."""

    x: Length
    """[m]"""
    y: Length
    """[m]"""
    z: Length
    """[m]"""


class Direction(NamedTuple):
    """A unit vector."""

    x: Number
    """[-]"""
    y: Number
    """[-]"""
    z: Number
    """[-]"""


class Station(NamedTuple):
    """A circle square to a body's axis."""

    place: Length
    """From the body's origin on along its axis [m]."""
    radius: Length
    """[m]"""


@dataclass(frozen=True)
class Frame:
    """The axes of one shaft in space."""

    origin: Point
    """Its first end."""
    along: Direction
    """From its first end to its second one: its x."""
    across: Direction
    """The y of its cross-section."""
    up: Direction
    """The z of its cross-section."""


@dataclass(frozen=True)
class Body:
    """The envelope of one part: the hull of circles about an axis, less a bore; cylinders and cones are two circles."""

    part: PartId
    """Who it is; planets of a set are one body, the ring that they sweep."""
    shaft: str
    """Shaft that it turns with or stands on, or ``ground``."""
    what: str
    """What of the part it is, where it is one of several: ``40 to 46 mm`` of a shaft, ``teeth`` of a bevel gear."""
    origin: Point
    """On its axis, at its first end."""
    direction: Direction
    """Of its axis."""
    stations: tuple[Station, ...]
    """Circles whose hull it is, in order along the axis, the first at the origin."""
    bore: Length = 0.0
    """Radius about the axis within which there is nothing of it [m]."""

    @property
    def length(self) -> Length:
        """Along the axis [m]."""
        return self.stations[-1].place

    @property
    def radius(self) -> Length:
        """The largest [m]."""
        return max(station.radius for station in self.stations)

    @property
    def name(self) -> str:
        """Its part, and what of it."""
        return f"{self.part} ({self.what})" if self.what else str(self.part)


@dataclass(frozen=True)
class Turn:
    """An axis that the design leaves open and that was turned about its mate to make room."""

    shaft: str
    """Of that axis."""
    before: Angle
    """Direction from its mate where nothing is in the way [rad]."""
    after: Angle
    """Direction from its mate with room around it [rad]."""
    why: str
    """What was in the way."""


@dataclass(frozen=True)
class ShaftPlan:
    """A shaft from its first end on."""

    length: Length
    """[m]"""
    bearings: tuple[Length, Length]
    """Middles of its two radial bearings, from the first end [m]."""
    places: Mapping[str, Length]
    """Gear, carrier, machine or clutch -> middle of its width, from the first end [m], in order."""
    seats: Mapping[str, BearingSeat] = field(default_factory=dict)
    """Bearings that the design gives the shaft, by name, in order along it; none where it leaves them open."""


@dataclass(frozen=True)
class Arrangement:
    """Axes and shafts of a transmission."""

    axes: Mapping[str, complex]
    """Shaft -> where its axis stands in the cross-section, y + i z [m], seen along x. The shafts of a bevel pair stand
    beside each other, as if the wheel's were turned into the pinion's; `frames` has them as they cross."""
    plans: Mapping[str, ShaftPlan]
    """Shaft -> where everything sits along it."""
    frames: Mapping[str, Frame] = field(default_factory=dict)
    """Shaft -> its axes in space."""
    bodies: tuple[Body, ...] = ()
    """Gears, free stretches of shafts, bearings, carriers."""
    apart: Mapping[str, Length] = field(default_factory=dict)
    """Mesh row -> how far its gears stand from where they mesh, along their axes [m]; those beside each other left
    out."""
    turns: tuple[Turn, ...] = ()
    """Axes that were turned to make room."""
    within: tuple[tuple[str, str], ...] = ()
    """Inner and outer shaft, where one goes through the other."""
    turned: tuple[str, ...] = ()
    """Planetary sets whose planes lie the other way round along the axis."""
    two_sided: tuple[str, ...] = ()
    """Planetary sets whose carrier's shaft leaves them on both sides."""
    unordered: tuple[tuple[str, ...], ...] = ()
    """Shafts of every axis on which no order was found in which all have room."""


# ----------------------------------------------------------------------------------------------------------------------
# What sizing yields: every value with its unit and the equation and source that made it.
# ----------------------------------------------------------------------------------------------------------------------


_THESIS = "Pulvirenti 2023"
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
    """Polar inertia of one body about its own axis, above level concept with m of the body as it is made [kg m²]."""
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
        Origin(
            "0.0299 T^0.833 n^0.234 kg; 0.3928 Q^0.8587 lb, or k T^0.33",
            "public machines for aircraft; NDARC (NASA/TP-2015-218751); Pulvirenti 2023",
        ),
    ]
    """Of a motor, generator or accessory by itself; None where the gearbox does not size it [kg]."""
    inertia: Inertia
    """Polar inertia of what turns [kg m²]."""
    inertia_is_given: bool
    """True if the design gives it, False if it is estimated."""
    inverter: Annotated[
        float | None, Quantity("mass"), Origin("P/(12 kW/kg)", "7.5 to 19 kW/kg of public inverters")
    ] = None
    """Mass of its inverter; None where none is counted [kg]."""
    cooling: Annotated[
        float | None, Quantity("mass"), Origin("0.8 kg/kW · P (1/0.95 - 1)", "an estimate: 0.2 to 1.5 kg/kW")
    ] = None
    """Mass of what cools it and its inverter; None where none is counted [kg]."""

    @property
    def installed(self) -> float:
        """Mass with inverter and cooling [kg]."""
        return (self.mass or 0.0) + (self.inverter or 0.0) + (self.cooling or 0.0)


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
        """Mass of all bearings of planets that the design asks for; in `mass` above level `concept` [kg]."""
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
        """Mass of gears, shafts and carriers, above level `concept` with what planets turn on; or as weighed [kg].

        Motors, housing, bearings of shafts and oil are not in it.
        """
        weighed = self.given.get("gearbox.mass")
        return self.parts_mass if weighed is None else weighed.value

    @property
    def parts_mass(self) -> Mass:
        """Sum of gears, shafts and carriers, above level `concept` with the bearings in planets [kg]."""
        turning = 0.0 if self.level == CONCEPT else self.planet_bearing_mass
        return self.gear_mass + self.shaft_mass + self.carrier_mass + turning

    @property
    def motor_mass(self) -> Mass:
        """Mass of all motors, generators and accessories by themselves [kg]."""
        return sum(machine.mass or 0.0 for machine in self.machines)

    @property
    def inverter_mass(self) -> Mass:
        """Mass of the inverters of motors and generators, as far as they are counted [kg]."""
        return sum(machine.inverter or 0.0 for machine in self.machines)

    @property
    def cooling_mass(self) -> Mass:
        """Mass of what cools motors, generators and their inverters, as far as it is counted [kg]."""
        return sum(machine.cooling or 0.0 for machine in self.machines)

    @property
    def machines_mass(self) -> Mass:
        """Mass of all motors, generators and accessories with inverters and cooling [kg]."""
        return self.motor_mass + self.inverter_mass + self.cooling_mass

    @property
    def power_density(self) -> Annotated[float, Quantity("specific_power")]:
        """Rated power over the mass of gears, shafts and carriers [W/kg]."""
        return self.rated_power / self.mass

    @property
    def total_power_density(self) -> Annotated[float, Quantity("specific_power")]:
        """Rated power over gearbox and machines; Pulvirenti 2023, appendix, has motors alone [W/kg]."""
        return self.rated_power / (self.mass + self.machines_mass)

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


# ----------------------------------------------------------------------------------------------------------------------
# The gate through which a sizing leaves: every number is one, and what physics wants above nothing is above nothing.
#
# A field marked `Endless` may be infinite, such as a margin where nothing loads the part; no other may. None is NaN.
# ----------------------------------------------------------------------------------------------------------------------


_POSITIVE = {
    GearSizing: ("module", "face_width", "pitch_diameter", "mass", "inertia"),
    ShaftSizing: ("length", "diameter", "mass", "stiffness"),
    CarrierSizing: ("radius", "pin_diameter", "plate_thickness", "mass", "inertia"),
    MachineSizing: ("inertia",),
}
"""Record -> fields that are above zero in every part that there can be."""
_UNSTATED = ("accessory", "load")
"""Kinds of machines that have no inertia where none is stated."""
_STANDS_OUT = 1.0
"""Powers of ten beyond the range of the shipped designs from which on a number of a design stands out [-]."""

_PLAIN = frozenset({int, str, bool, NoneType, Role, Row, PartId})
"""Kinds of values that hold no number which could be none."""
_WORDS = _PLAIN | {tuple[str, str]}
"""Declared types of fields that hold no number which could be none."""


def refuse_no_numbers(sizing: Sizing) -> Sizing:
    """Return a sizing whose every result is a number that a part can have.

    Args:
        sizing: As computed.

    Raises:
        DesignError: With part, field and value of what is none, and the number of the design that stands out, if any.
    """
    wrong = [] if _all_numbers(sizing) else [*_parts(sizing)]
    if not wrong and not 0.0 < sizing.mass < math.inf:
        wrong = [("gearbox", "mass", sizing.mass)]
    if not wrong:
        return sizing
    part, field, value = wrong[0]
    message = f"{part}: the {field.replace('_', ' ')} comes out as {value:g}, which no part has"
    raise DesignError([_blamed(sizing.design, message)])


def _all_numbers(sizing: Sizing) -> bool:
    """Tell quickly whether every result is a number that a part can have; which is none is for `_parts`."""
    groups = (*_groups(sizing), tuple(sizing.flows.values()))
    return all(_is_number(part) for group in groups for part in group) and all(
        getattr(part, field) > 0.0 for group in _groups(sizing) for part in group for field in _positive(part)
    )


def _is_number(value: Any, *, endless: bool = False) -> bool:
    """Tell whether every number inside a value is one; infinite only where it may be."""
    kind: Any = type(value)
    if kind is float:
        return math.isfinite(value) or (endless and not math.isnan(value))
    if kind in _PLAIN:
        return True
    if kind is tuple or kind is dict:
        items, may_be = (value, endless) if kind is tuple else (value.values(), False)
        for item in items:
            if not (type(item) is float and item - item == 0.0) and not _is_number(item, endless=may_be):
                return False
        return True
    if not (names := _numbers_of(kind)):
        return not any(True for _ in _wrong(value, "", endless=endless))
    for name, may_be in names:
        item = getattr(value, name)
        if type(item) is float and item - item == 0.0:  # which only finite numbers are
            continue
        if type(item) not in _PLAIN and not _is_number(item, endless=may_be):
            return False
    return True


@cache
def _numbers_of(kind: type) -> tuple[tuple[str, bool], ...]:
    """Return the fields of a kind of record that hold numbers, each with whether it may be infinite."""
    if not is_dataclass(kind):
        return ()
    marks, declared = marks_of(kind), get_type_hints(kind)
    return tuple(
        (entry.name, marks[entry.name].endless) for entry in fields(kind) if declared[entry.name] not in _WORDS
    )


def _groups(sizing: Sizing) -> tuple[tuple[Any, ...], ...]:
    return (sizing.gears, sizing.meshes, sizing.shafts, sizing.carriers, sizing.machines, sizing.built_shafts,
            sizing.bearings, sizing.joints, sizing.checks)  # fmt: skip


def _positive(part: Any) -> tuple[str, ...]:
    """Return the fields of a part that are above zero."""
    unstated = isinstance(part, MachineSizing) and part.kind in _UNSTATED
    return () if unstated else _POSITIVE.get(type(part), ())


def _parts(sizing: Sizing) -> Iterator[tuple[str, str, float]]:
    """Yield part, field and value of every result that is no number, or not above zero where it should be."""
    for group in _groups(sizing):
        for part in group:
            name = str(getattr(part, "name", getattr(part, "part", getattr(part, "stage", ""))))
            yield from ((name, field, value) for field, value in _wrong(part, ""))
            for size in _positive(part):
                if not getattr(part, size) > 0.0:
                    yield name, size, getattr(part, size)
    for case, flow in sizing.flows.items():
        yield from ((f"case {case}", field, value) for field, value in _wrong(flow, ""))


def _wrong(value: Any, field: str, *, endless: bool = False) -> Iterator[tuple[str, float]]:
    """Yield every number inside a value that is none, with the name of its field."""
    kind: Any = type(value)
    if isinstance(value, float):
        if math.isnan(value) or (math.isinf(value) and not endless):
            yield field, value
    elif names := _numbers_of(kind):
        for name, may_be in names:
            yield from _wrong(getattr(value, name), name, endless=may_be)
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _wrong(item, f"{field} of {key}")
    elif isinstance(value, tuple):
        for item in value:
            yield from _wrong(item, field, endless=endless)


class _Written(NamedTuple):
    """A number that the user wrote."""

    path: str
    """Of it in the design."""
    key: str
    """The path with a star for every name that a user chooses: what it is in any design."""
    value: float
    """In SI."""


def _blamed(design: Design, message: str) -> Problem:
    """Return the problem with the number of a design that is farthest beyond those of the shipped designs, if any is.

    Args:
        message: What is wrong.
    """
    known = _shipped_ranges()
    numbers = [number for number in _written(design) if number.key in known]
    beyond = [_beyond(number.value, known[number.key]) for number in numbers]
    if max(beyond, default=0.0) < _STANDS_OUT:
        return Problem("", f"{message}; no number of the design stands out")
    worst = numbers[beyond.index(max(beyond))]
    least, most = known[worst.key]
    span = f"{least:g}" if least == most else f"{least:g} to {most:g}"
    evidence = f"{worst.path} = {worst.value:g} stands out: the shipped designs have {span} there (all in SI)"
    return Problem(worst.path, f"{message}; {evidence}")


def _beyond(value: float, span: tuple[float, float]) -> float:
    """Return by how many powers of ten the size of a number is beyond a range [-]; below zero inside it."""
    size = math.log10(abs(value))
    return max(math.log10(span[0]) - size, size - math.log10(span[1]))


@cache
def _shipped_ranges() -> Mapping[str, tuple[float, float]]:
    """Return the least and the largest size of every number of the shipped designs, by its key."""
    sizes: dict[str, list[float]] = {}
    for name in shipped_designs():
        for number in _written(parse(shipped_design(name).read_text(encoding="utf-8"))):
            sizes.setdefault(number.key, []).append(abs(number.value))
    return {key: (min(found), max(found)) for key, found in sizes.items()}


def _written(value: Any, path: str = "", key: str = "") -> Iterator[_Written]:
    """Yield every number but zero that the user wrote."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        if value:
            yield _Written(path, key, float(value))
    elif isinstance(value, Record):
        for name in value.model_fields_set:
            kind = name if name in type(value).model_fields else "*"
            yield from _written(getattr(value, name), f"{path}.{name}".strip("."), f"{key}.{kind}".strip("."))
    elif isinstance(value, Mapping):
        for name, item in value.items():  # a number stands under a path, whose last name is not the user's
            kind = "*" if isinstance(item, Record | Mapping) else name.rpartition(".")[2]
            yield from _written(item, f"{path}.{name}", f"{key}.{kind}")
    elif isinstance(value, tuple):
        for item in value:
            yield from _written(item, path, key)
