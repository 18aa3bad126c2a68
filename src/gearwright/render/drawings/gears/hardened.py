"""Where a gear is hardened: a line beside its teeth (ISO 15787), and the table of what is asked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from gearwright.parts.iso6336 import Treatment
from gearwright.render.drawings.sheet.crossing import clear_of, segments, texts
from gearwright.render.drawings.sheet.entities import Entity
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.views.face_view import face_teeth, is_face_wheel
from gearwright.render.drawings.views.shaft_parts import MM, bevel_profile
from gearwright.render.drawings.views.shaft_view import Axis
from gearwright.render.drawings.views.shafts.hardness import case_words, hard_line
from gearwright.render.drawings.views.tooth_data import CASE
from gearwright.shape.teeth import cylindrical_gear, halves_of, is_internal, kind_of, making_of
from gearwright.sizing import GearSizing, Sizing

CASE_HARDENED, NITRIDED = ("case-hardened", "nitrided")


class Hard(NamedTuple):
    """What is asked of the teeth of a gear."""

    treatment: str
    """``case-hardened`` or ``nitrided``."""
    hardness: float
    """At least [HV]."""


def hard_teeth(sizing: Sizing, gear: GearSizing) -> Hard | None:
    """Return what is asked of the teeth of a gear: as its rating has them, else its material; None of soft ones.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    steel = making_of(sizing, gear.stage).iso_steel
    if steel is not None:
        known = {Treatment.CASE_HARDENED: CASE_HARDENED, Treatment.NITRIDED: NITRIDED}
        return Hard(known[steel.treatment], steel.hardness) if steel.treatment in known else None
    material = sizing.design.gear_material(gear.stage)
    if material.steel not in (CASE_HARDENED, NITRIDED) or not material.hardness:
        return None
    return Hard(material.steel, material.hardness)


def hard_grid(sizing: Sizing, gear: GearSizing) -> Iterator[Grid]:
    """Yield the table of hardened surfaces; none where none is.

    Args:
        sizing: What was sized.
        gear: One of its gears.
    """
    hard = hard_teeth(sizing, gear)
    if hard is None:
        return
    if hard.treatment == NITRIDED:
        rows = [
            ("1", "teeth", f"at least {hard.hardness:.0f} HV, NHD not sized"),
            ("", "all else", "may be nitrided, too (assumed)"),
        ]
        yield Grid("Nitrided (ISO 15787)", tuple(rows))
        return
    low, high = (MM * share * gear.module for share in CASE)
    rows = [("1", "teeth", case_words(hard.hardness, (low, high)))]
    rows.append(("", "all else", "soft: kept from carburizing (assumed)"))
    yield Grid("Case-hardened and tempered (ISO 15787)", tuple(rows))


def hard_lines(sizing: Sizing, gear: GearSizing, axis: Axis, view: Sequence[Entity]) -> Iterator[Entity]:
    """Yield the line beside the teeth of a gear in section, above its axis, or below it where letters are in its way.

    Args:
        sizing: What was sized.
        gear: One of its gears.
        axis: Of the section.
        view: What is drawn of the gear.
    """
    if hard_teeth(sizing, gear) is None:
        return
    lines, ends = list(segments(view)), _ends(sizing, gear)
    for side in (1.0, -1.0):
        first, last = (axis.on(complex(end.real, side * end.imag)) for end in ends)
        away = side * 1j * (last - first) / abs(last - first)
        found = list(hard_line((first, last), away, 1))
        if clear_of(texts(found), lines) and clear_of(texts(view), list(segments(found))):
            yield from found
            return


def _ends(sizing: Sizing, gear: GearSizing) -> tuple[complex, complex]:
    """Return both ends of the tips of a gear's teeth, metal to the right of the way from one to the other [mm]."""
    if kind_of(sizing, gear.stage) == "bevel":
        profile = bevel_profile(sizing, gear)
        return profile.small[0], profile.large[0]
    if is_face_wheel(sizing, gear):
        teeth = face_teeth(sizing, gear)
        return complex(-teeth.tip, teeth.reach[0]), complex(-teeth.tip, teeth.reach[1])
    tip, wide = MM * cylindrical_gear(sizing, gear).tip_radius, MM * gear.face_width * halves_of(gear)
    return (complex(wide, tip), 1j * tip) if is_internal(sizing, gear) else (1j * tip, complex(wide, tip))
