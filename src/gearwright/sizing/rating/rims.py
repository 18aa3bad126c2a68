"""Rims of gears as their design states them: rings by their wall, wheels and planets where a rim is given."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearwright.errors import Problem
from gearwright.identity import Role
from gearwright.parts.gears import ISO53_A
from gearwright.parts.iso6336 import rim_factor
from gearwright.sizing.rating.rules import Rating

RIMMED = (Role.WHEEL, Role.PLANET)
"""Gears whose rim `rim_ratio` states."""
LEAST_RING = 1.75
"""Rim of rings that the standard rates, over the module [-]."""
HEIGHT = ISO53_A.addendum + ISO53_A.dedendum
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
    return None if role not in RIMMED or rules.rim_ratio is None else rules.rim_ratio * HEIGHT


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
    return float(np.asarray(rim_factor(rim, HEIGHT, 1.0, internal=internal)))
