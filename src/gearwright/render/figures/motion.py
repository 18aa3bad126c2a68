"""Figures of a Trace and of Modes: forces against time, spectra, orbits, mode shapes on the drawn train."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    SIDES,
    DesignError,
    Floats,
    Kind,
    Problem,
    Role,
    by_name,
    carrier_part,
    gear_part,
    place_of_largest,
    verb,
)
from gearwright.dynamics import Labels, Modes, Trace
from gearwright.dynamics.model import PIN, Owner, System
from gearwright.dynamics.motion import Samples, index_of
from gearwright.particulars import Particulars
from gearwright.render import skeleton as glyphs, style as theme
from gearwright.render.schematic import draw_train, member_side
from gearwright.render.skeleton import Layout, lay_out
from gearwright.render.style import WIDTH
from gearwright.render.vector.figure import Axes, Figure, circle
from gearwright.render.vector.svg import band
from gearwright.sizing import Sizing
from gearwright.spec import GROUND
from gearwright.train import attachments

# ----------------------------------------------------------------------------------------------------------------------
# Figures of a Trace and of Modes: forces and torques against time, spectra with mesh orders, mode shapes.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Figures of one motion: orbits of centres, phase portraits and the transmission error of meshes.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Mode shapes on the drawn train: who swings with whom on the skeleton, and each planetary set from the front.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_DOT = 190.0
"""Area of a dot that holds all of a mode's kinetic energy [pt²]."""
SHOWN = 0.5
"""Largest displacement from the front, over the radius of a planet [-]."""
STILL_PART = 0.01
"""Displacement on paper over the radius of a planet below which a body is drawn as standing still [-]."""
QUIET = 1e-3
"""Share of the kinetic energy below which a body counts as still [-]."""


@theme.drawn
def drawn_modes_figure(facts: Particulars, system: System, modes: Modes, *, numbers: Sequence[int]) -> Figure:
    """Return some modes on the skeleton of the train and, beside it, on its planetary sets from the front.

    Args:
        facts: Of a sizing.
        system: Assembled from it.
        modes: Of that.
        numbers: Modes, counted from 1 as the table of modes does.
    """
    sizing = facts.sizing
    sets = list(sizing.design.planetaries)
    layout = lay_out(sizing.train, sizing.gears, {machine.name: machine.kind for machine in sizing.machines})
    figure = theme.sheet(WIDTH, 12.0 + 50.0 * len(numbers))
    grid = figure.grid(len(numbers), 1 + len(sets), widths=[2.2, *[1.0] * len(sets)])
    for row, number in zip(grid, numbers, strict=True):
        motion = _Motion(system, modes, number - 1)
        scale = _scale(facts, motion)
        _draw_skeleton(row[0], sizing, layout, motion)
        row[0].set_title(f"{number}:  {modes.frequency[number - 1]:.4g} Hz")
        for axes, name in zip(row[1:], sets, strict=True):
            _draw_front(axes, facts, name, motion=motion, scale=scale)
            axes.set_title(name, fontsize=7.5, weight="normal")
    figure.caption = "dots: kinetic energy of rotation; blue and orange: the two senses; sets: common scale"
    return figure


@dataclass(frozen=True)
class _Motion:
    """One mode shape, by name."""

    system: System
    modes: Modes
    place: int

    def of(self, name: str) -> float:
        """Return the displacement of a coordinate, zero where there is none."""
        names = self.system.labels.coordinates
        return float(self.modes.shapes[names.index(name), self.place]) if name in names else 0.0

    def share(self, name: str) -> float:
        """Return a coordinate's share of the kinetic energy [-]."""
        names = self.system.labels.coordinates
        mass = self.system.arrays.mass[names.index(name)] if name in names else 0.0
        return float(mass * self.of(name) ** 2)


def _draw_skeleton(axes: Axes, sizing: Sizing, layout: Layout, motion: _Motion) -> None:
    """Draw a dot on every body that turns: area by kinetic energy, colour by sense."""
    axes.set_axis_off()
    axes.set_aspect("box")
    draw_train(axes, sizing.train, layout, kinds={machine.name: machine.kind for machine in sizing.machines})
    for name, x, y in _spots(sizing, layout):
        share = motion.share(name)
        if share > QUIET:
            colour = theme.BLUE if motion.of(name) > 0.0 else theme.ORANGE
            axes.scatter([x], [y], s=max(LARGEST_DOT * share, 5.0), color=colour, alpha=0.8, lw=0.0, zorder=9)


def _spots(sizing: Sizing, layout: Layout) -> Iterator[tuple[str, float, float]]:
    """Yield body, x and y of everything that turns [mm]; of planets the first above and the second below the axis."""
    for machine in sizing.machines:
        yield machine.name, layout.places[machine.name].x, layout.heights[machine.shaft]
    for stage, planetary in sizing.design.planetaries.items():
        x, radii = layout.places[stage].x, _radii(sizing, stage)
        shaft = next(member for member in (planetary.sun, planetary.carrier, planetary.ring) if member != GROUND)
        y, centre = layout.heights[shaft], (radii[Role.SUN] + radii[Role.PLANET]) * layout.scale
        yield str(gear_part(stage, Role.SUN)), x, y
        yield str(gear_part(stage, Role.PLANET, number=1)), x, y + centre
        yield str(gear_part(stage, Role.PLANET, number=2)), x, y - centre
        yield str(carrier_part(stage)), x + _arm(sizing, layout, stage), y + 0.5 * centre
        yield str(gear_part(stage, Role.RING)), x, y + radii[Role.RING] * layout.scale
    for gear in sizing.gears:
        for shaft in gear.shafts if gear.role in SIDES else ():
            yield str(gear.body(shaft)), layout.places[gear.stage].x, layout.heights[shaft]


def _arm(sizing: Sizing, layout: Layout, stage: str) -> float:
    """Return where the carrier's arm stands beside its planets [mm]."""
    width = max(layout.outlines[sizing.train.gear_of(stage, Role.SUN).name].width * layout.scale, glyphs.LEAST_WIDTH)
    seats = [seat for seat in attachments(sizing.train) if seat.stage == stage and seat.member is Kind.CARRIER]
    side = member_side(seats[0], layout) if seats and seats[0].shaft != GROUND else 1.0
    return side * (0.5 * width + 2.5)


def _radii(sizing: Sizing, stage: str) -> Mapping[Role, float]:
    return {gear.role: 0.5 * gear.pitch_diameter for gear in sizing.gears if gear.stage == stage}


def _scale(facts: Particulars, motion: _Motion) -> float:
    """Return paper over motion for all planetary sets of a mode; zero if they stand still."""
    sizing = facts.sizing
    sets = [(_radii(sizing, stage), stage) for stage in sizing.design.planetaries]
    largest = max((disc.reach for radii, stage in sets for disc in _discs(facts, stage, radii, motion)), default=0.0)
    labels = motion.system.labels
    owned = zip(labels.coordinates, labels.coordinate_owners, strict=True)
    energy = sum(motion.share(name) for name, owner in owned if _stage(owner) in sizing.design.planetaries)
    return SHOWN * min(radii[Role.PLANET] for radii, _ in sets) / largest if energy > QUIET else 0.0


def _stage(owner: Owner) -> str:
    """Return the stage that a coordinate belongs to; empty for what belongs to none."""
    return owner.part.name if owner.part is not None and owner.part.kind in (Kind.GEAR, Kind.CARRIER) else ""


class _Disc(NamedTuple):
    """A gear of a planetary set from the front, and how a mode moves it."""

    centre: tuple[float, float]
    """(x, y) at rest [m]."""
    shift: tuple[float, float]
    """Displacement of the centre in the mode's own scale."""
    radius: float
    """[m]"""
    turn: float
    """Rotation in the mode's own scale."""

    @property
    def reach(self) -> float:
        """Largest displacement, of the centre or the rim."""
        return max(math.hypot(*self.shift), self.radius * abs(self.turn))


def _draw_front(axes: Axes, facts: Particulars, stage: str, *, motion: _Motion, scale: float) -> None:
    """Draw a planetary set from the front, at rest in grey and displaced in colour."""
    axes.set_axis_off()
    axes.set_aspect("box")
    radii = _radii(facts.sizing, stage)
    for disc in _discs(facts, stage, radii, motion):
        moved = _Disc(
            (disc.centre[0] + scale * disc.shift[0], disc.centre[1] + scale * disc.shift[1]),
            (0.0, 0.0), disc.radius, scale * disc.turn,
        )  # fmt: skip
        still = scale * disc.reach < STILL_PART * radii[Role.PLANET]
        colour = theme.MUTED if still else theme.BLUE if disc.turn >= 0.0 else theme.ORANGE
        _draw_disc(axes, disc._replace(turn=0.0), theme.HAIR)
        _draw_disc(axes, moved, colour)
    reach = 1.25 * radii[Role.RING]
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach))


def _draw_disc(axes: Axes, disc: _Disc, colour: str) -> None:
    """Draw a circle with a spoke that points up when it is not turned."""
    (x, y), radius = disc.centre, disc.radius
    axes.shape(circle(disc.centre, 2.0 * radius, 2.0 * radius), cubic=True, ec=colour, lw=1.0)
    tip = (x - radius * math.sin(disc.turn), y + radius * math.cos(disc.turn))
    axes.plot([x, tip[0]], [y, tip[1]], color=colour, lw=1.0)


def _arm_of(sizing: Sizing, stage: str) -> float:
    """Return how far the planets stand from the middle [m]."""
    return next(carrier.radius for carrier in sizing.carriers if carrier.stage == stage)


def _discs(facts: Particulars, stage: str, radii: Mapping[Role, float], motion: _Motion) -> Iterator[_Disc]:
    for role in (Role.RING, Role.SUN):
        name = str(gear_part(stage, role))
        yield _Disc((0.0, 0.0), (motion.of(f"{name}.x"), motion.of(f"{name}.y")), radii[role], motion.of(name))
    arm, carrier = _arm_of(facts.sizing, stage), motion.of(str(carrier_part(stage)))
    for k, angle in enumerate(facts.pins[stage], start=1):
        planet, cosine, sine = gear_part(stage, Role.PLANET, number=k), math.cos(angle), math.sin(angle)
        # Rotating bearings only: the planet's centre goes where its pin goes.
        along = motion.of(f"{planet}.tangential") or arm * carrier
        out = motion.of(f"{planet}.radial")
        shift = (out * cosine - along * sine, out * sine + along * cosine)
        yield _Disc((arm * cosine, arm * sine), shift, radii[Role.PLANET], motion.of(str(planet)))
