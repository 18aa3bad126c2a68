"""Whether what a planet turns on has room inside it."""

from __future__ import annotations

from gearwright.checks import Check
from gearwright.identity import Kind
from gearwright.sizing.bearings.planet_bodies import PlanetBody, planet_bodies
from gearwright.sizing.result import GearSizing
from gearwright.spec import Design


def named_room(design: Design, gears: tuple[GearSizing, ...]) -> tuple[Check, ...]:
    """Return whether the bearings that a design names have room in its planets, and planets beside their carrier.

    Bearings in one step of a body have the width of all its steps; those in several steps each that of their own.

    Args:
        design: As read.
        gears: As sized.
    """
    checks = list[Check]()
    for body in planet_bodies(design, gears):
        for step, place in zip(body.steps, body.places, strict=False):
            checks.append(_beside_plate(step, place))
        for fitting in body.fittings:
            own = body if len(body.fittings) == 1 else body._replace(steps=(fitting.step,))
            checks.append(planet_room(own, fitting.runs_on.designation, fitting.width))
    return tuple(checks)


def planet_room(body: PlanetBody, designation: str, width: float) -> Check:
    """Return whether what a planet turns on is as wide as the planet at most.

    Args:
        body: The planet, or the steps that the bearings stand in.
        designation: Of the bearings.
        width: Of all that stand side by side [m].
    """
    part = body.part._replace(kind=Kind.GEAR)
    return Check(
        part, "room for its bearing", "width of bearings and gear", width, body.width, "length",
        at_most=True, exponent=None, place=f"{designation} in {part}",
    )  # fmt: skip


def _beside_plate(step: GearSizing, place: float) -> Check:
    """Return whether a planet stands clear of the plate of its carrier."""
    return Check(
        step.part, "room beside the plate", "half its width, and its place", step.face_width / 2.0, place, "length",
        at_most=True, exponent=None,
    )  # fmt: skip
