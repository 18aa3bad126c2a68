"""Materials of gears, shafts and housings, and gear steels of ISO 6336-5."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from types import MappingProxyType
from typing import Any

from gearwright.base import SUFFIXES, Density, DesignError, Length, Problem, Ratio, Stress, near
from gearwright.catalogue.tables import data_rows, data_text
from gearwright.parts import LifeLine, Material
from gearwright.parts.housing_fatigue import CastCurve
from gearwright.parts.housings import CAST_SAFETY, CastingRule
from gearwright.parts.iso6336 import (
    GearSteel,
    LifeCurve,
    StrengthLine,
    Treatment,
    allowable_stress,
    bending_life_curve,
    contact_life_curve,
    knee_curve,
)
from gearwright.parts.material import BRINELL_PER_VICKERS, vickers_of_rockwell

# ----------------------------------------------------------------------------------------------------------------------
# The materials that a design may name: the package's own table, and what makes one of a table that a user writes.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Gear steels by heat treatment, quality grade and hardness, read from the package's table of ISO 6336-5.
# ----------------------------------------------------------------------------------------------------------------------


_MPA = 1e6
STATED = "stated in the design"
"""Source of strengths that a design states without one."""
USUAL_HARDNESS = 700.0
"""Hardness of flanks of another class than the material's own, where nothing else is said [HV]: 60 HRC."""


@cache
def _table() -> Mapping[str, Any]:
    return tomllib.loads(data_text("gear_strength.toml"))


def gear_steel_names() -> tuple[str, ...]:
    """Return the names of the steels that ISO 6336-5 rates here."""
    return tuple(name for name, row in _table().items() if isinstance(row, dict))


def is_cast_iron(name: str | None) -> bool:
    """Tell whether a class is one of cast irons.

    Args:
        name: Of a class, or of none.
    """
    return name in gear_steel_names() and Treatment(_class(name or "")["treatment"]).is_cast_iron


def gear_steel(name: str, grade: str, hardness: float, *, yield_strength: float | None = None) -> GearSteel:
    """Return a gear steel with its strengths.

    Args:
        name: Such as ``"case-hardened"``.
        grade: ML, MQ or ME.
        hardness: Surface hardness [HV, HBW for structural steel and cast irons].
        yield_strength: R_p0.2 [Pa]; the root of structural and through-hardened steel needs it.

    Source: ISO 6336-5:2016, table 1.

    Raises:
        DesignError: unknown steel or grade, with the nearest; hardness outside the grade's range.

    >>> steel = gear_steel("case-hardened", "MQ", 700.0)
    >>> steel.contact_strength / 1e6, steel.bending_strength / 1e6
    (1500.0, 425.0)
    """
    steel = _class(name)
    if grade not in steel["contact"]:
        raise DesignError([Problem("grade", f"{grade!r} is not given for {name}; {near(grade, steel['contact'])}")])
    rows = (steel["contact"][grade], steel["bending"][grade])
    treatment = Treatment(steel["treatment"])
    strengths = [allowable_stress(_line(row, treatment), hardness) for row in rows]
    return GearSteel(
        name=name,
        treatment=treatment,
        grade=grade,
        hardness=hardness,
        contact_strength=strengths[0],
        bending_strength=strengths[1],
        yield_strength=yield_strength,
        source=f"{_table()['source']}, rows {rows[0]['row']} and {rows[1]['row']}",
    )


@lru_cache(maxsize=256)
def rated_steel(
    material: Material,
    name: str | None = None,
    grade: str | None = None,
    *,
    hardness: float | None = None,
    base: str | None = None,
) -> GearSteel:
    """Return a material as ISO 6336 rates it: what it states itself, and the rest by its class in the table.

    Args:
        material: Of the gear.
        name: Class in the table in place of the material's own, then of grade MQ where nothing is said, and of 700 HV
            where it is so hard.
        grade: ML, MQ or ME in place of its own, or MQ.
        hardness: Surface hardness in place of its own [HV, HBW for structural steel and cast irons].
        base: Class of a material that states none.

    Source: ISO 6336-5:2016, table 1, for strengths that the material does not state; ISO 6336-2, table of Z_E, for
        E and ν of a class of cast iron that is not the material's.

    Raises:
        DesignError: no class; no such class, grade or hardness; a strength neither stated nor in the table.

    >>> from gearwright.catalogue import materials
    >>> steel = rated_steel(materials()["16MnCr5"])
    >>> steel.treatment.value, steel.grade, steel.contact_strength / 1e6
    ('Eh', 'MQ', 1500.0)
    """
    chosen = name or material.steel
    if chosen is None:
        message = f"{material.name!r} has no class of ISO 6336-5 and so no S-N data; give steel, one of "
        raise DesignError([Problem("material", message + ", ".join(gear_steel_names()))])
    its = chosen == material.steel
    quality = grade or (its and material.grade) or "MQ"
    hard = hardness or (_flank(material) if its else _usual_hardness(chosen, quality))
    if hard is None:
        raise DesignError([Problem("hardness", f"{material.name!r} states none; give the hardness of its flanks")])
    own = its and grade in (None, material.grade) and hardness is None
    lives = (material.contact_life, material.bending_life) if own else (None, None)
    curves = contact_life_curve, bending_life_curve
    treatment = Treatment(_class(chosen)["treatment"])
    contact, bending = (
        None if life is None else _knee(life, curve(treatment)) for life, curve in zip(lives, curves, strict=True)
    )
    modulus, ratio = _elasticity(material, chosen, material.steel or base)
    return replace(
        _strengths(material, chosen, quality, hardness=hard, own=own),
        elastic_modulus=modulus,
        poisson_ratio=ratio,
        density=material.density,
        yield_strength=material.yield_strength,
        contact_life=contact,
        bending_life=bending,
    )


def _strengths(material: Material, name: str, grade: str, *, hardness: float, own: bool) -> GearSteel:
    """Return what the material states of its strengths, or what its class says."""
    contact, bending = material.contact_strength, material.bending_strength
    if not own or contact is None or bending is None:
        return gear_steel(name, grade, hardness)
    sources = dict.fromkeys(material.source_of(key) for key in ("contact_strength", "bending_strength"))
    source = "; ".join(filter(None, sources)) or STATED
    return GearSteel(name, Treatment(_class(name)["treatment"]), grade, hardness, contact, bending, source=source)


def _elasticity(material: Material, name: str, base: str | None) -> tuple[float, float]:
    """Return E [Pa] and ν [-] of a class; those of the material are none of an iron that it is not."""
    row = _class(name)
    if base in (None, name) or "elastic_modulus_gpa" not in row:
        return material.elastic_modulus, material.poisson_ratio
    return row["elastic_modulus_gpa"] * 1e9, row["poisson_ratio"]


def _flank(material: Material) -> float | None:
    """Return the hardness of flanks in the scale of the material's class."""
    scale = Treatment(_class(material.steel or "")["treatment"]).hardness_scale
    return material.surface_hardness if scale == "HBW" else material.hardness


def _usual_hardness(name: str, grade: str) -> float:
    """Return the hardness of a class where nothing says it; soft classes have none that is usual."""
    row = _class(name)["contact"].get(grade)
    if row is not None and not row["hardness"][0] <= USUAL_HARDNESS <= row["hardness"][1]:
        low, high = row["hardness"]
        scale = Treatment(_class(name)["treatment"]).hardness_scale
        message = f"is required: {name} {grade} has {low:g} to {high:g} {scale} (ISO 6336-5)"
        raise DesignError([Problem("hardness", message)])
    return USUAL_HARDNESS


def _knee(line: LifeLine, usual: LifeCurve) -> LifeCurve:
    """Return a stated S-N line as a curve, with the ends of the treatment where it states none."""
    greatest = usual.factors[0] if line.static_factor is None else line.static_factor
    end = usual.factors[-1] if line.factor_at_1e10 is None else line.factor_at_1e10
    return knee_curve(line.knee_cycles, line.exponent, greatest=greatest, at_1e10=end)


def _class(name: str) -> Mapping[str, Any]:
    """Return the rows of a class."""
    if name not in gear_steel_names():
        raise DesignError([Problem("material", f"{name!r} is not known; {near(name, gear_steel_names())}")])
    rows: Mapping[str, Any] = _table()[name]
    return rows


def _line(row: Mapping[str, Any], treatment: Treatment) -> StrengthLine:
    """One row in SI."""
    first, last = row["hardness"]
    return StrengthLine(row["a"] * _MPA, row["b"] * _MPA, (first, last), treatment.hardness_scale)


# ----------------------------------------------------------------------------------------------------------------------
# What housings are made of: density, fatigue strength of the casting, and which walls foundries pour.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class HousingMaterial:
    """One material of housings."""

    name: str
    density: Density
    """[kg/m³]"""
    shear_fatigue: Stress
    """Largest shear stress that it bears for ever when it is loaded from zero [Pa]."""
    bending_fatigue: Stress
    """Largest normal stress that it bears so [Pa]."""
    casting: CastingRule
    """How thick its walls are poured."""
    curve: CastCurve
    """What castings of it bear of ranges of normal stress, again and again."""
    source: str
    """Of the numbers, and which are estimates."""

    @property
    def shear_strength(self) -> Stress:
        """Working shear stress: what it bears for ever over 3.5 [Pa]."""
        return self.shear_fatigue / CAST_SAFETY

    @property
    def bending_strength(self) -> Stress:
        """Working normal stress: what it bears for ever over 3.5 [Pa]."""
        return self.bending_fatigue / CAST_SAFETY

    @property
    def shear_share(self) -> Ratio:
        """Shear stress over the normal stress that tires it as much [-]."""
        return self.shear_fatigue / self.bending_fatigue

    @property
    def least_wall(self) -> Length:
        """Thinnest wall that is usual [m]."""
        return self.casting.least


@cache
def housing_materials() -> Mapping[str, HousingMaterial]:
    """Return the materials of housings by name."""
    return MappingProxyType({row["name"]: _material(row) for row in data_rows("housing_materials.csv")})


def _material(row: Mapping[str, str]) -> HousingMaterial:
    wall = [float(row[f"{name}_wall_mm"]) * 1e-3 for name in ("least", "most")]
    return HousingMaterial(
        row["name"],
        float(row["density_kg_m3"]),
        float(row["shear_fatigue_mpa"]) * _MPA,
        float(row["bending_fatigue_mpa"]) * _MPA,
        CastingRule(float(row["wall_base_mm"]) * 1e-3, float(row["wall_slope"]), *wall),
        CastCurve(
            float(row["fatigue_class_mpa"]) * _MPA,
            float(row["class_cycles"]),
            (float(row["slope"]), float(row["second_slope"])),
            float(row["knee_cycles"]),
        ),
        row["source"],
    )
