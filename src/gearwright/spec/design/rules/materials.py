"""Materials that a design states itself, to be named wherever one of the catalogue can be."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Density, Ratio, Stress


class LifeLineRules(Record):
    """An S-N line: straight in double logarithmic scale up to its knee, then to the factor at 1e10 cycles and on."""

    knee_cycles: float = Field(ge=1e4, le=5e9, description="Cycles at which the strength is what the material states")
    exponent: Ratio = Field(ge=2, le=100, description="p of N ~ σ^(−p) below the knee")
    static_factor: Ratio | None = Field(
        None, gt=1, le=5, description="Largest stress over the strength, for few cycles; left out: of the class"
    )
    factor_at_1e10: Ratio | None = Field(
        None,
        ge=0.5,
        le=1,
        description="Stress over the strength at 1e10 cycles; beyond, the line goes on; left out: 0.85",
    )


class MaterialRules(Record):
    """A material: what is not known is left out, and refused where a method needs it."""

    elastic_modulus: Stress = Field(ge=5e10, le=5e11, description="Young's modulus E")
    poisson_ratio: Ratio = Field(ge=0.1, le=0.49, description="Poisson's ratio ν")
    density: Density = Field(ge=1e3, le=2e4, description="Density ρ")
    yield_strength: Stress | None = Field(None, ge=5e7, le=4e9, description="0.2 % proof stress R_p0.2 of the core")
    ultimate_strength: Stress | None = Field(None, ge=5e7, le=5e9, description="Tensile strength R_m of the core")
    group: Literal["structural", "nitriding", "tempered", "nickel-case-hardened", "case-hardened"] | None = Field(
        None, description="How its strength falls with the size of a shaft (DIN 743-2)"
    )
    hardness_hv: float | None = Field(None, ge=80, le=1200, description="Hardness of the flanks, Vickers")
    hardness_hb: float | None = Field(None, ge=80, le=750, description="Hardness of the flanks, Brinell")
    hardness_hrc: float | None = Field(None, ge=20.3, le=68, description="Hardness of the flanks, Rockwell C")
    steel: str | None = Field(
        None, description="Class of ISO 6336-5, for strengths that are left out, life curves and factors of size"
    )
    grade: Literal["ML", "MQ", "ME"] | None = Field(None, description="Material quality of ISO 6336-5; left out: MQ")
    contact_strength: Stress | None = Field(
        None, ge=1e8, le=4e9, description="σ_Hlim; left out: of its class, grade and hardness"
    )
    bending_strength: Stress | None = Field(
        None, ge=5e7, le=2e9, description="σ_Flim; left out: of its class, grade and hardness"
    )
    contact_life: LifeLineRules | None = Field(None, description="S-N line of flanks; left out: of the class")
    bending_life: LifeLineRules | None = Field(None, description="S-N line of roots; left out: of the class")
    melting: Literal["air", "vacuum-degassed", "ESR", "VAR", "VIM-VAR"] | None = Field(
        None, description="How clean it is molten"
    )
    source: str = Field("", description="Where the values come from")
    sources: dict[str, str] = Field(default_factory=dict, description="Property -> its own source")
    estimated: dict[str, str] = Field(
        default_factory=dict, description="Property that no source gives -> rule by which it is estimated"
    )
