"""Safeties of gears that a document states, to be held beside those of a sizing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal

from gearwright.exchange.rexs.files import Document
from gearwright.exchange.rexs.reading.asking import Asking
from gearwright.ranking import ALIKE
from gearwright.sizing import MeshSizing, Sizing
from gearwright.sizing.rating.iso6336 import Iso6336Rating
from gearwright.sizing.rating.iso10300 import Iso10300Rating
from gearwright.units import Ratio

Symbol = Literal["S_H", "S_F"]
SAFETIES: Mapping[str, tuple[Symbol, str]] = {
    "safety_factor_pitting_iso_6336_2019": ("S_H", "ISO 6336:2019"),
    "safety_factor_tooth_root_iso_6336_2019": ("S_F", "ISO 6336:2019"),
    "safety_factor_pitting_iso_6336_2006": ("S_H", "ISO 6336:2006"),
    "safety_factor_tooth_root_iso_6336_2006": ("S_F", "ISO 6336:2006"),
    "safety_factor_root_din_3990_1987": ("S_F", "DIN 3990:1987"),
    "safety_factor_pitting_iso_10300_2023": ("S_H", "ISO 10300:2023"),
    "safety_factor_tooth_root_iso_10300_2023": ("S_F", "ISO 10300:2023"),
    "safety_factor_pitting_iso_10300_2014": ("S_H", "ISO 10300:2014"),
    "safety_factor_tooth_root_iso_10300_2014": ("S_F", "ISO 10300:2014"),
}
"""Attribute -> what it is, and by which standard."""


@dataclass(frozen=True)
class Stated:
    """A safety of a gear in a mesh, as a file states it."""

    gear: str
    """As the design calls it, such as ``first.pinion``."""
    mate: str
    """The gear that it meshes with."""
    symbol: Symbol
    """Against pitting or against fracture of the root."""
    standard: str
    """By which it is."""
    value: Ratio
    """[-]"""
    line: int
    """Of the file [-]."""

    def ours(self, sizing: Sizing) -> float | None:
        """Return what a sizing of the design makes of it [-]; None where it rates by no ISO standard.

        Args:
            sizing: Of the design that was read.
        """
        for mesh in sizing.meshes:
            if {self.gear, self.mate} == set(mesh.gears):
                return _safety(mesh, mesh.gears.index(self.gear), self.symbol)
        return None


def _safety(mesh: MeshSizing, side: int, symbol: Symbol) -> float | None:
    rating = mesh.rating
    if not isinstance(rating, Iso6336Rating | Iso10300Rating):
        return None
    return float((rating.pitting if symbol == "S_H" else rating.bending)[side])


def read_stated(asking: Asking, labels: Mapping[int, str]) -> tuple[Stated, ...]:
    """Return every safety that a document states, once for equal planets and paths.

    Args:
        asking: The document.
        labels: Gear -> what the design calls it.
    """
    found: list[Stated] = []
    for stated in _all(asking, labels):
        if not any(_alike(stated, other) for other in found):
            found.append(stated)
    return tuple(found)


def _alike(first: Stated, second: Stated) -> bool:
    """Return whether two safeties are one and the same but for rounding."""
    same = replace(first, value=second.value, line=second.line) == second
    return same and math.isclose(first.value, second.value, rel_tol=ALIKE)


def _all(asking: Asking, labels: Mapping[int, str]) -> Iterator[Stated]:
    document = asking.document
    for relation in document.relations:
        roles = relation.roles
        data = document.components.get(roles.get("stage_gear_data", -1))
        if relation.kind != "stage_gear_data" or data is None or roles.get("gear") not in labels:
            continue
        asking.used.add(data.number)
        mate = _mate(document, roles.get("stage", -1), roles["gear"])
        for name, (symbol, standard) in SAFETIES.items():
            attribute = asking.attribute(data, name)
            value = None if attribute is None else asking.number(data, name)
            if attribute is not None and value is not None and mate in labels:
                yield Stated(labels[roles["gear"]], labels[mate], symbol, standard, value, attribute.line)


def _mate(document: Document, stage: int, gear: int) -> int:
    ends = (document.related("stage", "stage", stage, role) for role in ("gear_1", "gear_2"))
    return next((end for both in ends for end in both if end != gear), -1)
