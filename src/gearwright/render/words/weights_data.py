"""What gearboxes weigh as plain rows, for CSV."""

from __future__ import annotations

from collections.abc import Iterable

from gearwright.render.grid.csv_text import csv_text
from gearwright.units import RPM
from gearwright.weights import COLUMNS, CheckedEngine, gearbox_mass

_KW = 1e3
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
