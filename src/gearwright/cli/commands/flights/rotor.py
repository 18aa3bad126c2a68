"""The command ``rotor``: what a helicopter's main and tail rotor take in hover, climb and forward flight.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.options import JsonOption, steps
from gearwright.cli.terminal.output import show

if TYPE_CHECKING:
    from gearwright.catalogue import TailRotor

_RPM = math.pi / 30.0


def rotor(
    mass_kg: Annotated[float, typer.Option(help="Of the helicopter")],
    diameter_m: Annotated[float, typer.Option(help="Of the main rotor")],
    rpm: Annotated[float, typer.Option(help="Speed of the main rotor")],
    solidity: Annotated[float, typer.Option(help="Of the main rotor: area of the blades over that of the disc")],
    flat_plate_area_m2: Annotated[float, typer.Option(help="Drag of the fuselage over the dynamic pressure")] = 0.0,
    speeds_m_s: Annotated[str, typer.Option(help="Forward speeds: first:last:step; 0 is hover")] = "0:60:10",
    altitude_m: Annotated[float, typer.Option(help="Pressure altitude")] = 0.0,
    isa_offset_k: Annotated[float, typer.Option(help="Temperature above the standard atmosphere")] = 0.0,
    rate_of_climb_m_s: Annotated[float, typer.Option(help="Negative in descent")] = 0.0,
    profile_drag: Annotated[float, typer.Option(help="c_d0 of the main rotor's blades")] = 0.010,
    induced_factor: Annotated[float, typer.Option(help="κ over the ideal induced power of the main rotor")] = 1.15,
    download: Annotated[float, typer.Option(help="Of the wake on the fuselage in hover, over the weight")] = 0.03,
    tail_diameter_m: Annotated[float | None, typer.Option(help="Of the tail rotor; left out: there is none")] = None,
    tail_rpm: Annotated[float | None, typer.Option(help="Speed of the tail rotor")] = None,
    tail_arm_m: Annotated[float | None, typer.Option(help="From the mast to the tail rotor's shaft")] = None,
    tail_solidity: Annotated[float | None, typer.Option(help="Of the tail rotor")] = None,
    tail_induced_factor: Annotated[float, typer.Option(help="κ of the tail rotor; about 0.85 in a duct")] = 1.25,
    json: JsonOption = False,
) -> None:
    """Show what a helicopter's main and tail rotor take in hover, climb and forward flight."""
    from gearwright.catalogue import Helicopter
    from gearwright.catalogue import rotor as trimmed
    from gearwright.render.words.flights.rotor import rotor_text

    helicopter = Helicopter(
        mass_kg, diameter_m, rpm * _RPM, solidity, flat_plate_area_m2, profile_drag, induced_factor, download,
        tail=_tail((tail_diameter_m, tail_rpm, tail_arm_m, tail_solidity), tail_induced_factor),
    )  # fmt: skip
    found = trimmed(
        helicopter, steps(speeds_m_s, "speeds-m-s"), altitude=altitude_m, rate_of_climb=rate_of_climb_m_s,
        isa_offset=isa_offset_k,
    )  # fmt: skip
    if json:
        show_answer("rotor", found)
    else:
        show(rotor_text(found))


def _tail(given: tuple[float | None, float | None, float | None, float | None], factor: float) -> TailRotor | None:
    """Return the tail rotor.

    Raises:
        DesignError: Some of its four numbers are given and some are not.
    """
    from gearwright.catalogue import TailRotor
    from gearwright.errors import Problem, refuse

    names = ("--tail-diameter-m", "--tail-rpm", "--tail-arm-m", "--tail-solidity")
    missing = [name for name, value in zip(names, given, strict=True) if value is None]
    if len(missing) == len(names):
        return None
    refuse([Problem(name, "a tail rotor is given without it; give all four, or none") for name in missing], "rotor")
    diameter, rpm, arm, solidity = (value or 0.0 for value in given)
    return TailRotor(diameter, rpm * _RPM, arm, solidity, induced_factor=factor)
