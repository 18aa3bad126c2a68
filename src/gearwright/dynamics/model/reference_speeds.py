"""Reference speeds: those that are not given follow from lines that may not stretch steadily, one after the other."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, Ints
from gearwright.dynamics.model.line import Line
from gearwright.dynamics.model.system import LARGE
from gearwright.errors import DesignError, Problem

SPEED_TOLERANCE = 1e-6
"""Largest stretch rate of a line at the reference speeds over the sum of its parts [-]: room for rounded radii."""
ROUNDING = 1e-12
"""Rate of a line over the fastest part of any that is rounding [-]."""


class Rows(NamedTuple):
    """Weights of lines, of unit length, one after the other."""

    line: Ints
    """Line of each weight."""
    dof: Ints
    """Coordinate of each weight."""
    weight: Floats
    lines: int
    """How many."""

    def rates(self, speed: Floats) -> Floats:
        """Return the steady stretch of each line, shape (lines,)."""
        return np.asarray(np.bincount(self.line, self.weight * speed[self.dof], self.lines), float)


def reference_speeds(lines: Sequence[Line], index: Mapping[str, int], given: Sequence[float | None]) -> Floats:
    """Return the speed of each coordinate; those that nothing determines are the least that fit.

    Args:
        lines: That may not stretch steadily.
        index: Coordinate -> its number.
        given: Speeds, None where they follow.

    Raises:
        DesignError: With every line that would stretch.
    """
    rows, stated = _rows(lines, index), np.array([value is not None for value in given], dtype=bool)
    speed = np.array([value or 0.0 for value in given])
    known = _spread(rows, speed, stated) if rows.lines > LARGE else stated
    left = np.flatnonzero(~known)
    used = np.unique(rows.line[~known[rows.dof]])
    if len(left) and len(used):
        matrix, rate = np.zeros((len(used), len(left))), rows.rates(np.where(known, speed, 0.0))[used]
        open_ = ~known[rows.dof]
        place = np.searchsorted(used, rows.line[open_]), np.searchsorted(left, rows.dof[open_])
        np.add.at(matrix, place, rows.weight[open_])
        speed[left] = np.linalg.lstsq(matrix, -rate, rcond=1e-10)[0]
    if stretching := _stretching(lines, rows, speed):
        raise DesignError(stretching)
    return speed


def _rows(lines: Sequence[Line], index: Mapping[str, int]) -> Rows:
    entries = [(row, index[name], weight) for row, line in enumerate(lines) for name, weight in line.weights.items()]
    line, dof = (np.array([entry[part] for entry in entries], dtype=np.int64) for part in (0, 1))
    weight = np.array([entry[2] for entry in entries], dtype=float)
    length = np.sqrt(np.bincount(line, weight**2, len(lines)))
    return Rows(line, dof, weight / length[line], len(lines))


def _spread(rows: Rows, speed: Floats, stated: Bools) -> Bools:
    """Fill speeds that a line with a single unknown one determines, and return which are known then.

    Speeds that are given may contradict each other; what follows is then told by the lines that stretch.
    """
    known, starts = stated.copy(), np.searchsorted(rows.line, np.arange(rows.lines + 1)).tolist()
    unknown = np.bincount(rows.line, ~known[rows.dof], rows.lines).astype(int).tolist()
    by_dof: list[list[int]] = [[] for _ in speed]
    for line, dof in zip(rows.line.tolist(), rows.dof.tolist(), strict=True):
        by_dof[dof].append(line)
    queue = deque(line for line, count in enumerate(unknown) if count == 1)
    while queue:
        line = queue.popleft()
        part = slice(starts[line], starts[line + 1])
        (open_,) = np.flatnonzero(~known[rows.dof[part]])[:1] if unknown[line] == 1 else (-1,)
        if open_ < 0 or abs(rows.weight[part][open_]) < SPEED_TOLERANCE:
            continue
        dof, others = int(rows.dof[part][open_]), known[rows.dof[part]]
        rest = float(rows.weight[part][others] @ speed[rows.dof[part][others]])
        speed[dof], known[dof] = -rest / float(rows.weight[part][open_]), True
        for other in by_dof[dof]:
            unknown[other] -= 1
            if unknown[other] == 1:
                queue.append(other)
    return known


def _stretching(lines: Sequence[Line], rows: Rows, speed: Floats) -> list[Problem]:
    rate = rows.rates(speed)
    size = rows._replace(weight=np.abs(rows.weight)).rates(np.abs(speed))
    allowed = SPEED_TOLERANCE * size + ROUNDING * np.max(size, initial=0.0)
    wrong = np.flatnonzero(np.abs(rate) > allowed).tolist()
    return [
        Problem(
            f"lines.{lines[row].name}",
            f"it would stretch steadily at the given speeds (by {abs(rate[row]) / size[row]:.1e} of its parts); "
            "speeds and weights (base radii, signs) must fit together",
        )
        for row in wrong
    ]
