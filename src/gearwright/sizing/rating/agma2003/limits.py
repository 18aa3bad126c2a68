"""At which limit of AGMA 2003 a factor stands: there it no longer answers to what it depends on."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from gearwright.parts.agma2003 import BevelEdition, size_factor_contact
from gearwright.parts.agma2003.factors import GREATEST_BENDING, GREATEST_CONTACT
from gearwright.sizing.rating.factors import Factor

_FIXED: dict[tuple[str, str], tuple[tuple[float, str], ...]] = {
    ("mesh", "size contact"): ((0.5, "least: b up to 12.7 mm"),),
    ("mesh", "size bending"): ((0.5, "least: m_et below 1.6 mm"),),
    ("mesh", "curvature"): ((1.0, "least, or straight teeth"), (1.15, "greatest")),
    ("mesh", "contact cycles"): ((GREATEST_CONTACT, "greatest: 1e4 cycles"),),
    ("mesh", "bending cycles"): ((GREATEST_BENDING, "greatest: 1e3 cycles"),),
    ("mesh", "temperature"): ((1.0, "least: up to 250 °F"),),
    ("pitting", "inertia"): ((1.0, "least: ε_o from 2"),),
    ("tooth root", "inertia"): ((1.0, "least: ε_o from 2"),),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""


def limited(rows: Iterable[Factor], edition: BevelEdition) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        edition: By which it is.
    """
    widest = (size_factor_contact(edition.value, edition), f"greatest: b from {1e3 * edition.value:g} mm")
    known = _FIXED | {("mesh", "size contact"): (*_FIXED["mesh", "size contact"], widest)}
    for row in rows:
        bounds = known.get((row.chapter, row.quantity), ())
        words = dict.fromkeys(
            word for value in row.values for bound, word in bounds if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))
