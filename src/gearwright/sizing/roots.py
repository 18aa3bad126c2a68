"""Root circles of gears, inside which a shaft and a bore must stay."""

from __future__ import annotations

import math

from gearwright.errors import Problem
from gearwright.parts.gears import ISO53_A
from gearwright.sizing.rating import THINNEST_RIM, TOOTH_HEIGHT, Context
from gearwright.sizing.result import GearSizing
from gearwright.units import text


def root_diameter(context: Context, gear: GearSizing) -> float:
    """Return the diameter of a gear's root circle, of a bevel gear at its thin end [m].

    Args:
        context: What sizing reads.
        gear: An external one.

    Source: ISO 21771:2007: d_f = d − 2 m_n (1.25 − x); ISO 23509:2016 at the mean cone, less b sin δ at the thin end.
    """
    rating = context.ratings[gear.stage]
    depth = 2.0 * gear.module * (ISO53_A.dedendum - gear.profile_shift)
    if rating.kind != "bevel":
        return gear.pitch_diameter - depth
    mesh = next(mesh for mesh in context.train.meshes if mesh.stage == gear.stage and gear.name in mesh.gears)
    mate = next(name for name in mesh.gears if name != gear.name)
    cone = math.atan2(gear.teeth, context.teeth[mate])  # tan δ = z/z_mate on square axes, ISO 23509:2016
    return gear.pitch_diameter - depth * math.cos(cone) - gear.face_width * math.sin(cone)


def widest_bore(context: Context, gear: GearSizing) -> float:
    """Return the widest bore that leaves a gear a rim which can be rated [m].

    Args:
        context: What sizing reads.
        gear: An external one.

    Source: ISO 6336-3:2019, clause 9: Y_B holds above half a tooth's height below the roots; thinner rims are to be
        avoided. AGMA 2001-D04 has the same end of its rim thickness factor.
    """
    return root_diameter(context, gear) - 2.0 * THINNEST_RIM * TOOTH_HEIGHT * gear.module


def bore_problem(context: Context, gear: GearSizing, path: str, bore: float) -> Problem | None:
    """Return what is wrong with a bore that leaves a gear too thin a rim; None where it leaves enough.

    Args:
        context: What sizing reads.
        gear: An external one.
        path: Key of the bore.
        bore: Its diameter [m].
    """
    most = widest_bore(context, gear)
    if bore <= most:
        return None
    given, module, root, room = (text(x, "length") for x in (bore, gear.module, root_diameter(context, gear), most))
    message = (
        f"{given}, and {gear.name} (z {gear.teeth}, m_n {module}) has a root circle of {root}; allowed: up to {room},"
        " which leaves half a tooth's height under the teeth; give a smaller bore, or the gear more teeth or a larger"
        " module"
    )
    return Problem(path, message)
