"""One stage of the search: its candidates beside what the teeth chosen so far leave of the asked speeds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.sizing.teeth.candidates import (
    REACHES,
    Reach,
    admissible,
    all_candidates,
    fewest_teeth,
    is_given,
    planet_counts,
    ring_teeth,
    shares_gear,
)
from gearwright.sizing.teeth.closing import ring_variants
from gearwright.sizing.teeth.forbidden import clear, refused
from gearwright.sizing.teeth.front import Front, Task
from gearwright.sizing.teeth.masses import weigh
from gearwright.sizing.teeth.refusal import contradiction, refusal
from gearwright.sizing.teeth.states import Needs, lightest
from gearwright.sizing.teeth.tables import admitted, admitted_candidates
from gearwright.spec import GROUND, Design, Planetary
from gearwright.train import Targets, gears_of, members_of, willis_ratio, willis_speed

PARENTS = 2000
"""Choices that a stage multiplies by its candidates at once, so that memory is bounded [-]."""


MANY = 256
"""Ratios asked from which those that occur more than once are looked up once [-]."""


class Extended(NamedTuple):
    """A front with one more stage."""

    front: Front
    weighed: int
    """Candidates that were weighed [-]."""
    left_out: float
    """Combinations that cannot win [-]."""


def extend(
    front: Front, task: Task, design: Design, nominal: Targets, *, needs: Needs, may_win: Callable[[Front], Bools]
) -> Extended:
    """Multiply the front by a stage's candidates and keep those that its rules admit; look further only if none is.

    Of the choices that leave the same to the stages after them only the lightest is kept.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        nominal: Asked speeds.
        needs: What the stages after it read.
        may_win: Tells of which choices something may become the lightest.

    Raises:
        DesignError: If no candidate is left, with what would do.
    """
    forbidden = list[Front]()
    for reach in REACHES:
        near, grown, weighed, left_out = list[Floats](), list[Front](), 0, 0.0
        for part, variant in product(_parts(front), ring_variants(task, design)):
            ratios, added = _grown(part, variant, design, asked_ratios(part, task, nominal), reach=reach)
            near.append(ratios)
            if added is None:
                continue
            weighed += len(added)
            if task.bans:
                good = clear(added, task)
                if not good.any():
                    forbidden.append(added)
                    continue
                added = added.take(good)
            kept = lightest(added, needs)
            winning = may_win(kept)
            left_out += float(kept.tally["combinations"][~winning].sum())
            grown.append(kept.take(winning))
        if grown:
            whole = lightest(grown[0].joined(grown[1:]), needs) if len(grown) > 1 else grown[0]
            return Extended(whole, weighed, left_out)
    if forbidden:
        raise refused(task, forbidden)
    actual = np.concatenate(near)
    if len(actual):
        raise contradiction(task.name, task.stage, design, float(np.median(actual)))
    ratio, fewest = float(np.median(asked_ratios(front, task, nominal))), fewest_teeth(task.rating)
    raise refusal(task.name, task.stage, design, ratio, fewest=fewest, nominal=nominal)


def _parts(front: Front) -> Iterator[Front]:
    """Yield the front piece by piece."""
    if len(front) <= PARENTS:
        yield front
        return
    for start in range(0, len(front), PARENTS):
        yield front.take(np.arange(start, min(start + PARENTS, len(front))))


def _grown(front: Front, task: Task, design: Design, target: Floats, *, reach: Reach) -> tuple[Floats, Front | None]:
    """Return the tooth ratios that are near enough, and the choices that keep the machines' speeds, weighed."""
    parent, small, large = near_candidates(front, task, design, target, reach=reach)
    actual = tooth_ratio(task, small, large)
    grown = front.take(parent)
    speeds = new_speeds(grown, task, actual)
    good = _speeds_hold(task, design, speeds, len(small))
    if not good.any():
        return actual, None
    grown = replace(grown, speeds={**grown.speeds, **speeds})
    if not good.all():
        grown, small, large = grown.take(good), small[good], large[good]
    return actual, weighed_front(grown, task, design, small, large)


def weighed_front(front: Front, task: Task, design: Design, small: Ints, large: Ints) -> Front:
    """Add a stage's teeth and bodies to the front, with every number of planets, candidate after candidate.

    Args:
        front: Choices of the stages before, one for each candidate.
        task: The stage.
        design: With the rules of the search.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    fronts, places, counts = list[Front](), list[Ints](), planet_counts(task.name, design)
    if len(counts) == 1 and not task.twin:  # by which the candidates are chosen
        return weigh(front, task, small, large, planets=counts[0])
    for planets in counts:
        fits = admissible(task, design, small, large, planets=planets)
        if task.twin in front.planets:
            fits = fits & (front.planets[task.twin] == planets)
        if fits.all():
            fronts.append(weigh(front, task, small, large, planets=planets))
            places.append(np.arange(len(small)))
        elif fits.any():
            fronts.append(weigh(front.take(fits), task, small[fits], large[fits], planets=planets))
            places.append(np.flatnonzero(fits))
    if len(fronts) == 1:
        return fronts[0]
    return fronts[0].joined(fronts[1:]).take(np.argsort(np.concatenate(places), kind="stable"))


def near_candidates(
    front: Front, task: Task, design: Design, target: Floats, *, reach: Reach
) -> tuple[Ints, Ints, Ints]:
    """Return a stage's candidates that some number of planets admits and that are near enough to what is asked.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
        target: Tooth ratio asked of every choice [-].
        reach: How far it looks.
    """
    if not task.twin and not is_open(front, task, design):
        if len(target) < MANY or shares_gear(front, task):
            return _near_of(front, task, design, target, reach=reach)
        distinct, place = np.unique(target, return_inverse=True)
        parent, small, large = _near_of(front, task, design, distinct, reach=reach)
        parent, index = _repeated(parent, place, len(distinct))
        return parent, small[index], large[index]
    if task.twin:
        names = gears_of(task.twin, task.stage)
        parent, small, large = np.arange(len(front)), front.teeth[names[0]], front.teeth[names[1]]
    else:
        parent, small, large = all_candidates(task, design)
    fits = admitted(task, design, small, large)
    parent, small, large = parent[fits], small[fits], large[fits]
    if not task.twin:
        return parent, small, large
    near = _near(task, design, tooth_ratio(task, small, large), target[parent])
    return parent[near], small[near], large[near]


def _near_of(front: Front, task: Task, design: Design, target: Floats, *, reach: Reach) -> tuple[Ints, Ints, Ints]:
    """Return the candidates for some ratios that are admitted and near enough."""
    parent, small, large = admitted_candidates(front, task, design, target, reach=reach)
    near = _near(task, design, tooth_ratio(task, small, large), target[parent])
    return parent[near], small[near], large[near]


def _repeated(owner: Ints, place: Ints, count: int) -> tuple[Ints, Ints]:
    """Return who has a candidate, and which, where each has those of one of so many owners, in their order."""
    own = np.bincount(owner, minlength=count)
    first, many = np.cumsum(own) - own, own[place]
    parent = np.arange(len(place)).repeat(many)
    return parent, np.arange(len(parent)) + (first[place] - np.cumsum(many) + many).repeat(many)


def tooth_ratio(task: Task, small: Ints, large: Ints) -> Floats:
    """Return z_2/z_1 or z_r/z_s [-].

    Args:
        task: The stage.
        small: Teeth of pinion or sun.
        large: Teeth of wheel or planet.
    """
    if not isinstance(task.stage, Planetary):
        return np.asarray(large / small)
    if task.stage.known_teeth is not None or task.deviation:
        return np.asarray(ring_teeth(task, small, large) / small)
    return np.asarray(1.0 + 2.0 * large / small)


def is_open(front: Front, task: Task, design: Design) -> bool:
    """Tell whether a stage's ratio is the search's own choice: the first of those that share an open ratio.

    Args:
        front: Choices of the stages before.
        task: The stage.
        design: With the rules of the search.
    """
    if design.teeth.split == "equal" or task.edge is None or is_given(task.stage) or task.stage.ratio is not None:
        return False
    known = {machine.shaft for machine in design.machines.values()} | set(front.speeds)
    far = task.edge.slow if task.edge.fast[0] in front.speeds else task.edge.fast
    return len(front) == 1 and not known & set(far)


def _near(task: Task, design: Design, actual: Floats, asked: Floats) -> Bools:
    """Tell which tooth ratios are within the tolerance; given teeth are as they are."""
    if is_given(task.stage):
        return np.ones(len(actual), dtype=bool)
    carrier_part = 1.0 if isinstance(task.stage, Planetary) else 0.0
    return np.asarray(np.abs((carrier_part + actual) / (carrier_part + asked) - 1.0) <= design.teeth.stage_tolerance)


def asked_ratios(front: Front, task: Task, nominal: Targets) -> Floats:
    """Return the tooth ratio asked of every choice in the front [-].

    Args:
        front: Choices of the stages before.
        task: The stage.
        nominal: Asked speeds.
    """
    count = len(front)

    def speed(shaft: str) -> Floats:
        return front.speeds.get(shaft, np.full(count, nominal.speeds.get(shaft, 0.0)))

    if isinstance(task.stage, Planetary):
        return willis_ratio(task.stage, {member: speed(member) for member in members_of(task.stage)})
    edge = nominal.edges[task.name]
    return np.asarray(speed(_known(edge.fast, front)) / speed(_known(edge.slow, front)))


def _known(shafts: tuple[str, ...], front: Front) -> str:
    return next((shaft for shaft in shafts if shaft in front.speeds), shafts[0])


def new_speeds(front: Front, task: Task, ratio: Floats) -> dict[str, Floats]:
    """Return the speeds of the shafts that a stage reaches.

    Args:
        front: Choices with the stage's candidates.
        task: The stage.
        ratio: Tooth ratio of each [-].
    """
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
