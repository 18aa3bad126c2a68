"""Every check of built shafts, bearings and joints against its limit."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.sizing.bending import BEARING_SLOPES, GEAR_SLOPE
from gearwright.sizing.building import Built
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, Check, JointSizing
from gearwright.spec import Design

LEAST_CRITICAL = 2.0
"""First critical speed over the highest speed [-] (Shigley, 10th ed., §7-6)."""
THICKEST_RIM = 1.2
"""Rim under the teeth over their height from which on it does not weaken them [-] (ISO 6336-3:2019, Y_B = 1)."""
_CLAUSES = {"key": "DIN 6892:2012, C", "spline": "DIN 5480, first sizing", "press-fit": "DIN 7190-1"}


def checks_of(built: Built, design: Design) -> Iterator[Check]:
    """Yield every check of a built shaft, its bearings and its joints.

    Args:
        built: The shaft.
        design: With its limits.
    """
    yield from _shaft(built.shaft, design)
    for bearing in built.bearings:
        yield from _bearing(bearing)
    for joint in built.joints:
        yield from _joint(joint)


def _shaft(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    service, rules = design.service, design.shafting
    tired = shaft.weakest
    yielding = min(shaft.sections, key=lambda each: each.yield_safety)
    law = "DE-ASME" if rules.fatigue == "asme" else "DE-Goodman"
    yield Check(
        shaft.name,
        f"fatigue n_f, {tired.place}",
        f"{law}, Shigley ch. 7",
        tired.fatigue_safety,
        service.shaft_fatigue_safety,
        tired.case,
    )
    yield Check(
        shaft.name,
        f"yield n_y, {yielding.place}",
        "Shigley eq. 7-16",
        yielding.yield_safety,
        service.shaft_yield_safety,
        yielding.case,
    )
    for place, slope in shaft.slopes:
        limit = _slope_limit(place, design)
        if limit is not None and slope > 0.0:
            yield Check(shaft.name, f"slope at {place}", "Shigley table 7-2", slope, limit, "", "angle", at_most=True)
    if shaft.critical_speed is not None:
        least = LEAST_CRITICAL * shaft.highest_speed
        yield Check(shaft.name, "first critical speed", "Shigley §7-6", shaft.critical_speed, least, "", "speed")


def _slope_limit(place: str, design: Design) -> float | None:
    """Return what is allowed at a gear or a bearing [rad]."""
    return BEARING_SLOPES.get(design.bearings[place].kind) if place in design.bearings else GEAR_SLOPE


def _bearing(bearing: BearingSizing) -> Iterator[Check]:
    named = f"{bearing.name} ({bearing.bearing.designation})"
    yield Check(named, "life L_10h", "ISO 281:2007", bearing.life, bearing.wanted_life, "", "time")
    yield Check(
        named, "static safety s_0", "ISO 76:2006", bearing.static_safety, bearing.wanted_static_safety, bearing.case
    )


def _joint(joint: JointSizing) -> Iterator[Check]:
    if joint.kind == "integral":
        return
    part = f"{joint.part} on {joint.shaft}"
    yield Check(
        part, f"{joint.kind} pressure", _CLAUSES[joint.kind], joint.pressure, joint.allowed_pressure, "", "stress",
        at_most=True,
    )  # fmt: skip
    if joint.rim is not None:
        yield Check(part, "rim under the teeth s_R/h_t", "ISO 6336-3:2019, Y_B", joint.rim, THICKEST_RIM)
