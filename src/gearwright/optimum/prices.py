"""Shadow prices: by how much every objective falls when a limit is relaxed by one per cent, and the design follows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.optimum.bench import Bench
from gearwright.optimum.freedoms import is_continuous
from gearwright.optimum.judging import judged_rows
from gearwright.optimum.keeping import Fixed, with_teeth
from gearwright.optimum.optimum import Optimum, Price
from gearwright.optimum.polishing import Compass, rounds
from gearwright.ranking import largest_first
from gearwright.spec import Study, path_problem
from gearwright.spec.edit import standing_at
from gearwright.spec.studies import Value
from gearwright.study.cases import Case

RELAXED = 0.02
"""By which a limit is relaxed: far above rounding, near enough to be a slope [-]."""
LIMITS: Mapping[str, float] = {
    "gears.bending_safety": -1.0, "gears.contact_safety": -1.0, "gears.iso6336.bending_safety": -1.0,
    "gears.iso6336.pitting_safety": -1.0, "gears.iso6336.scuffing_safety": -1.0, "shafting.safety": -1.0,
    "carriers.safety": -1.0, "service.life_h": -1.0, "service.bearing_life_h": -1.0,
    "teeth.speed_tolerance": 1.0, "teeth.stage_tolerance": 1.0,
}  # fmt: skip
"""Path of a rule that every design owes -> which way relaxes it [-]."""


class _Relaxed(NamedTuple):
    """The search with one limit relaxed."""

    limit: str
    kind: str
    study: Study
    changes: Mapping[str, Value]


def prices_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Price, ...]:
    """Return what limits cost the chosen design, the dearest first.

    Teeth are kept and ranges polished, with every limit in turn relaxed by a little; against the same polish without.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    start = with_teeth(answer.study, bench.designs, answer.best.row)
    if start is None:
        return ()
    free = [_Relaxed("", "", answer.study, {}), *_rules(bench, answer), *_bounds(answer)]
    span = np.maximum(np.ptp(values, axis=0), 1e-3 * np.abs(values).max(axis=0) + 1e-300)
    found = _polished(bench, start, free, span)
    if found[0] is None:
        return ()
    signs = np.array([1.0 if sense == "minimum" else -1.0 for sense in answer.study.objectives.values()])
    prices = []
    for relaxed, own in zip(free[1:], found[1:], strict=True):
        if own is not None:
            change = signs * (own - found[0]) / (100.0 * RELAXED)
            prices.append(
                Price(relaxed.limit, relaxed.kind, dict(zip(answer.objectives, change.tolist(), strict=True)))
            )
    return tuple(largest_first(prices, lambda price: _weight(price, span, answer)))


def _weight(price: Price, span: Floats, answer: Optimum) -> float:
    return float(sum(abs(price.changes[name]) / width for name, width in zip(answer.objectives, span, strict=True)))


def _rules(bench: Bench, answer: Optimum) -> Iterator[_Relaxed]:
    """Yield the rules of the chosen design, each relaxed."""
    design = bench.designs[answer.best.row.design]
    for path, way in LIMITS.items():
        if path_problem(design, path) is None and path not in answer.study.axes:
            stands = answer.study.changes.get(path, standing_at(design, path).value)
            if isinstance(stands, int | float) and stands:
                yield _Relaxed(path, "rule", answer.study, {path: float(stands) * (1.0 + way * RELAXED)})


def _bounds(answer: Optimum) -> Iterator[_Relaxed]:
    """Yield the constraints of the study and the ends of ranges that bind, each relaxed."""
    study = answer.study
    bound = {(binding.kind, binding.name) for binding in answer.best.binds}
    for name, own in study.constraints.items():
        if ("constraint", name) in bound:
            relaxed = own.model_copy(update={
                "minimum": None if own.minimum is None else own.minimum - RELAXED * abs(own.minimum),
                "maximum": None if own.maximum is None else own.maximum + RELAXED * abs(own.maximum),
            })  # fmt: skip
            wider = study.model_copy(update={"constraints": {**study.constraints, name: relaxed}})
            yield _Relaxed(name, "constraint", wider, {})
    for path, axis in study.axes.items():
        if ("end of a range", path) in bound and axis.first is not None and axis.last is not None:
            room = RELAXED * (axis.last - axis.first)
            wide = axis.model_copy(
                update={"first": max(axis.first - room, min(axis.first, 0.0)), "last": axis.last + room}
            )
            yield _Relaxed(path, "end of a range", study.model_copy(update={"axes": {**study.axes, path: wide}}), {})


def _polished(bench: Bench, start: Fixed, free: list[_Relaxed], span: Floats) -> list[Floats | None]:
    """Return the objectives to which the chosen design comes under each relaxation; nothing where it cannot be."""
    continuous = any(map(is_continuous, free[0].study.axes.values()))
    begun = [Fixed(start.design, {**start.inputs, **relaxed.changes}) for relaxed in free]
    rows = bench.tried([Case(k, own.design, dict(own.inputs)) for k, own in enumerate(begun)])
    found: list[Floats | None] = []
    compasses: dict[int, Compass] = {}
    for k, (relaxed, row) in enumerate(zip(free, rows, strict=True)):
        own = judged_rows(relaxed.study, [row])
        found.append(own.values[0] if own.good[0] else None)
        if own.good[0] and continuous:
            compasses[k] = Compass(begun[k], relaxed.study.axes, own, span)
    numbers = {id(compass): k for k, compass in compasses.items()}
    for going, tried in rounds(list(compasses.values()), 1):
        cases = list[Case]()
        for compass, places in zip(going, tried, strict=True):
            cases += [
                Case(len(cases) + n, compass.start.design, compass.inputs(place)) for n, place in enumerate(places)
            ]
        answers = iter(bench.tried(cases))
        for compass, places in zip(going, tried, strict=True):
            own_rows = [next(answers) for _ in places]
            number = numbers[id(compass)]
            compass.note(places, own_rows, judged_rows(free[number].study, own_rows))
            found[number] = compass.judged.values[0]
    return found
