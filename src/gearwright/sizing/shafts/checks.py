"""Every check of built shafts, bearings and joints against its limit."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.sizing.mounted import BearingSizing, BuiltShaft, Check, JointSizing
from gearwright.sizing.shafts.bending import BEARING_SLOPES, GEAR_SLOPE
from gearwright.sizing.shafts.building import Built
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
    yield from built.fits


def _shaft(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    service, rules, name = design.service, design.shafting, shaft.name
    tired, strained = shaft.weakest, min(shaft.sections, key=lambda section: section.yield_safety)
    law = "DE-ASME" if rules.fatigue == "asme" else "DE-Goodman"
    fatigue, asked = tired.fatigue_safety, service.shaft_fatigue_safety
    yield Check(name, f"fatigue n_f, {tired.place}", f"{law}, Shigley ch. 7", fatigue, asked, case=tired.case)
    first, asked = strained.yield_safety, service.shaft_yield_safety
    yield Check(name, f"yield n_y, {strained.place}", "Shigley eq. 7-16", first, asked, case=strained.case)
    for place, slope in shaft.slopes:
        limit = _slope_limit(place, design)
        if limit is not None and slope > 0.0:
            yield Check(name, f"slope at {place}", "Shigley table 7-2", slope, limit, "slope", at_most=True)
    if shaft.critical_speed is not None:
        asked = LEAST_CRITICAL * shaft.highest_speed
        yield Check(name, "first critical speed", "Shigley §7-6", shaft.critical_speed, asked, "speed")


def _slope_limit(place: str, design: Design) -> float | None:
    """Return what is allowed at a gear or a bearing [rad]."""
    return BEARING_SLOPES.get(design.bearings[place].kind) if place in design.bearings else GEAR_SLOPE


def _bearing(bearing: BearingSizing) -> Iterator[Check]:
    named, safety = f"{bearing.name} ({bearing.designation})", bearing.static_safety
    yield Check(named, "life L_10h", "ISO 281:2007", bearing.life, bearing.wanted_life, "life")
    yield Check(named, "static safety s_0", "ISO 76:2006", safety, bearing.wanted_static_safety, case=bearing.case)


def _joint(joint: JointSizing) -> Iterator[Check]:
    if joint.kind == "integral":
        return
    part, clause = f"{joint.part} on {joint.shaft}", _CLAUSES[joint.kind]
    pressure, allowed = joint.pressure, joint.allowed_pressure
    yield Check(part, f"{joint.kind} pressure", clause, pressure, allowed, "stress", at_most=True)
    if joint.rim is not None and joint.rim > 0.0:
        yield Check(part, "rim under the teeth s_R/h_t", "ISO 6336-3:2019, Y_B", joint.rim, THICKEST_RIM)
