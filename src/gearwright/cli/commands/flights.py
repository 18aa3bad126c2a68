"""Commands for missions, mixes and duty cycles, for propellers, rotors and turboshafts, engines and masses."""

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
from gearwright.cli.terminal import screen, show, show_commands, tell, write_figure
from gearwright.errors import DesignError, Problem, refuse
from gearwright.files import write_text

if TYPE_CHECKING:
    from collections.abc import Callable

    from gearwright.catalogue import Rotor, TailRotor
    from gearwright.machines import Blades
    from gearwright.machines.propellers import BladeShape
    from gearwright.mission import Durability, Flight, LifeSizing
    from gearwright.sizing import Sizing
    from gearwright.spec import Mission
    from gearwright.weights import CheckedEngine, Requirement, StatedMass


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


# ----------------------------------------------------------------------------------------------------------------------
# The command ``turboshaft``: an engine from its design point, its deck for missions, seconds of slam, rotor and start.
#
# Imports that cost time stand inside the command, so that ``--help`` stays quick.
# ----------------------------------------------------------------------------------------------------------------------


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
