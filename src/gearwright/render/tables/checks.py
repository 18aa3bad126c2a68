"""Checks as rows of a table, every factor of a rated mesh, methods side by side, what moves the margins."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace
from typing import Annotated, Any

import numpy as np

from gearwright.base import Check, Quantity, Status, digits_apart, margin_text, shown, unit, written
from gearwright.render.grid import Cell, Column, Table, table
from gearwright.sizing import Beside, Influence, MeshBeside, MeshInfluences, RatedMesh, UsualValue
from gearwright.sizing.rating import METHODS, Factor

# ----------------------------------------------------------------------------------------------------------------------
# Checks as rows of a table, in the units of the trade, and as sentences.
# ----------------------------------------------------------------------------------------------------------------------


JUST_ENOUGH = (
    "Margin: the factor by which loads may grow; 1 is just enough. Of a safety value over limit, of a stress limit over"
    " value, of a bearing's life the root of life over limit (p = 3, rollers 10/3). What no load moves, such as room,"
    " passes or fails with its distance. Limits of stresses include the asked factor."
)
COLUMNS = ("part", "check", "case", "value", "limit", "unit", "margin", "source")
"""Of a check that is assessed."""


@dataclass(frozen=True)
class Judged:
    """A check as it is shown."""

    part: str
    check: str
    """Mode, symbol and place."""
    case: str
    """Load case that governs; empty where no single one does."""
    value: float | None
    """As computed, in the unit."""
    limit: float | None
    """What is allowed, in the unit."""
    unit: str
    """Empty for a ratio."""
    margin: Annotated[float | None, Quantity("ratio")]
    """1 is just enough [-]."""
    source: str
    """Equation or clause."""
    status: str
    """passes, fails, waived or not assessed."""
    why: str
    """Why it is waived or not assessed, or what else to know, such as what would help."""


def judged(checks: Iterable[Check]) -> tuple[Judged, ...]:
    """Return checks as they are shown, in the order in which they come.

    Args:
        checks: Of one gearbox.
    """
    return tuple(
        Judged(
            part=str(check.part),
            check=check.what,
            case=check.case,
            value=_shown(check.value, check.dimension),
            limit=_shown(check.limit, check.dimension),
            unit=unit(check.dimension),
            margin=check.margin,
            source=check.clause,
            status="waived" if check.waiver else str(check.status),
            why=check.waiver or check.why,
        )
        for check in checks
    )


def review_tables(checks: Iterable[Check]) -> tuple[Table, ...]:
    """Return what is assessed, the worst first, remarks on it, what is waived or not assessed, each as a table.

    Args:
        checks: Of one gearbox, in the order of `worst_first`.
    """
    rows = judged(checks)
    assessed = [row for row in rows if row.margin is not None]
    waived = [row for row in rows if row.status == "waived"]
    told = [row for row in assessed if row.why and row.status != "waived"]
    return (
        table("Checks, worst first", assessed, ("status", *COLUMNS), note=JUST_ENOUGH),
        table("Remarks", told, ("part", "check", "why")),
        table("Waived by the design", waived, ("part", "check", "why")),
        table("Not assessed", [row for row in rows if row.margin is None], ("part", "check", "why")),
    )


def _shown(value: float | None, dimension: str) -> float | None:
    return None if value is None else shown(value, dimension)


def check_sentence(check: Check) -> str:
    """Return part, check, value, limit, source, case and margin.

    Args:
        check: One that is assessed.
    """
    (row,) = judged([check])
    pair = row.value or 0.0, row.limit or 0.0
    digits = digits_apart(*pair) if check.status is Status.FAILS else 4
    value, limit = (f"{written(number, digits)} {row.unit}".rstrip() for number in pair)
    case = f", case {row.case}" if row.case else ""
    margin = margin_text(row.margin or 0.0)
    return f"{row.part}: {row.check} {value}, limit {limit} ({row.source}){case}: margin {margin}"


# ----------------------------------------------------------------------------------------------------------------------
# Every factor of a rated mesh: symbol, value on pinion and wheel, unit and clause, as a rating program prints it.
# ----------------------------------------------------------------------------------------------------------------------


_FACTOR_NOTE = (
    "In the heaviest case over the whole life, application factor included; a single value holds for both gears."
    " The safeties under all cases stand in the table of checks. At a limit: the standard holds the factor there."
)
_USUAL = "Open in the design. Mass: by how much its gears would weigh more otherwise, with their teeth as they are."


@dataclass(frozen=True)
class FactorView:
    """One line: a quantity of both gears, or of the mesh."""

    chapter: str
    quantity: str
    """In words."""
    equation: str
    """Symbol, or the equation that makes it."""
    pinion: str
    """First gear, or the mesh."""
    wheel: str
    """Second gear; empty where there is one value."""
    unit: str
    limit: str
    """Limit of the standard at which it stands."""
    clause: str


def factor_tables(rated: Iterable[RatedMesh]) -> dict[str, Table]:
    """Return mesh -> table of the factors of its rating.

    Args:
        rated: Meshes, from `rated_factors`.
    """
    return {one.mesh.name: _factor_table(one) for one in rated}


def usual_table(usual: Sequence[UsualValue]) -> Table:
    """Return the load factors, reliefs and classes that a design leaves open, and what others would weigh.

    Args:
        usual: From `usual_values`.
    """
    fields = ("stage", "quantity", "value", "source", "otherwise", "mass")
    return table("Usual values taken", usual, fields, note=_USUAL)


def _factor_table(rated: RatedMesh) -> Table:
    mesh, method = rated.mesh, METHODS[rated.mesh.rating.method]
    views = [_view(row) for row in rated.factors]
    chapters = ["", *(view.chapter for view in views)]
    views = [
        replace(view, chapter="") if view.chapter == last else view for view, last in zip(views, chapters, strict=False)
    ]
    title = f"Rating of {mesh.name}: {mesh.gears[0]} and {mesh.gears[1]}, {method.edition}, case {mesh.rating.case}"
    return table(title, views, tuple(field.name for field in fields(FactorView)), note=_FACTOR_NOTE)


def _view(row: Factor) -> FactorView:
    values = [_read(value, row.dimension) for value in row.values]
    if len(values) > 2:
        values = [", ".join(values)]
    pinion, wheel = (*values, "")[:2]
    return FactorView(
        row.chapter, row.quantity, row.equation, pinion, wheel, unit(row.dimension), row.limit, row.clause
    )


def _read(value: Any, dimension: str) -> str:
    return str(value) if isinstance(value, int) else written(shown(float(np.asarray(value)), dimension), 5)


# ----------------------------------------------------------------------------------------------------------------------
# A mesh by every method, factor by factor: what differs, and why.
# ----------------------------------------------------------------------------------------------------------------------


_METHOD_NOTE = (
    "Teeth, module, width and loads of the design; steel and making of each method's own rules. In the heaviest case,"
    " pinion / wheel; one value holds for both. A dash: the method has no such factor. Margins: over the safeties that"
    " the method's rules ask."
)


def method_tables(meshes: Iterable[MeshBeside]) -> dict[str, Table]:
    """Return mesh -> table of its factors by every method.

    Args:
        meshes: From `methods_beside`.
    """
    return {mesh.mesh: _method_table(mesh) for mesh in meshes}


def _method_table(mesh: MeshBeside) -> Table:
    columns = [Column("aspect", "", "", ""), *(Column(name, name, "", "") for name in mesh.margins)]
    columns += [Column("unit", "unit", "", ""), Column("why", "why they differ", "", "")]
    rows = [_method_row(line, tuple(mesh.margins)) for line in mesh.rows]
    for place, words in enumerate(("margin of flanks", "margin of roots")):
        cells = [_told_number(margin_text(margin[place], 4), margin[place]) for margin in mesh.margins.values()]
        rows.append((_words(words), *cells, _words(""), _words("")))
    left = "".join(f" Not by {METHODS[name].edition}: {why}." for name, why in mesh.refused.items())
    return Table(f"Rating of {mesh.mesh} by every method", tuple(columns), tuple(rows), _METHOD_NOTE + left)


def _method_row(line: Beside, methods: tuple[str, ...]) -> tuple[Cell, ...]:
    cells = [_values(line.values.get(name, ()), line.dimension) for name in methods]
    return (_words(line.aspect), *cells, _words(unit(line.dimension)), _words(line.why))


def _values(values: tuple[float, ...], dimension: str) -> Cell:
    if not values:
        return _words("–")
    numbers = [shown(value, dimension) for value in values]
    same = all(math.isclose(number, numbers[0], rel_tol=1e-9) for number in numbers)
    texts = [written(number) for number in (numbers[:1] if same else numbers)]
    return _told_number(" / ".join(texts), numbers[0] if same else None)


def _told_number(text: str, value: float | None) -> Cell:
    return Cell(text if value is None else value, text)


def _words(text: str) -> Cell:
    return Cell(text, text)


# ----------------------------------------------------------------------------------------------------------------------
# What moves the margins of a mesh, and what would raise the worst to a wish.
# ----------------------------------------------------------------------------------------------------------------------


_INFLUENCE_NOTE = (
    "%/%: by how many per cent a safety grows for one per cent more of the value, ∂ ln S/∂ ln x; teeth and all else"
    " kept, the centre distance follows module and helix. The last column: where the worst margin is the wished one; a"
    " dash: not within a factor of three."
)


def influence_tables(meshes: Iterable[MeshInfluences]) -> dict[str, Table]:
    """Return mesh -> table of what moves its margins.

    Args:
        meshes: From `influences`.
    """
    return {mesh.mesh: _influence_table(mesh) for mesh in meshes}


def _influence_table(mesh: MeshInfluences) -> Table:
    heads = ("", "as it is", "unit", "S_H, %/%", "S_F, %/%", f"margin {mesh.wish:g}")
    title = f"What moves {mesh.mesh} ({mesh.method}): worst margin {margin_text(mesh.margin, 4)}"
    columns = tuple(Column(head, head, "", "") for head in heads)
    return Table(title, columns, tuple(_influence_row(row) for row in mesh.rows), _INFLUENCE_NOTE)


def _influence_row(row: Influence) -> tuple[Cell, ...]:
    value, wanted = shown(row.value, row.dimension), row.wanted
    aim = Cell(None, "–") if wanted is None else _number(shown(wanted, row.dimension))
    slopes = (Cell(slope, f"{round(slope, 3) + 0.0:+.3f}".replace("-", "−")) for slope in (row.flank, row.root))
    return (Cell(row.handle, row.handle), _number(value), Cell(unit(row.dimension), unit(row.dimension)), *slopes, aim)


def _number(value: float) -> Cell:
    return Cell(value, written(value))
