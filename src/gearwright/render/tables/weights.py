"""What gearboxes weigh: tables for the terminal, sentences about a sizing, rows for CSV."""

from collections.abc import Iterable

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.base import RPM, text
from gearwright.catalogue import Engine
from gearwright.particulars import Particulars
from gearwright.render.grid import csv_text
from gearwright.render.tables.sizing import motor_rows, with_band
from gearwright.render.terminal import Grid
from gearwright.sizing import Sizing
from gearwright.sizing.mass import band_of, requirement_of
from gearwright.spec.design import CONCEPT, PRELIMINARY
from gearwright.study import Table
from gearwright.weights import (
    COLUMNS,
    CheckedEngine,
    Comparison,
    Coverage,
    Estimate,
    Requirement,
    Score,
    StatedMass,
    corners,
    gearbox_mass,
    left_out_scatter,
    middle,
)

# ----------------------------------------------------------------------------------------------------------------------
# Tables of what gearboxes weigh, for the terminal.
# ----------------------------------------------------------------------------------------------------------------------


_KW = 1e3
_MARKS = {"included": "yes", "left out": "no", "not stated": "not stated"}
_SIGNS = {"included": "✓", "left out": "–", "not stated": "?"}
_SIGN_KEY = "H housing, L lubrication, S propeller shaft, A accessories: ✓ in it, – left out, ? not stated"
WIDE = 130
"""Width of a terminal from which sources and every column of the engine tables are shown [characters]."""
_BRIEF = ("gearbox_mass_kg", "gearbox_kw_kg", "torque_nm_kg")


def comparison_table(comparison: Comparison, *, width: int = WIDE) -> RenderableType:
    """Return every method side by side with the band, the mass that is taken and the engines that are alike.

    Args:
        comparison: Of `compare`.
        width: Of the terminal [characters].
    """
    return Group(
        _methods(comparison, width),
        Text(spread_text(comparison) + "\n"),
        _engines_alike(comparison.engines),
        Text(taken_text(comparison)),
    )


def engine_table(rows: Iterable[CheckedEngine], *, width: int = WIDE) -> Grid:
    """Return the engines as printed, with the flagged numbers marked.

    Args:
        rows: Checked rows of the catalogue.
        width: Of the terminal [characters]; a narrow one shows the columns of the gearbox.
    """
    shown = list(rows)
    columns = tuple(COLUMNS) if width >= WIDE else _BRIEF
    table = Grid(f"{len(shown)} engines (Pulvirenti 2023, tables 1.3-1.15; * flagged)")
    for heading in ("series", "model", "kW", "rpm\nin", "rpm\nout"):
        table.add_column(heading, justify="left" if heading in ("series", "model") else "right", no_wrap=True)
    for symbol, unit, _ in (COLUMNS[column] for column in columns):
        table.add_column(f"{symbol}\n{unit}", justify="right", no_wrap=True)
    for checked in shown:
        table.add_row(*_identity(checked.engine), *(_printed(checked, column) for column in columns))
    return table


def note_table(rows: Iterable[CheckedEngine]) -> Grid:
    """Return the reasons of everything that is flagged or doubtful.

    Args:
        rows: Checked rows of the catalogue.
    """
    table = Grid("Flagged")
    for heading in ("series", "model", "column", "verdict", "reason"):
        table.add_column(heading)
    notes = dict.fromkeys(note for row in rows for note in row.engine.notes)
    for note in notes:
        symbol = COLUMNS[note.column][0] if note.column in COLUMNS else note.column
        table.add_row(note.series, note.model, symbol, note.verdict, note.reason)
    return table


def score_table(ranked: Iterable[Score]) -> Grid:
    """Return bias and scatter of every method against the 61 real weights.

    Args:
        ranked: Of `scores`.
    """
    table = Grid("Against 61 real weights (NASA/TM-2009-215680)", caption=score_assumption())
    for heading in ("method", "in range", "bias", "scatter 1σ", "over assumed speeds"):
        table.add_column(heading, justify="left" if heading == "method" else "right")
    for score in ranked:
        table.add_row(score.method.name, str(score.count), *score_cells(score))
    return table


def score_cells(score: Score) -> tuple[str, str, str]:
    """Return bias, scatter and span of the bias as a reader sees them.

    Args:
        score: Of `scores`.
    """
    bias = "none in range" if score.bias is None else f"{100.0 * (score.bias - 1.0):+.0f} %"
    scatter = "" if score.scatter is None else f"× {score.scatter:.2f}"
    if score.bias_span is None:
        return bias, scatter, "partly out of range"
    if score.needs_only_beta:
        return bias, scatter, "exact, β only"
    low, high = (100.0 * (end - 1.0) for end in score.bias_span)
    return bias, scatter, f"{low:+.0f} to {high:+.0f} %"


def score_assumption() -> str:
    """Return in one sentence what the scores assume."""
    centre, edges = middle(), corners()
    ratios, speeds = [edge.ratio for edge in edges], [edge.propeller_speed / RPM for edge in edges]
    centre_rpm = centre.propeller_speed / RPM
    return (
        "The weights give β only: a band of plausibility, no validation. "
        f"Assumed for all: ratio {centre.ratio:.3g}, output {centre_rpm:.3g} rpm; "
        f"last column: ratio {min(ratios):.3g} to {max(ratios):.3g}, {min(speeds):.0f} to {max(speeds):.0f} rpm. "
        f"The refit has seen these weights; predicting each from the others it scatters by {left_out_scatter():.3f}."
    )


def coverage_text(covered: Coverage) -> str:
    """Return what a method contains in a few words.

    Args:
        covered: Of a method.
    """
    names = (("housing", covered.housing), ("lubrication", covered.lubrication), ("shaft", covered.rotor_shaft))
    stated = [
        f"{name} {_MARKS[state]}"
        for name, state in (*names, ("accessories", covered.accessories))
        if state != "not stated"
    ]
    silent = [name for name, state in (*names, ("accessories", covered.accessories)) if state == "not stated"]
    return ", ".join([*stated, *([f"not stated: {', '.join(silent)}"] if silent else [])])


def mass_text(estimate: Estimate) -> str:
    """Return the mass of an estimate, or that the method does not apply.

    Args:
        estimate: Of `estimate`.
    """
    return "out of range" if estimate.mass is None else f"{estimate.mass:.1f} kg"


def remark(estimate: Estimate) -> str:
    """Return why there is no mass, or what the method assumes.

    Args:
        estimate: Of `estimate`.
    """
    beyond = f"; the bare formula gives {estimate.beyond:.1f} kg" if estimate.beyond is not None else ""
    return estimate.reason + beyond if estimate.mass is None else estimate.method.assumes


def requirement_text(need: Requirement) -> str:
    """Return power, speeds, ratio and output torque in one line.

    Args:
        need: Power and speeds.
    """
    speeds = f"{need.engine_speed / RPM:.0f} to {need.propeller_speed / RPM:.0f} rpm"
    return f"{text(need.power, 'power')}, {speeds} (ratio {need.ratio:.2f}, output {need.output_torque:.0f} N m)"


def _methods(comparison: Comparison, width: int) -> Grid:
    table = Grid(f"Gearbox mass: {requirement_text(comparison.requirement)}", caption=_SIGN_KEY)
    table.add_column("method", no_wrap=True)
    table.add_column("mass", justify="right", no_wrap=True)
    for sign in "HLSA":
        table.add_column(sign, no_wrap=True)
    table.add_column("assumed, or why there is no mass")
    if width >= WIDE:
        table.add_column("source")
    for estimate in comparison.estimates:
        source = [estimate.method.source] if width >= WIDE else []
        table.add_row(
            estimate.method.name, mass_text(estimate), *_signs(estimate.method.includes), remark(estimate), *source
        )
    for stated in (comparison.bottom_up, comparison.stated):
        if stated is not None:
            table.add_row(given_name(stated), f"{stated.mass:.1f} kg", "", "", "", "", stated.origin, style="bold")
    return table


def _signs(covered: Coverage) -> tuple[str, str, str, str]:
    parts = (covered.housing, covered.lubrication, covered.rotor_shaft, covered.accessories)
    housing, lubrication, shaft, accessories = (_SIGNS[part] for part in parts)
    return housing, lubrication, shaft, accessories


def given_name(stated: StatedMass) -> str:
    """Return how a mass that no method made is called.

    Args:
        stated: The design's own mass or the user's.
    """
    return "Your own mass (override)" if stated.overridden else "This design"


def spread_text(comparison: Comparison) -> str:
    """Return span of the methods and bands of the real weights, a sentence a line.

    Args:
        comparison: Of `compare`.
    """
    low, high = comparison.spread
    lines = [f"The methods that apply span {low:.3g} to {high:.3g} kg, a factor of {high / low:.1f}."]
    lines += [
        f"{band.level:.0%} of real gearboxes of this β weigh {band.low:.0f} to {band.high:.0f} kg."
        for band in comparison.bands
    ]
    if not comparison.bands:
        lines.append("No band: β lies outside the 61 real weights.")
    return "\n".join(lines)


def taken_text(comparison: Comparison) -> str:
    """Return the mass that later results use, with its origin.

    Args:
        comparison: Of `compare`.
    """
    if comparison.taken is None:
        return "No mass is taken: outside the real weights, and neither a design nor your own mass was given."
    mark = "override, " if comparison.taken.overridden else ""
    return f"Taken from here on: {comparison.taken.mass:.1f} kg ({mark}{comparison.taken.origin})."


def _engines_alike(rows: tuple[Engine, ...]) -> Grid:
    table = Grid("Most alike in the catalogue; masses by NASA'15")
    for heading in ("series", "model", "kW", "rpm in", "rpm out", "m_GB, kg"):
        table.add_column(heading, justify="left" if heading in ("series", "model") else "right")
    for row in rows:
        table.add_row(*_identity(row), f"{gearbox_mass(row):.1f}")
    return table


def _identity(engine: Engine) -> tuple[str, str, str, str, str]:
    fast, slow = (f"{speed / RPM:.0f}" for speed in (engine.engine_speed, engine.propeller_speed))
    return engine.series.name, engine.model, f"{engine.power / _KW:g}", fast, slow


def _printed(row: CheckedEngine, column: str) -> str:
    check = row.check(column)
    mark = "*" if check in row.flagged else ""
    return "" if check.printed is None else check.printed.text + mark


# ----------------------------------------------------------------------------------------------------------------------
# What gearboxes weigh, in words: the train by its groups, everything with its band, and beside real gearboxes.
# ----------------------------------------------------------------------------------------------------------------------


_ROWS = ("complete_mass.low", "complete_mass.high")


def train_mass(facts: Particulars) -> str:
    """Return the mass of the train as sized with its groups, which add up to it unless it is given.

    Args:
        facts: Of a sizing.
    """
    sizing, groups = facts.sizing, facts.mass_groups
    discs = {} if sizing.level in (CONCEPT, PRELIMINARY) else {"gears": "gears as discs of their pitch circles"}
    parts = ", ".join(f"{discs.get(group, group)} {text(mass, 'mass')}" for group, mass in groups.items())
    if "gearbox.mass" in sizing.given:
        return f"{text(sizing.mass, 'mass')}, given, in place of the {text(sizing.parts_mass, 'mass')} of {parts}"
    return f"{text(sizing.mass, 'mass')} ({parts})"


def complete_words(facts: Particulars) -> str:
    """Return the complete mass with its band, nothing at level ``concept`` or where a mass is given.

    Args:
        facts: Of a sizing.
    """
    if facts.sizing.level == CONCEPT or "gearbox.mass" in facts.sizing.given:
        return ""
    return with_band(facts.complete)


def summary(facts: Particulars) -> str:
    """Return mass and power density in a few sentences; above level ``concept`` the complete mass comes first.

    Args:
        facts: Of a sizing.
    """
    sizing, complete = facts.sizing, complete_words(facts)
    turning = 0.0 if "planet bearings" in facts.mass_groups else sizing.planet_bearing_mass
    motors = {name.capitalize(): mass for name, mass in motor_rows(sizing)}
    beside = {"Bearings": sizing.bearing_mass + turning, **motors}
    told = "".join(f" {what} {text(mass, 'mass')}." for what, mass in beside.items() if mass)
    first = f"Complete mass {complete}. Train as sized " if complete else ""
    return f"{first}{train_mass(facts)}, {text(sizing.power_density, 'specific_power')}.{told}"


def beside_statistics(table: Table, sizing: Sizing) -> str:
    """Return what 61 real gearboxes say of a comparison's power and speeds, and which designs do not meet their band.

    Args:
        table: Of designs with their complete masses.
        sizing: Any of them.
    """
    need = requirement_of(sizing)
    found = None if need is None else band_of(need)
    if found is None or any(name not in table.results for name in _ROWS):
        return ""
    _, low, high = found
    limits = {row.design: [row.number(name) for name in _ROWS] for row in table.good}
    lighter = [name for name, (_, most) in limits.items() if most < low]
    heavier = [name for name, (least, _) in limits.items() if least > high]
    shown = [text(value, "mass", 3) for value in found]
    words = [f"61 real gearboxes: {shown[0]}, 68 % from {shown[1]} to {shown[2]}."]
    if lighter:
        words.append(f"Sums of parts below that: {', '.join(lighter)}; margins below 1 are part of the reason.")
    if heavier:
        words.append(f"Sums of parts above that: {', '.join(heavier)}.")
    return " ".join(words)


# ----------------------------------------------------------------------------------------------------------------------
# What gearboxes weigh as plain rows, for CSV.
# ----------------------------------------------------------------------------------------------------------------------


Row = dict[str, str | float | int | None]


def engine_rows(rows: Iterable[CheckedEngine]) -> list[Row]:
    """Return one flat row per engine: inputs, and each column printed, computed and judged.

    Args:
        rows: Checked rows of the catalogue.
    """
    return [_engine_row(row) for row in rows]


def to_csv(rows: list[Row]) -> str:
    """Return rows as CSV with a heading.

    Args:
        rows: Of equal keys.
    """
    return csv_text(rows[0], (row.values() for row in rows))


def _engine_row(checked: CheckedEngine) -> Row:
    engine = checked.engine
    row: Row = {
        "table": engine.series.table,
        "series": engine.series.name,
        "manufacturer": engine.series.manufacturer,
        "kind": engine.series.kind,
        "model": engine.model,
        "power_kw": engine.power / _KW,
        "engine_rpm": round(engine.engine_speed / RPM, 6),
        "engine_rpm_rule": engine.series.reason,
        "propeller_rpm": round(engine.propeller_speed / RPM, 6),
        "nasa15_mass_kg": gearbox_mass(engine),
        "engine_mass_minimum_kg": None if checked.engine_mass is None else checked.engine_mass[0],
        "engine_mass_maximum_kg": None if checked.engine_mass is None else checked.engine_mass[1],
    }
    for column in COLUMNS:
        check = checked.check(column)
        row[f"{column}_printed"] = None if check.printed is None else check.printed.text
        row[f"{column}_computed"] = check.computed
        row[f"{column}_verdict"] = check.verdict.value
        row[f"{column}_reason"] = check.reason
    return row
