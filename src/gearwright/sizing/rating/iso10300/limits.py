"""At which limit of ISO 10300 a factor stands: there it no longer answers to what it depends on."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from gearwright.parts.bevel import BevelRating
from gearwright.parts.iso6336 import GearSteel, life_curves
from gearwright.sizing.rating.factors import Factor
from gearwright.sizing.rating.iso6336.limits import life_limits

_WORN, _SOFT = 1200e6, 850e6
"""σ_Hlim between which the film's constants run [Pa] (ISO 10300-2:2023, 8.2.3)."""
_Bounds = tuple[tuple[float, str], ...]
_FIXED: Mapping[tuple[str, str], _Bounds] = {
    ("load factors", "transverse contact"): ((1.0, "least"),),
    ("load factors", "transverse bending"): ((1.0, "least"),),
    ("tooth root", "contact ratio"): ((0.625, "least: ε_vβ from 1"),),
    ("tooth root", "spiral"): ((1.0, "straight teeth"),),
    ("tooth root", "size"): ((1.0, "greatest"), (0.8, "least"), (0.85, "least")),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""


def limited(rows: Iterable[Factor], rated: BevelRating, steel: GearSteel) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        rated: That they show.
        steel: Of both gears.
    """
    known = {**_FIXED, **_own_limits(rated, steel)}
    for row in rows:
        bounds = known.get((row.chapter, row.quantity), ())
        words = dict.fromkeys(
            word for value in row.values for bound, word in bounds if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))


def _own_limits(rated: BevelRating, steel: GearSteel) -> dict[tuple[str, str], _Bounds]:
    """Return the limits that depend on the steel and the load."""
    limits: dict[tuple[str, str], _Bounds] = {}
    lives = (rated.contact_life, rated.root_life)
    for name, curve, factors in zip(("contact life", "root life"), life_curves(steel), lives, strict=True):
        limits["mesh", name] = tuple(
            bound
            for cycles, factor in zip(rated.cycles, factors, strict=True)
            for bound in life_limits(curve, cycles, factor)
        )
    if not _SOFT < steel.contact_strength < _WORN:
        end = "σ_Hlim counts as 1200" if steel.contact_strength >= _WORN else "σ_Hlim counts as 850"
        limits["pitting", "film"] = ((rated.pitting.film[0], end),)
    loads = rated.loads
    eased = float(loads.face_contact / loads.face_bending)
    for bound, words in ((1.0, "K_F0 least, or straight teeth"), (1.15, "K_F0 greatest")):
        if math.isclose(eased, bound, rel_tol=1e-12):
            limits["load factors", "face bending"] = ((float(loads.face_bending), words),)
    return limits
