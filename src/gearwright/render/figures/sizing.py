"""Figures of a Sizing: where the mass is, and how much margin every check has."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gearwright.arrays import Floats
from gearwright.checks import ROUNDING, Check
from gearwright.identity import Kind
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.tables.sizing.overview import not_in_the_mass
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.sizing import ShaftDiagram, ShaftSizing, Sizing, mass_groups, mass_parts
from gearwright.units import margin_text

_GROUP_COLOURS = {"gears": theme.BLUE, "carriers": theme.AMBER, "shafts": theme.GREEN, "planet bearings": theme.SKY}
_ROW = 5.2
"""Height of one bar [mm]."""
_FRAME = 22.0
"""Height of title and axis [mm]."""
_PART_COLOURS = {"gears": theme.BLUE, "shafts": theme.GREEN, "carriers": theme.AMBER, "bearings": theme.SKY,
                 "joints": theme.ORANGE}  # fmt: skip
"""Group of parts -> colour of its checks."""
MOST_MARGINS = 45
"""Checks that are drawn at most, the worst ones; tables have all."""
STEPS = 12
"""Places between two loads at which a shaft's diagram is drawn."""
HOUR = 3600.0
"""[s]"""
LARGEST_MARGIN = 4.0
"""Margin at which a bar is cut [-]; its number says how large it is."""


@theme.drawn
def mass_figure(sizing: Sizing) -> Figure:
    """Return the mass of every part, heaviest first, in its group's colour.

    Args:
        sizing: As sized.
    """
    parts = mass_parts(sizing)
    figure = theme.sheet(WIDTH, _FRAME + 6.0 + _ROW * len(parts))
    axes = figure.panel()
    names = [f"{part.count} × {part.part}" if part.count > 1 else part.part for part in parts]
    axes.barh(names, [part.total for part in parts],
              color=[_GROUP_COLOURS[part.group] for part in parts], height=0.72)  # fmt: skip
    for place, part in enumerate(parts):
        axes.annotate(f"{part.total:.2f} kg  {part.share:.0%}", (part.total, place), (3, 0),
                       va="center", fontsize=7.5)  # fmt: skip
    groups = mass_groups(sizing)
    for group, colour in _GROUP_COLOURS.items():
        if group in groups:
            axes.barh([0], [0.0], color=colour, label=f"{group}  {groups[group]:.2f} kg")
    axes.legend("lower right")
    axes.invert_yaxis()
    axes.set(xlim=(0.0, max(part.total for part in parts) * 1.18), xlabel=f"mass [kg]. {not_in_the_mass(sizing)}")
    parts_mass = f", parts {sizing.parts_mass:.2f} kg" if sizing.mass != sizing.parts_mass else ""
    axes.set_title(f"Train as sized {sizing.mass:.2f} kg{parts_mass}, {sizing.power_density / 1e3:.1f} kW/kg")
    axes.only_grid("x")
    return figure


@theme.drawn
def margin_figure(sizing: Sizing) -> Figure:
    """Return the margin of every check, worst first: what loads decide above, what shape and room decide below.

    Args:
        sizing: As sized.
    """
    every = sizing.checks
    checks = every[:MOST_MARGINS]
    panels = {
        "Margins against loads": [check for check in checks if check.exponent is not None],
        "Margins of shape and room": [check for check in checks if check.exponent is None],
    }
    panels = {title: rows for title, rows in panels.items() if rows}
    figure = theme.sheet(WIDTH, _FRAME * len(panels) + _ROW * len(checks))
    grid = figure.grid(len(panels), 1, heights=[len(rows) + 2 for rows in panels.values()])
    for axes, (title, rows) in zip(grid[:, 0], panels.items(), strict=True):
        _bars(axes, rows)
        axes.set_title(f"{title}, worst first")
    left = f"; {len(every) - len(checks)} more in the tables" if len(checks) < len(every) else ""
    grid[-1, 0].set_xlabel(f"margin [-], the asked factor included; 1 is just enough{left}")
    return figure


def aged_bearings(sizing: Sizing) -> tuple[Check, ...]:
    """Return the checks of the lives of bearings that are loaded, the shortest first; `bearing_life_figure` draws them.

    Args:
        sizing: As sized.
    """
    lives = [check for check in sizing.checks if check.part.kind is Kind.BEARING and check.dimension == "life"]
    judged = [check for check in lives if check.limit is not None and math.isfinite(check.value or math.inf)]
    return tuple(sorted(judged, key=lambda check: check.value or math.inf))


@theme.drawn
def bearing_life_figure(lives: Sequence[Check]) -> Figure:
    """Return the rating life of every bearing beside the one that is asked for.

    Args:
        lives: From `aged_bearings`.
    """
    hours, asked = [(check.value or 0.0) / HOUR for check in lives], [(check.limit or 0.0) / HOUR for check in lives]
    figure = theme.sheet(WIDTH, _FRAME + _ROW * len(lives))
    axes = figure.panel()
    colours = [theme.ORANGE if check.fails else theme.SKY for check in lives]
    axes.barh(range(len(lives)), hours, color=colours, height=0.72)
    for place, (check, life) in enumerate(zip(lives, hours, strict=True)):
        axes.annotate(f"{life:,.0f} h{_case(check)}", (life, place), (3, 0), fontsize=7.5, va="center")
        axes.plot([asked[place]] * 2, [place - 0.45, place + 0.45], color=theme.ORANGE, lw=1.6, zorder=3.0)
    axes.set_yticks(range(len(lives)), [str(check.part) for check in lives])
    axes.set(xscale="log", xlim=(0.3 * min(*hours, *asked), 10.0 * max(*hours, *asked)))
    axes.set(xlabel="rating life [h]; upright lines: asked")
    axes.set_ylim(len(lives) - 0.4, -0.6)
    axes.only_grid("x")
    return figure


def _bars(axes: Axes, checks: Sequence[Check]) -> None:
    """Draw a bar for every check, in the colour of its part."""
    margins = [math.inf if check.margin is None else check.margin for check in checks]
    shown = [min(margin, LARGEST_MARGIN) for margin in margins]
    kinds = [_kind_of(check) for check in checks]
    axes.barh(range(len(checks)), shown, color=[_PART_COLOURS[kind] for kind in kinds], height=0.72)
    for kind in dict.fromkeys(kinds):
        axes.barh([0], [0.0], color=_PART_COLOURS[kind], label=kind)
    for place, (check, margin, length) in enumerate(zip(checks, margins, shown, strict=True)):
        colour = theme.ORANGE if check.fails else theme.INK
        told = "  too small" if check.fails else "  waived" if check.waiver else ""
        number = margin_text(margin, 4) if math.isfinite(margin) else "no load"
        axes.annotate(f"{number}{told}", (length, place), (3, 0), fontsize=7.5,
                       va="center", color=colour)  # fmt: skip
    axes.set_yticks(range(len(checks)), [f"{check.part}, {check.what}{_case(check)}" for check in checks])
    axes.axvline(1.0, color=theme.ORANGE, lw=1.2)
    axes.set_ylim(len(checks) - 0.4, -0.6)
    axes.set_xlim(0.0, LARGEST_MARGIN * 1.12)
    if len(set(kinds)) > 1:
        axes.legend("upper right")
    axes.only_grid("x")


def _case(check: Check) -> str:
    """Return the case that governs, where it is one."""
    return f", {check.case}" if check.case and check.exponent is not None else ""


def _kind_of(check: Check) -> str:
    """Return the group of a check's part, as the legend names it."""
    return {Kind.SHAFT: "shafts", Kind.BEARING: "bearings", Kind.JOINT: "joints", Kind.CARRIER: "carriers"}.get(
        check.part.kind, "gears"
    )


def bent_shafts(sizing: Sizing) -> list[ShaftSizing]:
    """Return the shafts that carry more than torque; opposite forces that cancel leave only rounding.

    Args:
        sizing: As sized.
    """
    moments = {shaft.name: float(np.max(_along(shaft.diagram)[2])) for shaft in sizing.shafts if shaft.bearings}
    largest = max(moments.values(), default=0.0)
    return [shaft for shaft in sizing.shafts if moments.get(shaft.name, 0.0) > ROUNDING * largest]


@theme.drawn
def shaft_figure(sizing: Sizing) -> Figure:
    """Return shear, bending of both planes together and torsion along every shaft that is bent.

    Args:
        sizing: As sized; `bent_shafts` finds at least one.
    """
    shafts = bent_shafts(sizing)
    figure = theme.sheet(WIDTH, 12.0 + 34.0 * len(shafts))
    grid = figure.grid(len(shafts), 3)
    for row, shaft in zip(grid, shafts, strict=True):
        place, *curves = _along(shaft.diagram)
        for axes, values, colour in zip(row, curves, (theme.GREEN, theme.BLUE, theme.ORANGE), strict=True):
            axes.fill_between(place * 1e3, values, color=colour, alpha=0.25, lw=0.0)
            axes.plot(place * 1e3, values, color=colour)
            axes.plot([bearing.position * 1e3 for bearing in shaft.bearings], [0.0, 0.0], "^", color=theme.INK, ms=4.0)
            axes.margins(x=0.02)
        row[0].set_title(shaft.name)
    for axes, label in zip(grid[-1], ("shear force [N]", "bending moment [N m]", "torsion [N m]"), strict=True):
        axes.set_xlabel(f"{label} over position [mm]")
    return figure


def _along(diagram: ShaftDiagram) -> tuple[Floats, Floats, Floats, Floats]:
    """Return position [m], shear [N], bending [N m] (both planes together) and torsion [N m] at many places.

    Each component runs straight between loads, their square root does not: it is taken after the interpolation. Of
    several loads at one place only the first and the last value count, as what lies between depends on their order.
    """
    position = np.array(diagram.position)
    before, after = np.diff(position, prepend=-np.inf) > 0.0, np.diff(position, append=np.inf) > 0.0
    keep = np.flatnonzero(before | after)
    steps = np.linspace(0.0, len(keep) - 1.0, STEPS * (len(keep) - 1) + 1)

    def dense(values: Sequence[float]) -> Floats:
        result: Floats = np.interp(steps, np.arange(len(keep)), np.array(values)[keep])
        return result

    shear, bending = (np.hypot(dense(along_y), dense(along_z)) for along_y, along_z in (diagram.shear, diagram.bending))
    return dense(diagram.position), shear, bending, dense(diagram.torsion)
