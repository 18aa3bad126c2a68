"""The arrangement of a transmission whose gears are sized, found once."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from gearwright.errors import DesignError, Problem, refuse
from gearwright.sizing.arranged import Arrangement, ShaftPlan
from gearwright.sizing.arrangement.axes import axes_of
from gearwright.sizing.arrangement.layout import NO_MOVES, Moves, plan_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing

NO_ANGLES: Mapping[str, float] = MappingProxyType({})
"""Nothing is turned."""


def arrange(
    context: Context,
    gears: tuple[GearSizing, ...],
    angles: Mapping[str, float] = NO_ANGLES,
    moves: Moves = NO_MOVES,
) -> Arrangement:
    """Return where the axes of all shafts stand, and where everything sits along every shaft.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].
        moves: Shaft and gear -> how far it stands from equal gaps, along the shaft [m].

    Raises:
        DesignError: If axes do not close, or gears, places or bearings do not fit on their shafts.
    """
    axes = axes_of(context, gears, angles)
    plans: dict[str, ShaftPlan] = {}
    problems: list[Problem] = []
    for name in context.design.shafts:
        try:
            plans[name] = plan_of(context, name, gears, moves)
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    return Arrangement(axes, plans)
