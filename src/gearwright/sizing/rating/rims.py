"""Rims of gears as their design states them: rings by their wall, wheels and planets where a rim is given."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gearwright.errors import Problem
from gearwright.identity import Role
from gearwright.parts.gears import ISO53_A
from gearwright.parts.iso6336 import Value, as_value, rim_factor
from gearwright.sizing.rating.rules import Rating

RIMMED = (Role.WHEEL, Role.PLANET)
"""Gears whose rim `rim_ratio` states."""
LEAST_RING = 1.75
"""Rim of rings that the standard rates, over the module [-]."""
BACKUP = 1.2
"""Rim below the roots over the tooth height where the design says nothing [-]: the least without loss of strength,
AGMA 2001-D04, rim thickness factor."""
THINNEST_RIM = 0.5
"""Rim below the roots over the tooth height, at least [-]: where Y_B ends, ISO 6336-3:2019, clause 9."""
RACEWAY = 0.66
"""Raceway of a planet's bearing in the planet over its pitch diameter where no bore is given [-], an estimate."""
TOOTH_HEIGHT = ISO53_A.addendum + ISO53_A.dedendum
"""Tooth height h_t of ISO 53, profile A, over the module [-]."""


def rim_below_roots(rating: Rating, role: Role, *, internal: bool = False) -> float | None:
    """Return the rim below the roots of a gear over its module s_R/m_n [-]; None where its body is solid.

    Args:
        rating: Resolved rules.
        role: Of the gear.
        internal: Whether it is a ring.

    Source: ISO 53, profile A: roots lie 1.25 m_n inside the pitch circle, of rings outside it.
    """
    rules = rating.rules
    if internal:
        return rules.rim_thickness_ratio - ISO53_A.dedendum
    return None if role not in RIMMED or rules.rim_ratio is None else rules.rim_ratio * TOOTH_HEIGHT


def body_inside(rating: Rating, role: Role, teeth: Value, module: Value, *, internal: bool = False) -> Value | None:
    """Return the inner diameter of a gear's body or rim, of a ring its outer one, where the design gives none [m].

    Pinions and suns count as solid: what their shafts add in mass they add in stiffness. Wheels have a rim of
    `rim_ratio`, or of 1.2 tooth heights over their web; planets the raceway of a bearing, at most to such a rim.

    Args:
        rating: Resolved rules.
        role: Of the gear.
        teeth: z, positive [-].
        module: m_n [m].
        internal: Whether it is a ring.

    Source: ISO 6336-1:2006, clause 6.5.9 (d_i of the rim); 0.66 d by bearings of planets, an estimate.
    """
    rules = rating.rules
    pitch = np.asarray(teeth) * module / math.cos(rating.helix_angle)
    if internal:
        return as_value(pitch + 2.0 * rules.rim_thickness_ratio * module)
    if role not in RIMMED or rating.kind == "face":
        return None
    if role is Role.WHEEL and rules.rim_ratio is None and rules.web_thickness_ratio >= 1.0:
        return None
    rim = BACKUP if rules.rim_ratio is None else rules.rim_ratio
    inside = np.maximum(pitch - 2.0 * (ISO53_A.dedendum + rim * TOOTH_HEIGHT) * module, 0.0)
    if role is Role.PLANET and rules.rim_ratio is None:
        return as_value(np.minimum(inside, RACEWAY * pitch))
    return as_value(inside)


def rim_factors(rating: Rating, roles: tuple[Role, Role], *, internal: bool) -> tuple[float, float]:
    """Return the rim thickness factors Y_B of both gears of a mesh [-].

    Args:
        rating: Resolved rules.
        roles: What both gears are in their stage.
        internal: Whether the second gear is a ring.

    Source: ISO 6336-3:2006, clause 9.

    Raises:
        DesignError: Rims that are too thin for the standard, which `ring_problems` names before.
    """
    first, second = (_factor(rating, role, internal=internal and gear == 1) for gear, role in enumerate(roles))
    return first, second


def ring_problems(rating: Rating) -> Iterator[Problem]:
    """Yield a rim of a ring that is too thin for the standard, by the key that states it.

    Args:
        rating: Resolved rules of a stage with a ring.

    Source: ISO 6336-3:2006, clause 9.
    """
    rim = rim_below_roots(rating, Role.RING, internal=True)
    if rim is not None and rim <= LEAST_RING:
        given, least = rating.rules.rim_thickness_ratio, LEAST_RING + ISO53_A.dedendum
        why = f"{given:g} leaves a rim that ISO 6336-3, clause 9 does not rate; give more than {least:.4g}"
        yield Problem("gears.rim_thickness_ratio", why)


def _factor(rating: Rating, role: Role, *, internal: bool) -> float:
    """Y_B of one gear."""
    if (rim := rim_below_roots(rating, role, internal=internal)) is None:
        return 1.0
    return float(np.asarray(rim_factor(rim, TOOTH_HEIGHT, 1.0, internal=internal)))
