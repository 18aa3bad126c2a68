"""Gears that no load case loads: strength asks nothing of them, so that they have no size but a given one."""

from __future__ import annotations

import math
from collections.abc import Mapping

from gearwright.errors import Problem, refuse
from gearwright.sizing.rating import Context

NOTHING = 1e-9
"""Torque over the largest of its kind below which it is rounding [-]."""


def refuse_idle_stages(context: Context, needed: Mapping[str, float]) -> None:
    """Raise where nothing loads the gears of a stage whose module is not given.

    Args:
        context: What gear sizing reads.
        needed: Stage -> module that its meshes, or a stage on the same axes, ask for [m].

    Raises:
        DesignError: For every such stage, with what to give.
    """
    largest = max(needed.values(), default=0.0)
    if not math.isfinite(largest):
        return
    problems = []
    for stage, module in needed.items():
        is_given = f"{stage}.module" in context.given or f"{stage}.outer_module" in context.given
        if module > math.cbrt(NOTHING) * largest or is_given:
            continue
        table = "pairs" if stage in context.design.pairs else "planetaries"
        key = "outer_module_mm" if context.ratings[stage].kind == "bevel" else "module_mm"
        message = (
            "no load case sends power through these gears, so that strength asks for no module; write one here, such as"
            f" {key} = 2, or a case that loads them"
        )
        problems.append(Problem(f"{table}.{stage}", message))
    refuse(problems)
