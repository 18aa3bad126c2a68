"""How the bearings that a design names for its planets bear the load cases: life, static safety, room for the pin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from gearwright.catalogue import Bearing, check_bearing
from gearwright.checks import Check, Status
from gearwright.parts.bearings import pair_factor
from gearwright.sizing.bearings.borne import borne_by, planet_duty
from gearwright.sizing.bearings.planet_seats import planet_seats
from gearwright.sizing.bearings.run_checks import life_check, limit_checks
from gearwright.sizing.bearings.running import oiled_life, running_of
from gearwright.sizing.bearings.seat import Seat
from gearwright.sizing.bearings.unit_loads import unit_loads
from gearwright.sizing.carrying import CarrierSizing
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing

HELP = (
    "no size that has room lives as long: take a plain bearing, more planets, thinner rims"
    " (gears.rim_thickness_ratio), a slower carrier, or one that stands still"
)
"""What would help where no rolling bearing lives as long as is asked."""


def planet_lives(
    context: Context, gears: tuple[GearSizing, ...], carriers: tuple[CarrierSizing, ...]
) -> tuple[Check, ...]:
    """Return life, static safety and room of every rolling bearing that the design asks for in its planets.

    Args:
        context: What sizing reads.
        gears: As sized.
        carriers: As sized.

    Source: ISO 281:2007 and ISO 76:2006; equal bearings side by side bear i^0.7 (balls) or i^(7/9) (rollers) times the
        rating of one, ISO 281:2007, 5.1.2 and 7.1.2, and i times its static rating.
    """
    named = context.design
    if not any(stage.planet_bearing for stage in named.planetaries.values()) and not any(
        planet.bearing for epicyclic in named.epicyclics.values() for planet in epicyclic.planets.values()
    ):
        return ()
    seats = planet_seats(unit_loads(context), gears, carriers)
    return tuple(
        check
        for seat in seats
        if seat.runs_on is not None and seat.runs_on.bearing is not None
        for check in _checks(context, seat)
    )


def _checks(context: Context, seat: Seat) -> Iterator[Check]:
    assert seat.runs_on is not None and seat.runs_on.bearing is not None
    fitted, borne = seat.runs_on.bearing, borne_by(context, seat)
    duty = planet_duty(context, seat, fitted, borne)
    check, place = check_bearing(fitted, duty), fitted.designation
    oiled = oiled_life(context.design, fitted, duty, path=seat.path)
    static = check.static_safety * seat.side_by_side / pair_factor(fitted.kind, seat.side_by_side)
    yield _advised(life_check(seat.part, fitted, check.life, oiled, duty.life, context.design), seat)
    yield Check(
        seat.part, "static safety", "ISO 76:2006", static, duty.static_safety,
        symbol="s_0", place=place, case=tuple(context.flows)[int(np.argmax(borne.radial))],
    )  # fmt: skip
    yield from limit_checks(seat.part, fitted, running_of(fitted, duty), context.design)
    yield from _room(seat, fitted)


def _advised(check: Check, seat: Seat) -> Check:
    """Return the check of a life with what would help, where it falls short and the design left the size open."""
    if check.status is not Status.FAILS or seat.fitted is None or seat.fitted.designation is not None:
        return check
    return replace(check, why=HELP)


def _room(seat: Seat, fitted: Bearing) -> Iterator[Check]:
    """Yield whether the pin goes through a bearing, and whether the rim around it stays as thick as its rules ask."""
    yield Check(
        seat.part, "room around the pin", "diameter of the pin", fitted.bore, seat.bore, "length",
        exponent=None, place=fitted.designation,
    )  # fmt: skip
    yield Check(
        seat.part, "room in the rim", "rim_thickness_ratio", fitted.outer_diameter, seat.room, "length",
        at_most=True, exponent=None, place=fitted.designation,
    )  # fmt: skip
