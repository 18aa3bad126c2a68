"""Tables as such: records with columns, units and marks, on a page and as CSV text.

It knows no result: what a result shows as tables is in `tables`.
"""

import csv
import io
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal

from gearwright.identity import PartId
from gearwright.units import Origin, marks_at, number_text, origin_of, shown, unit

# ----------------------------------------------------------------------------------------------------------------------
# Tables of records: one mechanism for the terminal, the report and machines.
#
# A column takes header, unit, equation and source from the marks of the record's field (`gearwright.units`), so that
# no unit and no formula is written twice.
# ----------------------------------------------------------------------------------------------------------------------


Mark = Literal["", "given", "estimated"]
"""Where a value comes from: computed, given by the user in place of the computed one, or estimated."""
MARKS: Mapping[Mark, tuple[str, str]] = MappingProxyType(
    {"given": ("*", "given by the user in place of the computed value"), "estimated": ("~", "estimated: not given")}
)
"""Mark -> sign beside the value, and what it says."""
SYMBOLS: Mapping[str, str] = MappingProxyType({
    "teeth": "z", "module": "m_n", "helix_angle": "β", "profile_shift": "x", "tip_alteration": "k",
    "face_width": "b", "pitch_diameter": "d", "mass": "m", "centre_distance": "a_w", "working_pressure_angle": "α_wt",
    "inertia": "I", "speed": "n", "torque": "T", "power": "P", "load_factor": "K_γ", "tangential_force": "F_t",
    "resonance_ratio": "N", "dynamic_factor": "K_V", "relief_term": "B_k", "tip_relief": "C_a",
    "radial_force": "F_r", "axial_force": "F_a", "pitch_line_velocity": "v", "bending_stress": "σ_F",
    "contact_stress": "σ_H", "stiffness": "k", "bending_moment": "M_b", "diameter": "d", "bore": "d_i",
    "length": "L", "pin_force": "F_p", "centrifugal_force": "F_c",
    "peak_over_mean": "F_max/F_m", "peak_force": "F_t,max", "rated_force": "F_t",
    "radius": "r_c", "pin_diameter": "d_p", "plate_thickness": "t",
    "frequency": "f", "bodies": "N", "count": "N",
    "module_bending": "m_n (σ_F)", "module_contact": "m_n (σ_H)", "bending_margin": "margin σ_F",
    "contact_margin": "margin σ_H", "radial": "F_r", "axial": "F_a", "equivalent_load": "P", "dynamic_rating": "C",
    "life": "L_10h", "static_safety": "s_0", "inner_diameter": "d", "outer_diameter": "D", "bending_notch": "K_f",
    "torsion_notch": "K_fs", "fatigue_safety": "n_f", "yield_safety": "n_y", "din743_safety": "S_D", "pressure": "p",
    "allowed_pressure": "p_perm", "critical_speed": "n_crit", "separation_margin": "n_op/n − 1",
})  # fmt: skip
"""Field -> symbol of the trade."""
_HEADERS = {
    "name": "", "power_coefficient": "C_P", "thrust_coefficient": "C_T",
    "windmilling_angle": "idle angle", "windmilling_thrust": "idle C_T",
}  # fmt: skip


@dataclass(frozen=True)
class Column:
    """One field of the records."""

    name: str
    """Name of the field."""
    header: str
    """In words."""
    symbol: str
    """Of the trade; empty if there is none."""
    dimension: str
    """Key of the units, or empty for words and counts."""
    origins: tuple[Origin | None, ...] = ()
    """Equation and source of a computed field, in every row; empty where no value is computed."""

    @property
    def origin(self) -> Origin | None:
        """Equation and source where all rows have the same."""
        return self.origins[0] if len(set(self.origins)) == 1 else None

    @property
    def listed_origins(self) -> tuple[Origin, ...]:
        """Every equation and source of the column, once."""
        return tuple(origin for origin in dict.fromkeys(self.origins) if origin is not None)

    @property
    def unit(self) -> str:
        """Unit in which the column is shown."""
        return unit(self.dimension) if self.dimension else ""

    @property
    def heading(self) -> str:
        """Header with the unit, as files of tables have it."""
        return f"{self.header} [{self.unit}]" if self.unit else self.header


@dataclass(frozen=True)
class Cell:
    """One value of one record."""

    value: Any
    """In the unit that is shown; words, counts and names as they are; None where there is none."""
    text: str
    """As it is read."""
    mark: Mark = ""
    """Where it comes from."""

    @property
    def is_number(self) -> bool:
        """True for what is aligned to the right."""
        return isinstance(self.value, int | float) and not isinstance(self.value, bool)


@dataclass(frozen=True)
class Table:
    """Records as rows of text."""

    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    note: str = ""
    """What the reader must know."""

    @property
    def marks(self) -> tuple[Mark, ...]:
        """Marks that occur, for the legend."""
        return tuple(mark for mark in MARKS if any(cell.mark == mark for row in self.rows for cell in row))

    @property
    def number_columns(self) -> tuple[int, ...]:
        """Places of the columns that hold numbers alone, or nothing, counted from 1."""
        columns = enumerate(zip(*self.rows, strict=True), start=1)
        return tuple(
            place
            for place, cells in columns
            if any(cell.is_number for cell in cells) and all(cell.is_number or not cell.text for cell in cells)
        )


Marking = Callable[[object, str], Mark]
"""Record and field -> mark."""


def _computed(record: object, field: str) -> Mark:
    """Return the mark of a value that is computed: none."""
    return ""


def table(
    title: str, records: Iterable[object], fields: Sequence[str], *, mark: Marking = _computed, note: str = ""
) -> Table:
    """Return the table of some fields of equal records.

    Args:
        title: In words.
        records: Frozen records of one type, or alike in the fields; none at all gives a table without rows and columns.
        fields: Names of the columns, in order.
        mark: Tells where a value comes from.
        note: What the reader must know.
    """
    listed = list(records)
    if not listed:
        return Table(title, (), (), note)
    columns = tuple(column(name, listed) for name in fields)
    rows = tuple(tuple(cell(getattr(record, c.name), c, mark(record, c.name)) for c in columns) for record in listed)
    return Table(title, columns, rows, note)


def column(name: str, records: Sequence[object]) -> Column:
    """Return the column of a field.

    Args:
        name: Of the field or property.
        records: One at least.
    """
    dimension = marks_at(type(records[0]), name).dimension
    origins = tuple(origin_of(record, name) for record in records)
    header, symbol = _HEADERS.get(name, name.replace("_", " ")), SYMBOLS.get(name, "")
    return Column(name, header, symbol, dimension, origins if any(origins) else ())


def cell(value: object, column: Column, mark: Mark = "") -> Cell:
    """Return one value as it is read.

    Args:
        value: In SI.
        column: Its column.
        mark: Where it comes from.
    """
    if isinstance(value, float):
        number = shown(value, column.dimension) if column.dimension else value
        return Cell(number, number_text(value, column.dimension), mark)
    if value is None:
        return Cell(None, "–", mark)
    if isinstance(value, PartId):
        return Cell(str(value), str(value), mark)
    if isinstance(value, tuple):
        parts = [cell(part, column) for part in value]
        return Cell([part.value for part in parts], ", ".join(part.text for part in parts), mark)
    return Cell(value, str(value), mark)


# ----------------------------------------------------------------------------------------------------------------------
# Tables as CSV text that is the same data in every program: numbers stay numbers, and a text is never a formula.
# ----------------------------------------------------------------------------------------------------------------------


_FORMULA = ("=", "+", "-", "@", "\t")
"""What makes spreadsheets compute a cell, or call a program from it."""


def csv_text(heading: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    """Return a table as CSV.

    Args:
        heading: Names of the columns.
        rows: As many cells each.

    Source: OWASP, CSV injection: a leading apostrophe keeps a cell text.

    >>> csv_text(["name", "mass"], [["=1+1", -2.5], ["-3.1", None]])
    "name,mass\\n'=1+1,-2.5\\n-3.1,\\n"
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([_cell(name) for name in heading])
    writer.writerows([_cell(cell) for cell in row] for row in rows)
    return out.getvalue()


def table_csv(made: Table) -> str:
    """Return a table as CSV, in the units that it shows.

    Args:
        made: The table.
    """
    return csv_text([column.heading for column in made.columns], [[cell.value for cell in row] for row in made.rows])


def _cell(cell: object) -> object:
    """Return a cell whose text no program takes for a formula or for the end of a row."""
    if not isinstance(cell, str) or _is_number(cell):
        return cell
    text = cell.replace("\r\n", "\n").replace("\r", "\n")
    return f"'{text}" if text.lstrip().startswith(_FORMULA) else text


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
