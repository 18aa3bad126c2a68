"""Family: systems side by side as one record of arrays with a leading axis; what they share stands there once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import cast

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.model.system import Arrays
from gearwright.errors import DesignError, Problem

DIFFERS = "its structure differs from the first one's: lines, backlash or none, tones, kinds of loads"


def stacked(members: Sequence[Arrays]) -> Arrays:
    """Return arrays whose leading axis counts the systems; it has length one where all share one array.

    Args:
        members: Numbers of each system.

    Raises:
        DesignError: With the first system whose arrays have other shapes.
    """
    return cast("Arrays", _stack(members))


def _stack(parts: Sequence[object]) -> object:
    first = parts[0]
    if all(part is first for part in parts):
        parts = parts[:1]
    if isinstance(first, np.ndarray):
        for number, part in enumerate(parts):
            if cast("Floats", part).shape != first.shape:
                raise DesignError([Problem(f"systems.{number}", DIFFERS)])
        return np.array(parts)
    fields = cast("Sequence[Sequence[object]]", parts)
    return type(first)(*(_stack([part[place] for part in fields]) for place in range(len(fields[0]))))


def check_structure(family: Arrays) -> None:
    """Refuse systems that one code cannot run.

    Args:
        family: Systems, `stacked`.

    Raises:
        DesignError: With the first system whose structure differs from the first one's.
    """
    for rows in _structure(family):
        different = np.flatnonzero(np.any(rows != rows[0], axis=1))
        if len(different):
            raise DesignError([Problem(f"systems.{different[0]}", DIFFERS)])


def _structure(family: Arrays) -> Iterator[np.ndarray]:
    """Return what decides the structure, a row for each system."""
    loads, weights = family.loads, family.line_weight
    yield from (family.line_start, family.line_dof, np.where(np.abs(weights) == 1.0, weights, 0.0))
    yield np.array([weight_numbers(row)[0] for row in weights])
    yield from (family.backlash > 0.0, family.damping > 0.0, family.slip != 0.0)
    ramps = np.any(family.profile.factor != family.profile.factor[:, :1], axis=1, keepdims=True)
    yield from (ramps, ramps & (family.speed != 0.0))
    yield from (loads.constant != 0.0, loads.damping != 0.0, loads.quadratic != 0.0, loads.schedules.dof)
    yield from (family.variation.start, family.variation.tone, family.error.start, family.error.tone)
    yield from (family.gyroscopic.row, family.gyroscopic.column, family.centripetal.row, family.centripetal.column)


def weight_numbers(weights: Floats) -> tuple[Ints, Floats]:
    """Return the number of each weight, equal ones alike, in the order in which they first occur, and their values.

    Args:
        weights: Of all lines.
    """
    values, first, inverse = np.unique(weights, return_index=True, return_inverse=True)
    order = np.argsort(first)
    return np.argsort(order)[inverse], values[order]


def own_groups(family: Arrays, layout: tuple[int, ...], names: Sequence[str], rows: Floats) -> frozenset[str]:
    """Return which groups of numbers differ from system to system, and ``"clock"`` if their tones do.

    Args:
        family: Systems, `stacked`.
        layout: First place of each group of numbers.
        names: Of the groups.
        rows: Numbers of each system.
    """
    differs = np.any(rows != rows[0], axis=0)
    ends = [*layout[1:], len(differs)]
    varying = {name for name, start, end in zip(names, layout, ends, strict=True) if np.any(differs[start:end])}
    clocks = (family.profile.factor[:, :1], family.tone_rate)
    return frozenset(varying | {"clock"} if any(np.any(clock != clock[0]) for clock in clocks) else varying)


def envelope(first: Arrays, family: Arrays) -> Arrays:
    """Return the first system with the largest stiffness, swing and damping of each line.

    Args:
        first: System.
        family: Systems, `stacked`.
    """
    swing = np.max(np.hypot(family.variation.cosine, family.variation.sine), axis=0)
    return first._replace(
        stiffness=np.max(family.stiffness, axis=0),
        damping=np.max(family.damping, axis=0),
        variation=first.variation._replace(cosine=swing, sine=np.zeros_like(swing)),
    )
