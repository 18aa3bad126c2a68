"""Gears of first sizings moved along their shafts to where they mesh.

Where meshes close a loop, the gears of the last one may stand beside each other along their axes, as shafts without
bearings or places of their own have equal gaps. A gear that has no other mesh, on such a shaft, then moves to its mate.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import DesignError
from gearwright.sizing.arranged import Arrangement, Frame
from gearwright.sizing.arrangement import NO_ANGLES, Moves, arrange
from gearwright.sizing.places.frames import apart_of, frames_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN
from gearwright.train import Mesh


def arrange_meshing(
    context: Context, gears: tuple[GearSizing, ...], angles: Mapping[str, float] = NO_ANGLES
) -> Arrangement:
    """Return axes and plans in which gears in mesh stand beside each other, as far as open places give it.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].

    Raises:
        DesignError: As `arrange`.
    """
    arrangement = arrange(context, gears, angles)
    rows = [mesh for mesh in context.train.meshes if mesh.stage in context.design.pairs]
    if not _closes(context, rows):
        return arrangement
    moves: Moves = {}
    for _ in rows:
        closer = _closer(context, gears, angles, rows, arrangement, moves)
        if closer is None:
            break
        arrangement, moves = closer
    return arrangement


def _closes(context: Context, rows: list[Mesh]) -> bool:
    """Tell whether meshes close a loop of shafts, which sets and clutches join, too."""
    design, known = context.design, dict[str, str]()

    def root(shaft: str) -> str:
        while known.get(shaft, shaft) != shaft:
            shaft = known[shaft]
        return shaft

    joined = [stage.members for stage in design.sets.values()]
    joined += [(link.driving, link.driven) for link in design.links.values()]
    for first, *others in ([shaft for shaft in members if shaft != GROUND] for members in joined):
        known |= {root(other): root(first) for other in others if root(other) != root(first)}
    for mesh in rows:
        first, second = root(mesh.nodes[0]), root(mesh.nodes[1])
        if first == second:
            return True
        known[second] = first
    return False


def _closer(
    context: Context,
    gears: tuple[GearSizing, ...],
    angles: Mapping[str, float],
    rows: list[Mesh],
    arrangement: Arrangement,
    moves: Moves,
) -> tuple[Arrangement, Moves] | None:
    """Return the arrangement with one more gear moved to its mate, and all moves; None where none can be."""
    by_name = {gear.name: gear for gear in gears}
    frames = frames_of(context, by_name, arrangement)
    apart = apart_of(context, by_name, arrangement, frames)
    for mesh in rows:
        for shaft, gear in _open_ends(context, rows, mesh, arrangement) if mesh.name in apart else ():
            moved = _moved(moves, shaft, gear, frames, off=apart[mesh.name], mesh=mesh)
            try:
                return arrange(context, gears, angles, moved), moved
            except DesignError:  # it has no room on its shaft
                continue
    return None


def _open_ends(context: Context, rows: list[Mesh], mesh: Mesh, arrangement: Arrangement) -> Iterator[tuple[str, str]]:
    """Yield shaft and gear of the ends of a mesh that may move along their shafts."""
    for shaft, gear in zip(mesh.nodes[:2], mesh.gears, strict=True):
        layout = context.design.layout.get(shaft, NOTHING_GIVEN)
        meshes = sum((shaft, gear) in zip(row.nodes[:2], row.gears, strict=True) for row in rows)
        given = gear in layout.places or f"{shaft}.length" in context.given or layout.first_bearing is not None
        if meshes == 1 and not given and layout.second_bearing is None and not arrangement.plans[shaft].seats:
            yield shaft, gear


def _moved(moves: Moves, shaft: str, gear: str, frames: Mapping[str, Frame], *, off: float, mesh: Mesh) -> Moves:
    """Return moves with one more: the second shaft of the mesh stands too far on by so much, along itself."""
    first, second = (frames[node].along for node in mesh.nodes[:2])
    alike = 1.0 if sum(one * other for one, other in zip(first, second, strict=True)) > 0.0 else -1.0
    by = off * alike if shaft == mesh.nodes[0] else -off
    return {**moves, (shaft, gear): moves.get((shaft, gear), 0.0) + by}
