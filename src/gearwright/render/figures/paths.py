"""Figures of one motion: orbits of centres, phase portraits and the transmission error of meshes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearwright.dynamics.model import PIN
from gearwright.dynamics.motion import Samples, index_of
from gearwright.errors import DesignError, Problem
from gearwright.render.figures.motion import spectrum
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.figure import Figure

COLUMNS = 3
"""Panels side by side."""
STILL = 1e-4
"""Path over the largest one below which a centre counts as still [-]."""
_AXES = (("x", "y"), PIN, ("y", "z"))
"""Pairs of translations that make a path."""


def moving_centres(samples: Samples) -> list[tuple[str, str]]:
    """Return the pairs of translations whose paths can be drawn.

    Args:
        samples: Of a run.
    """
    labels = samples.labels
    names = {owner: name for name, owner in zip(labels.coordinates, labels.coordinate_owners, strict=True)}
    return [
        (name, names[owner._replace(what=second)])
        for first, second in _AXES
        for owner, name in names.items()
        if owner.what == first and owner._replace(what=second) in names
    ]


@theme.drawn
def orbit_figure(samples: Samples, centres: Sequence[tuple[str, str]] | None = None) -> Figure:
    """Return the paths of centres about their means; of a planetary set in the frame of its carrier.

    Args:
        samples: Every step of a stretch of time.
        centres: Pairs of translations; left out: all.

    Raises:
        DesignError: If nothing moves across.
    """
    pairs = moving_centres(samples) if centres is None else list(centres)
    if not pairs:
        message = "no centre moves across; take dynamics.fidelity translational, or supports"
        raise DesignError([Problem("dynamics.fidelity", message)])
    figure, grid = theme.tiles(len(pairs), min(COLUMNS, len(pairs)), frame=10.0, row=58.0)
    paths = [[1e6 * (samples.motion(name) - np.mean(samples.motion(name))) for name in pair] for pair in pairs]
    largest = float(np.max(np.abs(paths)))
    for axes, pair, (x, y) in zip(grid.flat, pairs, paths, strict=False):
        owners = [samples.labels.coordinate_owners[samples.labels.coordinates.index(name)] for name in pair]
        axes.set_title(str(owners[0].part or pair[0]))
        if max(np.max(np.abs(x)), np.max(np.abs(y))) < STILL * largest:
            axes.set_axis_off()
            axes.text(0.5, 0.5, f"stands still\n(below {STILL * largest:.1g} µm)", inside=True, ha="center")
            continue
        axes.plot(x, y, lw=0.5)
        xlabel, ylabel = (f"{owner.what or name} [µm]" for owner, name in zip(owners, pair, strict=True))
        axes.set(xlabel=xlabel, ylabel=ylabel)
        axes.set_aspect("data")
    return figure


@theme.drawn
def phase_figure(samples: Samples, lines: Sequence[str]) -> Figure:
    """Return phase portraits of meshes: rate of the deflection against the deflection.

    Args:
        samples: Every step of a stretch of time.
        lines: Meshes.
    """
    figure, grid = theme.tiles(len(lines), min(COLUMNS, len(lines)), frame=10.0, row=52.0)
    for axes, line in zip(grid.flat, lines, strict=False):
        deflection = samples.deflection(line)
        axes.plot(1e6 * deflection, 1e3 * np.gradient(deflection, samples.time), lw=0.5)
        axes.set(title=line, xlabel="deflection [µm]")
        if np.min(deflection) < 0.0:
            axes.axvline(0.0, color=theme.ORANGE, lw=0.9)
    for axes in grid[:, 0]:
        axes.set_ylabel("its rate [mm/s]")
    return figure


@theme.drawn
def transmission_error_figure(
    samples: Samples, lines: Sequence[str], *, mesh_frequency: float, cycles: float = 6.0
) -> Figure:
    """Return the dynamic transmission error of meshes along the line of action: over time, and its spectrum.

    Args:
        samples: Every step of a stretch of time.
        lines: Meshes.
        mesh_frequency: Of them [Hz].
        cycles: Mesh cycles that are shown, at the end [-].
    """
    for line in lines:
        index_of(line, samples.labels.lines, "line")
    figure = theme.sheet(WIDTH, 78.0)
    time_axes, spectrum_axes = figure.grid(1, 2)[0]
    shown = samples.time >= samples.time[-1] - cycles / mesh_frequency
    for line in lines:
        error = 1e6 * samples.deflection(line)
        time_axes.plot(1e3 * samples.time[shown], error[shown], label=line)
        frequency, amplitude = spectrum(samples.time, error)
        inner = (frequency > 0.0) & (frequency < 6.5 * mesh_frequency)
        spectrum_axes.plot(frequency[inner] / mesh_frequency, amplitude[inner], lw=0.9)
    spectrum_axes.set_yscale("log")
    time_axes.set(xlabel="time [ms]", ylabel="transmission error [µm]")
    time_axes.margins(x=0.0)
    time_axes.x.most = 4
    time_axes.set_title("Dynamic transmission error")
    spectrum_axes.set(xlabel="multiples of the mesh frequency", ylabel="amplitude [µm]", xlim=(0.0, 6.5))
    spectrum_axes.set_ylim(bottom=1e-4 * spectrum_axes.get_ylim()[1])
    spectrum_axes.set_title("Spectrum")
    figure.shared_key = min(4, len(lines))
    return figure
