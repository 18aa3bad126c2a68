"""Figures of what gearboxes weigh: the engines of the catalogue, their densities, the methods against real weights."""

from __future__ import annotations

import numpy as np

from gearwright.catalogue import Engine, Series, all_series, engines, weighed_gearboxes
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.units import POUND
from gearwright.weights import Comparison, LogLine, Score, checked_engines, gearbox_mass, log_line, refit, scores

_COLOURS = {
    "Pratt & Whitney Canada": theme.BLUE,
    "Rolls-Royce": theme.GREEN,
    "GE Aviation": theme.ORANGE,
    "Honeywell": theme.PURPLE,
}
_MARKERS = "osD^v<>P"
_KW = 1e3


def figure_mass_over_power(chosen: Comparison | None = None) -> Figure:
    """Return the thesis's figure 1.1: power against gearbox mass for every series, with the fitted power law.

    The masses are estimates by NASA'15, so the fits are properties of that formula and of the speeds of these engines.

    Args:
        chosen: A requirement to mark, with the band of the real weights.
    """
    figure = theme.sheet(WIDTH, 118.0)
    axes = figure.panel()
    for series in all_series():
        _draw_series(axes, series)
    for name, line, style in (("turboprops", turboprop_fit(), "-"), ("all 121 rows", fit_of_all_rows(), ":")):
        reach = np.geomspace(170.0, 4200.0, 50)
        law = f"{name}: m = {10**line.intercept:.4f} P^{line.slope:.3f}, R² = {line.r_squared:.2f}"
        axes.plot(reach, [line.at(p) for p in reach], color=theme.INK, ls=style, lw=1.4, label=law, zorder=1)
    axes.annotate("turboshafts that deliver\nat 6000 to 15 000 rpm", (640.0, 13.0), fontsize=7.5, color=theme.INK)
    if chosen is not None:
        _mark_requirement(axes, chosen)
    _log_axes(axes, "take-off power P [kW]", "gearbox mass m by NASA'15 [kg]")
    axes.set_xticks([200, 300, 500, 1000, 2000, 4000])
    axes.set_yticks([10, 20, 30, 50, 100, 200, 300])
    axes.set_title("Gearbox mass over power, 121 engines (Pulvirenti 2023, figure 1.1 redrawn)")
    axes.legend("right", size=7.0)
    return figure


def turboprop_fit() -> LogLine:
    """Return the power law of gearbox mass [kg] in power [kW] through the turboprops whose mass follows the formula."""
    turboprops = [
        engine
        for engine in engines()
        if engine.series.kind == "turboprop" and engine.note("gearbox_mass_kg", "differs") is None
    ]
    return log_line(
        [turboprop.power / _KW for turboprop in turboprops], [gearbox_mass(turboprop) for turboprop in turboprops]
    )


def fit_of_all_rows() -> LogLine:
    """Return the power law of printed gearbox mass [kg] in power [kW] through all 121 rows, flagged or not."""
    masses = [printed.value for engine in engines() if (printed := engine.as_printed("gearbox_mass_kg")) is not None]
    return log_line([engine.power / _KW for engine in engines()], masses)


def figure_densities() -> Figure:
    """Return power density of the gearbox and torque density of the engine, series by series."""
    figure = theme.sheet(WIDTH, 105.0)
    left, right = figure.grid(1, 2, share_y="all")[0]
    names = [series.name for series in all_series()]
    for place, series in enumerate(all_series()):
        rows = [engine for engine in checked_engines() if engine.engine.series is series]
        colour = _COLOURS[series.manufacturer]
        face = colour if rows[0].engine.has_gearbox else theme.PAPER
        for axes, column in ((left, "gearbox_kw_kg"), (right, "torque_nm_kg")):
            values = [value for row in rows if (value := row.check(column).computed) is not None]
            axes.plot([min(values), max(values)], [place, place], color=colour, lw=5.0, alpha=0.25)
            axes.scatter(values, [place] * len(values), s=20, color=face, edgecolors=colour, lw=0.9, zorder=3)
            axes.annotate(_span_text(values), (max(values), place), (6, 0), va="center", fontsize=7)
    for axes, label in (
        (left, "power density of the gearbox  P/m_GB [kW/kg]"),
        (right, "torque density  Q/m_engine [N m/kg]"),
    ):
        axes.set_xlabel(label)
        axes.only_grid("x")
        axes.set_xlim(0.0, axes.get_xlim()[1] * 1.2)
    left.set_yticks(range(len(names)), [f"{series.name}  ({series.kind})" for series in all_series()], fontsize=7.5)
    left.invert_yaxis()
    left.set_title("Densities by series, recomputed. Hollow: no such gearbox (CT7 turboshaft)")
    return figure


def figure_methods(chosen: Comparison | None = None) -> Figure:
    """Return the 61 real weights with the band of their refit, and bias and scatter of every method against them.

    Args:
        chosen: A requirement to mark, with the mass that each method gives it.
    """
    figure = theme.sheet(WIDTH, 95.0)
    left, right = figure.grid(1, 2, widths=(1.25, 1.0))[0]
    _draw_weights(left)
    if chosen is not None:
        _mark_methods(left, chosen)
    left.legend("upper left", size=7.0)
    _draw_scores(right, [score for score in scores() if score.bias is not None])
    return figure


def _draw_series(axes: Axes, series: Series) -> None:
    rows = [engine for engine in engines() if engine.series is series]
    computed = [row for row in rows if row.has_gearbox and row.note("gearbox_mass_kg", "differs") is None]
    kin = [relative for relative in all_series() if relative.manufacturer == series.manufacturer]
    colour, marker = _COLOURS[series.manufacturer], _MARKERS[kin.index(series)]
    face = colour if computed else theme.PAPER
    label = f"{series.name} ({len(rows)})" + ("" if computed else " flagged")
    x, y = [row.power / _KW for row in rows], [_mass_shown(row) for row in rows]
    axes.plot(x, y, marker, ms=4.0, color=colour, mfc=face, mec=colour, mew=0.9, alpha=0.85, label=label, zorder=3.0)


def _mass_shown(engine: Engine) -> float:
    """Return the recomputed mass, or the printed one where the formula does not make it."""
    printed = engine.as_printed("gearbox_mass_kg")
    if engine.note("gearbox_mass_kg", "differs") and printed is not None:
        return printed.value
    return gearbox_mass(engine)


def _mark_requirement(axes: Axes, chosen: Comparison) -> None:
    power = chosen.requirement.power / _KW
    for band in chosen.bands:
        axes.plot(
            [power, power],
            [band.low, band.high],
            color=theme.INK,
            lw=5.0 if band.level < 0.9 else 1.6,
            alpha=0.5,
            zorder=4,
        )
    taken = chosen.taken
    if taken is not None:
        label = "this requirement: mass taken, 68 and 95 % of real weights"
        axes.plot([power], [taken.mass], "D", ms=7.0, color=theme.INK, label=label, zorder=5.0)


def _draw_weights(axes: Axes) -> None:
    points = weighed_gearboxes()
    line = refit()
    reach = np.geomspace(points[0].beta, points[-1].beta, 120)
    for level, alpha in ((0.95, 0.13), (0.68, 0.22)):
        limits = np.array([line.band(beta, level) for beta in reach]) * POUND
        label = f"{level:.0%} of new gearboxes"
        axes.fill_between(reach, limits[:, 0], limits[:, 1], color=theme.BLUE, alpha=alpha, lw=0.0, label=label)
    law = f"refit, R² = {line.r_squared:.3f}"
    axes.plot(reach, [line.at(beta) * POUND for beta in reach], color=theme.BLUE, lw=1.5, label=law)
    axes.scatter(
        [point.beta for point in points],
        [point.mass for point in points],
        s=16,
        color=theme.INK,
        zorder=3,
        label="61 real gearboxes",
    )
    _log_axes(axes, "β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15", "gearbox mass [kg]")
    axes.set_xticks([0.6, 1, 2, 5, 10, 20, 50])
    axes.set_yticks([20, 50, 100, 200, 500, 1000, 2000, 5000])
    axes.set_title("Real weights (NASA/TM-2009-215680)")


def _mark_methods(axes: Axes, chosen: Comparison) -> None:
    masses = [estimate.mass for estimate in chosen.estimates if estimate.mass is not None]
    beta = chosen.requirement.beta
    label = f"methods at β = {beta:.3g}: {min(masses):.0f} to {max(masses):.0f} kg"
    axes.plot([beta] * len(masses), masses, "_", ms=9.0, color=theme.ORANGE, zorder=4.0, label=label)


def _draw_scores(axes: Axes, methods: list[Score]) -> None:
    for place, score in enumerate(methods):
        assert score.bias is not None  # the caller leaves the others out
        if score.bias_span is not None:
            axes.plot(score.bias_span, [place, place], color=theme.ORANGE, lw=7.0, alpha=0.35)
        if score.scatter is not None:
            axes.plot([score.bias / score.scatter, score.bias * score.scatter], [place, place], color=theme.INK, lw=1.2)
        axes.plot([score.bias], [place], "o", color=theme.INK, ms=5)
    axes.axvline(1.0, color=theme.BLUE, lw=1.2, zorder=0)
    _log_axes(axes, "estimate over real weight", "")
    axes.set_xticks([0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0])
    axes.set_yticks(range(len(methods)), [f"{score.method.name} ({score.count})" for score in methods], fontsize=7.5)
    axes.set_ylim(len(methods) - 0.5, -0.5)
    axes.set_title("Bias; one standard deviation (line);\nassumed speeds (bar)")


def _log_axes(axes: Axes, x: str, y: str) -> None:
    axes.set_xscale("log")
    if y:
        axes.set_yscale("log")
    axes.set(xlabel=x, ylabel=y)


def _span_text(values: list[float]) -> str:
    low, high = f"{min(values):.3g}", f"{max(values):.3g}"
    return low if low == high else f"{low}–{high}"
