"""One sized mesh by every method that rates its kind of gears: teeth, module, width and loads are the same."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.errors import DesignError, SolveError
from gearwright.showing import Shown
from gearwright.sizing.insight.aspects import ASPECTS, FAMILIES, Aspect
from gearwright.sizing.insight.bevel_aspects import BEVEL_ASPECTS, BEVEL_FAMILIES
from gearwright.sizing.insight.meshes import SizedMesh, sized_meshes
from gearwright.sizing.rating import METHODS, Factor, MeshRating, factor_rows
from gearwright.sizing.result import Sizing
from gearwright.spec.design import RATINGS
from gearwright.train import INTERNAL
from gearwright.verbs import verb

_KINDS = ((FAMILIES, ASPECTS), (BEVEL_FAMILIES, BEVEL_ASPECTS))
"""Of cylindrical and of bevel gears: method -> whose names its rows have, and what is compared."""
CLOSE = 0.005
"""Part by which values may differ and still count as equal [-]."""


class Beside(NamedTuple):
    """One aspect of a mesh by every method."""

    aspect: str
    """In words, with symbols."""
    values: Mapping[str, tuple[float, ...]]
    """Method -> of both gears, or one of the mesh [SI]; methods that know no such factor are left out."""
    dimension: str
    why: str
    """Why the values differ; empty where they do not."""


@dataclass(frozen=True, repr=False)
class MeshBeside(Shown):
    """A mesh by every method."""

    mesh: str
    """Name of the mesh."""
    rows: tuple[Beside, ...]
    margins: Mapping[str, tuple[float, float]]
    """Method -> margins of flanks and of roots over the asked safeties [-]."""
    refused: Mapping[str, str]
    """Method -> why it does not rate this mesh."""


@verb
def methods_beside(sizing: Sizing) -> tuple[MeshBeside, ...]:
    """Return every mesh of a design by every method of its kind, factor by factor, with the reasons of differences.

    Args:
        sizing: As sized; its teeth, modules, widths and loads are kept.
    """
    return tuple(
        _beside(mesh, families, aspects)
        for mesh in sized_meshes(sizing)
        for families, aspects in _KINDS
        if mesh.rating.method in families
    )


def _beside(mesh: SizedMesh, families: Mapping[str, str], aspects: tuple[Aspect, ...]) -> MeshBeside:
    rated: dict[str, MeshRating] = {}
    refused: dict[str, str] = {}
    for name in families:
        why = _uncovered(mesh, name)
        try:
            if not why:
                rated[name] = mesh.rated(replace(mesh.rating, method=name))
        except (DesignError, SolveError) as error:
            why = error.problems[0].message if isinstance(error, DesignError) else str(error)
        if why:
            refused[name] = why
    margins = {name: (record.contact_margin, record.bending_margin) for name, record in rated.items()}
    return MeshBeside(mesh.row.name, tuple(_lines(rated, families, aspects)), margins, refused)


def _uncovered(mesh: SizedMesh, method: str) -> str:
    """Return why a method does not rate a mesh; empty where it does."""
    internal = mesh.row.sign == INTERNAL
    kind = "internal" if internal else mesh.rating.kind
    if kind not in RATINGS[method].covers:
        return f"{RATINGS[method].title} rates no {kind} meshes here"
    material = mesh.rating.material
    lacking = [need for need in RATINGS[method].needs if getattr(material, need, None) is None]
    if lacking:
        return f"{material.name} has no {' and no '.join(lacking)}"
    first, second = (mesh.context.teeth[gear] for gear in mesh.row.gears)
    teeth = (first, -second if internal else second)
    problem = next(METHODS[method].refuse(replace(mesh.rating, method=method), teeth), None)
    return "" if problem is None else problem.message


def _lines(
    rated: Mapping[str, MeshRating], families: Mapping[str, str], aspects: tuple[Aspect, ...]
) -> Iterator[Beside]:
    rows = {name: {(row.chapter, row.quantity): row for row in _rows(name, record)} for name, record in rated.items()}
    for aspect in aspects:
        shown = {name: rows[name].get(_key(aspect, families[name])) for name in rated}  # type: ignore[arg-type]
        known = {name: row for name, row in shown.items() if row is not None}
        if known:
            values = {name: tuple(float(value) for value in row.values) for name, row in known.items()}
            differ = len(known) < len(rated) or _differ(list(values.values()))
            yield Beside(aspect.name, values, next(iter(known.values())).dimension, aspect.why if differ else "")


def _rows(method: str, record: MeshRating) -> list[Factor]:
    """Return the factors of a rating; of a method without such a list the numbers of its record."""
    return [*METHODS[method].factors(record)] or [*factor_rows(record, "mesh")]


def _key(aspect: Aspect, family: str) -> tuple[str, str] | None:
    return {"iso": aspect.iso, "agma": aspect.agma, "lewis": aspect.lewis}[family]


def _differ(values: list[tuple[float, ...]]) -> bool:
    first = values[0]
    return any(
        len(other) != len(first)
        or any(abs(a - b) > CLOSE * max(abs(a), abs(b)) for a, b in zip(first, other, strict=True))
        for other in values[1:]
    )
