"""Topology: which numbers a generated right-hand side needs, and where each stands in its parameter array.

Code is generated for the structure alone (who joins whom, which lines have backlash, which tones act where); the
numbers are parameters, so that all systems of one structure share one compiled code.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwright.dynamics.system import Arrays, Drives, Entries, Floats, Series


class LineShape(NamedTuple):
    """Structure of one line."""

    dofs: tuple[int, ...]
    """Coordinates."""
    signs: tuple[int, ...]
    """1 or −1 for weights of exactly that, 0 for any other."""
    variation: tuple[int, ...]
    """Tones of its stiffness."""
    error: tuple[int, ...]
    """Tones of its error."""
    gap: bool
    """Whether it has backlash."""
    damped: bool
    """Whether it has damping."""


class DriveShape(NamedTuple):
    """Structure of the drives."""

    dofs: tuple[int, ...]
    """Coordinates that feel them."""
    states: int
    """States of all."""
    inputs: int
    """What they read against time."""
    records: int
    """Drives."""
    length: int
    """Numbers in their table."""


class Topology(NamedTuple):
    """Structure of a system: hashable, the key of the generated code."""

    size: int
    """Coordinates."""
    tones: int
    """Tones."""
    lines: tuple[LineShape, ...]
    """Structure of each line."""
    loaded: tuple[tuple[int, bool, bool], ...]
    """Coordinates with a load: number, whether it depends on speed, whether on its square."""
    scheduled: tuple[int, ...]
    """Coordinates with a schedule, one for each schedule."""
    turning: tuple[int, ...]
    """Coordinates whose rigid motion may speed up: empty when the speed is constant."""
    gyroscopic: tuple[tuple[int, int], ...]
    """Rows and columns."""
    centripetal: tuple[tuple[int, int], ...]
    """Rows and columns."""
    drives: DriveShape
    """Of the drives."""


def topology(arrays: Arrays) -> Topology:
    """Return the structure of a system.

    Args:
        arrays: The system's numbers.
    """
    loads = arrays.loads
    scheduled = tuple(int(dof) for dof in loads.schedules.dof)
    acting = (loads.constant != 0.0) | (loads.damping != 0.0) | (loads.quadratic != 0.0)
    acting[list(scheduled)] = True
    acting[list(_drives(arrays.drives).dofs)] = True
    steady = bool(np.all(arrays.profile.factor == arrays.profile.factor[0]))
    return Topology(
        size=len(arrays.mass),
        tones=len(arrays.tone_rate),
        lines=tuple(_line(arrays, j) for j in range(len(arrays.stiffness))),
        loaded=tuple((int(i), bool(loads.damping[i]), bool(loads.quadratic[i])) for i in np.flatnonzero(acting)),
        scheduled=scheduled,
        turning=() if steady else tuple(int(i) for i in np.flatnonzero(arrays.speed)),
        gyroscopic=_places(arrays.gyroscopic),
        centripetal=_places(arrays.centripetal),
        drives=_drives(arrays.drives),
    )


def _drives(drives: Drives) -> DriveShape:
    dofs, table, place = set[int](), drives.table, 2
    while place < len(table):
        dofs |= {int(table[place + 2]), int(table[place + 4])} - {-1}
        place += int(table[place])
    records = int(table[0]) if len(table) else 0
    return DriveShape(tuple(sorted(dofs)), len(drives.start), len(drives.inputs.dof), records, len(table))


def fingerprint(arrays: Arrays) -> tuple[bytes, ...]:
    """Return what decides the structure, quick to take and to compare: equal for systems of one structure.

    Args:
        arrays: The system's numbers.
    """
    loads = arrays.loads
    signs = np.where(np.abs(arrays.line_weight) == 1.0, arrays.line_weight, 0.0)
    steady = bool(np.all(arrays.profile.factor == arrays.profile.factor[0]))
    parts = [arrays.line_start, arrays.line_dof, signs, arrays.backlash > 0.0, arrays.damping > 0.0]
    parts += [] if steady else [arrays.speed != 0.0]
    parts += [loads.constant != 0.0, loads.damping != 0.0, loads.quadratic != 0.0, loads.schedules.dof]
    parts += [arrays.variation.start, arrays.variation.tone, arrays.error.start, arrays.error.tone]
    parts += [arrays.gyroscopic.row, arrays.gyroscopic.column, arrays.centripetal.row, arrays.centripetal.column]
    rest = repr((len(arrays.tone_rate), steady, _drives(arrays.drives)))
    return (*(part.tobytes() for part in parts), rest.encode())


def _line(arrays: Arrays, j: int) -> LineShape:
    part = slice(arrays.line_start[j], arrays.line_start[j + 1])
    weights = arrays.line_weight[part]
    return LineShape(
        dofs=tuple(int(dof) for dof in arrays.line_dof[part]),
        signs=tuple(int(weight) if abs(weight) == 1.0 else 0 for weight in weights),
        variation=_tones(arrays.variation, j),
        error=_tones(arrays.error, j),
        gap=bool(arrays.backlash[j] > 0.0),
        damped=bool(arrays.damping[j] > 0.0),
    )


def _tones(series: Series, j: int) -> tuple[int, ...]:
    return tuple(int(tone) for tone in series.tone[series.start[j] : series.start[j + 1]])


def _places(entries: Entries) -> tuple[tuple[int, int], ...]:
    return tuple((int(row), int(column)) for row, column in zip(entries.row, entries.column, strict=True))


class Layout(NamedTuple):
    """First place of each group of numbers in the parameter array."""

    step: int
    """h."""
    weight: int
    """Line weights."""
    stiffness: int
    """Mean stiffness."""
    damping: int
    """c."""
    backlash: int
    """B."""
    variation_cos: int
    """Stiffness coefficients k a."""
    variation_sin: int
    """Stiffness coefficients k b."""
    variation_cos_rate: int
    """Coefficients of ½ dk/dτ on the cosine, ½ k b ω."""
    variation_sin_rate: int
    """On the sine, −½ k a ω."""
    error_cos: int
    """Error coefficients a."""
    error_sin: int
    """b."""
    error_cos_rate: int
    """b ω."""
    error_sin_rate: int
    """−a ω."""
    mobility: int
    """1/M."""
    inertia: int
    """M Ω."""
    speed: int
    """Ω."""
    constant: int
    """Constant load."""
    loss: int
    """Load lost per speed."""
    quadratic: int
    """Load lost per speed squared."""
    gyroscopic: int
    """Ω G."""
    centripetal: int
    """Ω² C."""
    drives: int
    """Table of the drives."""


def parameters(arrays: Arrays, h: float) -> tuple[Layout, Floats]:
    """Return where each number stands, and the numbers.

    Args:
        arrays: The system's numbers.
        h: Step [s].
    """
    variation = _coefficients(arrays, arrays.variation, (arrays.stiffness, 0.5))
    error = _coefficients(arrays, arrays.error, (np.ones_like(arrays.stiffness), 1.0))
    lines = [arrays.line_weight, arrays.stiffness, arrays.damping, arrays.backlash]
    bodies = [1.0 / arrays.mass, arrays.mass * arrays.speed, arrays.speed]
    loads = [arrays.loads.constant, arrays.loads.damping, arrays.loads.quadratic]
    frames = [arrays.gyroscopic.value, arrays.centripetal.value]
    groups = [np.array([h]), *lines, *variation, *error, *bodies, *loads, *frames, arrays.drives.table]
    starts = np.cumsum([0, *(len(group) for group in groups)])[:-1]
    return Layout(*(int(start) for start in starts)), np.concatenate(groups)


def _coefficients(arrays: Arrays, series: Series, scales: tuple[Floats, float]) -> list[Floats]:
    scale, share = scales
    factor = np.repeat(scale, np.diff(series.start))
    cos, sin, rate = series.cosine * factor, series.sine * factor, share * arrays.tone_rate[series.tone]
    return [cos, sin, sin * rate, -cos * rate]
