"""Figures of studies: lines along an axis, stacked masses, spreads and fronts, trades between designs.

Their tables are in `tables/study`.
"""

import math
import textwrap
from collections.abc import Mapping, Sequence
from itertools import cycle, product
from typing import Any

import numpy as np

from gearwright.base import Floats, smallest_first, written
from gearwright.optimum import Optimum
from gearwright.render import style as theme
from gearwright.render.style import DUSK, colour_bar, shade, shades
from gearwright.render.tables.study import letter
from gearwright.render.tables.variants import BESIDE_MOTORS, FLAT, heading, is_counted, numeric_axis, percent
from gearwright.render.vector.figure import Axes, Figure, Parallel
from gearwright.spec import Study
from gearwright.study import Row, Table
from gearwright.study.answers import INDEX_CONFIDENCE as CONFIDENCE, Influence, Standing, Verdict, varies, verdict
from gearwright.study.tables import pareto_front

# ----------------------------------------------------------------------------------------------------------------------
# Figures of a study: lines along an axis with the optimum and how flat it is, or stacked masses of several designs.
# ----------------------------------------------------------------------------------------------------------------------


FEW_CURVES = 3
"""Curves up to which every optimum is written beside its ring."""
_MACHINES = ("motor_mass", *BESIDE_MOTORS)
_STACK = ("gear_mass", "shaft_mass", "carrier_mass", *_MACHINES)
_COMPLETE = ("complete_mass", *_MACHINES)
_COLOURS = (theme.BLUE, theme.GREEN, theme.AMBER, theme.ORANGE, theme.PURPLE, theme.SKY)
_STACK_COLOURS = dict(zip(_STACK, _COLOURS, strict=True))
_STACK_COLOURS["complete_mass"] = theme.BLUE
_HEAVIER_IS_BETTER = ("power_density", "total_power_density", "worst_margin", "review.margin")


def study_figure(table: Table, objectives: Mapping[str, str] | None = None) -> Figure:
    """Return the figure that suits a study: lines where a number varies, bars where designs are compared.

    Args:
        table: Of the study.
        objectives: Result -> ``minimum`` or ``maximum``, whose optima are marked; left out: every result has its own.
    """
    return sweep_figure(table, objectives) if numeric_axis(table) else comparison_figure(table)


@theme.drawn
def sweep_figure(table: Table, objectives: Mapping[str, str] | None = None) -> Figure:
    """Return every result against the last axis, one panel each, with the optimum and the range near it.

    Args:
        table: Of a study whose last axis is a number.
        objectives: Result -> ``minimum`` or ``maximum``, whose optima are marked; left out: every result has its own.
    """
    senses = objectives or {name: "maximum" if name in _HEAVIER_IS_BETTER else "minimum" for name in table.numbers}
    axis = numeric_axis(table) or ""
    figure = theme.sheet(180.0, 16.0 + 44.0 * len(table.numbers))
    panels = figure.grid(len(table.numbers), 1, share_x=True)[:, 0]
    curves = _curves(table, axis)
    few = len(curves) <= FEW_CURVES
    for panel, result in zip(panels, table.numbers, strict=True):
        for colour, (label, rows) in zip(_colours(len(curves)), curves.items(), strict=True):
            place: list[Any] = [row.inputs[axis] for row in rows]
            values = [row.shown(result) for row in rows]
            panel.plot(place, values, "-", color=colour, marker=".", ms=3.5, label=label)
            if result in senses:
                _mark_optimum(panel, place, values, colour=colour, sense=senses[result], flat=few)
        panel.set_ylabel(axis_label(table, result))
        panel.margins(x=0.02, y=0.18)
    tied = len(table.rows[0].inputs) - len(table.free)
    panels[-1].set_xlabel(f"{axis}, and {tied} more with it" if tied else axis)
    if few and len(curves) > 1:
        panels[0].legend("best")
    elif not few:
        others = ", ".join(path for path in table.free if path != axis)
        panels[0].legend("right", title=others, size=6.5)
    band = f", band within {percent(FLAT)} of it" if few else ""
    panels[0].set_title(f"{table.name}: ring at the optimum{band}")
    return figure


def _colours(count: int) -> list[Any]:
    """Return colours of curves: each its own for few, a scale in their order for many."""
    if count <= len(theme.CYCLE):
        return list(theme.CYCLE[:count])
    return [shade(k / (count - 1)) for k in range(count)]


def _curves(table: Table, axis: str) -> dict[str, list[Row]]:
    """Return the rows that differ in the axis alone, by what sets them apart."""
    groups: dict[str, list[Row]] = {}
    designs = {row.design for row in table.rows}
    for row in table.good:
        inputs = [str(row.inputs[path]) for path in table.free if path != axis]
        names = inputs if inputs and len(designs) == 1 else [row.design, *inputs]
        groups.setdefault(", ".join(names), []).append(row)
    return groups


def axis_label(table: Table, name: str) -> str:
    """Return what stands at the axis of an input or a result: what it is and its unit.

    Args:
        table: Of the study.
        name: Path of the input, or name of the result.
    """
    return f"{heading(name)} [{table.unit(name) or '-'}]" if name in table.results else name


def _mark_optimum(panel: Axes, place: list[Any], values: list[float], *, colour: Any, sense: str, flat: bool) -> None:
    """Ring the optimum of a curve; with its value and the range near it where there is room."""
    best = max(values) if sense == "maximum" else min(values)
    if not math.isfinite(best):
        return
    near = [x for x, value in zip(place, values, strict=True) if abs(value / best - 1.0) <= FLAT] if best else place
    at = place[values.index(best)]
    panel.plot([at], [best], "o", mfc=theme.PAPER, mec=colour, ms=8)
    if not flat:
        return
    panel.axvspan(min(near), max(near), color=colour, alpha=0.07, lw=0)
    offset = -12 if sense == "maximum" else 8
    side = {min(place): "left", max(place): "right"}.get(at, "center")
    panel.annotate(f"{best:.4g} at {at:g}", (at, best), (0, offset), ha=side,
                   fontsize=7.5, color=colour)  # fmt: skip


@theme.drawn
def comparison_figure(table: Table) -> Figure:
    """Return the masses of several designs as stacked bars, lightest first, with their power density.

    Args:
        table: With the results ``complete_mass`` and ``motor_mass``, or ``gear_mass``, ``shaft_mass``,
            ``carrier_mass`` and ``motor_mass``, or some of them.
    """
    whole = _COMPLETE[0] in table.results
    stack = [part for part in (_COMPLETE if whole else _STACK) if part in table.results and is_counted(table, part)]
    parts = stack or list(table.numbers[:1])
    rows = smallest_first(table.good, lambda row: sum(row.number(part) for part in parts))
    figure = theme.sheet(180.0, 26.0 + 7.0 * len(rows))
    axes = figure.panel()
    labels = [", ".join([row.design, *(str(value) for value in row.inputs.values())]) for row in rows]
    start = [0.0] * len(rows)
    for part in parts:
        values = [row.shown(part) for row in rows]
        axes.barh(
            labels, values, left=start, height=0.66, color=_STACK_COLOURS.get(part, theme.SKY), label=heading(part)
        )
        start = [left + value for left, value in zip(start, values, strict=True)]
    for place, (row, end) in enumerate(zip(rows, start, strict=True)):
        axes.annotate(_bar_text(row, end), (end, place), (4, 0), va="center", fontsize=7.5)
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(start, default=1.0) * 1.42)
    left_out = "gears, shafts, carriers and motors; without housing, bearings and oil"
    axes.set_xlabel(f"mass [kg]: {'gearbox with all its parts, and motors' if whole else left_out}")
    axes.legend("upper right")
    axes.set_title(table.name)
    axes.only_grid("x")
    return figure


def _bar_text(row: Row, total: float) -> str:
    text = f"{total:.1f} kg"
    dense = "power_density" in row.results and _COMPLETE[0] not in row.results  # it is of gears, shafts and carriers
    return f"{text}   gearbox {row.shown('power_density'):.1f} kW/kg" if dense else text


# ----------------------------------------------------------------------------------------------------------------------
# Figures of a trade between designs: every objective beside the others, and who wins under which weights.
# ----------------------------------------------------------------------------------------------------------------------


RANGE = (0.05, 0.5, 0.95)
"""Quantiles of a bar's ends and its dot [-]."""
SELDOM = 0.02
"""Part of the weights below which a design that is never first with equal ones is left out [-]."""
LOGARITHMIC = 30.0
"""Ratio of the largest to the smallest value that is drawn from which an axis is logarithmic [-]."""


@theme.drawn
def trade_figure(study: Study, table: Table, verdict: Verdict) -> Figure:
    """Return the objectives side by side, one row for each design, the winner at the top: median and 5 to 95 % range.

    Args:
        study: With objectives.
        table: Its rows.
        verdict: How its designs stand.
    """
    objectives = list(study.objectives)
    figure = theme.sheet(196.0, 24.0 + 7.5 * len(verdict.standings))
    panels = figure.grid(1, len(objectives), share_y="all")[0]
    for panel, name in zip(panels, objectives, strict=True):
        _draw_objective(panel, table, verdict.standings, name, sense=study.objectives[name])
    panels[0].set_yticks(range(len(verdict.standings)), [standing.design for standing in verdict.standings])
    return figure


def _draw_objective(panel: Axes, table: Table, standings: Sequence[Standing], name: str, *, sense: str) -> None:
    spreads = [
        np.array([row.shown(name) for row in table.good if row.design == standing.design]) for standing in standings
    ]
    medians = [float(np.median(values)) if len(values) else np.nan for values in spreads]
    best = int(np.nanargmin(medians) if sense == "minimum" else np.nanargmax(medians))
    draw_ranges(panel, spreads, best)
    words = textwrap.fill(f"{heading(name)}{_unit(table, name)}", 16)
    panel.set_title(f"{words}\n{'lower' if sense == 'minimum' else 'higher'} is better", fontsize=7.5)
    panel.x.size = 7.0


def draw_ranges(panel: Axes, spreads: Sequence[Floats], best: int | None = None) -> None:
    """Draw one row of a panel for each design: median and 5 to 95 % range, the best in another colour.

    Args:
        panel: To draw on.
        spreads: Values of each design, as they are shown.
        best: Row that stands out.
    """
    finite = [values[np.isfinite(values)] for values in spreads]
    drawn = np.array([end for values in finite if len(values) for end in np.quantile(values, RANGE)])
    if len(drawn) and 0.0 < drawn.min() < drawn.max() / LOGARITHMIC:
        panel.set_xscale("log")
    else:
        panel.x.most = 3
    panel.set_ylim(len(spreads) - 0.5, -0.75)
    panel.margins(x=0.16)
    for place, values in enumerate(spreads):
        colour, ink = (theme.ORANGE, theme.ORANGE) if place == best else (theme.BLUE, theme.INK)
        ends = np.quantile(values[np.isfinite(values)], RANGE) if np.isfinite(values).any() else None
        if ends is not None:
            panel.plot(ends[[0, 2]], [place, place], "-", color=colour, lw=2.2, alpha=0.45)
        median = float(np.median(values)) if len(values) else np.nan
        if np.isfinite(median):
            panel.plot([median], [place], "o", color=colour, ms=5)
            panel.annotate(written(median, 3), (median, place), (0, 4.5), ha="center",
                           fontsize=6.5, color=ink)  # fmt: skip
        else:
            words = "∞" if len(values) else "infeasible"
            panel.annotate(words, (0.98, place), frames=("axes", "data"), ha="right", va="center",
                           fontsize=6.5, color=ink)  # fmt: skip


def _unit(table: Table, name: str) -> str:
    return f" [{table.unit(name)}]" if table.unit(name) else ""


@theme.drawn
def weights_figure(verdict: Verdict) -> Figure:
    """Return how often each design comes first: with equal weights, and with all weights of the objectives.

    Args:
        verdict: How designs stand; those that are hardly ever first are left out.
    """
    rows = [standing for standing in verdict.standings if standing.first or standing.weights >= SELDOM]
    figure = theme.sheet(150.0, 19.0 + 7.0 * len(rows))
    axes = figure.panel()
    place = np.arange(len(rows))
    bars = ((-0.19, [row.first / verdict.scenarios for row in rows], theme.BLUE, "objectives weigh the same"),
            (0.19, [row.weights for row in rows], theme.SKY, "over all weights of the objectives"))  # fmt: skip
    for offset, values, colour, label in bars:
        axes.barh(place + offset, values, 0.36, color=colour, label=label)
        for at, value in zip(place, values, strict=True):
            axes.annotate(percent(value), (value, at + offset), (3, 0), va="center",
                          fontsize=7)  # fmt: skip
    axes.set_yticks(place, [row.design for row in rows])
    axes.invert_yaxis()
    axes.set_xlim(0.0, 1.1)
    axes.set_xticks([0.0, 0.25, 0.5, 0.75, 1.0], ["0", "25 %", "50 %", "75 %", "100 %"])
    axes.set_xlabel("part of the cases with equal inputs in which it is first")
    axes.legend("lower right")
    axes.only_grid("x")
    return figure


# ----------------------------------------------------------------------------------------------------------------------
# Figures of studies with many cases: distributions, parallel coordinates, contours, Pareto fronts, tornados.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Figures of a search: how the hypervolume of its front grew.
# ----------------------------------------------------------------------------------------------------------------------


@theme.drawn
def growth_figure(optimum: Optimum) -> Figure:
    """Return the hypervolume of the front after every generation.

    Args:
        optimum: From `optimise`.
    """
    figure = theme.sheet(150.0, 60.0)
    axes = figure.panel()
    axes.plot(range(1, len(optimum.growth) + 1), optimum.growth, "-", color=theme.BLUE, lw=1.4)
    axes.set_xlabel("generation")
    axes.set_ylabel("hypervolume [-]")
    return figure
