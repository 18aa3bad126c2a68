"""Sections of gears along their axis by ISO 2203, and of hubs across it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from gearwright.parts.bevel import BevelProfile
from gearwright.parts.gears import CylindricalGear
from gearwright.render.drawings.sheet.entities import Entity, Hatch, Layer, Path
from gearwright.render.drawings.views.gear_parts import Hub, Web
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis, keyed_rim
from gearwright.sizing.casing import RingSeat
from gearwright.sizing.places import Bell
from gearwright.sizing.rating import BACKUP


def cylinder_section(
    axis: Axis, teeth: CylindricalGear, hub: Hub, span: tuple[float, float], *, lean: float
) -> list[Entity]:
    """Return an external gear in section, both halves.

    Args:
        axis: Where its axis lies.
        teeth: Its teeth.
        hub: Its bore.
        span: From face to face along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    root, tip = MM * teeth.root_radius, MM * teeth.tip_radius
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        inner = (hub.reach if side > 0.0 else _bottom(hub)) / 2.0
        whole = _box(span, inner, root, side) if hub.web is None else _webbed(span, hub.web, inner, root, side)
        bodies = [whole] if hub.web is None or not hub.web.holes else _bored(whole, hub.web, side)
        outline = _box(span, hub.bore / 2.0, tip, side)
        # Without a bore the two halves are one: no edge lies on the axis.
        entities += [hatched(axis, body, lean) for body in bodies]
        entities.append(line(axis, outline[1:] + outline[:1], closed=hub.bore > 0.0))
        entities.append(line(axis, _along(span, side * root)))
        if hub.web is not None:
            entities += [line(axis, recess) for recess in _recesses(span, hub.web, side)]
            entities += _hole(axis, hub.web, (span[0] + span[1]) / 2.0, side)
        if inner > hub.bore / 2.0:
            entities.append(line(axis, _along(span, side * inner)))
        entities.append(_pitch(axis, span, side * MM * teeth.pitch_radius))
    return entities


def _recesses(span: tuple[float, float], web: Web, side: float) -> list[list[complex]]:
    """Return the edges of what is turned out on both faces, from the hub over the web to the rim."""
    middle, half = (span[0] + span[1]) / 2.0, web.width / 2.0
    ways = ((span[0], middle - half), (span[1], middle + half))
    return [
        [complex(face, side * web.hub), complex(deep + web.dish, side * web.hub),
         complex(deep, side * web.rim), complex(face, side * web.rim)]
        for face, deep in ways
    ]  # fmt: skip


def _webbed(span: tuple[float, float], web: Web, inner: float, root: float, side: float) -> list[complex]:
    """Return the section of a body with rim, web and hub."""
    first, second = _recesses(span, web, side)
    return [complex(span[0], side * inner), *first, *_along(span, side * root), *second[::-1],
            complex(span[1], side * inner)]  # fmt: skip


def _bored(body: list[complex], web: Web, side: float) -> list[list[complex]]:
    """Return the two parts of a section through a hole of its web: around the hub, and around the rim."""
    ends = [[complex(x, side * (web.circle + way * web.hole)) for x in (body[2].real, body[9].real)] for way in (-1, 1)]
    inner = [*body[:3], *ends[0], *body[9:]]
    outer = [ends[1][0], *body[3:9], ends[1][1]]
    return [inner, outer]


def _hole(axis: Axis, web: Web, middle: float, side: float) -> Iterator[Path]:
    """Yield the edges of a hole in a web, and its centre line."""
    half, more = web.width / 2.0, OVERSHOOT / axis.scale
    for radius in (web.circle - web.hole, web.circle + web.hole) if web.holes else ():
        yield line(axis, _along((middle - half, middle + half), side * radius))
    if web.holes:
        yield line(axis, _along((middle - half - more, middle + half + more), side * web.circle), Layer.CENTRE)


def ring_section(
    axis: Axis, teeth: CylindricalGear, outer: float, span: tuple[float, float], *, lean: float
) -> list[Entity]:
    """Return an internal gear in section, both halves.

    Args:
        axis: Where its axis lies.
        teeth: Its teeth, with a negative number.
        outer: Outer radius of the ring [mm].
        span: From face to face along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    root, tip = MM * teeth.root_radius, MM * teeth.tip_radius
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        entities += [
            hatched(axis, _box(span, root, outer, side), lean),
            line(axis, _box(span, tip, outer, side), closed=True),
            line(axis, _along(span, side * root)),
            _pitch(axis, span, side * MM * teeth.pitch_radius),
        ]
    return entities


def seat_section(axis: Axis, seat: RingSeat, middle: float, *, lean: float) -> list[Entity]:
    """Return the splines of a ring that stands in the housing in section, to half of their height, both halves.

    Args:
        axis: Of the ring.
        seat: Of the ring.
        middle: Of the ring along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    span = (middle + MM * seat.spline[0], middle + MM * seat.spline[1])
    return list(_rings(axis, span, (MM * seat.teeth.shaft_root / 2.0, MM * seat.middle), lean))


def keeper_section(axis: Axis, seat: RingSeat, middle: float, *, lean: float) -> list[Entity]:
    """Return the ring that keeps a ring in the housing in section, both halves.

    Args:
        axis: Of the ring.
        seat: Of the ring.
        middle: Of the ring along the axis [mm].
        lean: Angle of the hatching [rad].
    """
    span = (middle + MM * seat.keeper[0], middle + MM * seat.keeper[1])
    return list(_rings(axis, span, (MM * seat.clear, MM * seat.outside), lean))


def _rings(axis: Axis, span: tuple[float, float], radii: tuple[float, float], lean: float) -> Iterator[Entity]:
    for side in (1.0, -1.0):
        corners = _box(span, radii[0], radii[1], side)
        yield from (hatched(axis, corners, lean), line(axis, corners, closed=True))


def bell_section(axis: Axis, bell: Bell, *, lean: float) -> list[Entity]:
    """Return what joins a turning ring to its shaft in section, both halves.

    Args:
        axis: Of the shaft.
        bell: As sized.
        lean: Angle of the hatching [rad].
    """
    entities: list[Entity] = []
    for side in (1.0, -1.0):
        corners = [complex(MM * place, side * MM * radius) for place, radius in bell.section]
        entities += [hatched(axis, corners, lean), line(axis, corners, closed=True)]
    return entities


def bell_anchor(bell: Bell) -> complex:
    """Return a point in the disc of a bell, along its shaft and beside it [mm].

    Args:
        bell: As sized.
    """
    (face, hub), (_, inside) = bell.section[:2]
    return MM * complex(face + 0.4 * (bell.section[-2][0] - face), 0.4 * hub + 0.6 * inside)


def bevel_corners(profile: BevelProfile, hub: Hub) -> list[complex]:
    """Return the body of a bevel gear below the roots of its teeth, as it is weighed, upper half.

    Args:
        profile: Corners of its teeth.
        hub: Its bore, and the way behind the teeth; of one piece with its shaft, without one.

    Returns:
        Root at the small end, root at the large end, heel of the back cone, back to the bore, front from the bore:
        along the axis away from the apex, from the mean point, and radius [mm].
    """
    small, large = profile.roots
    if hub.way:
        return [small, large, *hub.way]
    heel = large + BACKUP * (large - profile.large[0])
    return [small, large, heel, complex(heel.real, 0.0), complex(small.real, 0.0)]


def bevel_section(axis: Axis, profile: BevelProfile, hub: Hub, *, away: float, lean: float) -> list[Entity]:
    """Return a bevel gear in section, both halves, with its pitch cone from the apex on.

    Args:
        axis: Where its axis lies; x = 0 is the mean point.
        profile: Corners of its teeth.
        hub: Its bore.
        away: +1 where the apex lies towards the first end, −1 where it lies towards the second [-].
        lean: Angle of the hatching [rad].
    """
    entities: list[Entity] = []
    body = bevel_corners(profile, hub)
    for side in (1.0, -1.0):
        below = [complex(away * corner.real, side * corner.imag) for corner in body]
        tooth = [complex(away * corner.real, side * corner.imag)
                 for corner in (profile.roots[0], profile.small[0], profile.large[0], profile.roots[1])]  # fmt: skip
        entities += [hatched(axis, below, lean), line(axis, tooth)]
        entities.append(line(axis, below if hub.bore else [below[4], *below[:4]], closed=hub.bore > 0.0))
        more = profile.large[1] + (profile.large[1] - profile.small[1]) * 0.12
        ends = [complex(away * profile.apex, 0.0), complex(away * more.real, side * more.imag)]
        entities.append(line(axis, ends, Layer.PITCH))
    return entities


def hub_view(axis: Axis, hub: Hub) -> list[Entity]:
    """Return the bore of a hub seen along its axis, keyway on top.

    Args:
        axis: Its origin is the middle.
        hub: With a keyway.
    """
    assert hub.key is not None
    radius, half = hub.bore / 2.0, MM * hub.key.width / 2.0
    top = hub.reach / 2.0
    outline = (*keyed_rim(axis, radius, half), axis.at(-half, top), axis.at(half, top))
    reach = radius + OVERSHOOT / axis.scale
    return [
        Path(outline, Layer.OUTLINE, closed=True),
        Path((axis.at(-reach), axis.at(reach)), Layer.CENTRE),
        Path((axis.at(0.0, -reach), axis.at(0.0, top + OVERSHOOT / axis.scale)), Layer.CENTRE),
    ]


def _bottom(hub: Hub) -> float:
    """Return the diameter that is cut out on the side without keyway [mm]."""
    return hub.bore if hub.key is not None else hub.reach


def bore_edges(axis: Axis, span: tuple[float, float], hub: Hub) -> Iterator[Entity]:
    """Yield the edges of a bore that are seen behind the section.

    Args:
        axis: Where its axis lies.
        span: From face to face along the axis [mm].
        hub: The bore.
    """
    radius = hub.bore / 2.0
    for x in span if hub.bore else ():
        yield line(axis, [complex(x, -radius), complex(x, radius)])
    if hub.key is not None:
        flank = math.sqrt(radius**2 - (MM * hub.key.width / 2.0) ** 2)
        yield line(axis, _along(span, flank))


def _box(span: tuple[float, float], inner: float, outer: float, side: float) -> list[complex]:
    return [*_along(span, side * inner), *_along(span, side * outer)[::-1]]


def _along(span: tuple[float, float], radius: float) -> list[complex]:
    return [complex(x, radius) for x in span]


def hatched(axis: Axis, corners: Sequence[complex], lean: float) -> Hatch:
    """Return a face that is cut.

    Args:
        axis: Of the part.
        corners: Along the axis and beside it [mm].
        lean: Angle of the hatching against the axis [rad].
    """
    turned = (lean + cmath.phase(axis.along)) % math.pi
    return Hatch(tuple(axis.on(corner) for corner in corners), turned)


def line(axis: Axis, corners: Sequence[complex], layer: Layer = Layer.OUTLINE, *, closed: bool = False) -> Path:
    """Return a line over corners.

    Args:
        axis: Of the part.
        corners: Along the axis and beside it [mm].
        layer: Of the line.
        closed: Whether it ends where it begins.
    """
    return Path(tuple(axis.on(corner) for corner in corners), layer, closed=closed)


def _pitch(axis: Axis, span: tuple[float, float], radius: float) -> Path:
    more = 2.0 / axis.scale
    return line(axis, _along((span[0] - more, span[1] + more), radius), Layer.PITCH)
