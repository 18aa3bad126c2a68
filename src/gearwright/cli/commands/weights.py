"""The commands ``engines`` and ``mass``: they call the verbs, print, and write the files that the user names.

Imports that cost time stand inside the commands, so that ``--help`` stays quick.
"""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.designs import sized
from gearwright.cli.options import JsonOption, LinesOption
from gearwright.cli.terminal.output import screen, show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from gearwright.sizing import Sizing
    from gearwright.weights import CheckedEngine, Requirement, StatedMass

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
    series: Annotated[str, typer.Option(help="Part of the series' name, such as PW100")] = "",
    manufacturer: Annotated[str, typer.Option(help="Part of the manufacturer's name")] = "",
    kind: Annotated[Kind | None, typer.Option(help="Kind of engine")] = None,
    model: Annotated[str, typer.Option(help="Part of the model's name")] = "",
    min_power_kw: Annotated[float, typer.Option(help="Minimum take-off power", min=0.0)] = 0.0,
    max_power_kw: Annotated[float, typer.Option(help="Maximum take-off power")] = float("inf"),
    sort: Annotated[Order, typer.Option(help="Ascending order")] = Order.TABLE,
    csv: Annotated[Path | None, typer.Option(help="Write the rows, printed and recomputed, as CSV")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """List the 121 engines of the catalogue with what is printed, and the reason where a number is wrong."""
    from gearwright.catalogue import select
    from gearwright.render.answers.weights import engines_answer
    from gearwright.render.tables import weights
    from gearwright.render.words import weights_data
    from gearwright.weights import check_engine

    span = (min_power_kw * _KW, max_power_kw * _KW)
    chosen = select(series=series, manufacturer=manufacturer, kind=kind or "", model=model, power=span)
    rows = [check_engine(engine) for engine in chosen]
    if sort is not Order.TABLE:
        rows.sort(key=_sort_keys()[sort])
    if jsonl:
        show_rows("engines", engines_answer(rows), engines_answer(rows).rows)
    elif json:
        show_answer("engines", engines_answer(rows))
    else:
        show(weights.engine_table(rows, width=screen().width))
        if any(row.engine.notes for row in rows):
            show(weights.note_table(rows))
    if csv is not None:
        write_text(csv, weights_data.to_csv(weights_data.engine_rows(rows)))
        tell(f"wrote {csv}")


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


def mass(
    power_kw: Annotated[
        float | None, typer.Option(help="Power at the rating that sizes the gearbox; left out: of the design")
    ] = None,
    engine_rpm: Annotated[float | None, typer.Option(help="Speed of the input; left out: of the design")] = None,
    propeller_rpm: Annotated[
        float | None, typer.Option(help="Speed of the propeller or rotor; left out: of the design")
    ] = None,
    design: Annotated[str | None, typer.Option(help="Design whose parts are summed up beside the statistics")] = None,
    mass_kg: Annotated[float | None, typer.Option(help="Your own mass; it wins over every estimate")] = None,
    origin: Annotated[str, typer.Option(help="Where your own mass comes from")] = "",
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Show what a gearbox weighs by every public method, with the band of the real weights."""
    from gearwright.weights import compare

    sizing = sized(design) if design is not None else None
    comparison = compare(
        _requirement(sizing, power_kw, engine_rpm, propeller_rpm),
        bottom_up=_of_parts(sizing) if sizing is not None else None,
        stated=stated_mass(mass_kg, origin),
    )
    if json:
        from gearwright.render.answers.weights import mass_answer

        show_answer("mass", mass_answer(comparison), design=sizing.design.name if sizing is not None else None)
    else:
        from gearwright.render.tables import weights
        from gearwright.weights import scores

        show(weights.comparison_table(comparison, width=screen().width), weights.score_table(scores()))
    if report is not None:
        from gearwright.render.pages.weights import weights_page

        write_text(report, weights_page(comparison))
        tell(f"wrote {report}")


def _requirement(
    sizing: Sizing | None, power_kw: float | None, engine_rpm: float | None, propeller_rpm: float | None
) -> Requirement:
    """Return power and speeds as given, and those of the design where they are left out."""
    from gearwright.errors import Problem, refuse
    from gearwright.sizing.mass import requirement_of
    from gearwright.units import RPM
    from gearwright.weights import Requirement

    own = None if sizing is None else requirement_of(sizing)
    stands = (None, None, None) if own is None else (own.power, own.engine_speed, own.propeller_speed)
    given = {"--power-kw": (power_kw, _KW), "--engine-rpm": (engine_rpm, RPM), "--propeller-rpm": (propeller_rpm, RPM)}
    values = {
        name: stated if value is None else value * unit
        for (name, (value, unit)), stated in zip(given.items(), stands, strict=True)
    }
    fix = "or --design with a file that states it" if sizing is None else "as the design does not reduce a speed"
    refuse(Problem(name, f"is missing; give it, {fix}") for name, value in values.items() if value is None)
    return Requirement(*(value for value in values.values() if value is not None))


def _of_parts(sizing: Sizing) -> StatedMass:
    """Return the sum of all parts of a sizing, with its band and what gears, shafts and carriers are of it."""
    from gearwright.sizing.mass import complete_mass
    from gearwright.units import text
    from gearwright.weights import StatedMass

    mass = complete_mass(sizing)
    low, high, train = (text(value, "mass", 3) for value in (*mass.band, mass.train))
    words = f"sum of its parts, 68 % from {low} to {high}; of it gears, shafts and carriers {train}"
    return StatedMass(mass.total, words)


def _sort_keys() -> dict[Order, Callable[[CheckedEngine], float | str]]:
    from gearwright.weights import gearbox_mass

    return {
        Order.MODEL: lambda row: row.engine.model,
        Order.POWER: lambda row: row.engine.power,
        Order.PROPELLER_SPEED: lambda row: row.engine.propeller_speed,
        Order.GEARBOX_MASS: lambda row: gearbox_mass(row.engine),
        Order.TORQUE: lambda row: row.engine.power / row.engine.propeller_speed,
    }
