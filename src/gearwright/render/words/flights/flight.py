"""A flight in words: phases, energies, heat and the part that fails first."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.mission import Durability, Flight, LifeSizing, PartLife, PhaseSummary, phase_summaries
from gearwright.render.words.flights.forces import forces_text
from gearwright.render.words.headline import energy_text, headline
from gearwright.reviews import Review
from gearwright.units import CELSIUS, KWH

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
