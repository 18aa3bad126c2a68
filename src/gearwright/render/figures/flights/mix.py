"""Figure of a life of several missions: Miner's sum of every part that matters, and which mission eats it."""

from __future__ import annotations

from itertools import cycle

from gearwright.mission import FlownMix
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.tables.mix import MOST_ROWS
from gearwright.render.vector.figure import Figure

LEAST = 1e-6
"""Miner's sum after the whole life below which a part is not drawn [-]."""


@theme.drawn
def eaten_figure(flown: FlownMix) -> Figure:
    """Return the parts of the damage of every part by mission, the part that governs first on top.

    Args:
        flown: As flown.
    """
    known = [part for part in flown.life.parts if LEAST < part.damage * flown.mix.flights < float("inf")][:MOST_ROWS]
    figure = theme.sheet(WIDTH, 30.0 + 6.0 * max(len(known), 1))
    axes = figure.panel()
    left = [0.0] * len(known)
    for colour, name in zip(cycle(theme.CYCLE), flown.flights, strict=False):
        sums = [flown.damage_by_mission(part) for part in known]
        widths = [100.0 * damage[name] / sum(damage.values()) for damage in sums]
        axes.barh(range(len(known)), widths, left=left, height=0.72, color=colour, label=name)
        left = [start + width for start, width in zip(left, widths, strict=True)]
    for place, part in enumerate(known):
        axes.annotate(f"{part.damage * flown.mix.flights:.3g}", (100.0, place), (4, 0), fontsize=7.5, va="center")
    axes.set_yticks(range(len(known)), [f"{part.name}, {part.mode}" for part in known])
    axes.set(xlim=(0.0, 116.0), xlabel="part of the damage [%]; behind the bars Miner's sum of the whole life")
    axes.invert_yaxis()
    axes.legend("above", columns=4)
    axes.only_grid("x")
    return figure
