"""The command ``fly``: a mission flown by a design.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from gearwright.mission import Flight, GearDamage


def fly(
    design: Annotated[
        str | None, typer.Argument(help="Design file, or the name of a shipped design", metavar="DESIGN")
    ] = None,
    mission: Annotated[str, typer.Argument(help="Mission file, or the name of a shipped mission")] = "thesis",
    csv: Annotated[Path | None, typer.Option(help="Write the histories as CSV, in SI")] = None,
    json: Annotated[bool, typer.Option("--json", help="Print JSON for machines instead of words")] = False,
) -> None:
    """Fly a mission: fuel, charge, heat and the gear that dies first; without a design, list the shipped missions."""
    from gearwright.shipped import shipped_missions

    if design is None:
        _list(shipped_missions())
        return
    flight, damages = _flown(design, mission)
    from gearwright.render.flight_text import flight_csv, flight_json, flight_text

    typer.echo(flight_json(flight, damages) if json else flight_text(flight, damages))
    if csv is not None:
        csv.write_text(flight_csv(flight), encoding="utf-8")
        typer.echo(f"wrote {csv}", err=True)


def _list(names: tuple[str, ...]) -> None:
    from gearwright.shipped import shipped_mission
    from gearwright.spec.mission import read_mission

    for each in names:
        typer.echo(f"{each:20} {read_mission(shipped_mission(each)).name}")


def _flown(design: str, mission: str) -> tuple[Flight, tuple[GearDamage, ...]]:
    from gearwright.errors import DesignError
    from gearwright.mission import fly as flown_by
    from gearwright.mission import gear_damage
    from gearwright.shipped import shipped_design, shipped_designs, shipped_mission, shipped_missions
    from gearwright.sizing import size
    from gearwright.spec import read
    from gearwright.spec.mission import read_mission

    own, asked = Path(design), Path(mission)
    sizing = size(read(shipped_design(design) if not own.exists() and design in shipped_designs() else own))
    read_from = shipped_mission(mission) if not asked.exists() and mission in shipped_missions() else asked
    flight = flown_by(sizing, read_mission(read_from), folder=read_from.parent)
    try:
        return flight, gear_damage(flight)
    except DesignError as error:  # the flight is good without a rating; say why there is none
        typer.echo(f"No damage: {error}", err=True)
        return flight, ()
