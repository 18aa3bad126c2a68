"""Methods by which gears are rated, as design files name them: what each covers, and which rules it alone reads.

Who computes by them is `sizing.rating.methods`, which has a method for each of these names.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated

from gearwright.spec.bounds import OneOf

CYLINDRICAL, INTERNAL, FACE, BEVEL = "cylindrical", "internal", "face", "bevel"
"""Kinds of meshes: external cylindrical gears, a pinion in a ring, a pinion on a face gear, bevel gears."""


@dataclass(frozen=True)
class RatingMethod:
    """What a file may expect of a method."""

    title: str
    """As people call it."""
    covers: frozenset[str]
    """Kinds of meshes that it rates."""
    reads: tuple[str, ...]
    """Rules of [gears] that not every method reads."""
    needs: tuple[str, ...] = ()
    """Properties that the material of its gears must have."""
    table: str = ""
    """Table of rules under [gears] in which its safeties stand; empty where they stand in [gears] itself."""
    instead: Mapping[str, str] = field(default_factory=dict)
    """Kind of mesh -> sister standard that rates it."""
    fatigue: bool = True
    """Whether its safeties are against fatigue, over the load cycles of the life."""


_ISO6336 = RatingMethod(
    "ISO 6336",
    frozenset({CYLINDRICAL, INTERNAL, FACE}),
    ("iso6336", "rim_ratio"),
    table="iso6336",
    instead={BEVEL: "iso10300"},
)
RATINGS: dict[str, RatingMethod] = {
    "lewis-hertz": RatingMethod(
        "Lewis and Hertz",
        frozenset({CYLINDRICAL, INTERNAL, FACE}),
        ("bending_safety", "contact_safety", "idler_factor", "contact_angles"),
        needs=("yield_strength", "surface_hardness"),
        fatigue=False,
    ),
    "iso6336": _ISO6336,
    "iso6336-2006": replace(_ISO6336, title="ISO 6336:2006"),
    "din3990": replace(_ISO6336, title="DIN 3990", covers=frozenset({CYLINDRICAL})),
    "iso10300": RatingMethod("ISO 10300", frozenset({BEVEL}), ("iso6336",), table="iso6336"),
    "agma2001": RatingMethod(
        "AGMA 2001",
        frozenset({CYLINDRICAL}),
        ("agma2001", "agma2003", "rim_ratio"),
        table="agma2001",
        instead={BEVEL: "agma2003"},
    ),
    "agma2003": RatingMethod("AGMA 2003", frozenset({BEVEL}), ("agma2003",), table="agma2003"),
}
"""Name in files -> method. The one place where the names stand."""


RatingName = Annotated[str, OneOf(RATINGS)]
"""Type of a field that names a method."""


def method_of(name: str, kinds: Iterable[str]) -> str:
    """Return the name of the method that rates a stage: the asked one, or its sister for these meshes.

    Args:
        name: As the rules of the stage ask.
        kinds: Of its meshes.
    """
    return next((RATINGS[name].instead[kind] for kind in kinds if kind in RATINGS[name].instead), name)


def uncovered(name: str, kinds: Iterable[str]) -> tuple[str, ...]:
    """Return the kinds of meshes of a stage that neither a method nor its sister rates.

    Args:
        name: As the rules of the stage ask.
        kinds: Of its meshes.
    """
    asked = tuple(kinds)
    return tuple(kind for kind in asked if kind not in RATINGS[method_of(name, asked)].covers)
