"""Answers about one design: its sizing, its modes, its motion, and all of them in one run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, NamedTuple

from gearwright.render.answers.insight import (
    FactorsOfMesh,
    InfluencesOnMesh,
    MethodsOfMesh,
    factors_answer,
    influences_answer,
    methods_answer,
)
from gearwright.render.tables.checks import Judged, judged
from gearwright.render.tables.sizing.materials import Property, material_properties
from gearwright.render.tables.sizing.overview import shaft_by_shaft
from gearwright.render.tables.sizing.places import Stands, stands
from gearwright.sizing import AskedSpeed, MassPart, Passing, Sizing, Turn, asked_speeds, mass_parts, passing
from gearwright.sizing.arrangement.envelope import Envelope, envelope
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.losses import Loss, loss_balance
from gearwright.sizing.mass import CompleteMass, Statistics, complete_mass, statistics_beside
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing
from gearwright.sizing.result import GearSizing, MachineSizing
from gearwright.spec import implied
from gearwright.train import Branch
from gearwright.units import Mass, Power, Quantity


@dataclass(frozen=True)
class GivenEntry:
    """A value that the user gave in place of a computed one."""

    entry: str
    """Where it stands in the file, which ends in its unit."""
    amount: float
    """In that unit."""
    origin: str
    """Where the user has it from."""


@dataclass(frozen=True)
class SizeAnswer:
    """A sized transmission; equations and sources of its numbers stand in this schema."""

    level: str
    """How far the design is worked out: concept, preliminary or built."""
    implied: Mapping[str, str]
    """What the file leaves open and its level gives, the level itself too: path -> value."""
    mass: Mass
    """As sized: of gears, shafts and carriers, gears as discs of their pitch circles unless the level is preliminary,
    which counts bearings of planets, too; without motor, housing, other bearings and oil; or the user's own. What of
    the complete mass is the train: complete_train."""
    gear_mass: Mass
    shaft_mass: Mass
    carrier_mass: Mass
    bearing_mass: Mass
    """Of the chosen bearings of built shafts and of planets; in the mass are those of planets at level preliminary."""
    motor_mass: Mass
    rated_power: Power
    power_density: Annotated[float, Quantity("specific_power")]
    """Rated power over the mass."""
    worst_margin: Annotated[float | None, Quantity("ratio")]
    """Smallest factor by which loads may grow; 1 is just enough."""
    teeth: Mapping[str, int]
    """Gear -> tooth number."""
    cases: Mapping[str, tuple[Branch, ...]]
    """Load case -> every part on every shaft."""
    efficiencies: tuple[Passing, ...]
    """Of the gearbox and its epicyclic sets, forwards and backwards in every case; what is self-locking, by name."""
    losses: tuple[Loss, ...]
    """Of every mesh, bearing, gear and seal in every case, by the formulas of [losses]."""
    margins: tuple[Judged, ...]
    """Every check, the worst first."""
    asked_speeds: tuple[AskedSpeed, ...]
    """Asked speeds that the teeth give only nearly."""
    gears: tuple[GearSizing, ...]
    meshes: tuple[MeshSizing, ...]
    shafts: tuple[ShaftSizing, ...]
    built_shafts: tuple[BuiltShaft, ...]
    bearings: tuple[BearingSizing, ...]
    joints: tuple[JointSizing, ...]
    carriers: tuple[CarrierSizing, ...]
    machines: tuple[MachineSizing, ...]
    masses: tuple[MassPart, ...]
    """Gears, shafts and carriers, the heaviest first."""
    complete_mass: CompleteMass
    """Everything in it but machines, part by part with its origin."""
    complete_total: Mass
    """Sum of those parts."""
    complete_low: Mass
    """Lower limit of its band of 68 %."""
    complete_high: Mass
    """Upper limit of its band of 68 %."""
    complete_train: Mass
    """Of it gears, shafts and carriers, bodies as manufactured."""
    statistics: Statistics
    """What 61 real gearboxes say of its power and speeds."""
    envelope: Envelope
    places: tuple[Stands, ...]
    """Envelope of every body in space."""
    turns: tuple[Turn, ...]
    """Axes that the design leaves open and that were turned to make room."""
    materials: tuple[Property, ...]
    """Every property, in the unit beside it, with its source."""
    given: tuple[GivenEntry, ...]
    """Values that the user gave in place of computed ones."""
    factors: tuple[FactorsOfMesh, ...] | None
    """With --factors: every factor of every mesh that a standard rates; null where it is not asked for."""
    methods: tuple[MethodsOfMesh, ...] | None
    """With --methods: every mesh by every method; null where it is not asked for."""
    influences: tuple[InfluencesOnMesh, ...] | None
    """With --wish: what moves the margins of every mesh; null where it is not asked for."""


class Asked(NamedTuple):
    """What is asked for beside the sizing itself."""

    factors: bool = False
    methods: bool = False
    wish: float | None = None
    """Margin that is wished [-]; None: nobody asks what moves the margins."""


NOTHING_MORE = Asked()
"""The sizing alone."""


def size_answer(sizing: Sizing, asked: Asked = NOTHING_MORE) -> SizeAnswer:
    """Return what `gearwright size --json` answers.

    Args:
        sizing: As sized.
        asked: Beside it.
    """
    complete = complete_mass(sizing)
    return SizeAnswer(
        level=sizing.level,
        implied=implied(sizing.design),
        mass=sizing.mass,
        gear_mass=sizing.gear_mass,
        shaft_mass=sizing.shaft_mass,
        carrier_mass=sizing.carrier_mass,
        bearing_mass=sizing.bearing_mass + sizing.planet_bearing_mass,
        motor_mass=sizing.motor_mass,
        rated_power=sizing.rated_power,
        power_density=sizing.power_density,
        worst_margin=sizing.worst_margin,
        teeth=sizing.teeth,
        cases={case: tuple(shaft_by_shaft(sizing, case)) for case in sizing.flows},
        efficiencies=passing(sizing),
        losses=tuple(loss for case in sizing.flows for loss in loss_balance(sizing, case).losses),
        margins=judged(sizing.checks),
        asked_speeds=asked_speeds(sizing),
        gears=sizing.gears,
        meshes=sizing.meshes,
        shafts=sizing.shafts,
        built_shafts=sizing.built_shafts,
        bearings=sizing.bearings,
        joints=sizing.joints,
        carriers=sizing.carriers,
        machines=sizing.machines,
        masses=mass_parts(sizing),
        complete_mass=complete,
        complete_total=complete.total,
        complete_low=complete.band[0],
        complete_high=complete.band[1],
        complete_train=complete.train,
        statistics=statistics_beside(sizing, complete),
        envelope=envelope(sizing),
        places=stands(sizing.arrangement.bodies),
        turns=sizing.arrangement.turns,
        materials=material_properties(sizing),
        given=tuple(GivenEntry(row.entry, row.amount, row.origin) for row in sizing.given.values()),
        factors=factors_answer(sizing) if asked.factors else None,
        methods=methods_answer(sizing) if asked.methods else None,
        influences=None if asked.wish is None else influences_answer(sizing, asked.wish),
    )


@dataclass(frozen=True)
class CheckAnswer:
    """What is wrong with a design that can be sized."""

    holds: bool
    """True if no check fails; else the exit code is 1."""
    failing: tuple[Judged, ...]
    """Checks that fail, the worst first."""
    implied: Mapping[str, str]
    """What the file leaves open and its level gives: path -> value."""


def check_answer(sizing: Sizing) -> CheckAnswer:
    """Return what `gearwright check --json` answers.

    Args:
        sizing: As sized.
    """
    failing = judged(check for check in sizing.checks if check.fails)
    return CheckAnswer(not failing, failing, implied(sizing.design))
