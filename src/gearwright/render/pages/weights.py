"""What gearboxes weigh as one self-contained HTML page: methods, band, figures, formulas, the thesis's tables."""

from collections import Counter
from collections.abc import Iterator

from markupsafe import Markup

from gearwright.base import RPM, Origin, text
from gearwright.catalogue import Engine, Series, all_series
from gearwright.render.figures.masses import figure_densities, figure_mass_over_power, figure_methods
from gearwright.render.pages.page import (
    Number,
    Page,
    PageFigure,
    Section,
    Tone,
    Verdict as Judged,
    environment,
    figure,
    quantity,
    set_page,
)
from gearwright.render.tables import weights
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
_PARTS = {
    "mass": "What it will weigh",
    "engines_alike": "Engines most alike",
    "methods_against_weights": "The methods against 61 real weights",
    "formulas": "Methods, formulas and sources",
    "engine_figures": "121 engines",
    "tables": "Tables 1.3 to 1.15 of Pulvirenti (2023): printed, recomputed, difference, verdict",
}
"""Macro of the template -> title of the chapter."""
_FIRST = 3
"""Chapters before the appendices [-]."""


def weights_page(comparison: Comparison) -> str:
    """Return the whole page; it makes no request to anywhere.

    Args:
        comparison: Of `compare`.
    """
    context = _context(comparison)
    parts = environment().get_template("weights_sections.html.j2").make_module(context)
    drawn = _figures(comparison)
    sections = tuple(
        Section(title, figures=drawn.get(name, ()), content=Markup(getattr(parts, f"part_{name}")()))
        for name, title in _PARTS.items()
    )
    return set_page(
        Page("Gearbox mass", str(context["requirement"]), "", _verdict(comparison), tuple(_numbers(comparison)),
             sections[:_FIRST], sections[_FIRST:], footer="Masses in kg.")
    )  # fmt: skip


def _figures(comparison: Comparison) -> dict[str, tuple[PageFigure, ...]]:
    """Return chapter -> its figures."""
    methods = (
        "Real weights with the prediction band of their refit, and every method against them. Orange marks: what the"
        " methods give for this requirement."
    )
    power = "Gearbox mass over power. The masses are those of the formula of the tables."
    densities = "Power density of the gearbox and torque density of the engine, by series."
    return {
        "methods_against_weights": (figure(figure_methods(comparison), "methods", methods),),
        "engine_figures": (
            figure(figure_mass_over_power(comparison), "power", power),
            figure(figure_densities(), "densities", densities),
        ),
    }


def _verdict(comparison: Comparison) -> Judged:
    """Return how far the methods lie apart: an estimate never is more than open."""
    low, high = comparison.spread
    taken = weights.taken_text(comparison)
    if comparison.taken is not None:
        whose = "as given" if comparison.stated is not None else "the median of the refit of 61 real weights"
        taken = f"Taken from here on: {comparison.taken.mass:.1f} kg, {whose}."
    said = f"{taken} The methods that apply span {low:.3g} to {high:.3g} kg."
    return Judged(Tone.OPEN, f"An estimate: the methods differ by a factor of {high / low:.1f}", said)


def _numbers(comparison: Comparison) -> Iterator[Number]:
    taken = comparison.taken
    if taken is not None:
        band = next(((band.low, band.high) for band in comparison.bands), None)
        share = next((f"{band.level:.0%}".replace("%", " %") for band in comparison.bands), "")
        yield quantity("mass that is taken", taken.mass, "mass", digits=4, band=band, share=share)
    for mass in (comparison.bottom_up, comparison.stated):
        if mass is not None:
            yield quantity(weights.given_name(mass), mass.mass, "mass", origin=Origin("given", mass.origin))
    for estimate in comparison.estimates:
        if estimate.mass is not None:
            origin = Origin(estimate.method.formula, estimate.method.source)
            yield quantity(estimate.method.name, estimate.mass, "mass", origin=origin)


def _context(comparison: Comparison) -> _Cells:
    stated = [mass for mass in (comparison.bottom_up, comparison.stated) if mass is not None]
    return {
        "requirement": weights.requirement_text(comparison.requirement),
        "spread": weights.spread_text(comparison).splitlines(),
        "estimates": [_estimate(estimate) for estimate in comparison.estimates],
        "given": [
            {"name": weights.given_name(mass), "mass": f"{mass.mass:.1f} kg", "origin": mass.origin} for mass in stated
        ],
        "alike": [_alike(engine) for engine in comparison.engines],
        "scores": [_score(score) for score in scores()],
        "assumption": weights.score_assumption(),
        "columns": [{"key": key, "symbol": s, "unit": u, "formula": f} for key, (s, u, f) in COLUMNS.items()],
        "tables": [_table(series) for series in all_series()],
        "verdict_count": _verdict_count(),
    }


def _estimate(estimate: Estimate) -> _Cells:
    method = estimate.method
    return {
        "key": method.key,
        "name": method.name,
        "mass": weights.mass_text(estimate),
        "none": estimate.mass is None,
        "covered": weights.coverage_text(method.includes),
        "remark": weights.remark(estimate),
        "formula": method.formula,
        "source": method.source,
        "basis": method.basis,
        "assumes": method.assumes,
        "ranges": [_range(limit) for limit in method.ranges],
    }


def _range(limit: Range) -> str:
    dimension = "power" if limit.quantity == "power" else "number"
    return f"{limit.quantity} {text(limit.low, dimension)} to {text(limit.high, dimension)} ({limit.reason})"


def _alike(engine: Engine) -> _Cells:
    return {
        "table": engine.series.table,
        "series": engine.series.name,
        "model": engine.model,
        "power": f"{engine.power / 1e3:g}",
        "fast": f"{engine.engine_speed / RPM:.0f}",
        "slow": f"{engine.propeller_speed / RPM:.0f}",
        "mass": f"{gearbox_mass(engine):.1f}",
    }


def _score(score: Score) -> _Cells:
    return {
        "key": score.method.key,
        "name": score.method.name,
        "count": score.count,
        "cells": weights.score_cells(score),
    }


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


def _row(checked: CheckedEngine) -> _Cells:
    power, slow = checked.engine.as_printed("power_kw"), checked.engine.as_printed("propeller_rpm")
    return {
        "model": checked.engine.model,
        "power": power.text if power else "",
        "slow": slow.text if slow else "",
        "cells": [_cell(check) for check in checked.checks],
    }


def _cell(check: Check) -> _Cells:
    digits = 2 if check.printed is None else check.printed.decimals + 1
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
    parts = [
        f"{counts[verdict]} {verdict.value}" for verdict in Verdict if counts[verdict] and verdict is not Verdict.BLANK
    ]
    return f"Of {total} printed numbers: {', '.join(parts)}."
