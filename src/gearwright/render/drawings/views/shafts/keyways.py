"""Keyways on the sheet of a shaft: the removed section with width, depth and how symmetric it stands."""

from __future__ import annotations

import math
from dataclasses import replace

from gearwright.catalogue import keyway_tolerance, standard_tolerance
from gearwright.render.drawings.sheet.dimensions import extent
from gearwright.render.drawings.sheet.entities import (
    GAP,
    TEXT,
    Distance,
    Entity,
    Layer,
    Path,
    Words,
    trimmed,
    words_length,
)
from gearwright.render.drawings.sheet.tolerances import Tolerance, frame_length, tolerance_frame
from gearwright.render.drawings.views.shaft_parts import MM, Slot
from gearwright.render.drawings.views.shaft_view import Axis, key_section

SYMMETRY_GRADE = 9
"""Of the width of a keyway, of which half is how symmetric it stands; assumed: P9 has this grade."""
LEAST_WIDTH = 10e-3
"""Up to which widths have the tolerance of this one, as the grades begin above 6 mm [m]."""
AIR = 3.0
"""Between what stands in line with the width [mm of paper]."""


def keyway_section(slot: Slot, bore: float, letter: str, scale: float, *, datums: str) -> list[Entity]:
    """Return the section of a shaft through a keyway with its dimensions.

    Args:
        slot: The keyway.
        bore: Of the shaft [mm].
        letter: Of the cutting plane.
        scale: Of the view [-].
        datums: Axis to which it is symmetric; empty where the sheet has none.
    """
    axis = Axis(0j, 1 + 0j, scale)
    entities = key_section(axis, slot, bore)
    radius, half = slot.diameter / 2.0, MM * slot.section.width / 2.0
    floor = radius - MM * slot.section.shaft_depth
    rim = math.sqrt(radius**2 - half**2)
    above = 1j * (scale * radius + 7.0)
    width = Distance(axis.at(-half, rim), axis.at(half, rim), above, 0.0, scale, suffix=" P9")
    entities.append(width)
    beyond = max(extent([width])[2], scale * half) + AIR
    if datums:
        # In line with the dimension of the width: its middle plane is what stands symmetric.
        zone = MM * standard_tolerance(max(slot.section.width, LEAST_WIDTH), SYMMETRY_GRADE) / 2.0
        tolerance, start = Tolerance("symmetry", zone, datums), above + beyond
        entities += [Path((above + scale * half, start), Layer.SYMBOL), *tolerance_frame(start, tolerance)]
        beyond += frame_length(tolerance) + AIR
    low, high = axis.at(0.0, -radius), axis.at(half, floor)
    deviation = f" 0/−{trimmed(MM * keyway_tolerance(slot.section), 1)}"
    depth = Distance(low, high, complex(scale * radius + 9.0), math.pi / 2.0, scale, suffix=deviation)
    if words_length(depth.text, TEXT) > scale * depth.measured:  # its text stands above its line, beside all of this
        depth = replace(depth, line=complex(max(scale * radius + 9.0, beyond + TEXT + GAP)))
    entities.append(depth)
    top = extent(entities)[3]
    entities.append(Words(1j * (top + 3.0), f"{letter}–{letter}", TEXT, "middle"))
    entities.append(Words(-1j * (scale * radius + 9.0), slot.designation, TEXT, "middle"))
    return entities
