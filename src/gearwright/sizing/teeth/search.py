"""Search for the tooth numbers of the lightest gears, with lower bounds of mass and trial sizings."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import ROUNDING, SIDES, Bools, DesignError, Floats, Problem, Role, largest
from gearwright.sizing.rating import MESHES, load_sharing, rating_of, worn_torque
from gearwright.sizing.result import TeethSearch
from gearwright.sizing.rough_mass import around_stage
from gearwright.sizing.teeth.candidates import (
    EQUAL,
    Front,
    LoadStep,
    Reach,
    StageTask,
    admissible,
    assembled,
    candidates,
    given_teeth,
    gives_all,
    is_given,
    is_shifted,
    needs_of,
    planet_counts,
    ranks_of,
    ring_variants,
    with_twins,
)
from gearwright.sizing.teeth.criteria import aligned, banned, bevel_rows, clear_places, weigh
from gearwright.sizing.teeth.stage import extend, refusal, tooth_ratio
from gearwright.spec import GROUND, Design, Pair, Planetary, case_named, levels_of, shares_of
from gearwright.spec.design import RATINGS, SUN_LIMITS, module_owners
from gearwright.train import (
    Mesh,
    PowerFlow,
    Targets,
    Train,
    Turning,
    gear_of,
    gears_of,
    handed_on,
    members_of,
    power_flows,
    targets,
    teeth_of,
    ties_of,
)

# ----------------------------------------------------------------------------------------------------------------------
# What the stages that are still to come weigh at the least, so that choices which cannot win are left out.
#
# A stage and all that it drives weigh what they do by the speed of the shaft that leads to it. That is tabulated from
# the last stages backwards over steps of that speed, each with the least load and the most choices that any speed in
# it has.
# ----------------------------------------------------------------------------------------------------------------------


STEP = 1e-4
"""Of a speed in the tables, in its logarithm [-]."""
_STEPS = 280
"""Steps on either side of a nominal speed; beyond them nothing is known [-]."""
_WIDE = 1.0 + 1e-9
"""Factor that keeps the ends of a range inside it, whatever the rounding [-]."""


@dataclass(frozen=True)
class Branch:
    """A stage and all that is reached through it."""

    source: str
    """Shaft that leads to it."""
    nominal: float
    """Speed asked of that shaft [rad/s]."""
    least: Floats
    """Least mass of its gears and of all beyond it, step of the source's speed after step [kg]."""

    def at(self, speed: Floats) -> Floats:
        """Return the least mass at speeds of its source [kg].

        Args:
            speed: [rad/s].
        """
        step = np.floor(np.log(np.maximum(speed, 1e-300) / self.nominal) / STEP + 1e-6).astype(np.int64) + _STEPS
        inside = (step > 0) & (step < 2 * _STEPS - 1)
        return np.where(inside, np.minimum(self.least[step * inside], self.least[step * inside - 1]), 0.0)


def branches_of(front: Front, later: Sequence[StageTask], design: Design, nominal: Targets) -> list[Branch]:
    """Return what is reached from the shafts that a front knows, as far as it can be bounded.

    Args:
        front: Choices of the stages before.
        later: The stages to come, in order.
        design: With the rules of the search.
        nominal: Asked speeds.
    """
    by, ordered, waiting = dict.fromkeys(front.speeds, ""), list[tuple[StageTask, str]](), list(later)
    while task := next((task for task in waiting if _source(task, by, design)), None):
        waiting.remove(task)
        ordered.append((task, _source(task, by, design)))
        by = {**dict.fromkeys(_ends(task), task.name), **by}
    branches = list[Branch]()
    for task, source in reversed(ordered):
        beyond = [branch for branch in branches if by[branch.source] == task.name]
        branches.append(_branch(task, source, design, nominal, beyond))
    return [branch for branch in branches if not by[branch.source]]


def rest_of(front: Front, branches: Sequence[Branch]) -> Floats:
    """Return a mass that the gears of the stages still to come cannot be below, for every choice of a front [kg].

    Args:
        front: Choices of the stages before.
        branches: From `branches_of`.
    """
    rest = np.zeros(len(front))
    for branch in branches:
        rest += branch.at(front.speeds[branch.source])
    return rest


def _ends(task: StageTask) -> tuple[str, ...]:
    return () if task.edge is None else (*task.edge.fast, *task.edge.slow)


def _source(task: StageTask, reached: Collection[str], design: Design) -> str:
    """Return the shaft that leads to a stage that can be bounded; nothing where there is none, or more than one."""
    shares = isinstance(task.stage, Pair) and any(task.stage.shared(side) for side in SIDES)
    if task.edge is None or shares or design.teeth.split != "equal":
        return ""
    sides = [next((shaft for shaft in side if shaft in reached), "") for side in (task.edge.fast, task.edge.slow)]
    return "" if all(sides) else sides[0] or sides[1]


def _branch(task: StageTask, source: str, design: Design, nominal: Targets, beyond: Sequence[Branch]) -> Branch:
    """Return the table of a stage whose stages beyond it have theirs."""
    edge, known = task.edge, nominal.speeds[source]
    assert edge is not None
    drives = source in edge.fast
    other, fast = nominal.speeds[(edge.slow if drives else edge.fast)[0]], nominal.speeds[edge.fast[0]]
    speeds = known * np.exp(STEP * (np.arange(2 * _STEPS + 1) - _STEPS))
    asked = [edge.tooth_ratio(speed / other if drives else other / speed) for speed in speeds.tolist()]
    if not all(0.0 < ratio < math.inf for ratio in asked):
        return Branch(source, known, np.zeros(2 * _STEPS))
    teeth, mass = _candidates(task, design, _near(task, design, (min(asked), max(asked))), fast)
    ratio = np.array([edge.ratio(value) for value in teeth.tolist()])
    least = np.zeros(2 * _STEPS)
    for step, ends in enumerate(pairwise(asked)):
        span = _near(task, design, (min(ends), max(ends)))
        first, last = np.searchsorted(teeth, span[0]), np.searchsorted(teeth, span[1], side="right")
        own, low, high = ratio[first:last], speeds[step], speeds[step + 1]
        if len(own):
            weight = mass[first:last] * (fast / (high if drives else high * own))
            for branch in beyond:
                passed = (low / own, high / own) if drives else (low * own, high * own)
                weight = weight + np.minimum(branch.at(passed[0]), branch.at(passed[1]))
            least[step] = weight.min()
    return Branch(source, known, np.where(np.isfinite(least), least, 0.0))


def _near(task: StageTask, design: Design, asked: tuple[float, float]) -> tuple[float, float]:
    """Return the least and the largest tooth ratio that is near enough to some of a range; all of given teeth."""
    if is_given(task.stage):
        return 0.0, math.inf
    part, tolerance = (1.0 if isinstance(task.stage, Planetary) else 0.0), design.teeth.stage_tolerance * _WIDE
    return (part + asked[0]) * (1.0 - tolerance) - part, (part + asked[1]) * (1.0 + tolerance) - part


def _candidates(task: StageTask, design: Design, allowed: tuple[float, float], speed: float) -> tuple[Floats, Floats]:
    """Return every tooth ratio in a range, the least first, and the mass of its gears at a speed of the fast shaft."""
    parts = [_of_variant(variant, design, allowed, speed) for variant in ring_variants(task, design)]
    ratio, masses = (np.concatenate(columns) for columns in zip(*parts, strict=True))
    order = np.argsort(ratio, kind="stable")
    return ratio[order], masses[order]


def _of_variant(task: StageTask, design: Design, allowed: tuple[float, float], speed: float) -> tuple[Floats, Floats]:
    """Return the tooth ratios and masses of a stage; of shifted teeth those too that shifts may not close."""
    assert task.edge is not None
    low, high = allowed if allowed[1] < math.inf else (1.0, 1.0)
    largest = max(design.teeth.largest_sun(SUN_LIMITS[-1]), design.teeth.pinion_maximum)
    targets = np.linspace(low, high, math.ceil((high - low) * largest) + 2)  # next to every whole number between
    front = Front({}, {task.edge.fast[0]: np.full(len(targets), speed)}, {}, {})
    _, small, large = candidates(front, task, design, targets, reach=Reach(1, SUN_LIMITS[-1]))
    small, large = np.unique(np.stack([small, large]), axis=1)
    masses = np.full(len(small), np.inf)
    possible = assembled if is_shifted(task, design) else admissible
    for planets in planet_counts(task.name, design):
        fits = possible(task, design, small, large, planets=planets)
        alone = Front({}, {task.edge.fast[0]: np.full(int(fits.sum()), speed)}, {}, {})
        if fits.any():
            weighed = weigh(alone, task, small[fits], large[fits], planets=planets).mass
            masses[fits] = np.minimum(masses[fits], weighed)
    return tooth_ratio(task, small, large), masses


# ----------------------------------------------------------------------------------------------------------------------
# Choose the tooth numbers: every admissible combination counts, and the lightest gears win.
#
# Stages are taken from the kept machines outwards, so that a stage's target is what the teeth chosen so far leave of
# the asked speeds. A front holds all partial choices at once as arrays; each stage multiplies it by its candidates,
# and of those that leave the same to the stages after them the lightest is kept (`states`). Where they are still
# many, those go that cannot become lighter than a train that is found already (`bounds`).
# ----------------------------------------------------------------------------------------------------------------------


MANY = 5_000
"""Choices of a front beyond which those that cannot win are looked for [-]."""
MOST = 50_000
"""Choices of a front that are held; the lightest of more, and then nothing is proven [-]."""
HELD = 1_000
"""The same where more than the lightest are asked for [-]."""
BEAM = 300
"""Choices with which a first good train is looked for [-]."""


class Chosen(NamedTuple):
    """What the search decides."""

    teeth: dict[str, int]
    """Gear -> tooth number [-]."""
    planets: dict[str, int]
    """Planetary set whose number of planets the design leaves out -> that number [-]."""
    search: TeethSearch | None = None
    """How it was found; None where the design gives all teeth."""
    gear_mass: float = 0.0
    """What its gears weigh by the estimate of the search [kg]; 0 where the design gives all teeth."""
    masses: Mapping[str, float] = {}
    """The same of every group of stages with one module, by the one that owns it [kg]."""


def choose_teeth(
    design: Design, train: Train, areas: Mapping[str, float] | None = None, films: Collection[str] = ()
) -> list[Chosen]:
    """Return the tooth number of every gear, and how many planets each set has, of the lightest gears first.

    As many of the lightest as the rules of the search size in full.

    Args:
        design: Given teeth are kept, those left out are chosen.
        train: Its graph.
        areas: Set -> least face times diameter of all its planets with which it is weighed [m²].
        films: Bevel pairs that are weighed with what their films ask for, too.

    Raises:
        DesignError: If speeds are not determined, or a stage has no candidate; with what would do.
    """
    if gives_all(design):
        return [Chosen(given_teeth(design), {})]  # which say every speed, with what holds in each case
    nominal = targets(design)
    for name, stage in design.planetaries.items():
        ratio = nominal.tooth_ratios[name]
        if not is_given(stage) and ratio <= 1.0:  # a ring no larger than its sun: no torques could be found
            raise refusal(name, stage, design, ratio, fewest=0, nominal=nominal)
    flow, kept = nominal_flow(design, train, nominal)
    given, design = design, nominal.design
    tasks = [task_of(name, design, train, nominal, flow) for name in design.simple_stages]
    tasks = [replace(task, rating=replace(task.rating, least_area=(areas or {}).get(task.name, 0.0))) for task in tasks]
    tasks = [_met_before(replace(task, films=task.name in films)) for task in tasks]
    start = Front(
        {}, {shaft: np.array([nominal.speeds[shaft]]) for shaft in kept}, {}, {},
        tally={"combinations": np.ones(1), "second": np.full(1, np.inf)},
    )  # fmt: skip
    bans = banned(tasks, given, train, nominal, flow)
    found = _searched(_Search(design, nominal, bans.whole), start, with_twins(bans.tasks, design, nominal))
    front = aligned(found.front, design)
    mass = front.mass
    first = int(np.argmax(mass <= mass.min() * (1.0 + EQUAL)))
    others = [place for place in np.argsort(ranks_of(mass), kind="stable").tolist() if place != first]
    if bans.whole:
        chosen = (_chosen(design, found.front, place, None) for place in (first, *others))
        trains = zip((first, *others), ((choice.teeth, choice.planets) for choice in chosen), strict=True)
        first, *others = clear_places(given, train, bans.whole, trains, wanted=design.teeth.sized + 1)
    search = TeethSearch(
        combinations=float(found.front.tally["combinations"].sum()) + found.left_out,
        weighed=found.weighed,
        gear_mass=float(mass[first]),
        next_mass=float(min(mass[others].min(initial=np.inf), found.front.tally["second"].min())),
        proven=found.proven,
    )
    return [
        _chosen(design, found.front, place, search)._replace(
            gear_mass=float(mass[place]),
            masses={group: float(cube[place] * front.volumes[group][place]) for group, cube in front.cubes.items()},
        )
        for place in (first, *others)[: design.teeth.sized]
    ]


def _met_before(task: StageTask) -> StageTask:
    """Return a stage with the sizes that were found of it before, where it did the same: of other trains of a closure.

    Args:
        task: The stage.
    """
    met = MESHES.now().of(("teeth of", task.name, task.torque, task.speed), list)
    known = next((known for _, (own, known) in met if own == task), None)
    if known is None:
        met.append((task.rating, (task, task.known)))
        return task
    return replace(task, known=known)


def _chosen(design: Design, front: Front, place: int, search: TeethSearch | None) -> Chosen:
    """Return one of the whole combinations of a front."""
    left_out = {name for name, stage in design.planetaries.items() if stage.planets_given is None}
    return Chosen(
        {name: int(values[place]) for name, values in front.teeth.items()} | compound_teeth(design),
        {name: int(values[place]) for name, values in front.planets.items() if name in left_out},
        search,
    )


class _Search(NamedTuple):
    """What a search reads all the way."""

    design: Design
    """As the case holds it that asks for the speeds."""
    nominal: Targets
    whole: frozenset[str] = frozenset()
    """Forbidden bands that only whole trains are held against: none is left out before."""


@dataclass(frozen=True)
class _Found:
    """Whole combinations of teeth, and what it took to find them."""

    front: Front
    weighed: int = 0
    """Candidates of stages that were weighed [-]."""
    left_out: float = 0.0
    """Partial combinations that cannot win, or were too many [-]."""
    proven: bool = True
    """Nothing was left out that might have won."""


def _searched(search: _Search, front: Front, tasks: Sequence[StageTask], *, beam: int | None = None) -> _Found:
    """Return all whole combinations that may be the lightest, or those that a narrow search finds.

    Args:
        search: What it reads.
        front: Choices of the stages before.
        tasks: Stages to come.
        beam: Keep so many lightest choices of every front; left out: all that may win.
    """
    design, later, limit = search.design, list(tasks), math.inf
    found = _Found(carried_over(design, front))
    while later:
        task = next((task for task in later if is_ready(task, found.front)), None)
        if task is None:
            raise DesignError(
                Problem(waiting.name, "no speed that is known leads to this stage; give its teeth") for waiting in later
            )
        later.remove(task)
        rule = _MayWin(search, tuple(later), limit)
        needs = needs_of(later, design, kept=1 if search.whole else design.teeth.sized)
        needs = needs._replace(every=bool(search.whole))
        grown = extend(found.front, task, design, search.nominal, needs=needs, may_win=rule)
        left_out = found.left_out + grown.left_out
        found = _Found(carried_over(design, grown.front), found.weighed + grown.weighed, left_out, found.proven)
        most = MOST if design.teeth.sized == 1 else max(HELD, design.teeth.sized)
        alone = beam is None and design.teeth.sized == 1
        if later and alone and len(found.front) > MANY and not search.whole:
            limit = min(limit, _known(search, found.front, later))
            found = _only(found, _MayWin(search, tuple(later), limit)(found.front))
        found = _narrowed(search, found, later, beam or most)
    return found


def _known(search: _Search, front: Front, later: Sequence[StageTask]) -> float:
    """Return the mass of gears that as many trains as are sized in full do not exceed; infinite where they are fewer.

    A narrow search finds them from a front.
    """
    wanted = search.design.teeth.sized
    try:
        narrow = _searched(search, front, later, beam=max(BEAM, wanted))
    except DesignError:
        return math.inf
    mass = aligned(narrow.front, search.design).mass
    return float(np.partition(mass, wanted - 1)[wanted - 1]) if len(mass) >= wanted else math.inf


@dataclass(frozen=True)
class _MayWin:
    """Tells the choices that may become as light as the trains that are known."""

    search: _Search
    later: tuple[StageTask, ...]
    """Stages to come."""
    limit: float
    """Mass of the gears of the heaviest of those trains [kg]."""
    tables: dict[tuple[str, ...], list[Branch]] = field(default_factory=dict)
    """Shafts that a front knows -> the least masses beyond them."""

    def __call__(self, front: Front) -> Bools:
        """Return which choices of a front may.

        Args:
            front: Choices with one stage more.
        """
        if self.limit == math.inf:
            return np.ones(len(front), dtype=bool)
        shafts = tuple(front.speeds)
        if shafts not in self.tables:
            self.tables[shafts] = branches_of(front, self.later, self.search.design, self.search.nominal)
        return np.asarray(front.mass + rest_of(front, self.tables[shafts]) <= self.limit * (1.0 + EQUAL))


def _narrowed(search: _Search, found: _Found, later: Sequence[StageTask], most: int) -> _Found:
    """Keep the choices of a front that has too many from which the lightest trains may come."""
    front = found.front
    if len(front) <= most or not later:
        return found
    mass = front.mass + rest_of(front, branches_of(front, later, search.design, search.nominal))
    return replace(_only(found, mass <= np.partition(mass, most - 1)[most - 1]), proven=False)


def _only(found: _Found, kept: Bools) -> _Found:
    """Leave out all choices but those that are marked."""
    gone = float(found.front.tally["combinations"][~kept].sum())
    return replace(found, front=found.front.take(kept), left_out=found.left_out + gone)


def compound_teeth(design: Design) -> dict[str, int]:
    """Return the tooth number of every gear of compound sets.

    Args:
        design: As read.
    """
    return {gear: teeth for name in design.epicyclics for gear, teeth in teeth_of(design, name).items()}


def nominal_flow(design: Design, train: Train, nominal: Targets) -> tuple[dict[str, PowerFlow], set[str]]:
    """Return the power flow of every case at the asked ratios, and the shafts whose speed is kept.

    Args:
        design: With its cases.
        train: Its graph.
        nominal: Asked speeds.
    """
    real: dict[str, float] = dict(compound_teeth(design))
    for name, stage in design.simple_stages.items():
        ratio = nominal.tooth_ratios[name]
        if isinstance(stage, Planetary):
            sun, planet, ring = gears_of(name, stage)
            real |= {sun: 1.0, planet: (ratio - 1.0) / 2.0, ring: ratio}
        else:
            pinion, wheel = gears_of(name, stage)
            size = real.get(pinion) or (real[wheel] / ratio if wheel in real else 1.0)
            real |= {pinion: size, wheel: size * ratio}
    turning = Turning(design, train, real)
    free = {yielded.machine for yielded in turning.yielded}
    kept = {machine.shaft for name, machine in nominal.design.machines.items() if name not in free}
    return power_flows(design, turning), kept


def task_of(name: str, design: Design, train: Train, nominal: Targets, flows: Mapping[str, PowerFlow]) -> StageTask:
    """Return a stage of the search with its largest load.

    Args:
        name: Of the stage.
        design: With its rules.
        train: Its graph.
        nominal: Asked speeds.
        flows: Every load case at the asked ratios.
    """
    stage, edge = design.simple_stages[name], nominal.edges.get(name)
    rating = rating_of(design, name)
    # The reference gear sits on the edge's fast shaft: the ring where the sun stands still, else sun or pinion.
    meshes = [mesh for mesh in train.meshes if mesh.stage == name]
    ring = edge is not None and edge.grounded is Role.SUN
    own_rows = meshes[1:] if ring else (meshes[:1] if isinstance(stage, Planetary) else meshes)
    fatigue, loads = RATINGS[rating.method].fatigue, list[tuple[float, float]]()
    lasting = dict[str, tuple[float, float]]()

    def load_of(mesh: Mesh, flow: PowerFlow) -> tuple[float, float]:
        alike = 1 if isinstance(stage, Planetary) else mesh.count
        load = abs(flow.meshes[mesh.name].torques[1 if ring else 0]) / alike * rating.load_factor
        return load, abs(flow.speeds[meshes[0].nodes[0]] - flow.speeds[meshes[0].nodes[2]])

    for case, flow in flows.items():
        if fatigue and case_named(design, case).static:
            continue
        for mesh in own_rows:
            loads.append(load_of(mesh, flow))
            lasting[case] = (
                loads[-1] if case not in lasting else largest([lasting[case], loads[-1]], lambda row: row[0])
            )
    torque, rolling = heaviest(loads)
    speed = 1.0 if edge is None else nominal.speeds[edge.fast[0]]
    rows = bevel_rows(design, meshes, flows, rating) if rating.kind == "bevel" else ()
    made = design.compares_sizes
    factors = dict[int, float]()
    if isinstance(stage, Planetary) and design.rules(name).mesh_load_factor is None:
        factors = {count: load_sharing(design, name, count).factor for count in planet_counts(name, design)}
    task = StageTask(name, stage, edge, module_owners(design)[name], rating, torque, speed, rolling, rows, made)
    if not lasting or rating.proportions is None:
        return replace(task, factors=factors)
    steady = worn_torque(design, lasting) / torque if torque else 1.0
    fastest = max(speed for _, speed in lasting.values()) / rolling if rolling else 1.0
    every = {
        case: max((load_of(mesh, flow) for mesh in own_rows), key=lambda row: row[0]) for case, flow in flows.items()
    }
    parts = tuple(parts_of(design, every, (torque, rolling))) if torque and rolling else ()
    around = around_stage(name, design, train, flows, rating.helix_angle) if torque else None
    return replace(task, factors=factors, steady=steady, fastest=fastest, parts=parts, around=around)


def parts_of(
    design: Design, loads: Mapping[str, tuple[float, float]], largest_load: tuple[float, float]
) -> Iterator[LoadStep]:
    """Yield what makes up the life of a stage, limit loads, and the cases that count for resonance alone.

    Args:
        design: With shares of cases and their levels.
        loads: Case -> torque [N m] and rolling speed [rad/s].
        largest_load: The largest of those that last.
    """
    torque, rolling = largest_load
    shares, life = shares_of(design), design.service.life
    for case, share in shares.items():
        for level, part in levels_of(design, case):
            if share * part > 0.0 and loads[case][0] > 0.0:
                yield LoadStep(case, level * loads[case][0] / torque, loads[case][1] / rolling, share * part * life)
    for case, (load, speed) in loads.items():
        if load <= 0.0:
            continue
        if case_named(design, case).static:
            turning = max(speed, 1e-3)
            yield LoadStep(case, load / torque, turning / rolling, 2.0 * math.pi / turning, static=True)
        elif not shares:
            heaviest_one = load >= torque * (1.0 - ROUNDING)
            yield LoadStep(case, load / torque, speed / rolling, life if heaviest_one else 0.0)


def heaviest(loads: Sequence[tuple[float, float]]) -> tuple[float, float]:
    """Return the largest of some torques, the first of equal ones, and the speed beside it; 0 and 1 without any.

    Args:
        loads: Torques [N m] and rolling speeds [rad/s].
    """
    return largest([(0.0, 1.0), *loads], lambda row: row[0])


def is_ready(task: StageTask, front: Front) -> bool:
    """Tell whether the speeds on one side of a stage, and the teeth that it shares, are chosen.

    Args:
        task: The stage.
        front: Choices of the stages before.
    """
    if isinstance(task.stage, Pair):
        shared = [gear_of(task.name, side, task.stage) for side in SIDES if task.stage.shared(side)]
        if any(str(gear) not in front.teeth for gear in shared):
            return False
    if isinstance(task.stage, Planetary):
        members = members_of(task.stage)
        return sum(member == GROUND or member in front.speeds for member in members) >= 2
    return task.edge is not None and any(shaft in front.speeds for shaft in (*task.edge.fast, *task.edge.slow))


def carried_over(design: Design, front: Front) -> Front:
    """Carry speeds across clutches and compound sets.

    Args:
        design: With those.
        front: Choices of the stages before.
    """
    if not design.clutches and not design.epicyclics:
        return front
    speeds = dict(front.speeds)
    for name in design.epicyclics:
        speeds |= handed_on(ties_of(design, name), speeds)
    for clutch in design.clutches.values():
        ends = (clutch.driving, clutch.driven)
        for here, there in (ends, ends[::-1]):
            if here in speeds and there not in speeds:
                speeds[there] = speeds[here]
    return replace(front, speeds=speeds)


# ----------------------------------------------------------------------------------------------------------------------
# The lightest combinations of teeth among which the sizing looks, one after the other.
# ----------------------------------------------------------------------------------------------------------------------


CONSIDERED = 60
"""Combinations of the lightest gears among which a sizing by a standard, or a preliminary one, looks [-]."""

StageTeeth = tuple[str, tuple[int, ...]]
"""Stage, and its teeth with its number of planets where that is open."""


def stage_teeth(train: Train, choice: Chosen) -> frozenset[StageTeeth]:
    """Return the teeth of every stage of a combination.

    Args:
        train: The graph.
        choice: The combination.
    """
    own = dict[str, tuple[int, ...]]()
    for gear in train.gears:
        own[gear.stage] = (*own.get(gear.stage, ()), choice.teeth[gear.name])
    return frozenset((stage, (*teeth, choice.planets.get(stage, 0))) for stage, teeth in own.items())
