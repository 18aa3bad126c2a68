"""Gear steels by heat treatment, quality grade and hardness, read from the package's table of ISO 6336-5."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from typing import Any

from gearwright.catalogue.tables import data_text
from gearwright.errors import DesignError, Problem, near
from gearwright.parts.iso6336 import GearSteel, StrengthLine, Treatment, allowable_stress

_MPA = 1e6


@cache
def _table() -> Mapping[str, Any]:
    return tomllib.loads(data_text("gear_strength.toml"))


def gear_steel_names() -> tuple[str, ...]:
    """Return the names of the steels that ISO 6336-5 rates here."""
    return tuple(name for name, row in _table().items() if isinstance(row, dict))


def gear_steel(name: str, grade: str, hardness: float, *, yield_strength: float | None = None) -> GearSteel:
    """Return a gear steel with its strengths.

    Args:
        name: Such as ``"case-hardened"``.
        grade: ML, MQ or ME.
        hardness: Surface hardness [HV, for structural steel HBW].
        yield_strength: R_p0.2 [Pa]; the root of structural and through-hardened steel needs it.

    Source: ISO 6336-5:2016, table 1.

    Raises:
        DesignError: unknown steel or grade, with the nearest; hardness outside the grade's range.

    >>> steel = gear_steel("case-hardened", "MQ", 700.0)
    >>> steel.contact_strength / 1e6, steel.bending_strength / 1e6
    (1500.0, 425.0)
    """
    if name not in gear_steel_names():
        raise DesignError([Problem("material", f"{name!r} is not known; {near(name, gear_steel_names())}")])
    steel = _table()[name]
    if grade not in steel["contact"]:
        raise DesignError([Problem("grade", f"{grade!r} is not given for {name}; {near(grade, steel['contact'])}")])
    rows = (steel["contact"][grade], steel["bending"][grade])
    strengths = [allowable_stress(_line(row), hardness) for row in rows]
    return GearSteel(
        name=name,
        treatment=Treatment(steel["treatment"]),
        grade=grade,
        hardness=hardness,
        contact_strength=strengths[0],
        bending_strength=strengths[1],
        yield_strength=yield_strength,
        source=f"{_table()['source']}, rows {rows[0]['row']} and {rows[1]['row']}",
    )


def _line(row: Mapping[str, Any]) -> StrengthLine:
    """One row in SI."""
    return StrengthLine(row["a"] * _MPA, row["b"] * _MPA, (row["hardness"][0], row["hardness"][1]))
