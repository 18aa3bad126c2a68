"""What the stages that are still to come weigh at the least, so that choices which cannot win are left out.

A stage and all that it drives weigh what they do by the speed of the shaft that leads to it. That is tabulated from the
last stages backwards over steps of that speed, each with the least load and the most choices that any speed in it has.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gearwright.arrays import Floats
from gearwright.identity import SIDES
from gearwright.sizing.teeth.candidates import Reach, admissible, assembled, candidates, is_given, planet_counts
from gearwright.sizing.teeth.closing import is_shifted, ring_variants
from gearwright.sizing.teeth.front import Front, Task
from gearwright.sizing.teeth.masses import weigh
from gearwright.sizing.teeth.stage import tooth_ratio
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import SUN_LIMITS
from gearwright.train import Targets

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


def branches_of(front: Front, later: Sequence[Task], design: Design, nominal: Targets) -> list[Branch]:
    """Return what is reached from the shafts that a front knows, as far as it can be bounded.

    Args:
        front: Choices of the stages before.
        later: The stages to come, in order.
        design: With the rules of the search.
        nominal: Asked speeds.
    """
    by, ordered, waiting = dict.fromkeys(front.speeds, ""), list[tuple[Task, str]](), list(later)
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


def _ends(task: Task) -> tuple[str, ...]:
    return () if task.edge is None else (*task.edge.fast, *task.edge.slow)


def _source(task: Task, reached: Collection[str], design: Design) -> str:
    """Return the shaft that leads to a stage that can be bounded; nothing where there is none, or more than one."""
    shares = isinstance(task.stage, Pair) and any(task.stage.shared(side) for side in SIDES)
    if task.edge is None or shares or design.teeth.split != "equal":
        return ""
    sides = [next((shaft for shaft in side if shaft in reached), "") for side in (task.edge.fast, task.edge.slow)]
    return "" if all(sides) else sides[0] or sides[1]


def _branch(task: Task, source: str, design: Design, nominal: Targets, beyond: Sequence[Branch]) -> Branch:
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


def _near(task: Task, design: Design, asked: tuple[float, float]) -> tuple[float, float]:
    """Return the least and the largest tooth ratio that is near enough to some of a range; all of given teeth."""
    if is_given(task.stage):
        return 0.0, math.inf
    part, tolerance = (1.0 if isinstance(task.stage, Planetary) else 0.0), design.teeth.stage_tolerance * _WIDE
    return (part + asked[0]) * (1.0 - tolerance) - part, (part + asked[1]) * (1.0 + tolerance) - part


def _candidates(task: Task, design: Design, allowed: tuple[float, float], speed: float) -> tuple[Floats, Floats]:
    """Return every tooth ratio in a range, the least first, and the mass of its gears at a speed of the fast shaft."""
    parts = [_of_variant(variant, design, allowed, speed) for variant in ring_variants(task, design)]
    ratio, masses = (np.concatenate(columns) for columns in zip(*parts, strict=True))
    order = np.argsort(ratio, kind="stable")
    return ratio[order], masses[order]


def _of_variant(task: Task, design: Design, allowed: tuple[float, float], speed: float) -> tuple[Floats, Floats]:
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
