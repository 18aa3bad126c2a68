"""What moves the margins of a mesh, and how far each thing must be turned until the worst margin is a wished one."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from gearwright.errors import DesignError, SolveError
from gearwright.showing import Shown
from gearwright.sizing.insight.meshes import SizedMesh, sized_meshes
from gearwright.sizing.rating import Rating
from gearwright.sizing.result import Sizing
from gearwright.spec.design import RATINGS
from gearwright.verbs import verb

STEP = 0.005
"""Relative step of the central differences [-]."""
FARTHEST = 3.0
"""Factor beyond which a thing is not turned [-]."""
_HALVINGS = 30
"""Of a step of the scan: 5 % / 2³⁰ is 5e-11 of a value."""
_SCAN = 24


class Handle(NamedTuple):
    """Something that a user can turn."""

    name: str
    """In words, with its symbol."""
    dimension: str
    value: float
    """As it is [SI]."""
    turned: Callable[[float], SizedMesh]
    """Value -> the mesh with it."""


@dataclass(frozen=True)
class Influence:
    """How one thing moves the margins of a mesh."""

    handle: str
    dimension: str
    value: float
    """As it is [SI]."""
    flank: float
    """∂ ln S_H/∂ ln x, of the weaker gear [-]."""
    root: float
    """∂ ln S_F/∂ ln x, of the weaker gear [-]."""
    wanted: float | None
    """Value at which the worst margin is the wished one [SI]; None where a threefold change does not do."""


@dataclass(frozen=True, repr=False)
class MeshInfluences(Shown):
    """A mesh, and everything that moves its margins."""

    mesh: str
    method: str
    margin: float
    """The worst of flanks and roots, as it is [-]."""
    wish: float
    """Margin that is wished [-]."""
    rows: tuple[Influence, ...]


@verb
def influences(sizing: Sizing, wish: float = 1.0) -> tuple[MeshInfluences, ...]:
    """Return of every loaded mesh what moves its margins, and what would raise the worst to a wish.

    Args:
        sizing: As sized; teeth are kept.
        wish: Margin over the asked safeties that is wished [-]; 1 is just enough.
    """
    return tuple(_influences(mesh, wish) for mesh in sized_meshes(sizing))


def _influences(mesh: SizedMesh, wish: float) -> MeshInfluences:
    rows = (_influence(handle, wish) for handle in handles(mesh))
    return MeshInfluences(
        mesh.row.name, mesh.rating.method, min(_margins(mesh)), wish, tuple(row for row in rows if row is not None)
    )


def handles(mesh: SizedMesh) -> Iterator[Handle]:
    """Yield what a user can turn of a mesh: sizes, duty, and the numbers of its method's rules.

    Args:
        mesh: As sized.
    """
    rating = mesh.rating
    service = rating.service
    yield Handle("face width b", "length", mesh.face_width, lambda x: mesh._replace(face_width=x))
    yield Handle("module m_n", "length", mesh.module, lambda x: mesh._replace(module=x))
    if rating.helix_angle:
        yield Handle("helix angle β", "angle", rating.helix_angle, lambda x: _by(mesh, replace(rating, helix_angle=x)))
    if RATINGS[rating.method].fatigue:
        factor = service.application_factor
        yield Handle("application factor K_A", "ratio", factor, _service(mesh, "application_factor"))
        yield Handle("life", "life", service.life, _service(mesh, "life"))
    if RATINGS[rating.method].table == "iso6336":
        for name, dimension, key in (
            ("flank roughness R_z", "length", "flank_roughness"), ("root roughness R_z", "length", "root_roughness"),
            ("oil ν_40 in mm²/s", "number", "oil_viscosity"), ("tip relief C_a", "length", "tip_relief"),
        ):  # fmt: skip
            if value := getattr(rating.rules.iso6336, key):
                yield Handle(name, dimension, value, _making(mesh, key))


def _by(mesh: SizedMesh, rating: Rating) -> SizedMesh:
    ratings = {**mesh.context.ratings, mesh.row.stage: rating}
    return mesh._replace(context=replace(mesh.context, ratings=ratings))


def _service(mesh: SizedMesh, key: str) -> Callable[[float], SizedMesh]:
    def turned(value: float) -> SizedMesh:
        service = mesh.rating.service.model_copy(update={key: value})
        design = mesh.context.design.model_copy(update={"service": service})
        return _by(mesh._replace(context=replace(mesh.context, design=design)), replace(mesh.rating, service=service))

    return turned


def _making(mesh: SizedMesh, key: str) -> Callable[[float], SizedMesh]:
    def turned(value: float) -> SizedMesh:
        rules = mesh.rating.rules
        table = rules.iso6336.model_copy(update={key: value})
        return _by(mesh, replace(mesh.rating, rules=rules.model_copy(update={"iso6336": table})))

    return turned


def _margins(mesh: SizedMesh) -> tuple[float, float]:
    rated = mesh.rated()
    return float(rated.contact_margin), float(rated.bending_margin)


def _influence(handle: Handle, wish: float) -> Influence | None:
    """Return what a handle does; None where it cannot be turned at all."""
    try:
        below, above = (_margins(handle.turned(handle.value * (1.0 + step))) for step in (-STEP, STEP))
    except (DesignError, SolveError):
        return None
    span = math.log((1.0 + STEP) / (1.0 - STEP))
    flank, root = (math.log(high / low) / span for low, high in zip(below, above, strict=True))
    return Influence(handle.name, handle.dimension, handle.value, flank, root, _wanted(handle, wish))


def _wanted(handle: Handle, wish: float) -> float | None:
    """Return the nearest value at which the worst margin is the wished one, looked for on both sides."""
    here = _short(handle, 1.0, wish)
    last = {1: (1.0, here), -1: (1.0, here)}
    for far in range(1, _SCAN + 1):
        for side, (near_by, before) in last.items():
            factor = FARTHEST ** (side * far / _SCAN)
            short = _short(handle, factor, wish)
            if {before, short} == {True, False}:
                return handle.value * _crossing(handle, near_by, factor, wish, short=before)
            last[side] = factor, short
    return None


def _short(handle: Handle, factor: float, wish: float) -> bool | None:
    """Tell whether the worst margin falls short of the wish; None where the gears are none."""
    try:
        return min(_margins(handle.turned(handle.value * factor))) < wish
    except (DesignError, SolveError):
        return None


def _crossing(handle: Handle, one: float, other: float, wish: float, *, short: bool | None) -> float:
    """Return the factor at which the margin is the wished one, between one that is short, or not, and another."""
    for _ in range(_HALVINGS):
        middle = math.sqrt(one * other)
        one, other = (middle, other) if _short(handle, middle, wish) == short else (one, middle)
    return math.sqrt(one * other)
