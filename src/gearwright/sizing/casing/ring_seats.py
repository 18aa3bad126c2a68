"""Seats of rings that stand in the housing: splines on their outside in a land of the housing, and a keeper.

A land stands about the middle of its ring: a shoulder and the hub's teeth, before whose end a keeper is screwed. A ring
so held centres itself on its planets as far as flanks leave play.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, following
from gearwright.catalogue import housing_materials
from gearwright.parts.joints import Spline, spline, spline_length, spline_pressure
from gearwright.parts.joints.spline import MODULES, ROOT_DEPTH
from gearwright.sizing.arranged import Body, Frame
from gearwright.sizing.blanks import ring_radii
from gearwright.sizing.casing.housed import housed
from gearwright.sizing.casing.loops import inside_of, ways_of
from gearwright.sizing.casing.rooms import rooms_around
from gearwright.sizing.casing.shell import Stretch
from gearwright.sizing.places import ring_torque
from gearwright.sizing.places.plates import plates_of
from gearwright.sizing.result import GearSizing, Sizing
from gearwright.spec import GROUND

MODULE = 0.008
"""Module of a seat's splines over the ring's outside diameter, at most [-], an assumption: half of the room within the
wall is left for the land."""
SHORTEST = 3.0
"""Length of a seat's splines over their module, at least [-], an assumption."""
SIDE = (1.0, 2e-3)
"""Width of a shoulder and of a keeper: over the module [-], and at least [m], assumptions."""
CLEAR, OVER = 0.25, 1.0
"""Between the ring's outside and what stands beside its teeth, and how far a keeper reaches over the land, over their
module [-], assumptions."""
SUNK = (0.1, 1e-3)
"""How far a land goes on into the wall, so that it is one piece with it: over the wall [-], and at least [m]."""
CORNERS = 48
"""Of a land's outline [-]."""
PARALLEL = 1e-9
"""One less the cosine between axes that count as parallel [-]."""

Span = tuple[float, float]


class RingSeat(NamedTuple):
    """How a ring is held against turning and along its axis; places along the axis from the ring's middle."""

    ring: GearSizing
    torque: float
    """Largest of all cases [N m]."""
    teeth: Spline
    pressure: float
    """On the flanks [Pa]."""
    permissible: float
    """[Pa]"""
    spline: Span
    """[m]"""
    keeper: Span
    """Of the ring that is screwed to the land beyond the splines [m]."""
    span: Span
    """Of the land, from the shoulder on to the end of the splines [m]."""

    @property
    def middle(self) -> float:
        """Radius at half the height of the teeth: what the ring has outside, the land inside [m]."""
        return (self.teeth.shaft_tip + self.teeth.hub_tip) / 4.0

    @property
    def clear(self) -> float:
        """Radius beside the teeth within shoulder and keeper [m]."""
        return self.teeth.shaft_root / 2.0 + CLEAR * self.teeth.module

    @property
    def outside(self) -> float:
        """Radius of the keeper's outside [m]."""
        return self.middle + OVER * self.teeth.module

    @property
    def name(self) -> str:
        """As of DIN 5480, of a reference diameter that is the ring's own."""
        teeth = self.teeth
        return f"{1e3 * teeth.reference_diameter:.4g} x {1e3 * teeth.module:g} x 30 x {teeth.teeth}"

    @property
    def teeth_volume(self) -> float:
        """Of the teeth on the ring [m³]."""
        return _annulus(self.middle, self.teeth.shaft_root / 2.0) * (self.spline[1] - self.spline[0])

    @property
    def keeper_volume(self) -> float:
        """Of the keeper [m³]."""
        return _annulus(self.outside, self.clear) * (self.keeper[1] - self.keeper[0])


class LandPiece(NamedTuple):
    """A stretch of a land: from an outline in the wall to a bore."""

    span: Span
    """Along the first shaft [m]."""
    outer: Floats
    """Outline across it, y and z [m], shape (n, 2)."""
    inner: Floats
    """The bore, corner by corner, as large as its circle [m], shape (n, 2)."""
    volume: float
    """[m³]"""


def ring_seats(sizing: Sizing) -> Iterator[RingSeat]:
    """Yield how the rings of sets that stand in a housing of the gearbox's own are held.

    Args:
        sizing: As sized.

    The module is the largest of DIN 5480-1 up to 0.008 of the ring's outside with which the land is no wider than the
    ring; the length is what the torque asks at the permissible pressure, twice the working shear stress of the housing
    (Tresca), 3 modules at least, and no more than the ring leaves.

    Source: p = 2 T/(d_m h l z k) as `spline_pressure`; that a turboprop's second ring is held by splines in its case,
        with plates for axial retention: U.S. Army, subcourse AL0993, figure 9.9; how long and with which module:
        assumptions. Wear of flanks that move is not assessed.
    """
    if not sizing.design.housing.own:
        return
    permissible = 2.0 * housing_materials()[sizing.design.housing.material].shear_strength
    for ring in sizing.gears:
        if ring.rim and ring.stage in sizing.design.sets and ring.shafts[0] == GROUND:
            yield _seat(sizing, ring, permissible)


def _seat(sizing: Sizing, ring: GearSizing, permissible: float) -> RingSeat:
    outside, torque = 2.0 * ring_radii(sizing.design, ring)[1], ring_torque(sizing, ring)
    module = _module(min(MODULE * outside, ring.face_width / (SHORTEST + 2.0 * SIDE[0])))
    teeth, side = spline(outside + ROOT_DEPTH * module, module), max(SIDE[0] * module, SIDE[1])
    room = max(ring.face_width - 2.0 * side, SHORTEST * module)
    length = min(max(spline_length(torque, teeth, allowable=permissible), SHORTEST * module), room)
    pressure = spline_pressure(torque, teeth, length)
    half = length / 2.0
    return RingSeat(
        ring, torque, teeth, pressure, permissible, (-half, half), (half, half + side), (-half - side, half)
    )


def _module(most: float) -> float:
    """Return the largest module of the standard that is no larger than a length [m]; the smallest one if none is."""
    return max((size for size in MODULES if size <= most), default=MODULES[0])


def ring_frame(sizing: Sizing, ring: GearSizing) -> tuple[Frame, float]:
    """Return the frame of a shaft on a ring's axis, and where along it the ring's middle is [m].

    Args:
        sizing: As sized.
        ring: Of a set.
    """
    host = next(shaft for shaft in sizing.design.sets[ring.stage].members if shaft != GROUND)
    frame = sizing.arrangement.frames[host]
    body = next(body for body in sizing.arrangement.bodies if body.part == ring.part)
    start = float((np.asarray(body.origin) - np.asarray(frame.origin)) @ np.asarray(frame.along))
    way = float(np.asarray(body.direction) @ np.asarray(frame.along))
    return frame, start + way * body.length / 2.0


class Land(NamedTuple):
    """What holds a ring in the housing, one piece with its wall."""

    seat: RingSeat
    pieces: tuple[LandPiece, ...]
    """Its shoulder and its teeth; none about an axis across the first shaft, of which none is found."""

    @property
    def volume(self) -> float:
        """[m³]"""
        return sum(piece.volume for piece in self.pieces)


def lands_of(sizing: Sizing, wall: float) -> tuple[Land, ...]:
    """Return the lands in which the rings that stand in the housing sit.

    Args:
        sizing: As sized.
        wall: Thickness of the housing's wall [m].
    """
    seats = tuple(ring_seats(sizing))
    if not seats:
        return ()
    rings = tuple(
        _Held(*ring_frame(sizing, seat.ring), seat.span, seat.spline, seat.clear, seat.middle) for seat in seats
    )
    pieces = _pieces(_in_housing(sizing), rings, wall)
    return tuple(Land(seat, own) for seat, own in zip(seats, pieces, strict=True))


class _Held(NamedTuple):
    """What a land's pieces follow from."""

    frame: Frame
    place: float
    span: Span
    spline: Span
    clear: float
    middle: float


def _pieces(bodies: tuple[Body, ...], rings: tuple[_Held, ...], wall: float) -> tuple[tuple[LandPiece, ...], ...]:
    """Return the pieces of the land of every ring, in a wall around bodies."""
    rooms = rooms_around(bodies, wall)
    return tuple(_pieces_of(ring, rooms, wall) for ring in rings)


def _pieces_of(ring: _Held, rooms: Sequence[Stretch], wall: float) -> tuple[LandPiece, ...]:
    frame = ring.frame
    if abs(frame.along.x) < 1.0 - PARALLEL:
        return ()
    way, middle = math.copysign(1.0, frame.along.x), np.array([frame.origin.y, frame.origin.z])
    centre = frame.origin.x + way * ring.place
    low, high = sorted(centre + way * end for end in ring.span)
    around = [inside_of(room, wall) for room in rooms if room.start < high and room.end > low]
    outer = _around(np.min(around, axis=0) + max(SUNK[0] * wall, SUNK[1]), middle)
    bores = (((ring.span[0], ring.spline[0]), ring.clear), (ring.spline, ring.middle))
    ends = [sorted(centre + way * end for end in span) for span, _ in bores]
    pieces: list[LandPiece] = []
    for (start, end), (_, bore) in zip(ends, bores, strict=True):
        inner = middle + _circle(bore)
        pieces.append(LandPiece((start, end), outer, inner, (_area(outer) - _area(inner)) * (end - start)))
    return tuple(pieces)


def _in_housing(sizing: Sizing) -> tuple[Body, ...]:
    """Return all bodies that stand in the housing, with both plates of carriers."""
    plates = [plate for stage in sizing.design.sets for plate in plates_of(sizing, stage)]
    return (*housed(sizing), *plates)


def _around(reach: Floats, middle: Floats) -> Floats:
    """Return points of a cross-section's outline at equal angles about a point within it [m], shape (n, 2)."""
    ways, sides = ways_of(CORNERS), ways_of(len(reach))
    left, toward = reach - sides @ middle, ways @ sides.T
    far = np.where(toward > PARALLEL, left / np.where(toward > PARALLEL, toward, 1.0), math.inf)
    return np.asarray(middle + np.min(far, axis=1)[:, None] * ways)


def _circle(radius: float) -> Floats:
    """Return a polygon as large as a circle [m], shape (n, 2)."""
    step = 2.0 * math.pi / CORNERS
    return np.asarray(radius * math.sqrt(step / math.sin(step)) * ways_of(CORNERS))


def _area(loop: Floats) -> float:
    after = following(loop)
    return float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]) / 2.0)


def _annulus(outer: float, inner: float) -> float:
    return math.pi * (outer**2 - inner**2)
