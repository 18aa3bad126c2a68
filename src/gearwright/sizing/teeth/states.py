"""What partial choices leave to the stages after them: of those that leave the same, the lightest are kept.

This is dynamic programming: the teeth of a stage reach others by the speeds of shafts, by gears that two stages share,
and by modules that several have together, and by nothing else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.identity import SIDES
from gearwright.sizing.teeth.front import Front, Task
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import module_owners
from gearwright.train import gear_of, gears_of, members_of

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
