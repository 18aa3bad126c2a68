"""What housings are made of: density, working stress and the thinnest wall that is usual."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from gearwright.catalogue.tables import data_rows
from gearwright.units import Density, Length, Stress


@dataclass(frozen=True)
class HousingMaterial:
    """One material of housings."""

    name: str
    density: Density
    """[kg/m³]"""
    shear_strength: Stress
    """Working shear stress [Pa]."""
    least_wall: Length
    """Thinnest wall that is usual [m]."""
    source: str
    """Of the numbers, and which are estimates."""


@cache
def housing_materials() -> Mapping[str, HousingMaterial]:
    """Return the materials of housings by name."""
    return MappingProxyType({row["name"]: _material(row) for row in data_rows("housing_materials.csv")})


def _material(row: Mapping[str, str]) -> HousingMaterial:
    return HousingMaterial(
        row["name"],
        float(row["density_kg_m3"]),
        float(row["shear_strength_mpa"]) * 1e6,
        float(row["least_wall_mm"]) * 1e-3,
        row["source"],
    )
