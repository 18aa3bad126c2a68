"""Figures of load sharing: against time, by error, by chance, around a shaft, against the number of planets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.arrays import Floats, smallest_first
from gearwright.catalogue import load_factor_tables, load_factors
from gearwright.dynamics.equations import errors_at, line_forces
from gearwright.dynamics.sharing import (
    Allocation,
    LoadSharing,
    PlanetCounts,
    PlanetSharing,
    SharingProblem,
    SharingStudy,
    SupportSweep,
    shaft_displacement,
    single_error_sharing,
)
from gearwright.render import style as theme
from gearwright.render.style import WIDTH, upright_ranges
from gearwright.render.terminal import Grid
from gearwright.render.vector.figure import Axes, Figure

# ----------------------------------------------------------------------------------------------------------------------
# Figures of load sharing: against time, against the support of a floating shaft, by error, by chance, as an orbit.
# ----------------------------------------------------------------------------------------------------------------------


INSTANTS = 4000
"""Of a turn that is drawn."""
MICROMETRE = 1e-6
ROW = 5.0
"""Height of one bar [mm of paper]."""
PERCENTILES = (50.0, 95.0, 99.0)
LEAST_SPAN = 0.01
"""Of coefficients b, below which a panel would show rounding alone [-]."""
POINTS = 1200
"""Points of a curve: closer than a printer can tell apart."""


@theme.drawn
def sharing_figure(sharings: Mapping[str, LoadSharing]) -> Figure:
    """Return sharing coefficients against time, one panel each: over a tooth cycle, and pale behind it every instant.

    Args:
        sharings: Title -> sharing; the counterpart of the paper's figures 3, 4, 6 and 8 to 18.
    """
    figure = theme.sheet(WIDTH, 12.0 + 42.0 * len(sharings))
    panels = figure.grid(len(sharings), 1, share_x=True)[:, 0]
    for axes, (title, sharing) in zip(panels, sharings.items(), strict=True):
        _draw_sharing(axes, sharing)
        axes.set(title=title, ylabel="sharing coefficient b [-]")
    panels[0].legend("right")
    panels[-1].set_xlabel("time [s]")
    return figure


def _draw_sharing(axes: Axes, sharing: LoadSharing) -> None:
    cycle, instants = sharing.tooth_cycle, sharing.instantaneous
    middle = sharing.time[: len(cycle)] + 0.5 * sharing.period
    stride = max(1, len(cycle) // POINTS)
    bins = np.linspace(0, len(instants) - 1, POINTS // 2 + 1).astype(int)[:-1]
    for column, name in enumerate(sharing.lines):
        colour = theme.CYCLE[column % len(theme.CYCLE)]
        low, high = (extreme.reduceat(instants[:, column], bins) for extreme in (np.minimum, np.maximum))
        axes.fill_between(sharing.time[bins], low, high, color=colour, alpha=0.2, lw=0.0, zorder=1)
        axes.plot(middle[::stride], cycle[::stride, column], color=colour, label=name, zorder=2)
    axes.axhline(1.0, color=theme.MUTED, lw=0.6)
    axes.margins(x=0.0)
    least, most = min(float(instants.min()), 1.0), max(float(instants.max()), 1.0)
    if most - least < LEAST_SPAN:
        axes.set_ylim(least - LEAST_SPAN, most + LEAST_SPAN)


@theme.drawn
def displacement_figure(problems: Mapping[str, SharingProblem], shaft: str, time: Floats) -> Figure:
    """Return the quasi-static displacement of a floating shaft against time.

    Args:
        problems: Label -> problem; the counterpart of the paper's figures 5 and 7.
        shaft: That floats.
        time: [s], shape (instants,).
    """
    figure = theme.sheet(WIDTH, 60.0)
    axes = figure.panel()
    for label, problem in problems.items():
        moved = np.linalg.norm(_displacement(problem, shaft, time), axis=1)
        axes.plot(time, moved / MICROMETRE, label=label)
    axes.set(xlabel="time [s]", ylabel="displacement [µm]", title=f"How far shaft {shaft} moves")
    axes.legend("right")
    axes.margins(x=0.0)
    axes.set_ylim(bottom=0.0)
    return figure


def _displacement(problem: SharingProblem, shaft: str, time: Floats) -> Floats:
    force = line_forces(problem.train, errors_at(problem.system, time))
    return shaft_displacement(problem, shaft, force)


@theme.drawn
def orbit_figure(problem: SharingProblem, shafts: Sequence[str], time: Floats) -> Figure:
    """Return the paths of shafts' centres across themselves under slow errors.

    Args:
        problem: From `sharing_problem`.
        shafts: That move.
        time: [s], shape (instants,).
    """
    figure = theme.sheet(WIDTH, 62.0)
    panels = figure.grid(1, len(shafts))[0]
    for axes, shaft in zip(panels, shafts, strict=True):
        moved = _displacement(problem, shaft, time) / MICROMETRE
        axes.plot(moved[:, 0], moved[:, 1], lw=0.7)
        axes.plot(*np.mean(moved, axis=0).tolist(), "o", color=theme.ORANGE, ms=3.0)
        axes.set(title=shaft, xlabel="first axis across [µm]")
        axes.set_aspect("data")
    panels[0].set_ylabel("second axis across [µm]")
    return figure


@theme.drawn
def support_figure(sweep: SupportSweep, marked: Mapping[float, str]) -> Figure:
    """Return sharing and displacement against the stiffness of a shaft's support.

    Args:
        sweep: From `support_sweep`.
        marked: Stiffness [N/m] -> word beside it.
    """
    figure = theme.sheet(WIDTH, 95.0)
    sharing, way = figure.grid(2, 1, share_x=True)[:, 0]
    sharing.fill_between(sweep.stiffness, sweep.minimum, sweep.maximum, color=theme.SKY, alpha=0.35, lw=0.0)
    sharing.plot(sweep.stiffness, sweep.maximum, color=theme.BLUE, label="errors: minimum and maximum")
    sharing.plot(sweep.stiffness, sweep.minimum, color=theme.BLUE)
    sharing.plot(sweep.stiffness, sweep.perfect, color=theme.ORANGE, label="no errors")
    sharing.set(ylabel="sharing coefficient b [-]", title=f"What floating shaft {sweep.shaft} buys")
    way.plot(sweep.stiffness, sweep.displacement / MICROMETRE, color=theme.GREEN)
    way.set(xlabel="support stiffness [N/m]", ylabel="displacement [µm]")
    for axes in (sharing, way):
        axes.set_xscale("log")
    for stiffness, word in marked.items():
        for axes in (sharing, way):
            axes.axvline(stiffness, color=theme.MUTED, lw=0.7, ls=":")
        sharing.annotate(word, (stiffness, 1.0), (2, -9), frames=("data", "axes"), fontsize=6.5, color=theme.MUTED)
    sharing.legend("lower left")
    return figure


@theme.drawn
def tornado_figure(study: SharingStudy) -> Figure:
    """Return what every error does alone to the sharing, the largest on top.

    Args:
        study: From `sharing_study`.
    """
    rows = study.influences
    figure, axes = _rows([row.source for row in rows])
    colours = [theme.BLUE if row.turns else theme.AMBER for row in rows]
    effect = 100.0 * np.array([row.effect for row in rows])
    axes.barh(range(len(rows)), 2.0 * effect, left=-effect, color=colours, height=0.62)
    axes.set(
        xlabel="change of the sharing coefficient [%]", title="One error at a time: blue comes and goes, amber stays"
    )
    axes.axvline(0.0, color=theme.MUTED, lw=0.6)
    return figure


def _rows(names: Sequence[str]) -> tuple[Figure, Axes]:
    """Return a figure with a named row for each bar, the first on top."""
    figure = theme.sheet(WIDTH, 22.0 + ROW * len(names))
    axes = figure.panel()
    axes.set_yticks(range(len(names)), names, fontsize=7.0)
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.only_grid("x")
    return figure, axes


@theme.drawn
def distribution_figure(study: SharingStudy, target: float | None = None) -> Figure:
    """Return how the peak share of random gearboxes is spread.

    Args:
        study: From `sharing_study`, of a design with errors.
        target: Share that is asked for [-].
    """
    figure = theme.sheet(WIDTH, 65.0)
    axes = figure.panel()
    if study.distribution is not None:
        axes.hist(100.0 * study.distribution.peak, bins=60, color=theme.SKY)
        for percent in PERCENTILES:
            _mark(axes, 100.0 * study.distribution.percentile(percent), f"{percent:g} %")
        axes.set_title(f"All errors at full size, random phases: {len(study.distribution.peak)} gearboxes")
    if target is not None:
        axes.axvline(100.0 * target, color=theme.ORANGE, lw=1.2)
    axes.set(xlabel="share of the most loaded path at its worst moment [%]", ylabel="gearboxes")
    return figure


def _mark(axes: Axes, place: float, word: str) -> None:
    axes.axvline(place, color=theme.INK, lw=0.7, ls=":")
    axes.annotate(word, (place, 1.0), (2, -8), frames=("data", "axes"),
                  fontsize=6.5, color=theme.MUTED)  # fmt: skip


@theme.drawn
def allocation_figure(allocation: Allocation) -> Figure:
    """Return every tolerance as given and as allowed for the target.

    Args:
        allocation: From `allocate`.
    """
    rows = smallest_first(allocation.sizes, lambda row: row.allowed / row.given)
    figure, axes = _rows([row.error for row in rows])
    axes.barh(range(len(rows)), [100.0] * len(rows), color=theme.STEEL, height=0.7)
    axes.barh(range(len(rows)), [100.0 * row.allowed / row.given for row in rows], color=theme.GREEN, height=0.45)
    share = f"{100.0 * allocation.target:g}/{100.0 * (1.0 - allocation.target):g}"
    title = f"How tight for {share} in {allocation.percent:g} % of gearboxes, at least cost"
    axes.set(xlabel="allowed size over the size given [%]", title=title)
    return figure


@theme.drawn
def single_error_figure(
    problem: SharingProblem, span: tuple[float, float], names: Mapping[str, str] | None = None
) -> Figure:
    """Return the tooth-cycle sharing against time for every error alone, as in the paper's figures 8 to 18.

    Args:
        problem: From `sharing_problem`, with its errors.
        span: (from, to) [s].
        names: Error -> what its panel is called besides.
    """
    # Over a tooth cycle the ripple is gone, so that mean stiffness is enough.
    sharings = {
        source.name: single_error_sharing(problem, source, method="frequency response", span=span)
        for source in problem.sources
    }
    figure, grid = theme.tiles(len(sharings), 3, frame=14.0, row=30.0, share_y="all")
    for axes, (name, sharing) in zip(grid.flat, sharings.items(), strict=False):
        cycle = sharing.tooth_cycle
        stride = max(1, len(cycle) // POINTS)
        axes.plot(sharing.time[: len(cycle) : stride], cycle[::stride], lw=0.8)
        axes.set_title(": ".join(filter(None, ((names or {}).get(name), name))), fontsize=6.0)
        axes.axhline(1.0, color=theme.MUTED, lw=0.5)
        axes.margins(x=0.0)
    for axes in grid[:, 0]:
        axes.set_ylabel("b [-]")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return figure


@theme.drawn
def load_factor_figure(sets: Mapping[str, PlanetSharing], curves: Mapping[str, Mapping[int, float]]) -> Figure:
    """Return K_γ of random planetary sets against the number of planets: median, and where 90 % of the sets lie.

    Args:
        sets: Label, such as ``"floating sun"`` -> sets.
        curves: Label -> number of planets -> K_γ to lay beside them [-]: closed form, tables of standards.
    """
    figure = theme.sheet(WIDTH, 80.0)
    axes = figure.panel()
    for number, (label, sharing) in enumerate(sets.items()):
        low, middle, high = (list(sharing.percentile(percent).values()) for percent in (5.0, 50.0, 95.0))
        place = np.array(sharing.planets) + 0.12 * (number - 0.5 * (len(sets) - 1))
        colour = theme.CYCLE[number % len(theme.CYCLE)]
        upright_ranges(axes, place, np.array(low), np.array(high), colour=colour)
        axes.plot(place, middle, "o", ms=3.5, color=colour, label=label)
    for number, (label, curve) in enumerate(curves.items()):
        order = number + len(sets)
        colour, style = theme.CYCLE[order % len(theme.CYCLE)], "--" if order < len(theme.CYCLE) else ":"
        axes.plot(list(curve), list(curve.values()), style, lw=0.9, marker=".", color=colour, label=label, zorder=1)
    axes.set(xlabel="planets", ylabel="mesh load factor K_γ [-]", title="Random sets: median, 5 and 95 %")
    counts = {count for sharing in sets.values() for count in sharing.planets}
    axes.set_xticks(sorted(counts.union(*curves.values())))
    axes.legend("right", size=6.5)
    return figure


def one_turn(problems: Mapping[str, SharingProblem]) -> Floats:
    """Return instants over one turn of the slowest part that turns [s].

    Args:
        problems: Whose errors turn.
    """
    rates = [abs(source.rate) for problem in problems.values() for source in problem.sources if source.rate]
    return np.linspace(0.0, 2.0 * np.pi / min(rates), INSTANTS) if rates else np.zeros(1)


# ----------------------------------------------------------------------------------------------------------------------
# How paths that lie around a shaft share its load, as a polar figure: planets round their carrier.
# ----------------------------------------------------------------------------------------------------------------------


SIDES = 120
"""Corners of what is drawn for a circle."""
RING = 0.25
"""Step of the rings [-]."""
NEARLY, ROOM, WIDE = 0.2, 0.5, 2.8
"""What is counted as above or below the middle, room for words around the rings [-], half the width over the rings."""


@theme.drawn
def around_figure(sharing: LoadSharing) -> Figure:
    """Return the sharing coefficients of parallel paths in their order round the shaft, the first one on top.

    Args:
        sharing: Of three paths or more.
    """
    shares = sharing.instantaneous
    low, middle, high = shares.min(axis=0), shares.mean(axis=0), shares.max(axis=0)
    figure = theme.sheet(theme.WIDTH, 92.0)
    axes = figure.panel()
    axes.set_axis_off()
    axes.set_aspect("data")
    reach = _rings(axes, max(1.0, float(high.max())))
    turn = np.pi / 2.0 - 2.0 * np.pi * np.arange(len(middle)) / len(middle)
    half = 0.8 * np.pi / len(middle)
    for k, angle in enumerate(turn):
        colour = theme.CYCLE[k % len(theme.CYCLE)]
        arc = np.linspace(angle - half, angle + half, SIDES // 4)
        x, y = _places(arc, np.full(len(arc), middle[k]))
        axes.shape(np.stack([np.append(x, 0.0), np.append(y, 0.0)], axis=1), fc=colour, alpha=0.35, zorder=2.0)
        axes.plot(*_places(np.full(2, angle), np.array([low[k], high[k]])), color=colour, lw=3.0, zorder=3.0)
        at = (reach + 0.25) * np.cos(angle), (reach + 0.25) * np.sin(angle)
        across = "center" if abs(at[0]) < NEARLY else "left" if at[0] > 0.0 else "right"
        axes.annotate(sharing.lines[k], at, (0, 1), fontsize=7.5, ha=across, weight="bold")
        words = f"mean {middle[k]:.3f}, {low[k]:.3f} to {high[k]:.3f}"
        axes.annotate(words, at, (0, -8), fontsize=7.0, ha=across, color=theme.MUTED)
    axes.set(xlim=(-WIDE * reach, WIDE * reach), ylim=(-reach - ROOM, reach + ROOM))
    return figure


def _rings(axes: Axes, most: float) -> float:
    """Draw a ring for every step of the coefficient, the equal share darker; return the last one's."""
    count = int(np.ceil(most / RING))
    around = np.linspace(0.0, 2.0 * np.pi, SIDES + 1)
    for step in range(1, count + 1):
        equal = step * RING == 1.0
        colour, width = (theme.MUTED, 1.0) if equal else (theme.HAIR, 0.6)
        axes.plot(*_places(around, np.full(len(around), step * RING)), color=colour, lw=width, zorder=1.0)
    return count * RING


def _places(angle: Floats, radius: Floats) -> tuple[Floats, Floats]:
    return radius * np.cos(angle), radius * np.sin(angle)


# ----------------------------------------------------------------------------------------------------------------------
# K_γ against the number of planets: random sets, one pin in closed form, and what standards and tests say.
# ----------------------------------------------------------------------------------------------------------------------


PERCENT = 95.0
"""Percentage of random sets that stay below the factor that is shown."""
LIMIT = "errors as given, torque and gears kept; the tables grant planets that are sized for their number"


def planets_text(counts: PlanetCounts) -> RenderableType:
    """Return K_γ by number of planets as a table, with where the printed ones come from.

    Args:
        counts: From `planet_counts`.
    """
    columns = {f"{PERCENT:g} % of random sets": counts.random.percentile(PERCENT), **_beside(counts)}
    table = Grid(f"K_γ of {counts.stage} against planets", caption=LIMIT)
    table.add_column("planets", justify="right")
    for name in columns:
        table.add_column(name, justify="right")
    for count in counts.random.planets:
        table.add_row(str(count), *(f"{row[count]:.2f}" if count in row else "" for row in columns.values()))
    return Group(table, *(Text(line) for line in published_notes()))


def published_notes() -> list[str]:
    """Return one sentence on how sure each table is, and the measured values."""
    tables = {row.name: row.confidence for row in load_factors() if not row.measured}
    measured = (row for row in load_factors() if row.measured)
    return [f"{name}: {confidence}" for name, confidence in tables.items()] + [
        f"measured, {row.name}: {row.load_factor:.2f} ({row.planets} planets)" for row in measured
    ]


def planets_figure(counts: PlanetCounts) -> Figure:
    """Return K_γ against planets with the closed form and the standards' tables.

    Args:
        counts: From `planet_counts`.
    """
    return load_factor_figure({"random sets": counts.random}, _beside(counts))


def _beside(counts: PlanetCounts) -> dict[str, Mapping[int, float]]:
    closed = {"one pin, floating": counts.floating, "one pin, fixed": counts.fixed}
    return {**closed, **load_factor_tables()}
