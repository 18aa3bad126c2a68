"""How often teeth mesh and planets pass: the frequencies that a turning train shakes its housing with."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Literal

from gearwright.spec import Design, Planetary
from gearwright.train.flow.carried import PowerFlow
from gearwright.train.graph import INTERNAL, Mesh, Train

Pass = Literal["mesh", "planet-pass"]


def passes(
    design: Design, train: Train, teeth: Mapping[str, float], flow: PowerFlow, of: Pass
) -> Iterator[tuple[Mesh, float]]:
    """Yield the rows of a train whose teeth mesh, or whose planets pass a tooth of their ring, and how often [Hz].

    Both rows of a planetary set mesh as often: the one with the sun speaks for it. What stands still passes nothing.

    Args:
        design: With its stages.
        train: Its graph.
        teeth: Tooth number of every gear.
        flow: A load case.
        of: Teeth (mesh) or planets (planet-pass).

    Source: counting: z |ω − ω_c|/2π and N |ω_c − ω_r|/2π; McFadden & Smith 1985, Proc. Inst. Mech. Eng. C 199, 65-70.
    """
    for mesh in train.meshes:
        first, second, carrier = (flow.speeds[node] for node in mesh.nodes)
        in_ring = mesh.sign == INTERNAL
        if of == "mesh" and not (in_ring and isinstance(design.stages[mesh.stage], Planetary)):
            frequency = teeth[mesh.gears[0]] * abs(first - carrier) / (2.0 * math.pi)
        elif of == "planet-pass" and in_ring and mesh.stage in design.sets:
            frequency = mesh.count * abs(carrier - second) / (2.0 * math.pi)
        else:
            continue
        if frequency:
            yield mesh, frequency
