"""Every number of a material with its unit, its source, and whether it is estimated."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from gearwright.catalogue import rated_steel
from gearwright.parts import Material
from gearwright.parts.iso6336 import GearSteel, LifeCurve, life_curves
from gearwright.render.grid.table import Mark, Table, table
from gearwright.sizing import Sizing
from gearwright.sizing.rating import method_for, rating_of
from gearwright.units import shown, unit

NUMBERS = {
    "elastic_modulus": ("Young's modulus E", "stress"),
    "poisson_ratio": ("Poisson's ratio ν", "ratio"),
    "density": ("density ρ", "density"),
    "yield_strength": ("proof stress R_p0.2", "stress"),
    "ultimate_strength": ("tensile strength R_m", "stress"),
    "surface_hardness": ("hardness of flanks HB", "number"),
    "hardness": ("hardness of flanks HV", "number"),
}
"""Number of a material -> words with its symbol, and its kind."""
STRENGTHS = {"contact_strength": "strength of flanks σ_Hlim", "bending_strength": "strength of roots σ_Flim"}
"""Number of a gear steel -> words with its symbol [stress]."""
ESTIMATED = "estimated: "
"""How the source of a number begins that no source gives."""
_HARDNESS = "hardness"
_STANDARDS = ("ISO 6336-2:2019, table 2", "ISO 6336-3:2019, table 1")
"""Of the S-N lines of flanks and roots."""


@dataclass(frozen=True)
class Property:
    """One property of one material."""

    material: str
    quantity: str
    """In words, with its symbol."""
    value: float | str
    """In its unit."""
    unit: str
    source: str
    """Where it comes from, or that it is estimated and by which rule."""

    @property
    def estimated(self) -> bool:
        """Whether no source gives it."""
        return self.source.startswith(ESTIMATED)


def properties(material: Material, steel: GearSteel | None) -> Iterator[Property]:
    """Yield every property of a material that is known.

    Args:
        material: The material.
        steel: As its gears are rated; None where they are not.
    """
    for key, (words, kind) in NUMBERS.items():
        value: float | None = getattr(material, key)
        if value is not None and (steel is not None or key != _HARDNESS):
            own = _HARDNESS if key == "surface_hardness" and key not in material.sources else key
            yield Property(material.name, words, shown(value, kind), unit(kind), _source(material, own))
    for key, words in (("group", "group of DIN 743"), ("melting", "melting")):
        if getattr(material, key) is not None:
            yield Property(material.name, words, getattr(material, key), "", _source(material, key))
    if steel is not None:
        yield from _rated(material, steel)


def _rated(material: Material, steel: GearSteel) -> Iterator[Property]:
    """Yield strengths and S-N lines."""
    yield Property(material.name, "class and grade", f"{steel.name} {steel.grade}", "", steel.source)
    own = material.steel is not None and steel == rated_steel(material)
    for key, words in STRENGTHS.items():
        stated = own and (key in material.estimated or getattr(material, key) is not None)
        source = _source(material, key) if stated else steel.source
        yield Property(material.name, words, shown(getattr(steel, key), "stress"), unit("stress"), source)
    lines = (("contact_life", "flanks", steel.contact_life), ("bending_life", "roots", steel.bending_life))
    for (key, part, line), curve, standard in zip(lines, life_curves(steel), _STANDARDS, strict=True):
        source = standard if line is None else _source(material, key)
        yield Property(material.name, f"S-N line of {part}, N and factor", _line(curve), "", source)


def _source(material: Material, key: str) -> str:
    """Return the source of a property, or that it is estimated and how."""
    return f"{ESTIMATED if key in material.estimated else ''}{material.source_of(key)}"


def _line(curve: LifeCurve) -> str:
    """Return the corners of an S-N curve."""
    return ", ".join(f"{n:.3g} × {factor:.3g}" for n, factor in zip(curve.cycles, curve.factors, strict=True))


def materials_table(sizing: Sizing) -> Table:
    """Return every property of the materials that a design uses.

    Args:
        sizing: As sized.
    """
    fields = ("material", "quantity", "value", "unit", "source")
    return table("Materials", material_properties(sizing), fields, mark=_mark)


def material_properties(sizing: Sizing) -> tuple[Property, ...]:
    """Return every property of the materials that a design uses.

    Args:
        sizing: As sized.
    """
    used: dict[tuple[str, GearSteel | None], Material] = {}
    for stage in sizing.design.stages:
        rating = rating_of(sizing.design, stage)
        used[rating.material.name, method_for(rating).making(rating).iso_steel] = rating.material
    shaft = sizing.design.shaft_material
    if shaft.name not in {name for name, _ in used}:
        used[shaft.name, None] = shaft
    return tuple(line for (_, steel), material in used.items() for line in properties(material, steel))


def estimated_only(materials: Table) -> Table:
    """Return the rows of a table of materials that no source gives.

    Args:
        materials: As `materials_table` makes it.
    """
    rows = tuple(row for row in materials.rows if any(cell.mark == "estimated" for cell in row))
    return replace(materials, title="Materials: what is estimated", rows=rows)


def _mark(record: object, field: str) -> Mark:
    return "estimated" if field == "value" and getattr(record, "estimated", False) else ""
