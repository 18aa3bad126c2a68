"""Root circles of gears, inside which a shaft must stay."""

from __future__ import annotations

import math

from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing

DEDENDUM = 1.25
"""Dedendum of the basic rack over the module [-] (ISO 53)."""


def root_diameter(context: Context, gear: GearSizing) -> float:
    """Return the diameter of a gear's root circle, of a bevel gear at its thin end [m].

    Args:
        context: What sizing reads.
        gear: A pinion, wheel or sun.

    Source: ISO 21771:2007: d_f = d − 2 m_n (1.25 − x); ISO 23509:2016 at the mean cone, less b sin δ at the thin end.
    """
    rating = context.ratings[gear.stage]
    depth = 2.0 * gear.module * (DEDENDUM - gear.profile_shift)
    if rating.kind != "bevel":
        return gear.pitch_diameter - depth
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == gear.stage and gear.name in mesh.gears)
    mate = next(name for name in mesh.gears if name != gear.name)
    cone = math.atan2(gear.teeth, context.teeth[mate])  # tan δ = z/z_mate on square axes, ISO 23509:2016
    return gear.pitch_diameter - depth * math.cos(cone) - gear.face_width * math.sin(cone)
