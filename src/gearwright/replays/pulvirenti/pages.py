"""Errata, claims and figures of Pulvirenti (2023) as tables and pages."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from jinja2 import Environment
from markupsafe import Markup
from rich.text import Text

from gearwright.base import Floats, Row, mesh_part, unit, written
from gearwright.dynamics import Samples
from gearwright.mission.windows import DynamicWindow
from gearwright.render import style as theme
from gearwright.render.pages.page import Number, Page, Section, Tone, Verdict as Judged, environment, set_page
from gearwright.render.style import WIDTH
from gearwright.render.terminal import Grid
from gearwright.render.vector.figure import Axes, Figure
from gearwright.replays.pulvirenti.claims import Claim, Erratum, claims, errata
from gearwright.replays.pulvirenti.flight import (
    CLAIMS,
    CONSTANT,
    ROUNDING,
    VARYING,
    Departed,
    Frequencies,
    JudgedClaim,
    Judgement,
    Runs,
    torques,
)
from gearwright.replays.replay import Verdict
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# The errata and claims of Pulvirenti (2023) as tables: words for the terminal, Markdown, one self-contained page.
# ----------------------------------------------------------------------------------------------------------------------


_TITLE = "Pulvirenti 2023: what it claims, what it prints, what gearwright uses"
_LEAD = (
    "The thesis on hybrid-electric turboprop gearboxes is where gearwright's first sizing comes from. This "
    "page holds its claims against what its own equations give once they are right, and lists the "
    "corrections."
)
_FOOTER = (
    "Text: doubtful words, not a formula. Right: doubted, and found right. Provable: by dimension, balance "
    "or geometry. Scan: the misprint may be that of the scanned text."
)
_DIGITS = 3
_STYLES = {Verdict.HOLDS: "green", Verdict.CONDITION: "yellow", Verdict.FAILS: "red"}
_SIGNS = {Verdict.HOLDS: "yes", Verdict.CONDITION: "partly", Verdict.FAILS: "no"}


def thesis_page() -> str:
    """Return the page as HTML that makes no request to anywhere."""
    counts = _context()["counts"]
    parts: Any = _environment().get_template("page.html.j2").make_module(_context())
    failing, held = counts[Verdict.FAILS], counts[Verdict.HOLDS]
    total = sum(counts.values())
    said = f"{held} hold, {counts[Verdict.CONDITION]} hold with a condition, {failing} do not hold."
    word = f"{failing} of {total} claims do not hold" if failing else "Every claim holds"
    sections = (
        Section(f"{total} claims", content=Markup(parts.part_claims())),
        Section(f"{len(errata())} doubtful passages", content=Markup(parts.part_errata())),
    )
    numbers = (*(Number(verdict.value, f"{count}") for verdict, count in counts.items()),
               Number("doubtful passages", f"{len(errata())}"))  # fmt: skip
    verdict = Judged(Tone.BAD if failing else Tone.GOOD, word, said)
    return set_page(Page("Replay", _TITLE, _LEAD, verdict, numbers, sections, footer=_FOOTER))


def thesis_markdown() -> str:
    """Return the same as Markdown, for the documentation."""
    return _environment().get_template("page.md.j2").render(_context())


def claims_table(judged: Sequence[Claim]) -> Grid:
    """Return the claims for the terminal.

    Args:
        judged: Of `claims`.
    """
    table = Grid("Claims of Pulvirenti 2023, and what its equations give once they are right", names=0, spaced=True)
    for header in ("printed", "computed", "verdict"):
        table.add_column(header)
    for claim in judged:
        table.add_row(
            claim.printed.printed, computed_text(claim), Text(claim.verdict.value, style=_STYLES[claim.verdict])
        )
    return table


def errata_table(listed: Sequence[Erratum]) -> Grid:
    """Return the errata for the terminal.

    Args:
        listed: Of `errata`.
    """
    table = Grid("Errata of Pulvirenti 2023", spaced=True)
    for header in ("equation", "standing", "printed", "correct"):
        table.add_column(header)
    for erratum in listed:
        table.add_row(erratum.equation, erratum.standing, Text(erratum.printed), Text(erratum.correct))
    return table


def computed_text(claim: Claim) -> str:
    """Return what was computed, by each way of counting.

    Args:
        claim: With its numbers.
    """
    first = f"{_number(claim.value, claim.printed.dimension)} ({claim.printed.counts})"
    if claim.other is None:
        return first
    return f"{first}; {_number(claim.other, claim.printed.dimension)} ({claim.printed.other})"


def covered_text(claim: Claim) -> str:
    """Return which numbers the wording covers.

    Args:
        claim: With its printed side.
    """
    low, high, dimension = claim.printed.low, claim.printed.high, claim.printed.dimension
    if math.isinf(high):
        return f"above {_number(low, dimension)}"
    if low == 0.0:
        return f"below {_number(high, dimension)}"
    return f"{_number(low, dimension)} to {_number(high, dimension)}"


def _number(value: float, dimension: str) -> str:
    if dimension == "percent":
        return f"{value:.1f} %".replace("-", "−")
    return f"{written(value, 4 if dimension == 'speed' else _DIGITS)} {unit(dimension)}".rstrip()


def _context() -> dict[str, Any]:
    judged = claims()
    return {
        "claims": judged,
        "errata": errata(),
        "counts": {verdict: sum(claim.verdict is verdict for claim in judged) for verdict in Verdict},
        "version": __version__,
    }


@cache
def _environment() -> Environment:
    pages = environment("gearwright.replays.pulvirenti")
    pages.filters |= {"computed": computed_text, "covered": covered_text, "sign": _SIGNS.__getitem__}
    return pages


# ----------------------------------------------------------------------------------------------------------------------
# Chapter 4 of Pulvirenti (2023) flown again: the page of its claims, and a counterpart of each of its figures.
# ----------------------------------------------------------------------------------------------------------------------


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
STIFFNESS: Mapping[str, str] = MappingProxyType({claim.figure: claim.stiffness for claim in CLAIMS})
"""Figure of the thesis -> its mesh stiffness."""
SHOWN_STIFFNESS: Mapping[str, str] = MappingProxyType({
    "cruise": VARYING, "second-order": CONSTANT, "take-off": VARYING, "taxi": VARYING,
})  # fmt: skip
"""Window -> mesh stiffness of its figure on the page."""
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


class Side(NamedTuple):
    """One column of a figure."""

    words: str
    """Above it."""
    runs: Runs


@theme.drawn
def chapter_figure(sides: Sequence[Side], window: str, panels: Sequence[str], *, stiffness: str) -> Figure:
    """Return panels of a window, as printed on the left and as it should be on the right.

    Args:
        sides: Columns, from left to right.
        window: Its name.
        panels: Keys of `TITLES`, from top to bottom.
        stiffness: Of the meshes.
    """
    figure = theme.sheet(WIDTH, ROW * len(panels) + 8.0)
    grid = figure.grid(len(panels), len(sides), share_y="row")
    for column, side in enumerate(sides):
        run = side.runs[window, stiffness]
        for row, panel in enumerate(panels):
            axes = grid[row, column]
            _DRAWN[panel](axes, run)
            axes.set_title(f"{TITLES[panel]}, {side.words}", fontsize=8.0)
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
    axes.legend("best", size=6.0, columns=4)


def _output(axes: Axes, window: DynamicWindow) -> None:
    samples, part, _ = _seen(window)
    shafts = torques(window, samples)
    for name, torque in (("T_c2", shafts.output), ("T_prop", shafts.propeller)):
        axes.plot(_time(window), 100.0 * (torque[part] / shafts.ideal[part] - 1.0), lw=0.9, label=name)
    axes.set_ylabel("off T_ideal [%]")
    axes.legend("best", size=6.0, columns=2)


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


def covered_figure_text(judged: JudgedClaim) -> str:
    """Return which numbers a claim's wording covers.

    Args:
        judged: With its claim.
    """
    low, high, unit = judged.claim.low, judged.claim.high, judged.claim.unit
    if math.isinf(high):
        return f"above {number_text(low, unit)}"
    return f"up to {number_text(high, unit)}" if low == 0.0 else f"{low:.3g} to {number_text(high, unit)}"


class Chapter(NamedTuple):
    """What the page of chapter 4 shows."""

    judged: Sequence[JudgedClaim]
    departed: Sequence[Departed]
    frequencies: Frequencies
    images: Mapping[str, str]
    """Window -> file of its figure, beside the page."""


def chapter_markdown(chapter: Chapter) -> str:
    """Return the page of the chapter as Markdown.

    Args:
        chapter: Claims, departures, figures.
    """
    counts = {judgement: sum(claim.judgement is judgement for claim in chapter.judged) for judgement in Judgement}
    parts = [
        _HEAD.format(
            claims=len(chapter.judged),
            reproduced=counts[Judgement.REPRODUCED],
            failed=counts[Judgement.NOT_REPRODUCED],
            untestable=counts[Judgement.NOT_TESTABLE],
        ),
        "\n".join([_TABLE, *map(_row, chapter.judged)]),
        _ASSUMED,
        _DEPARTED,
        "\n".join([_DEPARTED_TABLE, *_departed_rows(chapter.departed)]),
        _INERTIA.format(pairs=_pairs(chapter.frequencies)),
        *(f"## {_WORDS[window]}\n\n![{_WORDS[window]}]({path})" for window, path in chapter.images.items()),
    ]
    return "\n\n".join(parts) + "\n"


def _departed_rows(departed: Sequence[Departed]) -> Sequence[str]:
    """Return one row for each way, with all windows side by side."""
    rows: dict[tuple[str, str], list[str]] = {}
    for row in departed:
        numbers = [number_text(100.0 * value, "%") for value in (row.maximum, row.mean, row.swing)]
        rows.setdefault((row.equation, row.words), []).extend(numbers)
    return [f"| {equation or '–'} | {words} | {' | '.join(numbers)} |" for (equation, words), numbers in rows.items()]


def _pairs(frequencies: Frequencies) -> str:
    """Return the frequencies that the planets' inertia moves, lowest first."""
    distinct = [sorted({round(value, 1) for value in values}) for values in (frequencies.right, frequencies.printed)]
    right, printed = ([value for value in own if value not in other] for own, other in (distinct, distinct[::-1]))
    return f"{', '.join(f'{value:g}' for value in right)} Hz become {', '.join(f'{value:g}' for value in printed)} Hz"


def _row(judged: JudgedClaim) -> str:
    claim = judged.claim
    printed, right = (number_text(value, claim.unit) for value in (judged.printed, judged.right))
    why = f"{claim.why}. Not printed: {claim.setting}" if claim.setting else claim.why
    return (
        f"| {claim.figure} | {claim.says} | {covered_figure_text(judged)} | **{printed}** | {right} | "
        f"{judged.judgement.value} | {why} |"
    )


_WORDS: Mapping[str, str] = MappingProxyType({
    "cruise": "Cruise, varying stiffness", "second-order": "Cruise, pitch of second order",
    "take-off": "Climb into cruise, varying stiffness", "taxi": "Green taxi, varying stiffness",
})  # fmt: skip
_HEAD = """---
hide: [toc]
---

# The thesis: chapter 4 flown again

Chapter 4 of Pulvirenti (2023) shows its two-stage hybrid gearbox in flight, in figures 4.2 to 4.23: cruise, a climb
into cruise, and taxi on the motor alone, with constant and with varying mesh stiffness. In-Line H2 flies the same
windows here, with propeller, governor and machines on the elastic train, twice: with the model **as printed**, its
departures included, and **as it should be**. The page is written by

    gearwright replay pulvirenti --chapter-4 thesis-flight.md --figures FOLDER

and FOLDER gets a counterpart of each figure, `4.2.svg` to `4.23.svg`, as printed beside as it should be. Each of
{claims} claims is judged by the printed model with the stiffness of its figure (bold): {reproduced} are
reproduced, not reproduced {failed}, and {untestable} cannot be tested: they hang on a number that is not printed."""
_TABLE = """| figure | the thesis says, in our words | its wording covers | as printed | as it should be | verdict | why |
| --- | --- | --- | --- | --- | --- | --- |"""  # noqa: E501
_ASSUMED = """Printed are I_prop = 100 kg m², the damping ratio 0.1, speeds, the governor's gain and the form of every
equation; powers, teeth, modules, widths, stiffnesses and maps are not. These come from gearwright's own sizing, the map
from the Hamilton Standard method, and what else is assumed stands in the mission file `thesis-chapter-4.toml`. Losses
are left out, as there. Each run's own error estimate is below 1e-3 of the largest line force. In quiet windows curves
show the last milliseconds, every step; elsewhere bands reach from the least to the greatest force of each 25 ms."""
_DEPARTED = """## Which departure makes which number

The output torque with varying stiffness against the ideal one: greatest difference, mean difference, greatest less
least, in cruise and in taxi. Every row is a run of its own. The first seven change the right model by what they say;
*as printed* has the first four together. Below it stand, each on top of *as printed*, formulas whose units do not fit
or which may be meant otherwise, with the numbers that they give as they stand."""
_DEPARTED_TABLE = """| equation | what is printed | cruise, most | mean | swing | taxi, most | mean | swing |
| --- | --- | --- | --- | --- | --- | --- | --- |"""
_INERTIA = """The planets' inertia, alone, moves natural frequencies of the train: {pairs}.
With θ_p relative to the carrier the kinetic energy is J_p (θ̇_c − θ̇_p)²/2 and not J_p θ̇_p²/2; gearwright takes
absolute angles."""
