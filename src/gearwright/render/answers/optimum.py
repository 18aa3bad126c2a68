"""The answer of a search for the best designs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.optimum import Binding, Counts, Fit, Optimum
from gearwright.render.answers.plain import named
from gearwright.sizing import Named
from gearwright.units import Ratio


@dataclass(frozen=True)
class FrontRow:
    """A design of the front."""

    design: str
    inputs: Mapping[str, float | int | str | bool]
    """Dotted path, which ends in its unit -> value; of polished ones with their teeth."""
    results: Mapping[str, float | str]
    """Result with its unit -> value."""
    teeth: Mapping[str, tuple[int, ...]]
    """Stage -> teeth of its gears."""
    binds: tuple[Binding, ...]
    """What keeps it from being better, the nearest first."""
    polished: bool
    chosen: bool


@dataclass(frozen=True)
class PriceRow:
    """What a limit costs the chosen design."""

    limit: str
    kind: str
    changes: Mapping[str, float | str]
    """Objective with its unit -> its change for each per cent by which the limit is relaxed."""


@dataclass(frozen=True)
class RegretRow:
    """How a design of the front does where nobody knows what comes."""

    place: int
    """Of the design in the front, from 0."""
    best: Ratio
    """Part of the samples in which it is the best of the front."""
    mean: Ratio
    """Of how much it is worse than the best, over the span of the front."""
    late: Ratio
    """The same, which 95 % of the samples keep."""
    keeps: Ratio
    """Part of the samples in which it keeps every constraint as it was built."""
    low: Mapping[str, float | str]
    """Objective with its unit -> value that 5 % of the samples stay below."""
    high: Mapping[str, float | str]
    """Objective with its unit -> value that 95 % of the samples stay below."""


@dataclass(frozen=True)
class InfluenceRow:
    """What an assumption does to the chosen design."""

    path: str
    low: float
    """16 % quantile, in the unit of the path."""
    high: float
    """84 % quantile."""
    changes: Mapping[str, float | str]
    """Objective with its unit -> its change from low to high."""
    chosen: tuple[int, ...]
    """Designs of the front that would be chosen at either, from 0."""


@dataclass(frozen=True)
class OptimiseAnswer:
    """The best designs of a search."""

    name: str
    counts: Counts
    """What was looked at."""
    growth: tuple[float, ...]
    """Hypervolume of the front after every generation."""
    still: bool
    """Whether the hypervolume stood still; false where the evaluations ran out."""
    front: tuple[FrontRow, ...]
    """The best of the first objective first."""
    prices: tuple[PriceRow, ...]
    regrets: tuple[RegretRow, ...]
    """The chosen one first; empty where nothing is uncertain."""
    influences: tuple[InfluenceRow, ...]
    fits: tuple[Fit, ...]
    """How well surrogates foretell each result that they are not told; empty where none chose the designs."""


def optimise_answer(optimum: Optimum) -> OptimiseAnswer:
    """Return what `gearwright optimise --json` answers.

    Args:
        optimum: From `optimise`.
    """
    front = tuple(
        FrontRow(best.row.design, best.inputs, dict(named(best.row.results)), best.teeth, best.binds, best.polished,
                 place == optimum.chosen)
        for place, best in enumerate(optimum.front)
    )  # fmt: skip
    prices = tuple(PriceRow(own.limit, own.kind, _with_units(optimum, own.changes)) for own in optimum.prices)
    regrets = tuple(
        RegretRow(
            own.place, own.best, own.mean, own.late, own.keeps,
            *(_with_units(optimum, {name: ends[k] for name, ends in own.spread.items()}) for k in (0, 1)),
        )
        for own in optimum.regrets
    )  # fmt: skip
    influences = tuple(
        InfluenceRow(own.path, own.low, own.high, _with_units(optimum, own.changes), own.chosen)
        for own in optimum.influences
    )
    return OptimiseAnswer(
        optimum.study.name,
        optimum.counts,
        optimum.growth,
        optimum.still,
        front,
        prices,
        regrets,
        influences,
        optimum.fits,
    )


def _with_units(optimum: Optimum, values: Mapping[str, float]) -> dict[str, float | str]:
    """Return objectives with their units in their names."""
    results = optimum.best.row.results
    return dict(named({name: Named(value, results[name].dimension) for name, value in values.items()}))
