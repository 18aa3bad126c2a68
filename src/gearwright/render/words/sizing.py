"""A sizing in words: the headline of a page or report, and the report for the terminal; modes and traces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.base import worst
from gearwright.particulars import Particulars
from gearwright.render.grid import MARKS, Cell, Column, Table
from gearwright.render.tables.checks import check_sentence, factor_tables, influence_tables, method_tables, usual_table
from gearwright.render.tables.sizing import estimated_only, flow_tables, path_table, tables_of
from gearwright.render.tables.weights import summary
from gearwright.render.terminal import Grid
from gearwright.sizing import MeshBeside, MeshInfluences, RatedMesh, Sizing, UsualValue
from gearwright.spec import Design, implied
from gearwright.spec.design import BUILT, CONCEPT, PRELIMINARY, STATIC

if TYPE_CHECKING:
    from gearwright.dynamics import Modes, Trace
    from gearwright.dynamics.sharing import PathShare
    from gearwright.reviews import Review


# ----------------------------------------------------------------------------------------------------------------------
# What a page says first: the verdict of a review with its worst entry, or the worst that a sizing alone knows.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDING = 1e-15
"""Relative residual of an energy balance below which nothing but rounding is left [-]."""
FIRST = (
    f'First sizing by level = "{CONCEPT}", with no housing and no oil in its mass: gearwright size --level'
    f" {PRELIMINARY} counts them, rates gears against fatigue and gives planets bearings."
)
"""What is said of a design that states `level = "concept"`."""
_FEWER = {
    CONCEPT: "",
    PRELIMINARY: f'; level = "{CONCEPT}" is the first sizing without them',
    BUILT: "; shafts with steps, bearings and joints, as [bearings] stand",
}
"""Level -> what a level below leaves out, or this one adds."""


def headline(review: Review) -> str:
    """Return the verdict in one sentence that says no more than its worst entry.

    Args:
        review: Of a design.
    """
    said = said_of(review)
    return f"{review.verdict}: {said}" if review.worst else said


def said_of(review: Review) -> str:
    """Return the worst entry and how many fail, without the verdict.

    Args:
        review: Of a design.
    """
    first = review.worst
    said = f"the worst is {check_sentence(first)}" if first else "nothing is assessed"
    counts = [f"{len(review.failing)} {_fail(len(review.failing))}"]
    beside = {"waived": len(review.waived), "not assessed": len(review.open)}
    return f"{said}; {', '.join(counts + [f'{count} {what}' for what, count in beside.items() if count])}"


def sizing_headline(sizing: Sizing) -> str:
    """Return the worst of what a sizing checks, with what helps where it fails, and who looks at the rest.

    Args:
        sizing: As sized.
    """
    first, left = worst(sizing.checks), sum(check.ratio is None for check in sizing.checks)
    count = len(sizing.checks) - left
    entry = check_sentence(first) if first is not None else "none is assessed"
    failing = sum(check.fails for check in sizing.checks)
    said = f"{failing} of {count} sizing checks {_fail(failing)}" if failing else f"{count} sizing checks pass"
    helps = f"; {first.why}" if first is not None and first.fails and first.why else ""
    unsaid = f"; {left} not assessed" if left else ""
    return f"{said}, the worst: {entry}{helps}{unsaid}; peaks, resonances and lives: gearwright review"


def implied_text(design: Design) -> str:
    """Return the level of a design with what it takes by default at it, or what a stated concept leaves out.

    One sentence.

    Args:
        design: As read.
    """
    taken, stated = implied(design), "level" in design.model_fields_set
    if design.level == CONCEPT:
        asks = f'its gears ask for {STATIC}; without that it is "{PRELIMINARY}", against fatigue'
        return FIRST if stated else f'By default level = "{CONCEPT}": {asks}.'
    sets = [name for name, one in design.planetaries.items() if "planet_bearing" not in one.model_fields_set]
    parts = [f'gears.rating = "{taken["gears.rating"]}"'] if "gears.rating" in taken else []
    parts += [f"bearings of the catalogue in planets of {', '.join(sets)}"] if sets else []
    if not stated:
        taken_level = f'level = "{design.level}"'
        return f"By default {', '.join([taken_level, *parts])}{_FEWER[design.level]}."
    by_default = f"; by default {', '.join(parts)}" if parts else ""
    return f'Level = "{design.level}", as stated{by_default}.'


def _fail(count: int) -> str:
    """Return the verb of so many checks."""
    return "fails" if count == 1 else "fail"


def unneeded_text(name: str) -> str:
    """Return that a waiver is not needed.

    Args:
        name: Of the check.
    """
    return f"The waiver of {name} is not needed: it passes"


def energy_text(residual: float) -> str:
    """Return how well an energy balance closes.

    Args:
        residual: What does not add up, over what goes in [-].

    >>> energy_text(0.0), energy_text(3.2e-7)
    ('to rounding', 'within 3.2e-07')
    """
    return f"within {residual:.1e}" if abs(residual) > ROUNDING else "to rounding"


# ----------------------------------------------------------------------------------------------------------------------
# Words for the terminal: the report of a Sizing, the modes, the summary of a Trace.
# ----------------------------------------------------------------------------------------------------------------------


_ORDER = (
    "passing",
    "losses",
    "margins",
    "speeds",
    "gears",
    "meshes",
    "load_factors",
    "rating",
    "shafts",
    "shaft_sizes",
    "bearings",
    "airscrew_loads",
    "steps",
    "strength",
    "stiffness",
    "bearing_sizes",
    "bearing_oil",
    "joints",
    "carriers",
    "planet_bearings",
    "machines",
    "mass",
    "complete_mass",
    "envelope",
    "turns",
    "places",
    "materials",
    "overrides",
)


def sizing_text(facts: Particulars, review: Review | None = None, *, paths: Sequence[PathShare] = ()) -> RenderableType:
    """Return the report of a sizing for the terminal.

    Args:
        facts: Of the sizing.
        review: Of it; left out: the checks of sizing alone are told, and who looks at the rest.
        paths: Shares of its parallel meshes, if they are to be in it.
    """
    sizing, tables = facts.sizing, tables_of(facts)
    tables["materials"] = estimated_only(tables["materials"])
    verdict = sizing_headline(sizing) if review is None else headline(review)
    said = (summary(facts), f"{verdict}.", implied_text(sizing.design), *facts.remarks)
    head = [Text(words) for words in said if words]
    parts: list[RenderableType] = [Text(sizing.design.name, style="bold"), *head, Text()]
    parts += [table_text(table) for table in (*flow_tables(facts.branches), path_table(paths)) if table.rows]
    parts += [table_text(tables[name]) for name in _ORDER if tables[name].rows]
    return Group(*parts)


def factors_text(rated: Iterable[RatedMesh], usual: Sequence[UsualValue]) -> RenderableType:
    """Return every factor of every mesh whose method has some beside stresses and margins.

    Args:
        rated: From `rated_factors`.
        usual: From `usual_values`, of the same sizing.
    """
    tables = [usual_table(usual)] if usual else []
    return Group(*map(table_text, [*tables, *factor_tables(rated).values()]))


def influences_text(meshes: Iterable[MeshInfluences]) -> RenderableType:
    """Return what moves the margins of every mesh.

    Args:
        meshes: From `influences`.
    """
    return Group(*map(table_text, influence_tables(meshes).values()))


def methods_text(meshes: Iterable[MeshBeside]) -> RenderableType:
    """Return every cylindrical mesh by every method, factor by factor.

    Args:
        meshes: From `methods_beside`.
    """
    return Group(*map(table_text, method_tables(meshes).values()))


def modes_text(modes: Modes, *, case: str = "", maximum: int = 30) -> RenderableType:
    """Return the natural frequencies for the terminal.

    Args:
        modes: As found.
        case: Load case, if they are of a design.
        maximum: Modes that are listed at most.
    """
    from gearwright.render.tables.dynamics import mode_table

    return table_text(mode_table(modes, case=case, maximum=maximum))


def trace_text(trace: Trace, sizing: Sizing | None = None, *, case: str = "") -> RenderableType:
    """Return mean, least, greatest, rms and peak-to-peak of every line, and the energy balance, for the terminal.

    Args:
        trace: As simulated.
        sizing: That it is a run of: with it, peaks stand beside the rated loads.
        case: Load case, if it is of a design.
    """
    from gearwright.dynamics.motion import Error
    from gearwright.render.tables.dynamics import dynamic_table, energy_table, motion_tables

    head = Text(
        f"{f'Case {case}. ' if case else ''}{trace.duration:.4g} s in steps of {trace.step:.3g} s, {trace.method};"
        f" {Error(trace.error, trace.rms_error).words()}"
    )
    notes = [Text(note, style="yellow") for note in trace.notes]
    beside = [dynamic_table(sizing, trace)] if sizing is not None and trace.force.bins else []
    tables = (*motion_tables(trace), energy_table(trace), *beside)
    return Group(head, *notes, Text(), *map(table_text, tables))


def table_text(table: Table) -> RenderableType:
    """Return a table for the terminal, in several blocks where it is too narrow for all columns.

    Args:
        table: The table.
    """
    grid = Grid(table.title, names=_names(table))
    for k, column in enumerate(table.columns):
        right = _is_number(table, k)
        grid.add_column(_head(column), justify="right" if right else "left", no_wrap=right)
    for row in table.rows:
        grid.add_row(*map(_shown, row))
    legend = " ".join(f"{MARKS[mark][0]} {MARKS[mark][1]}." for mark in table.marks)
    below = "\n".join(filter(None, [table.note, legend]))
    return Group(grid, Text(f"{below}\n", style="dim")) if below else grid


def _names(table: Table) -> int:
    """Return how many columns name a row: the first, or where it repeats itself all words before the first number."""
    if len({row[0].text for row in table.rows}) == len(table.rows):
        return 1
    return max(next((k for k in range(len(table.columns)) if _is_number(table, k)), 1), 1)


def _is_number(table: Table, k: int) -> bool:
    return any(row[k].is_number for row in table.rows)


def _head(column: Column) -> str:
    return f"{column.symbol or column.header}\n{column.unit}"


def _shown(cell: Cell) -> Text:
    sign = MARKS[cell.mark][0] if cell.mark else ""
    return Text(cell.text + sign)
