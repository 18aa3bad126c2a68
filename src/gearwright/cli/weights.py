"""The commands ``engines`` and ``mass``: they call the verbs, print, and write the files that the user names.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.output import screen, show
from gearwright.writing import write_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from gearwright.weights import CheckedEngine, Comparison, StatedMass

_KW = 1e3


class Order(StrEnum):
    """What engines are sorted by."""

    TABLE = "table"
    MODEL = "model"
    POWER = "power"
    PROPELLER_SPEED = "propeller-speed"
    GEARBOX_MASS = "gearbox-mass"
    TORQUE = "torque"


class Kind(StrEnum):
    """Kinds of engine."""

    TURBOPROP = "turboprop"
    TURBOSHAFT = "turboshaft"


def engines(
    series: Annotated[str, typer.Option(help="Part of the series' name, such as PW100.")] = "",
    manufacturer: Annotated[str, typer.Option(help="Part of the manufacturer's name.")] = "",
    kind: Annotated[Kind | None, typer.Option(help="Kind of engine.")] = None,
    model: Annotated[str, typer.Option(help="Part of the model's name.")] = "",
    min_power_kw: Annotated[float, typer.Option(help="Least take-off power.", min=0.0)] = 0.0,
    max_power_kw: Annotated[float, typer.Option(help="Greatest take-off power.")] = float("inf"),
    sort: Annotated[Order, typer.Option(help="Ascending order.")] = Order.TABLE,
    csv: Annotated[Path | None, typer.Option(help="Write the rows, printed and recomputed, as CSV.")] = None,
    json: Annotated[Path | None, typer.Option(help="Write the same rows as JSON.")] = None,
) -> None:
    """List the 121 engines of the catalogue with what is printed, and the reason where a number is wrong."""
    from gearwright.catalogue import select
    from gearwright.render.tables import weights
    from gearwright.render.words import weights_data
    from gearwright.weights import check_engine

    span = (min_power_kw * _KW, max_power_kw * _KW)
    chosen = select(series=series, manufacturer=manufacturer, kind=kind or "", model=model, power=span)
    rows = [check_engine(engine) for engine in chosen]
    if sort is not Order.TABLE:
        rows.sort(key=_sort_keys()[sort])
    show(weights.engine_table(rows, width=screen().width))
    if any(row.engine.notes for row in rows):
        show(weights.note_table(rows))
    for path, write in ((csv, weights_data.to_csv), (json, weights_data.to_json)):
        if path is not None:
            _write(path, write(weights_data.engine_rows(rows)))


def stated_mass(mass_kg: float | None, origin: str) -> StatedMass | None:
    """Return the user's own mass, if there is one.

    Args:
        mass_kg: [kg].
        origin: In the user's words.

    Raises:
        DesignError: A mass without an origin, or an origin without a mass.
    """
    from gearwright.errors import DesignError, Problem
    from gearwright.weights import StatedMass

    if mass_kg is not None:
        return StatedMass(mass_kg, origin, overridden=True)
    if origin:
        raise DesignError([Problem("--origin", f"{origin!r} was given without a mass; add --mass-kg")])
    return None


def show_mass(
    power_kw: float,
    engine_rpm: float,
    propeller_rpm: float,
    *,
    bottom_up: float | None = None,
    stated: StatedMass | None = None,
    json: Path | None = None,
    report: Path | None = None,
) -> Comparison:
    """Print the comparison, write what is asked for, and return it.

    Args:
        power_kw: [kW].
        engine_rpm: [rpm].
        propeller_rpm: [rpm].
        bottom_up: Sum of the parts of a sized design [kg].
        stated: The user's own mass.
        json: Where to write the comparison.
        report: Where to write the page.
    """
    from gearwright.render.tables import weights
    from gearwright.render.words import weights_data
    from gearwright.units import RPM
    from gearwright.weights import Requirement, compare, scores

    need = Requirement(power_kw * _KW, engine_rpm * RPM, propeller_rpm * RPM)
    comparison = compare(need, bottom_up=bottom_up, stated=stated)
    show(weights.comparison_table(comparison, width=screen().width), weights.score_table(scores()))
    if json is not None:
        _write(json, weights_data.to_json(weights_data.comparison_record(comparison)))
    if report is not None:
        from gearwright.render.pages.weights import weights_page

        _write(report, weights_page(comparison))
    return comparison


def _sort_keys() -> dict[Order, Callable[[CheckedEngine], float | str]]:
    from gearwright.weights import gearbox_mass

    return {
        Order.MODEL: lambda row: row.engine.model,
        Order.POWER: lambda row: row.engine.power,
        Order.PROPELLER_SPEED: lambda row: row.engine.propeller_speed,
        Order.GEARBOX_MASS: lambda row: gearbox_mass(row.engine),
        Order.TORQUE: lambda row: row.engine.power / row.engine.propeller_speed,
    }


def _write(path: Path, content: str) -> None:
    write_text(path, content)
    show(f"wrote {path}")
