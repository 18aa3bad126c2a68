"""Figures of what shakes a train: Campbell diagram with its low end, frequency response, waterfall, orders."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle

import numpy as np
from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.base import RPM, Floats, largest_first, smallest_first, written
from gearwright.catalogue import load_factor_tables, load_factors
from gearwright.dynamics import System
from gearwright.dynamics.motion import index_of
from gearwright.dynamics.sharing import (
    Allocation,
    LoadSharing,
    PlanetCounts,
    PlanetSharing,
    SharingStudy,
    SupportSweep,
)
from gearwright.dynamics.vibration import (
    RESONANCE,
    SEPARATION,
    SWING,
    Campbell,
    CriticalSpeed,
    OrderLine,
    Response,
    RunUp,
    SpeedCase,
    order_name,
    turning_shaft,
)
from gearwright.render import style as theme
from gearwright.render.style import NIGHT, WIDTH, colour_bar, shades, spread, upright_ranges
from gearwright.render.terminal import Grid
from gearwright.render.vector.figure import Axes, Figure
from gearwright.sizing import Sizing

# ----------------------------------------------------------------------------------------------------------------------
# The low end of a Campbell diagram: torsional frequencies of shafts and machines, and what turns or passes there.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Figures of what shakes a train and how it answers: Campbell diagram with margins, frequency response.
# ----------------------------------------------------------------------------------------------------------------------


MOST_MARGINS = 12
"""Critical speeds whose margins are drawn."""
PLANE = 1e-6
"""Relative slope of a frequency by gyroscopic terms below which a mode counts as one that does not turn [-]."""
LARGEST_DOT = 70.0
"""Area of the dot of a dynamic force as large as the mean one [pt²]."""


@theme.drawn
def campbell_figure(sizing: Sizing, speeds: SpeedCase) -> Figure:
    """Return the Campbell diagram of one set of speeds, and the margins of the nearest excited critical speeds.

    Args:
        sizing: As sized.
        speeds: From `critical_speeds`.
    """
    excited = [critical for critical in (*speeds.critical, *speeds.assumed) if critical.excited and critical.criterion]
    near = smallest_first(excited, lambda critical: critical.over_limit)[:MOST_MARGINS]
    heights = [85.0, *([75.0] if has_low_modes(speeds) else []), 12.0 + 5.0 * max(len(near), 1)]
    figure = theme.sheet(WIDTH, sum(heights) + 8.0 + 8.0 * len(heights))
    diagram, *low, margins = figure.grid(len(heights), 1, heights=heights)[:, 0]
    _draw_campbell(diagram, sizing, speeds)
    for axes in low:
        draw_low(axes, sizing, speeds, operating=operating_speed(sizing, speeds))
    _draw_margins(margins, near)
    return figure


@theme.drawn
def diagram_figure(campbell: Campbell) -> Figure:
    """Return a Campbell diagram without its sizing: frequencies and orders against speed, crossings as dots.

    Args:
        campbell: From `campbell`.
    """
    figure = theme.sheet(WIDTH, 105.0)
    axes = figure.panel()
    end, top = campbell.factor[-1], 1.05 * float(np.max(campbell.frequency))
    whirl = np.max(campbell.whirl, axis=0) + np.min(campbell.whirl, axis=0)
    looks = (
        ("natural frequency", np.abs(whirl) <= PLANE, theme.MUTED, "-"),
        ("forward whirl, raised by gyroscopic terms", whirl > PLANE, theme.INK, "-"),
        ("backward whirl, lowered", whirl < -PLANE, theme.INK, "--"),
    )
    for name, chosen, colour, dashes in looks:
        if np.any(chosen):
            axes.plot(campbell.factor, campbell.frequency[:, chosen], color=colour, lw=0.8, ls=dashes)
            axes.plot([], [], color=colour, lw=0.8, ls=dashes, label=name)
    for colour, order in zip(cycle(theme.CYCLE), campbell.orders, strict=False):
        axes.plot([0.0, end], [0.0, order.frequency * end], color=colour, lw=0.9, label=str(order))
    crossings = campbell.crossings
    axes.scatter([at.factor for at in crossings], [at.frequency for at in crossings], s=9.0, color=theme.ORANGE, lw=0.0)
    axes.axvline(1.0, color=theme.INK, lw=0.9)
    axes.set(xlim=(0.0, end), ylim=(0.0, top), xlabel="speed over operating speed [-]", ylabel="frequency [Hz]")
    axes.legend("below", columns=3, size=6.5)
    return figure


@dataclass(frozen=True)
class _Frame:
    """What the diagram shows."""

    speed: float
    """Operating speed of the first machine that turns [rpm]."""
    top: float
    """Highest frequency [kHz]."""


def _draw_campbell(axes: Axes, sizing: Sizing, speed_case: SpeedCase) -> None:
    shaft, speed = operating_speed(sizing, speed_case)
    excited = [critical for critical in speed_case.critical if critical.excited]
    highest = max(
        (critical.frequency for critical in excited or speed_case.critical),
        default=float(np.max(speed_case.campbell.frequency)),
    )
    frame = _Frame(speed, 1.12e-3 * highest)
    speeds = speed_case.campbell.factor * frame.speed
    axes.axvspan(*RESONANCE.around(frame.speed), color=theme.STEEL, lw=0.0, zorder=0)
    axes.axvline(frame.speed, color=theme.INK, lw=0.9)
    axes.annotate("operating", (frame.speed, 1.0), (2, -2), frames=("data", "axes"), fontsize=6.5,
                   va="top")  # fmt: skip
    named = mode_names(speed_case.campbell, speed_case.system)
    axes.plot(speeds, speed_case.campbell.frequency / 1e3, color=theme.MUTED, lw=0.7, names=named)
    axes.plot([], [], color=theme.MUTED, lw=0.7, label="natural frequency")
    axes.set(xlim=(0.0, speeds[-1]), ylim=(0.0, frame.top), ylabel="frequency [kHz]")
    axes.set_xlabel(f"speed of {shaft} [rpm]")
    axes.set_title(f"Campbell diagram, case {speed_case.cases}")
    _draw_orders(axes, sizing, speed_case.campbell.orders, frame)
    for critical in (*speed_case.assumed, *speed_case.critical):
        if critical.excited and critical.frequency / 1e3 < frame.top:
            axes.scatter([critical.speed / RPM], [critical.frequency / 1e3], s=_area(critical), c=[_face(critical)],
                         edgecolors=theme.ORANGE, zorder=3, lw=0.8)  # fmt: skip
    axes.scatter(
        [], [], s=LARGEST_DOT, color=theme.ORANGE, lw=0.0, label="resonance; area: force amplitude over mean force"
    )
    axes.legend("below", columns=2, size=6.5)


def _draw_orders(axes: Axes, sizing: Sizing, orders: Sequence[OrderLine], frame: _Frame) -> None:
    """Draw the rays: mesh orders named, in the colour of their stage; shafts dotted."""
    stages, end, free = list(sizing.design.stages), axes.get_xlim()[1], 0.0
    for order in largest_first((order for order in orders if order.excitation is None), lambda order: order.frequency):
        name, top = order_name(sizing, order.tone), order.frequency / 1e3 * end / frame.speed
        if not name.stage:
            axes.plot([0.0, end], [0.0, top], color=theme.MUTED, lw=0.6, ls=":", zorder=1, names=(name.short,))
            continue
        colour = theme.CYCLE[stages.index(name.stage) % len(theme.CYCLE)]
        axes.plot([0.0, end], [0.0, top], color=colour, lw=0.9, zorder=1, names=(name.short,))
        leaves = end * min(1.0, frame.top / top)
        if leaves >= free or leaves == end:
            _name_ray(axes, name.short, (leaves, min(top, frame.top)), colour)
            free = leaves + 0.028 * end
    for order in (order for order in orders if order.excitation is not None):
        top = order.frequency / 1e3 * end / frame.speed
        axes.plot([0.0, end], [0.0, top], color=theme.MUTED, lw=0.4, ls="--", names=(str(order),))
    axes.plot([], [], color=theme.MUTED, lw=0.6, ls=":", label="shaft turning")
    axes.plot([], [], color=theme.MUTED, lw=0.4, ls="--", label="machines, sidebands, planets that pass")


def _name_ray(axes: Axes, word: str, at: tuple[float, float], colour: str) -> None:
    """Write a ray's name where it leaves the frame: on the right, or slanted on top."""
    right = at[0] == axes.get_xlim()[1]
    axes.annotate(word, at, (3, 0) if right else (1, 2),  fontsize=6.0, color=colour,
                  rotation=0.0 if right else 45.0, va="center" if right else "bottom",
                  )  # fmt: skip


def operating_speed(sizing: Sizing, speeds: SpeedCase) -> tuple[str, float]:
    """Return the shaft whose speed stands for all, and that speed [rpm].

    Args:
        sizing: As sized.
        speeds: From `critical_speeds`.
    """
    shaft = turning_shaft(sizing, speeds.first) or sizing.machines[0].shaft
    return shaft, abs(sizing.flows[speeds.first].speeds[shaft]) / RPM


def _area(critical: CriticalSpeed) -> float:
    """Return the area of the dot of a dynamic force [pt²]."""
    return max(2.0, LARGEST_DOT * min(critical.dynamic_force, 2.0))


def _face(critical: CriticalSpeed) -> str:
    """Return the colour inside a dot: hollow where the strength of the order is assumed."""
    return theme.PAPER if critical.why else theme.ORANGE


def _draw_margins(axes: Axes, near: Sequence[CriticalSpeed]) -> None:
    """Draw the separation margin of each critical speed, in per cent, the nearest on top."""
    axes.set_title("Excited critical speeds, the nearest to the operating speed by their limits")
    if not near:
        axes.set_axis_off()
        axes.text(0.0, 0.5, "No order excites a mode in this range of speeds.", inside=True, fontsize=7.5)
        return
    for criterion, look in ((RESONANCE, {"color": theme.STEEL}), (SEPARATION, {"color": theme.MUTED, "alpha": 0.25})):
        axes.axvspan(-100.0 * criterion.limit, 100.0 * criterion.limit, lw=0.0, zorder=0, **look)
    axes.axvline(0.0, color=theme.INK, lw=0.9)
    place = np.arange(len(near))
    margin = np.array([100.0 * critical.separation_margin for critical in near])
    axes.hlines(place, 0.0, margin, color=theme.MUTED, lw=0.7)
    area, face = [_area(critical) for critical in near], [_face(critical) for critical in near]
    axes.scatter(margin, place, s=area, c=face, edgecolors=theme.ORANGE, zorder=3, lw=0.8)
    names = [f"{critical.order}, mode {critical.mode} ({critical.frequency:.0f} Hz)" for critical in near]
    axes.set_yticks(place, names, fontsize=6.5)
    axes.set_ylim(len(near) - 0.4, -0.6)
    reach = 1.15 * max(float(np.max(np.abs(margin))), 100.0 * RESONANCE.limit)
    axes.set_xlim(-reach, reach)
    axes.set_xlabel(
        "separation margin: operating over critical speed, less 1 [%]\n"
        "shaded: main resonance range, ISO 6336-1; darker: 10 %, API 617\n"
        f"hollow: {100.0 * SWING:g} % of a torque or mesh force is assumed to swing"
    )
    axes.only_grid("x")


@theme.drawn
def response_figure(response: Response, lines: Sequence[str], *, title: str) -> Figure:
    """Return the amplitude and phase of mesh forces against frequency.

    Args:
        response: Of the train.
        lines: Whose forces are drawn.
        title: What excites.
    """
    figure = theme.sheet(WIDTH, 105.0)
    top, below = figure.grid(2, 1, share_x=True, heights=(3.0, 1.3))[:, 0]
    for line in lines:
        force = response.force(line)
        top.plot(response.frequency / 1e3, np.abs(force), label=line)
        below.plot(response.frequency / 1e3, np.degrees(np.angle(force)), lw=0.8)
    for axes in (top, below):
        axes.set_xscale("log")
    top.set_yscale("log")
    top.set(title=title, ylabel="force amplitude [N]")
    top.legend("right")
    below.set(ylabel="phase [°]", xlabel="frequency [kHz]", ylim=(-190.0, 190.0))
    below.set_yticks([-180.0, -90.0, 0.0, 90.0, 180.0])
    below.margins(x=0.0)
    return figure


# ----------------------------------------------------------------------------------------------------------------------
# Figures of many speeds: waterfall of a line's force with its orders, and how strong each order is at each speed.
# ----------------------------------------------------------------------------------------------------------------------


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
    _name_orders(axes, run_up, rpm)


def _name_orders(axes: Axes, run_up: RunUp, rpm: Floats) -> None:
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


# ----------------------------------------------------------------------------------------------------------------------
# Figures of load sharing: against time, against the support of a floating shaft, by error, by chance, as an orbit.
# ----------------------------------------------------------------------------------------------------------------------


MICROMETRE = 1e-6
ROW = 5.0
"""Height of one bar [mm of paper]."""
PERCENTILES = (50.0, 95.0, 99.0)
LEAST_SPAN = 0.01
"""Of coefficients b, below which a panel would show rounding alone [-]."""
POINTS = 1200
"""Points of a curve: closer than a printer can tell apart."""


@theme.drawn
def sharing_figure(sharings: Mapping[str, LoadSharing]) -> Figure:
    """Return sharing coefficients against time, one panel each: over a tooth cycle, and pale behind it every instant.

    Args:
        sharings: Title -> sharing; the counterpart of the paper's figures 3, 4, 6 and 8 to 18.
    """
    figure = theme.sheet(WIDTH, 12.0 + 42.0 * len(sharings))
    panels = figure.grid(len(sharings), 1, share_x=True)[:, 0]
    for axes, (title, sharing) in zip(panels, sharings.items(), strict=True):
        _draw_sharing(axes, sharing)
        axes.set(title=title, ylabel="sharing coefficient b [-]")
    panels[0].legend("right")
    panels[-1].set_xlabel("time [s]")
    return figure


def _draw_sharing(axes: Axes, sharing: LoadSharing) -> None:
    cycle, instants = sharing.tooth_cycle, sharing.instantaneous
    middle = sharing.time[: len(cycle)] + 0.5 * sharing.period
    stride = max(1, len(cycle) // POINTS)
    bins = np.linspace(0, len(instants) - 1, POINTS // 2 + 1).astype(int)[:-1]
    for column, name in enumerate(sharing.lines):
        colour = theme.CYCLE[column % len(theme.CYCLE)]
        low, high = (extreme.reduceat(instants[:, column], bins) for extreme in (np.minimum, np.maximum))
        axes.fill_between(sharing.time[bins], low, high, color=colour, alpha=0.2, lw=0.0, zorder=1)
        axes.plot(middle[::stride], cycle[::stride, column], color=colour, label=name, zorder=2)
    axes.axhline(1.0, color=theme.MUTED, lw=0.6)
    axes.margins(x=0.0)
    least, most = min(float(instants.min()), 1.0), max(float(instants.max()), 1.0)
    if most - least < LEAST_SPAN:
        axes.set_ylim(least - LEAST_SPAN, most + LEAST_SPAN)


@theme.drawn
def displacement_figure(paths: Mapping[str, Floats], shaft: str, time: Floats) -> Figure:
    """Return the quasi-static displacement of a floating shaft against time.

    Args:
        paths: Label -> displacement [m], shape (instants, 2); the counterpart of the paper's figures 5 and 7.
        shaft: That floats.
        time: [s], shape (instants,).
    """
    figure = theme.sheet(WIDTH, 60.0)
    axes = figure.panel()
    for label, path in paths.items():
        axes.plot(time, np.linalg.norm(path, axis=1) / MICROMETRE, label=label)
    axes.set(xlabel="time [s]", ylabel="displacement [µm]", title=f"How far shaft {shaft} moves")
    axes.legend("right")
    axes.margins(x=0.0)
    axes.set_ylim(bottom=0.0)
    return figure


@theme.drawn
def orbit_figure(paths: Mapping[str, Floats]) -> Figure:
    """Return the paths of shafts' centres across themselves under slow errors.

    Args:
        paths: Shaft -> its displacement [m], shape (instants, 2).
    """
    figure = theme.sheet(WIDTH, 62.0)
    panels = figure.grid(1, len(paths))[0]
    for axes, (shaft, path) in zip(panels, paths.items(), strict=True):
        moved = path / MICROMETRE
        axes.plot(moved[:, 0], moved[:, 1], lw=0.7)
        axes.plot(*np.mean(moved, axis=0).tolist(), "o", color=theme.ORANGE, ms=3.0)
        axes.set(title=shaft, xlabel="first axis across [µm]")
        axes.set_aspect("data")
    panels[0].set_ylabel("second axis across [µm]")
    return figure


@theme.drawn
def support_figure(sweep: SupportSweep, marked: Mapping[float, str]) -> Figure:
    """Return sharing and displacement against the stiffness of a shaft's support.

    Args:
        sweep: From `support_sweep`.
        marked: Stiffness [N/m] -> word beside it.
    """
    figure = theme.sheet(WIDTH, 95.0)
    sharing, way = figure.grid(2, 1, share_x=True)[:, 0]
    sharing.fill_between(sweep.stiffness, sweep.minimum, sweep.maximum, color=theme.SKY, alpha=0.35, lw=0.0)
    sharing.plot(sweep.stiffness, sweep.maximum, color=theme.BLUE, label="errors: minimum and maximum")
    sharing.plot(sweep.stiffness, sweep.minimum, color=theme.BLUE)
    sharing.plot(sweep.stiffness, sweep.perfect, color=theme.ORANGE, label="no errors")
    sharing.set(ylabel="sharing coefficient b [-]", title=f"What floating shaft {sweep.shaft} buys")
    way.plot(sweep.stiffness, sweep.displacement / MICROMETRE, color=theme.GREEN)
    way.set(xlabel="support stiffness [N/m]", ylabel="displacement [µm]")
    for axes in (sharing, way):
        axes.set_xscale("log")
    for stiffness, word in marked.items():
        for axes in (sharing, way):
            axes.axvline(stiffness, color=theme.MUTED, lw=0.7, ls=":")
        sharing.annotate(word, (stiffness, 1.0), (2, -9), frames=("data", "axes"), fontsize=6.5, color=theme.MUTED)
    sharing.legend("lower left")
    return figure


@theme.drawn
def tornado_figure(study: SharingStudy) -> Figure:
    """Return what every error does alone to the sharing, the largest on top.

    Args:
        study: From `sharing_study`.
    """
    rows = study.influences
    figure, axes = _rows([row.source for row in rows])
    colours = [theme.BLUE if row.turns else theme.AMBER for row in rows]
    effect = 100.0 * np.array([row.effect for row in rows])
    axes.barh(range(len(rows)), 2.0 * effect, left=-effect, color=colours, height=0.62)
    axes.set(
        xlabel="change of the sharing coefficient [%]", title="One error at a time: blue comes and goes, amber stays"
    )
    axes.axvline(0.0, color=theme.MUTED, lw=0.6)
    return figure


def _rows(names: Sequence[str]) -> tuple[Figure, Axes]:
    """Return a figure with a named row for each bar, the first on top."""
    figure = theme.sheet(WIDTH, 22.0 + ROW * len(names))
    axes = figure.panel()
    axes.set_yticks(range(len(names)), names, fontsize=7.0)
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.only_grid("x")
    return figure, axes


@theme.drawn
def distribution_figure(study: SharingStudy, target: float | None = None) -> Figure:
    """Return how the peak share of random gearboxes is spread.

    Args:
        study: From `sharing_study`, of a design with errors.
        target: Share that is asked for [-].
    """
    figure = theme.sheet(WIDTH, 65.0)
    axes = figure.panel()
    if study.distribution is not None:
        axes.hist(100.0 * study.distribution.peak, bins=60, color=theme.SKY)
        for percent in PERCENTILES:
            _mark(axes, 100.0 * study.distribution.percentile(percent), f"{percent:g} %")
        axes.set_title(f"All errors at full size, random phases: {len(study.distribution.peak)} gearboxes")
    if target is not None:
        axes.axvline(100.0 * target, color=theme.ORANGE, lw=1.2)
    axes.set(xlabel="share of the most loaded path at its worst moment [%]", ylabel="gearboxes")
    return figure


def _mark(axes: Axes, place: float, word: str) -> None:
    axes.axvline(place, color=theme.INK, lw=0.7, ls=":")
    axes.annotate(word, (place, 1.0), (2, -8), frames=("data", "axes"),
                  fontsize=6.5, color=theme.MUTED)  # fmt: skip


@theme.drawn
def allocation_figure(allocation: Allocation) -> Figure:
    """Return every tolerance as given and as allowed for the target.

    Args:
        allocation: From `allocate`.
    """
    rows = smallest_first(allocation.sizes, lambda row: row.allowed / row.given)
    figure, axes = _rows([row.error for row in rows])
    axes.barh(range(len(rows)), [100.0] * len(rows), color=theme.STEEL, height=0.7)
    axes.barh(range(len(rows)), [100.0 * row.allowed / row.given for row in rows], color=theme.GREEN, height=0.45)
    share = f"{100.0 * allocation.target:g}/{100.0 * (1.0 - allocation.target):g}"
    title = f"How tight for {share} in {allocation.percent:g} % of gearboxes, at least cost"
    axes.set(xlabel="allowed size over the size given [%]", title=title)
    return figure


@theme.drawn
def single_error_figure(sharings: Mapping[str, LoadSharing], names: Mapping[str, str] | None = None) -> Figure:
    """Return the tooth-cycle sharing against time for every error alone, as in the paper's figures 8 to 18.

    Args:
        sharings: Error -> sharing with it alone.
        names: Error -> what its panel is called besides.
    """
    figure, grid = theme.tiles(len(sharings), 3, frame=14.0, row=30.0, share_y="all")
    for axes, (name, sharing) in zip(grid.flat, sharings.items(), strict=False):
        cycle = sharing.tooth_cycle
        stride = max(1, len(cycle) // POINTS)
        axes.plot(sharing.time[: len(cycle) : stride], cycle[::stride], lw=0.8)
        axes.set_title(": ".join(filter(None, ((names or {}).get(name), name))), fontsize=6.0)
        axes.axhline(1.0, color=theme.MUTED, lw=0.5)
        axes.margins(x=0.0)
    for axes in grid[:, 0]:
        axes.set_ylabel("b [-]")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    return figure


@theme.drawn
def load_factor_figure(sets: Mapping[str, PlanetSharing], curves: Mapping[str, Mapping[int, float]]) -> Figure:
    """Return K_γ of random planetary sets against the number of planets: median, and where 90 % of the sets lie.

    Args:
        sets: Label, such as ``"floating sun"`` -> sets.
        curves: Label -> number of planets -> K_γ to lay beside them [-]: closed form, tables of standards.
    """
    figure = theme.sheet(WIDTH, 80.0)
    axes = figure.panel()
    for number, (label, sharing) in enumerate(sets.items()):
        low, middle, high = (list(sharing.percentile(percent).values()) for percent in (5.0, 50.0, 95.0))
        place = np.array(sharing.planets) + 0.12 * (number - 0.5 * (len(sets) - 1))
        colour = theme.CYCLE[number % len(theme.CYCLE)]
        upright_ranges(axes, place, np.array(low), np.array(high), colour=colour)
        axes.plot(place, middle, "o", ms=3.5, color=colour, label=label)
    for number, (label, curve) in enumerate(curves.items()):
        order = number + len(sets)
        colour, style = theme.CYCLE[order % len(theme.CYCLE)], "--" if order < len(theme.CYCLE) else ":"
        axes.plot(list(curve), list(curve.values()), style, lw=0.9, marker=".", color=colour, label=label, zorder=1)
    axes.set(xlabel="planets", ylabel="mesh load factor K_γ [-]", title="Random sets: median, 5 and 95 %")
    counts = {count for sharing in sets.values() for count in sharing.planets}
    axes.set_xticks(sorted(counts.union(*curves.values())))
    axes.legend("right", size=6.5)
    return figure


# ----------------------------------------------------------------------------------------------------------------------
# How paths that lie around a shaft share its load, as a polar figure: planets round their carrier.
# ----------------------------------------------------------------------------------------------------------------------


SIDES = 120
"""Corners of what is drawn for a circle."""
RING = 0.25
"""Step of the rings [-]."""
NEARLY, ROOM, WIDE = 0.2, 0.5, 2.8
"""What is counted as above or below the middle, room for words around the rings [-], half the width over the rings."""


@theme.drawn
def around_figure(sharing: LoadSharing) -> Figure:
    """Return the sharing coefficients of parallel paths in their order round the shaft, the first one on top.

    Args:
        sharing: Of three paths or more.
    """
    shares = sharing.instantaneous
    low, middle, high = shares.min(axis=0), shares.mean(axis=0), shares.max(axis=0)
    figure = theme.sheet(theme.WIDTH, 92.0)
    axes = figure.panel()
    axes.set_axis_off()
    axes.set_aspect("data")
    reach = _rings(axes, max(1.0, float(high.max())))
    turn = np.pi / 2.0 - 2.0 * np.pi * np.arange(len(middle)) / len(middle)
    half = 0.8 * np.pi / len(middle)
    for k, angle in enumerate(turn):
        colour = theme.CYCLE[k % len(theme.CYCLE)]
        arc = np.linspace(angle - half, angle + half, SIDES // 4)
        x, y = _places(arc, np.full(len(arc), middle[k]))
        axes.shape(np.stack([np.append(x, 0.0), np.append(y, 0.0)], axis=1), fc=colour, alpha=0.35, zorder=2.0)
        axes.plot(*_places(np.full(2, angle), np.array([low[k], high[k]])), color=colour, lw=3.0, zorder=3.0)
        at = (reach + 0.25) * np.cos(angle), (reach + 0.25) * np.sin(angle)
        across = "center" if abs(at[0]) < NEARLY else "left" if at[0] > 0.0 else "right"
        axes.annotate(sharing.lines[k], at, (0, 1), fontsize=7.5, ha=across, weight="bold")
        words = f"mean {middle[k]:.3f}, {low[k]:.3f} to {high[k]:.3f}"
        axes.annotate(words, at, (0, -8), fontsize=7.0, ha=across, color=theme.MUTED)
    axes.set(xlim=(-WIDE * reach, WIDE * reach), ylim=(-reach - ROOM, reach + ROOM))
    return figure


def _rings(axes: Axes, most: float) -> float:
    """Draw a ring for every step of the coefficient, the equal share darker; return the last one's."""
    count = int(np.ceil(most / RING))
    around = np.linspace(0.0, 2.0 * np.pi, SIDES + 1)
    for step in range(1, count + 1):
        equal = step * RING == 1.0
        colour, width = (theme.MUTED, 1.0) if equal else (theme.HAIR, 0.6)
        axes.plot(*_places(around, np.full(len(around), step * RING)), color=colour, lw=width, zorder=1.0)
    return count * RING


def _places(angle: Floats, radius: Floats) -> tuple[Floats, Floats]:
    return radius * np.cos(angle), radius * np.sin(angle)


# ----------------------------------------------------------------------------------------------------------------------
# K_γ against the number of planets: random sets, one pin in closed form, and what standards and tests say.
# ----------------------------------------------------------------------------------------------------------------------


PERCENT = 95.0
"""Percentage of random sets that stay below the factor that is shown."""
LIMIT = "errors as given, torque and gears kept; the tables grant planets that are sized for their number"


def planets_text(counts: PlanetCounts) -> RenderableType:
    """Return K_γ by number of planets as a table, with where the printed ones come from.

    Args:
        counts: From `planet_counts`.
    """
    columns = {f"{PERCENT:g} % of random sets": counts.random.percentile(PERCENT), **_beside(counts)}
    table = Grid(f"K_γ of {counts.stage} against planets", caption=LIMIT)
    table.add_column("planets", justify="right")
    for name in columns:
        table.add_column(name, justify="right")
    for count in counts.random.planets:
        table.add_row(str(count), *(f"{row[count]:.2f}" if count in row else "" for row in columns.values()))
    return Group(table, *(Text(line) for line in published_notes()))


def published_notes() -> list[str]:
    """Return one sentence on how sure each table is, and the measured values."""
    tables = {row.name: row.confidence for row in load_factors() if not row.measured}
    measured = (row for row in load_factors() if row.measured)
    return [f"{name}: {confidence}" for name, confidence in tables.items()] + [
        f"measured, {row.name}: {row.load_factor:.2f} ({row.planets} planets)" for row in measured
    ]


def planets_figure(counts: PlanetCounts) -> Figure:
    """Return K_γ against planets with the closed form and the standards' tables.

    Args:
        counts: From `planet_counts`.
    """
    return load_factor_figure({"random sets": counts.random}, _beside(counts))


def _beside(counts: PlanetCounts) -> dict[str, Mapping[int, float]]:
    closed = {"one pin, floating": counts.floating, "one pin, fixed": counts.fixed}
    return {**closed, **load_factor_tables()}
