"""The words of REXS that gearwright writes and reads: attributes with their units, and what units mean in SI."""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Literal, NamedTuple

Version = Literal["1.7", "1.6"]
VERSIONS: tuple[Version, ...] = ("1.7", "1.6")
"""Versions of REXS that are written, the usual one first."""
OWN = ("custom_gearwright_design", "custom_gearwright_gear", "custom_gearwright_mesh")
"""Attributes of gearwright's own, as REXS lets applications have them: the design as TOML, and the gear and the mesh
row of it that a component is."""
DESIGN, GEAR, MESH = OWN
BEARING_TYPES = {
    "deep-groove": "radial_grooved_ball_bearing",
    "cylindrical": "radial_roller_bearing",
    "taper": "radial_tapered_roller_bearing",
    "four-point": "four_point_contact_ball_bearing",
}
"""Kind of a bearing in a design -> in REXS."""
ABSORBS = {"none": "no_direction", "both": "both_directions", "first": "negative", "second": "positive"}
"""Where a bearing holds its shaft in a design -> in REXS."""


class Unit(NamedTuple):
    """A unit as REXS spells it."""

    dimension: str
    """What is measured in it."""
    factor: float
    """Of it in the unit that gearwright counts in: SI, but °C, mm²/s and HV [-]."""


_PER_MINUTE, _DEGREE, _HOUR = math.pi / 30.0, math.pi / 180.0, 3600.0
UNITS: Mapping[str, Unit] = {
    "none": Unit("number", 1.0), "": Unit("number", 1.0), "%": Unit("number", 0.01),
    "mm": Unit("length", 1e-3), "m": Unit("length", 1.0), "mum": Unit("length", 1e-6),
    "deg": Unit("angle", _DEGREE), "°": Unit("angle", _DEGREE), "rad": Unit("angle", 1.0),
    "1 / min": Unit("speed", _PER_MINUTE), "rad / s": Unit("speed", 1.0), "1 / s": Unit("speed", 2.0 * math.pi),
    "N m": Unit("torque", 1.0), "N": Unit("force", 1.0), "kN": Unit("force", 1e3),
    "kW": Unit("power", 1e3), "W": Unit("power", 1.0),
    "N / mm^2": Unit("stress", 1e6), "MPa": Unit("stress", 1e6), "Pa": Unit("stress", 1.0),
    "kg": Unit("mass", 1.0), "kg / dm^3": Unit("density", 1e3),
    "h": Unit("time", _HOUR), "s": Unit("time", 1.0),
    "C": Unit("temperature", 1.0), "mm^2 / s": Unit("viscosity", 1.0), "HV": Unit("hardness", 1.0),
}  # fmt: skip
"""Unit as files write it -> what it measures."""


class Word(NamedTuple):
    """An attribute of REXS."""

    unit: str
    """In which the database gives it."""
    kind: str
    """Such as ``floating_point``."""
    since: Version
    """First version that is written and has it."""


@cache
def words() -> Mapping[str, Word]:
    """Return attribute -> its unit and kind, of all that gearwright writes or reads."""
    text = files("gearwright.exchange.rexs").joinpath("attributes.csv").read_text(encoding="utf-8")
    rows = csv.DictReader(text.splitlines())
    return {row["attribute"]: Word(row["unit"], row["kind"], _version(row["since"])) for row in rows}


def _version(text: str) -> Version:
    return next(version for version in VERSIONS if version == text)


def spellings(dimension: str) -> list[str]:
    """Return the units in which a dimension may be written.

    Args:
        dimension: Such as ``length``.
    """
    return [name for name, unit in UNITS.items() if unit.dimension == dimension and name]
