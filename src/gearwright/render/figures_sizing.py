"""Figures of a Sizing: where the mass is, and how much margin every check has."""

from __future__ import annotations

import math

from matplotlib.figure import Figure

from gearwright.render import theme
from gearwright.render.views import NOT_IN_THE_MASS, margins, mass_parts
from gearwright.sizing.result import Sizing

_GROUP_COLOURS = {"gears": theme.BLUE, "carriers": theme.AMBER, "shafts": theme.GREEN}
_ROW = 5.2
"""Height of one bar [mm]."""
_FRAME = 22.0
"""Height of title and axis [mm]."""
WIDTH = 180.0
"""Of a figure on an A4 page [mm]."""
_CHECK_COLOURS = {"tooth root bending": theme.BLUE, "flank contact": theme.SKY, "shaft, Tresca": theme.GREEN}
LARGEST_MARGIN = 4.0
"""Margin at which a bar is cut [-]; its number says how large it is."""


@theme.styled
def mass_figure(sizing: Sizing) -> Figure:
    """Return the mass of every part, heaviest first, in its group's colour.

    Args:
        sizing: As sized.
    """
    parts = mass_parts(sizing)
    figure = theme.sheet(WIDTH, _FRAME + 6.0 + _ROW * len(parts))
    axes = figure.add_subplot()
    axes.barh([_several(part.part, part.count) for part in parts], [part.total for part in parts],
              color=[_GROUP_COLOURS[part.group] for part in parts], height=0.72)  # fmt: skip
    for place, part in enumerate(parts):
        axes.annotate(f"{part.total:.2f} kg  {part.share:.0%}", (part.total, place), (3, 0),
                      textcoords="offset points", va="center", fontsize=7.5)  # fmt: skip
    totals = {"gears": sizing.gear_mass, "carriers": sizing.carrier_mass, "shafts": sizing.shaft_mass}
    for group, total in totals.items():
        if total:
            axes.barh([0], [0.0], color=_GROUP_COLOURS[group], label=f"{group}  {total:.2f} kg")
    axes.legend(loc="lower right")
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(part.total for part in parts) * 1.18)
    axes.set_xlabel(f"mass [kg]. {NOT_IN_THE_MASS}")
    axes.set_title(f"Mass {sizing.mass:.2f} kg, {sizing.power_density / 1e3:.1f} kW/kg")
    theme.only_grid(axes, "x")
    return figure


def _several(part: str, count: int) -> str:
    return f"{count} × {part}" if count > 1 else part


@theme.styled
def margin_figure(sizing: Sizing) -> Figure:
    """Return the margin of every check, worst first.

    Args:
        sizing: As sized.
    """
    checks = margins(sizing)
    figure = theme.sheet(WIDTH, _FRAME + _ROW * len(checks))
    axes = figure.add_subplot()
    shown = [min(check.margin, LARGEST_MARGIN) for check in checks]
    axes.barh(range(len(checks)), shown, color=[_CHECK_COLOURS[check.check] for check in checks], height=0.72)
    for place, (check, length) in enumerate(zip(checks, shown, strict=True)):
        colour = theme.INK if check.holds else theme.ORANGE
        number = f"{check.margin:.3f}" if math.isfinite(check.margin) else "no load"
        axes.annotate(number if check.holds else f"{number}  too small", (length, place), (3, 0), fontsize=7.5,
                      textcoords="offset points", va="center", color=colour)  # fmt: skip
    axes.set_yticks(range(len(checks)), [f"{check.part}, {check.check}" for check in checks])
    axes.axvline(1.0, color=theme.ORANGE, lw=1.2)
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(shown) * 1.12)
    axes.set_xlabel("allowable over actual stress [-], the asked factor included; 1 is just enough")
    axes.set_title("Margins, worst first")
    theme.only_grid(axes, "x")
    return figure
