"""Static cases of a mesh: limit loads that come once, held against the static strength of flanks and roots."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.parts.iso6336 import PairRating, StaticStrength, static_strength
from gearwright.ranking import smallest
from gearwright.sizing.rating.iso6336.inputs import steels_of
from gearwright.sizing.rating.protocol import LoadedMesh


@dataclass(frozen=True)
class StaticCase:
    """What both gears of a mesh bear in a static case."""

    case: str
    """Its name."""
    strengths: tuple[StaticStrength, StaticStrength]
    """Of both gears."""


class _Asked(NamedTuple):
    """A judgement on static strength."""

    mode: str
    clause: str
    symbol: str
    safety: float | None
    least: float


class Rated(Protocol):
    """A mesh with its worst static case."""

    @property
    def static(self) -> StaticCase | None:
        """That case."""

    @property
    def static_asked(self) -> tuple[float, float, float]:
        """Least safeties [-]."""


def worst_static(mesh: LoadedMesh, rated: Sequence[tuple[str, PairRating]]) -> StaticCase | None:
    """Return the static case that comes nearest to what is asked; None where there is none.

    Args:
        mesh: As loaded.
        rated: Every static case and the mesh under it, K_A = 1.
    """
    rules, steels = mesh.rating.rules.iso6336, steels_of(mesh.rating, mesh.heaviest.ask.roles)
    asked = rules.static_pitting_safety, rules.static_bending_safety, rules.yielding_safety
    cases = []
    for case, pair in rated:
        first, second = (static_strength(pair.pitting, pair.bending, steels, gear) for gear in (0, 1))
        cases.append(StaticCase(case, (first, second)))
    return smallest(cases, lambda case: _margin(case, asked)) if cases else None


def static_checks(rated: Rated, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield every judgement on static strength.

    Args:
        rated: The mesh.
        gears: Both gears.
    """
    if rated.static is None:
        return
    for gear, strength in zip(gears, rated.static.strengths, strict=True):
        for row in _judged(strength, rated.static_asked):
            yield Check(
                gear, row.mode, row.clause, row.safety, row.least, symbol=row.symbol, case=rated.static.case,
                exponent=0.5 if row.symbol == "S_H" else 1.0,
            )  # fmt: skip


def _judged(strength: StaticStrength, asked: tuple[float, float, float]) -> Iterator[_Asked]:
    flank, root = float(strength.contact_safety), float(strength.bending_safety)
    yield _Asked("static pitting", "ISO 6336-2, clauses 5 and 11", "S_H", flank, asked[0])
    yield _Asked("static tooth root", "ISO 6336-3, clauses 5 and 11", "S_F", root, asked[1])
    if strength.yielding_safety is not None:
        yielding = float(strength.yielding_safety)
        yield _Asked("yielding root", "nominal stress of the critical section, R_p0.2", "S_y", yielding, asked[2])


def _margin(case: StaticCase, asked: tuple[float, float, float]) -> float:
    judged = (row for strength in case.strengths for row in _judged(strength, asked))
    return min(row.safety / row.least for row in judged if row.safety is not None)
