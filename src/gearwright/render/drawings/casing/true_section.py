"""A gearbox cut by one plane along its first shaft, beside an unfolded section that cannot hold the housing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gearwright.render.drawings.casing.casing_parts import casing_items
from gearwright.render.drawings.casing.casing_section import casing_entities
from gearwright.render.drawings.casing.plane_section import Casing, casing_of, holes_behind
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import Distance, Entity, Path, Words
from gearwright.render.drawings.sheet.numbers import balloons
from gearwright.render.drawings.sheet.symbols import cutting_plane
from gearwright.render.drawings.views.arrangement_parts import Item, shaft_parts
from gearwright.render.drawings.views.laid.beside import TRUE, Lying
from gearwright.render.drawings.views.positions import Positions
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape import Scene
from gearwright.sizing import Sizing

LETTER = "B"
"""Of the plane."""
LETTERS, BELOW, BEYOND = 5.0, 8.0, 3.0
"""Height of the section's name, from the parts to a length over all, from the outline to a cutting plane's end [mm]."""


class TrueSection(NamedTuple):
    """What one plane cuts."""

    casing: Casing
    plane: Positions
    """Shafts whose axes lie in it."""


def true_section(sizing: Sizing, scene: Scene, unfolded: Positions) -> TrueSection | None:
    """Return the section by the plane along the first shaft that the housing's own sheet has; None where none cuts it.

    Args:
        sizing: What was sized.
        scene: Its solids.
        unfolded: The plane of the arrangement, with the places of parts on shafts.
    """
    casing = casing_of(sizing, scene)
    if casing is None:
        return None
    out, shafts = np.array([-casing.up[1], casing.up[0]]), {}
    for name, lying in unfolded.shafts.items():
        frame = sizing.arrangement.frames[name]
        off = np.array(frame.origin[1:]) - casing.foot
        if MM * max(abs(float(off @ out)), abs(float(np.array(frame.along[1:]) @ out))) < TRUE:
            origin = MM * complex(frame.origin.x, float(off @ casing.up))
            along = complex(frame.along.x, float(np.array(frame.along[1:]) @ casing.up))
            shafts[name] = Lying(origin, along, lying.start, lying.end)
    return TrueSection(casing, Positions(shafts, unfolded.places))


def true_entities(sizing: Sizing, section: TrueSection, scale: float, first: int) -> list[Entity]:
    """Return the section with its name, its length over all, and numbers of what the arrangement shows here alone.

    Args:
        sizing: What was sized.
        section: What is cut.
        scale: mm of paper per mm [-].
        first: Number of its first item.
    """
    casing, entities = section.casing, list[Entity]()
    for name in section.plane.shafts:
        entities += shaft_parts(sizing, section.plane, name, scale)[0]
    entities += [*casing_entities(casing.section, scale), *holes_behind(casing, scale)]
    box = extent(entities)
    items = true_items(sizing, section, scale)
    entities += balloons([item.anchor for item in items], box, [], first)
    low = complex(0.0, extent(entities)[1] - BELOW)
    entities.append(Distance(complex(box[0], box[1]), complex(box[2], box[1]), low, 0.0, scale))
    name_at = complex((box[0] + box[2]) / 2.0, extent(entities)[3] + BELOW)
    return [*entities, Words(name_at, f"{LETTER}-{LETTER}", LETTERS, "middle")]


def true_items(sizing: Sizing, section: TrueSection, scale: float) -> list[Item]:
    """Return what the list of parts has of the section alone: the housing and its screws.

    Args:
        sizing: What was sized.
        section: What is cut.
        scale: mm of paper per mm [-].
    """
    return list(casing_items(sizing, section.casing.section, scale))


def cutting_line(section: TrueSection, outside: Sequence[Path], scale: float, *, turned: bool) -> list[Entity]:
    """Return both ends of the cutting plane in the view along the first shaft from its second end.

    Args:
        section: What is cut.
        outside: The housing in that view [mm].
        scale: mm of paper per mm [-].
        turned: Whether the view is turned by half a turn.
    """
    up, foot = complex(*section.casing.up.tolist()), MM * complex(*section.casing.foot.tolist())
    reach = [((point - foot) * up.conjugate()).real for line in outside for point in line.points]
    middle, half = foot + up * (min(reach) + max(reach)) / 2.0, (max(reach) - min(reach)) / 2.0
    sense = -1.0 if turned else 1.0
    return cutting_plane(sense * scale * middle, scale * half + BEYOND, LETTER, looking=-1j * sense * up)
