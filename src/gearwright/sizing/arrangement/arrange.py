"""The arrangement of a transmission whose gears are sized, found once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from gearwright.errors import DesignError, Problem, refuse
from gearwright.sizing.arranged import Arrangement, ShaftPlan
from gearwright.sizing.arrangement.axes import axes_of, shared_axes
from gearwright.sizing.arrangement.axle import Axle, axles_of
from gearwright.sizing.arrangement.layout import NO_MOVES, Moves, on_shaft, plan_along, plan_of
from gearwright.sizing.arrangement.ordering import Way, best_way
from gearwright.sizing.arrangement.stretching import both_sides, spans_a_set, stretched
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec.design import NOTHING_GIVEN

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
    listed = {name: _listed(context, name) for name in context.design.shafts}
    ways = [(axle, best_way(axle)) for axle in axles_of(context, shared_axes(context.design), listed)]
    plans: dict[str, ShaftPlan] = {}
    problems: list[Problem] = []
    for name, names in _ordered(listed, ways).items():
        try:
            plans[name] = plan_of(context, name, gears, names, moves)
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    found = Arrangement(axes, plans)
    for axle, way in ways:
        found = _with(context, gears, found, axle, way)
    return found


def axles_in(context: Context) -> tuple[Axle, ...]:
    """Return what stands on every axis that several shafts share and whose bearings the design leaves open.

    Args:
        context: What sizing reads.
    """
    listed = {name: _listed(context, name) for name in context.design.shafts}
    return axles_of(context, shared_axes(context.design), listed)


def _listed(context: Context, shaft: str) -> tuple[str, ...]:
    """Return everything on a shaft in the usual order, what the design puts in order in that one."""
    names = tuple(on_shaft(context.design, context.train, shaft))
    layout = context.design.layout.get(shaft, NOTHING_GIVEN)
    if not layout.order:
        return names
    wished = (label for label in layout.order if label in names)
    return tuple(next(wished) if label in layout.order else label for label in names)


def _ordered(listed: Mapping[str, tuple[str, ...]], ways: Sequence[tuple[Axle, Way | None]]) -> dict[str, list[str]]:
    """Return shaft -> what stands on it, in the order of its axis; gears of pairs keep theirs."""
    found = {shaft: list(names) for shaft, names in listed.items()}
    for axle, way in ways:
        if way is not None:
            rank = {pair: k for k, token in enumerate(way.order) for pair in axle.tokens[token].labels}
            for shaft in axle.shafts:
                found[shaft].sort(key=lambda label, shaft=shaft: rank[shaft, label])  # type: ignore[misc]
    return found


def _with(
    context: Context, gears: tuple[GearSizing, ...], arrangement: Arrangement, axle: Axle, way: Way | None
) -> Arrangement:
    """Return an arrangement with what one axis adds to it."""
    if way is None:
        return replace(arrangement, unordered=(*arrangement.unordered, axle.shafts))
    if not spans_a_set(axle, way):
        return arrangement
    plans = dict(arrangement.plans)
    for shaft, (length, places) in stretched(context, axle, way, plans, gears).items():
        plans[shaft] = plan_along(context, shaft, length, places)
    within = tuple(pair for pair in way.within if pair[0] in plans and pair[1] in plans)
    return replace(
        arrangement, plans=plans, within=(*arrangement.within, *within), turned=(*arrangement.turned, *way.turned),
        two_sided=(*arrangement.two_sided, *both_sides(axle, way)),
    )  # fmt: skip
