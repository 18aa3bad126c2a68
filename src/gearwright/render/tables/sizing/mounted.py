"""What a reader wants to see of built shafts, as tables: steps, strength, stiffness, bearings, joints."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gearwright.render.grid.table import Table, table
from gearwright.sizing import BuiltShaft, Sizing
from gearwright.units import Length, Slope, Speed, text

_STEPS = "From the shaft's first end; of a gear of one piece, the part of its body that stiffens the shaft."
_STRENGTH = (
    "The case that tires each section most. K_f and K_fs are felt at the notch; n_f against fatigue at the asked"
    " reliability, and n_y against yield with the application factor, decide; S_D is what DIN 743 says of the section."
)
_STIFFNESS = "Largest of all cases. Critical speed with the gears as discs, in rigid bearings, without rotors."
_BEARINGS = (
    "Forces of the case with the largest static load; P is the mean over the service. Basic rating life, without a_ISO."
    " Ratings of the assumed inside of a standard size, unless the design gives the maker's."
)
_OILED = (
    "With the oil of [oil]: κ = ν/ν_1 and e_C are the least of all cases. P of the lightest case against what keeps"
    " rolling elements from skidding, speeds against n_θr by ISO 15312: checked where bearing_rules.limits asks for it."
)
_JOINTS = "Torque of the heaviest case with the application factor."
_STRENGTH_FIELDS = (
    "shaft", "place", "case", "position", "diameter", "bending_moment", "torque", "bending_notch", "torsion_notch",
    "fatigue_safety", "yield_safety", "din743_safety",
)  # fmt: skip
_BEARING_FIELDS = (
    "name", "shaft", "designation", "inner_diameter", "outer_diameter", "width", "case", "radial", "axial",
    "equivalent_load", "dynamic_rating", "life", "static_safety", "mass",
)  # fmt: skip
_OILED_FIELDS = (
    "name", "designation", "viscosity_ratio", "contamination", "life_factor", "modified_life", "lightest_load",
    "least_load", "highest_speed", "reference_speed", "speed_factor",
)  # fmt: skip
_JOINT_FIELDS = (
    "part", "shaft", "kind", "designation", "torque", "diameter", "length", "pressure", "allowed_pressure",
)  # fmt: skip


@dataclass(frozen=True)
class Step:
    """One cylinder of one shaft."""

    shaft: str
    seat: str
    """What sits on it."""
    start: Length
    """[m]"""
    end: Length
    """[m]"""
    diameter: Length
    """[m]"""
    bore: Length
    """[m]"""


@dataclass(frozen=True)
class Bend:
    """How far a shaft bends at one place."""

    shaft: str
    place: str
    """Gear or bearing."""
    slope: Slope
    """[rad]"""
    deflection: Length | None
    """None at bearings [m]."""
    critical_speed: Speed | None
    """First one of the shaft in bending [rad/s]."""


def mounted_tables(sizing: Sizing) -> dict[str, Table]:
    """Return the tables of built shafts, bearings and joints by a short name; without rows where there are none.

    Args:
        sizing: As sized.
    """
    shafts, strength = sizing.built_shafts, [section for shaft in sizing.built_shafts for section in shaft.sections]
    steps = [step for shaft in shafts for step in _steps(shaft)]
    bends = [bend for shaft in shafts for bend in _bends(shaft)]
    joined = [joint for joint in sizing.joints if joint.kind != "integral"]
    fitted = ("running_pressure", "needed_pressure") if any(joint.running_pressure for joint in joined) else ()
    return {
        "steps": table("Shafts: steps", steps, ("shaft", "seat", "start", "end", "diameter", "bore"), note=_STEPS),
        "strength": table("Shafts: strength of sections", strength, _STRENGTH_FIELDS, note=_STRENGTH),
        "stiffness": table("Shafts: how they bend", bends,
                           ("shaft", "place", "slope", "deflection", "critical_speed"), note=_STIFFNESS),
        "bearing_sizes": table("Bearings", sizing.bearings, _BEARING_FIELDS, note=f"{_BEARINGS}{_system(sizing)}"),
        "bearing_oil": table("Bearings: oil, least load, speeds", sizing.bearings, _OILED_FIELDS, note=_OILED),
        "joints": table("Shaft-hub joints", joined, (*_JOINT_FIELDS, *fitted), note=_JOINTS),
    }  # fmt: skip


def _steps(shaft: BuiltShaft) -> Iterator[Step]:
    for step in shaft.steps:
        yield Step(shaft.name, step.seat, step.start, step.end, step.diameter, shaft.bore)


def _bends(shaft: BuiltShaft) -> Iterator[Bend]:
    deflections = dict(shaft.deflections)
    for place, slope in shaft.slopes:
        yield Bend(shaft.name, place, slope, deflections.get(place), shaft.critical_speed)


def _system(sizing: Sizing) -> str:
    """Return what all bearings together live and weigh."""
    if sizing.system_life is None:
        return ""
    life, mass = text(sizing.system_life, "life"), text(sizing.bearing_mass, "mass")
    return f" All of them reach {life} with 90 % reliability (Weibull's product) and weigh {mass}."
