"""Figures of a search: how the hypervolume of its front grew."""

from __future__ import annotations

from gearwright.optimum import Optimum
from gearwright.render.style import theme
from gearwright.render.vector.figure import Figure


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
