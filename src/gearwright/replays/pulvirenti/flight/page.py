"""Chapter 4 of Pulvirenti (2023) flown again: the page of its claims, and a counterpart of each of its figures."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gearwright.arrays import Floats
from gearwright.dynamics import Samples
from gearwright.identity import Row, mesh_part
from gearwright.mission.windows import DynamicWindow
from gearwright.render.style import theme
from gearwright.render.style.theme import WIDTH
from gearwright.replays.pulvirenti.flight.claims import CONSTANT, ROUNDING, VARYING, JudgedClaim, Runs
from gearwright.replays.pulvirenti.flight.measures import torques
from gearwright.replays.pulvirenti.flight.phases import Phased

ROW = 44.0
"""Height of one row of panels [mm]."""
QUIET = ("cruise", "taxi")
"""Windows in which nothing happens: they are shown closely, every step."""
CLOSE = 1.2e-3
"""What is shown of them [s]; of slower ones as much more [s]."""
THINNED = 500
"""Points of a curve over a whole window."""

FIGURES: Mapping[str, tuple[str, str]] = MappingProxyType({
    "4.2": ("cruise", "stage 1"), "4.3": ("cruise", "stage 2"), "4.4": ("cruise", "torques"),
    "4.5": ("cruise", "output"), "4.6": ("cruise", "pitch"), "4.7": ("second-order", "pitch"),
    "4.8": ("second-order", "output"), "4.9": ("take-off", "torques"), "4.10": ("take-off", "stage 1"),
    "4.11": ("take-off", "stage 2"), "4.12": ("take-off", "pitch"), "4.13": ("cruise", "forces"),
    "4.14": ("cruise", "torques"), "4.15": ("cruise", "output"), "4.16": ("take-off", "output"),
    "4.17": ("taxi", "stage 1"), "4.18": ("taxi", "stage 2"), "4.19": ("taxi", "output"),
    "4.20": ("taxi", "torques"), "4.21": ("taxi", "forces"), "4.22": ("taxi", "torques"), "4.23": ("taxi", "output"),
})  # fmt: skip
"""Figure of the thesis -> window and panel of its counterpart."""
LEAST_RANGE: Mapping[str, float] = MappingProxyType({"output": 0.02, "pitch": 0.1})
"""Panel -> range that its axis has at least, in its unit."""
PANELS: Mapping[str, tuple[str, ...]] = MappingProxyType({
    "cruise": ("stage 1", "stage 2", "torques", "output"),
    "second-order": ("pitch", "output"),
    "take-off": ("stage 1", "stage 2", "torques", "output", "pitch"),
    "taxi": ("stage 1", "stage 2", "torques", "output"),
})  # fmt: skip
"""Window -> rows of its figure on the page."""
TITLES: Mapping[str, str] = MappingProxyType({
    "stage 1": "Sun forces, stage 1", "stage 2": "Sun forces, stage 2", "forces": "Sun forces",
    "torques": "Shaft torques", "output": "Torques over the ideal one", "pitch": "Pitch",
})  # fmt: skip


@theme.styled
def chapter_figure(runs: Runs, window: str, panels: Sequence[str]) -> Figure:
    """Return panels of a window, constant stiffness on the left and varying on the right.

    Args:
        runs: Of `chapter_runs`.
        window: Its name.
        panels: Keys of `TITLES`, from top to bottom.
    """
    figure = theme.sheet(WIDTH, ROW * len(panels) + 8.0)
    grid = figure.subplots(len(panels), 2, squeeze=False, sharey="row")
    for column, stiffness in enumerate((CONSTANT, VARYING)):
        run = runs[window, stiffness]
        for row, panel in enumerate(panels):
            axes = grid[row, column]
            _DRAWN[panel](axes, run)
            axes.set_title(f"{TITLES[panel]}, {stiffness} stiffness", fontsize=8.0)
            axes.margins(x=0.0)
        grid[-1, column].set_xlabel("time [ms]" if window in QUIET else "time [s]")
    for row, panel in enumerate(panels):
        _widen(grid[row, 0], LEAST_RANGE.get(panel, 0.0))
    return figure


def _widen(axes: Axes, span: float) -> None:
    """Give an axis at least a range, so that rounding is not shown as if it were something."""
    low, high = axes.get_ylim()
    room = max(0.0, 0.5 * (span - (high - low)))
    axes.set_ylim(low - room, high + room)


def _seen(window: DynamicWindow) -> tuple[Samples, slice, float]:
    """Return samples, the part that is shown, and the unit of time."""
    if window.name in QUIET:
        samples = window.trace.windows[-1]
        turning = float(window.system.arrays.profile.factor[-1])
        return samples, slice(0, int(np.searchsorted(samples.time, samples.time[0] + CLOSE / turning))), 1e3
    samples = window.trace.samples
    return samples, slice(0, None, max(1, len(samples.time) // THINNED)), 1.0


def _time(window: DynamicWindow) -> Floats:
    samples, part, scale = _seen(window)
    return np.asarray(scale * (samples.time[part] - samples.time[0]))


def _stage(*stages: str) -> Callable[[Axes, DynamicWindow], None]:
    def draw(axes: Axes, window: DynamicWindow) -> None:
        samples, part, _ = _seen(window)
        if window.name not in QUIET:
            _bands(axes, window, stages)
            return
        rows = [mesh_part(stage, Row.SUN_PLANET) for stage in stages]
        for place, line in enumerate(place for row in rows for place in samples.labels.places_of(row)):
            colour, owner = theme.CYCLE[place % len(theme.CYCLE)], samples.labels.line_owners[line]
            label = str(owner.part._replace(name="")) if owner.part is not None else ""
            axes.plot(_time(window), samples.line_force[part, line] / 1e3, lw=0.8, color=colour, label=label)
        axes.set_ylabel("[kN]")

    return draw


def _bands(axes: Axes, window: DynamicWindow, stages: Sequence[str]) -> None:
    """Draw the mean of the first planet's force, and a band from least to greatest."""
    force = window.trace.force
    middle = 0.5 * (force.edges[1:] + force.edges[:-1])
    for place, stage in enumerate(stages):
        band, colour = force.of(str(mesh_part(stage, Row.SUN_PLANET, number=1))), theme.CYCLE[place]
        axes.fill_between(middle, band["minimum"] / 1e3, band["maximum"] / 1e3, color=colour, alpha=0.3, lw=0.0)
        axes.plot(middle, band["mean"] / 1e3, color=colour, lw=0.9)
    axes.set_ylabel("[kN]")


def _torques(axes: Axes, window: DynamicWindow) -> None:
    samples, part, _ = _seen(window)
    shafts = torques(window, samples)
    for name, torque in (
        ("T_GT", shafts.turbine),
        ("T_EM", shafts.motor),
        ("T_c1", shafts.carrier),
        ("T_c2", shafts.output),
    ):
        axes.plot(_time(window), torque[part] / 1e3, lw=0.9, label=name)
    axes.set_ylabel("[kN m]")
    axes.legend(loc="best", fontsize=6.0, ncols=4)


def _output(axes: Axes, window: DynamicWindow) -> None:
    samples, part, _ = _seen(window)
    shafts = torques(window, samples)
    for name, torque in (("T_c2", shafts.output), ("T_prop", shafts.propeller)):
        axes.plot(_time(window), 100.0 * (torque[part] / shafts.ideal[part] - 1.0), lw=0.9, label=name)
    axes.set_ylabel("off T_ideal [%]")
    axes.legend(loc="best", fontsize=6.0, ncols=2)


def _pitch(axes: Axes, window: DynamicWindow) -> None:
    samples = window.trace.samples
    step = max(1, len(samples.time) // THINNED)
    axes.plot(samples.time[::step], np.degrees(samples.drive("propeller pitch"))[::step], color=theme.GREEN)
    axes.set_ylabel("[°]")
    axes.set_xlabel("time [s]")


_DRAWN: Mapping[str, Callable[[Axes, DynamicWindow], None]] = MappingProxyType({
    "stage 1": _stage("first"), "stage 2": _stage("second"), "forces": _stage("first", "second"),
    "torques": _torques, "output": _output, "pitch": _pitch,
})  # fmt: skip


def number_text(value: float, unit: str) -> str:
    """Return a measured number; what is only rounding is zero.

    Args:
        value: In the unit.
        unit: ``"%"``, ``"°"`` or empty.
    """
    shown = "0" if abs(value) < ROUNDING else f"{value:.3g}"
    return f"{shown} {unit}".rstrip()


def covered_text(judged: JudgedClaim) -> str:
    """Return which numbers a claim's wording covers.

    Args:
        judged: With its claim.
    """
    low, high, unit = judged.claim.low, judged.claim.high, judged.claim.unit
    if math.isinf(high):
        return f"above {number_text(low, unit)}"
    return f"up to {number_text(high, unit)}" if low == 0.0 else f"{low:.3g} to {number_text(high, unit)}"


def chapter_markdown(judged: Sequence[JudgedClaim], phases: Sequence[Phased], images: Mapping[str, str]) -> str:
    """Return the page of the chapter as Markdown.

    Args:
        judged: Of `flight_claims`.
        phases: Of `phased`.
        images: Window -> file of its figure, beside the page.
    """
    holds = sum(claim.holds for claim in judged)
    parts = [
        _HEAD.format(claims=len(judged), holds=holds, fails=len(judged) - holds),
        "\n".join([_TABLE, *map(_row, judged)]),
        _ASSUMED,
        _PHASED,
        "\n".join([_PHASE_TABLE, *map(_phase_row, phases)]),
        *(f"## {_WORDS[window]}\n\n![{_WORDS[window]}]({path})" for window, path in images.items()),
    ]
    return "\n\n".join(parts) + "\n"


def _phase_row(row: Phased) -> str:
    numbers = " | ".join(number_text(100.0 * value, "%") for value in (row.maximum, row.mean, row.swing))
    return f"| {row.window} | {row.phases} | {numbers} |"


def _row(judged: JudgedClaim) -> str:
    claim = judged.claim
    numbers = [number_text(value, claim.unit) for value in (judged.constant, judged.varying)]
    counted = 0 if claim.stiffness == CONSTANT else 1
    numbers[counted] = f"**{numbers[counted]}**"
    verdict = "holds" if judged.holds else "does not hold"
    return (
        f"| {claim.figure} | {claim.says} | {covered_text(judged)} | {numbers[0]} | {numbers[1]} | {verdict} | "
        f"{claim.why} |"
    )


_WORDS: Mapping[str, str] = MappingProxyType({
    "cruise": "Cruise", "second-order": "Cruise, pitch of second order", "take-off": "Climb into cruise",
    "taxi": "Green taxi",
})  # fmt: skip
_HEAD = """---
hide: [toc]
---

# The thesis: chapter 4 flown again

Chapter 4 of Pulvirenti (2023) shows its two-stage hybrid gearbox in flight, in figures 4.2 to 4.23: cruise, a climb
into cruise, and taxi on the motor alone, with constant and with varying mesh stiffness. In-Line H2 flies the same
windows here, with propeller, governor and machines on the elastic train. The page is written by

    gearwright replay pulvirenti --chapter-4 thesis-flight.md --figures FOLDER

and FOLDER gets a counterpart of each figure, `4.2.svg` to `4.23.svg`, with both stiffnesses side by side. Of {claims}
claims {holds} hold and {fails} do not. Every claim is measured with both stiffnesses; the number that is judged, in
bold, is that with the stiffness of the thesis's figure."""
_TABLE = """| figure | the thesis says, in our words | the wording covers | constant | varying | verdict | why |
| --- | --- | --- | --- | --- | --- | --- |"""
_ASSUMED = """The thesis prints no power, stiffness, inertia, map, time constant or damping: masses, stiffnesses and
inertias come from gearwright's own sizing, the map from the Hamilton Standard method, and what else is assumed stands
in the mission file `thesis-chapter-4.toml`. Losses are left out, as there. Each run's own error estimate is below 1e-3
of the largest line force. In quiet windows curves show the last milliseconds, every step; elsewhere bands reach from
the least to the greatest force of each 25 ms."""
_PHASED = """## What the planets' phases do

How far the output torque swings with varying stiffness is a matter of how the planets' meshes follow each other. The
same windows with three ways of phasing them, against the ideal torque:"""
_PHASE_TABLE = """| window | planets at | at most | on average | greatest less least |
| --- | --- | --- | --- | --- |"""
