"""How far webs of wheels may stand aside at their hubs; a design whose webs stand further is refused by its sizing."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem, refuse
from gearwright.identity import Role
from gearwright.parts.bevel import bevel_dishes
from gearwright.sizing.mass.bodies import (
    Seats,
    bevel_cones,
    bevel_hub,
    bevel_web,
    gear_blank,
    kind_of,
    shaft_diameters,
)
from gearwright.sizing.result import GearSizing, Sizing


def refuse_dishes(sizing: Sizing) -> None:
    """Refuse every web that does not meet rim and hub with all of its thickness, and a dish of a wheel without a web.

    Args:
        sizing: With shafts.

    Raises:
        DesignError: With where the dish is written, how far the web may lean, and what to write.
    """
    if any(sizing.design.rules(name).web_dish for name in sizing.design.pairs):
        seats = Seats({}, shaft_diameters(sizing))
        wheels = [gear for gear in sizing.gears if gear.role is Role.WHEEL and gear.stage in sizing.design.pairs]
        refuse(problem for wheel in wheels for problem in _dish_problems(sizing, wheel, seats))


def _dish_problems(sizing: Sizing, wheel: GearSizing, seats: Seats) -> Iterator[Problem]:
    """Yield what is wrong with the dish of one wheel."""
    dish, path = sizing.design.rules(wheel.stage).web_dish, sizing.design.key_of(wheel.stage, "gears.web_dish")
    own = path != "gears.web_dish"
    limits = _dishes(sizing, wheel, seats)
    if not dish:
        return
    if limits is None:
        if own:
            yield Problem(path, f"{dish:g} given; {wheel.name} has no web between rim and hub: leave it out")
        return
    low, high = _inwards(limits)
    if low <= dish <= high:
        return
    lean = "must be 0" if low >= high else f"must be from {low:g} to {high:g}"
    why = f"{lean}, so that the web of {wheel.name} meets rim and hub with all of its thickness"
    fix = "lean it less" if own or len(sizing.design.pairs) == 1 else (
        f"lean it less, or write another web_dish in [pairs.{wheel.stage}.gears]"
    )  # fmt: skip
    yield Problem(path, f"{dish:g} given; {why}: {fix}")


def _dishes(sizing: Sizing, wheel: GearSizing, seats: Seats) -> tuple[float, float] | None:
    """Return the least and the largest dish of a wheel; None of one without a web."""
    if wheel.rim:
        return None
    blank = gear_blank(sizing, wheel, seats)
    if kind_of(sizing, wheel) == "bevel":
        bore = blank.bore_radius
        web, hub = bevel_web(sizing, wheel, bore), bevel_hub(sizing, wheel, bore)
        return bevel_dishes(bevel_cones(sizing, wheel.stage), 1, bore, web, hub)
    height, halves = blank.rim_radius - blank.hub_radius, max(wheel.bodies // max(len(wheel.shafts), 1), 1)
    joint = sizing.design.joints.get(wheel.name)
    if height <= 0.0 or (joint is not None and joint.kind == "integral"):
        return None
    most = halves * (blank.width - blank.web_width) / 2.0 / height
    return -most, most


def _inwards(limits: tuple[float, float]) -> tuple[float, float]:
    """Return limits with four decimals, either of which is allowed itself."""
    low, high = (math.ceil(1e4 * limits[0]) / 1e4, math.floor(1e4 * limits[1]) / 1e4)
    return low, high
