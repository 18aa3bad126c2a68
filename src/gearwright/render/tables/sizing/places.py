"""Where every body stands in space, as tables: envelopes with place and direction, and axes that were turned."""

from __future__ import annotations

from dataclasses import dataclass

from gearwright.render.grid.table import Table, table
from gearwright.sizing import Body, Sizing
from gearwright.units import Length, Number

_PLACES = (
    "Envelopes: cylinders and cones about an axis, from the middle of their first end on. x runs along the first shaft"
    " from its first end, y and z across it. Planets as the ring that they sweep; no housing and no machines."
)
_TURNS = "Open in the design, and turned by the least angle that makes room; an angle in [layout] keeps an axis."
_SQUARE = 1e-9
"""One less the cosine of the angle to x, y or z below which an axis lies along it [-]."""


@dataclass(frozen=True)
class Stands:
    """Where one body stands."""

    body: str
    """Part, and what of it."""
    shaft: str
    """Shaft that it turns with or stands on, or ``ground``."""
    x: Length
    """Of the middle of its first end [m]."""
    y: Length
    """[m]"""
    z: Length
    """[m]"""
    along_x: Number
    """Direction of its axis [-]."""
    along_y: Number
    """[-]"""
    along_z: Number
    """[-]"""
    length: Length
    """[m]"""
    first_radius: Length
    """At its first end [m]."""
    last_radius: Length
    """At its other end [m]."""
    bore_radius: Length | None
    """Within which there is nothing of it; None where it is solid [m]."""

    @property
    def axis(self) -> str:
        """Direction of its axis in words: ``+x``, or its three parts."""
        parts = {"x": self.along_x, "y": self.along_y, "z": self.along_z}
        whole = [f"{'+' if part > 0.0 else '-'}{name}" for name, part in parts.items() if abs(part) > 1.0 - _SQUARE]
        return whole[0] if whole else ", ".join(f"{part + 0.0:.3f}" for part in parts.values())


def stands(bodies: tuple[Body, ...]) -> tuple[Stands, ...]:
    """Return where every body stands.

    Args:
        bodies: Of an arrangement.
    """
    return tuple(_stands(body) for body in bodies)


def _stands(body: Body) -> Stands:
    first, last = body.stations[0].radius, body.stations[-1].radius
    return Stands(body.name, body.shaft, *body.origin, *body.direction, body.length, first, last, body.bore or None)


def place_tables(sizing: Sizing) -> dict[str, Table]:
    """Return the tables of places by a short name; without rows where there are none.

    Args:
        sizing: As sized.
    """
    fields = ("body", "shaft", "x", "y", "z", "axis", "length", "first_radius", "last_radius", "bore_radius")
    turns = sizing.arrangement.turns
    return {
        "turns": table("Axes turned to make room", turns, ("shaft", "before", "after", "why"), note=_TURNS),
        "places": table("Places in space", stands(sizing.arrangement.bodies), fields, note=_PLACES),
    }
