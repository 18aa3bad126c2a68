"""A train seen along its first shaft, where no single plane holds all axes: gears at their true places."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.render.drawings.sheet.crossing import Segment, clear_of, segments
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words, words_length
from gearwright.render.drawings.views.laid.beside import Lying
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT
from gearwright.render.style.labels import overlap
from gearwright.shape.solids import Leg, spans_in, without
from gearwright.sizing import Sizing

STEP = 2.0
"""Between places of a name that are tried [mm]."""
TRIES = 30
"""Of them, each way [-]."""
_ALONG = 1.0 - 1e-9
"""Share of an axis along the view from which on it lies along it [-]."""


class Outside(NamedTuple):
    """A housing as it is seen along the first shaft from its second end, y in space to the right, z upwards."""

    lines: tuple[Path, ...] = ()
    """Its edges [mm]."""
    covers: tuple[Floats, ...] = ()
    """Convex loops that fill what it covers [m], shape (n, 2) each."""


def end_view(sizing: Sizing, scale: float, outside: Outside, *, turned: bool) -> list[Entity]:
    """Return a gearbox seen along the first shaft, from its second end; planets are left out.

    Gears whose axes lie along the view are their pitch circles; of those across it the outlines of the bodies are seen,
    dashed where the housing covers them.

    Args:
        sizing: What was sized; all axes along the first shaft or square to it.
        scale: mm of paper per mm [-].
        outside: The housing; empty where none is drawn.
        turned: Whether the view is turned by half a turn.
    """
    entities: list[Entity] = [
        replace(line, points=tuple(scale * point for point in line.points)) for line in outside.lines
    ]
    frames, axes = sizing.arrangement.frames, dict[complex, list[str]]()
    along = [name for name in frames if abs(frames[name].along[0]) > _ALONG]
    for name in along:
        y, z = (round(scale * MM * coordinate, 6) for coordinate in frames[name].origin[1:])
        axes.setdefault(complex(y, z), []).append(name)
    for middle, names in axes.items():
        gears = [gear for gear in sizing.gears if set(names) & set(gear.shafts)]
        radii = {scale * MM * gear.pitch_diameter / 2.0 for gear in gears}
        entities += [Arc(middle, radius, Layer.PITCH) for radius in sorted(radii)]
        reach = max(radii, default=0.0) + OVERSHOOT
        entities += [Path((middle - way, middle + way), Layer.CENTRE) for way in (reach, 1j * reach)]
    names_of = [(middle, name) for middle, shafts in axes.items() for name in shafts]
    for name in frames:
        if name not in along:
            entities += _across(sizing, name, scale, outside.covers)
            names_of.append((_seen(frames[name].origin, scale), name))
    if turned:
        entities, names_of = _upside_down(entities), [(-middle, name) for middle, name in names_of]
    return [*entities, *names_beside(names_of, list(segments(entities)))]


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
        nearest = next(apart)
        found.append(next((words for words in chain([nearest], apart) if clear_of([words], lines)), nearest))
    return found
