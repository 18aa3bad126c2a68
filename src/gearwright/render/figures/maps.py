"""Figures of many speeds: waterfall of a line's force with its orders, and how strong each order is at each speed."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.motion import index_of
from gearwright.dynamics.vibration import RunUp
from gearwright.render.style import theme
from gearwright.render.style.compound import NIGHT, colour_bar, shades
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.units import RPM, written

DECADES = 3.0
"""Range of amplitudes that a waterfall tells apart, below the largest [decades]."""
CELLS = 160
"""Cells of a waterfall along its frequencies: a cell shows the largest amplitude in it."""
MOST_ORDERS = 6
"""Orders whose course is drawn, at most."""
NAME = 0.027
"""Height of a name over the height of the map [-]."""
QUIET = 0.02
"""Amplitude over the largest below which an order is not drawn [-]."""


@theme.drawn
def waterfall_figure(run_up: RunUp, line: str, *, speed: float, shaft: str) -> Figure:
    """Return the waterfall of a line's force over speed, and below it the amplitudes of its strongest orders.

    Args:
        run_up: From `run_up`.
        line: One of its lines.
        speed: Operating speed of the shaft [rad/s].
        shaft: Named at the speed axis.
    """
    index_of(line, run_up.lines, "line")
    figure = theme.sheet(WIDTH, 150.0)
    bar, above, below = figure.grid(3, 1, heights=(0.03, 1.6, 1.0))[:, 0]
    above.x.numbers = False
    rpm = run_up.factor * speed / RPM
    _draw_map(bar, above, run_up, line=line, rpm=rpm)
    _draw_tracks(below, run_up, line, rpm)
    for axes in (above, below):
        axes.axvline(speed / RPM, color=theme.ORANGE, lw=0.9)
    above.annotate(
        "operating", (speed / RPM, 1.0), (2, -2), frames=("data", "axes"), fontsize=6.5, va="top", color=theme.ORANGE
    )
    below.set_xlabel(f"speed of {shaft} [rpm]")
    return figure


def _draw_map(bar: Axes, axes: Axes, run_up: RunUp, *, line: str, rpm: Floats) -> None:
    frequency, amplitude = _cells(run_up, line)
    largest = float(np.max(amplitude))
    level = np.log10(np.maximum(amplitude / largest, 10.0**-DECADES))
    half = 0.5 * (rpm[1] - rpm[0]), 0.5e-3 * (frequency[1] - frequency[0])
    box = (rpm[0] - half[0], frequency[0] / 1e3 - half[1], rpm[-1] + half[0], frequency[-1] / 1e3 + half[1])
    axes.picture(box, shades(level.T / DECADES + 1.0, NIGHT))
    powers = np.arange(-DECADES, 0.5)
    colour_bar(bar, (-DECADES, 0.0), NIGHT, upright=False)
    bar.set_xticks(powers, [f"{written(largest * 10.0**power, 3)} N" for power in powers], fontsize=6.5)
    axes.set(ylabel="frequency [kHz]", ylim=(0.0, frequency[-1] / 1e3), xlim=(rpm[0], rpm[-1]))
    bar.set_title(f"Waterfall of the force in {line}, amplitude")
    axes.x.grid = axes.y.grid = False
    _draw_orders(axes, run_up, rpm)


def _draw_orders(axes: Axes, run_up: RunUp, rpm: Floats) -> None:
    """Name every order where it leaves the map; those of machines, which no line makes, are drawn as well."""
    reach, top = float(run_up.factor[-1]), 1e3 * axes.get_ylim()[1]
    tones = zip(run_up.orders, run_up.order_frequency.tolist(), strict=True)
    rows = [(end * reach, name.short, theme.MUTED) for name, end in tones]
    rows += [(order.rate / (2.0 * np.pi) * reach, order.name, theme.ORANGE) for order in run_up.machine_orders]
    named: list[float] = []
    for end, word, colour in rows:
        if colour != theme.MUTED:
            axes.plot(rpm, end / 1e3 * rpm / rpm[-1], color=colour, lw=0.4, ls="--")
        if 0.0 < end < top and all(abs(end - other) > NAME * top for other in named):
            named.append(end)
            axes.annotate(word, (rpm[-1], end / 1e3), (3, 0), fontsize=6.0, va="center",
                          color=colour)  # fmt: skip
    axes.plot([], [], color=theme.ORANGE, lw=0.4, ls="--", label="machines, sidebands, planets that pass")
    axes.legend("upper left", size=6.5)


def _cells(run_up: RunUp, line: str) -> tuple[Floats, Floats]:
    """Return frequencies [Hz] and the largest amplitudes around each, up to the highest that shows [N]."""
    amplitude = run_up.amplitude[:, run_up.lines.index(line)]
    loud = np.flatnonzero(np.max(amplitude, axis=0) > 10.0**-DECADES * np.max(amplitude))
    end = min(len(run_up.frequency), int(1.05 * loud[-1]) + 2)
    edges = np.unique(np.linspace(0, end, CELLS + 1).astype(int))
    largest = np.maximum.reduceat(amplitude[:, :end], edges[:-1], axis=1)
    return 0.5 * (run_up.frequency[edges[:-1]] + run_up.frequency[np.minimum(edges[1:], end) - 1]), largest


def _draw_tracks(axes: Axes, run_up: RunUp, line: str, rpm: Floats) -> None:
    number = run_up.lines.index(line)
    tracks = run_up.order_amplitude[:, number]
    peaks = np.max(tracks, axis=0)
    strongest = [place for place in np.argsort(-peaks)[:MOST_ORDERS] if peaks[place] > QUIET * np.max(peaks)]
    for place in sorted(strongest):
        axes.plot(rpm, tracks[:, place], label=str(run_up.orders[place]))
    axes.plot(rpm, run_up.swing[:, number], color=theme.INK, lw=1.4, label="all, rms")
    axes.set(ylabel="amplitude [N]", title="Orders")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(rpm[0], rpm[-1])
    axes.legend("right")
