"""Rainflow counting: a history of load as cycles of a range and a mean, by ASTM E1049."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

Residue = Literal["half-cycles", "repeated"]
"""What becomes of what closes no loop: every range of it is half a cycle, or the history is one period that repeats."""
HALF, WHOLE = 0.5, 1.0


@dataclass(frozen=True)
class LoadCycle:
    """Cycles of one size."""

    range: float
    """From valley to peak, in the unit of the history."""
    mean: float
    """Half of valley and peak, in the same unit."""
    count: float
    """Cycles, a half one counted as 0.5 [-]."""


def reversals(history: Sequence[float]) -> list[float]:
    """Return the peaks and valleys of a history, with its first and its last value.

    Args:
        history: Loads one after the other [N m], or any other unit of load.

    Source: ASTM E1049-85 (2017), clause 3.

    >>> reversals([0.0, 1.0, 1.0, 2.0, -1.0, 0.0])
    [0.0, 2.0, -1.0, 0.0]
    """
    turned: list[float] = []
    for value in history:
        if turned and value == turned[-1]:
            continue
        if len(turned) > 1 and (turned[-1] - turned[-2]) * (value - turned[-1]) > 0.0:
            turned[-1] = value
        else:
            turned.append(value)
    return turned


def rainflow(history: Sequence[float], *, residue: Residue = "half-cycles") -> tuple[LoadCycle, ...]:
    """Return the cycles of a history of load, the largest range first.

    Args:
        history: Loads one after the other [N m], or any other unit of load.
        residue: By ``half-cycles`` each range that closes no loop counts as half a cycle (clause 5.4.4); by
            ``repeated`` the history is one period of many, begins at its highest peak and leaves nothing open (5.4.5).

    Source: ASTM E1049-85 (2017), clauses 5.4.4 and 5.4.5.

    >>> [(cycle.range, cycle.count) for cycle in rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2], residue="repeated")]
    [(9, 1.0), (7, 1.0), (4, 1.0), (3, 1.0)]
    """
    turned = reversals(history)
    if residue == "repeated" and turned:
        top = turned.index(max(turned))
        turned = reversals([*turned[top:], *turned[: top + 1]])
    counted: dict[tuple[float, float], float] = {}
    for first, second, count in _counted(turned):
        key = (abs(first - second), (first + second) / 2.0)
        counted[key] = counted.get(key, 0.0) + count
    merged = [LoadCycle(*key, count) for key, count in counted.items()]
    return tuple(sorted(merged, key=lambda cycle: (-cycle.range, -cycle.mean)))


def _counted(turned: Sequence[float]) -> Iterator[tuple[float, float, float]]:
    """Yield both ends and the count of every range, in the order in which loops close."""
    held: list[float] = []
    for value in turned:
        held.append(value)
        while len(held) > 2 and abs(held[-1] - held[-2]) >= abs(held[-2] - held[-3]):
            if len(held) == 3:
                yield held[0], held[1], HALF
                del held[0]
            else:
                yield held[-3], held[-2], WHOLE
                del held[-3:-1]
    for place in range(len(held) - 1):
        yield held[place], held[place + 1], HALF
