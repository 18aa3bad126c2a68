"""The arrangement of a transmission whose gears are sized, found once."""

from __future__ import annotations

from gearwright.errors import DesignError, Problem, refuse
from gearwright.sizing.arranged import Arrangement, ShaftPlan
from gearwright.sizing.arrangement.axes import axes_of
from gearwright.sizing.arrangement.layout import plan_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing


def arrange(context: Context, gears: tuple[GearSizing, ...]) -> Arrangement:
    """Return where the axes of all shafts stand, and where everything sits along every shaft.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.

    Raises:
        DesignError: If axes do not close, or gears, places or bearings do not fit on their shafts.
    """
    axes = axes_of(context, gears)
    plans: dict[str, ShaftPlan] = {}
    problems: list[Problem] = []
    for name in context.design.shafts:
        try:
            plans[name] = plan_of(context, name, gears)
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    return Arrangement(axes, plans)
