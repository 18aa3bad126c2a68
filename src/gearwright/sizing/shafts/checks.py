"""Every check of shafts, carriers, bearings and joints against its limit."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.checks import Check, stressed
from gearwright.identity import Kind, PartId
from gearwright.sizing.bearings import life_check, limit_checks
from gearwright.sizing.carrying import CarrierSizing, ShaftSizing
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing
from gearwright.sizing.shafts.bending import BEARING_SLOPES, GEAR_SLOPE
from gearwright.sizing.shafts.building import Built
from gearwright.spec import Design

LEAST_CRITICAL = 2.0
"""First critical speed over the highest speed [-] (Shigley, 10th ed., §7-6)."""
THICKEST_RIM = 1.2
"""Rim under the teeth over their height from which on it does not weaken them [-] (ISO 6336-3:2019, Y_B = 1)."""
_CLAUSES = {"key": "DIN 6892:2012, C", "spline": "DIN 5480, first sizing", "press-fit": "DIN 7190-1"}


def shaft_checks(shaft: ShaftSizing) -> Iterator[Check]:
    """Yield the check of a shaft of one diameter, or of the section of a built one that its stress is of.

    Args:
        shaft: As sized.
    """
    part, clause = PartId(Kind.SHAFT, shaft.name), "Pulvirenti 2023, eq. 2.47"
    yield stressed(part, "Tresca", clause, shaft.stress, shaft.margin, case=shaft.case)


def carrier_checks(carrier: CarrierSizing) -> Iterator[Check]:
    """Yield the checks of a carrier's pins, of the plate around them and, where it turns, of the plate at its hub.

    Args:
        carrier: As sized.
    """
    part, case = carrier.part, carrier.case
    yield stressed(part, "pin bending", "cantilever", carrier.pin_stress, carrier.pin_margin, case=case)
    yield stressed(part, "pin in its hole", "p = F/(d t)", carrier.hole_pressure, carrier.hole_margin, case=case)
    yield stressed(part, "eye shear", "tear-out, Tresca", carrier.eye_stress, carrier.eye_margin, case=case)
    if carrier.plate_margin is not None:
        yield stressed(part, "plate shear", "Tresca", carrier.plate_stress, carrier.plate_margin, case=case)


def built_checks(built: Built, design: Design) -> Iterator[Check]:
    """Yield every check of a built shaft, its bearings and its joints.

    Args:
        built: The shaft.
        design: With its limits.
    """
    yield from _strength(built.shaft, design)
    yield from _stiffness(built.shaft, design)
    for bearing in built.bearings:
        yield from _bearing(bearing, design)
    for joint in built.joints:
        yield from _joint(joint)
    yield from built.fits


_LAWS = {"asme": "DE-ASME", "goodman": "DE-Goodman", "gerber": "DE-Gerber", "soderberg": "DE-Soderberg"}
"""Criterion -> as tables name it."""


def _strength(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    service, part = design.service, PartId(Kind.SHAFT, shaft.name)
    tired, strained = shaft.weakest, min(shaft.sections, key=lambda section: section.yield_safety)
    law = _LAWS[design.shafting.fatigue]
    yield Check(
        part, "fatigue", f"{law}, Shigley ch. 7", tired.fatigue_safety, service.shaft_fatigue_safety,
        symbol="n_f", place=tired.place, case=tired.case,
    )  # fmt: skip
    yield Check(
        part, "yield", "Shigley eq. 7-16", strained.yield_safety, service.shaft_yield_safety,
        symbol="n_y", place=strained.place, case=strained.case,
    )  # fmt: skip


def _stiffness(shaft: BuiltShaft, design: Design) -> Iterator[Check]:
    part = PartId(Kind.SHAFT, shaft.name)
    for place, slope in shaft.slopes:
        limit = _slope_limit(place, design)
        if limit is not None and slope > 0.0:
            yield Check(part, "slope", "Shigley table 7-2", slope, limit, "slope", at_most=True, place=place)
    if shaft.critical_speed is not None:
        first, asked = shaft.critical_speed, LEAST_CRITICAL * shaft.highest_speed
        yield Check(part, "first critical speed", "Shigley §7-6", first, asked, "speed", exponent=None)


def _slope_limit(place: str, design: Design) -> float | None:
    """Return what is allowed at a gear or a bearing [rad]."""
    return BEARING_SLOPES.get(design.bearings[place].kind) if place in design.bearings else GEAR_SLOPE


def _bearing(bearing: BearingSizing, design: Design) -> Iterator[Check]:
    part, place, taken = PartId(Kind.BEARING, bearing.name), bearing.designation, bearing.bearing
    yield life_check(part, taken, bearing.life, bearing.oiled, bearing.wanted_life, design)
    yield Check(
        part, "static safety", "ISO 76:2006", bearing.static_safety, bearing.wanted_static_safety,
        symbol="s_0", place=place, case=bearing.case,
    )  # fmt: skip
    yield from limit_checks(part, taken, bearing.running, design)


def _joint(joint: JointSizing) -> Iterator[Check]:
    if joint.kind == "integral":
        return
    part, clause = PartId(Kind.JOINT, joint.part, branch=joint.shaft), _CLAUSES[joint.kind]
    pressure, allowed = joint.pressure, joint.allowed_pressure
    yield Check(part, f"{joint.kind} pressure", clause, pressure, allowed, "stress", at_most=True)
    if joint.kind == "press-fit" and joint.speed:
        running, needed = joint.running_pressure, joint.needed_pressure
        yield Check(part, "press-fit pressure at speed", "DIN 7190-1", running, needed, "stress", symbol="p")
    if joint.rim is not None and joint.rim > 0.0:
        clause = "ISO 6336-3:2019, Y_B"
        yield Check(part, "rim under the teeth", clause, joint.rim, THICKEST_RIM, exponent=None, symbol="s_R/h_t")
