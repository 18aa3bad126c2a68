"""Gears of a planetary stage as sets hold them: halves put together, helical teeth by their transverse section."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from gearwright.errors import DesignError
from gearwright.exchange.rexs.files import Component
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.exchange.rexs.reading.bodies import Bodies
from gearwright.exchange.rexs.reading.gearing import NEAR, Gear, Table
from gearwright.parts.gears.working_centre import shifts_at, working_centre


def members(asking: Asking, bodies: Bodies, whole: Component, gears: Sequence[Gear]) -> dict[int, Gear]:
    """Return id of every gear -> the spur gear that stands for it; the two halves of a double-helical one have one.

    Args:
        asking: The document.
        bodies: What of it turns as one.
        whole: The planetary stage.
        gears: All of it.
    """
    found: dict[int, Gear] = {}
    for gear in gears:
        half = next((other for other in found.values() if _are_halves(bodies, other, gear)), None)
        if half is None:
            found[gear.number] = gear
        else:
            found[half.number] = found[gear.number] = replace(half, width=half.width + gear.width, helix=half.helix)
    if any(gear.helix for gear in gears):
        angle = math.degrees(max(abs(gear.helix) for gear in gears))
        said = (
            f"its teeth of {angle:.4g}° are read as spur ones of the same transverse section, as sets of a design are"
        )
        asking.notes.append(f"line {whole.line}: {whole.path}: {said}")
    return {number: transverse(gear) for number, gear in found.items()}


def _are_halves(bodies: Bodies, one: Gear, other: Gear) -> bool:
    return (
        one.helix == -other.helix != 0.0
        and (one.component.kind, one.teeth, one.module) == (other.component.kind, other.teeth, other.module)
        and bodies.of(one.shaft) == bodies.of(other.shaft)
    )


def transverse(gear: Gear) -> Gear:
    """Return the spur gear that has the transverse section of a helical one.

    Args:
        gear: Of any helix angle.

    Source: ISO 21771:2007, m_t = m_n/cos β, tan α_t = tan α_n/cos β, x_t = x_n cos β.
    """
    if gear.helix == 0.0:
        return gear
    slope = math.cos(gear.helix)
    shift = None if gear.shift is None else gear.shift * slope
    angle = math.atan(math.tan(gear.pressure_angle) / slope)
    return replace(gear, module=gear.module / slope, helix=0.0, shift=shift, pressure_angle=angle)


def shifts_that_close(
    asking: Asking, whole: Component, members: tuple[Gear, Gear, Gear], centre: float | None
) -> Table:
    """Return the profile shifts of a simple set, without those that do not close where its other gears do.

    Args:
        asking: The document.
        whole: The planetary stage.
        members: Sun, a planet and ring, of spur teeth.
        centre: Centre distance as stated [m]; None where it is not.
    """
    sun, planet, ring = members
    shifts = {"sun_shift": sun.shift, "planet_shift": planet.shift, "ring_shift": ring.shift}
    try:
        stands = _stands(sun, planet, centre)
        if stands is not None and sun.shift is not None:
            shifts["planet_shift"] = _follows(asking, whole, planet, sun, (1, stands))
        known = shifts["planet_shift"]
        if stands is not None and known is None and sun.shift is not None:
            known = _sum(sun, planet, 1, stands) - sun.shift
        if stands is not None and known is not None:
            shifts["ring_shift"] = _follows(asking, whole, ring, replace(planet, shift=known), (-1, stands))
    except DesignError:  # base circles that do not reach each other: the design is refused in its own words
        pass
    return {key: shift for key, shift in shifts.items() if shift is not None}


def _stands(sun: Gear, planet: Gear, centre: float | None) -> float | None:
    """Return the working centre distance over the module [-]."""
    if centre is not None:
        return centre / sun.module
    if sun.shift is None or planet.shift is None:
        return None
    return working_centre(
        sun.teeth + planet.teeth, sun.shift + planet.shift, pressure_angle=sun.pressure_angle, helix_angle=0.0
    )


def _sum(one: Gear, other: Gear, sign: int, stands: float) -> float:
    return shifts_at(one.teeth + sign * other.teeth, stands, pressure_angle=one.pressure_angle, helix_angle=0.0)


def _follows(asking: Asking, whole: Component, gear: Gear, mate: Gear, meets: tuple[int, float]) -> float | None:
    """Return the shift of a gear; None where it does not close with its mate and so follows from it."""
    if gear.shift is None or mate.shift is None:
        return gear.shift
    sign, stands = meets
    closes = _sum(mate, gear, sign, stands) - mate.shift
    if abs(closes - gear.shift) <= NEAR:
        return gear.shift
    said = f"{gear.component.path} has a profile shift of {gear.shift:.4g}, which does not close: {closes:.4g} does"
    asking.notes.append(f"line {whole.line}: {whole.path}: {said}")
    return None


def closing(asking: Asking, whole: Component, planet: Gear, centrals: Sequence[Gear]) -> dict[int, float | None]:
    """Return sun or ring -> its shift, None where it follows as it does not close where the first of them does.

    Args:
        asking: The document.
        whole: The planetary stage.
        planet: Of spur teeth.
        centrals: What it meets, in the order in which they are trusted.
    """
    stands: float | None = None
    found: dict[int, float | None] = {}
    for gear in centrals:
        sign = -1 if gear.component.kind == "ring_gear" else 1
        found[gear.number] = gear.shift
        if gear.shift is None or planet.shift is None:
            continue
        if stands is None:
            sums, shifts = planet.teeth + sign * gear.teeth, planet.shift + gear.shift
            stands = working_centre(sums, shifts, pressure_angle=gear.pressure_angle, helix_angle=0.0)
        else:
            found[gear.number] = _follows(asking, whole, gear, planet, (sign, stands))
    return found
