"""Power on its way through a train: what each stretch of each shaft carries, and which machines it comes from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.render.schematic.layout import Layout
from gearwright.spec import GROUND
from gearwright.train import Branch, PowerFlow, Train, branches

NOTHING = 1e-9
"""Power that is not drawn, over the largest [-]."""


@dataclass(frozen=True)
class Stretch:
    """A piece of a shaft between two neighbouring columns, or the step from a part to its shaft."""

    shaft: str
    start: float
    """Left end [mm]."""
    end: float
    """Right end [mm]."""
    speed: float
    """[rad/s]"""
    torque: float
    """Inside the shaft [N m]."""
    power: float
    """To the right [W]."""
    sources: Mapping[str, float]
    """Machine -> share of the power [-]."""


@dataclass(frozen=True)
class Feed:
    """Power between a part and the shaft that it sits on."""

    branch: Branch
    x: float
    """Column [mm]."""
    sources: Mapping[str, float]
    """Machine -> share of the power [-]."""


class Traced(NamedTuple):
    """The power of a load case on its way."""

    stretches: list[Stretch]
    """Of all shafts."""
    feeds: list[Feed]
    """Of all parts."""


Node = tuple[str, float]
"""Shaft and column, or the name of a part with no column."""


class Edge(NamedTuple):
    """Power from one place to another."""

    origin: Node
    """Whence it comes."""
    to: Node
    """Where it goes."""
    power: float
    """Not negative [W]."""


def trace_power(train: Train, flow: PowerFlow, layout: Layout) -> Traced:
    """Return what every stretch of every shaft carries, and what every part gives to its shaft, with the sources.

    Power that meets at a place mixes: what goes on has the shares of what came in.

    Args:
        train: The graph.
        flow: The load case.
        layout: Where everything stands.
    """
    on = [branch for branch in branches(train, flow) if branch.shaft != GROUND]
    pieces = [piece for shaft in layout.spans for piece in _pieces(shaft, on, flow, layout)]
    edges = [_directed((piece.shaft, piece.start), (piece.shaft, piece.end), piece.power) for piece in pieces]
    edges += [_directed((_part(branch), 0.0), (branch.shaft, _column(branch, layout)), branch.power) for branch in on]
    largest = max((edge.power for edge in edges), default=0.0)
    shares = _shares([edge for edge in edges if edge.power > NOTHING * largest], list(train.machines))
    stretches = [
        replace(piece, sources=shares.get((piece.shaft, piece.start if piece.power > 0.0 else piece.end), {}))
        for piece in pieces
    ]
    feeds = [Feed(branch, _column(branch, layout), shares.get(_upstream(branch, layout), {})) for branch in on]
    return Traced(stretches, feeds)


def _part(branch: Branch) -> str:
    return branch.stage or branch.part.name


def _column(branch: Branch, layout: Layout) -> float:
    return layout.places[_part(branch)].x


def _upstream(branch: Branch, layout: Layout) -> Node:
    return (_part(branch), 0.0) if branch.power > 0.0 else (branch.shaft, _column(branch, layout))


def _pieces(shaft: str, on: Sequence[Branch], flow: PowerFlow, layout: Layout) -> Iterator[Stretch]:
    """Yield every piece of a shaft with what the parts to its left give, its sources still open."""
    columns = sorted({_column(branch, layout) for branch in on if branch.shaft == shaft})
    for start, end in pairwise(columns):
        left = [branch for branch in on if branch.shaft == shaft and _column(branch, layout) <= start]
        torque, power = sum(branch.torque for branch in left), sum(branch.power for branch in left)
        yield Stretch(shaft, start, end, flow.speeds[shaft], torque, power, {})


def _directed(origin: Node, to: Node, power: float) -> Edge:
    return Edge(origin, to, power) if power >= 0.0 else Edge(to, origin, -power)


def _shares(edges: Sequence[Edge], machines: Sequence[str]) -> dict[Node, dict[str, float]]:
    """Return place -> machine -> share of the power there: mixing, solved at once as power may circle."""
    nodes = list(dict.fromkeys(node for edge in edges for node in (edge.origin, edge.to)))
    number = {node: k for k, node in enumerate(nodes)}
    matrix, sources = np.eye(len(nodes)), np.zeros((len(nodes), len(machines)))
    inflow = np.zeros(len(nodes))
    for edge in edges:
        inflow[number[edge.to]] += edge.power
    for edge in edges:
        matrix[number[edge.to], number[edge.origin]] -= edge.power / inflow[number[edge.to]]
    for k, name in enumerate(machines):
        if (name, 0.0) in number and inflow[number[name, 0.0]] == 0.0:
            sources[number[name, 0.0], k] = 1.0
    solved = np.linalg.lstsq(matrix, sources, rcond=None)[0] if nodes else sources
    return {node: {name: float(solved[k, j]) for j, name in enumerate(machines) if solved[k, j] > NOTHING}
            for node, k in number.items()}  # fmt: skip
