"""The command ``propeller``: a map of given blades, and what they do to their shaft at a point of flight.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

import math
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.options import FigureOption, JsonOption, LinesOption, steps
from gearwright.cli.terminal.output import show, tell, write_figure
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.machines import Blades
    from gearwright.machines.propellers import BladeShape

_RPM = math.pi / 30.0


class By(StrEnum):
    """How a map is made."""

    ELEMENTS = "elements"
    CHARTS = "charts"


def propeller(
    file: Annotated[
        Path | None,
        typer.Argument(
            help="CSV file of a blade: radius_ratio, chord_ratio (c/R), blade_angle_deg; left out: a generic blade",
            metavar="BLADES",
        ),
    ] = None,
    blades: Annotated[int, typer.Option(help="Number of blades")] = 4,
    activity_factor: Annotated[float, typer.Option(help="Of a generic blade")] = 115.0,
    design_lift: Annotated[float, typer.Option(help="Integrated design lift coefficient of a generic blade")] = 0.5,
    by: Annotated[By, typer.Option(help="Blade elements, or the Hamilton Standard charts")] = By.ELEMENTS,
    ratios: Annotated[str, typer.Option(help="Advance ratios: first:last:step")] = "0:4:0.1",
    angles_deg: Annotated[str, typer.Option(help="Blade angles at 0.75 R: first:last:step")] = "-30:90:2",
    tip_mach: Annotated[
        list[float] | None, typer.Option(help="Mach number of the tips' rotation; again for more")
    ] = None,
    rpm: Annotated[float | None, typer.Option(help="At a point of flight: speed of rotation")] = None,
    diameter_m: Annotated[float, typer.Option(help="There: diameter")] = 3.93,
    tas_m_s: Annotated[float, typer.Option(help="There: true airspeed")] = 0.0,
    altitude_m: Annotated[float, typer.Option(help="There: pressure altitude")] = 0.0,
    power_kw: Annotated[float | None, typer.Option(help="There: power of the shaft")] = None,
    blade_angle_deg: Annotated[float | None, typer.Option(help="There, for the power: blade angle at 0.75 R")] = None,
    incidence_deg: Annotated[float, typer.Option(help="There: angle of the axis to the stream")] = 0.0,
    out: Annotated[Path | None, typer.Option(help="Write the map, for missions, to this CSV file")] = None,
    figure: FigureOption = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Make the map of a propeller from its blades; with --rpm, its thrust and the loads of incidence on its shaft."""
    from gearwright.catalogue import FlightPoint, map_text, propeller_loads
    from gearwright.catalogue import propeller as made_of
    from gearwright.render.answers.flights.propeller import map_points, propeller_answer
    from gearwright.render.words.flights.propeller import loads_text, made_text

    given = _blades(file, blades, activity_factor, design_lift)
    radians = [math.radians(angle) for angle in steps(angles_deg, "angles-deg")]
    made = made_of(
        given, advance_ratios=steps(ratios, "ratios"), blade_angles=radians, tip_machs=tip_mach or [], by=by.value
    )
    flight = None
    if rpm is not None:
        point = FlightPoint(diameter_m, rpm * _RPM, tas_m_s, altitude_m, math.radians(incidence_deg))
        angle = None if blade_angle_deg is None else math.radians(blade_angle_deg)
        power = None if power_kw is None else power_kw * 1e3
        flight = propeller_loads(given, point, power=power, blade_angle=angle, by=by.value)
    if jsonl:
        show_rows("propeller", propeller_answer(made, flight), map_points(made))
    elif json:
        show_answer("propeller", propeller_answer(made, flight))
    else:
        show(made_text(made))
        if flight is not None:
            show(loads_text(flight, by.value))
    if out is not None:
        write_text(out, map_text(made.chart))
        tell(f"wrote {out}")
    if figure is not None:
        from gearwright.render.figures.flights.propeller import propeller_figure

        mach, chart = made.maps[0]
        title = f"Propeller map at tip Mach {mach:g}" if mach else "Propeller map"
        write_figure(propeller_figure(chart, title), figure)
        tell(f"wrote {figure}")


def _blades(file: Path | None, number: int, activity_factor: float, design_lift: float) -> Blades | BladeShape:
    from gearwright.catalogue import read_blades
    from gearwright.machines import Blades

    return Blades(number, activity_factor, design_lift) if file is None else read_blades(file, number)
