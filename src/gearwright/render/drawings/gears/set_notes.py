"""What a general arrangement says of its sets: how rings and carriers are held, and what it does not draw."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.sizing import Sizing
from gearwright.sizing.casing import ring_seats
from gearwright.sizing.places import bells
from gearwright.spec import GROUND


def set_notes(sizing: Sizing, *, cut: bool) -> Iterator[str]:
    """Yield what has to be said of planetary and compound sets.

    Args:
        sizing: What was sized.
        cut: Whether the section shows the housing.
    """
    if any(gear.rim and GROUND in gear.shafts for gear in sizing.gears):
        where = "in lands of the housing" if cut else "in the housing"
        if list(ring_seats(sizing)):
            splines = "splines (as DIN 5480-1, cut at half of their height)"
            yield f"Rings that stand have {splines} {where}; keepers by screws."
        else:
            yield "What holds rings that stand is not sized, and not drawn."
    if names := [carrier.stage for carrier in sizing.carriers if carrier.shaft == GROUND]:
        yield f"What holds the standing carrier of {', '.join(names)} in the housing is not sized, and not drawn."
    if list(bells(sizing)):
        yield "Bells of rings: thickness by torque; what joins them to ring and shaft is not sized, and not drawn."
    if names := [name for name in sizing.design.sets if name not in sizing.design.planetaries]:
        yield f"Planets and carrier of {', '.join(names)} are not drawn in this section."
