"""Figure of a dynamic window: speeds, shaft torques, mesh forces and pitch against time, and its end at every step."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics import Trace
from gearwright.dynamics.motion import Samples
from gearwright.mission.windows import DynamicWindow
from gearwright.render.figures.motion import families
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.units import shown

HEIGHT = 150.0
"""[mm]"""


@theme.drawn
def window_figure(window: DynamicWindow) -> Figure:
    """Return what a window did.

    Args:
        window: As flown.
    """
    trace = window.trace
    figure = theme.sheet(WIDTH, HEIGHT)
    grid = figure.grid(3, 2)
    _speeds(grid[0, 0], trace)
    _pitches(grid[0, 1], window)
    _bands(grid[1, 0], trace, "rad")
    _bands(grid[1, 1], trace, "m")
    _close(grid[2, 0], trace, "rad")
    _close(grid[2, 1], trace, "m")
    for axes in grid[:2].flat:
        axes.set_xlabel("time [s]")
        axes.margins(x=0.0)
        if window.rules.event != "none":
            axes.axvline(window.rules.event_at, color=theme.MUTED, lw=0.7, ls=":")
    return figure


def _speeds(axes: Axes, trace: Trace) -> None:
    for name, speed in _drive_histories(trace.samples, "speed").items():
        label = f"{name}, {shown(float(speed[0]), 'speed'):.0f} rpm"
        axes.plot(trace.samples.time, 100.0 * (speed / speed[0] - 1.0), label=label, lw=0.9)
    axes.set(title="Speeds over those at the start", ylabel="[%]")
    axes.legend("best", size=6.5)


def _pitches(axes: Axes, window: DynamicWindow) -> None:
    samples = window.trace.samples
    for pitch in _drive_histories(samples, "pitch").values():
        axes.plot(samples.time, np.degrees(pitch), color=theme.GREEN, label="pitch")
    axes.set(title="Pitch and torque of the propeller", ylabel="pitch [°]")
    other = axes.twinx()
    for name in _drive_histories(samples, "pitch"):
        torque = samples.drive(f"{name} torque")
        sense = np.sign(torque[0]) or 1.0  # what a stream drives is negative
        other.plot(samples.time, sense * torque / 1e3, color=theme.ORANGE, lw=0.9, label="torque")
    other.set_ylabel("torque [kN m]")
    axes.legend("best", size=6.5)


def _bands(axes: Axes, trace: Trace, unit: str) -> None:
    """Draw means with bands from least to greatest of every time bin."""
    edges = trace.force.edges
    middle = 0.5 * (edges[1:] + edges[:-1])
    for place, (family, names) in enumerate(families(trace.labels, unit).items()):
        colour = theme.CYCLE[place % len(theme.CYCLE)]
        bins = [trace.force.of(name) for name in names]
        lowest, highest = np.min([bin["minimum"] for bin in bins], 0), np.max([bin["maximum"] for bin in bins], 0)
        axes.fill_between(middle, lowest / 1e3, highest / 1e3, color=colour, alpha=0.25, lw=0.0)
        axes.plot(middle, bins[0]["mean"] / 1e3, color=colour, lw=0.9, label=family)
    axes.set(title="Shaft torques" if unit == "rad" else "Mesh forces", ylabel="[kN m]" if unit == "rad" else "[kN]")
    axes.legend("best", size=6.0, columns=2)


def _close(axes: Axes, trace: Trace, unit: str) -> None:
    """Draw the end of the window, every step: the first line of each family, torques over their mean."""
    samples = trace.windows[-1]
    for place, names in enumerate(families(trace.labels, unit).values()):
        force = samples.force(names[0])
        values = force - np.mean(force) if unit == "rad" else force / 1e3
        axes.plot(1e3 * (samples.time - samples.time[0]), values, color=theme.CYCLE[place % len(theme.CYCLE)], lw=0.8)
    axes.set_title("Its end, over the mean" if unit == "rad" else "Its end, one mesh of each row")
    axes.set_ylabel("[N m]" if unit == "rad" else "[kN]")
    axes.set_xlabel("time [ms]")
    axes.margins(x=0.0)


def _drive_histories(samples: Samples, what: str) -> dict[str, Floats]:
    """Return one kind of history of all drives that have it, by drive, positive at the start.

    Args:
        samples: Of a run with drives.
        what: Such as ``"speed"``.
    """
    owners = enumerate(samples.labels.drive_owners)
    return {
        str(owner.part): samples.drives[:, place] * (np.sign(samples.drives[0, place]) or 1.0)
        for place, owner in owners
        if owner.what == what
    }
