"""What ratio each stage should have, before teeth are chosen.

Shaft speeds are potentials: every stage with one grounded member joins two shafts by one ratio, machines fix the speeds
of their shafts, and what they leave open is split into equal ratios (Pulvirenti 2023, eq. 2.5; ψ is ``ratio_split``).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.spec import GROUND, Design, Pair, Planetary
from gearwright.train.flow import asked_speeds
from gearwright.train.graph import shafts_of
from gearwright.train.kinematics import Array

# Weights of what holds first, in log speeds: the kept speed, given teeth and ratios, other machines, equal ratios.
_KEPT, _GIVEN, _ASKED, _EQUAL = 1e9, 1e6, 1e3, 1.0


@dataclass(frozen=True)
class Edge:
    """A stage as one ratio between two shafts: ω_fast / ω_slow = ratio(tooth ratio)."""

    stage: str
    fast: tuple[str, ...]
    """Shafts of the pinions, or of the sun (of the ring where the sun stands still)."""
    slow: tuple[str, ...]
    """Shafts of the wheels, or the other turning member's."""
    grounded: str
    """``ring``, ``carrier``, ``sun``; or ``axes`` for a pair."""

    def ratio(self, tooth_ratio: float) -> float:
        """Return the speed ratio of a tooth ratio z_2/z_1 or z_r/z_s [-]."""
        match self.grounded:
            case "ring":
                return 1.0 + tooth_ratio
            case "sun":
                return 1.0 + 1.0 / tooth_ratio
            case _:
                return tooth_ratio

    def tooth_ratio(self, ratio: float) -> float:
        """Return the tooth ratio of a speed ratio [-]."""
        match self.grounded:
            case "ring":
                return ratio - 1.0
            case "sun":
                return 1.0 / (ratio - 1.0)
            case _:
                return ratio


@dataclass(frozen=True)
class Targets:
    """Nominal speeds and tooth ratios."""

    speeds: Mapping[str, float]
    """Shaft -> nominal speed without its sense [rad/s]."""
    tooth_ratios: Mapping[str, float]
    """Stage -> z_2/z_1 or z_r/z_s asked [-]."""
    edges: Mapping[str, Edge]
    """Stages that join two shafts; a differential is not in it."""


def targets(design: Design) -> Targets:
    """Return the nominal speed of every shaft and the tooth ratio asked of every stage.

    Args:
        design: With its machines and stages.

    Raises:
        DesignError: If a speed is not determined, or a differential's speeds allow no teeth.
    """
    edges = {name: edge for name in design.stages if (edge := edge_of(name, design)) is not None}
    speeds = _potentials(design, edges, {})
    split = {name: _ratio(edge, speeds) * design.stages[name].ratio_split for name, edge in edges.items()}
    changed = {name: ratio for name, ratio in split.items() if design.stages[name].ratio_split != 1.0}
    if changed:
        speeds = _potentials(design, edges, changed)
    tooth_ratios = {name: edge.tooth_ratio(_ratio(edge, speeds)) for name, edge in edges.items()}
    for name in design.planetaries.keys() - edges.keys():
        tooth_ratios[name] = _differential(name, design.planetaries[name], speeds)
    return Targets(speeds, tooth_ratios, edges)


def edge_of(name: str, design: Design) -> Edge | None:
    """Return a stage as an edge between shafts, or None for a differential.

    Args:
        name: Name of the stage.
        design: The design.
    """
    stage = design.stages[name]
    if isinstance(stage, Pair):
        pinions, wheels = shafts_of("pinion", stage, design), shafts_of("wheel", stage, design)
        return Edge(name, tuple(pinions), tuple(wheels), "axes")
    if stage.ring == GROUND:
        return Edge(name, (stage.sun,), (stage.carrier,), "ring")
    if stage.carrier == GROUND:
        return Edge(name, (stage.sun,), (stage.ring,), "carrier")
    if stage.sun == GROUND:
        return Edge(name, (stage.ring,), (stage.carrier,), "sun")
    return None


def _ratio(edge: Edge, speeds: Mapping[str, float]) -> float:
    return speeds[edge.fast[0]] / speeds[edge.slow[0]]


def given_tooth_ratio(stage: Pair | Planetary) -> float | None:
    """Return the tooth ratio that a stage's own teeth give, if they do [-].

    Args:
        stage: As in the design.
    """
    if isinstance(stage, Pair):
        return stage.wheel_teeth / stage.pinion_teeth if stage.pinion_teeth and stage.wheel_teeth else None
    sun, planet, ring = stage.sun_teeth, stage.planet_teeth, stage.ring_teeth
    if ring and planet:
        sun = ring - 2 * planet
    elif sun and planet:
        ring = sun + 2 * planet
    return ring / sun if sun and ring else None


def _potentials(design: Design, edges: Mapping[str, Edge], fixed: Mapping[str, float]) -> dict[str, float]:
    """Return shaft speeds by weighted least squares in their logarithms."""
    column = {name: k for k, name in enumerate(design.shafts)}
    equations: list[tuple[dict[str, float], float, float]] = []
    for rank, (machine, speed) in enumerate(asked_speeds(design, {}).items()):
        shaft = design.machines[machine].shaft
        equations.append(({shaft: 1.0}, math.log(abs(speed)), _KEPT if rank == 0 else _ASKED))
    for name, edge in edges.items():
        ratio, weight = _edge_ratio(design.stages[name], edge, fixed.get(name))
        equations += [({fast: 1.0, slow: -1.0}, math.log(ratio), weight) for fast in edge.fast for slow in edge.slow]
    equations += [({clutch.driving: 1.0, clutch.driven: -1.0}, 0.0, _GIVEN) for clutch in design.clutches.values()]
    matrix = np.zeros((len(equations), len(column)))
    right = np.zeros(len(equations))
    for k, (terms, value, weight) in enumerate(equations):
        for shaft, factor in terms.items():
            if shaft != GROUND:
                matrix[k, column[shaft]] += factor * weight
        right[k] = value * weight
    _require_connected(matrix, design)
    solution, *_ = np.linalg.lstsq(matrix, right, rcond=1e-14)
    return {name: math.exp(solution[k]) for name, k in column.items()}


def _edge_ratio(stage: Pair | Planetary, edge: Edge, fixed: float | None) -> tuple[float, float]:
    """Return an edge's ratio and how firmly it holds."""
    asked = given_tooth_ratio(stage)
    if asked is None and stage.ratio is not None:
        asked = stage.ratio if isinstance(stage, Pair) else stage.ratio - 1.0
    if asked is not None:
        return edge.ratio(asked), _GIVEN
    return (fixed, _GIVEN) if fixed is not None else (1.0, _EQUAL)


def _require_connected(matrix: Array, design: Design) -> None:
    """Raise where a shaft's speed has no equation that leads to a machine."""
    _, values, right = np.linalg.svd(matrix / np.maximum(np.abs(matrix).max(axis=1, keepdims=True), 1e-300))
    rank = int(np.sum(values > 1e-10 * values[0]))
    loose = [name for k, name in enumerate(design.shafts) if np.abs(right[rank:, k]).max(initial=0.0) > 1e-8]
    if loose:
        message = (
            f"the speeds of {', '.join(loose)} are not determined: no machine gives them, and no stage with a grounded"
            " member leads to a machine; put a machine with a speed on one of them, or ground a member"
        )
        raise DesignError([Problem("shafts", message)])


def members_of(stage: Planetary) -> tuple[str, str, str]:
    """Return the shafts of sun, ring and carrier.

    Args:
        stage: A planetary set.
    """
    return stage.sun, stage.ring, stage.carrier


def willis_ratio(stage: Planetary, speeds: Mapping[str, Array]) -> Array:
    """Return z_r/z_s that lets the members turn at given speeds [-].

    Args:
        stage: A planetary set.
        speeds: Shaft -> speed without its sense; the ground is zero [rad/s].

    Source: Willis 1841, ω_s − ω_c = −(z_r/z_s) (ω_r − ω_c); with the carrier held the ring turns backwards.
    """
    sun, ring, carrier = (speeds[member] for member in members_of(stage))
    if stage.carrier == GROUND:
        return np.asarray(sun / ring)
    with np.errstate(divide="ignore"):
        return np.asarray((sun - carrier) / (carrier - ring))


def willis_speed(stage: Planetary, member: str, ratio: Array, speeds: Mapping[str, Array]) -> Array:
    """Return the speed of one member from those of the other two, without its sense [rad/s].

    Args:
        stage: A planetary set.
        member: Shaft whose speed is asked.
        ratio: z_r/z_s [-].
        speeds: Shaft -> speed of the others [rad/s].

    Source: Willis 1841, ω_s + (z_r/z_s) ω_r = (1 + z_r/z_s) ω_c.
    """
    zero = np.zeros(len(ratio))
    sun, ring, carrier = (speeds.get(each, zero) for each in members_of(stage))
    if member == stage.sun:
        return np.abs((1.0 + ratio) * carrier - ratio * ring)
    if member == stage.ring:
        return np.abs(((1.0 + ratio) * carrier - sun) / ratio)
    return np.abs((sun + ratio * ring) / (1.0 + ratio))


def _differential(name: str, stage: Planetary, speeds: Mapping[str, float]) -> float:
    """Return z_r/z_s of a planetary set whose three members turn."""
    given = given_tooth_ratio(stage)
    if given is not None:
        return given
    sun, ring, carrier = (speeds[member] for member in members_of(stage))
    ratio = float(willis_ratio(stage, {member: np.asarray(speeds[member]) for member in members_of(stage)}))
    if not 1.0 < ratio < math.inf:
        message = (
            f"no teeth let sun, ring and carrier turn at {sun:.4g}, {ring:.4g} and {carrier:.4g} rad/s: z_r/z_s would"
            f" be {ratio:.3g}, and it must lie above 1; put the carrier's speed between the others, nearer the ring's"
        )
        raise DesignError([Problem(f"planetaries.{name}", message)])
    return ratio
