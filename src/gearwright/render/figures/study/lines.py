"""Figures of a study: lines along an axis with the optimum and how flat it is, or stacked masses of several designs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from gearwright.ranking import smallest_first
from gearwright.render.style import theme
from gearwright.render.style.compound import shade
from gearwright.render.tables.study.variants import FLAT, heading, numeric_axis, percent
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.figure import Figure
from gearwright.study import Row, Table

FEW_CURVES = 3
"""Curves up to which every optimum is written beside its ring."""
_STACK = ("gear_mass", "shaft_mass", "carrier_mass", "motor_mass")
_COMPLETE = ("complete_mass", "motor_mass")
_STACK_COLOURS = dict(zip(_STACK, (theme.BLUE, theme.GREEN, theme.AMBER, theme.ORANGE), strict=True))
_STACK_COLOURS["complete_mass"] = theme.BLUE
_HEAVIER_IS_BETTER = ("power_density", "total_power_density", "worst_margin", "review.margin")


def study_figure(table: Table, objectives: Mapping[str, str] | None = None) -> Figure:
    """Return the figure that suits a study: lines where a number varies, bars where designs are compared.

    Args:
        table: Of the study.
        objectives: Result -> ``minimum`` or ``maximum``, whose optima are marked; left out: every result has its own.
    """
    return sweep_figure(table, objectives) if numeric_axis(table) else comparison_figure(table)


@theme.drawn
def sweep_figure(table: Table, objectives: Mapping[str, str] | None = None) -> Figure:
    """Return every result against the last axis, one panel each, with the optimum and the range near it.

    Args:
        table: Of a study whose last axis is a number.
        objectives: Result -> ``minimum`` or ``maximum``, whose optima are marked; left out: every result has its own.
    """
    senses = objectives or {name: "maximum" if name in _HEAVIER_IS_BETTER else "minimum" for name in table.numbers}
    axis = numeric_axis(table) or ""
    figure = theme.sheet(180.0, 16.0 + 44.0 * len(table.numbers))
    panels = figure.grid(len(table.numbers), 1, share_x=True)[:, 0]
    curves = _curves(table, axis)
    few = len(curves) <= FEW_CURVES
    for panel, result in zip(panels, table.numbers, strict=True):
        for colour, (label, rows) in zip(_colours(len(curves)), curves.items(), strict=True):
            place: list[Any] = [row.inputs[axis] for row in rows]
            values = [row.shown(result) for row in rows]
            panel.plot(place, values, "-", color=colour, marker=".", ms=3.5, label=label)
            if result in senses:
                _mark_optimum(panel, place, values, colour=colour, sense=senses[result], flat=few)
        panel.set_ylabel(axis_label(table, result))
        panel.margins(x=0.02, y=0.18)
    tied = len(table.rows[0].inputs) - len(table.free)
    panels[-1].set_xlabel(f"{axis}, and {tied} more with it" if tied else axis)
    if few and len(curves) > 1:
        panels[0].legend("best")
    elif not few:
        others = ", ".join(path for path in table.free if path != axis)
        panels[0].legend("right", title=others, size=6.5)
    band = f", band within {percent(FLAT)} of it" if few else ""
    panels[0].set_title(f"{table.name}: ring at the optimum{band}")
    return figure


def _colours(count: int) -> list[Any]:
    """Return colours of curves: each its own for few, a scale in their order for many."""
    if count <= len(theme.CYCLE):
        return list(theme.CYCLE[:count])
    return [shade(k / (count - 1)) for k in range(count)]


def _curves(table: Table, axis: str) -> dict[str, list[Row]]:
    """Return the rows that differ in the axis alone, by what sets them apart."""
    groups: dict[str, list[Row]] = {}
    designs = {row.design for row in table.rows}
    for row in table.good:
        inputs = [str(row.inputs[path]) for path in table.free if path != axis]
        names = inputs if inputs and len(designs) == 1 else [row.design, *inputs]
        groups.setdefault(", ".join(names), []).append(row)
    return groups


def axis_label(table: Table, name: str) -> str:
    """Return what stands at the axis of an input or a result: what it is and its unit.

    Args:
        table: Of the study.
        name: Path of the input, or name of the result.
    """
    return f"{heading(name)} [{table.unit(name) or '-'}]" if name in table.results else name


def _mark_optimum(panel: Axes, place: list[Any], values: list[float], *, colour: Any, sense: str, flat: bool) -> None:
    """Ring the optimum of a curve; with its value and the range near it where there is room."""
    best = max(values) if sense == "maximum" else min(values)
    if not math.isfinite(best):
        return
    near = [x for x, value in zip(place, values, strict=True) if abs(value / best - 1.0) <= FLAT] if best else place
    at = place[values.index(best)]
    panel.plot([at], [best], "o", mfc=theme.PAPER, mec=colour, ms=8)
    if not flat:
        return
    panel.axvspan(min(near), max(near), color=colour, alpha=0.07, lw=0)
    offset = -12 if sense == "maximum" else 8
    side = {min(place): "left", max(place): "right"}.get(at, "center")
    panel.annotate(f"{best:.4g} at {at:g}", (at, best), (0, offset), ha=side,
                   fontsize=7.5, color=colour)  # fmt: skip


@theme.drawn
def comparison_figure(table: Table) -> Figure:
    """Return the masses of several designs as stacked bars, lightest first, with their power density.

    Args:
        table: With the results ``complete_mass`` and ``motor_mass``, or ``gear_mass``, ``shaft_mass``,
            ``carrier_mass`` and ``motor_mass``, or some of them.
    """
    whole = _COMPLETE[0] in table.results
    parts = [part for part in (_COMPLETE if whole else _STACK) if part in table.results] or list(table.numbers[:1])
    rows = smallest_first(table.good, lambda row: sum(row.number(part) for part in parts))
    figure = theme.sheet(180.0, 26.0 + 7.0 * len(rows))
    axes = figure.panel()
    labels = [", ".join([row.design, *(str(value) for value in row.inputs.values())]) for row in rows]
    start = [0.0] * len(rows)
    for part in parts:
        values = [row.shown(part) for row in rows]
        axes.barh(
            labels, values, left=start, height=0.66, color=_STACK_COLOURS.get(part, theme.SKY), label=heading(part)
        )
        start = [left + value for left, value in zip(start, values, strict=True)]
    for place, (row, end) in enumerate(zip(rows, start, strict=True)):
        axes.annotate(_bar_text(row, end), (end, place), (4, 0), va="center", fontsize=7.5)
    axes.invert_yaxis()
    axes.set_xlim(0.0, max(start, default=1.0) * 1.42)
    left_out = "gears, shafts, carriers and motors; without housing, bearings and oil"
    axes.set_xlabel(f"mass [kg]: {'gearbox with all its parts, and motors' if whole else left_out}")
    axes.legend("upper right")
    axes.set_title(table.name)
    axes.only_grid("x")
    return figure


def _bar_text(row: Row, total: float) -> str:
    text = f"{total:.1f} kg"
    dense = "power_density" in row.results and _COMPLETE[0] not in row.results  # it is of gears, shafts and carriers
    return f"{text}   gearbox {row.shown('power_density'):.1f} kW/kg" if dense else text
