"""Commands for turboshaft engines, the engine catalogue and mass estimates."""

from __future__ import annotations

import math
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.options import JsonOption, LinesOption, sized, steps
from gearwright.cli.terminal import screen, show, tell
from gearwright.errors import DesignError, Problem, refuse
from gearwright.files import write_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from gearwright.catalogue import Rotor
    from gearwright.errors import DesignError
    from gearwright.sizing import Sizing
    from gearwright.weights import CheckedEngine, Requirement, StatedMass


# ----------------------------------------------------------------------------------------------------------------------
# The command ``turboshaft``: an engine from its design point, its deck for missions, seconds of slam, rotor and start.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


_RPM = math.pi / 30.0
_KWH = 3.6e6


def turboshaft(
    power_kw: Annotated[float, typer.Option(help="At sea level on a standard day, without speed")],
    fuel_kg_kwh: Annotated[float, typer.Option(help="Specific fuel consumption there")],
    air_flow_kg_s: Annotated[float, typer.Option(help="Air flow there")],
    pressure_ratio: Annotated[float, typer.Option(help="Of the compressor there")],
    n1_rpm: Annotated[float, typer.Option(help="Speed of the gas generator there")],
    inertia_kg_m2: Annotated[float, typer.Option(help="Of the gas generator, for seconds of it")] = 0.06,
    compressor: Annotated[float, typer.Option(help="Isentropic efficiency; an assumption")] = 0.81,
    turbine: Annotated[float, typer.Option(help="Isentropic, of the turbine that drives it; an assumption")] = 0.86,
    altitudes_m: Annotated[str, typer.Option(help="Of the deck: first:last:step")] = "0:9000:3000",
    machs: Annotated[str, typer.Option(help="Of the deck: first:last:step")] = "0:0.6:0.3",
    slam_kw: Annotated[str | None, typer.Option(help="Seconds of a lever: from:to")] = None,
    slam_altitude_m: Annotated[float, typer.Option(help="There: pressure altitude, also of a start")] = 0.0,
    slam_mach: Annotated[float, typer.Option(help="There: Mach number")] = 0.0,
    isa_offset_k: Annotated[float, typer.Option(help="There: above the standard atmosphere, also of a start")] = 0.0,
    slam_s: Annotated[float, typer.Option(help="There: how long it is followed")] = 10.0,
    acceleration: Annotated[float, typer.Option(help="There: most fuel over p_3, over that of the design point")] = 1.0,
    rotor_inertia_kg_m2: Annotated[
        float | None, typer.Option(help="A rotor at the power turbine, which takes the slam and a governor holds")
    ] = None,
    n2_rpm: Annotated[float | None, typer.Option(help="Its speed")] = None,
    n2_gain: Annotated[float, typer.Option(help="Per cent of N1 that its governor asks for one of N2")] = 1.0,
    n2_integral: Annotated[float, typer.Option(help="The same over the integral, 1/s; 0: with droop")] = 0.5,
    n2_limit: Annotated[float, typer.Option(help="N2 over the one that is held, from which on least fuel flows")] = 1.1,
    starter_nm: Annotated[float | None, typer.Option(help="Seconds of a start: torque of the starter at rest")] = None,
    starter_cut: Annotated[float, typer.Option(help="There: part of N1 at which it is switched off")] = 0.5,
    hottest_k: Annotated[float, typer.Option(help="There: T_45 to which the fuel is cut back")] = 1100.0,
    out: Annotated[Path | None, typer.Option(help="Write the deck, for missions, to this CSV file")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Make the deck of a turboshaft engine from its design point; seconds of a slam, a held rotor or a start."""
    from gearwright import turboshaft as made_of
    from gearwright.catalogue import DesignPoint, Slam, StartRules, deck_text, engine_slam, engine_start
    from gearwright.render.answers.flights import turboshaft_answer
    from gearwright.render.words.flights import engine_text, transient_text

    design = DesignPoint(
        power_kw * 1e3, fuel_kg_kwh / _KWH, air_flow_kg_s, pressure_ratio, n1_rpm * _RPM, inertia_kg_m2, compressor,
        turbine,
    )  # fmt: skip
    slam = start = None
    rotor = _rotor(rotor_inertia_kg_m2, n2_rpm, (n2_gain, n2_integral, n2_limit))
    if rotor is not None and slam_kw is None:
        raise _missing("--slam-kw", "a rotor is given, and no power that changes; give one, such as 300:800")
    if slam_kw is not None:
        before, after = _powers(slam_kw)
        asked = Slam(
            before, after, slam_altitude_m, slam_mach, isa_offset_k, slam_s, acceleration, rotor=rotor
        )  # fmt: skip
        slam = engine_slam(design, asked)
    if starter_nm is not None:
        rules = StartRules(
            starter_nm, cut=starter_cut, hottest=hottest_k, altitude=slam_altitude_m, isa_offset=isa_offset_k
        )
        start = engine_start(design, rules)
    made = made_of(design, altitudes=steps(altitudes_m, "altitudes-m"), machs=steps(machs, "machs"))
    if jsonl:
        show_rows("turboshaft", turboshaft_answer(made, slam, start), made.rows)
    elif json:
        show_answer("turboshaft", turboshaft_answer(made, slam, start))
    else:
        show(engine_text(made))
        for found in (slam, start):
            if found is not None:
                show(transient_text(found))
    if out is not None:
        write_text(out, deck_text(made.deck))
        tell(f"wrote {out}")


def _powers(text: str) -> tuple[float, float]:
    """Return two powers [W].

    Raises:
        DesignError: The text is not two numbers.
    """
    try:
        before, after = (float(part) * 1e3 for part in text.split(":"))
    except ValueError:
        raise _missing("--slam-kw", f"{text!r} is not from:to, such as 300:800") from None
    return before, after


def _rotor(inertia: float | None, speed: float | None, governor: tuple[float, float, float]) -> Rotor | None:
    """Return the rotor that is held, by gain, integral and limit.

    Raises:
        DesignError: One of its two numbers is given, and the other is not.
    """
    from gearwright.catalogue import Rotor

    if inertia is None and speed is None:
        return None
    if inertia is None or speed is None:
        missing = "--rotor-inertia-kg-m2" if inertia is None else "--n2-rpm"
        raise _missing(missing, "a rotor is given without it; give both, or none")
    return Rotor(inertia, speed * _RPM, *governor)


def _missing(option: str, message: str) -> DesignError:
    return DesignError([Problem(option, message)])


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``engines`` and ``mass``: they call the verbs, print, and write the files that the user names.
#
# Imports that cost time stand inside the commands, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


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
        write_text(csv, weights.to_csv(weights.engine_rows(rows)))
        tell(f"wrote {csv}")


def stated_mass(mass_kg: float | None, origin: str) -> StatedMass | None:
    """Return the user's own mass, if there is one.

    Args:
        mass_kg: [kg].
        origin: In the user's words.

    Raises:
        DesignError: A mass without an origin, or an origin without a mass.
    """
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
