"""Figures of a trade between designs: every objective beside the others, and who wins under which weights."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.style import theme
from gearwright.render.tables.study.variants import heading, percent
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.spec import Study
from gearwright.study import Table
from gearwright.study.answers import Standing, Verdict
from gearwright.units import written

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
