"""Which ratios a stage can have whatever its teeth, and which speeds that leaves a shaft between two others."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from gearwright.parts.planetary import most_planet_teeth
from gearwright.spec import Design, Pair, Planetary
from gearwright.spec.design import SUN_LIMITS
from gearwright.train.kinematics import Edge, asked_tooth_ratio, edge_of

Range = tuple[float, float]
"""Least and largest [-]."""
ANY: Range = (0.0, math.inf)
"""Of a stage of which nothing is known that limits it."""


def tooth_ratio_range(stage: Planetary, design: Design, *, sun: int) -> Range:
    """Return the least and the largest z_r/z_s of a planetary set whose teeth are free [-].

    The least has the largest sun and the smallest planets, the largest the planets that just pass their neighbours; two
    of them always do.

    Args:
        stage: As in the design.
        design: With the limits of the search.
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    rules = design.teeth
    largest, planets = rules.largest_sun(sun), stage.planets_given
    most = math.inf if planets is None or planets <= 2 else most_planet_teeth(largest, planets)
    return 1.0 + 2.0 * rules.planet_minimum / largest, 1.0 + 2.0 * most / largest


def ratio_range(stage: Pair | Planetary, edge: Edge, design: Design, *, sun: int) -> Range:
    """Return the least and the largest ratio of the speeds that a stage joins [-].

    Args:
        stage: As in the design.
        edge: The same as one ratio.
        design: With the limits of the search.
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    asked = asked_tooth_ratio(stage)
    if asked is not None:
        return edge.ratio(asked), edge.ratio(asked)
    if not isinstance(stage, Planetary) or (stage.sun_teeth or stage.planet_teeth or stage.ring_teeth):
        return ANY
    least, most = sorted(edge.ratio(tooth_ratio) for tooth_ratio in tooth_ratio_range(stage, design, sun=sun))
    return least, most


def total_range(design: Design, stages: Iterable[str], edges: Mapping[str, Edge]) -> Range:
    """Return the least and the largest ratio of stages in series [-].

    Args:
        design: With them.
        stages: Their names.
        edges: Stage -> its ratio; one that is in none may have any.
    """
    ranges = [
        ratio_range(design.simple_stages[name], edges[name], design, sun=SUN_LIMITS[-1]) if name in edges else ANY
        for name in stages
    ]
    return math.prod(least for least, _ in ranges), math.prod(most for _, most in ranges)


def speed_range(shaft: str, design: Design, speeds: Mapping[str, float], *, sun: int) -> Range:
    """Return between which speeds a shaft can turn, as its stages join it to shafts whose speeds are known [rad/s].

    Args:
        shaft: Of the design.
        design: With the stages.
        speeds: Shaft -> speed without its sense [rad/s].
        sun: Teeth of the largest sun where the design does not limit them [-].
    """
    low, high = ANY
    for name, stage in design.simple_stages.items():
        edge = edge_of(name, design)
        if edge is None:
            continue
        least, most = ratio_range(stage, edge, design, sun=sun)
        for other in edge.fast:
            if shaft in edge.slow and other in speeds:
                low, high = max(low, speeds[other] / most), min(high, speeds[other] / least if least else math.inf)
        for other in edge.slow:
            if shaft in edge.fast and other in speeds:
                low, high = max(low, speeds[other] * least), min(high, speeds[other] * most)
    return low, high
