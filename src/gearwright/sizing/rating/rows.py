"""A row of meshes rated by the method of its stage under the load cases of the design."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gearwright.sizing.rating.context import Context, ask_of, once, worst_case
from gearwright.sizing.rating.iso6336 import Iso6336Rating, scuffing_safeties
from gearwright.sizing.rating.methods import method_for
from gearwright.sizing.rating.protocol import LEAST_TORQUE, Load, LoadedMesh, MeshRating, Unloaded
from gearwright.spec import case_named, levels_of, shares_of
from gearwright.train import Mesh

_CREEP = 1e-3
"""Speed of gears that a limit load finds at rest [rad/s]."""
_NONE_ASKED = (0.0, 0.0)


def rate_row(
    context: Context, mesh: Mesh, module: float, face_width: float, *, asked: tuple[float, float] = _NONE_ASKED
) -> MeshRating:
    """Return the rating of one mesh of a row.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].
        asked: Modules that bending and contact ask for, for its record [m].
    """
    loaded = _loaded(context, mesh, module, face_width, asked)
    if isinstance(loaded, Unloaded):
        return loaded
    rated: MeshRating = once(
        context, loaded.rating, ("rating", *loaded[1:]), lambda: method_for(loaded.rating).rate(loaded)
    )
    return rated


def row_reserve(context: Context, mesh: Mesh, module: float, face_width: float) -> float | None:
    """Return by what factor the loads of a row could grow [-]; None where nothing loads it.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n, of bevel gears m_mn [m].
        face_width: b [m].
    """
    loaded = _loaded(context, mesh, module, face_width)
    if isinstance(loaded, Unloaded):
        return None
    reserve: float = once(
        context, loaded.rating, ("reserve", *loaded[1:]), lambda: method_for(loaded.rating).reserve_of(loaded)
    )
    return reserve


def scuffing_ratio(
    context: Context, mesh: Mesh, module: float, face_width: float, asked: tuple[float, float] = _NONE_ASKED
) -> float:
    """Return the least safety of a row against scuffing over the asked one [-]; ∞ where its method has none.

    Args:
        context: What sizing reads.
        mesh: A row of the train.
        module: m_n [m].
        face_width: b [m].
        asked: As for `rate_row`, so that a size that is kept is not rated again [m].
    """
    rated = rate_row(context, mesh, module, face_width, asked=asked)
    if not isinstance(rated, Iso6336Rating):
        return math.inf
    safeties = (safety for safety in scuffing_safeties(rated) if safety is not None)
    return min(safeties, default=math.inf) / rated.scuffing_asked


def _loaded(
    context: Context, mesh: Mesh, module: float, face_width: float, asked: tuple[float, float] = _NONE_ASKED
) -> LoadedMesh | Unloaded:
    """Return one mesh of a row with all that its life consists of."""
    rating, (case, per_tooth) = context.rating(mesh), worst_case(context, mesh)
    if per_tooth * context.teeth[mesh.gears[0]] <= LEAST_TORQUE:
        return Unloaded(case)
    heaviest = _load(context, mesh, case, rating.service.life)
    loads = tuple(load for load in _loads(context, mesh) if load.torque > LEAST_TORQUE)
    others = tuple(load for load in _others(context, mesh) if load.torque > LEAST_TORQUE)
    return LoadedMesh(rating, module, face_width, heaviest, loads, asked, others)


def _others(context: Context, mesh: Mesh) -> Iterator[Load]:
    """Yield the cases that last where no shares of the life are said."""
    if not shares_of(context.design):
        for case in context.flows:
            if not case_named(context.design, case).static:
                yield _load(context, mesh, case, 0.0)


def _loads(context: Context, mesh: Mesh) -> Iterator[Load]:
    """Yield the cases that make up the life; where none is said, the heaviest lasts all of it."""
    life, shares = context.design.service.life, shares_of(context.design)
    for case, share in (shares or {worst_case(context, mesh)[0]: 1.0}).items():
        for level, part in levels_of(context.design, case):
            if share * part > 0.0:
                yield _load(context, mesh, case, share * part * life, level)
    for case in context.flows:
        if case_named(context.design, case).static:
            yield _once(_load(context, mesh, case, 0.0))


def _once(load: Load) -> Load:
    """Return a limit load as one turn of the first gear: static strength bears it, and no cycles are spent."""
    speed = max(float(np.asarray(load.ask.speed)), _CREEP)
    return load._replace(ask=load.ask._replace(speed=speed), life=2.0 * math.pi / speed, static=True)


def _load(context: Context, mesh: Mesh, case: str, life: float, level: float = 1.0) -> Load:
    multiplier = level * abs(context.flows[case].meshes[mesh.name].multiplier)
    per_tooth = multiplier / mesh.count * context.ratings[mesh.stage].load_factor
    return Load(case, per_tooth * context.teeth[mesh.gears[0]], ask_of(context, mesh, case, per_tooth), life)
