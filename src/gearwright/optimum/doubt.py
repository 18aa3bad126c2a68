"""Doubt: what becomes of the front and of its choice where assumptions turn out otherwise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gearwright.arrays import Bools, Floats
from gearwright.optimum.bench import Bench
from gearwright.optimum.judging import judged_rows
from gearwright.optimum.keeping import Fixed, sizes_of, sizing_of, teeth_of
from gearwright.optimum.optimum import Influence, Optimum, Regret
from gearwright.sizing import Sizing
from gearwright.spec import Study, value_at
from gearwright.spec.studies import Value
from gearwright.study.cases import Case, unit_sample

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
