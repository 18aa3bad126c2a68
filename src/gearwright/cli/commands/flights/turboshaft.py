"""The command ``turboshaft``: an engine from its design point, its deck for missions, seconds of slam, rotor and start.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.options import JsonOption, LinesOption, steps
from gearwright.cli.terminal.output import show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.catalogue import Rotor
    from gearwright.errors import DesignError

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
    from gearwright.catalogue import DesignPoint, Slam, StartRules, deck_text, engine_slam, engine_start
    from gearwright.catalogue import turboshaft as made_of
    from gearwright.render.answers.flights.turboshaft import turboshaft_answer
    from gearwright.render.words.flights.turboshaft import engine_text, transient_text

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
    from gearwright.errors import DesignError, Problem

    return DesignError([Problem(option, message)])
