"""Required ratios of stages with free tooth numbers, and the ratios and speeds they can reach."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from gearwright.base import SIDES, DesignError, Floats, Problem
from gearwright.parts.planetary import most_planet_teeth
from gearwright.spec import GROUND, Clutch, Design, Epicyclic, Machine, Pair, Planetary, Record, case_named, cases_of
from gearwright.spec.design import MACHINES, SUN_LIMITS
from gearwright.train.graph import null_space, remembered
from gearwright.train.kinematics import (
    Edge,
    asked_tooth_ratio,
    edge_of,
    handed_on,
    members_of,
    ties_of,
    willis_ratio,
    willis_speed,
)
from gearwright.train.load_case import asked_speeds

# ----------------------------------------------------------------------------------------------------------------------
# A design as one of its cases holds it: what brakes hold belongs to the ground, and open clutches join nothing.
# ----------------------------------------------------------------------------------------------------------------------


Part = TypeVar("Part", bound=Record)


def as_held(design: Design, case: str) -> Design:
    """Return a design in which the brakes of a case ground members of planetary sets, without its open clutches.

    Args:
        design: As read.
        case: Name of one of its cases.
    """
    if not design.clutches:
        return design
    clutches = _holding(design, case)
    braked = {end for clutch in clutches.values() for end in (clutch.driving, clutch.driven) if _is_brake(clutch)}
    held = braked & _members(design)
    turning = {
        table: {name: machine for name, machine in getattr(design, table).items() if machine.shaft not in held}
        for table in MACHINES
    }
    grounded = {
        "shafts": [shaft for shaft in design.shafts if shaft not in held],
        "clutches": {name: clutch for name, clutch in clutches.items() if not _is_brake(clutch)},
        "planetaries": {name: _grounded(stage, held) for name, stage in design.planetaries.items()},
        "epicyclics": {name: _grounded_set(stage, held) for name, stage in design.epicyclics.items()},
    }
    return design.model_copy(update={**turning, **grounded})


def _holding(design: Design, case: str) -> dict[str, Clutch]:
    engaged = case_named(design, case).engaged
    return {
        name: clutch
        for name, clutch in design.clutches.items()
        if clutch.kind == "overrunning" or (clutch.kind == "engaged" if engaged is None else name in engaged)
    }


def _is_brake(clutch: Clutch) -> bool:
    return GROUND in (clutch.driving, clutch.driven)


def _members(design: Design) -> set[str]:
    """Return the shafts of planetary sets that carry no gear of a pair: held, they leave the speeds of others known."""
    members = {shaft for stage in design.planetaries.values() for shaft in (stage.sun, stage.ring, stage.carrier)}
    members |= {shaft for stage in design.epicyclics.values() for shaft in stage.members}
    return members - {shaft for pair in design.pairs.values() for side in SIDES for shaft in pair.named(side)}


def _grounded(part: Part, held: Set[str]) -> Part:
    """Return a record whose shafts that are held are the ground."""
    return part.model_copy(update={key: GROUND for key, value in part if isinstance(value, str) and value in held})


def _grounded_set(epicyclic: Epicyclic, held: Set[str]) -> Epicyclic:
    update = {
        "suns": {name: _grounded(gear, held) for name, gear in epicyclic.suns.items()},
        "rings": {name: _grounded(gear, held) for name, gear in epicyclic.rings.items()},
    }
    return _grounded(epicyclic, held).model_copy(update=update)


# ----------------------------------------------------------------------------------------------------------------------
# Which ratios a stage can have whatever its teeth, and which speeds that leaves a shaft between two others.
# ----------------------------------------------------------------------------------------------------------------------


Range = tuple[float, float]
"""Least and largest [-]."""
ANY: Range = (0.0, math.inf)
"""Of a stage of which nothing is known that limits it."""


def tooth_ratio_range(stage: Planetary, design: Design, *, sun: int) -> Range:
    """Return the least and the largest z_r/z_s of a planetary set whose teeth are free [-].

    The least has the largest sun and the smallest planets, the largest the planets that just pass their neighbours; two
    of them always do.

    Args:
        stage: As in the design.
        design: With the limits of the search.
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    rules = design.teeth
    largest, planets = rules.largest_sun(sun), stage.planets_given
    most = math.inf if planets is None or planets <= 2 else most_planet_teeth(largest, planets)
    return 1.0 + 2.0 * rules.planet_minimum / largest, 1.0 + 2.0 * most / largest


def ratio_range(stage: Pair | Planetary, edge: Edge, design: Design, *, sun: int) -> Range:
    """Return the least and the largest ratio of the speeds that a stage joins [-].

    Args:
        stage: As in the design.
        edge: The same as one ratio.
        design: With the limits of the search.
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    asked = asked_tooth_ratio(stage)
    if asked is not None:
        return edge.ratio(asked), edge.ratio(asked)
    if not isinstance(stage, Planetary) or (stage.sun_teeth or stage.planet_teeth or stage.ring_teeth):
        return ANY
    least, most = sorted(edge.ratio(tooth_ratio) for tooth_ratio in tooth_ratio_range(stage, design, sun=sun))
    return least, most


def total_range(design: Design, stages: Iterable[str], edges: Mapping[str, Edge]) -> Range:
    """Return the least and the largest ratio of stages in series [-].

    Args:
        design: With them.
        stages: Their names.
        edges: Stage -> its ratio; one that is in none may have any.
    """
    ranges = [
        ratio_range(design.simple_stages[name], edges[name], design, sun=SUN_LIMITS[-1]) if name in edges else ANY
        for name in stages
    ]
    return math.prod(least for least, _ in ranges), math.prod(most for _, most in ranges)


def speed_range(shaft: str, design: Design, speeds: Mapping[str, float], *, sun: int) -> Range:
    """Return between which speeds a shaft can turn, as its stages join it to shafts whose speeds are known [rad/s].

    Args:
        shaft: Of the design.
        design: With the stages.
        speeds: Shaft -> speed without its sense [rad/s].
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    low, high = ANY
    for name, stage in design.simple_stages.items():
        edge = edge_of(name, design)
        if edge is None:
            continue
        least, most = ratio_range(stage, edge, design, sun=sun)
        for other in edge.fast:
            if shaft in edge.slow and other in speeds:
                low, high = max(low, speeds[other] / most), min(high, speeds[other] / least if least else math.inf)
        for other in edge.slow:
            if shaft in edge.fast and other in speeds:
                low, high = max(low, speeds[other] * least), min(high, speeds[other] * most)
    return low, high


# ----------------------------------------------------------------------------------------------------------------------
# What ratio each stage should have, before teeth are chosen.
#
# Shaft speeds are potentials: every stage with one grounded member joins two shafts by one ratio, machines fix the
# speeds of their shafts, and what they leave open is split into equal ratios (Pulvirenti 2023, eq. 2.5; ψ is
# ``ratio_split``).
# ----------------------------------------------------------------------------------------------------------------------


# Weights of what holds first, in log speeds: the kept speed, given teeth and ratios, other machines, equal ratios.
_KEPT, _GIVEN, _ASKED, _EQUAL = 1e9, 1e6, 1e3, 1.0
_SIDE = 1e-3
"""Weight of equal ratios in stages off the way from the first machine to the propeller."""
_SAME = 1e-4
"""Of a machine's speed: what the weights above leave of one that is asked [-]."""


@dataclass(frozen=True)
class Targets:
    """Nominal speeds and tooth ratios."""

    speeds: Mapping[str, float]
    """Shaft -> nominal speed without its sense [rad/s]."""
    tooth_ratios: Mapping[str, float]
    """Stage -> z_2/z_1 or z_r/z_s asked [-]."""
    edges: Mapping[str, Edge]
    """Stages that join two shafts; a differential is not in it."""
    total: float
    """Ratio asked of all stages on the way from the first machine to the propeller [-]."""
    reach: tuple[float, float]
    """Least and largest ratio that these stages can have together [-]."""
    design: Design
    """As the case holds it that asks for them: members that a brake holds are grounded."""


def targets(design: Design) -> Targets:
    """Return the nominal speed of every shaft and the tooth ratio asked of every stage.

    They are those of the case whose brakes ground the most sets, the first of several, that leaves no speed open.

    Args:
        design: With its machines and stages.

    Raises:
        DesignError: If no case determines every speed, or a differential's speeds allow no teeth.
    """
    refused: DesignError | None = None
    for held in _as_held(design):
        try:
            return _targets(held)
        except DesignError as error:
            refused = refused or error
    raise refused or DesignError([])


def _as_held(design: Design) -> list[Design]:
    """Return the design as each case holds it, the one of the fewest differentials first."""
    cases = cases_of(design) if design.clutches else cases_of(design)[:1]
    return sorted((as_held(design, case) for case in cases), key=_differentials)


def _differentials(design: Design) -> int:
    return sum(GROUND not in members_of(planetary) for planetary in design.planetaries.values())


def _targets(design: Design) -> Targets:
    edges = {name: edge for name in design.simple_stages if (edge := edge_of(name, design)) is not None}
    speeds = _potentials(design, edges, {})
    stages = design.simple_stages
    split = {name: _ratio(edge, speeds) * stages[name].ratio_split for name, edge in edges.items()}
    changed = {name: ratio for name, ratio in split.items() if stages[name].ratio_split != 1.0}
    if changed:
        speeds = _potentials(design, edges, changed)
    speeds = _within_reach(design, edges, speeds, changed)
    tooth_ratios = {name: edge.tooth_ratio(_ratio(edge, speeds)) for name, edge in edges.items()}
    for name in design.planetaries.keys() - edges.keys():
        tooth_ratios[name] = _differential(name, design.planetaries[name], speeds)
    main = _main_stages(design, edges)
    start, end = _ends(design)
    return Targets(speeds, tooth_ratios, edges, speeds[start] / speeds[end], total_range(design, main, edges), design)


def _ratio(edge: Edge, speeds: Mapping[str, float]) -> float:
    return speeds[edge.fast[0]] / speeds[edge.slow[0]]


def _within_reach(
    design: Design, edges: Mapping[str, Edge], speeds: dict[str, float], fixed: Mapping[str, float]
) -> dict[str, float]:
    """Return speeds at which no free stage is asked for a ratio that no teeth have, as far as the others take the rest.

    Where they cannot, the machines would turn at other speeds than they ask for: then the speeds stay as they are.
    """
    shafts = {machine.shaft for machine in design.machines.values()}
    for sun in SUN_LIMITS:
        moved = _moved(design, edges, speeds, fixed, sun=sun)
        if all(math.isclose(moved[shaft], speeds[shaft], rel_tol=_SAME) for shaft in shafts):
            return moved
    return speeds


def _moved(
    design: Design, edges: Mapping[str, Edge], speeds: dict[str, float], fixed: Mapping[str, float], *, sun: int
) -> dict[str, float]:
    """Return speeds at which every free stage has a ratio that teeth have, whatever becomes of the machines' speeds."""
    bounds = dict(fixed)
    for _ in edges:
        beyond = {
            name: bound
            for name, edge in edges.items()
            if name not in bounds
            and (bound := _nearest(design.simple_stages[name], edge, design, speeds, sun=sun)) is not None
        }
        if not beyond:
            break
        bounds |= beyond
        speeds = _potentials(design, edges, bounds)
    return speeds


def _nearest(
    stage: Pair | Planetary, edge: Edge, design: Design, speeds: Mapping[str, float], *, sun: int
) -> float | None:
    """Return the ratio nearest to the asked one that teeth can have, or None where the asked one is that itself."""
    least, most = ratio_range(stage, edge, design, sun=sun)
    ratio = _ratio(edge, speeds)
    return None if asked_tooth_ratio(stage) is not None or least <= ratio <= most else min(max(ratio, least), most)


def _potentials(design: Design, edges: Mapping[str, Edge], fixed: Mapping[str, float]) -> dict[str, float]:
    """Return shaft speeds by weighted least squares in their logarithms."""
    column = {name: k for k, name in enumerate(design.shafts)}
    main = _main_stages(design, edges)
    equations: list[tuple[dict[str, float], float, float]] = []
    strong = _strong_speeds(design)
    for rank, (shaft, speed) in enumerate(strong.items()):
        equations.append(({shaft: 1.0}, math.log(speed), _KEPT if rank == 0 else _ASKED))
    for name, edge in edges.items():
        ratio, weight = _edge_ratio(design.simple_stages[name], edge, fixed.get(name))
        ends = [(fast, slow) for fast in edge.fast for slow in edge.slow]
        part = weight / math.sqrt(len(ends)) * (1.0 if name in main else _SIDE)
        equations += [({fast: 1.0, slow: -1.0}, math.log(ratio), part) for fast, slow in ends]
        equations += [({shaft: 1.0, first: -1.0}, 0.0, _GIVEN) for shaft, first in _alike(edge, strong)]
    for name in design.epicyclics:
        (first, speed), *others = list(ties_of(design, name).items()) or [("", 0.0)]
        equations += [({shaft: 1.0, first: -1.0}, math.log(abs(tied / speed)), _GIVEN) for shaft, tied in others]
    joined = design.clutches.values()
    equations += [({clutch.driving: 1.0, clutch.driven: -1.0}, 0.0, _GIVEN) for clutch in joined]
    matrix = np.zeros((len(equations), len(column)))
    kept, wanted = math.log(next(iter(strong.values()))), list[float]()
    for k, (terms, value, weight) in enumerate(equations):
        own = {column[shaft]: factor for shaft, factor in terms.items() if shaft != GROUND}
        for place, factor in own.items():
            matrix[k, place] += factor * weight
        wanted.append(value - kept if sum(own.values()) else value)
    _require_connected(matrix, design)
    shares = _shares(matrix).tolist()
    return {name: math.exp(kept + _dot(shares[k], wanted)) for name, k in column.items()}


@remembered
def _shares(matrix: Floats) -> Floats:
    """Return how much of what each equation asks, in its own weight, becomes of each unknown, (unknowns, equations)."""
    weights = np.abs(matrix).max(axis=1)
    return np.asarray(np.linalg.lstsq(matrix, np.diag(weights), rcond=1e-14)[0])


def _dot(shares: Sequence[float], values: Sequence[float]) -> float:
    return sum(share * value for share, value in zip(shares, values, strict=True))


def _alike(edge: Edge, strong: Mapping[str, float]) -> Iterator[tuple[str, str]]:
    """Yield shafts that turn alike, because equal gears on them mesh with one mate; not those whose speed is asked."""
    for side in (edge.fast, edge.slow):
        free = [shaft for shaft in side if shaft not in strong]
        if len(free) == len(side):
            yield from ((shaft, side[0]) for shaft in side[1:])


def _strong_speeds(design: Design) -> dict[str, float]:
    """Return the speeds that machines give, and those that follow from them through differentials of given ratio."""
    speeds: dict[str, float] = {}
    for machine, speed in asked_speeds(design, {}).items():
        speeds.setdefault(design.machines[machine].shaft, abs(speed))
    for _ in design.stages:
        for name in design.epicyclics:
            speeds |= handed_on(ties_of(design, name), speeds)
        for name, stage in design.simple_stages.items():
            _propagate(stage, edge_of(name, design), speeds)
    return speeds


def _propagate(stage: Pair | Planetary, edge: Edge | None, speeds: dict[str, float]) -> None:
    """Add the speed that a stage of given ratio hands on, if it hands on one."""
    ratio = asked_tooth_ratio(stage)
    if ratio is None:
        return
    if edge is not None:
        source = next((shaft for shaft in (*edge.fast, *edge.slow) if shaft in speeds), None)
        if source is not None:
            fast = speeds[source] * (1.0 if source in edge.fast else edge.ratio(ratio))
            for shaft in edge.fast:
                speeds.setdefault(shaft, fast)
            for shaft in edge.slow:
                speeds.setdefault(shaft, fast / edge.ratio(ratio))
        return
    if isinstance(stage, Pair):
        return
    missing = [member for member in members_of(stage) if member not in speeds]
    if len(missing) == 1:
        known = {member: np.array([speeds[member]]) for member in members_of(stage) if member in speeds}
        speeds[missing[0]] = float(willis_speed(stage, missing[0], np.array([ratio]), known)[0])


def _main_stages(design: Design, edges: Mapping[str, Edge]) -> set[str]:
    """Return the stages on the shortest way from the first machine to the first driven one, which share its ratio."""
    start, goal = _ends(design)
    ways: dict[str, tuple[str, ...]] = {start: ()}
    queue = [start]
    for shaft in queue:
        for name, ends in _neighbours(design, edges, shaft):
            for end in ends:
                if end not in ways:
                    ways[end] = (*ways[shaft], name)
                    queue.append(end)
    return set(ways.get(goal, ()))


def _goal(design: Design) -> Machine:
    """Return the first machine that is driven, or the last one where all drive."""
    *_, last = machines = list(design.machines.values())
    return next((machine for machine in machines if not machine.drives), last)


def _ends(design: Design) -> tuple[str, str]:
    """Return the shafts of the first machine and of the first that is driven."""
    return design.machines[next(iter(asked_speeds(design, {})))].shaft, _goal(design).shaft


def _neighbours(design: Design, edges: Mapping[str, Edge], shaft: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield what leads from a shaft, and where to: stages, differentials, clutches."""
    for name, edge in edges.items():
        if shaft in edge.fast:
            yield name, edge.slow
        if shaft in edge.slow:
            yield name, edge.fast
    for name, planetary in design.planetaries.items():
        if name not in edges and shaft in members_of(planetary):
            yield name, members_of(planetary)
    for name, epicyclic in design.epicyclics.items():
        if shaft in epicyclic.members:
            yield name, epicyclic.members
    for name, clutch in design.clutches.items():
        if shaft in (clutch.driving, clutch.driven):
            yield name, (clutch.driving, clutch.driven)


def _edge_ratio(stage: Pair | Planetary, edge: Edge, fixed: float | None) -> tuple[float, float]:
    """Return an edge's ratio and how firmly it holds."""
    asked = asked_tooth_ratio(stage)
    if asked is not None:
        return edge.ratio(asked), _GIVEN
    return (fixed, _GIVEN) if fixed is not None else (1.0, _EQUAL)


def _require_connected(matrix: Floats, design: Design) -> None:
    """Raise where a shaft's speed has no equation that leads to a machine."""
    swing = _undetermined(matrix)
    loose = [name for k, name in enumerate(design.shafts) if swing[k] > 1e-8]
    if loose:
        message = (
            f"the speeds of {', '.join(loose)} are not determined: no machine gives them, and no stage with a grounded"
            " member leads to a machine; put a machine with a speed on one of them, or ground a member"
        )
        raise DesignError([Problem("shafts", message)])


@remembered
def _undetermined(matrix: Floats) -> Floats:
    """Return how far each unknown may move without any equation noticing, of a motion of unit length."""
    free = null_space(matrix / np.maximum(np.abs(matrix).max(axis=1, keepdims=True), 1e-300))
    return np.asarray(np.abs(free).max(axis=1, initial=0.0))


def _differential(name: str, stage: Planetary, speeds: Mapping[str, float]) -> float:
    """Return z_r/z_s of a planetary set whose three members turn."""
    asked = asked_tooth_ratio(stage)
    if asked is not None:
        return asked
    sun, ring, carrier = (speeds[member] for member in members_of(stage))
    ratio = float(willis_ratio(stage, {member: np.asarray(speeds[member]) for member in members_of(stage)}))
    if not 1.0 < ratio < math.inf:
        message = (
            f"no teeth let sun, ring and carrier turn at {sun:.4g}, {ring:.4g} and {carrier:.4g} rad/s: z_r/z_s would"
            f" be {ratio:.3g}, and it must lie above 1; put the carrier's speed between the others, nearer the ring's"
        )
        raise DesignError([Problem(f"planetaries.{name}", message)])
    return ratio
