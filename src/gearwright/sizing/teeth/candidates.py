"""Candidate tooth numbers of a stage, partial choices of them in the search, and which of these are dominated."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any, NamedTuple

import numpy as np

from gearwright.base import SIDES, Bools, DesignError, Floats, Ints, Role
from gearwright.memo import Memo
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.parts.planetary import assembles, nearest_positions, neighbours_clear, tip_gap
from gearwright.sizing.rating import Load, Rating, fewest_virtual_teeth
from gearwright.sizing.rough_mass import MassBasis
from gearwright.spec import Design, Epicyclic, Pair, Planetary
from gearwright.spec.design import SET_ROLES, SUN_LIMITS, ForbiddenBand, StageShifts, module_owners, stage_shifts
from gearwright.train import Edge, Targets, gear_of, gears_of, members_of, teeth_of

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


class LoadStep(NamedTuple):
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
class StageTask:
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
    parts: tuple[LoadStep, ...] = ()
    """Its life, where a standard sizes it on a grid."""
    around: MassBasis | None = None
    """What carries, encloses and cools its gears is estimated from it; None where nothing loads it."""
    films: bool = False
    """Whether a bevel pair is weighed with what its films ask for, too."""
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


def needs_of(later: Sequence[StageTask], design: Design, *, kept: int = 1) -> Needs:
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


def with_twins(tasks: Sequence[StageTask], design: Design, nominal: Targets) -> list[StageTask]:
    """Return the stages of the search, of which each says whose teeth it has for being the same.

    Args:
        tasks: Every stage.
        design: The design.
        nominal: Asked speeds.
    """
    whole = list[StageTask]()
    for task in tasks:
        alike = (other for other in whole if not other.twin and _are_twins(task, other, design, nominal))
        whole.append(replace(task, twin=next((other.name for other in alike), "")))
    return whole


def _are_twins(task: StageTask, other: StageTask, design: Design, nominal: Targets) -> bool:
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


def _stands_alone(task: StageTask, design: Design) -> bool:
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


# ----------------------------------------------------------------------------------------------------------------------
# Which open teeth of a planetary set its profile shifts close: those given, a centre distance, or a rule of balance.
#
# Where no shift is asked for, z_r = z_s + 2 z_p closes every set. Else sun, planet and ring are tried as sizing takes
# them: shifts within their limits, no undercut, no pointed tip, no interference in the ring, planets beside each other.
# ----------------------------------------------------------------------------------------------------------------------


FARTHEST = 4.0
"""Modules by which no shifts bring a given centre distance nearer to that of teeth without shift [-]."""


def ring_variants(task: StageTask, design: Design) -> tuple[StageTask, ...]:
    """Return a stage with every number of teeth by which a chosen ring may differ from z_s + 2 z_p, the least first.

    Args:
        task: The stage.
        design: With the rules of the search.
    """
    most = design.teeth.ring_deviation
    if not most or not isinstance(task.stage, Planetary) or task.stage.known_teeth is not None:
        return (task,)
    return tuple(replace(task, deviation=teeth) for teeth in sorted(range(-most, most + 1), key=abs))


def is_shifted(task: StageTask, design: Design) -> bool:
    """Tell whether the teeth of a planetary set have shifts that its design asks for, beyond those of all its gears.

    Args:
        task: The stage.
        design: With its rules.
    """
    stage = task.stage
    if not isinstance(stage, Planetary):
        return False
    shifts = (stage.sun_shift, stage.planet_shift, stage.ring_shift)
    asked = stage.centre_distance is not None or any(shift is not None for shift in shifts)
    return asked or task.deviation != 0 or design.rules(task.name).balanced_shifts is not None


def closed(task: StageTask, design: Design, small: Ints, large: Ints, ring: Ints, *, planets: int) -> Bools:
    """Tell which teeth of a planetary set with shifts close, so that planets pass each other.

    Args:
        task: The stage.
        design: With its rules.
        small: Of the sun [-].
        large: Of planets [-].
        ring: Of the ring [-].
        planets: Number of planets [-].
    """
    good = _near(task, small + large) & _near(task, ring - large)
    triples, place = np.unique(np.stack([small, large, ring])[:, good], axis=1, return_inverse=True)
    fits = [_stands(task, design, (int(z_s), int(z_p), int(z_r)), planets) for z_s, z_p, z_r in triples.T]
    good[good] = np.array(fits, dtype=bool)[place.ravel()]
    return good


def _near(task: StageTask, total: Ints) -> Bools:
    """Tell which sums of teeth stand near enough to the given centre distance for a look; all, where none is given."""
    stage = task.stage
    if stage.centre_distance is None or stage.module is None:
        return np.ones(total.shape, dtype=bool)
    return np.asarray(np.abs(stage.centre_distance / stage.module - total / 2.0) <= FARTHEST)


def _stands(task: StageTask, design: Design, teeth: tuple[int, int, int], planets: int) -> bool:
    """Tell whether one set closes and its planets pass each other."""
    if teeth not in task.closed:
        task.closed[teeth] = _shifts(task.name, design, teeth)
    shifts = task.closed[teeth]
    if shifts is None:
        return False
    sun, planet, ring = teeth
    centre = 0.5 * (sun + planet) if shifts.centre is None else shifts.centre
    tip = 0.5 * planet + 1.0 + sum(shifts.of(Role.PLANET))
    return tip_gap(centre, tip, nearest_positions(sun, ring, planets)) > 0.0


def _shifts(name: str, design: Design, teeth: tuple[int, int, int]) -> StageShifts | None:
    """Return the shifts that close a set; None where none do."""
    try:
        return stage_shifts(design, name, dict(zip(SET_ROLES, teeth, strict=True)))
    except DesignError:
        return None


# ----------------------------------------------------------------------------------------------------------------------
# Tooth numbers that a stage may have: near its ratio, free of undercut, able to be put together.
# ----------------------------------------------------------------------------------------------------------------------


class Reach(NamedTuple):
    """How far the search looks."""

    around: int
    """Tooth numbers on either side of the exact ratio [-]."""
    largest_sun: int
    """Teeth of the largest sun where the design does not limit them [-]."""


REACHES = (Reach(1, SUN_LIMITS[0]), Reach(4, SUN_LIMITS[0]), *(Reach(1, largest) for largest in SUN_LIMITS[1:]))
"""The integers next to the exact ratio, then more of them, then larger suns, where none of those before will do."""
LARGEST_FREE_RATIO = 10
"""Largest tooth ratio z_2/z_1 that is looked at where a stage's ratio is the search's own choice."""
MOST_TEETH = 1_000_000
"""Where an absurd ratio stops [-]."""
ROUNDING = 1e-12
"""Of a wanted tooth number [-]."""
NEAREST_CENTRES = (-0.4, 0.9)
"""By how many modules a given centre distance may differ from that of teeth without shift, to be chosen [-]."""
LEAST_LEWIS = 12
"""Fewest teeth for which the Lewis form factor is tabulated."""
LEAST_BEVEL = 8
"""Fewest teeth of bevel pinions that are looked at; their cone decides what is undercut."""


def is_given(stage: Pair | Planetary | Epicyclic) -> bool:
    """Tell whether a stage's teeth are all given; how many planets there are is another question.

    Args:
        stage: As in the design.
    """
    if isinstance(stage, Epicyclic):
        return True
    if isinstance(stage, Pair):
        return bool(stage.pinion_teeth and stage.wheel_teeth)
    return sum(teeth is not None for teeth in (stage.sun_teeth, stage.planet_teeth, stage.ring_teeth)) >= 2


def given_teeth(design: Design) -> dict[str, int]:
    """Return the tooth number of every gear that a design gives; a gear that stages share is given by any of them.

    Args:
        design: As read.
    """
    teeth: dict[str, int] = {}
    for name, stage in design.stages.items():
        if isinstance(stage, Epicyclic):
            teeth |= teeth_of(design, name)
            continue
        if isinstance(stage, Planetary):
            numbers = list(stage.known_teeth or (None, None, None))
        else:
            numbers = [stage.pinion_teeth, stage.wheel_teeth]
        teeth |= {gear: own for gear, own in zip(gears_of(name, stage), numbers, strict=True) if own}
    return teeth


def gives_all(design: Design) -> bool:
    """Tell whether a design gives the teeth of every gear and the planets of every set, so that nothing is chosen.

    Args:
        design: As read.
    """
    teeth, stages = given_teeth(design), design.stages.items()
    return all(
        len(planet_counts(name, design)) == 1 and teeth.keys() >= set(gears_of(name, stage)) for name, stage in stages
    )


def candidates(
    front: Front, task: StageTask, design: Design, target: Floats, *, reach: Reach
) -> tuple[Ints, Ints, Ints]:
    """Return the choice in the front that each candidate extends, and the teeth of pinion and wheel, or sun and planet.

    Args:
        front: Partial choices.
        task: The stage.
        design: With the rules of the search.
        target: Tooth ratio asked of every choice [-].
        reach: How far it looks.
    """
    stage, rules = task.stage, design.teeth
    if isinstance(stage, Planetary):
        first, second, _ = stage.known_teeth or (stage.sun_teeth, stage.planet_teeth, None)
        small = np.array([first]) if first else np.arange(rules.sun_minimum, rules.largest_sun(reach.largest_sun) + 1)
        wanted = ((target[:, None] - 1.0) * small - task.deviation) / 2.0
        if stage.ring_teeth and second is None:
            wanted = np.broadcast_to((stage.ring_teeth - small - task.deviation) / 2.0, wanted.shape)
        return _neighbours(wanted, small, second, reach.around)
    pinion, wheel = gears_of(task.name, stage)
    if wheel in front.teeth:
        large = front.teeth[wheel]
        return _around(large / target, large, stage.pinion_teeth, reach.around)
    if pinion in front.teeth:
        parent, large, small_ = _around(
            front.teeth[pinion] * target, front.teeth[pinion], stage.wheel_teeth, reach.around
        )
        return parent, small_, large
    fewest = rules.pinion_minimum or fewest_teeth(task.rating)
    small = np.array([stage.pinion_teeth]) if stage.pinion_teeth else np.arange(fewest, rules.pinion_maximum + 1)
    return _neighbours(target[:, None] * small, small, stage.wheel_teeth, reach.around)


def shares_gear(front: Front, task: StageTask) -> bool:
    """Tell whether a gear of a stage is chosen with another stage, so that its candidates are those beside it.

    Args:
        front: Choices of the stages before.
        task: The stage.
    """
    return any(gear in front.teeth for gear in gears_of(task.name, task.stage))


def _virtual_pinion(small: Ints, large: Ints) -> Floats:
    """Return the virtual tooth number of the pinion of a bevel pair on square axes, z_1/cos δ_1 [-]."""
    return np.asarray(small * np.hypot(small, large) / large)


def all_candidates(task: StageTask, design: Design) -> tuple[Ints, Ints, Ints]:
    """Return every tooth number that a stage of free ratio may have, from a front of one choice.

    Args:
        task: The stage.
        design: With the rules of the search.
    """
    rules = design.teeth
    if isinstance(task.stage, Planetary):
        first = np.arange(rules.sun_minimum, rules.largest_sun() + 1)
        second = np.arange(rules.planet_minimum, LARGEST_FREE_RATIO * rules.largest_sun() // 2 + 1)
    else:
        fewest = rules.pinion_minimum or fewest_teeth(task.rating)
        first = (
            np.array([task.stage.pinion_teeth])
            if task.stage.pinion_teeth
            else np.arange(fewest, rules.pinion_maximum + 1)
        )
        second = np.arange(fewest, LARGEST_FREE_RATIO * int(first.max()) + 1)
    small, large = (grid.ravel() for grid in np.meshgrid(first, second, indexing="ij"))
    return np.zeros(len(small), dtype=np.int64), small, large


def ring_teeth(task: StageTask, sun: Ints, planet: Ints) -> Ints:
    """Return the teeth of the ring: given with the others, or those that close, without shift or nearly so [-].

    Args:
        task: A planetary set.
        sun: z_s [-].
        planet: z_p [-].
    """
    known = task.stage.known_teeth if isinstance(task.stage, Planetary) else None
    return sun + 2 * planet + task.deviation if known is None else np.full_like(sun, known[2])


def fewest_teeth(rating: Rating, gear: int = 0) -> int:
    """Return the smallest tooth number of a gear without undercut [-].

    Args:
        rating: Resolved rules: pressure angle, helix angle and the shifts that are sure before teeth are chosen.
        gear: 0 of the pinion, 1 of the wheel.

    Source: z_min = 2 cos β (1 − x) / sin² α_t; Pulvirenti 2023, eq. (2.6), approximates it: 2 cos³ β (1 − x)/sin² α.
    """
    if rating.kind == "bevel":
        return LEAST_BEVEL
    angle, shift = rating.helix_angle, rating.shifts.gears[gear].profile_shift
    transverse = transverse_pressure_angle(rating.rules.pressure_angle, angle)
    return max(math.ceil(2.0 * math.cos(angle) * (1.0 - shift) / math.sin(transverse) ** 2), LEAST_LEWIS)


def whole_below(wanted: Floats) -> Ints:
    """Return the tooth number below, of a whole number the one before it, whatever its rounding; at least one tooth.

    What an absurd ratio asks is refused later by its rules.

    Args:
        wanted: Teeth that the exact ratio asks for [-].
    """
    return np.minimum(np.maximum(np.ceil(wanted * (1.0 - ROUNDING)) - 1.0, 1.0), MOST_TEETH).astype(np.int64)


def _neighbours(wanted: Floats, small: Ints, large_teeth: int | None, reach: int) -> tuple[Ints, Ints, Ints]:
    """Return every choice of the front with every small gear and the integers around the wanted large one."""
    low = whole_below(wanted)[:, :, None]
    large = (
        np.maximum(low + np.arange(1 - reach, 1 + reach), 1)
        if large_teeth is None
        else np.full((*low.shape[:2], 1), large_teeth)
    )
    parent = np.arange(len(wanted)).repeat(large[0].size)
    return parent, np.broadcast_to(small[:, None], large.shape).ravel(), large.ravel()


def _around(wanted: Floats, large: Ints, small_teeth: int | None, reach: int) -> tuple[Ints, Ints, Ints]:
    """Return the integers around the wanted gear that meshes with one that is chosen already."""
    low = whole_below(wanted)[:, None]
    small = (
        np.maximum(low + np.arange(1 - reach, 1 + reach), 1)
        if small_teeth is None
        else np.full((len(low), 1), small_teeth)
    )
    parent, teeth, shared = np.broadcast_arrays(np.arange(len(low))[:, None], small, large[:, None])
    return parent.ravel(), teeth.ravel(), shared.ravel()


def planet_counts(name: str, design: Design) -> Sequence[int]:
    """Return how many planets a stage may have: those it gives, or from two up; one, that does not count, of a pair.

    Of open numbers only those that a table of load factors has, if the rules of the stage have one.

    Args:
        name: Of the stage.
        design: With the rules of the search.
    """
    stage = design.stages[name]
    if not isinstance(stage, Planetary):
        return range(1, 2)
    given, table = stage.planets_given, design.rules(name).planet_load_factors
    if given is not None:
        return range(given, given + 1)
    counts = range(2, design.teeth.planets_maximum + 1)
    return [count for count in counts if str(count) in table] if table else counts


def admissible(task: StageTask, design: Design, small: Ints, large: Ints, *, planets: int) -> Bools:
    """Tell which tooth numbers can be made and put together.

    Args:
        task: The stage.
        design: With the rules of the search.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
        planets: Of a planetary set [-].
    """
    rules, stage = design.teeth, task.stage
    if isinstance(stage, Planetary):
        if is_given(stage) and stage.planets_given is not None:  # told as the file is read
            return np.ones(small.shape, dtype=bool)
        ring, good = ring_teeth(task, small, large), assembled(task, design, small, large, planets=planets)
        if not is_shifted(task, design):
            return good & neighbours_clear(small, large, planets)
        good[good] = closed(task, design, small[good], large[good], ring[good], planets=planets)
        return good
    least = [rules.pinion_minimum or fewest_teeth(task.rating, gear) for gear in (0, 0 if stage.internal else 1)]
    good = (small >= least[0]) & (large >= least[1]) & _reached(stage, small, large, helix=task.rating.helix_angle)
    if task.rating.kind == "bevel":
        good &= _virtual_pinion(small, large) >= fewest_virtual_teeth(task.rating)
    if rules.hunting:
        good &= np.gcd(small, large) == 1
    return good


def assembled(task: StageTask, design: Design, small: Ints, large: Ints, *, planets: int) -> Bools:
    """Tell which teeth of a planetary set let equally spaced planets be put in, whatever its shifts.

    Args:
        task: A planetary set.
        design: With the rules of the search.
        small: Teeth of the sun.
        large: Teeth of planets.
        planets: Number of planets [-].
    """
    rules, ring = design.teeth, ring_teeth(task, small, large)
    good = assembles(small, ring, planets) & (large >= rules.planet_minimum)
    if isinstance(task.stage, Planetary) and task.stage.ring_teeth:
        good &= ring == task.stage.ring_teeth
    if rules.hunting:
        good &= (np.gcd(small, large) == 1) & (np.gcd(large, ring) == 1)
    return good


def _reached(stage: Pair, small: Ints, large: Ints, *, helix: float) -> Bools:
    """Tell which teeth usual shifts bring to a given centre distance; all, where none is given.

    Source: DIN 3992:1964, whose sums of shifts are −0.5 to 1 or little more; the distance gains a little less.
    """
    if stage.centre_distance is None or stage.module is None:
        return np.ones(small.shape, dtype=bool)
    total = large - small if stage.internal else large + small
    gained = stage.centre_distance / stage.module - total / (2.0 * math.cos(helix))
    return np.asarray((gained >= NEAREST_CENTRES[0]) & (gained <= NEAREST_CENTRES[1]))


# ----------------------------------------------------------------------------------------------------------------------
# Which teeth of planetary sets can be put together, tabulated once: the search looks them up for every ratio asked.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST = 4096
"""Teeth of planets that are tabulated; sets of larger ones are looked at one by one [-]."""
_WINDOWS = Memo[tuple[Any, ...], Any](64)
"""Tables by what they depend on."""


def admitted(task: StageTask, design: Design, small: Ints, large: Ints) -> Bools:
    """Tell which teeth some number of planets admits.

    Args:
        task: The stage.
        design: With the rules of the search.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    fits = [admissible(task, design, small, large, planets=n) for n in planet_counts(task.name, design)]
    return fits[0] if len(fits) == 1 else np.any(fits, axis=0)


def admitted_candidates(
    front: Front, task: StageTask, design: Design, target: Floats, *, reach: Reach
) -> tuple[Ints, Ints, Ints]:
    """Return the candidates for every ratio asked that some number of planets admits.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        target: Tooth ratio asked of every choice [-].
        reach: How far it looks.

    Returns:
        Choice that each extends, teeth of pinion and wheel, or of sun and planet.
    """
    stage, rules = task.stage, design.teeth
    given = not isinstance(stage, Planetary) or stage.sun_teeth or stage.planet_teeth or stage.ring_teeth
    if not (given or is_shifted(task, design)):
        suns = np.arange(rules.sun_minimum, rules.largest_sun(reach.largest_sun) + 1)
        low = whole_below((target[:, None] - 1.0) * suns / 2.0)
        size = 1 << int(low.max(initial=255)).bit_length()
        if size <= LARGEST:
            windows = _windows(task, design, suns, size=size, around=reach.around)
            return _looked_up(windows, low, suns, reach.around)
    parent, small, large = candidates(front, task, design, target, reach=reach)
    fits = admitted(task, design, small, large)
    return parent[fits], small[fits], large[fits]


def _windows(task: StageTask, design: Design, suns: Ints, *, size: int, around: int) -> Any:
    """Return of every sun and planet, bit for bit, which of the planets around that one are admitted.

    Args:
        task: A planetary set of which no teeth are given, and none are shifted.
        design: With the rules of the search.
        suns: Teeth of suns that are looked at [-].
        size: Teeth beyond those of the largest planet [-].
        around: Tooth numbers on either side [-].
    """
    rules, counts = design.teeth, tuple(planet_counts(task.name, design))
    key = (counts, rules.planet_minimum, rules.hunting, len(suns), *suns[:1].tolist(), size, around)

    def tabulated() -> Any:
        planets = np.arange(size + around)
        grid = (np.broadcast_to(axis, (len(suns), len(planets))) for axis in (suns[:, None], planets))
        fits = admitted(task, design, *grid).astype(np.uint8)
        windows = np.zeros((len(suns), size), dtype=np.uint8)
        for bit in range(2 * around):
            windows |= fits[:, np.maximum(planets[:size] + 1 - around + bit, 1)] << np.uint8(bit)
        return windows

    return _WINDOWS.of(key, tabulated)


def _looked_up(windows: Any, low: Ints, suns: Ints, around: int) -> tuple[Ints, Ints, Ints]:
    """Return the choice that each candidate extends, and the teeth of sun and planet.

    Args:
        windows: From `_windows`.
        low: (choices, suns) teeth of the planet below the wanted one [-].
        suns: Their teeth [-].
        around: Tooth numbers on either side [-].
    """
    count, size = windows.shape
    codes = windows.ravel()[low + size * np.arange(count)].ravel()
    some = np.flatnonzero(codes)
    owner, bit = np.nonzero(np.unpackbits(codes[some, None], axis=1, count=2 * around, bitorder="little"))
    place = some[owner]
    parent = place // count
    return parent, suns[place - parent * count], np.maximum(low.ravel()[place] + 1 - around + bit, 1)
