"""Answers about one design: its sizing, its motion in one run, and what a rating rests on."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import Mass, Number, Power, Quantity, Ratio, shown, unit
from gearwright.particulars import Particulars
from gearwright.render.tables.checks import Judged, judged
from gearwright.render.tables.sizing import Property, Stands, material_properties, stands
from gearwright.sizing import (
    AskedSpeed,
    BearingSizing,
    Beside,
    BuiltShaft,
    CarrierSizing,
    GearSizing,
    Influence,
    JointSizing,
    MachineSizing,
    MassPart,
    MeshBeside,
    MeshInfluences,
    MeshSizing,
    Passing,
    RatedMesh,
    ShaftSizing,
    Sizing,
    Turn,
)
from gearwright.sizing.airscrew_loads import AirscrewCase
from gearwright.sizing.arrangement import Envelope
from gearwright.sizing.losses import Loss
from gearwright.sizing.mass import CompleteMass, Statistics
from gearwright.sizing.rating import METHODS, Factor
from gearwright.spec import implied
from gearwright.train import Branch

# ----------------------------------------------------------------------------------------------------------------------
# Answers about what a rating rests on: every factor, every method side by side, what moves the margins.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class FactorEntry:
    """One quantity of a rating."""

    chapter: str
    quantity: str
    equation: str
    """Symbol, or the equation that makes it."""
    values: tuple[Number, ...]
    """Of first and second gear, or one of the mesh; more are one list; in the unit beside."""
    unit: str
    limit: str
    """Limit of the standard at which it stands; empty where it stands at none."""
    clause: str


@dataclass(frozen=True)
class FactorsOfMesh:
    """Every factor of a mesh by the method that rates it, in the heaviest case over the whole life."""

    mesh: str
    gears: tuple[str, ...]
    method: str
    edition: str
    case: str
    factors: tuple[FactorEntry, ...]


@dataclass(frozen=True)
class AspectEntry:
    """One thing that every method has to say of a mesh."""

    aspect: str
    """In words, with the symbols of ISO and AGMA."""
    values: Mapping[str, tuple[Number, ...]]
    """Method -> of both gears, or one of the mesh, in the unit beside; methods without such a factor are left out."""
    unit: str
    why: str
    """Why the values differ; empty where they do not."""


@dataclass(frozen=True)
class MarginsByMethod:
    """Margins over the safeties that the method's rules ask."""

    flanks: Ratio
    roots: Ratio


@dataclass(frozen=True)
class MethodsOfMesh:
    """A mesh by every method, with teeth, module, width and loads of the design."""

    mesh: str
    aspects: tuple[AspectEntry, ...]
    margins: Mapping[str, MarginsByMethod]
    """Method -> its margins."""
    refused: Mapping[str, str]
    """Method -> why it does not rate this mesh."""


@dataclass(frozen=True)
class InfluenceEntry:
    """What turning one value does to the margins of a mesh."""

    handle: str
    """In words, with its symbol."""
    value: Number
    """As it is, in the unit beside."""
    unit: str
    flank: Ratio
    """∂ ln S_H/∂ ln x of the weaker gear: per cent for a per cent."""
    root: Ratio
    """∂ ln S_F/∂ ln x of the weaker gear: per cent for a per cent."""
    wanted: Number | None
    """Where the worst margin is the wished one, in the unit beside; null where a threefold change does not do."""


@dataclass(frozen=True)
class InfluencesOnMesh:
    """What moves the margins of a mesh."""

    mesh: str
    method: str
    margin: Ratio
    """The worst of flanks and roots, as it is."""
    wish: Ratio
    """Margin that is wished."""
    handles: tuple[InfluenceEntry, ...]


def factors_answer(rated: Iterable[RatedMesh]) -> tuple[FactorsOfMesh, ...]:
    """Return every factor of every rated mesh, as `gearwright size --factors --json` answers.

    Args:
        rated: From `rated_factors`.
    """
    return tuple(
        FactorsOfMesh(
            mesh.name, mesh.gears, mesh.rating.method, METHODS[mesh.rating.method].edition, mesh.rating.case,
            tuple(map(_factor, rows)),
        )
        for mesh, rows in rated
    )  # fmt: skip


def methods_answer(meshes: Iterable[MeshBeside]) -> tuple[MethodsOfMesh, ...]:
    """Return every mesh by every method, as `gearwright size --methods --json` answers.

    Args:
        meshes: From `methods_beside`.
    """
    return tuple(map(_methods, meshes))


def influences_answer(meshes: Iterable[MeshInfluences]) -> tuple[InfluencesOnMesh, ...]:
    """Return what moves the margins of every mesh, as `gearwright size --wish --json` answers.

    Args:
        meshes: From `influences`.
    """
    return tuple(map(_influences, meshes))


def _factor(row: Factor) -> FactorEntry:
    return FactorEntry(
        row.chapter, row.quantity, row.equation, tuple(_numbers(row)), unit(row.dimension), row.limit, row.clause
    )


def _numbers(row: Factor) -> Iterator[float]:
    for value in row.values:
        yield value if isinstance(value, int) else shown(float(np.asarray(value)), row.dimension)


def _methods(mesh: MeshBeside) -> MethodsOfMesh:
    margins = {method: MarginsByMethod(*pair) for method, pair in mesh.margins.items()}
    return MethodsOfMesh(mesh.mesh, tuple(map(_aspect, mesh.rows)), margins, mesh.refused)


def _aspect(line: Beside) -> AspectEntry:
    values = {name: tuple(shown(value, line.dimension) for value in both) for name, both in line.values.items()}
    return AspectEntry(line.aspect, values, unit(line.dimension), line.why)


def _influences(mesh: MeshInfluences) -> InfluencesOnMesh:
    return InfluencesOnMesh(mesh.mesh, mesh.method, mesh.margin, mesh.wish, tuple(map(_influence, mesh.rows)))


def _influence(row: Influence) -> InfluenceEntry:
    value, wanted = shown(row.value, row.dimension), row.wanted
    aim = None if wanted is None else shown(wanted, row.dimension)
    return InfluenceEntry(row.handle, value, unit(row.dimension), row.flank, row.root, aim)


# ----------------------------------------------------------------------------------------------------------------------
# Answers about one design: its sizing, its modes, its motion, and all of them in one run.
# ----------------------------------------------------------------------------------------------------------------------


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
    """Of motors, generators and accessories by themselves."""
    inverter_mass: Mass
    """Of their inverters, as far as they are counted."""
    cooling_mass: Mass
    """Of what cools them, as far as it is counted."""
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
    airscrew_loads: tuple[AirscrewCase, ...]
    """Of propellers and rotors by case, stated or assumed; empty at level concept."""
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
    """What is asked for beside the sizing itself; None of what nobody asks for."""

    factors: Sequence[RatedMesh] | None = None
    """From `rated_factors`."""
    methods: Sequence[MeshBeside] | None = None
    """From `methods_beside`."""
    influences: Sequence[MeshInfluences] | None = None
    """From `influences`."""


NOTHING_MORE = Asked()
"""The sizing alone."""


def size_answer(facts: Particulars, asked: Asked = NOTHING_MORE) -> SizeAnswer:
    """Return what `gearwright size --json` answers.

    Args:
        facts: Of the sizing.
        asked: Beside it.
    """
    sizing, complete = facts.sizing, facts.complete
    return SizeAnswer(
        level=sizing.level,
        implied=implied(sizing.design),
        mass=sizing.mass,
        gear_mass=sizing.gear_mass,
        shaft_mass=sizing.shaft_mass,
        carrier_mass=sizing.carrier_mass,
        bearing_mass=sizing.bearing_mass + sizing.planet_bearing_mass,
        motor_mass=sizing.motor_mass,
        inverter_mass=sizing.inverter_mass,
        cooling_mass=sizing.cooling_mass,
        rated_power=sizing.rated_power,
        power_density=sizing.power_density,
        worst_margin=sizing.worst_margin,
        teeth=sizing.teeth,
        cases=facts.branches,
        efficiencies=facts.passing,
        losses=tuple(loss for balance in facts.losses.values() for loss in balance.losses),
        margins=judged(sizing.checks),
        asked_speeds=facts.asked_speeds,
        airscrew_loads=facts.airscrew_loads,
        gears=sizing.gears,
        meshes=sizing.meshes,
        shafts=sizing.shafts,
        built_shafts=sizing.built_shafts,
        bearings=sizing.bearings,
        joints=sizing.joints,
        carriers=sizing.carriers,
        machines=sizing.machines,
        masses=facts.mass_parts,
        complete_mass=complete,
        complete_total=complete.total,
        complete_low=complete.band[0],
        complete_high=complete.band[1],
        complete_train=complete.train,
        statistics=facts.statistics,
        envelope=facts.envelope,
        places=stands(sizing.arrangement.bodies),
        turns=sizing.arrangement.turns,
        materials=material_properties(facts.materials),
        given=tuple(GivenEntry(row.entry, row.amount, row.origin) for row in sizing.given.values()),
        factors=None if asked.factors is None else factors_answer(asked.factors),
        methods=None if asked.methods is None else methods_answer(asked.methods),
        influences=None if asked.influences is None else influences_answer(asked.influences),
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
