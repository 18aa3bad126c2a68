"""What gearboxes weigh as plain rows, for CSV and JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable

from gearwright.render.tables.csv_text import csv_text
from gearwright.units import RPM
from gearwright.weights import COLUMNS, CheckedEngine, Comparison, StatedMass, gearbox_mass

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


def to_json(value: object) -> str:
    """Return rows or a record as JSON; a computed number that does not exist is null.

    Args:
        value: Of `engine_rows` or `comparison_record`.
    """
    return json.dumps(value, indent=1, ensure_ascii=False, allow_nan=False)


def comparison_record(comparison: Comparison) -> dict[str, object]:
    """Return a comparison with units in its keys, every mass beside its formula and source.

    Args:
        comparison: Of `compare`.
    """
    need = comparison.requirement
    return {
        "requirement": {
            "power_kw": need.power / _KW,
            "engine_rpm": need.engine_speed / RPM,
            "propeller_rpm": need.propeller_speed / RPM,
            "beta": need.beta,
        },
        "methods": [
            {
                "key": estimate.method.key,
                "name": estimate.method.name,
                "mass_kg": estimate.mass,
                "reason": estimate.reason,
                "beyond_range_kg": estimate.beyond,
                "formula": estimate.method.formula,
                "source": estimate.method.source,
                "assumes": estimate.method.assumes,
                "includes": vars(estimate.method.includes),
            }
            for estimate in comparison.estimates
        ],
        "bands": [{"level": band.level, "low_kg": band.low, "high_kg": band.high} for band in comparison.bands],
        "nearest_engines": [f"{engine.series.name} {engine.model}" for engine in comparison.engines],
        "bottom_up": _stated(comparison.bottom_up),
        "stated": _stated(comparison.stated),
        "taken": _stated(comparison.taken),
    }


def _stated(mass: StatedMass | None) -> dict[str, object] | None:
    return None if mass is None else {"mass_kg": mass.mass, "origin": mass.origin, "overridden": mass.overridden}


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
        "engine_mass_least_kg": None if checked.engine_mass is None else checked.engine_mass[0],
        "engine_mass_greatest_kg": None if checked.engine_mass is None else checked.engine_mass[1],
    }
    for column in COLUMNS:
        check = checked.check(column)
        row[f"{column}_printed"] = None if check.printed is None else check.printed.text
        row[f"{column}_computed"] = check.computed
        row[f"{column}_verdict"] = check.verdict.value
        row[f"{column}_reason"] = check.reason
    return row
