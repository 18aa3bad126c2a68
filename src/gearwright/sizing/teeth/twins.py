"""Twins: stages that do the same in the same place, such as inputs of two equal engines, and have the same teeth."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from gearwright.sizing.teeth.front import Task
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import module_owners
from gearwright.train import Targets

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
