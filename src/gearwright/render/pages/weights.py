"""What gearboxes weigh as one self-contained HTML page: methods, band, figures, formulas, the thesis's tables."""

from __future__ import annotations

import io
from base64 import b64encode
from collections import Counter

from matplotlib import rc_context
from matplotlib.figure import Figure

from gearwright.catalogue import Engine, Series, all_series
from gearwright.render.figures.weights import figure_densities, figure_mass_over_power, figure_methods
from gearwright.render.style.templates import environment
from gearwright.render.tables import weights
from gearwright.units import RPM, text
from gearwright.weights import (
    COLUMNS,
    Check,
    CheckedEngine,
    Comparison,
    Estimate,
    Range,
    Score,
    Verdict,
    checked_engines,
    gearbox_mass,
    scores,
)

_SHORT = {Verdict.AGREES: "agrees", Verdict.ROUNDED: "rounding", Verdict.BLANK: "not printed"}
_KINDS = {Verdict.AGREES: "agrees", Verdict.ROUNDED: "rounded", Verdict.BLANK: "blank"}
_Cells = dict[str, object]


def weights_page(found: Comparison) -> str:
    """Return the whole page; it makes no request to anywhere.

    Args:
        found: Of `compare`.
    """
    return environment().get_template("weights_page.html.j2").render(_context(found))


def _context(found: Comparison) -> _Cells:
    given = [one for one in (found.bottom_up, found.stated) if one is not None]
    return {
        "requirement": weights.requirement_text(found.requirement),
        "taken": weights.taken_text(found),
        "spread": weights.spread_text(found).splitlines(),
        "estimates": [_estimate(estimate) for estimate in found.estimates],
        "given": [
            {"name": weights.given_name(one), "mass": f"{one.mass:.1f} kg", "origin": one.origin} for one in given
        ],
        "alike": [_alike(engine) for engine in found.engines],
        "scores": [_score(score) for score in scores()],
        "assumption": weights.score_assumption(),
        "columns": [{"key": key, "symbol": s, "unit": u, "formula": f} for key, (s, u, f) in COLUMNS.items()],
        "tables": [_table(one) for one in all_series()],
        "verdict_count": _verdict_count(),
        "figures": {
            "power": _svg(figure_mass_over_power(found), "power"),
            "densities": _svg(figure_densities(), "densities"),
            "methods": _svg(figure_methods(found), "methods"),
        },
    }


def _estimate(one: Estimate) -> _Cells:
    method = one.method
    return {
        "key": method.key,
        "name": method.name,
        "mass": weights.mass_text(one),
        "none": one.mass is None,
        "covered": weights.coverage_text(method.includes),
        "remark": weights.remark(one),
        "formula": method.formula,
        "source": method.source,
        "basis": method.basis,
        "assumes": method.assumes,
        "ranges": [_range(limit) for limit in method.ranges],
    }


def _range(limit: Range) -> str:
    dimension = "power" if limit.quantity == "power" else "number"
    return f"{limit.quantity} {text(limit.low, dimension)} to {text(limit.high, dimension)} ({limit.reason})"


def _alike(one: Engine) -> _Cells:
    return {
        "table": one.series.table,
        "series": one.series.name,
        "model": one.model,
        "power": f"{one.power / 1e3:g}",
        "fast": f"{one.engine_speed / RPM:.0f}",
        "slow": f"{one.propeller_speed / RPM:.0f}",
        "mass": f"{gearbox_mass(one):.1f}",
    }


def _score(one: Score) -> _Cells:
    return {"key": one.method.key, "name": one.method.name, "count": one.count, "cells": weights.score_cells(one)}


def _table(series: Series) -> _Cells:
    rows = [engine for engine in checked_engines() if engine.engine.series is series]
    unit = "times the propeller speed" if series.rule == "ratio" else "rpm"
    notes = dict.fromkeys(note for row in rows for note in row.engine.notes)
    return {
        "number": series.table,
        "name": series.name,
        "manufacturer": series.manufacturer,
        "kind": series.kind,
        "rule": f"{series.value:g} {unit}; {series.reason}",
        "rows": [_row(row) for row in rows],
        "notes": [
            {
                "model": "every model" if note.model == "*" else note.model,
                "column": COLUMNS[note.column][0] if note.column in COLUMNS else note.column,
                "verdict": note.verdict,
                "reason": note.reason,
            }
            for note in notes
        ],
    }


def _row(one: CheckedEngine) -> _Cells:
    power, slow = one.engine.as_printed("power_kw"), one.engine.as_printed("propeller_rpm")
    return {
        "model": one.engine.model,
        "power": power.text if power else "",
        "slow": slow.text if slow else "",
        "cells": [_cell(check) for check in one.checks],
    }


def _cell(check: Check) -> _Cells:
    digits = 2 if check.printed is None else len(check.printed.text.partition(".")[2]) + 1
    return {
        "printed": check.printed.text if check.printed else "",
        "computed": "" if check.computed is None else f"{check.computed:.{digits}f}",
        "difference": "" if check.difference is None else f"{check.difference:+.{digits}f}",
        "verdict": check.verdict.value,
        "short": _SHORT.get(check.verdict, check.verdict.value),
        "kind": _KINDS.get(check.verdict, "flagged"),
        "reason": check.reason,
    }


def _verdict_count() -> str:
    counts = Counter(check.verdict for engine in checked_engines() for check in engine.checks)
    total = sum(counts.values()) - counts[Verdict.BLANK]
    parts = [f"{counts[one]} {one.value}" for one in Verdict if counts[one] and one is not Verdict.BLANK]
    return f"Of {total} printed numbers: {', '.join(parts)}."


def _svg(figure: Figure, name: str) -> str:
    """Return a figure as the address of an SVG image: apart from the page's ids, and the same at every run."""
    out = io.BytesIO()
    with rc_context({"svg.hashsalt": name}):
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    return f"data:image/svg+xml;base64,{b64encode(out.getvalue()).decode('ascii')}"
