"""Large systems: rigid motions by the graph of their lines, and statics with sparse matrices.

Beyond `LARGE` coordinates dense decompositions take seconds. Lines join few bodies each, so that spanning trees and
sparse factors take milliseconds.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.equations.modes import split_rigid
from gearwright.dynamics.equations.potential import HELD_BACK, ROUNDS, SETTLED, Slope, reach, touching
from gearwright.dynamics.equations.reference import dead_zone
from gearwright.dynamics.model import LARGE, Arrays, holding, planned
from gearwright.errors import SolveError
from gearwright.train.algebra import RANK_TOLERANCE, null_space

ROUNDING = 1e-14
"""Share of all forces at a body that rounding may leave over [-]."""


def is_sparse(arrays: Arrays) -> bool:
    """Tell whether statics are solved with sparse matrices: no line only pulls, and no body flies outwards.

    Args:
        arrays: The system's numbers.
    """
    presses = np.isinf(arrays.backlash).any()
    return len(arrays.mass) > LARGE and not presses and not len(arrays.centripetal.value)


@planned
def rigid_motions(arrays: Arrays) -> Floats:
    """Return mass-normalised motions that stretch no line that holds, shape (coordinates, rigid).

    Args:
        arrays: The system's numbers.
    """
    return motions_of_graph(arrays) if len(arrays.mass) > LARGE else split_rigid(arrays)[0]


def motions_of_graph(arrays: Arrays) -> Floats:
    """Return the same by the graph of the lines.

    Lines of two coordinates are the edges of a graph: along a spanning tree each coordinate follows from the first of
    its part. What the other lines ask of the parts is a small matrix, whose null space tells the parts' motions.

    Args:
        arrays: The system's numbers.
    """
    rows = _rows(arrays)
    part, ratio = _spanned(rows, len(arrays.mass))
    parts = int(np.max(part, initial=-1)) + 1
    conditions = np.array([row for line in rows if (row := _condition(line, part, ratio, parts)) is not None])
    free = null_space(conditions.reshape(-1, parts)) if len(conditions) else np.eye(parts)
    root = np.sqrt(arrays.mass)
    motions = np.linalg.qr((root * ratio)[:, None] * free[part])[0] if free.size else np.zeros((len(root), 0))
    return np.asarray(motions / root[:, None])


def _rows(arrays: Arrays) -> list[dict[int, float]]:
    """Return the weights of each line that holds, by coordinate."""
    rows = []
    for line in np.flatnonzero(holding(arrays)).tolist():
        row = dict[int, float]()
        for place in range(arrays.line_start[line], arrays.line_start[line + 1]):
            dof = int(arrays.line_dof[place])
            row[dof] = row.get(dof, 0.0) + float(arrays.line_weight[place])
        rows.append({dof: weight for dof, weight in row.items() if weight})
    return rows


def _spanned(rows: list[dict[int, float]], size: int) -> tuple[Any, Floats]:
    """Return the part of each coordinate, and how far it moves with the first coordinate of its part."""
    edges: list[list[tuple[int, float]]] = [[] for _ in range(size)]
    for row in rows:
        if len(row) == 2:
            (first, a), (second, b) = row.items()
            edges[first].append((second, -a / b))
            edges[second].append((first, -b / a))
    part, ratio, parts = np.full(size, -1), np.ones(size), 0
    for start in range(size):
        if part[start] >= 0:
            continue
        part[start], queue = parts, deque([start])
        while queue:
            here = queue.popleft()
            for there, factor in edges[here]:
                if part[there] < 0:
                    part[there], ratio[there] = parts, ratio[here] * factor
                    queue.append(there)
        parts += 1
    return part, ratio


def _condition(line: dict[int, float], part: Any, ratio: Floats, parts: int) -> Floats | None:
    """Return what a line asks of the parts' motions; none of a line that the tree, or its closing, satisfies."""
    row, size = np.zeros(parts), np.zeros(parts)
    for dof, weight in line.items():
        row[part[dof]] += weight * ratio[dof]
        size[part[dof]] += abs(weight * ratio[dof])
    row[np.abs(row) <= RANK_TOLERANCE * size] = 0.0
    length = float(np.linalg.norm(row))
    return row / length if length > 0.0 else None


def settled(arrays: Arrays, load: Floats, stiffness: Floats, error: Floats) -> Floats:
    """Return q at the least of the potential of lines and loads, of least kinetic norm, by Newton's method.

    Args:
        arrays: The system's numbers, without centripetal terms, and with no line that never touches on its back.
        load: On each coordinate [N or N m].
        stiffness: Of each line at the instant [N/m or N m/rad].
        error: Of each line [m or rad].

    Raises:
        SolveError: If contact does not settle.
    """
    from scipy import sparse  # small systems do without it

    root, stiff = np.sqrt(arrays.mass), np.sqrt(stiffness)
    lines = scaled_lines(arrays, stiffness)
    rigid = rigid_motions(arrays) * root[:, None]
    pull = load / root - rigid @ (rigid.T @ (load / root))
    gap, opened = stiff * arrays.backlash, stiff * error
    place = _solve(lines, rigid, pull + lines.T @ opened)
    for _ in range(ROUNDS):
        deflection = lines @ place - opened
        contact = dead_zone(deflection, gap)
        left = pull - lines.T @ contact
        left -= rigid @ (rigid.T @ left)
        acting = np.linalg.norm(pull) + np.linalg.norm(contact) * ROUNDING / SETTLED
        acting += np.linalg.norm(abs(lines).T @ np.abs(contact))
        if np.linalg.norm(left) <= SETTLED * acting:
            return np.asarray(place / root)
        weight = np.where(touching(deflection, gap), 1.0, HELD_BACK)
        way = _solve(sparse.diags(np.sqrt(weight)) @ lines, rigid, left)
        place = place + reach(Slope(deflection, lines @ way, gap), float(way @ pull), 0.0) * way
    raise SolveError(
        f"contact did not settle in {ROUNDS} rounds; forces of {np.linalg.norm(left) / acting:.1e} are left over"
    )


def scaled_lines(arrays: Arrays, stiffness: Floats) -> Any:
    """Return √k D M^(−1/2) as a sparse matrix, whose square is the stiffness in coordinates of unit mass.

    Args:
        arrays: The system's numbers.
        stiffness: Of each line [N/m or N m/rad].
    """
    from scipy import sparse

    entries, shape = arrays.line_weight / np.sqrt(arrays.mass)[arrays.line_dof], (len(stiffness), len(arrays.mass))
    return sparse.diags(np.sqrt(stiffness)) @ sparse.csr_matrix((entries, arrays.line_dof, arrays.line_start), shape)


def _solve(lines: Any, rigid: Floats, force: Floats) -> Floats:
    """Return the motion under a force, without any rigid one."""
    return factored(lines, rigid)(force)


def factored(lines: Any, rigid: Floats) -> Callable[[Floats], Floats]:
    """Return what finds the motion under a force, both without any rigid one.

    One coordinate for each rigid motion is held while the rest is solved for, which leaves the matrix as sparse as it
    is; what the answer then has of the rigid motions is taken out.

    Args:
        lines: As `scaled_lines` has them.
        rigid: Motions of unit length, shape (coordinates, rigid).
    """
    from scipy.linalg import qr
    from scipy.sparse.linalg import splu

    held = qr(rigid.T, mode="r", pivoting=True)[-1][: rigid.shape[1]] if rigid.size else []
    free = np.delete(np.arange(len(rigid)), held)
    part = lines[:, free]
    factors = splu((part.T @ part).tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})

    def solved(force: Floats) -> Floats:
        motion = np.zeros(len(force))
        motion[free] = factors.solve(force[free])
        return np.asarray(motion - rigid @ (rigid.T @ motion))

    return solved
