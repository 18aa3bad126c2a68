"""Undercuts of seats (DIN 509, form F) and of threads (DIN 76, form A): their profile and their enlarged detail."""

from __future__ import annotations

import math

from gearwright.catalogue import THREAD_RUN_IN, ThreadUndercut, Undercut
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
ENLARGED, THREAD_ENLARGED = 10.0, 5.0
"""Scales of the details of undercuts of seats and of threads [-]."""
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


def relief_profile(standard: ThreadUndercut) -> list[tuple[float, float]]:
    """Return the corners of a thread's undercut: along the shaft from one of its edges, and above its edges [mm].

    Args:
        standard: The undercut; on both sides its flanks lean by 30°, which meet its bottom in its radius.
    """
    depth, width, radius = MM * standard.below / 2.0, MM * standard.width, MM * standard.radius
    foot = depth / math.tan(THREAD_RUN_IN) + radius * math.tan(THREAD_RUN_IN / 2.0)
    turns = [THREAD_RUN_IN * k / _TURNS for k in range(_TURNS, -1, -1)]
    half = [(0.0, 0.0), *((foot - radius * math.sin(turn), radius * (1.0 - math.cos(turn)) - depth) for turn in turns)]
    return [*half, *((width - along, above) for along, above in reversed(half))]


def relief_detail(standard: ThreadUndercut) -> list[Entity]:
    """Return the enlarged section of a thread's undercut with its sizes; the seat on the left, the thread on the right.

    Args:
        standard: The undercut.
    """
    corners = [complex(along, above) for along, above in relief_profile(standard)]
    left, right, bottom = corners[0], corners[-1], complex(corners[0].real, -MM * standard.below / 2.0)
    edge = (left - 2.0 * AROUND, *corners, right + 2.0 * AROUND)
    low = bottom.imag - AROUND
    around = (*edge, complex(edge[-1].real, low), complex(edge[0].real, low))
    scale = THREAD_ENLARGED
    entities: list[Entity] = [
        Hatch(tuple(scale * point for point in around)),
        Path(tuple(scale * point for point in edge), Layer.OUTLINE),
    ]
    rounding = scale * corners[1 + _TURNS // 2]
    knee = complex(rounding.real + 4.0, 7.0)
    radius = f"R{millimetres(MM * standard.radius)}"
    flat = scale * corners[1 + _TURNS]
    entities += [
        Distance(scale * left, scale * right, scale * right + 16j, 0.0, scale),
        Distance(flat, scale * left, scale * edge[0] - 5.0, math.pi / 2.0, scale),
        Path((knee + Words(0j, radius).length + 2.0, knee, rounding), Layer.DIMENSION),
        arrow(rounding, (rounding - knee) / abs(rounding - knee)),
        Words(knee + complex(1.0, GAP), radius, TEXT, layer=Layer.DIMENSION),
    ]
    first, _, last, high = extent(entities)
    entities.append(Words(complex((first + last) / 2.0, high + 3.0 + SMALL), standard.designation, TEXT, "middle"))
    entities.append(Words(complex((first + last) / 2.0, high + 1.5), f"{scale:g}:1", SMALL, "middle"))
    return entities
