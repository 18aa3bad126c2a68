"""Choose the tooth numbers: every admissible combination is evaluated, and the lightest gears win.

Stages are taken from the kept machines outwards, so that a stage's target is what the teeth chosen so far leave of the
asked speeds. A front holds all partial choices at once as arrays; each stage multiplies it by its candidates.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.identity import SIDES, Role
from gearwright.sizing.rating import rating_of
from gearwright.sizing.teeth.candidates import (
    REACHES,
    Reach,
    admissible,
    all_candidates,
    candidates,
    fewest_teeth,
    given_teeth,
    is_given,
    planet_counts,
    ring_teeth,
)
from gearwright.sizing.teeth.front import Front, Task
from gearwright.sizing.teeth.masses import aligned, weigh
from gearwright.sizing.teeth.refusal import contradiction, refusal
from gearwright.spec import GROUND, Design, Pair, Planetary
from gearwright.spec.design import module_owners
from gearwright.train import (
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
    willis_ratio,
    willis_speed,
)

EQUAL = 1e-9
"""Masses that differ by less are equal: the first of them, of the fewest teeth, is taken, whatever the rounding."""


class Chosen(NamedTuple):
    """What the search decides."""

    teeth: dict[str, int]
    """Gear -> tooth number [-]."""
    planets: dict[str, int]
    """Planetary set whose number of planets the design leaves out -> that number [-]."""


def choose_teeth(design: Design, train: Train) -> Chosen:
    """Return the tooth number of every gear, and how many planets each set has.

    Args:
        design: Given teeth are kept, those left out are chosen.
        train: Its graph.

    Raises:
        DesignError: If speeds are not determined, or a stage has no candidate; with what would do.
    """
    if all(is_given(stage) and len(planet_counts(stage, design)) == 1 for stage in design.stages.values()):
        return Chosen(given_teeth(design), {})  # which say every speed, with what holds in each case
    nominal = targets(design)
    for name, stage in design.planetaries.items():
        ratio = nominal.tooth_ratios[name]
        if not is_given(stage) and ratio <= 1.0:  # a ring no larger than its sun: no torques could be found
            raise refusal(name, stage, design, ratio, fewest=0, nominal=nominal)
    flow, kept = _nominal_flow(design, train, nominal)
    design = nominal.design
    tasks = [_task(name, design, train, nominal, flow) for name in design.simple_stages]
    front = _joined(design, Front({}, {shaft: np.array([nominal.speeds[shaft]]) for shaft in kept}, {}, {}))
    while tasks:
        task = next((task for task in tasks if _ready(task, front)), None)
        if task is None:
            raise DesignError(
                Problem(waiting.name, "no speed that is known leads to this stage; give its teeth") for waiting in tasks
            )
        tasks.remove(task)
        front = _joined(design, _extend(front, task, design, nominal, later=tasks))
    mass = aligned(front, design).mass
    best = front.take(np.array([int(np.argmax(mass <= mass.min() * (1.0 + EQUAL)))]))
    left_out = {name for name, stage in design.planetaries.items() if stage.planets_given is None}
    return Chosen(
        {name: int(value[0]) for name, value in best.teeth.items()} | _compound_teeth(design),
        {name: int(value[0]) for name, value in best.planets.items() if name in left_out},
    )


def _compound_teeth(design: Design) -> dict[str, int]:
    return {gear: teeth for name in design.epicyclics for gear, teeth in teeth_of(design, name).items()}


def _nominal_flow(design: Design, train: Train, nominal: Targets) -> tuple[dict[str, PowerFlow], set[str]]:
    """Return the power flow of every case at the asked ratios, and the shafts whose speed is kept."""
    real: dict[str, float] = dict(_compound_teeth(design))
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


def _task(name: str, design: Design, train: Train, nominal: Targets, flows: Mapping[str, PowerFlow]) -> Task:
    stage, edge = design.simple_stages[name], nominal.edges.get(name)
    rating = rating_of(design, name)
    # The reference gear sits on the edge's fast shaft: the ring where the sun stands still, else sun or pinion.
    meshes = [mesh for mesh in train.meshes if mesh.stage == name]
    ring = edge is not None and edge.grounded is Role.SUN
    own_rows = meshes[1:] if ring else (meshes[:1] if isinstance(stage, Planetary) else meshes)
    torque, speed, rolling = 0.0, 1.0, 1.0
    for flow in flows.values():
        for mesh in own_rows:
            meshes_alike = 1 if isinstance(stage, Planetary) else mesh.count
            load = abs(flow.meshes[mesh.name].torques[1 if ring else 0]) / meshes_alike * rating.load_factor
            if load > torque:
                torque = load
                speed = abs(flow.speeds[mesh.nodes[1 if ring else 0]])
                rolling = abs(flow.speeds[meshes[0].nodes[0]] - flow.speeds[meshes[0].nodes[2]])
    return Task(name, stage, edge, module_owners(design)[name], rating, torque, speed, rolling)


def _ready(task: Task, front: Front) -> bool:
    """Tell whether the speeds on one side of a stage, and the teeth that it shares, are chosen."""
    if isinstance(task.stage, Pair):
        shared = [gear_of(task.name, side, task.stage) for side in SIDES if task.stage.shared(side)]
        if any(str(gear) not in front.teeth for gear in shared):
            return False
    if isinstance(task.stage, Planetary):
        members = members_of(task.stage)
        return sum(member == GROUND or member in front.speeds for member in members) >= 2
    return task.edge is not None and any(shaft in front.speeds for shaft in (*task.edge.fast, *task.edge.slow))


def _joined(design: Design, front: Front) -> Front:
    """Carry speeds across clutches and compound sets."""
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


def _is_alone(task: Task, reached: Iterable[str], later: Sequence[Task], design: Design) -> bool:
    """Tell whether a stage's teeth change nothing for others: no speed, no module, no common centre distance."""
    tied = {name: pair.coaxial_with for name, pair in design.pairs.items() if pair.coaxial_with is not None}
    owners = list(module_owners(design).values())
    if task.name in {*tied, *tied.values()} or owners.count(task.group) > 1:
        return False
    touched = {shaft for clutch in design.clutches.values() for shaft in (clutch.driving, clutch.driven)}
    for other in later:
        ends = () if other.edge is None else (*other.edge.fast, *other.edge.slow)
        touched |= {*ends, *(members_of(other.stage) if isinstance(other.stage, Planetary) else ())}
    return touched.isdisjoint(reached)


def _extend(front: Front, task: Task, design: Design, nominal: Targets, *, later: Sequence[Task]) -> Front:
    """Multiply the front by a stage's candidates and keep those that its rules admit; look further only if none is.

    Of a stage that is alone only the lightest candidate of every choice is kept.
    """
    target = _target(front, task, nominal)
    for reach in REACHES:
        parent, small, large = _near_target(front, task, design, target, reach=reach)
        actual = _tooth_ratio(task.stage, small, large)
        grown = front.take(parent)
        speeds = _new_speeds(grown, task, actual)
        good = _speeds_hold(task, design, speeds, len(small))
        if good.any():
            break
    else:
        if len(actual):
            raise contradiction(task.name, task.stage, design, float(np.median(actual)))
        ratio, fewest = float(np.median(target)), fewest_teeth(task.rating)
        raise refusal(task.name, task.stage, design, ratio, fewest=fewest, nominal=nominal)
    grown = replace(grown, speeds={**grown.speeds, **speeds})
    alike = parent if _is_alone(task, speeds, later, design) else np.arange(len(parent))
    if not good.all():
        grown, small, large, alike = grown.take(good), small[good], large[good], alike[good]
    return _lightest(grown, task, design, (small, large), alike)


def _near_target(front: Front, task: Task, design: Design, target: Floats, *, reach: Reach) -> tuple[Ints, Ints, Ints]:
    """Return a stage's candidates that some number of planets admits and that are near enough to what is asked."""
    open_ = _is_open(front, task, design)
    found = all_candidates(task, design) if open_ else candidates(front, task, design, target, reach=reach)
    parent, small, large = found
    counts = planet_counts(task.stage, design)
    fits = np.any([admissible(task, design, small, large, planets=planets) for planets in counts], axis=0)
    parent, small, large = parent[fits], small[fits], large[fits]
    if open_:
        return parent, small, large
    near = _near(task, design, _tooth_ratio(task.stage, small, large), target[parent])
    return parent[near], small[near], large[near]


def _lightest(front: Front, task: Task, design: Design, gears: tuple[Ints, Ints], alike: Ints) -> Front:
    """Add a stage's teeth and bodies to the front, with every number of planets; keep the lightest of those alike."""
    fronts, groups = list[Front](), list[Ints]()
    small, large = gears
    for planets in planet_counts(task.stage, design):
        fits = admissible(task, design, small, large, planets=planets)
        if fits.any():
            fronts.append(weigh(front.take(fits), task, small[fits], large[fits], planets=planets))
            groups.append(alike[fits])
    weighed, group = fronts[0].joined(fronts[1:]), np.concatenate(groups)
    mass, least = weighed.mass, np.full(int(group.max()) + 1, np.inf)
    np.minimum.at(least, group, mass)
    light = np.flatnonzero(mass <= least[group] * (1.0 + EQUAL))
    return weighed.take(light[np.unique(group[light], return_index=True)[1]])


def _tooth_ratio(stage: Pair | Planetary, small: Ints, large: Ints) -> Floats:
    """Return z_2/z_1 or z_r/z_s [-]."""
    if not isinstance(stage, Planetary):
        return np.asarray(large / small)
    if stage.known_teeth is not None:
        return np.asarray(ring_teeth(stage, small, large) / small)
    return np.asarray(1.0 + 2.0 * large / small)


def _is_open(front: Front, task: Task, design: Design) -> bool:
    """Tell whether a stage's ratio is the search's own choice: the first of those that share an open ratio."""
    if design.teeth.split == "equal" or task.edge is None or is_given(task.stage) or task.stage.ratio is not None:
        return False
    known = {machine.shaft for machine in design.machines.values()} | set(front.speeds)
    far = task.edge.slow if task.edge.fast[0] in front.speeds else task.edge.fast
    return len(next(iter(front.speeds.values()))) == 1 and not known & set(far)


def _near(task: Task, design: Design, actual: Floats, asked: Floats) -> Bools:
    """Tell which tooth ratios are within the tolerance; given teeth are as they are."""
    if is_given(task.stage):
        return np.ones(len(actual), dtype=bool)
    carrier_part = 1.0 if isinstance(task.stage, Planetary) else 0.0
    return np.asarray(np.abs((carrier_part + actual) / (carrier_part + asked) - 1.0) <= design.teeth.stage_tolerance)


def _target(front: Front, task: Task, nominal: Targets) -> Floats:
    """Return the tooth ratio asked of every choice in the front [-]."""
    count = len(next(iter(front.speeds.values())))

    def speed(shaft: str) -> Floats:
        return front.speeds.get(shaft, np.full(count, nominal.speeds.get(shaft, 0.0)))

    if isinstance(task.stage, Planetary):
        return willis_ratio(task.stage, {member: speed(member) for member in members_of(task.stage)})
    edge = nominal.edges[task.name]
    return np.asarray(speed(_known(edge.fast, front)) / speed(_known(edge.slow, front)))


def _known(shafts: tuple[str, ...], front: Front) -> str:
    return next((shaft for shaft in shafts if shaft in front.speeds), shafts[0])


def _new_speeds(front: Front, task: Task, ratio: Floats) -> dict[str, Floats]:
    """Return the speeds of the shafts that a stage reaches."""
    known = front.speeds
    if isinstance(task.stage, Planetary):
        missing = [member for member in members_of(task.stage) if member != GROUND and member not in known]
        return {member: willis_speed(task.stage, member, ratio, known) for member in missing}
    edge = task.edge
    if edge is None:
        return {}
    source = next(shaft for shaft in (*edge.fast, *edge.slow) if shaft in known)
    fast = known[source] if source in edge.fast else known[source] * ratio
    reached = {**dict.fromkeys(edge.fast, fast), **dict.fromkeys(edge.slow, fast / ratio)}
    return {shaft: speed for shaft, speed in reached.items() if shaft not in known}


def _speeds_hold(task: Task, design: Design, speeds: Mapping[str, Floats], count: int) -> Bools:
    """Tell which choices keep the machines' speeds within the tolerance; given teeth are as they are."""
    good = np.ones(count, dtype=bool)
    if is_given(task.stage):
        return good
    for machine in design.machines.values():
        if machine.shaft in speeds and machine.asked_speed is not None:
            good &= np.abs(speeds[machine.shaft] / machine.asked_speed - 1.0) <= design.teeth.speed_tolerance
    return good
