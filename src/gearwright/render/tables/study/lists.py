"""Tables on the page of a study: ranking, Pareto front, the spread of results, and what was varied."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from gearwright.render.grid.table import Cell, Column, Table
from gearwright.render.tables.study.variants import heading, percent, spread
from gearwright.sizing import Named
from gearwright.spec import Axis, Study
from gearwright.study import Row
from gearwright.study import Table as Rows
from gearwright.study.answers import Verdict, bound, quantiles
from gearwright.units import written

MILLION = 1e6
"""From here a number is written with a power of ten in narrow columns."""


def standings_table(rows: Rows, outcome: Verdict) -> Table:
    """Return how the designs stand: their places, how often they are first, and results that are names.

    Args:
        rows: Cases of a study.
        outcome: How its designs stand.
    """
    names = [name for name in rows.results if name not in rows.numbers]
    columns = [
        _column("design"),
        _column("mean rank"),
        _column("first"),
        _column("all weights"),
        _column("non-dominated"),
    ]
    columns += [_result_column(name, rows.good[0].results[name]) for name in names]
    lines = []
    for standing in outcome.standings:
        cases = [row for row in rows.good if row.design == standing.design]
        cells = [Cell(standing.design, standing.design), Cell(standing.place, f"{standing.place:.1f}")]
        cells += [
            _share(part) for part in (standing.first / outcome.scenarios, standing.weights, standing.non_dominated)
        ]
        lines.append((*cells, *(_typical(cases, name, rows) for name in names)))
    note = (
        "Mean rank over all objectives; first: part of the cases with equal inputs in which that rank is the best;"
        " all weights: part of all weights of the objectives, drawn evenly, with which it is first; non-dominated:"
        " part of the cases in which it is on the Pareto front."
    )
    return Table("Ranking of the designs", tuple(columns), tuple(lines), note)


def values_table(study: Study, rows: Rows, outcome: Verdict) -> Table:
    """Return median and range of every result that is a number, designs in the order of their places.

    Args:
        study: With objectives, which come first.
        rows: Its cases.
        outcome: How its designs stand.
    """
    names = [*study.objectives, *(name for name in rows.numbers if name not in study.objectives)]
    columns = [_column("design"), *(_result_column(name, rows.good[0].results[name]) for name in names)]
    by_design = [[row for row in rows.good if row.design == standing.design] for standing in outcome.standings]
    lines = [
        (Cell(standing.design, standing.design), *(_typical(cases, name, rows) for name in names))
        for standing, cases in zip(outcome.standings, by_design, strict=True)
    ]
    note = "Medians; in brackets from 5 to 95 % of the cases." if outcome.scenarios > 1 else ""
    return Table("Results of the designs", tuple(columns), tuple(lines), note)


def _typical(cases: Sequence[Row], name: str, rows: Rows) -> Cell:
    """Return the median with its range, or the commonest name."""
    if not cases:
        return Cell(None, "–")
    if name not in rows.numbers:
        word, count = Counter(str(row.results[name].value) for row in cases).most_common(1)[0]
        return Cell(word, word if count == len(cases) else f"{word} ({percent(count / len(cases))})")
    low, median, high = quantiles([row.shown(name) for row in cases], (0.05, 0.5, 0.95))
    if low == high:
        return Cell(median, written(median))
    digits = 3 if high - low > 0.01 * abs(median) else 4
    short = [_short(quantile, digits) for quantile in (median, low, high)]
    return Cell(median, f"{short[0]} ({short[1]}–{short[2]})")


def _short(number: float, digits: int) -> str:
    return f"{number:.1e}".replace("e+0", "e") if MILLION <= abs(number) < np.inf else written(number, digits)


def front_list(study: Study, rows: Rows, chosen: Sequence[Row]) -> Table:
    """Return the designs of a front with their letters, inputs and results.

    Args:
        study: With objectives.
        rows: Its cases.
        chosen: Those of the front that are listed.
    """
    first = chosen[0].results
    names = [*study.objectives, *(name for name in rows.results if name not in study.objectives)]
    columns = [_column(""), _column("design"), *(_column(path) for path in rows.free)]
    columns += [_result_column(name, first[name]) for name in names]
    lines = [
        (Cell(letter(k), letter(k)), Cell(row.design, row.design), *(_given(row.inputs[path]) for path in rows.free),
         *(_typical([row], name, rows) for name in names))
        for k, row in enumerate(chosen)
    ]  # fmt: skip
    return Table("Pareto front", tuple(columns), tuple(lines))


def letter(place: int) -> str:
    """Return the letter of a design on the front.

    Args:
        place: From 0.
    """
    return chr(ord("A") + place)


def spread_table(rows: Rows, *, sampled: bool) -> Table:
    """Return how every result is spread, and what 95 % of all that may come keep, with 95 % confidence.

    Args:
        rows: Cases of a study.
        sampled: Whether they are samples, which a bound needs.
    """
    names = ["result", "unit", "minimum", "5 %", "median", "95 %", "maximum"]
    columns = [_column(name) for name in (names + (["95 % are above", "95 % are below"] if sampled else []))]
    lines = []
    for line in spread(rows):
        values = [row.shown(line.result) for row in rows.good]
        cells = [Cell(heading(line.result), heading(line.result)), Cell(line.unit, line.unit)]
        cells += [Cell(0.0, text) for text in line.values]
        if sampled:
            above = bound([-value for value in values])
            cells += [_limit(None if above is None else -above), _limit(bound(values))]
        lines.append(tuple(cells))
    note = (
        "The last two columns hold for 95 % of all that may come, with 95 % confidence (Wilks 1941; 59 cases or more)."
    )
    return Table("How the results are spread", tuple(columns), tuple(lines), note if sampled else "")


def inputs_table(study: Study) -> Table:
    """Return what was varied and what was set.

    Args:
        study: As run.
    """
    lines = [(Cell(path, path), _word(axis_words(axis))) for path, axis in study.axes.items()]
    lines += [(Cell(path, path), _word(f"{value} in all cases")) for path, value in study.changes.items()]
    return Table("What was varied", (_column("path"), _column("values")), tuple(lines))


def axis_words(axis: Axis) -> str:
    """Return the values of an axis in words.

    Args:
        axis: As written.
    """
    if axis.values is not None:
        return ", ".join(str(value) for value in axis.values)
    if axis.distribution == "normal":
        return f"normal, mean {axis.mean:g}, standard deviation {axis.deviation:g}"
    ends = f"{axis.first:g} to {axis.last:g}"
    if axis.step is not None:
        return f"{ends} in steps of {axis.step:g}"
    likeliest = f", likeliest {axis.likeliest:g}" if axis.likeliest is not None else ""
    return f"{ends}, {axis.distribution}{likeliest}"


def _column(name: str) -> Column:
    return Column(name, name, "", "")


def _result_column(name: str, example: Named) -> Column:
    return Column(name, heading(name), "", "" if isinstance(example.value, str) else example.dimension)


def _share(part: float) -> Cell:
    return Cell(part, percent(part))


def _limit(value: float | None) -> Cell:
    return Cell(value, "too few" if value is None else written(value))


def _given(value: object) -> Cell:
    return Cell(value, f"{value:.5g}" if isinstance(value, float) else str(value))


def _word(text: str) -> Cell:
    return Cell(text, text)
