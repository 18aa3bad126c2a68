"""Flights in words and as CSV: phases, forces, dynamic windows, lives of several missions.

Which missions are flown is words of studies; how a flight is drawn is `figures` and `pages`.
"""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from rich.console import Group, RenderableType
from rich.text import Text

from gearwright.base import CELSIUS, GRAVITY, KWH, NAUTICAL_MILE, largest, margin_text, number_text, shown, text, unit
from gearwright.catalogue import EngineTransient, MadeEngine, MadePropeller, PropellerLoads, RotorTrim
from gearwright.dynamics import Trace
from gearwright.dynamics.motion import Error, Statistics
from gearwright.machines.propellers import BladeShape, Feathered, activity_factor, integrated_lift
from gearwright.mission import (
    Durability,
    DutySpectrum,
    Flight,
    FlownMix,
    LifeSizing,
    MeasuredDuty,
    PartLife,
    PhaseForces,
    PhaseSummary,
    flight_series,
    phase_forces,
    phase_summaries,
)
from gearwright.mission.lives import bearings_of, seat_duties, torque_cycles
from gearwright.mission.windows import DynamicWindow
from gearwright.parts.shaft_fatigue import LoadCycle, Residue
from gearwright.render.grid import csv_text
from gearwright.render.tables.flights import (
    cycle_table,
    deck_table,
    duty_table,
    mission_table,
    part_table,
    propeller_table,
    rotor_tables,
    shares_of_damage,
    transient_table,
)
from gearwright.render.words.sizing import energy_text, headline, table_text
from gearwright.reviews import Review
from gearwright.spec import Phase

# ----------------------------------------------------------------------------------------------------------------------
# Forces of a flight in words: thrust beside drag, block fuel, take-off, and what an aircraft would not fly so.
# ----------------------------------------------------------------------------------------------------------------------


TELLING = 0.05
"""Part of the thrust that may be left over before it is told [-]."""
JUMP = 0.5
"""Airspeed that may jump before it is told: rounding of knots [m/s]."""


def forces_text(flight: Flight) -> list[str]:
    """Return the forces on the aircraft, phase by phase, as lines of text; none where the mission has no aircraft.

    Args:
        flight: As flown.
    """
    rows = phase_forces(flight)
    if not rows:
        return []
    head = f"{'phase':15} {'NM':>7} {'mass kg':>8} {'thrust kN':>10} {'drag kN':>8} {'path kN':>8} {'left over':>10}"
    return ["", head, *map(_row, rows), *_fuel(flight, rows), *_roll(flight, rows), *_told(flight, rows)]


def _row(row: PhaseForces) -> str:
    thrust, left = (f"{value / 1e3:.2f}" if value is not None else "–" for value in (row.thrust, row.left_over))
    return (
        f"{row.name:15} {row.distance / NAUTICAL_MILE:7.1f} {row.mass:8.0f} {thrust:>10} {row.drag / 1e3:8.2f}"
        f" {row.path / 1e3:8.2f} {left:>10}"
    )


def _fuel(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield block fuel and reserves, of the whole aircraft."""
    spent = {True: 0.0, False: 0.0}
    for row, summary in zip(rows, phase_summaries(flight), strict=True):
        engines = flight.mission.phases[row.name].engines or flight.mission.engines
        spent[row.reserve] += engines * summary.fuel
    beside = f", reserves of {spent[True]:.0f} kg beside it" if spent[True] else ""
    yield f"Block fuel of the aircraft {spent[False]:.0f} kg{beside}"


def _roll(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield distances of take-offs and landings."""
    for row in rows:
        kind = flight.mission.phases[row.name].kind
        if kind in ("take-off", "landing"):
            yield f"{row.name}: {row.distance:.0f} m, of which {row.roll:.0f} m roll"


def _told(flight: Flight, rows: Sequence[PhaseForces]) -> Iterator[str]:
    """Yield airspeeds that jump, and thrust that drag and path do not explain."""
    for row in rows:
        if abs(row.jump) > JUMP:
            yield (
                f"Note: {row.name} starts {abs(row.jump):.1f} m/s {'faster' if row.jump > 0.0 else 'slower'} than the"
                f" phase before ended: {row.jump_acceleration:.2f} m/s² within a step of {flight.mission.step:g} s"
            )
        left, implied = row.left_over, row.implied
        phase = flight.mission.phases[row.name]
        if phase.kind is not None or left is None or implied is None or abs(left) <= TELLING * abs(row.thrust or 0.0):
            continue
        friction, most = (
            _braking(phase, row),
            flight.mission.aircraft.braking_friction if flight.mission.aircraft else 0.0,
        )
        if friction is not None and 0.0 < friction <= most:
            yield f"{row.name}: brakes hold {left / 1e3:.1f} kN, {friction:.2f} of the weight"
            continue
        unexplained = f"{left / 1e3:.1f} kN of thrust are not explained by drag and path"
        more = f", and brakes hold {most:g} of the weight" if friction else ""
        yield f"Note: {row.name}, {unexplained}: {implied:.2f} m/s²{more}"


def _braking(phase: Phase, row: PhaseForces) -> float | None:
    """Return the friction with which wheels hold what is left over [-]; None where a phase does not end at a stand."""
    if row.left_over is None or 0.0 not in (phase.tas, phase.cas, phase.mach):
        return None
    return row.left_over / (row.mass * GRAVITY)


# ----------------------------------------------------------------------------------------------------------------------
# A flight in words: phases, energies, heat and the part that fails first.
# ----------------------------------------------------------------------------------------------------------------------


_LITRE_PER_MINUTE = 1e-3 / 60.0
MOST_ROWS = 8
"""Parts that are shown in words [-]."""
_MOST_LIFE = 1e6
"""Flights and hours above this many are shown as such."""


def flight_text(flight: Flight, parts: Durability, review: Review, *, life: LifeSizing | None = None) -> str:
    """Return what a flight took and did, of one gearbox, as lines of text.

    Args:
        flight: As flown.
        parts: Lives of its gears and bearings.
        review: Of the gearbox that flew.
        life: How the design was strengthened, if it was.
    """
    head = f"{flight.mission.name}, flown by {flight.sizing.design.name}"
    lines = [head, f"{headline(review)}.", "", _heading()]
    lines += [_phase(row) for row in phase_summaries(flight)]
    lines += [*forces_text(flight), "", *_totals(flight), "", *_damage(parts.parts), *_bearings(parts)]
    lines += [f"Note: {note}" for note in (*_of_the_day(flight), *parts.notes)]
    return "\n".join([*lines, *([life_text(life)] if life is not None else [])])


def verdict_text(parts: Durability) -> str:
    """Return which part fails first, and after how many flights.

    Args:
        parts: Lives of gears and bearings.
    """
    rows = parts.parts
    if not rows or not rows[0].damage:
        return "Nothing that is rated fails"
    first = rows[0]
    scope = " of what is rated" if parts.is_partial else ""
    lasts = f"{count_text(first.flights)} flights or {count_text(first.life)} h"
    return f"First to fail{scope}: {first.name}, {first.mode}, after {lasts}"


def count_text(number: float) -> str:
    """Return a number of flights or hours, or what it is greater than where it is beyond any sense.

    Args:
        number: [-] or [h].
    """
    return f"{number:.0f}" if number < _MOST_LIFE else f"> {_MOST_LIFE:.0e}"


def life_text(life: LifeSizing) -> str:
    """Return what an asked life costs.

    Args:
        life: From `size_for_life`.
    """
    words = (
        f"A gear life of {life.hours:.0f} h instead of {life.path[0][0]:.0f} h costs {life.mass_of_life:.2f} kg on"
        f" {life.mass_before:.2f} kg, in {life.rounds} rounds"
    )
    if life.bearings.rows:
        words += f"; bearings for it weigh {life.bearings.mass:.2f} kg,"
        words += f" those for the mission's own life {life.bearings_before:.2f} kg"
    return words


def _of_the_day(flight: Flight) -> list[str]:
    """Return by what law the turbines of a day that is not standard have their power; none where there are none."""
    mission, rules = flight.mission, flight.mission.engine
    if not mission.isa_offset_k or not flight.sizing.design.turbines:
        return []
    of = "the deck's power, which is that of a standard day," if rules.deck else "the turbines' power"
    return [
        f"on ISA{mission.isa_offset_k:+g} K {of} follows θ_t^n, n = {rules.temperature_exponent:g} up to 15 °C at the"
        f" inlet and {rules.hot_exponent:g} beyond: as of engines by their components, no measurement of this one"
    ]


def _heading() -> str:
    return f"{'phase':14} {'min':>6} {'fuel kg':>8} {'battery kWh':>12} {'propeller kWh':>14} {'efficiency %':>13}"


def _phase(row: PhaseSummary) -> str:
    return (
        f"{row.name:14} {row.duration / 60.0:6.1f} {row.fuel:8.1f} {row.battery / KWH:12.1f}"
        f" {row.propeller / KWH:14.1f} {100.0 * row.efficiency:13.2f}"
    )


def _totals(flight: Flight) -> list[str]:
    balance, history = flight.balance, flight.history
    lines = [
        f"Fuel {flight.fuel:.1f} kg and {balance.battery / KWH:.1f} kWh of charge in {flight.duration / 3600.0:.2f} h,"
        " of one gearbox",
        f"Lost in meshes {balance.mesh_loss / KWH:.2f} kWh, bearings {balance.bearing_loss / KWH:.2f} kWh,"
        f" windage {balance.windage_loss / KWH:.2f} kWh, churning {balance.churning_loss / KWH:.2f} kWh,"
        f" motors {balance.motor_loss / KWH:.2f} kWh, battery {balance.battery_loss / KWH:.2f} kWh",
        f"Oil: {flight.oil_flow / _LITRE_PER_MINUTE:.1f} l/min, at most {flight.hottest_oil - CELSIUS:.0f} °C behind"
        f" the gearbox; a cooler of {flight.cooler_conductance:.0f} W/K",
        f"Energies close {energy_text(balance.residual)}",
    ]
    if flight.dry is not None:
        rules = flight.mission.oil.network
        ends = (
            f"{flight.dry.part} at their limit after {flight.dry.lasts / 60.0:.1f} min"
            if flight.dry.part
            else "no limit"
        )
        lines.append(f"Without oil from the end of {rules.dry_from if rules else ''}: {ends}")
    if balance.consumers:
        lines.insert(1, f"Accessories, tail rotors and other loads take {balance.consumers / KWH:.2f} kWh")
    if flight.has_battery:
        lines.insert(1, f"State of charge at the end {history.state_of_charge[-1]:.3f}")
    return lines


def _damage(rows: Sequence[PartLife]) -> list[str]:
    lines = [f"{'part':24} {'mode':16} {'damage a flight':>16} {'flights':>10} {'life h':>10}"]
    for row in rows[:MOST_ROWS]:
        numbers = [count_text(number) for number in (row.flights, row.life)]
        lines.append(f"{row.name:24} {row.mode:16} {row.damage:16.2e} {numbers[0]:>10} {numbers[1]:>10}")
    return lines


def _bearings(parts: Durability) -> list[str]:
    lines = [
        f"Bearing {row.seat}: {row.count} x {row.bearing.designation}{'' if row.asked is None else ', chosen'},"
        f" P {row.mean_load / 1e3:.1f} kN, s_0 {row.static_safety:.1f}, {row.mass:.1f} kg"
        for row in parts.bearings.rows
    ]
    return [verdict_text(parts), *lines]


# ----------------------------------------------------------------------------------------------------------------------
# A flight for machines: its histories as CSV; its sums, damages and duty spectra as JSON.
# ----------------------------------------------------------------------------------------------------------------------


def flight_csv(flight: Flight) -> str:
    """Return the histories as CSV, one row per interval, in SI.

    Args:
        flight: As flown.
    """
    columns = {
        **{series.name: series.values for series in flight_series(flight)},
        **{f"bearing.{seat.name}": duty.radial for seat, duty in seat_duties(flight)},
    }
    rows = ([phase, *(float(values[k]) for values in columns.values())] for k, phase in enumerate(flight.phase))
    return csv_text(["phase", *columns], rows)


# ----------------------------------------------------------------------------------------------------------------------
# A life of several missions in words: verdict, missions, parts, fuel and charge.
# ----------------------------------------------------------------------------------------------------------------------


def mix_text(flown: FlownMix) -> RenderableType:
    """Return a life of several missions for the terminal.

    Args:
        flown: As flown.
    """
    head = f"{flown.mix.name}, flown by {flown.sizing.design.name}"
    tables = [table for table in (mission_table(flown), part_table(flown)) if table.rows]
    last = [totals(flown), *mix_notes(flown)]
    return Group(*map(Text, (head, verdict(flown), "")), *map(table_text, tables), *map(Text, last))


def verdict(flown: FlownMix) -> str:
    """Return whether the gearbox lives all flights, what fails first, and which mission eats most of its life.

    Args:
        flown: As flown.
    """
    parts = flown.life.parts
    partial = flown.life.unrated or any(lived.is_partial for lived in flown.lives.values())
    scope = "of what is rated " if partial else ""
    if not parts or not parts[0].damage:
        return f"Nothing {scope}fails."
    first, shares = parts[0], shares_of_damage(flown, parts[0])
    worst = largest(shares, shares.__getitem__)
    lives = "lives" if flown.damage < 1.0 else "does not live"
    return (
        f"It {lives} all {flown.mix.flights} flights: {scope}{first.name}, {first.mode}, fails first, after"
        f" {count_text(first.flights)} flights or {count_text(first.life)} h (Miner's sum {flown.damage:.3g});"
        f" {worst} eats {100.0 * shares[worst]:.0f} % of its life."
    )


def totals(flown: FlownMix) -> str:
    """Return time, fuel and charge of the whole life.

    Args:
        flown: As flown.
    """
    charge = ""
    if any(flight.has_battery for flight in flown.flights.values()):
        charge = f", {flown.battery / KWH / 1e3:.5g} MWh from the battery"
    worn = [
        flown.mix.count(name) * flight.pack.cycles for name, flight in flown.flights.items() if flight.pack is not None
    ]
    cycles = f", {sum(worn):.4g} full cycles of its cells" if worn else ""
    return (
        f"All {flown.mix.flights} flights: {flown.duration / 3600.0:.0f} h, {flown.fuel / 1e3:.4g} t of fuel"
        f"{charge}{cycles}, of one gearbox"
    )


def mix_notes(flown: FlownMix) -> list[str]:
    """Return which bearings are taken, and what is not rated.

    Args:
        flown: As flown.
    """
    named = ", ".join(f"{seat} {bearing}" for seat, bearing in bearings_of(flown).items())
    lines = [f"Bearings, one for all missions: {named}"] if named else []
    return [*lines, *(f"Note: {note}" for note in not_rated(flown))]


def not_rated(flown: FlownMix) -> list[str]:
    """Return what is not rated in some mission or falls short there, and why.

    Args:
        flown: As flown.
    """
    told = dict[str, list[str]]()
    for name, lived in flown.lives.items():
        for note in lived.notes:
            told.setdefault(note, []).append(name)
    return [*flown.life.unrated, *(f"{', '.join(names)}: {note}" for note, names in told.items())]


# ----------------------------------------------------------------------------------------------------------------------
# A measured duty in words: what was read, its classes, and the lines for a design file.
# ----------------------------------------------------------------------------------------------------------------------


def duty_text(duty: MeasuredDuty, spectrum: DutySpectrum) -> RenderableType:
    """Return a measured duty for the terminal.

    Args:
        duty: As read.
        spectrum: Its classes.
    """
    return Group(*map(Text, [summary(duty), *duty_notes(duty)]), Text(), table_text(duty_table(spectrum)))


def cycles_text(duty: MeasuredDuty, residue: Residue) -> RenderableType:
    """Return the cycles of torque of a duty for the terminal, and what a shaft needs for the largest of them.

    Args:
        duty: As read.
        residue: Rule of what closes no loop.
    """
    cycles = torque_cycles(duty, residue=residue)
    return Group(table_text(cycle_table(cycles, residue)), Text(swing_words(cycles)))


def swing_words(cycles: Sequence[LoadCycle]) -> str:
    """Return which swing of the torque a shaft must bear so that it bears every cycle.

    Args:
        cycles: As counted.
    """
    swings = [cycle.range / 2.0 / abs(cycle.mean) if cycle.mean else math.inf for cycle in cycles]
    largest = max(swings, default=0.0)
    if largest <= 1.0:
        return f"For shafts: torque_swing = {largest:.4g} in [service], alternating over mean torque of the worst cycle"
    return "For shafts: torque reverses within a cycle; torque_swing = 1, the most that [service] has, is less"


def summary(duty: MeasuredDuty) -> str:
    """Return how long a record is, and what it reaches.

    Args:
        duty: As read.
    """
    torque, speed = float(abs(duty.torque).max()), float(abs(duty.speed).max())
    return (
        f"{len(duty.time)} rows over {text(float(duty.duration.sum()), 'time')}; at most {text(torque, 'torque')} and"
        f" {text(speed, 'speed')}; work {work(duty) / KWH:.4g} kWh"
    )


def work(duty: MeasuredDuty) -> float:
    """Return the work of a record, that in its other direction taken off [J].

    Args:
        duty: As read.
    """
    return float((duty.power * duty.duration).sum())


def duty_notes(duty: MeasuredDuty) -> list[str]:
    """Return what of a record is not used, or is used in a way that its reader must know.

    Args:
        duty: As read.
    """
    told = []
    if duty.temperature is not None:
        low, high = (float(value) - CELSIUS for value in (duty.temperature.min(), duty.temperature.max()))
        told.append(f"Temperatures, {low:.4g} to {high:.4g} °C, were read and are not used: a load spectrum has none")
    if (duty.torque < 0.0).any() and (duty.torque > 0.0).any():
        told.append("Torque changes its sign; both directions are counted together, as if on one flank of the teeth")
    return told


# ----------------------------------------------------------------------------------------------------------------------
# A dynamic window in words: what every speed, torque, force and the pitch did in it.
# ----------------------------------------------------------------------------------------------------------------------


class Range(NamedTuple):
    """What one quantity did in a window, in SI."""

    name: str
    dimension: str
    """Its unit, as `units` knows it."""
    start: float
    """Mean of the first time bin."""
    minimum: float
    """Of every step."""
    maximum: float
    """Of every step."""
    end: float
    """Mean of the last time bin."""


def ranges(window: DynamicWindow) -> tuple[Range, ...]:
    """Return what speeds, torques, pitch and line forces did.

    Args:
        window: As flown.
    """
    return (*_drives(window.trace), *_lines(window.trace))


_DIMENSIONS = {"torque": "torque", "speed": "speed", "slip": "speed", "pitch": "angle"}


def _drives(trace: Trace) -> Iterator[Range]:
    if trace.drive is None:
        return
    for name, owner in zip(trace.labels.drives, trace.labels.drive_owners, strict=True):
        dimension = _DIMENSIONS.get(owner.what)
        if dimension:
            yield _range(trace.drive, name, dimension)


def _lines(trace: Trace) -> Iterator[Range]:
    for name, line_unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if line_unit == "rad":
            yield _range(trace.force, name, "torque")
    for name, line_unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if line_unit == "m":
            yield _range(trace.force, name, "force")


def _range(statistics: Statistics, name: str, dimension: str) -> Range:
    history = statistics.of(name)
    return Range(
        name,
        dimension,
        float(history["mean"][0]),
        float(np.min(history["minimum"])),
        float(np.max(history["maximum"])),
        float(history["mean"][-1]),
    )


def window_text(window: DynamicWindow) -> str:
    """Return what happened in a window as lines of text.

    Args:
        window: As flown.
    """
    trace, rules = window.trace, window.rules
    event = "nothing but the mission" if rules.event == "none" else f"{rules.event} after {rules.event_at:g} s"
    lines = [
        f"{window.name}: {trace.duration:.4g} s of {rules.phase} from {window.start:.0f} s of the mission; {event}",
        "",
        f"{'':28} {'start':>11} {'minimum':>11} {'maximum':>11} {'end':>11}",
        *(_line(row) for row in ranges(window)),
        "",
        *_peaks(window),
        window_verdict(window),
        f"Steps of {trace.step * 1e6:.3g} µs; {Error(trace.error, trace.rms_error).words()}; energies close"
        f" {energy_text(trace.work.imbalance)}",
    ]
    return "\n".join([*lines, *trace.notes[1:]])


def _peaks(window: DynamicWindow) -> Iterator[str]:
    """Yield the peak of every mesh row and shaft beside what it is sized for."""
    yield f"{'peak beside what it is sized for':32} {'peak':>9} {'sized for':>9} {'':3}  margin left"
    for load in window.meshes:
        numbers = f"{shown(load.peak_force, 'force'):9.5g} {shown(load.rated_force, 'force'):9.5g} {unit('force'):3}"
        margins = f"bending {margin_text(load.bending_margin)}, contact {margin_text(load.contact_margin)}"
        yield f"{f'{load.mesh}, tangential':32} {numbers}  {margins}"
    for shaft in window.shafts:
        torques = " ".join(f"{shown(value, 'torque'):9.5g}" for value in (shaft.peak_torque, shaft.rated_torque))
        yield f"{f'{shaft.shaft} shaft':32} {torques} {unit('torque'):3}  yield {margin_text(shaft.margin)}"
    yield ""


def _line(row: Range) -> str:
    numbers = " ".join(f"{shown(value, row.dimension):11.5g}" for value in row[2:])
    return f"{row.name:28} {numbers} {unit(row.dimension)}"


def _stopped(window: DynamicWindow) -> str:
    """Return whether a sudden stop comes to rest."""
    assert window.trace.drive is not None  # every window has drives
    speed = abs(float(window.trace.drive.of("brake speed")["mean"][-1])) * 30.0 / math.pi
    if window.rest is not None:
        after = window.rest - window.rules.event_at
        return f"At rest {after:.3g} s after the event, but for {speed:.2g} rpm that friction needs to hold it"
    return (
        f"Not at rest: what is held still turns at {speed:.4g} rpm; give a longer window, more torque, or lag_s for"
        " machines that fail"
    )


def window_verdict(window: DynamicWindow) -> str:
    """Return whether the governor comes to rest in a window.

    Args:
        window: As flown.
    """
    cycle = window.limit_cycle
    if window.rules.event == "sudden-stop":
        return _stopped(window)
    if cycle is None:
        return "The governor does not limit-cycle"
    return (
        f"The governor limit-cycles at {cycle.frequency:.3g} Hz with {cycle.amplitude:.3g} rad/s"
        f" ({cycle.amplitude * 30.0 / math.pi:.3g} rpm); lower its gain, or give a faster actuator"
    )


# ----------------------------------------------------------------------------------------------------------------------
# A made propeller in words: its blades, its map, and what it does at a point of flight.
# ----------------------------------------------------------------------------------------------------------------------


_SOURCES = {"elements": "by blade elements", "charts": "by the Hamilton Standard charts"}


def blades_line(shape: BladeShape) -> str:
    """Return number, activity factor and design lift of blades.

    Args:
        shape: The blades.
    """
    return f"{shape.number} blades, activity factor {activity_factor(shape):.3g}, C_Li {integrated_lift(shape):.3g}"


def made_text(made: MadePropeller) -> RenderableType:
    """Return a made map for the terminal.

    Args:
        made: The map.
    """
    _, chart = made.maps[0]
    machs = f" at {len(made.maps)} tip Mach numbers" if len(made.maps) > 1 else ""
    lines = [] if made.blades is None else [Text(blades_line(made.blades))]
    angles = f"{len(chart.blade_angle)} blade angles{machs}"
    size = f"{len(chart.advance_ratio)} advance ratios by {angles}, {_SOURCES[made.by]}"
    feather = made.feather
    stands = [] if feather is None else [Text(), Text(_stands(feather))]
    return Group(*lines, Text(size), Text(), table_text(propeller_table(made)), *stands)


def _stands(feather: Feathered) -> str:
    return (
        f"In feather at {text(feather.angle, 'angle')} it stands still, and drags q D² times {feather.drag_area:.4f}:\n"
        f"  for the phases of a mission, extra_drag = {feather.drag_area:.4f} D²/S"
    )


def loads_text(found: PropellerLoads, by: str) -> RenderableType:
    """Return what a propeller does at a point of flight, with the two keys of a design that its incidence gives.

    Args:
        found: At that point.
        by: ``elements`` or ``charts``, which say nothing of incidence.
    """
    point = (
        f"At advance ratio {found.advance_ratio:.4g}, tip Mach {found.tip_mach:.3f}, {_SOURCES[by]},"
        f" blade angle {text(found.blade_angle, 'angle')}:",
        f"  power {text(found.power, 'power')}, torque {text(found.torque, 'torque')},"
        f" thrust {text(found.thrust, 'force')}, efficiency {number_text(found.efficiency, 'ratio')}",
    )
    if by == "charts":
        return Group(*map(Text, point))
    lines = (
        *point,
        f"  by incidence {text(found.in_plane_force, 'force')} across the shaft and"
        f" {text(found.hub_moment, 'torque')} at the hub,",
        f"  which bend the shaft once a turn; each blade by ±{text(found.blade_bending, 'torque')}",
        f"  in a design: in_plane_force_n = {found.in_plane_force:.0f}, hub_moment_nm = {found.hub_moment:.0f},"
        f" thrust_n = {found.thrust:.0f}",
    )
    return Group(*map(Text, lines))


# ----------------------------------------------------------------------------------------------------------------------
# A helicopter's rotors in words: tables over its speed, and the speeds that stand out.
# ----------------------------------------------------------------------------------------------------------------------


def rotor_text(found: RotorTrim) -> RenderableType:
    """Return what the rotors take, for the terminal.

    Args:
        found: Over the speed.
    """
    merit = "" if found.figure_of_merit is None else f"Figure of merit in hover {found.figure_of_merit:.3f}. "
    words = (
        f"{merit}Least power {text(found.least_power, 'power')} at {text(found.least_power_speed, 'velocity')};"
        f" farthest at {text(found.best_range_speed, 'velocity')}."
    )
    parts: list[RenderableType] = []
    for table in rotor_tables(found):
        parts += [table_text(table), Text()]
    return Group(*parts, Text(words))


# ----------------------------------------------------------------------------------------------------------------------
# A turboshaft engine in words: its deck, what a mission says of it, and seconds of a lever, a rotor or a start.
# ----------------------------------------------------------------------------------------------------------------------


def engine_text(made: MadeEngine) -> RenderableType:
    """Return an engine's deck for the terminal.

    Args:
        made: The engine.
    """
    keys, design = made.keys, made.design
    exponents = (
        f"  temperature_exponent = {keys.temperature_exponent:.2f}",
        f"  hot_exponent = {keys.hot_exponent:.2f}",
    )
    lines = (
        f"Its power turbine has an efficiency of {made.power_turbine:.3f}; T_45 is {made.hottest:.0f} K at most.",
        f"This deck of {len(made.rows)} rows is a file with --out deck.csv; a mission then has",
        "  [engine]",
        '  deck = "deck.csv"',
        *exponents,
        f"or, up to {100 * keys.worst_fuel:.0f} % in fuel and {100 * keys.worst_power:.0f} % in power from it,",
        "  [engine]",
        f"  thermal_power_kw = {design.power / 1e3:.4g}",
        f"  fuel_kg_kwh = {design.fuel_per_energy * 3.6e6:.4g}",
        f"  idle_fuel = {keys.idle_fuel:.3f}",
        *exponents,
        f"  air_flow_kg_s = {design.air_flow:.4g}",
    )
    return Group(table_text(deck_table(made)), Text(), Text("\n".join(lines)))


def transient_text(found: EngineTransient) -> RenderableType:
    """Return seconds of an engine for the terminal.

    Args:
        found: As computed.
    """
    return Group(Text(), table_text(transient_table(found)), Text(), Text(_said(found)))


def _said(found: EngineTransient) -> str:
    if found.kind == "start":
        energy = text(found.starter_energy or 0.0, "energy")
        said = f"At idle after {found.settled or 0.0:.1f} s; the starter gave {energy}"
    elif found.settled is None:
        said = "It does not settle in this time"
    elif found.kind == "held rotor":
        said = f"N2 stays within 0.5 % from {found.settled:.2f} s on"
    else:
        said = f"95 % of the change of power have come after {found.settled:.2f} s"
    if found.lowest_rotor is not None and found.highest_rotor is not None:
        said += f"; N2 is from {100 * found.lowest_rotor:.1f} to {100 * found.highest_rotor:.1f} %"
    bound = f"; bound by {', '.join(found.bound)}" if found.bound else "; no limit is reached"
    return f"{said}.\nT_45 up to {found.hottest:.0f} K{bound}."
