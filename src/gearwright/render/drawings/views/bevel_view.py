"""The section of a bevel gear with its dimensions about the apex."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from gearwright.parts.bevel import BevelProfile, face_and_root
from gearwright.render.drawings.sheet.crossing import Segment, crossings, segments
from gearwright.render.drawings.sheet.dimensions import corner_leader, corner_words, words_corners
from gearwright.render.drawings.sheet.entities import Corner, Distance, Entity, Layer, Path
from gearwright.render.drawings.sheet.tolerances import datum
from gearwright.render.drawings.views.gear_dimensions import LEAN, runout_beside, thickness
from gearwright.render.drawings.views.gear_parts import Boss, Hub
from gearwright.render.drawings.views.gear_view import bevel_corners, bevel_section, bore_edges
from gearwright.render.drawings.views.shaft_parts import bevel_profile
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis
from gearwright.shape.teeth import bevel_pair, meshes_of
from gearwright.sizing import GearSizing, Sizing

BESIDE = 0.85
"""Share of the way from the apex to the hub that angles take, so that their texts stay clear of it [-]."""
SHARES = (1.0, 0.93, 0.86, 0.8, 0.74, 0.68, 0.62, 0.56, 0.5, 0.44, 0.38)
"""Of the radius of an angle's arc that are tried where lines run through its text [-]."""


def bevel_view(sizing: Sizing, gear: GearSizing, hub: Hub, axis: Axis) -> list[Entity]:
    """Return a bevel gear in section with its dimensions.

    Args:
        sizing: What was sized.
        gear: A bevel gear of it.
        hub: Of the gear.
        axis: On paper.
    """
    profile = bevel_profile(sizing, gear)
    beyond = OVERSHOOT / axis.scale
    corners = bevel_corners(profile, hub)
    heel, bored = corners[2], _bored(corners, hub)
    entities: list[Entity] = [
        Path((axis.at(profile.apex - beyond), axis.at(max(heel.real, profile.large[0].real) + beyond)), Layer.CENTRE)
    ]
    entities += bevel_section(axis, profile, hub, away=1.0, lean=LEAN)
    entities += bore_edges(axis, bored, hub)
    entities += [
        Path((axis.at(profile.apex), axis.on(corner)), Layer.DIMENSION)
        for corner in (profile.small[0], profile.roots[0])
    ]
    arcs = _bevel_angles(sizing, gear, axis, profile=profile, boss=hub.boss)
    angles = _uncrossed(arcs, list(segments(entities)))
    entities += _bevel_lengths(axis, profile, angles, hub=hub, back=heel.real)
    lines = list(segments(entities))
    entities += [angle for angle in angles if not crossings(corner_words(angle), lines)]
    tip = profile.large[0]
    right = axis.at(max(heel.real, tip.real, bored[1])).real + 9.0
    entities.append(_at(axis, tip, right + (8.0 if hub.boss is None else 16.0)))
    if hub.bore:
        suffix = f" {hub.tolerance}" if hub.tolerance else ""
        entities.append(_at(axis, complex(bored[1], hub.bore / 2.0), right, suffix))
        entities += datum(complex(right, axis.at(0.0, -hub.bore / 2.0).imag), -1j, "A")
        root = profile.roots[1].imag
        face = axis.at(heel.real, -0.9 * root)
        entities += runout_beside(face, max(right, face.real) + 24.0, root)
    if hub.boss is not None:
        outer = complex(max(hub.boss.end, heel.real), hub.boss.diameter / 2.0)
        entities += [_at(axis, outer, right + 8.0), _hub_length(axis, hub.boss, hub.bore / 2.0)]
        web = bevel_plate(hub)
        if web is not None:
            low, high = web.hub, web.rim
            front = web.front + web.lean * (high - 0.5 * (low + high))
            entities += thickness(axis, (front, front + web.width), (low, high))
    return entities


class Plate(NamedTuple):
    """The web of a bevel gear, from the mean point along the axis away from the apex [mm]."""

    front: float
    """Where its face towards the apex meets the rim."""
    width: float
    """Along the axis."""
    lean: float
    """Towards its hub [-]."""
    hub: float
    """Radius of the hub."""
    rim: float
    """Radius inside the rim, on the face towards the apex."""
    behind: float
    """The same behind."""


def bevel_plate(hub: Hub) -> Plate | None:
    """Return the web of a bored bevel gear; None where rim and hub meet.

    Args:
        hub: Of the gear.
    """
    if len(hub.way) < len(("heel", "back", "hub", "bore", "bore", "hub", "front", "toe")):
        return None
    toe, front = hub.way[-1], hub.way[-2]
    at = 2 if hub.way[1].imag != hub.way[2].imag else 1
    back = hub.way[at]
    lean = (front.real - toe.real) / (toe.imag - front.imag)
    return Plate(toe.real, back.real - front.real, lean, front.imag, toe.imag, hub.way[at - 1].imag)


def _uncrossed(arcs: Sequence[Corner], lines: Sequence[Segment]) -> list[Corner]:
    """Return the first angle at the largest radius at which no line runs through its text, and the clear others.

    Where no radius is clear, the table of tooth data has it alone.
    """
    first, *others = arcs
    tried = [replace(first, radius=share * first.radius) for share in SHARES]
    wide = next((arc for arc in tried if not crossings(corner_words(arc), lines)), None)
    if wide is None:
        return []
    return [
        wide,
        *(arc for arc in others if not crossings(corner_words(arc), lines) and arc.radius < 0.8 * wide.radius),
    ]


def _bored(corners: Sequence[complex], hub: Hub) -> tuple[float, float]:
    """Return where the bore begins and ends [mm]."""
    ends = [corner.real for corner in corners if corner.imag <= hub.bore / 2.0]
    return min(ends), max(ends)


def _hub_length(axis: Axis, boss: Boss, bore: float) -> Distance:
    """Return the length of the hub, within its bore."""
    line = axis.at(0.0, -bore) + 2.0j
    return Distance(axis.at(boss.start, -bore), axis.at(boss.end, -bore), line, 0.0, axis.scale)


def _at(axis: Axis, point: complex, x: float, suffix: str = "") -> Distance:
    return Distance(axis.on(point.conjugate()), axis.on(point), complex(x, 0.0), math.pi / 2.0, axis.scale, "Ø", suffix)


def _bevel_lengths(
    axis: Axis, profile: BevelProfile, angles: Sequence[Corner], *, hub: Hub, back: float
) -> Iterator[Entity]:
    """Yield face width and, beyond the texts of angles, cone distance; hub, crown and back of a body from the apex."""
    apex = axis.at(profile.apex)
    near, far = axis.on(profile.small[1]), axis.on(profile.large[1])
    turn = cmath.phase(far - apex)
    above = cmath.rect(1.0, turn + math.pi / 2.0)
    clear = ((axis.on(profile.large[0]) - far) * above.conjugate()).real
    yield Distance(near, far, far + above * (clear + 9.0), turn, axis.scale)
    texts = [point for angle in angles for point in words_corners(corner_words(angle))]
    over = max((((point - far) * above.conjugate()).real for point in texts), default=0.0)
    yield Distance(apex, far, far + above * max(clear + 17.0, over + 1.0), turn, axis.scale)
    crown = axis.on(profile.large[0].conjugate())
    points = [] if hub.boss is None else [axis.at(hub.boss.start, -hub.boss.diameter / 2.0)]
    points += [crown, *([axis.at(back, -profile.roots[0].imag)] if hub.bore else [])]
    for row, point in enumerate(sorted(points, key=lambda point: point.real)):
        yield Distance(apex, point, complex(0.0, crown.imag - 9.0 - 8.0 * row), 0.0, axis.scale)


def _bevel_angles(
    sizing: Sizing, gear: GearSizing, axis: Axis, *, profile: BevelProfile, boss: Boss | None
) -> list[Corner]:
    """Return pitch, face and root cone angle about the apex."""
    pair, side = bevel_pair(sizing, gear.stage), meshes_of(sizing, gear.name)[0][1]
    apex = axis.at(profile.apex)
    face, root = face_and_root(pair, side)
    free = profile.roots[0].real - profile.apex
    if boss is not None and boss.start > profile.apex:
        free = min(free, BESIDE * (boss.start - profile.apex))
    clear = min(axis.scale * free, abs(axis.on(profile.small[0]) - apex))
    arcs = [Corner(apex, 0.0, angle, share * clear)
            for share, angle in ((0.94, pair.pitch_angles[side]), (0.7, face), (0.46, root))]  # fmt: skip
    # Where the apex is too near for all three, the table has the others.
    return [arc for k, arc in enumerate(arcs) if k == 0 or not corner_leader(arc)]
