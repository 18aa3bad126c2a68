"""The axes of a train seen along them, where no single plane holds them: pitch circles at their true places."""

from __future__ import annotations

from collections.abc import Sequence

from gearwright.render.drawings.sheet.crossing import Segment, clear_of, segments
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words, words_length
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT
from gearwright.render.style.labels import overlap
from gearwright.sizing import Sizing

STEP = 2.0
"""Between places of a name that are tried [mm]."""
TRIES = 12
"""Of them, each way [-]."""


def end_view(sizing: Sizing, scale: float) -> list[Entity]:
    """Return the pitch circles of all gears about their axes, seen from the second ends; planets are left out.

    Args:
        sizing: What was sized; all axes parallel.
        scale: mm of paper per mm [-].
    """
    entities: list[Entity] = []
    axes: dict[complex, list[str]] = {}
    for shaft in sizing.shafts:
        y, z = (round(scale * MM * coordinate, 6) for coordinate in shaft.axis)
        axes.setdefault(complex(y, z), []).append(shaft.name)
    for middle, names in axes.items():
        gears = [gear for gear in sizing.gears if set(names) & set(gear.shafts)]
        radii = {scale * MM * gear.pitch_diameter / 2.0 for gear in gears}
        entities += [Arc(middle, radius, Layer.PITCH) for radius in sorted(radii)]
        reach = max(radii, default=0.0) + OVERSHOOT
        entities += [Path((middle - way, middle + way), Layer.CENTRE) for way in (reach, 1j * reach)]
    names_of = [(middle, name) for middle, shafts in axes.items() for name in shafts]
    return [*entities, *_names(names_of, list(segments(entities)))]


def _names(named: Sequence[tuple[complex, str]], lines: Sequence[Segment]) -> list[Words]:
    """Return the names of shafts beside their axes, each at the nearest place that no line and no name crosses."""
    found: list[Words] = []
    for middle, name in named:
        wide = words_length(name, SMALL)
        ways = [complex(1.5 + STEP * k, side * (1.5 + STEP * j) - (side < 0.0) * SMALL)
                for k in range(TRIES) for j in range(TRIES) for side in (1.0, -1.0)]  # fmt: skip
        ways += [complex(-way.real - wide, way.imag) for way in ways]
        wanted = [Words(middle + way, name, SMALL) for way in sorted(ways, key=abs)]
        apart = [words for words in wanted if not any(overlap(extent([words]), extent([other])) for other in found)]
        found.append(next((words for words in apart if clear_of([words], lines)), apart[0]))
    return found
