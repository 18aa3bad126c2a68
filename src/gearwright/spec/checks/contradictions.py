"""Wishes that contradict each other, both named: sides and angles, pins given twice, overlap wider than is allowed.

Keep-outs without a body are found here, too.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.spec.design import RATINGS, SIDE_ANGLES, Design, GearRules, given_values
from gearwright.units import text

_SAME = 1e-9
"""Part by which two lengths may differ that are one [-]."""


_THIN = 1e-6
"""Edges and axes of a keep-out that are shorter are none [m]."""


def contradiction_problems(design: Design) -> Iterator[Problem]:
    """Yield wishes that contradict each other, and keep-outs that enclose nothing or say no reason.

    Args:
        design: As typed.
    """
    yield from _places(design)
    yield from _pins(design)
    yield from _overlaps(design)


def _pins(design: Design) -> Iterator[Problem]:
    given = given_values(design).values
    for name, stage in design.planetaries.items():
        pin, bearing = given.get(f"{name}.pin_diameter"), stage.planet_bearing
        if pin is None or bearing is None or bearing.diameter is None:
            continue
        if abs(bearing.diameter - pin.value) > _SAME * pin.value:
            message = (
                f"{text(bearing.diameter, 'length')}, but {pin.entry} gives the same pin {text(pin.value, 'length')};"
                " keep one of them"
            )
            yield Problem(f"planetaries.{name}.planet_bearing.diameter", message)


def _overlaps(design: Design) -> Iterator[Problem]:
    """Find overlap ratios that are asked of gears whose face may not be as wide; the usual one yields by itself."""
    rules = {"gears": design.gears} if design.pairs else {}
    rules |= {f"pairs.{name}.gears": own for name, pair in design.pairs.items() if (own := pair.gears) is not None}
    for path, rule in rules.items():
        whole = rule if path == "gears" else design.rules(path.split(".")[1])
        if "overlap_ratio" in rule.model_fields_set and whole.face_width_ratio is None and whole.helix_angle > 0.0:
            yield from _too_wide(path, whole)


def _too_wide(path: str, rule: GearRules) -> Iterator[Problem]:
    table = RATINGS[rule.rating].table
    if not table:
        return
    asked = rule.overlap_ratio * math.pi / math.sin(rule.helix_angle)
    allowed = getattr(rule, table).widest_modules
    if asked > allowed * (1.0 + _SAME):
        lean = math.asin(min(rule.overlap_ratio * math.pi / allowed, 1.0))
        message = (
            f"{rule.overlap_ratio:g} asks for a face of {asked:.4g} modules at a helix angle of"
            f" {text(rule.helix_angle, 'angle')}, but {path}.{table}.widest_modules allows {allowed:g}; ask for less,"
            f" lean the teeth by {text(lean, 'angle')}, or allow wider faces"
        )
        yield Problem(f"{path}.overlap_ratio", message)


def _places(design: Design) -> Iterator[Problem]:
    """Find angles that point away from their sides, and keep-outs that enclose nothing or say no reason."""
    for name, layout in design.layout.items():
        if layout.side is None or layout.angle is None:
            continue
        off = layout.angle - SIDE_ANGLES[layout.side]
        if math.cos(off) <= 0.0:
            message = (
                f"{layout.side!r} contradicts angle_deg = {math.degrees(layout.angle):g}; leave one of them out, or"
                f" give an angle within 90° of {math.degrees(SIDE_ANGLES[layout.side]):g}"
            )
            yield Problem(f"layout.{name}.side", message)
    for name, keep in design.keep_out.items():
        edges = [abs(end - start) for start, end in ((getattr(keep.start, k), getattr(keep.end, k)) for k in "xyz")]
        if keep.radius is None and min(edges) < _THIN:
            thin = ", ".join(k for k, edge in zip("xyz", edges, strict=True) if edge < _THIN)
            message = f"the box is flat: start and end are equal in {thin}; give it a thickness, or a radius_mm"
            yield Problem(f"keep_out.{name}.end", message)
        if keep.radius is not None and math.hypot(*edges) < _THIN:
            message = "start and end of the cylinder's axis are one place; give it a length"
            yield Problem(f"keep_out.{name}.end", message)
        if not keep.reason.strip():
            yield Problem(f"keep_out.{name}.reason", "is empty; write what is there")
