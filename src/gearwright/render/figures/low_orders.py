"""The low end of a Campbell diagram: torsional frequencies of shafts and machines, and what turns or passes there."""

from __future__ import annotations

from itertools import cycle

import numpy as np

from gearwright.dynamics import System
from gearwright.dynamics.vibration import SEPARATION, Campbell, SpeedCase, order_name
from gearwright.render.style import theme
from gearwright.render.style.labels import spread
from gearwright.render.vector.axes import Axes
from gearwright.sizing import Sizing
from gearwright.units import RPM

LOW = 300.0
"""Frequency below which a diagram shows what the teeth's would hide [Hz]."""
HEIGHT = 0.04
"""Of a line of names over the panel's height [-]."""
TOP_GAP = 0.045
"""Between slanted names over the panel's width [-]."""


def has_low_modes(speeds: SpeedCase) -> bool:
    """Tell whether a natural frequency lies below `LOW`.

    Args:
        speeds: From `critical_speeds`.
    """
    return bool(np.any(speeds.campbell.frequency < LOW))


def mode_names(campbell: Campbell, system: System | None = None) -> list[str]:
    """Return what a pointer is told of each natural frequency.

    Args:
        campbell: From `campbell`.
        system: It is of; with it modes are counted as in the table of modes, rigid ones first.
    """
    rigid = 0 if system is None else len(system.labels.coordinates) - campbell.frequency.shape[1]
    at = int(np.argmin(np.abs(campbell.factor - 1.0)))
    return [f"mode {rigid + k + 1}, {value:.4g} Hz" for k, value in enumerate(campbell.frequency[at].tolist())]


def draw_low(axes: Axes, sizing: Sizing, speeds: SpeedCase, *, operating: tuple[str, float]) -> None:
    """Draw natural frequencies below `LOW`, every order that passes there by its name, and where it excites.

    Args:
        axes: Where it is drawn.
        sizing: As sized.
        speeds: From `critical_speeds`.
        operating: Shaft whose speed stands for all, and that speed [rpm].
    """
    shaft, speed = operating
    rpm = speeds.campbell.factor * speed
    axes.axvspan(*SEPARATION.around(speed), color=theme.STEEL, lw=0.0, zorder=0)
    axes.axvline(speed, color=theme.INK, lw=0.9)
    axes.plot(rpm, speeds.campbell.frequency, color=theme.INK, lw=1.1, names=mode_names(speeds.campbell, speeds.system))
    axes.set(xlim=(0.0, rpm[-1]), ylim=(0.0, LOW), ylabel="frequency [Hz]", xlabel=f"speed of {shaft} [rpm]")
    axes.set_title(f"Below {LOW:g} Hz; shaded: the operating speed within 10 % of the critical one")
    _draw_rays(axes, _named(sizing, speeds, rpm[-1] / speed))
    for critical in (*speeds.critical, *speeds.assumed):
        if critical.excited and critical.frequency < LOW:
            face = theme.PAPER if critical.why else theme.ORANGE
            axes.plot(critical.speed / RPM, critical.frequency, "o", ms=4.0, mfc=face, mec=theme.ORANGE, zorder=3)


def _named(sizing: Sizing, speeds: SpeedCase, reach: float) -> dict[float, str]:
    """Return the frequency of each order at the end of the speeds [Hz], and its name; equal ones together."""
    names = dict[float, list[str]]()
    for order in speeds.campbell.orders:
        if order.frequency * speeds.campbell.factor[0] < LOW:
            word = order_name(sizing, order.tone).short if order.excitation is None else order.excitation.name
            names.setdefault(round(order.frequency * reach, 6), []).append(word)
    return {
        top: words[0] if len(words) == 1 else f"{words[0]} and {len(words) - 1} more" for top, words in names.items()
    }


def _draw_rays(axes: Axes, names: dict[float, str]) -> None:
    """Draw the orders, each frequency once; named on the right, or slanted on top where they leave there."""
    end = axes.get_xlim()[1]
    rows = list(zip(sorted(names), cycle(theme.CYCLE), strict=False))
    right = [top for top, _ in rows if top <= LOW]
    places = dict(zip(right, spread(right, HEIGHT * LOW), strict=True))
    free = end
    for top, colour in rows:
        axes.plot([0.0, end], [0.0, top], color=colour, lw=0.8, zorder=1, names=(names[top],))
        if top <= LOW:
            axes.annotate(names[top], (end * 1.02, places[top]), leader=(end, top), fontsize=6.0,
                          color=colour, va="center")  # fmt: skip
        elif (leaves := end * LOW / top) <= free:
            axes.annotate(names[top], (leaves, LOW), (1, 2),  fontsize=6.0,
                                    color=colour, rotation=30.0, va="bottom", )  # fmt: skip
            free = leaves - TOP_GAP * end
