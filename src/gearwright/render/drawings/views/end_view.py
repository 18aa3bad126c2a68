"""A gearbox seen along its first shaft, where one section cannot show how all stands: gears at their true places."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.drawings.sheet.crossing import Segment, clear_of, segments
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import SMALL, Arc, Distance, Entity, Layer, Path, Words, words_length
from gearwright.render.drawings.views.laid.beside import Lying
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT
from gearwright.render.style.labels import overlap
from gearwright.shape.solids import Leg, spans_in, without
from gearwright.shape.stands import stands_of
from gearwright.sizing import Sizing

STEP = 2.0
"""Between places of a name that are tried [mm]."""
TRIES = 30
"""Of them, each way [-]."""
BELOW = 8.0
"""From the view to the distance of its planets, and from each to the next [mm]."""
_ALONG = 1.0 - 1e-9
"""Share of an axis along the view from which on it lies along it [-]."""


class Outside(NamedTuple):
    """A housing as it is seen along the first shaft from its second end, y in space to the right, z upwards."""

    lines: tuple[Path, ...] = ()
    """Its edges [mm]."""
    covers: tuple[Floats, ...] = ()
    """Convex loops that fill what it covers [m], shape (n, 2) each."""
    way: tuple[complex, ...] = ()
    """Corners of an unfolded section, from end to end [mm]."""


def end_view(sizing: Sizing, scale: float, outside: Outside, *, turned: bool) -> list[Entity]:
    """Return a gearbox seen along the first shaft, from its second end.

    Gears whose axes lie along the view, planets too, are their pitch circles; of those across it the outlines of the
    bodies are seen, dashed where the housing covers them.

    Args:
        sizing: What was sized; all axes along the first shaft or square to it.
        scale: mm of paper per mm [-].
        outside: The housing; empty where none is drawn.
        turned: Whether the view is turned by half a turn.
    """
    entities: list[Entity] = [
        replace(line, points=tuple(scale * point for point in line.points)) for line in outside.lines
    ]
    if outside.way:
        entities.append(Path(tuple(scale * point for point in outside.way), Layer.CENTRE))
    frames, axes = sizing.arrangement.frames, dict[complex, list[str]]()
    along = [name for name in frames if abs(frames[name].along[0]) > _ALONG]
    for name in along:
        y, z = (round(scale * MM * coordinate, 6) for coordinate in frames[name].origin[1:])
        axes.setdefault(complex(y, z), []).append(name)
    circles = _pitch_circles(sizing, scale)
    for middle in dict.fromkeys((*axes, *circles)):
        radii = circles.get(middle, set())
        entities += [Arc(middle, radius, Layer.PITCH) for radius in sorted(radii)]
        reach = max(radii, default=0.0) + OVERSHOOT if middle in axes else OVERSHOOT
        entities += [Path((middle - way, middle + way), Layer.CENTRE) for way in (reach, 1j * reach)]
    several = len(axes) > 1 or len(along) < len(frames)
    names_of = [(middle, ", ".join(shafts)) for middle, shafts in axes.items() if several]
    for name in frames:
        if name not in along:
            entities += _across(sizing, name, scale, outside.covers)
            names_of.append((_seen(frames[name].origin, scale), name))
    if turned:
        entities, names_of = _upside_down(entities), [(-middle, name) for middle, name in names_of]
    entities += names_beside(names_of, list(segments(entities)))
    return [*entities, *_planet_distances(sizing, scale, extent(entities)[1], -1.0 if turned else 1.0)]


def _planet_distances(sizing: Sizing, scale: float, low: float, sense: float) -> Iterator[Distance]:
    """Yield the distance of planets from the axis of their set, below the view, of sets with one beside their axis."""
    stands = stands_of(sizing)
    for row, carrier in enumerate(sizing.carriers, start=1):
        middle = next(stand.axes for stand in stands if stand.gear.stage == carrier.stage and not stand.carrier)
        if abs(float(middle.along[0])) <= _ALONG:
            continue
        foot = sense * _seen(middle.origin.tolist(), scale)
        planets = [sense * _seen(stand.axes.origin.tolist(), scale) for stand in stands
                   if stand.carrier and stand.gear.stage == carrier.stage]  # fmt: skip
        level = [place for place in planets if abs(place.imag - foot.imag) < 1e-6]
        if level:
            yield Distance(foot, level[0], complex(0.0, low - BELOW * row), 0.0, scale)


def _pitch_circles(sizing: Sizing, scale: float) -> dict[complex, set[float]]:
    """Return axis along the view -> radii of the pitch circles about it, also of planets [mm of paper]."""
    found: dict[complex, set[float]] = {}
    for stand in stands_of(sizing):
        if abs(float(stand.axes.along[0])) > _ALONG:
            y, z = (round(scale * MM * float(coordinate), 6) for coordinate in stand.axes.origin[1:])
            found.setdefault(complex(y, z), set()).add(scale * MM * stand.gear.pitch_diameter / 2.0)
    return found


def is_turned(sizing: Sizing, shafts: Mapping[str, Lying]) -> bool:
    """Tell whether the section has shafts across the first one upside down, as the view along it has to, then.

    Args:
        sizing: What was sized.
        shafts: As the section has them.
    """
    frames = sizing.arrangement.frames
    return sum(frames[name].along.z * lying.along.imag for name, lying in shafts.items()) < 0.0


def _upside_down(entities: Sequence[Entity]) -> list[Entity]:
    """Return circles and lines turned by half a turn."""
    turned: list[Entity] = []
    for mark in entities:
        if isinstance(mark, Arc):
            turned.append(replace(mark, centre=-mark.centre))
        elif isinstance(mark, Path):
            turned.append(replace(mark, points=tuple(-point for point in mark.points)))
    return turned


def is_square(sizing: Sizing) -> bool:
    """Tell whether every axis lies along the first shaft or square to it.

    Args:
        sizing: What was sized.
    """
    ways = [abs(frame.along[0]) for frame in sizing.arrangement.frames.values()]
    return all(way > _ALONG or way < 1.0 - _ALONG for way in ways)


def _across(sizing: Sizing, shaft: str, scale: float, covers: Sequence[Floats]) -> Iterator[Entity]:
    """Yield the outlines of the bodies on a shaft that lies across the view, and its axis."""
    for body in sizing.arrangement.bodies:
        if body.shaft != shaft or max(station.radius for station in body.stations) <= 0.0:
            continue
        way = complex(body.direction.y, body.direction.z)
        origin = _seen(body.origin, scale)
        upper = [(scale * MM * station.place, scale * MM * station.radius) for station in body.stations]
        corners = [*upper, *((place, -radius) for place, radius in reversed(upper))]
        outline = tuple(origin + way * complex(x, r) for x, r in corners)
        if not covers:
            yield Path(outline, Layer.THIN, closed=True)
        for start, end in pairwise([*outline, outline[0]] if covers else ()):
            yield from _parted(start, end, [scale * MM * loop for loop in covers])
    frame, plan = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft]
    way = complex(*frame.along[1:])
    start = _seen(frame.origin, scale)
    end = start + way * scale * MM * plan.length
    yield Path((start - OVERSHOOT * way, end + OVERSHOOT * way), Layer.CENTRE)


def _parted(start: complex, end: complex, covers: Sequence[Floats]) -> Iterator[Path]:
    """Yield a line, dashed where loops cover it [mm of paper]."""
    length = abs(end - start)
    if length < 1e-6:
        return
    way = (end - start) / length
    leg = Leg(0.0, length, np.array([start.real, start.imag]), np.array([way.real, way.imag]))
    free = [(0.0, length)]
    for loop in covers:
        free = without(free, spans_in(loop, [leg]))
    for spans, layer in ((free, Layer.OUTLINE), (without([(0.0, length)], free), Layer.HIDDEN)):
        yield from (Path((start + low * way, start + high * way), layer) for low, high in spans)


def _seen(point: Sequence[float], scale: float) -> complex:
    """Return a point of space as the view has it [mm of paper]."""
    return scale * MM * complex(point[1], point[2])


def names_beside(named: Sequence[tuple[complex, str]], lines: Sequence[Segment]) -> list[Words]:
    """Return the names of shafts beside their axes, each at the nearest place that no line and no name crosses.

    A name for which there is no such place is left out: the table of axes has it.

    Args:
        named: Axes [mm of paper] with their names.
        lines: Of the view.
    """
    found: list[Words] = []
    for middle, name in named:
        wide = words_length(name, SMALL)
        ways = [complex(1.5 + STEP * k, side * (1.5 + STEP * j) - (side < 0.0) * SMALL)
                for k in range(TRIES) for j in range(TRIES) for side in (1.0, -1.0)]  # fmt: skip
        ways += [complex(-way.real - wide, way.imag) for way in ways]
        wanted = [Words(middle + way, name, SMALL) for way in sorted(ways, key=abs)]
        boxes = [extent([other]) for other in found]
        apart = (words for words in wanted if not any(overlap(extent([words]), box) for box in boxes))
        found += islice((words for words in apart if clear_of([_wider(words)], lines)), 1)
    return found


def _wider(words: Words) -> Words:
    """Return a text with air at both ends."""
    return replace(words, at=words.at - words_length("i", SMALL), text=f"i{words.text}i")
