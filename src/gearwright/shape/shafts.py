"""The solids of shafts: their steps, bearings, bells of rings."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.identity import Kind, PartId
from gearwright.shape.solids import Solid, bearing, stepped, tube, turned
from gearwright.sizing import Sizing
from gearwright.sizing.arranged import Body
from gearwright.sizing.casing import RingSeat
from gearwright.sizing.places import Bell, Run
from gearwright.sizing.shafts import Holder


def shaft_solid(run: Run, middle: float) -> Solid:
    """Return the solid of a shaft about its middle.

    Args:
        run: As drawn.
        middle: Place that becomes z = 0, from its first end [m].
    """
    return stepped([(low - middle, high - middle, radius) for low, high, radius in run.steps], run.bore)


def bell_solid(bell: Bell) -> Solid:
    """Return the solid of a ring's bell about the middle of its ring.

    Args:
        bell: As sized.
    """
    corners = [(place - bell.middle, radius) for place, radius in bell.section]
    way = corners if bell.disc[1] > bell.disc[0] else corners[::-1]
    return Solid((*way, way[0]))


def seat_solids(seat: RingSeat) -> tuple[Solid, Solid]:
    """Return the splines of a ring as a tube to half of their height, and its keeper, about its middle.

    Args:
        seat: As sized.
    """
    teeth = turned([(*seat.spline, seat.teeth.shaft_root / 2.0, seat.middle)])
    return teeth, turned([(*seat.keeper, seat.clear, seat.outside)])


def bearing_solid(body: Body) -> Solid:
    """Return the envelope of a bearing.

    Args:
        body: Where it stands.
    """
    return bearing(body.bore, body.radius, body.length)


def bearing_bodies(sizing: Sizing) -> Iterator[tuple[PartId, Body]]:
    """Yield every bearing of a shaft with its envelope.

    Args:
        sizing: As sized.
    """
    yield from ((body.part, body) for body in sizing.arrangement.bodies if body.part.kind is Kind.BEARING)


def holder_solid(holder: Holder) -> Solid:
    """Return a part that holds a bearing, about its middle.

    Args:
        holder: As sized.
    """
    middle, half = (holder.start + holder.end) / 2.0, (holder.end - holder.start) / 2.0
    if not holder.stepped:
        return tube((-half, half), holder.outer / 2.0, holder.bore / 2.0)
    rings = ((ring.start - middle, ring.end - middle, ring.bore / 2.0, ring.outer / 2.0) for ring in holder.rings)
    return turned(tuple(rings))
