"""How long the gears of a closed design live at the safeties that are asked."""

from __future__ import annotations

import math
from operator import itemgetter

from gearwright.closure.closed import StageLife
from gearwright.closure.requirements import requirement_of
from gearwright.closure.wishes import HOUR
from gearwright.ranking import smallest_first
from gearwright.sizing import Sizing
from gearwright.sizing.insight import trial_of
from gearwright.spec import edited
from gearwright.spec.design import RATINGS

LONGEST = 1e6 * HOUR
"""Above it a life is told as this one [s]."""
SHORTEST = 0.1 * HOUR
"""Below it a life is told as this one [s]."""
FATIGUE = ("pitting", "tooth root")
"""Modes that a life ends: cycles wear out flanks and roots, while scuffing, films and limit loads know no hours."""
CLOSE = 1e-3
"""Relative width of the bracket in which a life is found [-]."""


def stage_lives(sizing: Sizing, left_out: frozenset[str] = frozenset()) -> tuple[StageLife, ...]:
    """Return the largest life of every stage at which its safeties against fatigue are met, the shortest first.

    Args:
        sizing: As sized.
        left_out: Requirements that do not count.
    """
    stages = [name for name in sizing.design.simple_stages if RATINGS[sizing.design.rating(name)].fatigue]
    lives = [_life(sizing, stage, left_out) for stage in stages]
    return tuple(smallest_first(lives, lambda row: row.life))


def _life(sizing: Sizing, stage: str, left_out: frozenset[str]) -> StageLife:
    """Return the life of one stage: a bracket around it, then by halving its logarithm."""
    low = high = sizing.design.service.life
    margin, governs = _margin(sizing, stage, high, left_out)
    while margin >= 1.0 and high < LONGEST:
        low, high = high, 2.0 * high
        margin, governs = _margin(sizing, stage, high, left_out)
    while low == high and margin < 1.0 and low > SHORTEST:
        low = 0.5 * low
        margin, name = _margin(sizing, stage, low, left_out)
        low, high, governs = (low, 2.0 * low, governs) if margin >= 1.0 else (low, low, name)
    while high / low - 1.0 > CLOSE:
        middle = math.sqrt(low * high)
        margin, name = _margin(sizing, stage, middle, left_out)
        low, high, governs = (middle, high, governs) if margin >= 1.0 else (low, middle, name)
    return StageLife(stage, max(low, SHORTEST), governs)


def _margin(sizing: Sizing, stage: str, life: float, left_out: frozenset[str]) -> tuple[float, str]:
    """Return the least margin against fatigue of a stage that lives so long [-], and the name of its check."""
    design = edited(sizing.design, {"service.life_h": life / HOUR})
    mesh = next(mesh for mesh in sizing.meshes if mesh.stage == stage)
    gear = next(gear for gear in sizing.gears if gear.name == mesh.gears[0])
    checks = trial_of(design, sizing).checks(stage, gear.module, gear.face_width)
    fatigue = [check for check in checks if check.mode in FATIGUE and requirement_of(check) not in left_out]
    reserves = [(check.reserve, check.name) for check in fatigue if check.reserve is not None]
    return min(reserves, default=(math.inf, ""), key=itemgetter(0))
