"""What stepped planets turn on: places of both steps along the pin, and the strongest bearing that each step holds."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.catalogue import bearings
from gearwright.parts.bearings import BearingKind
from gearwright.sizing import Sizing, size
from gearwright.spec import Design, edited
from gearwright.spec.edit import Value

GAP = 5e-3
"""Between the plate and the wide step, and between the steps [m]; an estimate."""
STEPS = ("wide", "narrow")
"""Of a stepped planet, from the plate on."""
_SMALLEST = "NU 202"
_MM = 1e-3


def borne(design: Design) -> Design:
    """Return a design whose stepped planets have places and cylindrical roller bearings in both steps.

    Rolling bearings in a stepped planet are not chosen by sizing: each step gets the strongest of the catalogue that
    its rim and its face hold. Whether that lives is for the checks to say. Designs without such sets stay as they are.

    Args:
        design: At level preliminary.

    Raises:
        DesignError: As `size`.
    """
    if not design.epicyclics:
        return design
    standing = edited(design, dict(_standing(size(design))))
    return edited(standing, dict(_strongest(size(standing))))


def _standing(sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield where both steps of every stepped planet stand along their pin, with the smallest bearing in each."""
    for name in sizing.design.epicyclics:
        place = GAP
        for step in STEPS:
            width = next(gear.face_width for gear in sizing.gears if (gear.stage, gear.own) == (name, step))
            yield f"{_path(name, step)}.place_mm", (place + width / 2.0) / _MM
            yield f"{_path(name, step)}.bearing", {"designation": _SMALLEST}
            place += width + GAP


def _strongest(sizing: Sizing) -> Iterator[tuple[str, Value]]:
    """Yield the cylindrical roller bearing with the largest rating that stands in each step."""
    rollers = [one for one in bearings().values() if one.kind is BearingKind.CYLINDRICAL]
    for name in sizing.design.epicyclics:
        for step in STEPS:
            gear = next(gear for gear in sizing.gears if (gear.stage, gear.own) == (name, step))
            room = next(_rooms(sizing, name, step), 0.0)
            fitting = [one for one in rollers if one.outer_diameter <= room and one.width <= gear.face_width]
            if fitting:
                best = max(fitting, key=lambda one: (one.dynamic_rating, one.designation))
                yield f"{_path(name, step)}.bearing", {"designation": best.designation}


def _rooms(sizing: Sizing, stage: str, step: str) -> Iterator[float]:
    """Yield the largest outside that the rim of a step leaves a bearing [m]."""
    for check in sizing.checks:
        if check.mode == "room in the rim" and (check.part.name, check.part.own) == (stage, step):
            yield check.limit or 0.0


def _path(stage: str, step: str) -> str:
    return f"epicyclics.{stage}.planets.{step}"
