"""A train seen along its first shaft, where no single plane holds all axes: gears at their true places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from gearwright.render.drawings.sheet.crossing import Segment, clear_of, segments
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words, words_length
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT
from gearwright.render.style.labels import overlap
from gearwright.sizing import Sizing

STEP = 2.0
"""Between places of a name that are tried [mm]."""
TRIES = 30
"""Of them, each way [-]."""
_ALONG = 1.0 - 1e-9
"""Share of an axis along the view from which on it lies along it [-]."""


def end_view(sizing: Sizing, scale: float) -> list[Entity]:
    """Return all gears seen along the first shaft, from its second end; planets are left out.

    Gears whose axes lie along the view are their pitch circles; of those across it the outlines of the bodies are seen.

    Args:
        sizing: What was sized; all axes along the first shaft or square to it.
        scale: mm of paper per mm [-].
    """
    entities: list[Entity] = []
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
            entities += _across(sizing, name, scale)
            names_of.append((_seen(frames[name].origin, scale), name))
    down = sum(frames[name].along[2] for name in frames if name not in along) < 0.0
    if down:  # shafts across the view are drawn upright, as the section has them
        entities, names_of = _upside_down(entities), [(-middle, name) for middle, name in names_of]
    return [*entities, *names_beside(names_of, list(segments(entities)))]


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


def _across(sizing: Sizing, shaft: str, scale: float) -> Iterator[Entity]:
    """Yield the outlines of the bodies on a shaft that lies across the view, and its axis."""
    for body in sizing.arrangement.bodies:
        if body.shaft != shaft or max(station.radius for station in body.stations) <= 0.0:
            continue
        way = complex(body.direction.y, body.direction.z)
        origin = _seen(body.origin, scale)
        upper = [(scale * MM * station.place, scale * MM * station.radius) for station in body.stations]
        corners = [*upper, *((place, -radius) for place, radius in reversed(upper))]
        yield Path(tuple(origin + way * complex(x, r) for x, r in corners), Layer.THIN, closed=True)
    frame, plan = sizing.arrangement.frames[shaft], sizing.arrangement.plans[shaft]
    way = complex(*frame.along[1:])
    start = _seen(frame.origin, scale)
    end = start + way * scale * MM * plan.length
    yield Path((start - OVERSHOOT * way, end + OVERSHOOT * way), Layer.CENTRE)


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
