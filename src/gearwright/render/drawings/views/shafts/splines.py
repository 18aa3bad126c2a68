"""Splines on the sheet of a shaft: the tables of their data, and whether a hob has room to run out behind them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gearwright.render.drawings.sheet.entities import millimetres
from gearwright.render.drawings.sheet.tables import Grid
from gearwright.render.drawings.views.shaft_parts import MM, ShaftBody, Toothing

HOB = 60.0
"""Diameter of a hob for splines; assumed [mm]."""


def spline_grids(body: ShaftBody) -> Iterator[Grid]:
    """Yield the data of every spline.

    Args:
        body: The shaft.
    """
    for toothing in body.splines:
        teeth = toothing.teeth
        rows = (
            ("Number of teeth", "z", f"{teeth.teeth}"),
            ("Module", "m", millimetres(MM * teeth.module)),
            ("Pressure angle", "α", "30°"),
            ("Profile shift coefficient", "x", f"{teeth.profile_shift:.3g}"),
            ("Reference diameter", "d_{B}", millimetres(MM * teeth.reference_diameter)),
            ("Pitch diameter", "d", millimetres(MM * teeth.pitch_diameter)),
            ("Tip diameter", "d_{a1}", millimetres(MM * teeth.shaft_tip)),
            ("Root diameter, hobbed", "d_{f1}", millimetres(MM * teeth.shaft_root)),
        )
        yield Grid(f"Spline: {toothing.designation}", rows)


def run_out_notes(body: ShaftBody) -> Iterator[str]:
    """Yield of every spline that a hob cannot leave before the next shoulder that it must be shaped.

    Args:
        body: The shaft.
    """
    for toothing in body.splines:
        room, needed = hob_room(body, toothing), hob_run_out(toothing)
        if room < needed:
            yield (
                f"{toothing.designation}: shaped, as {millimetres(room)} mm lie before the next shoulder; a hob of"
                f" Ø{HOB:g} (assumed) runs out over {needed:.1f} mm."
            )


def hob_run_out(toothing: Toothing) -> float:
    """Return over which length a hob leaves teeth that it cuts to their full depth [mm]: √(h (D − h)).

    Args:
        toothing: Splines of a shaft.
    """
    depth = MM * (toothing.teeth.shaft_tip - toothing.teeth.shaft_root) / 2.0
    return math.sqrt(depth * (HOB - depth))


def hob_room(body: ShaftBody, toothing: Toothing) -> float:
    """Return how far it is from either end of a spline to what is thicker than it, the less of both [mm].

    Args:
        body: The shaft.
        toothing: On it.
    """
    tip = MM * toothing.teeth.reference_diameter
    thick = [piece for piece in body.pieces if piece.diameter > tip + 1e-6]
    behind = (piece.start - toothing.end for piece in thick if piece.start > toothing.end - 1e-6)
    before = (toothing.start - piece.end for piece in thick if piece.end < toothing.start + 1e-6)
    return min((*behind, *before), default=math.inf)
