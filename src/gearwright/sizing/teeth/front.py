"""Partial choices of tooth numbers in the search, dominated choices, and stages with equal teeth."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import SIDES, Bools, Floats, Ints
from gearwright.sizing.rating import Load, Rating
from gearwright.sizing.rough_mass import Around
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import ForbiddenBand, StageShifts, module_owners
from gearwright.train import Edge, Targets, gear_of, gears_of, members_of

# ----------------------------------------------------------------------------------------------------------------------
# What the search for teeth works on: a front of partial choices as arrays, and one task per stage.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Front:
    """All partial choices: every array has one entry per choice."""

    teeth: Mapping[str, Ints]
    """Gear -> tooth numbers."""
    speeds: Mapping[str, Floats]
    """Shaft -> speed that the teeth give [rad/s]."""
    cubes: Mapping[str, Floats]
    """Group of gears with one module -> m_n³ [m³]."""
    volumes: Mapping[str, Floats]
    """Group -> mass of its bodies over m_n³ [kg/m³]."""
    planets: Mapping[str, Ints] = field(default_factory=dict)
    """Planetary set -> number of its planets [-]."""
    tally: Mapping[str, Floats] = field(default_factory=dict)
    """What a choice stands for: ``combinations`` of teeth that it was the lightest of [-], and the mass of the
    ``second`` lightest of them [kg]."""

    def __len__(self) -> int:
        """Return how many choices there are."""
        return len(next(iter(self.speeds.values())))

    @property
    def mass(self) -> Floats:
        """Mass of the gears chosen so far [kg]."""
        parts = [self.cubes[group] * self.volumes[group] for group in self.cubes]
        return np.sum(parts, axis=0) if parts else np.zeros(1)

    def take(self, index: Ints | Bools) -> Front:
        """Return the choices of an index, repeated where it repeats them, or those that are marked."""
        return self._of_parts(lambda values: values[0][index], self)

    def joined(self, others: Sequence[Front]) -> Front:
        """Return the choices of this front and, after them, those of others that chose for the same stages."""
        return self._of_parts(np.concatenate, self, *others)

    @staticmethod
    def _of_parts(made: Callable[[list[Any]], Any], *fronts: Front) -> Front:
        """Return a front whose every array is made of those of the same name."""
        parts = [[getattr(front, part.name) for front in fronts] for part in fields(Front)]
        return Front(*({name: made([part[name] for part in same]) for name in same[0]} for same in parts))


class Part(NamedTuple):
    """A part of the life of a stage, or a limit load, beside its largest load."""

    case: str
    torque: float
    """Over the largest [-]."""
    speed: float
    """Rolling speed over that of the largest load [-]."""
    life: float
    """How long it lasts [s]; 0 of a case that counts for resonance alone."""
    static: bool = False


class Ban(NamedTuple):
    """A forbidden band of frequencies as one stage is held against it."""

    name: str
    band: ForbiddenBand
    factor: float
    """Speeds of the case over those of the search [-]."""


@dataclass(frozen=True)
class Task:
    """One stage of the search."""

    name: str
    stage: Pair | Planetary
    edge: Edge | None
    group: str
    rating: Rating
    torque: float
    """Largest nominal torque on the stage's reference gear, of one mesh or of all planets, K_γ included [N m]."""
    speed: float
    """Nominal speed of the edge's fast shaft; where the teeth let it turn faster, the torque is less [rad/s]."""
    rolling: float
    """Nominal speed of pinion or sun against the carrier [rad/s]."""
    rows: tuple[Load, ...] = ()
    """Of each loaded row of a bevel pair the heaviest case over the whole life, without teeth."""
    made: bool = False
    """Whether gears are weighed with rims and webs, as at a preliminary level."""
    twin: str = ""
    """Stage before it whose teeth it has, because what both do is the same; empty where it has none."""
    deviation: int = 0
    """z_r − (z_s + 2 z_p) of a ring that is chosen [-]."""
    bans: tuple[Ban, ...] = ()
    """Bands of frequencies at which nothing of it passes."""
    factors: Mapping[int, float] = field(default_factory=dict)
    """Number of planets that is looked at -> its K_γ [-]; empty of pairs."""
    steady: float = 1.0
    """Load for which tips are relieved over the largest one [-]."""
    fastest: float = 1.0
    """Greatest rolling speed over the one at the largest load [-]."""
    parts: tuple[Part, ...] = ()
    """Its life, where a standard sizes it on a grid."""
    around: Around | None = None
    """What carries, encloses and cools its gears is estimated from it; None where nothing loads it."""
    known: dict[tuple[int, int, int, int], tuple[float, ...]] = field(default_factory=dict, compare=False, repr=False)
    """Teeth of pinion or sun, of wheel or planet, number of planets, deviation of the ring -> m_n³ [m³], λ = b/m_n [-]
    and what is around its gears over m_n³ [kg/m³] at nominal load, as far as found."""
    closed: dict[tuple[int, int, int], StageShifts | None] = field(default_factory=dict, compare=False, repr=False)
    """Teeth of sun, planet and ring -> shifts that close them, as far as looked for; None where none do."""


# ----------------------------------------------------------------------------------------------------------------------
# What partial choices leave to the stages after them: of those that leave the same, the lightest are kept.
#
# This is dynamic programming: the teeth of a stage reach others by the speeds of shafts, by gears that two stages
# share, and by modules that several have together, and by nothing else.
# ----------------------------------------------------------------------------------------------------------------------


EQUAL = 1e-9
"""Masses that differ by less are equal: the first of them, of the fewest teeth, is taken, whatever the rounding."""
_SAME_SPEED = 1e-12
"""Part by which speeds may differ that are the same but for rounding [-]."""

_STILL = 1e-12
"""Speed of a shaft that stands still, for its logarithm [rad/s]."""


class Needs(NamedTuple):
    """What the stages that are still to come read of a choice."""

    shafts: frozenset[str]
    """Whose speeds."""
    gears: frozenset[str]
    """Whose teeth."""
    groups: frozenset[str]
    """Whose modules are not settled yet."""
    kept: int = 1
    """How many of the lightest that leave the same [-]."""
    every: bool = False
    """All teeth and numbers of planets tell choices apart: only whole trains are held against some of the rules."""


def needs_of(later: Sequence[Task], design: Design, *, kept: int = 1) -> Needs:
    """Return what stages that are still to come read of the choices before them.

    Args:
        later: Those stages.
        design: The design.
        kept: How many of the lightest whole combinations are asked for [-].
    """
    owners = module_owners(design)
    tied = {name: pair.coaxial_with for name, pair in design.pairs.items() if pair.coaxial_with is not None}
    groups = {task.group for task in later} | {owners[name] for name in (*tied, *tied.values())}
    gears = {str(gear) for name in (*tied, *tied.values()) for gear in gears_of(name, design.pairs[name])}
    if not later:
        return Needs(frozenset(), frozenset(gears), frozenset(groups), kept)
    shafts = {shaft for clutch in design.clutches.values() for shaft in (clutch.driving, clutch.driven)}
    shafts |= {shaft for epicyclic in design.epicyclics.values() for shaft in epicyclic.members}
    for task in later:
        shafts.update(() if task.edge is None else (*task.edge.fast, *task.edge.slow))
        if isinstance(task.stage, Planetary):
            shafts.update(members_of(task.stage))
        if isinstance(task.stage, Pair):
            gears |= {str(gear_of(task.name, side, task.stage)) for side in SIDES if task.stage.shared(side)}
        if task.twin:
            gears |= set(gears_of(task.twin, task.stage))
    return Needs(frozenset(shafts), frozenset(gears), frozenset(groups), kept)


def lightest(front: Front, needs: Needs) -> Front:
    """Return the lightest of the choices that leave the same to the stages after them, with what it stands for.

    Args:
        front: Choices, those of the fewest teeth first.
        needs: What the stages after them read.
    """
    state, mass = states_of(front, needs), front.mass
    if needs.kept > 1:
        return _several(front, state, needs.kept)
    count = int(state.max()) + 1
    least = np.full(count, np.inf)
    np.minimum.at(least, state, mass)
    light = np.flatnonzero(mass <= least[state] * (1.0 + EQUAL))
    chosen = np.sort(light[np.unique(state[light], return_index=True)[1]])
    if len(chosen) == len(front):
        return front
    others, second = mass.copy(), np.full(count, np.inf)
    others[chosen] = np.inf
    np.minimum.at(second, state, np.minimum(others, front.tally["second"]))
    stands = np.bincount(state, weights=front.tally["combinations"], minlength=count)
    kept = front.take(chosen)
    tally: dict[str, Floats] = {"combinations": np.asarray(stands, dtype=float)[state[chosen]]}
    return replace(kept, tally={**tally, "second": second[state[chosen]]})


def ranks_of(mass: Floats) -> Floats:
    """Return numbers in the order of masses, the same for those that are equal but for rounding [-].

    Args:
        mass: Of choices [kg].
    """
    return np.rint(np.log(np.maximum(mass, _STILL)) / EQUAL)


def _several(front: Front, state: Ints, kept: int) -> Front:
    """Return so many of the lightest of every state; the lightest stands for those that are left out."""
    order = np.lexsort((front.mass, state))
    begins = np.flatnonzero(np.diff(state[order], prepend=-1))
    begin = np.repeat(begins, np.diff(begins, append=len(order)))
    light = np.arange(len(order)) - begin < kept
    if light.all():
        return front
    combinations, second = front.tally["combinations"].copy(), front.tally["second"].copy()
    gone, first = order[~light], order[begin[~light]]
    np.add.at(combinations, first, front.tally["combinations"][gone])
    np.minimum.at(second, first, np.minimum(front.mass[gone], front.tally["second"][gone]))
    places = np.sort(order[light])
    return replace(front.take(places), tally={"combinations": combinations[places], "second": second[places]})


def states_of(front: Front, needs: Needs) -> Ints:
    """Return a number for each choice, the same for those that leave the same behind.

    Args:
        front: Choices.
        needs: What the stages after them read.
    """
    columns: list[Ints] = [
        np.rint(np.log(np.maximum(speed, _STILL)) / _SAME_SPEED).astype(np.int64)
        for shaft, speed in front.speeds.items()
        if shaft in needs.shafts and len(speed) > 1
    ]
    columns += [teeth for gear, teeth in front.teeth.items() if needs.every or gear in needs.gears]
    columns += list(front.planets.values()) if needs.every else []
    for group in needs.groups & front.cubes.keys():
        columns += [front.cubes[group].view(np.int64), front.volumes[group].view(np.int64)]
    state = np.zeros(len(front), dtype=np.int64)
    for column in columns:
        if column.min() != column.max():
            _, place = np.unique(column, return_inverse=True)
            _, state = np.unique(state * (int(place.max()) + 1) + place, return_inverse=True)
    return state


# ----------------------------------------------------------------------------------------------------------------------
# Twins: stages that do the same in the same place, such as inputs of two equal engines, and have the same teeth.
# ----------------------------------------------------------------------------------------------------------------------


_PLACES = {"pinion", "wheel", "sun", "ring", "carrier"}
"""Keys of a stage that say where it stands."""
_SAME = 1e-9
"""Part by which loads and speeds of twins may differ [-]."""


def with_twins(tasks: Sequence[Task], design: Design, nominal: Targets) -> list[Task]:
    """Return the stages of the search, of which each says whose teeth it has for being the same.

    Args:
        tasks: Every stage.
        design: The design.
        nominal: Asked speeds.
    """
    whole = list[Task]()
    for task in tasks:
        alike = (other for other in whole if not other.twin and _are_twins(task, other, design, nominal))
        whole.append(replace(task, twin=next((other.name for other in alike), "")))
    return whole


def _are_twins(task: Task, other: Task, design: Design, nominal: Targets) -> bool:
    """Tell whether two stages have the same teeth in every lightest train."""
    if not (_stands_alone(task, design) and _stands_alone(other, design)):
        return False
    loads = zip((task.torque, task.speed, task.rolling), (other.torque, other.speed, other.rolling), strict=True)
    if (task.bans, task.rating) != (other.bans, other.rating):
        return False
    if not all(math.isclose(*pair, rel_tol=_SAME) for pair in loads):
        return False
    if _described(task.stage) != _described(other.stage) or task.edge is None or other.edge is None:
        return False
    ends = ((task.edge.fast, other.edge.fast), (task.edge.slow, other.edge.slow))
    return all(_same_place(*pair, design=design, nominal=nominal) for pair in ends)


def _stands_alone(task: Task, design: Design) -> bool:
    """Tell whether a stage shares no gear and no centre distance, and has given planets and a ring that they decide."""
    if isinstance(task.stage, Planetary):
        return task.stage.planets_given is not None and not design.teeth.ring_deviation
    coaxial = {pair.coaxial_with for pair in design.pairs.values()}
    if task.stage.coaxial_with is not None or task.name in coaxial:
        return False
    return list(module_owners(design).values()).count(task.group) == 1


def _described(stage: Pair | Planetary) -> dict[str, object]:
    """Return what a stage is, without where it stands."""
    return {"kind": type(stage).__name__, **stage.model_dump(exclude=_PLACES)}


def _same_place(here: tuple[str, ...], there: tuple[str, ...], *, design: Design, nominal: Targets) -> bool:
    """Tell whether two ends turn alike: one shaft, shafts of machines of one speed, or shafts that one stage joins."""
    if here == there:
        return True
    if len(here) != 1 or len(there) != 1:
        return False
    both = {here[0], there[0]}
    driven = both <= {machine.shaft for machine in design.machines.values()}
    alike = driven and math.isclose(nominal.speeds[here[0]], nominal.speeds[there[0]], rel_tol=_SAME)
    return alike or any(both <= set(side) for edge in nominal.edges.values() for side in (edge.fast, edge.slow))
