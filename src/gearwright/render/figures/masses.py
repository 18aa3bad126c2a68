"""Figures of what weighs: the mass and the margins of a Sizing, treemap with its band, the catalogue's engines."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gearwright.base import POUND, ROUNDING, Check, Floats, Kind, largest_first, margin_text, smallest_first
from gearwright.catalogue import Engine, Series, all_series, engines, weighed_gearboxes
from gearwright.particulars import Particulars
from gearwright.render import style as theme
from gearwright.render.style import WIDTH
from gearwright.render.tables.sizing import not_in_the_mass
from gearwright.render.vector.figure import Axes, Figure, tinted
from gearwright.render.vector.layout import text_width
from gearwright.sizing import ShaftDiagram, ShaftSizing, Sizing
from gearwright.sizing.mass import CompleteMass
from gearwright.weights import Comparison, LogLine, Score, checked_engines, gearbox_mass, log_line, refit, scores

# ----------------------------------------------------------------------------------------------------------------------
# Figures of a Sizing: where the mass is, and how much margin every check has.
# ----------------------------------------------------------------------------------------------------------------------


_GROUP_COLOURS = {"gears": theme.BLUE, "carriers": theme.AMBER, "shafts": theme.GREEN, "planet bearings": theme.SKY}
_ROW = 5.2
"""Height of one bar [mm]."""
_FRAME = 22.0
"""Height of title and axis [mm]."""
_PART_COLOURS = {"gears": theme.BLUE, "shafts": theme.GREEN, "carriers": theme.AMBER, "bearings": theme.SKY,
                 "joints": theme.ORANGE}  # fmt: skip
"""Group of parts -> colour of its checks."""
MOST_MARGINS = 45
"""Checks that are drawn at most, the worst ones; tables have all."""
STEPS = 12
"""Places between two loads at which a shaft's diagram is drawn."""
HOUR = 3600.0
"""[s]"""
LARGEST_MARGIN = 4.0
"""Margin at which a bar is cut [-]; its number says how large it is."""


@theme.drawn
def mass_figure(facts: Particulars) -> Figure:
    """Return the mass of every part, heaviest first, in its group's colour.

    Args:
        facts: Of a sizing.
    """
    sizing, parts, groups = facts.sizing, facts.mass_parts, facts.mass_groups
    figure = theme.sheet(WIDTH, _FRAME + 6.0 + _ROW * len(parts))
    axes = figure.panel()
    names = [f"{part.count} × {part.part}" if part.count > 1 else part.part for part in parts]
    axes.barh(names, [part.total for part in parts],
              color=[_GROUP_COLOURS[part.group] for part in parts], height=0.72)  # fmt: skip
    for place, part in enumerate(parts):
        axes.annotate(f"{part.total:.2f} kg  {part.share:.0%}", (part.total, place), (3, 0),
                       va="center", fontsize=7.5)  # fmt: skip
    for group, colour in _GROUP_COLOURS.items():
        if group in groups:
            axes.barh([0], [0.0], color=colour, label=f"{group}  {groups[group]:.2f} kg")
    axes.legend("lower right")
    axes.invert_yaxis()
    axes.set(xlim=(0.0, max(part.total for part in parts) * 1.18), xlabel=f"mass [kg]. {not_in_the_mass(groups)}")
    parts_mass = f", parts {sizing.parts_mass:.2f} kg" if sizing.mass != sizing.parts_mass else ""
    axes.set_title(f"Train as sized {sizing.mass:.2f} kg{parts_mass}, {sizing.power_density / 1e3:.1f} kW/kg")
    axes.only_grid("x")
    return figure


@theme.drawn
def margin_figure(sizing: Sizing) -> Figure:
    """Return the margin of every check, worst first: what loads decide above, what shape and room decide below.

    Args:
        sizing: As sized.
    """
    every = sizing.checks
    checks = every[:MOST_MARGINS]
    panels = {
        "Margins against loads": [check for check in checks if check.exponent is not None],
        "Margins of shape and room": [check for check in checks if check.exponent is None],
    }
    panels = {title: rows for title, rows in panels.items() if rows}
    figure = theme.sheet(WIDTH, _FRAME * len(panels) + _ROW * len(checks))
    grid = figure.grid(len(panels), 1, heights=[len(rows) + 2 for rows in panels.values()])
    for axes, (title, rows) in zip(grid[:, 0], panels.items(), strict=True):
        _bars(axes, rows)
        axes.set_title(f"{title}, worst first")
    left = f"; {len(every) - len(checks)} more in the tables" if len(checks) < len(every) else ""
    grid[-1, 0].set_xlabel(f"margin [-], the asked factor included; 1 is just enough{left}")
    return figure


def aged_bearings(sizing: Sizing) -> tuple[Check, ...]:
    """Return the checks of the lives of bearings that are loaded, the shortest first; `bearing_life_figure` draws them.

    Args:
        sizing: As sized.
    """
    lives = [check for check in sizing.checks if check.part.kind is Kind.BEARING and check.dimension == "life"]
    judged = [check for check in lives if check.limit is not None and math.isfinite(check.value or math.inf)]
    return tuple(smallest_first(judged, lambda check: check.value or math.inf))


@theme.drawn
def bearing_life_figure(lives: Sequence[Check]) -> Figure:
    """Return the rating life of every bearing beside the one that is asked for.

    Args:
        lives: From `aged_bearings`.
    """
    hours, asked = [(check.value or 0.0) / HOUR for check in lives], [(check.limit or 0.0) / HOUR for check in lives]
    figure = theme.sheet(WIDTH, _FRAME + _ROW * len(lives))
    axes = figure.panel()
    colours = [theme.ORANGE if check.fails else theme.SKY for check in lives]
    axes.barh(range(len(lives)), hours, color=colours, height=0.72)
    for place, (check, life) in enumerate(zip(lives, hours, strict=True)):
        axes.annotate(f"{life:,.0f} h{_case(check)}", (life, place), (3, 0), fontsize=7.5, va="center")
        axes.plot([asked[place]] * 2, [place - 0.45, place + 0.45], color=theme.ORANGE, lw=1.6, zorder=3.0)
    axes.set_yticks(range(len(lives)), [str(check.part) for check in lives])
    axes.set(xscale="log", xlim=(0.3 * min(*hours, *asked), 10.0 * max(*hours, *asked)))
    axes.set(xlabel="rating life [h]; upright lines: asked")
    axes.set_ylim(len(lives) - 0.4, -0.6)
    axes.only_grid("x")
    return figure


def _bars(axes: Axes, checks: Sequence[Check]) -> None:
    """Draw a bar for every check, in the colour of its part."""
    margins = [math.inf if check.margin is None else check.margin for check in checks]
    shown = [min(margin, LARGEST_MARGIN) for margin in margins]
    kinds = [_kind_of(check) for check in checks]
    axes.barh(range(len(checks)), shown, color=[_PART_COLOURS[kind] for kind in kinds], height=0.72)
    for kind in dict.fromkeys(kinds):
        axes.barh([0], [0.0], color=_PART_COLOURS[kind], label=kind)
    for place, (check, margin, length) in enumerate(zip(checks, margins, shown, strict=True)):
        colour = theme.ORANGE if check.fails else theme.INK
        told = "  too small" if check.fails else "  waived" if check.waiver else ""
        number = margin_text(margin, 4) if math.isfinite(margin) else "no load"
        axes.annotate(f"{number}{told}", (length, place), (3, 0), fontsize=7.5,
                       va="center", color=colour)  # fmt: skip
    axes.set_yticks(range(len(checks)), [f"{check.part}, {check.what}{_case(check)}" for check in checks])
    axes.axvline(1.0, color=theme.ORANGE, lw=1.2)
    axes.set_ylim(len(checks) - 0.4, -0.6)
    axes.set_xlim(0.0, LARGEST_MARGIN * 1.12)
    if len(set(kinds)) > 1:
        axes.legend("upper right")
    axes.only_grid("x")


def _case(check: Check) -> str:
    """Return the case that governs, where it is one."""
    return f", {check.case}" if check.case and check.exponent is not None else ""


def _kind_of(check: Check) -> str:
    """Return the group of a check's part, as the legend names it."""
    return {Kind.SHAFT: "shafts", Kind.BEARING: "bearings", Kind.JOINT: "joints", Kind.CARRIER: "carriers"}.get(
        check.part.kind, "gears"
    )


def bent_shafts(sizing: Sizing) -> list[ShaftSizing]:
    """Return the shafts that carry more than torque; opposite forces that cancel leave only rounding.

    Args:
        sizing: As sized.
    """
    moments = {shaft.name: float(np.max(_along(shaft.diagram)[2])) for shaft in sizing.shafts if shaft.bearings}
    largest = max(moments.values(), default=0.0)
    return [shaft for shaft in sizing.shafts if moments.get(shaft.name, 0.0) > ROUNDING * largest]


@theme.drawn
def shaft_figure(sizing: Sizing) -> Figure:
    """Return shear, bending of both planes together and torsion along every shaft that is bent.

    Args:
        sizing: As sized; `bent_shafts` finds at least one.
    """
    shafts = bent_shafts(sizing)
    figure = theme.sheet(WIDTH, 12.0 + 34.0 * len(shafts))
    grid = figure.grid(len(shafts), 3)
    for row, shaft in zip(grid, shafts, strict=True):
        place, *curves = _along(shaft.diagram)
        for axes, values, colour in zip(row, curves, (theme.GREEN, theme.BLUE, theme.ORANGE), strict=True):
            axes.fill_between(place * 1e3, values, color=colour, alpha=0.25, lw=0.0)
            axes.plot(place * 1e3, values, color=colour)
            axes.plot([bearing.position * 1e3 for bearing in shaft.bearings], [0.0, 0.0], "^", color=theme.INK, ms=4.0)
            axes.margins(x=0.02)
        row[0].set_title(shaft.name)
    for axes, label in zip(grid[-1], ("shear force [N]", "bending moment [N m]", "torsion [N m]"), strict=True):
        axes.set_xlabel(f"{label} over position [mm]")
    return figure


def _along(diagram: ShaftDiagram) -> tuple[Floats, Floats, Floats, Floats]:
    """Return position [m], shear [N], bending [N m] (both planes together) and torsion [N m] at many places.

    Each component runs straight between loads, their square root does not: it is taken after the interpolation. Of
    several loads at one place only the first and the last value count, as what lies between depends on their order.
    """
    position = np.array(diagram.position)
    before, after = np.diff(position, prepend=-np.inf) > 0.0, np.diff(position, append=np.inf) > 0.0
    keep = np.flatnonzero(before | after)
    steps = np.linspace(0.0, len(keep) - 1.0, STEPS * (len(keep) - 1) + 1)

    def dense(values: Sequence[float]) -> Floats:
        result: Floats = np.interp(steps, np.arange(len(keep)), np.array(values)[keep])
        return result

    shear, bending = (np.hypot(dense(along_y), dense(along_z)) for along_y, along_z in (diagram.shear, diagram.bending))
    return dense(diagram.position), shear, bending, dense(diagram.torsion)


# ----------------------------------------------------------------------------------------------------------------------
# Everything that a gearbox weighs as areas, and below it the band in which such gearboxes lie.
# ----------------------------------------------------------------------------------------------------------------------


FEW = 4
"""Letters of a name that is cut, at least."""
HEIGHT = 88.0
"""Of the areas [mm]."""
LETTERS = 6.5
"""[pt]"""
COLOURS = (*theme.CYCLE, theme.MUTED)
"""Of the groups, the heaviest first."""
_LINE = 3.0
"""Height of a line of letters [mm]."""

Place = tuple[float, float, float, float]
"""Left, low, width, height [mm]."""


def squarified(sizes: Sequence[float], place: Place) -> list[Place]:
    """Return rectangles of given areas that fill a place, as nearly square as rows of them allow.

    Args:
        sizes: Positive, the largest first.
        place: To fill.

    Source: Bruls, Huizing and van Wijk 2000, Squarified Treemaps.

    >>> squarified([2.0, 1.0, 1.0], (0.0, 0.0, 2.0, 2.0))
    [(0.0, 0.0, 1.0, 2.0), (1.0, 0.0, 1.0, 1.0), (1.0, 1.0, 1.0, 1.0)]
    """
    left, low, width, height = place
    scale = width * height / sum(sizes) if sizes else 0.0
    areas, made = [size * scale for size in sizes], list[Place]()
    while areas:
        side = min(width, height)
        longer = (k for k in range(1, len(areas)) if _worst(areas[: k + 1], side) > _worst(areas[:k], side))
        count = next(longer, len(areas))
        row, areas = areas[:count], areas[count:]
        depth, at = sum(row) / side, 0.0
        for area in row:
            long = area / depth
            made.append((left, low + at, depth, long) if width >= height else (left + at, low, long, depth))
            at += long
        if width >= height:
            left, width = left + depth, width - depth
        else:
            low, height = low + depth, height - depth
    return made


def _worst(row: Sequence[float], side: float) -> float:
    """Return the largest ratio of sides in a row along one side."""
    depth = sum(row) / side
    return max(max(depth * depth / area, area / (depth * depth)) for area in row)


@theme.drawn
def treemap_figure(mass: CompleteMass, low: float | None, high: float | None) -> Figure:
    """Return the parts of a complete mass as areas in the colours of their groups, and the bands of the whole.

    Args:
        mass: Sum of all parts.
        low: Least mass that real gearboxes let expect [kg]; None where it is not known.
        high: Greatest [kg].
    """
    figure = theme.sheet(WIDTH, HEIGHT + 34.0)
    areas, bands = figure.grid(2, 1, heights=(HEIGHT, 12.0))[:, 0]
    wide = WIDTH - 12.0
    for k, (group, parts) in enumerate(_groups(mass, (0.0, 0.0, wide, HEIGHT))):
        colour = COLOURS[k % len(COLOURS)]
        for words, place in parts:
            areas.rectangle(place[:2], *place[2:], fc=tinted(colour), ec=theme.PAPER, lw=0.8)
            _label(areas, words, place)
        areas.shape([(0.0, 0.0)] * 3, fc=tinted(colour), label=f"{group}, {mass.of(group):.3g} kg")
    areas.set(xlim=(0.0, wide), ylim=(0.0, HEIGHT), title=f"{mass.design}: {mass.total:.4g} kg")
    areas.set_axis_off()
    areas.legend("below", columns=5, size=LETTERS)
    _draw_bands(bands, mass, low, high)
    return figure


def _groups(mass: CompleteMass, place: Place) -> Iterator[tuple[str, list[tuple[list[str], Place]]]]:
    """Yield each group, the heaviest first, with words and place of its parts."""
    groups = largest_first(mass.groups, lambda group: group.total)
    for group, room in zip(groups, squarified([group.total for group in groups], place), strict=True):
        parts = largest_first((item for item in mass.parts if item.group == group.group), lambda item: item.total)
        places = squarified([item.total for item in parts], room)
        named = [
            [f"{item.count} × {item.part}" if item.count > 1 else item.part, f"{item.total:.3g} kg"] for item in parts
        ]
        yield group.group, list(zip(named, places, strict=True))


def _label(axes: Axes, words: Sequence[str], place: Place) -> None:
    """Write what fits: name and mass, or the name alone."""
    left, low, width, height = place
    name = _cut(words[0], width - 2.0)
    fitting = [word for word in (name, words[1]) if word and text_width(word, LETTERS, bold=False) <= width - 2.0]
    for k, word in enumerate(fitting[: int((height - 1.0) / _LINE)]):
        axes.text(left + 1.0, low + height - 0.8 - k * _LINE, word, fontsize=LETTERS, va="top")


def _cut(word: str, width: float) -> str:
    """Return a word as far as it fits, nothing where that is less than a few letters."""
    if text_width(word, LETTERS, bold=False) <= width:
        return word
    shorter = (k for k in range(len(word) - 1, FEW, -1) if text_width(f"{word[:k]}…", LETTERS, bold=False) <= width)
    fits = next(shorter, 0)
    return word[:fits] + "…" if fits else ""


def _draw_bands(axes: Axes, mass: CompleteMass, low: float | None, high: float | None) -> None:
    rows = [("sum of its parts", mass.band, theme.BLUE)]
    if low is not None and high is not None:
        rows.append(("61 real gearboxes", (low, high), theme.MUTED))
    for place, (_, ends, colour) in enumerate(rows):
        axes.barh(place, ends[1] - ends[0], left=ends[0], height=0.6, color=colour)
    axes.x.zero = False
    axes.axvline(mass.total, color=theme.INK, lw=1.2)
    axes.set_yticks(range(len(rows)), [name for name, *_ in rows])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xlim(0.0, 1.1 * max(ends[1] for _, ends, _ in rows))
    axes.set_xlabel("complete mass [kg]; bars: 68 %, line: this gearbox")
    axes.only_grid("x")


# ----------------------------------------------------------------------------------------------------------------------
# Figures of what gearboxes weigh: the engines of the catalogue, their densities, the methods against real weights.
# ----------------------------------------------------------------------------------------------------------------------


_COLOURS = {
    "Pratt & Whitney Canada": theme.BLUE,
    "Rolls-Royce": theme.GREEN,
    "GE Aviation": theme.ORANGE,
    "Honeywell": theme.PURPLE,
}
_MARKERS = "osD^v<>P"
_KW = 1e3


def figure_mass_over_power(chosen: Comparison | None = None) -> Figure:
    """Return the thesis's figure 1.1: power against gearbox mass for every series, with the fitted power law.

    The masses are estimates by NASA'15, so the fits are properties of that formula and of the speeds of these engines.

    Args:
        chosen: A requirement to mark, with the band of the real weights.
    """
    figure = theme.sheet(WIDTH, 118.0)
    axes = figure.panel()
    for series in all_series():
        _draw_series(axes, series)
    for name, line, style in (("turboprops", turboprop_fit(), "-"), ("all 121 rows", fit_of_all_rows(), ":")):
        reach = np.geomspace(170.0, 4200.0, 50)
        law = f"{name}: m = {10**line.intercept:.4f} P^{line.slope:.3f}, R² = {line.r_squared:.2f}"
        axes.plot(reach, [line.at(p) for p in reach], color=theme.INK, ls=style, lw=1.4, label=law, zorder=1)
    axes.annotate("turboshafts that deliver\nat 6000 to 15 000 rpm", (640.0, 13.0), fontsize=7.5, color=theme.INK)
    if chosen is not None:
        _mark_requirement(axes, chosen)
    _log_axes(axes, "take-off power P [kW]", "gearbox mass m by NASA'15 [kg]")
    axes.set_xticks([200, 300, 500, 1000, 2000, 4000])
    axes.set_yticks([10, 20, 30, 50, 100, 200, 300])
    axes.set_title("Gearbox mass over power, 121 engines (Pulvirenti 2023, figure 1.1 redrawn)")
    axes.legend("right", size=7.0)
    return figure


def turboprop_fit() -> LogLine:
    """Return the power law of gearbox mass [kg] in power [kW] through the turboprops whose mass follows the formula."""
    turboprops = [
        engine
        for engine in engines()
        if engine.series.kind == "turboprop" and engine.note("gearbox_mass_kg", "differs") is None
    ]
    return log_line(
        [turboprop.power / _KW for turboprop in turboprops], [gearbox_mass(turboprop) for turboprop in turboprops]
    )


def fit_of_all_rows() -> LogLine:
    """Return the power law of printed gearbox mass [kg] in power [kW] through all 121 rows, flagged or not."""
    masses = [printed.value for engine in engines() if (printed := engine.as_printed("gearbox_mass_kg")) is not None]
    return log_line([engine.power / _KW for engine in engines()], masses)


def figure_densities() -> Figure:
    """Return power density of the gearbox and torque density of the engine, series by series."""
    figure = theme.sheet(WIDTH, 105.0)
    left, right = figure.grid(1, 2, share_y="all")[0]
    names = [series.name for series in all_series()]
    for place, series in enumerate(all_series()):
        rows = [engine for engine in checked_engines() if engine.engine.series is series]
        colour = _COLOURS[series.manufacturer]
        face = colour if rows[0].engine.has_gearbox else theme.PAPER
        for axes, column in ((left, "gearbox_kw_kg"), (right, "torque_nm_kg")):
            values = [value for row in rows if (value := row.check(column).computed) is not None]
            axes.plot([min(values), max(values)], [place, place], color=colour, lw=5.0, alpha=0.25)
            axes.scatter(values, [place] * len(values), s=20, color=face, edgecolors=colour, lw=0.9, zorder=3)
            axes.annotate(_span_text(values), (max(values), place), (6, 0), va="center", fontsize=7)
    for axes, label in (
        (left, "power density of the gearbox  P/m_GB [kW/kg]"),
        (right, "torque density  Q/m_engine [N m/kg]"),
    ):
        axes.set_xlabel(label)
        axes.only_grid("x")
        axes.set_xlim(0.0, axes.get_xlim()[1] * 1.2)
    left.set_yticks(range(len(names)), [f"{series.name}  ({series.kind})" for series in all_series()], fontsize=7.5)
    left.invert_yaxis()
    left.set_title("Densities by series, recomputed. Hollow: no such gearbox (CT7 turboshaft)")
    return figure


def figure_methods(chosen: Comparison | None = None) -> Figure:
    """Return the 61 real weights with the band of their refit, and bias and scatter of every method against them.

    Args:
        chosen: A requirement to mark, with the mass that each method gives it.
    """
    figure = theme.sheet(WIDTH, 95.0)
    left, right = figure.grid(1, 2, widths=(1.25, 1.0))[0]
    _draw_weights(left)
    if chosen is not None:
        _mark_methods(left, chosen)
    left.legend("upper left", size=7.0)
    _draw_scores(right, [score for score in scores() if score.bias is not None])
    return figure


def _draw_series(axes: Axes, series: Series) -> None:
    rows = [engine for engine in engines() if engine.series is series]
    computed = [row for row in rows if row.has_gearbox and row.note("gearbox_mass_kg", "differs") is None]
    kin = [relative for relative in all_series() if relative.manufacturer == series.manufacturer]
    colour, marker = _COLOURS[series.manufacturer], _MARKERS[kin.index(series)]
    face = colour if computed else theme.PAPER
    label = f"{series.name} ({len(rows)})" + ("" if computed else " flagged")
    x, y = [row.power / _KW for row in rows], [_mass_shown(row) for row in rows]
    axes.plot(x, y, marker, ms=4.0, color=colour, mfc=face, mec=colour, mew=0.9, alpha=0.85, label=label, zorder=3.0)


def _mass_shown(engine: Engine) -> float:
    """Return the recomputed mass, or the printed one where the formula does not make it."""
    printed = engine.as_printed("gearbox_mass_kg")
    if engine.note("gearbox_mass_kg", "differs") and printed is not None:
        return printed.value
    return gearbox_mass(engine)


def _mark_requirement(axes: Axes, chosen: Comparison) -> None:
    power = chosen.requirement.power / _KW
    for band in chosen.bands:
        axes.plot(
            [power, power],
            [band.low, band.high],
            color=theme.INK,
            lw=5.0 if band.level < 0.9 else 1.6,
            alpha=0.5,
            zorder=4,
        )
    taken = chosen.taken
    if taken is not None:
        label = "this requirement: mass taken, 68 and 95 % of real weights"
        axes.plot([power], [taken.mass], "D", ms=7.0, color=theme.INK, label=label, zorder=5.0)


def _draw_weights(axes: Axes) -> None:
    points = weighed_gearboxes()
    line = refit()
    reach = np.geomspace(points[0].beta, points[-1].beta, 120)
    for level, alpha in ((0.95, 0.13), (0.68, 0.22)):
        limits = np.array([line.band(beta, level) for beta in reach]) * POUND
        label = f"{level:.0%} of new gearboxes"
        axes.fill_between(reach, limits[:, 0], limits[:, 1], color=theme.BLUE, alpha=alpha, lw=0.0, label=label)
    law = f"refit, R² = {line.r_squared:.3f}"
    axes.plot(reach, [line.at(beta) * POUND for beta in reach], color=theme.BLUE, lw=1.5, label=law)
    axes.scatter(
        [point.beta for point in points],
        [point.mass for point in points],
        s=16,
        color=theme.INK,
        zorder=3,
        label="61 real gearboxes",
    )
    _log_axes(axes, "β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15", "gearbox mass [kg]")
    axes.set_xticks([0.6, 1, 2, 5, 10, 20, 50])
    axes.set_yticks([20, 50, 100, 200, 500, 1000, 2000, 5000])
    axes.set_title("Real weights (NASA/TM-2009-215680)")


def _mark_methods(axes: Axes, chosen: Comparison) -> None:
    masses = [estimate.mass for estimate in chosen.estimates if estimate.mass is not None]
    beta = chosen.requirement.beta
    label = f"methods at β = {beta:.3g}: {min(masses):.0f} to {max(masses):.0f} kg"
    axes.plot([beta] * len(masses), masses, "_", ms=9.0, color=theme.ORANGE, zorder=4.0, label=label)


def _draw_scores(axes: Axes, methods: list[Score]) -> None:
    for place, score in enumerate(methods):
        assert score.bias is not None  # the caller leaves the others out
        if score.bias_span is not None:
            axes.plot(score.bias_span, [place, place], color=theme.ORANGE, lw=7.0, alpha=0.35)
        if score.scatter is not None:
            axes.plot([score.bias / score.scatter, score.bias * score.scatter], [place, place], color=theme.INK, lw=1.2)
        axes.plot([score.bias], [place], "o", color=theme.INK, ms=5)
    axes.axvline(1.0, color=theme.BLUE, lw=1.2, zorder=0)
    _log_axes(axes, "estimate over real weight", "")
    axes.set_xticks([0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0])
    axes.set_yticks(range(len(methods)), [f"{score.method.name} ({score.count})" for score in methods], fontsize=7.5)
    axes.set_ylim(len(methods) - 0.5, -0.5)
    axes.set_title("Bias; one standard deviation (line);\nassumed speeds (bar)")


def _log_axes(axes: Axes, x: str, y: str) -> None:
    axes.set_xscale("log")
    if y:
        axes.set_yscale("log")
    axes.set(xlabel=x, ylabel=y)


def _span_text(values: list[float]) -> str:
    low, high = f"{min(values):.3g}", f"{max(values):.3g}"
    return low if low == high else f"{low}–{high}"
