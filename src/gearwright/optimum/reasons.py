"""Active constraints, shadow prices and uncertainty of an optimum, and the reasons where none exists."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, Check, Floats, GearwrightError, Problem, largest_first, margin_text, smallest_first
from gearwright.optimum.course import Archive, Bench, Compass, rounds
from gearwright.optimum.generations import (
    Fixed,
    is_continuous,
    judged_rows,
    place_of,
    sizes_of,
    sizing_of,
    teeth_of,
    with_teeth,
)
from gearwright.optimum.optimum import Best, Binding, Influence, Optimum, Price, Regret
from gearwright.sizing import Sizing
from gearwright.spec import Design, Study, Value, path_problem, standing_at, value_at
from gearwright.study.cases import Case, unit_sample
from gearwright.study.tables import Row

# ----------------------------------------------------------------------------------------------------------------------
# What keeps a design from being better: checks at their limits, constraints at their bounds, ranges at their ends.
# ----------------------------------------------------------------------------------------------------------------------


NEAR = 0.02
"""Of a limit within which it binds [-]."""
AT_END = 1e-3
"""Of a range within which its end binds [-]."""
DIGITS = 6
"""To which margins are told apart in their order: beyond is rounding [-]."""
FEW_LIMITS = 6
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
    return (*found[:FEW_LIMITS], *_ends(study, row))


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


# ----------------------------------------------------------------------------------------------------------------------
# Shadow prices: by how much every objective falls when a limit is relaxed by one per cent, and the design follows.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Doubt: what becomes of the front and of its choice where assumptions turn out otherwise.
# ----------------------------------------------------------------------------------------------------------------------


COMPARED = 24
"""Designs of the front that are held against each other, the chosen one among them [-]."""
LOW, HIGH = 0.16, 0.84
"""Between which 68 % of all that may come lies [-]."""
BAND = (0.05, 0.95)


def regrets_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Regret, ...]:
    """Return how designs of the front do in samples of what is uncertain, the chosen one first.

    In every sample all are sized anew with their teeth kept; a design regrets by how much its objectives, over the span
    of the front and each weighing the same, are worse than those of the best of that sample.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    study = answer.study
    if not study.uncertain or study.search is None:
        return ()
    places = _compared(answer)
    sizings = [sizing_of(study, bench.designs, answer.front[place].row) for place in places]
    samples = _samples(study, study.search.samples, study.search.seed)
    merits, spreads = [], []
    span, ideal = np.maximum(np.ptp(values, axis=0), 1e-300), values.min(axis=0)
    for place, sizing in zip(places, sizings, strict=True):
        fixed = _kept(answer, place, teeth_of(sizing))
        rows = bench.tried([_case(k, fixed, sample) for k, sample in enumerate(samples)])
        own = judged_rows(study, rows)
        merits.append(np.where(own.good, ((own.values - ideal) / span).mean(axis=1), np.inf))
        spreads.append(_spread(study, own.values[~own.failed]))
    merit = np.array(merits)
    least = merit.min(axis=0)
    some = np.isfinite(least)
    regret = merit[:, some] - least[some]
    best = merit[:, some].argmin(axis=0)
    keeps = [_keeps(bench, answer, place, sizing, samples) for place, sizing in zip(places, sizings, strict=True)]
    late = np.quantile(regret, 0.95, axis=1, method="higher")
    return tuple(
        Regret(place, float((best == k).mean()), float(regret[k].mean()), float(late[k]), keeps[k], spreads[k])
        for k, place in enumerate(places)
    )


def _compared(answer: Optimum) -> list[int]:
    """Return the chosen design, then others evenly along the front."""
    others = np.unique(np.linspace(0, len(answer.front) - 1, COMPARED).astype(int)).tolist()
    return [answer.chosen, *(place for place in others if place != answer.chosen)]


def _kept(answer: Optimum, place: int, more: Mapping[str, Value]) -> Fixed:
    row = answer.front[place].row
    return Fixed(row.design, {**row.inputs, **more})


def _case(number: int, fixed: Fixed, sample: Mapping[str, Value]) -> Case:
    return Case(number, fixed.design, {**fixed.inputs, **sample})


def _samples(study: Study, count: int, seed: int) -> list[dict[str, Value]]:
    """Return samples of what is uncertain: scrambled Sobol' points."""
    sampling = study.sampling.model_copy(update={"method": "sobol", "count": count, "seed": seed})
    cube = unit_sample(study.model_copy(update={"axes": study.uncertain, "sampling": sampling}))
    axes = list(study.uncertain.items())
    return [
        {path: value_at(path, axis, float(own)) for (path, axis), own in zip(axes, place, strict=True)}
        for place in cube
    ]


def _spread(study: Study, values: Floats) -> dict[str, tuple[float, float]]:
    """Return the band of every objective, in its own sense."""
    band = {}
    for (name, sense), column in zip(study.objectives.items(), values.T, strict=True):
        own = column if sense == "minimum" else -column
        band[name] = (
            (float(np.quantile(own, BAND[0])), float(np.quantile(own, BAND[1]))) if len(own) else (np.nan, np.nan)
        )
    return band


def _keeps(bench: Bench, answer: Optimum, place: int, sizing: Sizing, samples: Sequence[Mapping[str, Value]]) -> float:
    """Return in which part of the samples a design keeps the constraints as it was built."""
    fixed = _kept(answer, place, {**teeth_of(sizing), **sizes_of(sizing)})
    own = judged_rows(answer.study, bench.tried([_case(k, fixed, sample) for k, sample in enumerate(samples)]))
    good: Bools = own.good
    return float(good.mean())


def influences_of(bench: Bench, answer: Optimum, values: Floats) -> tuple[Influence, ...]:
    """Return what each assumption alone does, from its 16 to its 84 % quantile, all others at their medians.

    Args:
        bench: What evaluates; these designs are not kept.
        answer: With its front.
        values: Its objectives, shape (designs, objectives).
    """
    study = answer.study
    medians = {path: value_at(path, axis, 0.5) for path, axis in study.uncertain.items()}
    places = _compared(answer)
    span, ideal = np.maximum(np.ptp(values, axis=0), 1e-300), values.min(axis=0)
    signs = [1.0 if sense == "minimum" else -1.0 for sense in study.objectives.values()]
    found = []
    for path, axis in study.uncertain.items():
        ends, chosen = [], []
        for quantile in (LOW, HIGH):
            sample = {**medians, path: value_at(path, axis, quantile)}
            own = judged_rows(
                study, bench.tried([_case(k, _kept(answer, place, {}), sample) for k, place in enumerate(places)])
            )
            away = np.where(own.good[:, None], (own.values - ideal) / span, np.inf).max(axis=1)
            ends.append(own.values[0])
            chosen.append(places[int(np.argmin(away))])
        change = {name: sign * float(high - low)
                  for name, sign, low, high in zip(study.objectives, signs, *ends, strict=True)}  # fmt: skip
        low, high = (float(value_at(path, axis, quantile)) for quantile in (LOW, HIGH))
        found.append(Influence(path, low, high, change, (chosen[0], chosen[1])))
    return tuple(
        sorted(
            found,
            key=lambda own: (
                -sum(abs(own.changes[name]) / width for name, width in zip(study.objectives, span, strict=True))
            ),
        )
    )


# ----------------------------------------------------------------------------------------------------------------------
# Why a search has found nothing: the design that comes nearest, what it misses, and which checks keep it from it.
# ----------------------------------------------------------------------------------------------------------------------


FEW_CHECKS = 3
"""Checks that are named [-]."""


def shortfall(study: Study, designs: Mapping[str, Design], archive: Archive) -> list[Problem]:
    """Return why no design of a search is good.

    Args:
        study: With its constraints.
        designs: Name -> design.
        archive: Everything that was looked at, none of it good.
    """
    if archive.nearest is None:
        return [Problem("axes", f"every design is refused, the first with {archive.refusal}")]
    row = archive.nearest
    problems = list(_missed(study, archive, row))
    at = ", ".join(f"{path} = {value:.6g}" if isinstance(value, float) else f"{path} = {value}"
                   for path, value in row.inputs.items())  # fmt: skip
    failing = "; ".join(_failing(study, designs, row))
    told = f"the nearest of all that were looked at is {row.design}: {at}"
    why = f"; its sizing fails {failing}" if failing else ""
    return [*problems, Problem("axes", f"{told}{why}: free what these depend on, or widen the axes")]


def _missed(study: Study, archive: Archive, row: Row) -> Iterator[Problem]:
    """Yield every constraint that the nearest design breaks, and how near any design comes to it."""
    for name, least in zip(study.constraints, archive.least_broken.tolist(), strict=True):
        value, bound = row.shown(name), study.constraints[name]
        for limit, over in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
            if limit is not None and over * (value - limit) > 0.0:
                asked = f"at {'least' if over < 0.0 else 'most'} {limit:g} is asked"
                share = abs(value - limit) / (abs(limit) or 1.0)
                others = "others come nearer and break another" if least < share * (1.0 - 1e-9) else "none comes nearer"
                reached = f"the nearest design has {value:.4g}, {100 * share:.1f} % off; {others}"
                yield Problem(f"constraints.{name}", f"{asked}, and {reached}: relax it")


def _failing(study: Study, designs: Mapping[str, Design], row: Row) -> Iterator[str]:
    """Yield the checks of its sizing that fail, the worst first."""
    try:
        checks = sizing_of(study, designs, row).checks
    except GearwrightError:
        return
    worst = smallest_first((check for check in checks if check.fails), lambda check: check.margin or 0.0)
    yield from (f"{check.name} ({margin_text(check.margin or 0.0)} of what is asked)" for check in worst[:FEW_CHECKS])
