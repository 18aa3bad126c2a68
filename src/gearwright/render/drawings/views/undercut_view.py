"""Undercuts of DIN 509, form F: their profile in a shaft's outline, and the enlarged detail with their sizes."""

from __future__ import annotations

import math

from gearwright.catalogue import Undercut
from gearwright.render.drawings.sheet.dimensions import arrow, extent
from gearwright.render.drawings.sheet.entities import (
    GAP,
    SMALL,
    TEXT,
    Distance,
    Entity,
    Hatch,
    Layer,
    Path,
    Words,
    millimetres,
)

MM = 1e3
"""Millimetres in a metre."""
RUN_IN, RUN_OUT = math.radians(15.0), math.radians(8.0)
"""Angles to the seat and to the face [rad] (DIN 509:1998, form F)."""
ENLARGED = 10.0
"""Scale of the detail [-]."""
AROUND = 1.5
"""Of seat and face beside the undercut in the detail, and metal below it [mm]."""
_TURNS = 8


def undercut_profile(standard: Undercut) -> list[tuple[float, float]]:
    """Return the corners of an undercut from seat to face: from the face along the seat, and above the seat [mm].

    Args:
        standard: The undercut.
    """
    depth, behind, radius = MM * standard.depth, MM * standard.face_depth, MM * standard.radius
    width = MM * standard.width
    quarter = [math.pi / 2.0 * k / _TURNS for k in range(_TURNS + 1)]
    rounded = [(radius * (1.0 - math.sin(turn)) - behind, radius * (1.0 - math.cos(turn)) - depth) for turn in quarter]
    return [
        (width, 0.0), (width - depth / math.tan(RUN_IN), -depth),
        *rounded, (0.0, radius - depth + behind / math.tan(RUN_OUT)),
    ]  # fmt: skip


def undercut_detail(standard: Undercut) -> list[Entity]:
    """Return the enlarged section of an undercut with its sizes; the seat on the left, the face on the right.

    Args:
        standard: The undercut.
    """
    corners = [complex(-along, above) for along, above in undercut_profile(standard)]
    seat, foot, top, behind = corners[0], corners[1], corners[-1], corners[-2]
    edge = (seat - AROUND, *corners, top + 1j * AROUND)
    low = complex(behind.real + AROUND, foot.imag - AROUND)
    around = (*edge, complex(low.real, edge[-1].imag), low, complex(edge[0].real, low.imag))
    entities: list[Entity] = [
        Hatch(tuple(ENLARGED * point for point in around)),
        Path(tuple(ENLARGED * point for point in edge), Layer.OUTLINE),
    ]
    above = ENLARGED * (top + 1j * AROUND)
    rounding = ENLARGED * corners[2 + _TURNS // 2]
    knee = complex(rounding.real - 6.0, ENLARGED * top.imag * 0.5 + 2.0)
    radius = f"R{millimetres(MM * standard.radius)}"
    shoulder = knee - complex(Words(0j, radius).length + 2.0, 0.0)
    entities += [
        Distance(ENLARGED * seat, above, above + 8j, 0.0, ENLARGED),
        Distance(above, ENLARGED * behind, above + 18j, 0.0, ENLARGED),
        Distance(ENLARGED * seat, ENLARGED * foot, ENLARGED * edge[0] - 5.0, math.pi / 2.0, ENLARGED),
        Path((shoulder, knee, rounding), Layer.DIMENSION),
        arrow(rounding, (rounding - knee) / abs(rounding - knee)),
        Words(shoulder + complex(1.0, GAP), radius, TEXT, layer=Layer.DIMENSION),
    ]
    left, _, right, high = extent(entities)
    entities.append(Words(complex((left + right) / 2.0, high + 3.0 + SMALL), standard.designation, TEXT, "middle"))
    entities.append(Words(complex((left + right) / 2.0, high + 1.5), f"{ENLARGED:g}:1", SMALL, "middle"))
    return entities
