"""The axes of a train seen along them, where no single plane holds them: pitch circles at their true places."""

from __future__ import annotations

from gearwright.render.drawings.sheet.entities import SMALL, Arc, Entity, Layer, Path, Words
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.render.drawings.views.shaft_view import OVERSHOOT
from gearwright.sizing import Sizing


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
        entities += [Words(middle + complex(1.5, 1.5 + 1.6 * SMALL * k), name, SMALL) for k, name in enumerate(names)]
    return entities
