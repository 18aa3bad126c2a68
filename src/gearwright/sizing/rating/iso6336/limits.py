"""At which limit of the standard a factor stands: there it no longer answers to what it depends on."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from gearwright.parts.iso6336 import LifeCurve, PairRating, Steels, life_curves
from gearwright.sizing.rating.factors import Factor

_WORN, _SOFT = 1200e6, 850e6
"""σ_Hlim between which the film's constants run [Pa] (ISO 6336-2, clause 12.3)."""
_FIXED: Mapping[tuple[str, str], tuple[tuple[float, str], ...]] = {
    ("dynamic factor", "slope"): ((1.0, "least: from 3 m/s"), (2.0, "greatest: up to 0.2 m/s")),
    ("load factors", "transverse contact"): ((1.0, "least"),),
    ("load factors", "transverse bending"): ((1.0, "least"),),
    ("pitting", "single contact"): ((1.0, "least: pitch point"),),
    ("strength of flanks", "work hardening"): ((1.0, "least"), (1.2, "greatest: 130 HB")),
    ("strength of flanks", "size"): ((1.0, "greatest"),),
    ("strength of roots", "size"): ((1.0, "greatest"), (0.7, "least"), (0.8, "least"), (0.85, "least")),
    ("tooth root", "rim"): ((1.0, "least: thick rim"),),
    ("tooth root", "deep tooth"): ((1.0, "greatest"), (0.7, "least")),
}
"""Chapter and quantity -> values at which it is held, and which limit each is."""
_FILM = ("lubricant", "speed", "roughness")


def limited(rows: Iterable[Factor], rated: PairRating, steels: Steels) -> Iterator[Factor]:
    """Yield the rows of a rating, each with the limit at which it stands.

    Args:
        rows: Of the rating.
        rated: That they show.
        steels: Of both gears.
    """
    own = _own_limits(rated, steels)
    for row in rows:
        known = (*_FIXED.get((row.chapter, row.quantity), ()), *own.get((row.chapter, row.quantity), ()))
        words = dict.fromkeys(
            word for value in row.values for bound, word in known if math.isclose(float(value), bound, rel_tol=1e-12)
        )
        yield replace(row, limit=", ".join(words))


def life_limits(curve: LifeCurve, cycles: float, factor: float) -> Iterator[tuple[float, str]]:
    """Yield life factors at which an S-N curve ends, and which end each is.

    Args:
        curve: Of a flank or a root.
        cycles: That it bears [-].
        factor: Its life factor there [-].
    """
    yield curve.factors[0], "greatest: static"
    if curve.fall == 0.0:
        yield curve.factors[-1], "least: borne without end"
    elif cycles > curve.cycles[-1]:
        yield factor, "beyond 1e10 cycles"


def _own_limits(rated: PairRating, steels: Steels) -> dict[tuple[str, str], tuple[tuple[float, str], ...]]:
    """Return the limits that depend on the steel."""
    limits: dict[tuple[str, str], tuple[tuple[float, str], ...]] = {}
    for mode, chapter in enumerate(("strength of flanks", "strength of roots")):
        both = rated.root_strength if mode else rated.contact_strength
        limits[chapter, "life"] = tuple(
            bound
            for steel, life, cycles in zip(steels, [strength.life for strength in both], rated.cycles, strict=True)
            for bound in life_limits(life_curves(steel)[mode], float(cycles), float(life))
        )
    softer = min(steel.contact_strength for steel in steels)
    if not _SOFT < softer < _WORN:
        end = "σ_Hlim counts as 1200" if softer >= _WORN else "σ_Hlim counts as 850"
        film = rated.contact_strength[0]
        for name in _FILM:
            limits["strength of flanks", name] = ((float(getattr(film, name)), end),)
    return limits
