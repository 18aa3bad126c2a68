"""The cones of a sized bevel pair."""

from __future__ import annotations

from collections.abc import Mapping

from gearwright.parts.bevel import BevelPair
from gearwright.sizing.rating import Context, standard_teeth
from gearwright.sizing.result import GearSizing


def bevel_cones(context: Context, gears: Mapping[str, GearSizing], stage: str) -> BevelPair:
    """Return the cones of a bevel pair; its gears are sized at their mean cones.

    Args:
        context: What sizing reads.
        gears: By name.
        stage: The pair.
    """
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == stage)
    pinion, wheel = (gears[name] for name in mesh.gears)
    return standard_teeth.bevel_pair(
        (pinion.teeth, wheel.teeth), pinion.module, pinion.face_width, context.ratings[stage]
    )
