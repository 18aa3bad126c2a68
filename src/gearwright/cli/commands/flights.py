"""Commands for missions, mission mixes, duty cycles, propellers and rotors."""

from __future__ import annotations

import math
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.answers import show_answer, show_rows
from gearwright.cli.options import (
    DateOption,
    DesignArgument,
    FigureOption,
    JsonOption,
    LinesOption,
    MissionArgument,
    designs,
    mixes,
    placed_in,
    sized,
    steps,
)
from gearwright.cli.terminal import show, show_commands, tell, write_figure
from gearwright.errors import DesignError, Problem, refuse
from gearwright.files import write_text

if TYPE_CHECKING:
    from gearwright.catalogue import TailRotor
    from gearwright.machines import Blades
    from gearwright.machines.propellers import BladeShape
    from gearwright.mission import Durability, Flight, LifeSizing
    from gearwright.sizing import Sizing
    from gearwright.spec import Mission


# ----------------------------------------------------------------------------------------------------------------------
# The command ``fly``: a mission flown by a design.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


def fly(
    design: Annotated[
        str | None,
        typer.Argument(
            help="Design file, or the name of a shipped design",
            metavar="DESIGN",
            autocompletion=designs,
        ),
    ] = None,
    mission: MissionArgument = "thesis",
    life_h: Annotated[
        float | None,
        typer.Option(
            help="Strengthen the gears until all live so many flight hours, and choose bearings for them",
            min=0.001,
        ),
    ] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    window: Annotated[
        list[str] | None, typer.Option(help="Window of the mission to fly dynamically and draw on the page; or: all")
    ] = None,
    date: DateOption = "",
    csv: Annotated[Path | None, typer.Option(help="Write the histories as CSV, in SI")] = None,
    json: JsonOption = False,
    jsonl: LinesOption = False,
) -> None:
    """Fly a mission: fuel, charge, heat and the part that fails first; without a design, list the shipped missions."""
    if design is None:
        _list()
        return
    from gearwright.reviews import review_of

    if window and report is None:
        raise DesignError([Problem("--window", "windows are drawn on the page; name its file with --report, too")])
    flight, parts, life = flown(sized(design), mission, life_h=life_h)
    with placed_in(design):
        review = review_of(flight.sizing, flight, parts, life=None if life_h is None else 3600.0 * life_h)
    from gearwright.render.answers.flights import fly_answer, moments
    from gearwright.render.words.flights import flight_csv, flight_text

    name = flight.sizing.design.name
    if jsonl:
        show_rows("fly", fly_answer(flight, parts, review, life=life), moments(flight), design=name)
    elif json:
        show_answer("fly", fly_answer(flight, parts, review, life=life), design=name)
    else:
        show(flight_text(flight, parts, review, life=life))
    if report is not None:
        from gearwright.mission.windows import fly_window
        from gearwright.render.pages.flight import flight_page
        from gearwright.render.pages.page import Stamp

        windows = [fly_window(flight, name) for name in _windows(flight, window or [])]
        for dynamic in windows:
            dynamic.trace.whole()
        write_text(report, flight_page(flight, parts, review, life=life, windows=windows, stamp=Stamp(date)))
        tell(f"wrote {report}")
    if csv is not None:
        write_text(csv, flight_csv(flight))
        tell(f"wrote {csv}")


def _windows(flight: Flight, names: list[str]) -> list[str]:
    """Return the windows that are asked for; all of them for the word."""
    return list(flight.mission.windows) if "all" in names else names


def _list() -> None:
    from gearwright import read_mission, shipped_mission, shipped_missions

    for mission in shipped_missions():
        show(f"{mission:20} {read_mission(shipped_mission(mission)).name}")


def mission_of(name: str) -> tuple[Mission, Path]:
    """Return a mission, and the folder in which its propeller map may lie."""
    from gearwright.shipped import find_mission
    from gearwright.spec import read_mission

    path = find_mission(name)
    return read_mission(path), path.parent


def flown(sizing: Sizing, name: str, *, life_h: float | None = None) -> tuple[Flight, Durability, LifeSizing | None]:
    """Return the flight of a named mission; what cannot be flown is placed at its line in the mission's file.

    Args:
        sizing: Of the design.
        name: Of the mission, or its path.
        life_h: For which the design is strengthened, if it is [h].

    Raises:
        DesignError: If the mission cannot be read or flown.
    """
    from gearwright.mission import durability, fly as flown_by, size_for_life
    from gearwright.shipped import find_mission
    from gearwright.spec import file_text, placed

    mission, folder = mission_of(name)
    try:
        life = None if life_h is None else size_for_life(sizing.design, mission, life_h, folder=folder)
        flight = life.flight if life is not None else flown_by(sizing, mission, folder=folder)
        return flight, durability(flight), life
    except DesignError as error:
        if any(problem.path.partition(".")[0] not in type(mission).model_fields for problem in error.problems):
            raise
        path = find_mission(name)
        raise DesignError(placed(error.problems, file_text(path)), str(path)) from None


# ----------------------------------------------------------------------------------------------------------------------
# The commands ``mix`` and ``duty``: a life of several missions, and measured torque over time as a load spectrum.
#
# Imports that cost time stand inside the commands, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


MACHINE = "MACHINE"
"""Stands for a machine in the text for a design where none is named."""


def mix(
    design: DesignArgument,
    mix: Annotated[
        str, typer.Argument(help="Mix file, or the name of a shipped mix", metavar="MIX", autocompletion=mixes)
    ] = "regional-life",
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page")] = None,
    json: JsonOption = False,
) -> None:
    """Fly a life of several missions: what fails first, which mission eats the life, fuel and charge of all flights."""
    from gearwright.mission import fly_mix
    from gearwright.render.answers.flights import mix_answer
    from gearwright.render.words.flights import mix_text
    from gearwright.shipped import find_mix
    from gearwright.spec import file_text, placed, read_mix

    asked, sizing = read_mix(mix), sized(design)
    try:
        flown = fly_mix(sizing, asked)
    except DesignError as error:
        raise DesignError(placed(error.problems, file_text(find_mix(mix))), mix) from None
    if json:
        show_answer("mix", mix_answer(flown), design=sizing.design.name)
    else:
        show(mix_text(flown))
    if report is not None:
        from gearwright.render.pages.flight import mix_page

        write_text(report, mix_page(flown))
        tell(f"wrote {report}")


def duty(
    file: Annotated[
        Path,
        typer.Argument(
            help="CSV file; its first line names columns with units: time_s, torque_nm or power_kw, speed_rpm",
            metavar="FILE",
        ),
    ],
    classes: Annotated[int, typer.Option(help="Classes of torque, of equal width", min=1, max=1000)] = 20,
    machine: Annotated[str, typer.Option(help="Machine of the design that gave what was measured")] = MACHINE,
    name: Annotated[str, typer.Option(help="Of load case and spectrum")] = "measured",
    out: Annotated[Path | None, typer.Option(help="Write load case and spectrum to this file, as TOML")] = None,
    cycles: Annotated[
        Literal["half-cycles", "repeated"] | None,
        typer.Option(help="Count cycles of torque for shafts, too, by rainflow; says what becomes of the residue"),
    ] = None,
    json: JsonOption = False,
) -> None:
    """Count measured torque over time into a load spectrum, and write it as a load case of a design."""
    from gearwright.mission import duty_spectrum, read_duty
    from gearwright.render.answers.flights import duty_answer
    from gearwright.render.words.flights import cycles_text, duty_text

    measured = read_duty(file)
    spectrum = duty_spectrum(measured, classes=classes)
    text = spectrum.text(machine, name)
    if json:
        show_answer("duty", duty_answer(measured, spectrum, text, cycles))
    else:
        show(duty_text(measured, spectrum))
        if cycles is not None:
            show(cycles_text(measured, cycles))
        fill = f", with the name of its machine for {MACHINE} (or from --machine)" if machine == MACHINE else ""
        show(f"For a design file{fill}:\n")
        show_commands(text.rstrip())
    if out is not None:
        write_text(out, text)
        tell(f"wrote {out}")


# ----------------------------------------------------------------------------------------------------------------------
# The command ``propeller``: a map of given blades, and what they do to their shaft at a point of flight.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.catalogue import FlightPoint, map_text, propeller as made_of, propeller_loads
    from gearwright.render.answers.flights import map_points, propeller_answer
    from gearwright.render.words.flights import loads_text, made_text

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
        from gearwright.render.figures.flights import propeller_figure

        mach, chart = made.maps[0]
        title = f"Propeller map at tip Mach {mach:g}" if mach else "Propeller map"
        write_figure(propeller_figure(chart, title), figure)
        tell(f"wrote {figure}")


def _blades(file: Path | None, number: int, activity_factor: float, design_lift: float) -> Blades | BladeShape:
    from gearwright.catalogue import read_blades
    from gearwright.machines import Blades

    return Blades(number, activity_factor, design_lift) if file is None else read_blades(file, number)


# ----------------------------------------------------------------------------------------------------------------------
# The command ``rotor``: what a helicopter's main and tail rotor take in hover, climb and forward flight.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.catalogue import Helicopter, rotor as trimmed
    from gearwright.render.words.flights import rotor_text

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

    names = ("--tail-diameter-m", "--tail-rpm", "--tail-arm-m", "--tail-solidity")
    missing = [name for name, value in zip(names, given, strict=True) if value is None]
    if len(missing) == len(names):
        return None
    refuse([Problem(name, "a tail rotor is given without it; give all four, or none") for name in missing], "rotor")
    diameter, rpm, arm, solidity = (value or 0.0 for value in given)
    return TailRotor(diameter, rpm * _RPM, arm, solidity, induced_factor=factor)
