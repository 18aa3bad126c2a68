"""The materials that a design may name, read from the package's own table."""

from __future__ import annotations

import tomllib
from functools import cache
from types import MappingProxyType
from typing import TYPE_CHECKING

from gearwright.catalogue.tables import data_text
from gearwright.parts import Material

if TYPE_CHECKING:
    from collections.abc import Mapping

_MPA = 1e6


@cache
def materials() -> Mapping[str, Material]:
    """Return every material of the catalogue by name."""
    table = tomllib.loads(data_text("materials.toml"))
    return MappingProxyType({name: _material(name, row) for name, row in table.items()})


def _material(name: str, row: Mapping[str, float | str]) -> Material:
    strength, ultimate = row.get("yield_strength_mpa"), row.get("ultimate_strength_mpa")
    hardness = row.get("surface_hardness")
    return Material(
        name=name,
        elastic_modulus=float(row["elastic_modulus_mpa"]) * _MPA,
        poisson_ratio=float(row["poisson_ratio"]),
        density=float(row["density_kg_m3"]),
        yield_strength=None if strength is None else float(strength) * _MPA,
        surface_hardness=None if hardness is None else float(hardness),
        ultimate_strength=None if ultimate is None else float(ultimate) * _MPA,
        group=None if "group" not in row else str(row["group"]),
        source=str(row["source"]),
    )
