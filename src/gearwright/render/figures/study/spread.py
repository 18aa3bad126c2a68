"""Figures of studies with many cases: distributions, parallel coordinates, contours, Pareto fronts, tornados."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import cycle, product

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.figures.study.lines import axis_label, study_figure
from gearwright.render.figures.study.trade import draw_ranges, trade_figure
from gearwright.render.style import theme
from gearwright.render.style.compound import DUSK, colour_bar, shades
from gearwright.render.tables.study.lists import letter
from gearwright.render.tables.study.variants import heading, percent
from gearwright.render.vector.figure import Figure, Parallel
from gearwright.spec import Study
from gearwright.study import Row, Table
from gearwright.study.answers import Influence, pareto_front, varies, verdict
from gearwright.study.answers.sensitivity import CONFIDENCE

MOST_BINS, FEW_DESIGNS = 40, 4
"""Bars of a distribution; designs up to which bars are told apart."""
_MARKS = "os^v"
"""Shapes of points, for more designs than colours."""
CELLS = 96
"""Of a side of a map."""
MOST_LINES = 400
"""Cases drawn as parallel coordinates; more would be a wall of ink: evenly spaced ones are taken."""
MOST_BRUSHED = 2000
"""Cases that a page carries for a reader who brushes."""


def figure_of(study: Study, table: Table) -> Figure:
    """Return the figure that suits a study: a trade, a front, lines or bars of a grid, or distributions of samples.

    Args:
        study: As run.
        table: Its rows.
    """
    outcome = verdict(study, table)
    if outcome is not None:
        return trade_figure(study, table, outcome)
    if len(study.objectives) > 1:
        return pareto_figure(study, table, pareto_front(study, table))
    if study.sampling.method in ("grid", "list"):
        return study_figure(table, study.objectives)
    return distribution_figure(table)


@theme.drawn
def distribution_figure(table: Table) -> Figure:
    """Return the distribution of every result that varies, with median and 5 to 95 % range.

    Few designs are histograms in colours, many are one row each.

    Args:
        table: Of a study.
    """
    drawn = [name for name in table.numbers if varies(np.array(table.column(name)))]
    designs = tuple(dict.fromkeys(row.design for row in table.good))
    many = len(designs) > FEW_DESIGNS
    figure = theme.sheet(180.0, 14.0 + (12.0 + 6.5 * len(designs) if many else 38.0) * len(drawn))
    panels = figure.grid(max(1, len(drawn)), 1)[:, 0]
    for panel, result in zip(panels, drawn, strict=False):
        panel.set_xlabel(axis_label(table, result))
        if many:
            spreads = [np.array([row.shown(result) for row in table.good if row.design == name]) for name in designs]
            draw_ranges(panel, spreads)
            panel.set_yticks(range(len(designs)), designs)
            continue
        everything = np.array([row.shown(result) for row in table.good])
        bins = np.histogram_bin_edges(everything, bins=min(MOST_BINS, int(2.0 * math.sqrt(len(everything))) + 1))
        for design, colour in zip(designs, cycle(theme.CYCLE), strict=False):
            values = np.array([row.shown(result) for row in table.good if row.design == design])
            if len(values):
                low, median, high = np.quantile(values, (0.05, 0.5, 0.95))
                label = f"{design}: {median:.4g} ({low:.4g} to {high:.4g})"
                panel.hist(values, bins, color=colour, alpha=0.55, label=label)
                panel.axvline(median, color=colour, lw=0.9)
        panel.set_ylabel("cases")
        panel.legend("best", title="median (5 to 95 %)")
    return figure


@theme.drawn
def parallel_figure(table: Table, chosen: Sequence[Row] = ()) -> Figure:
    """Return inputs and results of every case as lines across parallel axes; chosen ones stand out.

    Args:
        table: Of a study.
        chosen: Such as its Pareto front.
    """
    names = [*(path for path in table.free if _numeric(table, path)), *table.numbers]
    every = table.good
    rows = every[:: max(1, len(every) // MOST_LINES)]
    names = [name for name in names if varies(np.array([_value(row, name) for row in rows]))]
    values = np.array([[_value(row, name) for name in names] for row in [*rows, *chosen]])
    low, high = values.min(axis=0), values.max(axis=0)
    placed = (values - low) / np.where(high > low, high - low, 1.0)
    figure = theme.sheet(180.0, 90.0)
    axes = figure.panel()
    axes.plot(range(len(names)), placed[: len(rows)].T, color=theme.MUTED, lw=0.4, alpha=0.35)
    if len(chosen):
        axes.plot(range(len(names)), placed[len(rows) :].T, color=theme.ORANGE, lw=1.0)
    for k in range(len(names)):
        axes.axvline(k, color=theme.INK, lw=0.6)
        axes.annotate(f"{high[k]:.4g}", (k, 1.0), (0, 3), ha="center", fontsize=7)
        axes.annotate(f"{low[k]:.4g}", (k, 0.0), (0, -9), ha="center", fontsize=7)
    axes.set_xticks(range(len(names)), [_wrapped(axis_label(table, name)) for name in names], fontsize=7)
    axes.x.ticks = axes.y.ticks = axes.y.numbers = axes.x.grid = axes.y.grid = False
    axes.left_spine = axes.bottom_spine = False
    axes.set_ylim(-0.08, 1.02)
    figure.parallel = _brushed(table, names, chosen)
    return figure


def _brushed(table: Table, names: Sequence[str], chosen: Sequence[Row]) -> Parallel | None:
    """Return what a reader of a page may brush: as many cases as it carries, chosen ones among them."""
    every = [row for row in table.good if row not in chosen]
    kept = [*chosen, *every[:: max(1, math.ceil(len(every) / MOST_BRUSHED))]]
    if len(names) < 2:
        return None
    drawn = range(len(chosen), len(kept))[:: max(1, (len(kept) - len(chosen)) // MOST_LINES)]
    values = np.array([[_value(row, name) for name in names] for row in kept])
    labels = tuple(axis_label(table, name) for name in names)
    return Parallel(labels, values, (*drawn, *range(len(chosen))), tuple(range(len(chosen))))


@theme.drawn
def contour_figure(table: Table, result: str) -> Figure:
    """Return a result over the first two axes that are numbers, as filled contours between the cases.

    Args:
        table: Of a study with two axes that are numbers, of one design.
        result: Its name.
    """
    across, up = [path for path in table.free if _numeric(table, path)][:2]
    rows = table.good
    x, y = (np.array([_value(row, path) for row in rows]) for path in (across, up))
    z = np.array([row.shown(result) for row in rows])
    figure = theme.sheet(150.0, 100.0)
    axes, bar = figure.grid(1, 2, widths=(1.0, 0.03))[0]
    low, high = float(np.min(z)), float(np.max(z))
    level = (between(x, y, z) - low) / ((high - low) or 1.0)
    axes.picture((float(x.min()), float(y.min()), float(x.max()), float(y.max())), shades(level, DUSK))
    axes.plot(x, y, ".", color=theme.PAPER, ms=1.5, alpha=0.6)
    colour_bar(bar, (low, high if high > low else low + 1.0), DUSK, upright=True)
    bar.set_title(axis_label(table, result), fontsize=7.5)
    axes.set(xlabel=across, ylabel=up)
    return figure


def between(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return values between scattered ones, linear in triangles, on a grid of `CELLS` a side; outside not a number.

    Args:
        x: Places.
        y: Places.
        z: Values.
    """
    from scipy.interpolate import griddata

    across, up = (np.linspace(float(ends.min()), float(ends.max()), CELLS) for ends in (x, y))
    values: Floats = griddata((x, y), z, (across[None, :], up[:, None]), rescale=True)
    return values


@theme.drawn
def pareto_figure(study: Study, table: Table, front: Sequence[Row], chosen: Sequence[Row] = ()) -> Figure:
    """Return all cases over the first two objectives, the front joined, designs in colours and marks.

    Args:
        study: With two objectives or more.
        table: Its rows.
        front: From `pareto_front`.
        chosen: Designs of the front that get letters, in order.
    """
    across, up = list(study.objectives)[:2]
    figure = theme.sheet(150.0, 100.0)
    axes = figure.panel()
    designs = tuple(dict.fromkeys(row.design for row in table.rows))
    for design, (mark, colour) in zip(designs, cycle(product(_MARKS, theme.CYCLE)), strict=False):
        rows = [row for row in table.good if row.design == design]
        axes.plot(*_points(rows, across, up), mark, color=colour, ms=2.5, alpha=0.35, mew=0)
        best = [row for row in front if row.design == design]
        axes.plot(*_points(best, across, up), mark, color=colour, ms=5, mec=theme.INK, mew=0.5)
        axes.plot([], [], mark, color=colour, ms=5, label=design)
    for k, row in enumerate(chosen):
        at = (row.shown(across), row.shown(up))
        axes.annotate(letter(k), at, (5, 4), fontsize=8, weight="bold")
    if len(study.objectives) == 2:
        axes.plot(*_points(front, across, up), "-", color=theme.INK, lw=0.8, label="front", zorder=1)
    axes.set_xlabel(f"{axis_label(table, across)}: {study.objectives[across]}")
    axes.set_ylabel(f"{axis_label(table, up)}: {study.objectives[up]}")
    axes.legend("best")
    return figure


@theme.drawn
def tornado_figure(result: str, influences: Sequence[Influence]) -> Figure:
    """Return the total and first-order influence of every axis on a result as bars with their confidence.

    Args:
        result: Its name.
        influences: From `sensitivity`.
    """
    figure = theme.sheet(150.0, 24.0 + 12.0 * len(influences))
    axes = figure.panel()
    place = np.arange(len(influences))
    for offset, kind, colour in ((-0.19, "total", theme.BLUE), (0.19, "first", theme.SKY)):
        values = np.array([getattr(influence, kind) for influence in influences])
        ends = np.array([getattr(influence, f"{kind}_interval") for influence in influences]).T
        label = "with interactions" if kind == "total" else "alone"
        axes.barh(place + offset, values, 0.36, color=colour, label=label)
        axes.hlines(place + offset, np.minimum(values, ends[0]), np.maximum(values, ends[1]), lw=0.8)
    axes.set_yticks(place, [influence.axis for influence in influences])
    axes.invert_yaxis()
    axes.set_xlabel(f"share of the variance of {heading(result)} [-]; bars of {percent(CONFIDENCE)} confidence")
    axes.legend("lower right")
    axes.only_grid("x")
    return figure


def _value(row: Row, name: str) -> float:
    return float(row.inputs[name]) if name in row.inputs else row.shown(name)


def _points(rows: Sequence[Row], across: str, up: str) -> tuple[list[float], list[float]]:
    return [row.shown(across) for row in rows], [row.shown(up) for row in rows]


def _numeric(table: Table, path: str) -> bool:
    values = [row.inputs[path] for row in table.rows]
    return all(isinstance(value, int | float) and not isinstance(value, bool) for value in values)


def _wrapped(label: str) -> str:
    return label.replace(".", ".\n").replace(" [", "\n[")
