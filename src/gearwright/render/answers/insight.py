"""Answers about what a rating rests on: every factor, every method side by side, what moves the margins."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.render.tables.sizing.factors import rated_factors
from gearwright.sizing import Beside, Influence, MeshBeside, MeshInfluences, Sizing, influences, methods_beside
from gearwright.sizing.rating import METHODS, Factor
from gearwright.units import Number, Ratio, shown, unit


@dataclass(frozen=True)
class FactorEntry:
    """One quantity of a rating."""

    chapter: str
    quantity: str
    equation: str
    """Symbol, or the equation that makes it."""
    values: tuple[Number, ...]
    """Of first and second gear, or one of the mesh; more are one list; in the unit beside."""
    unit: str
    limit: str
    """Limit of the standard at which it stands; empty where it stands at none."""
    clause: str


@dataclass(frozen=True)
class FactorsOfMesh:
    """Every factor of a mesh by the method that rates it, in the heaviest case over the whole life."""

    mesh: str
    gears: tuple[str, ...]
    method: str
    edition: str
    case: str
    factors: tuple[FactorEntry, ...]


@dataclass(frozen=True)
class AspectEntry:
    """One thing that every method has to say of a mesh."""

    aspect: str
    """In words, with the symbols of ISO and AGMA."""
    values: Mapping[str, tuple[Number, ...]]
    """Method -> of both gears, or one of the mesh, in the unit beside; methods without such a factor are left out."""
    unit: str
    why: str
    """Why the values differ; empty where they do not."""


@dataclass(frozen=True)
class MarginsByMethod:
    """Margins over the safeties that the method's rules ask."""

    flanks: Ratio
    roots: Ratio


@dataclass(frozen=True)
class MethodsOfMesh:
    """A mesh by every method, with teeth, module, width and loads of the design."""

    mesh: str
    aspects: tuple[AspectEntry, ...]
    margins: Mapping[str, MarginsByMethod]
    """Method -> its margins."""
    refused: Mapping[str, str]
    """Method -> why it does not rate this mesh."""


@dataclass(frozen=True)
class InfluenceEntry:
    """What turning one value does to the margins of a mesh."""

    handle: str
    """In words, with its symbol."""
    value: Number
    """As it is, in the unit beside."""
    unit: str
    flank: Ratio
    """∂ ln S_H/∂ ln x of the weaker gear: per cent for a per cent."""
    root: Ratio
    """∂ ln S_F/∂ ln x of the weaker gear: per cent for a per cent."""
    wanted: Number | None
    """Where the worst margin is the wished one, in the unit beside; null where a threefold change does not do."""


@dataclass(frozen=True)
class InfluencesOnMesh:
    """What moves the margins of a mesh."""

    mesh: str
    method: str
    margin: Ratio
    """The worst of flanks and roots, as it is."""
    wish: Ratio
    """Margin that is wished."""
    handles: tuple[InfluenceEntry, ...]


def factors_answer(sizing: Sizing) -> tuple[FactorsOfMesh, ...]:
    """Return every factor of every rated mesh, as `gearwright size --factors --json` answers.

    Args:
        sizing: As sized.
    """
    return tuple(
        FactorsOfMesh(
            mesh.name, mesh.gears, mesh.rating.method, METHODS[mesh.rating.method].edition, mesh.rating.case,
            tuple(map(_factor, rows)),
        )
        for mesh, rows in rated_factors(sizing)
    )  # fmt: skip


def methods_answer(sizing: Sizing) -> tuple[MethodsOfMesh, ...]:
    """Return every mesh by every method, as `gearwright size --methods --json` answers.

    Args:
        sizing: As sized.
    """
    return tuple(map(_methods, methods_beside(sizing)))


def influences_answer(sizing: Sizing, wish: float) -> tuple[InfluencesOnMesh, ...]:
    """Return what moves the margins of every mesh, as `gearwright size --wish --json` answers.

    Args:
        sizing: As sized.
        wish: Margin that is wished [-].
    """
    return tuple(map(_influences, influences(sizing, wish)))


def _factor(row: Factor) -> FactorEntry:
    return FactorEntry(
        row.chapter, row.quantity, row.equation, tuple(_numbers(row)), unit(row.dimension), row.limit, row.clause
    )


def _numbers(row: Factor) -> Iterator[float]:
    for value in row.values:
        yield value if isinstance(value, int) else shown(float(np.asarray(value)), row.dimension)


def _methods(mesh: MeshBeside) -> MethodsOfMesh:
    margins = {method: MarginsByMethod(*pair) for method, pair in mesh.margins.items()}
    return MethodsOfMesh(mesh.mesh, tuple(map(_aspect, mesh.rows)), margins, mesh.refused)


def _aspect(line: Beside) -> AspectEntry:
    values = {name: tuple(shown(value, line.dimension) for value in both) for name, both in line.values.items()}
    return AspectEntry(line.aspect, values, unit(line.dimension), line.why)


def _influences(mesh: MeshInfluences) -> InfluencesOnMesh:
    return InfluencesOnMesh(mesh.mesh, mesh.method, mesh.margin, mesh.wish, tuple(map(_influence, mesh.rows)))


def _influence(row: Influence) -> InfluenceEntry:
    value, wanted = shown(row.value, row.dimension), row.wanted
    aim = None if wanted is None else shown(wanted, row.dimension)
    return InfluenceEntry(row.handle, value, unit(row.dimension), row.flank, row.root, aim)
