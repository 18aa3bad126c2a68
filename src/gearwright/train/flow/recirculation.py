"""Power that runs in a circle: out of a stage on one shaft, through other stages, and back into it on another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.ranking import largest_first
from gearwright.train.flow.carried import PowerFlow, shaft_powers
from gearwright.train.graph import Train

SMALLEST_SHARE = 1e-9
"""Circulating power below this part of the power supplied is rounding."""


@dataclass(frozen=True)
class Loop:
    """One circle of power."""

    path: tuple[str, ...]
    """Stages and shafts in the direction of the power; the first one follows the last."""
    power: float
    """What circulates [W]."""


def recirculation(train: Train, flow: PowerFlow) -> tuple[Loop, ...]:
    """Return every circle in which power runs, the largest first; none is the usual case.

    Args:
        train: The graph.
        flow: A load case.
    """
    edges = _edges(train, flow)
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    loops = []
    while (path := _circle(edges)) is not None:
        steps = list(zip(path, (*path[1:], path[0]), strict=True))
        power = min(edges[start][end] for start, end in steps)
        loops.append(Loop(tuple(path), power))
        for start, end in steps:
            edges[start][end] -= power
            if edges[start][end] <= SMALLEST_SHARE * supplied:
                del edges[start][end]
    return tuple(largest_first(loops, lambda loop: loop.power))


def _edges(train: Train, flow: PowerFlow) -> dict[str, dict[str, float]]:
    """Return the power from every stage to the shafts that it drives, and to it from those that drive it [W]."""
    powers = {(f"stage {stage}", shaft): power for (stage, shaft), power in shaft_powers(train, flow).items()}
    for link in train.links:
        torque = flow.given(link.name)
        powers[(f"link {link.name}", link.driven)] = torque * flow.speeds[link.driven]
        powers[(f"link {link.name}", link.driving)] = -torque * flow.speeds[link.driving]
    supplied = sum(power for power in flow.machine_powers.values() if power > 0.0)
    edges: dict[str, dict[str, float]] = {}
    for (stage, shaft), power in powers.items():
        if abs(power) > SMALLEST_SHARE * supplied:
            start, end = (stage, shaft) if power > 0.0 else (shaft, stage)
            edges.setdefault(start, {})[end] = abs(power)
    return edges


def _circle(edges: Mapping[str, Mapping[str, float]]) -> list[str] | None:
    """Return one directed circle, or None."""
    done: set[str] = set()
    for start in edges:
        path: list[str] = []
        circle = _walk(start, edges, path, done)
        if circle is not None:
            return circle
    return None


def _walk(node: str, edges: Mapping[str, Mapping[str, float]], path: list[str], done: set[str]) -> list[str] | None:
    """Follow the power from a node until a node of the path comes again."""
    if node in path:
        return path[path.index(node) :]
    if node in done:
        return None
    path.append(node)
    for following in edges.get(node, {}):
        circle = _walk(following, edges, path, done)
        if circle is not None:
            return circle
    path.pop()
    done.add(node)
    return None
