"""What keeps a design from being better: checks at their limits, constraints at their bounds, ranges at their ends."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

from gearwright.checks import Check
from gearwright.errors import GearwrightError
from gearwright.optimum.freedoms import is_continuous, place_of
from gearwright.optimum.keeping import sizing_of
from gearwright.optimum.optimum import Best, Binding
from gearwright.spec import Design, Study
from gearwright.study.answers import Row

NEAR = 0.02
"""Of a limit within which it binds [-]."""
AT_END = 1e-3
"""Of a range within which its end binds [-]."""
DIGITS = 6
"""To which margins are told apart in their order: beyond is rounding [-]."""
FEW = 6
"""Limits that are named of each design [-]."""


def best_of(study: Study, designs: Mapping[str, Design], row: Row, *, polished: bool) -> Best:
    """Return a design of the front with what binds it, and its teeth.

    Args:
        study: With its changes and constraints.
        designs: Name -> design.
        row: That could be sized.
        polished: Whether its sizes were polished.
    """
    try:
        sizing = sizing_of(study, designs, row)
    except GearwrightError:
        return Best(row, bindings(study, row, ()), {}, polished)
    teeth: dict[str, tuple[int, ...]] = {}
    for gear in sizing.gears:
        teeth[gear.stage] = (*teeth.get(gear.stage, ()), gear.teeth)
    return Best(row, bindings(study, row, sizing.checks), teeth, polished)


def bindings(study: Study, row: Row, checks: Iterable[Check]) -> tuple[Binding, ...]:
    """Return what binds a design, the nearest first.

    Args:
        study: With its constraints.
        row: That could be sized.
        checks: Of its sizing.
    """
    found = [*_checks(checks), *_constraints(study, row)]
    found.sort(key=lambda binding: round(binding.margin, DIGITS))
    return (*found[:FEW], *_ends(study, row))


def _checks(checks: Iterable[Check]) -> Iterator[Binding]:
    nearest: dict[str, float] = {}
    for check in checks:
        if check.margin is not None and not check.waiver and check.margin <= 1.0 + NEAR:
            nearest.setdefault(check.name, check.margin)
    yield from (Binding("check", name, margin) for name, margin in nearest.items())


def _constraints(study: Study, row: Row) -> Iterator[Binding]:
    for name, bound in study.constraints.items():
        value = row.shown(name)
        for limit, margin in (
            (bound.minimum, _ratio(value, bound.minimum)),
            (bound.maximum, _ratio(bound.maximum, value)),
        ):
            if limit is not None and math.isfinite(margin) and margin <= 1.0 + NEAR:
                yield Binding("constraint", name, margin)


def _ratio(value: float | None, limit: float | None) -> float:
    return value / limit if value is not None and limit else math.inf


def _ends(study: Study, row: Row) -> Iterator[Binding]:
    for path, axis in study.axes.items():
        if is_continuous(axis) and path in row.inputs:
            place = place_of(path, axis, row.inputs[path])
            if place <= AT_END or place >= 1.0 - AT_END:
                yield Binding("end of a range", path, 1.0)
