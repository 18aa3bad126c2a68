"""A gear seen along its axis from its first face, where its bore or its web is no body of revolution (ISO 2203)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.render.drawings.sheet.entities import TEXT, Arc, Distance, Entity, Layer, Path, Words, millimetres
from gearwright.render.drawings.views.gear_parts import Hub, Web
from gearwright.render.drawings.views.gear_view import hub_view
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT, Axis

ASIDE = 9.0
"""From a part to its nearest dimension line [mm]."""
MARK, APART, BEYOND = 4.0, 1.5, 1.0
"""Of the two strokes that mean that the other half is alike: length, distance and place beyond the outline [mm]."""
KNEE = 7.0
"""Of a leader beyond the gear [mm]."""


class Circles(NamedTuple):
    """What is seen of a gear's body, as radii [mm]."""

    outlines: tuple[float, ...]
    """Tips, edges of the rim and of the hub."""
    pitch: float
    """Of the pitch circle."""
    names_spline: bool = False
    """Whether the designation of a spline stands here, as the section has no room for it."""


def needs_end(hub: Hub) -> bool:
    """Tell whether a gear is no body of revolution.

    Args:
        hub: Its bore and web.
    """
    return hub.key is not None or hub.teeth is not None or (hub.web is not None and hub.web.holes > 0)


def end_of_gear(hub: Hub, circles: Circles, axis: Axis) -> list[Entity]:
    """Return a gear seen along its axis: whole with a keyway, else its right half.

    Args:
        hub: Its bore and web.
        circles: What is seen of its body.
        axis: Its origin is the middle.
    """
    whole, tip = hub.key is not None, max(circles.outlines)
    half = (0.0, 2.0 * math.pi) if whole else (-math.pi / 2.0, math.pi / 2.0)
    seen = [(radius, Layer.OUTLINE) for radius in sorted(set(circles.outlines))]
    seen.append((circles.pitch, Layer.PITCH))
    if hub.key is None and hub.bore:
        seen.append((hub.bore / 2.0, Layer.OUTLINE))
    if hub.teeth is not None:
        seen.append((MM * hub.teeth.reference_diameter / 2.0, Layer.THIN))
    entities: list[Entity] = [Arc(axis.at(0.0), axis.scale * radius, layer, *half) for radius, layer in seen]
    reach = axis.scale * tip + OVERSHOOT
    entities.append(Path((axis.origin - 1j * reach, axis.origin + 1j * reach), Layer.CENTRE))
    entities.append(Path((axis.origin - (reach if whole else OVERSHOOT), axis.origin + reach), Layer.CENTRE))
    if hub.key is not None:
        entities += [*hub_view(axis, hub)[:1], *_keyway(hub, axis, tip)]
    else:
        entities += _halved(axis, axis.scale * tip + OVERSHOOT + BEYOND)
    if hub.teeth is not None and circles.names_spline:
        entities += _spline(hub, axis, tip)
    if hub.web is not None and hub.web.holes:
        entities += _holes(hub.web, axis, tip, half)
    return entities


def _halved(axis: Axis, reach: float) -> Iterator[Path]:
    """Yield the strokes at both ends of a line of symmetry (ISO 128-3)."""
    for side in (1.0, -1.0):
        for k in (0.0, 1.0):
            foot = axis.origin + 1j * side * (reach + APART * k)
            yield Path((foot - MARK / 2.0, foot + MARK / 2.0), Layer.THIN)


def _keyway(hub: Hub, axis: Axis, tip: float) -> Iterator[Entity]:
    """Yield width and depth of a keyway, and what key it is for, outside of the gear."""
    assert hub.key is not None
    radius, half, top = hub.bore / 2.0, MM * hub.key.width / 2.0, hub.reach / 2.0
    above = axis.at(0.0, tip) + 1j * ASIDE
    yield Distance(axis.at(-half, top), axis.at(half, top), above, 0.0, axis.scale, suffix=" P9")
    side = axis.at(tip) + ASIDE
    yield Distance(axis.at(0.0, -radius), axis.at(half, top), side, math.pi / 2.0, axis.scale)
    yield Words(axis.at(0.0, -tip) - 1j * (ASIDE + TEXT), hub.designation, TEXT, "middle")


def _spline(hub: Hub, axis: Axis, tip: float) -> Iterator[Entity]:
    """Yield the leader from a splined bore to below the gear, with the spline's designation."""
    target = axis.on(cmath.rect(hub.bore / 2.0, -math.pi / 4.0))
    level = axis.origin.imag - axis.scale * tip - KNEE
    knee = complex(target.real + (target.imag - level) / 2.0, level)
    words = Words(knee + 2.0 + 1.0j, hub.designation, TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + words.length), Layer.DIMENSION)
    yield words


def _holes(web: Web, axis: Axis, tip: float, half: tuple[float, float]) -> Iterator[Entity]:
    """Yield holes on their circle, the first on top, and what is said of them."""
    whole = half[0] == 0.0
    radius = axis.scale * web.hole
    yield Arc(axis.at(0.0), axis.scale * web.circle, Layer.CENTRE, *half)
    places = [cmath.rect(web.circle, math.pi / 2.0 - 2.0 * math.pi * k / web.holes) for k in range(web.holes)]
    for place in places:
        if whole or place.real > web.hole:
            yield Arc(axis.on(place), radius, Layer.OUTLINE)
        elif place.real > -web.hole:
            turn = math.acos(max(min(-place.real / web.hole, 1.0), -1.0))
            yield Arc(axis.on(place), radius, Layer.OUTLINE, -turn, turn)
    yield from _told(web, axis, tip, places)


def _told(web: Web, axis: Axis, tip: float, places: Sequence[complex]) -> Iterator[Entity]:
    """Yield the leader from a hole on the right, to beyond the gear."""
    place = max(
        places, key=lambda at: (round(at.imag, 6), round(at.real, 6)) if at.real > web.hole else (-math.inf, 0.0)
    )
    target = axis.on(place) + cmath.rect(axis.scale * web.hole, math.pi / 4.0)
    level = axis.origin.imag + axis.scale * tip + KNEE
    knee = complex(target.real + (level - target.imag), level)
    across, circle = (millimetres(2.0 * size) for size in (web.hole, web.circle))
    words = Words(knee + 2.0 + 1.0j, f"{web.holes} × Ø{across} on Ø{circle}", TEXT, "left", layer=Layer.DIMENSION)
    yield Path((target, knee, knee + 4.0 + words.length), Layer.DIMENSION)
    yield words
