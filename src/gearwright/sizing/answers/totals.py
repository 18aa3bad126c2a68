"""What optimisers want little of beside mass, loss and room: shaken meshes, flanks to be ground."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from gearwright.parts.gears import GearPair
from gearwright.sizing.meshed import MeshSizing
from gearwright.sizing.result import Sizing
from gearwright.sizing.tooth_shape import cylindrical_gear
from gearwright.spec import Pair
from gearwright.train import INTERNAL


def excitation(sizing: Sizing) -> float:
    """Return by how much changing contact lines shake all meshes [N]: √(Σ N (F_t s)²) over rows of N meshes.

    It stands for noise where nobody knows flanks and housing: the quieter of two gearboxes for one power has the less.

    Args:
        sizing: As sized; bevel and face gears are left out.

    Source: s = 2 |sinc(ε_α) sinc(ε_β)|, sinc(x) = sin(πx)/(πx): first harmonic over the mean of the length of contact
        lines of perfect cylindrical gears, Maatar and Velex 1996, J. Mech. Des. 118 (3), 358-363.
    """
    rows = [(mesh.count, mesh.tangential_force * swing_of(pair)) for mesh, pair in _pairs(sizing)]
    return math.sqrt(sum(count * force * force for count, force in rows))


def swing_of(pair: GearPair) -> float:
    """Return the first harmonic of the length of contact lines over its mean [-].

    Args:
        pair: Of cylindrical gears.

    Source: as `excitation`.
    """
    return abs(2.0 * _sinc(pair.transverse_contact_ratio) * _sinc(pair.overlap_ratio))


def _sinc(ratio: float) -> float:
    angle = math.pi * max(abs(ratio), 1e-9)
    return math.sin(angle) / angle


def _pairs(sizing: Sizing) -> Iterator[tuple[MeshSizing, GearPair]]:
    """Yield every row of cylindrical gears with the geometry of one mesh."""
    gears = {gear.name: gear for gear in sizing.gears}
    for mesh, row in zip(sizing.meshes, sizing.train.meshes, strict=True):
        stage = sizing.design.stages[mesh.stage]
        if isinstance(stage, Pair) and stage.kind != "cylindrical":
            continue
        first, second = (cylindrical_gear(sizing.design, gears[gear]) for gear in mesh.gears)
        second = replace(second, teeth=-second.teeth) if row.sign == INTERNAL else second
        moved = first.profile_shift + second.profile_shift != 0.0
        yield mesh, GearPair(first, second, mesh.centre_distance if moved else None)


def flank_area(sizing: Sizing) -> float:
    """Return the area of all flanks, 2 z b h/cos β of every gear [m²], h = 2.25 m_n: what is cut and ground.

    It stands for cost: time and wear of tools go with it, whatever they cost.

    Args:
        sizing: As sized.
    """
    return sum(
        gear.bodies * 2.0 * gear.teeth * gear.face_width * 2.25 * gear.module / math.cos(gear.helix_angle)
        for gear in sizing.gears
    )
