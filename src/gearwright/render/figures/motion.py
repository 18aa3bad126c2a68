"""Figures of a Trace and of Modes: forces and torques against time, spectra with mesh orders, mode shapes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics import Labels, Modes, Samples, Trace
from gearwright.dynamics.model import Owner
from gearwright.errors import DesignError, Problem, by_name
from gearwright.ranking import place_of_largest
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.render.vector.thinning import band
from gearwright.sizing import Sizing
from gearwright.verbs import verb

ORDERS = 3
"""Multiples of each mesh frequency that a spectrum marks."""
FLOOR = 1e-5
"""Smallest amplitude that a spectrum shows, over the largest [-]."""
DENSE = 2000
"""Steps of a run above which a family of lines is the band from its least to its greatest."""
CLOSE_STEPS = 600
"""Steps at the end of a window that are shown closely."""
MOST_MODES = 9
"""Mode shapes in one figure."""
_KINDS = {"m": ("Mesh and support forces", "force [N]"), "rad": ("Shaft torques", "torque [N m]")}


@verb
def mesh_frequencies(sizing: Sizing, case: str) -> dict[str, float]:
    """Return the frequency with which teeth meet in every mesh row [Hz].

    Args:
        sizing: As sized.
        case: Load case.

    Source: f = z_a |n_a − n_c|, kinematics.
    """
    speeds = by_name(case, sizing.flows, "case").speeds
    return {
        mesh.name: sizing.teeth[mesh.gears[0]] * abs(speeds[mesh.nodes[0]] - speeds[mesh.nodes[2]]) / (2.0 * np.pi)
        for mesh in sizing.train.meshes
    }


@theme.drawn
def time_figure(trace: Trace) -> Figure:
    """Return mesh forces and shaft torques against time: the whole run, and beside it the end of the last window.

    Args:
        trace: As simulated.
    """
    units = [unit for unit in _KINDS if unit in trace.labels.line_units]
    stretches = [trace.samples, *trace.windows[-1:]]
    figure = theme.sheet(WIDTH, 10.0 + 62.0 * len(units))
    grid = figure.grid(len(units), len(stretches), share_y="row")
    for row, unit in zip(grid, units, strict=True):
        for axes, samples in zip(row, stretches, strict=True):
            _draw_lines(axes, samples, unit, len(samples.time) if samples is trace.samples else CLOSE_STEPS)
        row[0].set(ylabel=_KINDS[unit][1], title=_KINDS[unit][0])
        row[-1].legend("right")
    if trace.windows:
        grid[0, 1].set_title("Its end, every step")
    for axes in grid[-1]:
        axes.set_xlabel("time [ms]")
    return figure


def families(labels: Labels, unit: str) -> dict[str, list[str]]:
    """Return the lines of one unit by what they are, the planets of a set together.

    Args:
        labels: Of a trace or its samples.
        unit: ``"m"`` for forces, ``"rad"`` for torques.
    """
    by_family: dict[str, list[str]] = {}
    for name, line_unit, owner in zip(labels.lines, labels.line_units, labels.line_owners, strict=True):
        if line_unit == unit:
            by_family.setdefault(_family(name, owner), []).append(name)
    return by_family


def _family(name: str, owner: Owner) -> str:
    """Return what a line is called together with those of the other planets."""
    if owner.part is None or owner.part.number is None:
        return name
    whole = owner.part._replace(number=None)
    return f"{whole}.{owner.what}" if owner.what else str(whole)


def _draw_lines(axes: Axes, samples: Samples, unit: str, last: int) -> None:
    for place, (family, names) in enumerate(families(samples.labels, unit).items()):
        colour = theme.CYCLE[place % len(theme.CYCLE)]
        forces = np.array([samples.force(name)[-last:] for name in names]).T
        label = family if len(names) == 1 else f"{family} ({len(names)})"
        if len(forces) > DENSE:
            time, low, high = band(samples.time[-last:], forces)
            axes.fill_between(time * 1e3, low, high, color=colour, alpha=0.75, lw=0.4, label=label)
            continue
        axes.plot(samples.time[-last:] * 1e3, forces, color=colour, lw=0.8, label=label,
                  alpha=1.0 if len(names) == 1 else 0.6)  # fmt: skip
    axes.margins(x=0.0)
    axes.x.most = 5


@theme.drawn
def spectrum_figure(trace: Trace, mesh_frequency: Mapping[str, float]) -> Figure:
    """Return the amplitude spectrum of the line forces (of the first planet of a set), and the mesh frequencies.

    Args:
        trace: As simulated.
        mesh_frequency: Mesh row -> [Hz], as `mesh_frequencies` gives it.

    Raises:
        DesignError: If no stretch of the run is kept at every step; thinned samples would show false frequencies.
    """
    units = [unit for unit in _KINDS if unit in trace.labels.line_units]
    samples = every_step(trace)
    if samples is None:
        raise DesignError([Problem("outputs.windows", "none is kept; keep a window, so that every step is known")])
    figure = theme.sheet(WIDTH, 10.0 + 62.0 * len(units))
    grid = figure.grid(len(units), 1, share_x=True)[:, 0]
    for axes, unit in zip(grid, units, strict=True):
        _draw_spectra(axes, samples, unit)
        axes.set_ylabel(f"amplitude of {_KINDS[unit][1]}")
        _mark_orders(axes, trace.labels, mesh_frequency, named=axes is grid[0])
        axes.legend("right")
    grid[0].set_title("Spectrum; dotted: mesh frequency and its multiples")
    grid[-1].set_xlabel("frequency [kHz]")
    return figure


def every_step(trace: Trace) -> Samples | None:
    """Return the last stretch of a run of which every step is kept, if there is one.

    Args:
        trace: As simulated.
    """
    if trace.windows:
        return trace.windows[-1]
    time = trace.samples.time
    return trace.samples if len(time) > 1 and time[1] - time[0] < 1.5 * trace.step else None


def spectrum(time: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Return frequency [Hz] and amplitude of evenly spaced values, without their mean.

    Args:
        time: [s], shape (instants,).
        values: Shape (instants,).

    Source: discrete Fourier transform with Hann's window, amplitudes corrected by the window's mean.
    """
    window = np.hanning(len(values))
    amplitude = 2.0 * np.abs(np.fft.rfft((values - np.mean(values)) * window)) / np.sum(window)
    return np.fft.rfftfreq(len(values), (time[-1] - time[0]) / (len(time) - 1)), amplitude


def _draw_spectra(axes: Axes, samples: Samples, unit: str) -> None:
    largest = 0.0
    for family, names in families(samples.labels, unit).items():
        frequency, amplitude = spectrum(samples.time, samples.force(names[0]))
        axes.set_yscale("log")
        axes.plot(frequency[1:] / 1e3, amplitude[1:], label=family, lw=0.8)
        largest = max(largest, float(np.max(amplitude[1:], initial=0.0)))
    if largest > 0.0:
        axes.set_ylim(largest * FLOOR, largest * 2.0)
    axes.margins(x=0.0)


def _mark_orders(axes: Axes, labels: Labels, mesh_frequency: Mapping[str, float], *, named: bool) -> None:
    """Mark each distinct mesh frequency and its multiples, named above the frame, if asked and with room."""
    end = min(axes.get_xlim()[1], 1.1e-3 * ORDERS * max(mesh_frequency.values(), default=np.inf))
    axes.set_xlim(0.0, end)
    parts = [owner.part._replace(number=None) for owner in labels.line_owners if owner.part is not None]
    named_rows = {str(part): part.name for part in parts}
    stages = {round(value, 6): named_rows.get(row, row) for row, value in reversed(list(mesh_frequency.items()))}
    marks = sorted(
        (order * value / 1e3, order, name) for value, name in stages.items() for order in range(1, ORDERS + 1)
    )
    free = -np.inf
    for frequency, order, name in marks:
        if frequency > end:
            continue
        axes.axvline(frequency, color=theme.MUTED, lw=0.7, ls=":", zorder=0)
        if frequency - free > 0.03 * end and named:
            word = name if order == 1 else f"{order} {name}"
            axes.annotate(word, (frequency, 1.0), (0, 3), frames=("data", "axes"), rotation=45.0,
                           fontsize=6.5, color=theme.MUTED)  # fmt: skip
            free = frequency


@theme.drawn
def mode_figure(modes: Modes) -> Figure:
    """Return shapes of the lowest elastic modes, one a frequency: each coordinate over the largest of its kind.

    Args:
        modes: As found.
    """
    elastic = list(_first_of_each(modes))[:MOST_MODES]
    columns, names = min(3, max(1, len(elastic))), modes.labels.coordinates
    figure, grid = theme.tiles(
        len(elastic), columns, frame=8.0, row=12.0 + 3.0 * len(names), share_x=True, share_y="all"
    )
    for axes, mode in zip(grid.flat, elastic, strict=False):
        _draw_shape(axes, modes, mode)
    grid[0, 0].set_yticks(range(len(names)), names)
    grid[0, 0].set_ylim(len(names) - 0.5, -0.5)
    return figure


def _first_of_each(modes: Modes) -> Iterator[int]:
    """Yield the first mode of every elastic frequency; those that share it look alike from another planet."""
    first = 0
    for frequency, count in modes.groups():
        if frequency > 0.0:
            yield first
        first += count


def _draw_shape(axes: Axes, modes: Modes, mode: int) -> None:
    shape, units = modes.shapes[:, mode], np.array(modes.labels.coordinate_units)
    for unit, colour in (("rad", theme.BLUE), ("m", theme.GREEN)):
        places = np.flatnonzero(units == unit)
        if len(places) and np.any(shape[places]):
            largest = shape[places[place_of_largest(np.abs(shape[places]))]]
            axes.barh(places, shape[places] / largest, color=colour, height=0.62)
    held = place_of_largest(modes.line_energy[:, mode])
    axes.set_title(f"{mode + 1}:  {modes.frequency[mode]:.4g} Hz", fontsize=8.5)
    share = f"{modes.line_energy[held, mode]:.0%} of the strain in {modes.labels.lines[held]}"
    axes.annotate(share, (0.0, 1.0), (0, 1), frames=("axes", "axes"),  fontsize=6.0,
                  color=theme.MUTED, va="bottom")  # fmt: skip
    axes.axvline(0.0, color=theme.MUTED, lw=0.6)
    axes.set_xlim(-1.1, 1.1)
    axes.y.size = 6.0
    axes.only_grid("x")
