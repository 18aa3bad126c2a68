"""The materials that a design may name: the package's own table, and what makes one of a table that a user writes."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from gearwright.catalogue.tables import data_text
from gearwright.parts import LifeLine, Material
from gearwright.parts.hardness import BRINELL_PER_VICKERS, vickers_of_rockwell
from gearwright.units import SUFFIXES

_UNITS = {**SUFFIXES["stress"], **SUFFIXES["density"]}
"""Suffix of a key -> SI value."""
_LIVES = ("contact_life", "bending_life")
_SCALES = ("hardness_hv", "hardness_hb", "hardness_hrc")


@cache
def materials() -> Mapping[str, Material]:
    """Return every material of the catalogue by name."""
    table = tomllib.loads(data_text("materials.toml"))
    return MappingProxyType({name: material_of(name, _si(row)) for name, row in table.items()})


def material_of(name: str, values: Mapping[str, Any]) -> Material:
    """Return a material of its values, its hardness in the scales of flanks in which it is not given, too.

    Args:
        name: As designs name it.
        values: Field -> value in SI, with ``hardness_hv``, ``hardness_hb`` or ``hardness_hrc``; None is not known.

    Source: ISO 18265:2013, table A.1, for hardness in other scales.

    >>> round(material_of("mine", {"elastic_modulus": 206e9, "poisson_ratio": 0.3, "density": 7830.0,
    ...     "hardness_hrc": 60.1}).surface_hardness)
    665
    """
    known = {key: value for key, value in values.items() if value is not None}
    vickers, brinell = hardnesses_of({scale: known.pop(scale, None) for scale in _SCALES})
    known |= {key: LifeLine(**known[key]) for key in _LIVES if key in known}
    return Material(name=name, hardness=vickers, surface_hardness=brinell, **known)


def hardnesses_of(scales: Mapping[str, float | None]) -> tuple[float | None, float | None]:
    """Return the hardness of flanks in HV and HB [-]; None where no scale has it.

    Args:
        scales: ``hardness_hv``, ``hardness_hb`` and ``hardness_hrc``, those that are known.

    Source: ISO 18265:2013, table A.1.
    """
    vickers, brinell, rockwell = (scales.get(scale) for scale in _SCALES)
    if vickers is None and rockwell is not None:
        vickers = vickers_of_rockwell(rockwell)
    if vickers is None and brinell is not None:
        vickers = brinell / BRINELL_PER_VICKERS
    if brinell is None and vickers is not None:
        brinell = BRINELL_PER_VICKERS * vickers
    return vickers, brinell


def _si(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return a row of the table by fields: numbers in SI without the unit in their key."""
    values: dict[str, Any] = {}
    for key, value in row.items():
        field, suffix = next(
            ((key.removesuffix(f"_{suffix}"), suffix) for suffix in _UNITS if key.endswith(f"_{suffix}")), (key, "")
        )
        values[field] = float(value) * _UNITS.get(suffix, 1.0) if isinstance(value, int | float) else value
    return values
