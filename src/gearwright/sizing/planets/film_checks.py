"""Checks of plain bearings of planets: pressure, film, temperature, laminar flow, and room in the rim."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gearwright.checks import Check, Status, not_assessed
from gearwright.parts.bearings import laminar_limit
from gearwright.ranking import largest, smallest
from gearwright.sizing.bearings import Carrying, Seat, borne_by, planet_seats, unit_loads
from gearwright.sizing.planets.films import STANDING, design_oil, judged
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.units import CELSIUS

HELP = "a wider or larger film, thinner rims (gears.rim_thickness_ratio), more planets or a slower carrier would help"
"""What helps a film that is pressed too hard."""


def film_checks(context: Context, gears: tuple[GearSizing, ...], carriers: Sequence[Carrying]) -> Iterator[Check]:
    """Yield what is asked of every film between a planet and its pin, each in its worst case.

    Args:
        context: What sizing reads.
        gears: As sized.
        carriers: As sized.
    """
    if any(gear.runs_on is not None and gear.runs_on.journal is not None for gear in gears):
        for seat in planet_seats(unit_loads(context), gears, carriers):
            if seat.runs_on is not None and seat.runs_on.journal is not None:
                yield from (_advised(check) for check in _checks(context, seat))


def _advised(check: Check) -> Check:
    return replace(check, why=HELP) if check.status is Status.FAILS else check


def _checks(context: Context, seat: Seat) -> Iterator[Check]:
    assert seat.runs_on is not None and seat.runs_on.journal is not None and seat.fitted is not None
    load, journal, asked = borne_by(context, seat), seat.runs_on.journal, seat.fitted
    oil, cases, place = design_oil(context.design, asked), tuple(context.flows), seat.runs_on.designation
    films = list(judged(journal, load, asked, oil))
    pressed = largest(range(len(cases)), lambda case: load.radial[case])
    pressure = float(load.radial[pressed]) / (journal.width * journal.diameter)
    yield Check(
        seat.part, "film pressure", "ISO 7902-3, p_lim", pressure, asked.largest_pressure, "stress",
        at_most=True, symbol="p", place=place, case=cases[pressed],
    )  # fmt: skip
    if not films:
        why = f"the planet turns on its pin in no case ({STANDING:g} rad/s or more), and a film needs that"
        yield not_assessed(seat.part, "film thickness", "ISO 7902-1", why)
        return
    thin, hot = (
        smallest(films, lambda film: film.state.film / film.least_film),
        largest(films, lambda film: film.state.exit),
    )
    wild = largest(films, lambda film: film.state.reynolds)
    yield Check(
        seat.part, "film thickness", "ISO 7902-1, h_min", thin.state.film, thin.least_film, "film_thickness",
        symbol="h_min", place=place, case=cases[thin.case],
    )  # fmt: skip
    yield Check(
        seat.part, "oil at the exit", "ISO 7902-1, T_ex", hot.state.exit - CELSIUS, asked.largest_temperature,
        "temperature", at_most=True, exponent=None, symbol="T_ex", place=place, case=cases[hot.case],
    )  # fmt: skip
    yield Check(
        seat.part, "laminar film", "Taylor 1923, 41.3/√ψ", wild.state.reynolds, laminar_limit(journal.clearance),
        "number", at_most=True, exponent=None, symbol="Re", place=place, case=cases[wild.case],
    )  # fmt: skip
    yield Check(
        seat.part, "room in the rim", "rim_thickness_ratio", seat.runs_on.outer_diameter, seat.room, "length",
        at_most=True, exponent=None, place=place,
    )  # fmt: skip
