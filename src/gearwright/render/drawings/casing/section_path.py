"""Where the section that a general arrangement shows runs through space, so that a housing is cut where it lies.

Axes along the first shaft are corners of a way across it: from one to the next the section is the plane of both, as an
unfolded section has it. Where shafts stand square to the first one on a side on which other axes lie, the section steps
from one plane to the other. It is a true section or none.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.ranking import smallest_first
from gearwright.render.drawings.views.laid.beside import TRUE, Lying
from gearwright.render.drawings.views.positions import Positions
from gearwright.render.drawings.views.shaft_parts import MM
from gearwright.shape.solids import Leg
from gearwright.sizing import Sizing
from gearwright.sizing.arranged import Frame
from gearwright.sizing.casing import boss_bodies
from gearwright.sizing.shafts import holders_of

BESIDE = 0.02
"""From a joint to a step of the section [m]: beyond flanges of common screws."""
FLAT = 1e-9
"""How far a unit vector's part may be from what it should be [-]."""


class Lane(NamedTuple):
    """A stretch of the section along the first shaft that is cut along one way across it."""

    start: float
    """Along the first shaft [m]; −inf of the first one."""
    end: float
    """[m]; inf of the last one."""
    legs: tuple[Leg, ...]
    """Along the way, a place is its height on the sheet [m]."""


class _Across(NamedTuple):
    """A shaft that crosses the first one's direction on the sheet."""

    level: int
    """Number of the axis along the first shaft through which its plane goes."""
    up: Floats
    """What the sheet has upwards, across the first shaft [-], shape (2,)."""
    span: tuple[float, float]
    """What it takes along the first shaft, with its bearings [m]."""
    reach: tuple[float, float]
    """From and to on the sheet's height [m]."""


def lanes(sizing: Sizing, plane: Positions, joints: Sequence[float] = ()) -> tuple[Lane, ...] | None:
    """Return where the section runs, from the first end to the last; None where no true section is what is drawn.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        joints: Places along the first shaft beside which the section does not step [m].
    """
    frames, flat = sizing.arrangement.frames, dict[str, Lying]()
    for name, lying in plane.shafts.items():
        if abs(lying.along.imag) < FLAT:
            flat[name] = lying
    corners = _corners(frames, flat)
    if corners is None:
        return None
    across = []
    for name, lying in plane.shafts.items():
        if name not in flat:
            one = _across(sizing, name, lying, corners)
            if one is None:
                return None
            across.append(one)
    axes = _axes(sizing, plane, flat)
    return _laid(corners, across, _spans(flat), joints, axes)


class _Axis(NamedTuple):
    """A shaft along the first one."""

    name: str
    height: float
    """On the sheet [m]."""
    foot: Floats
    """Where it stands across the first shaft [m], shape (2,)."""
    reach: float
    """Largest radius on it [m]."""

    def is_crossed(self, leg: Leg) -> bool:
        """Tell whether a leg cuts bodies about it where the sheet does not show them."""
        low, high = max(leg.low, self.height - self.reach), min(leg.high, self.height + self.reach)
        beside = float(np.linalg.norm(leg.foot + self.height * leg.along - self.foot))
        if MM * beside < TRUE and low < high:
            return False
        nearest = min(max(float((self.foot - leg.foot) @ leg.along), leg.low), leg.high)
        return float(np.linalg.norm(leg.foot + nearest * leg.along - self.foot)) < self.reach - TRUE / MM


def _axes(sizing: Sizing, plane: Positions, names: Iterable[str]) -> list[_Axis]:
    frames = sizing.arrangement.frames
    reach = {name: max((body.radius for body in sizing.arrangement.bodies if body.shaft == name), default=0.0)
             for name in names}  # fmt: skip
    return [_Axis(name, plane.shafts[name].origin.imag / MM, np.array(frames[name].origin[1:]), reach[name])
            for name in names]  # fmt: skip


def crossed(sizing: Sizing, plane: Positions, ways: Sequence[Lane]) -> list[str]:
    """Return the shafts whose bodies the section cuts in legs in which the sheet does not show them.

    Args:
        sizing: What was sized.
        plane: Where shafts lie on the sheet.
        ways: From `lanes`.
    """
    level = [name for name, lying in plane.shafts.items() if abs(lying.along.imag) < FLAT]
    return [axis.name for axis in _axes(sizing, plane, level) if any(axis.is_crossed(leg) for leg in ways[0].legs)]


Corners = list[tuple[float, Floats]]
"""Axes along the first shaft: height on the sheet [m], and where it stands across that shaft [m], from below."""


def _corners(frames: Mapping[str, Frame], flat: Mapping[str, Lying]) -> Corners | None:
    """Return the axes along the first shaft; None where the sheet has one of them, or two side by side, elsewhere."""
    found: Corners = []
    for name, lying in flat.items():
        frame, height = frames[name], lying.origin.imag / MM
        if abs(frame.along.x - lying.along.real) > FLAT or abs(MM * frame.origin.x - lying.origin.real) > TRUE:
            return None
        found.append((height, np.array(frame.origin[1:])))
    found = smallest_first(found, lambda corner: corner[0])
    for (low, one), (high, other) in pairwise(found):
        if MM * abs(float(np.linalg.norm(other - one)) - (high - low)) > TRUE:
            return None
    kept = [found[0]] if found else []
    for corner in found[1:]:
        if MM * (corner[0] - kept[-1][0]) > TRUE:
            kept.append(corner)
    return kept or None


def _spans(flat: Mapping[str, Lying]) -> list[tuple[float, float, float]]:
    """Return height, start and end of every shaft along the first one [m]."""
    ends = [(lying.origin.imag, *sorted((lying.at(lying.start).real, lying.at(lying.end).real)))
            for lying in flat.values()]  # fmt: skip
    return [(height / MM, low / MM, high / MM) for height, low, high in ends]


def _across(sizing: Sizing, name: str, lying: Lying, corners: Corners) -> _Across | None:
    """Return a shaft across the first one's direction; None where the sheet does not have it where it stands."""
    frame = sizing.arrangement.frames[name]
    ways = np.array(frame.along[1:]) * math.copysign(1.0, lying.along.imag)
    if abs(frame.along.x - lying.along.real) > FLAT or abs(MM * frame.origin.x - lying.origin.real) > TRUE:
        return None
    up, origin, height = ways / float(np.linalg.norm(ways)), np.array(frame.origin[1:]), lying.origin.imag / MM
    at = next((k for k, (level, foot) in enumerate(corners)
               if MM * float(np.linalg.norm(origin - foot - (height - level) * up)) < TRUE), None)  # fmt: skip
    if at is None:
        return None
    bodies = [body for body in sizing.arrangement.bodies if body.shaft == name and str(body.part.kind) != "gear"]
    bosses = boss_bodies(sizing, holders_of(sizing))
    wide = max([0.0, *(body.radius for body in (*bodies, *bosses.values()) if body.shaft == name)])
    ends = [lying.at(end) / MM for end in (lying.start, lying.end)]
    xs, ys = sorted(end.real for end in ends), sorted(end.imag for end in ends)
    return _Across(at, up, (xs[0] - wide, xs[1] + wide), (ys[0], ys[1]))


def _laid(
    corners: Corners,
    across: list[_Across],
    spans: list[tuple[float, float, float]],
    joints: Sequence[float],
    axes: Sequence[_Axis],
) -> tuple[Lane, ...] | None:
    """Return the lanes: one, or two where shafts across stand beside what is on their side of an axis."""
    first = across[0].up if across else np.array([1.0, 0.0])
    base = _Way.of(corners, first)
    if not across:
        base = base.freed(axes)
    stepped: list[_Across] = []
    for one in across:
        if base.holds(one):
            continue
        beyond = base.beyond(one)
        if beyond is None:
            stepped.append(one)
        else:
            base = beyond
    if not stepped:
        return (Lane(-math.inf, math.inf, base.legs),)
    other = stepped[0]
    if len(stepped) > 1 or not all(base.beyond(one) or base.holds(one) for one in across if one not in stepped):
        return None
    level = corners[other.level][0]
    aside = [span for span in spans if abs(span[0] - level) > TRUE / MM]
    low, high = min(span[1] for span in aside), max(span[2] for span in aside)
    way = _Way(corners[other.level : other.level + 1], (-other.up, other.up))
    if high < other.span[0]:
        step = _step(high, other.span[0], joints)
        return (Lane(-math.inf, step, base.legs), Lane(step, math.inf, way.legs))
    if low > other.span[1]:
        step = _step(other.span[1], low, joints)
        return (Lane(-math.inf, step, way.legs), Lane(step, math.inf, base.legs))
    return None


def _step(low: float, high: float, joints: Sequence[float]) -> float:
    """Return the middle between two places, or a place beside it that is further from joints [m]."""
    tried = [low + share * (high - low) for share in (0.5, 0.375, 0.625, 0.25, 0.75)]
    far = [min((abs(step - joint) for joint in joints), default=math.inf) for step in tried]
    return next((step for step, room in zip(tried, far, strict=True) if room > BESIDE), tried[far.index(max(far))])


class _Way(NamedTuple):
    """A way across the first shaft: its corners, and how it goes on below the first and above the last one."""

    corners: Corners
    beyond_ends: tuple[Floats, Floats]
    """Unit vectors out of both ends [-]."""

    @staticmethod
    def of(corners: Corners, up: Floats) -> _Way:
        """Return the way through all corners, at both ends straight on; of one corner that of a direction."""
        if len(corners) == 1:
            return _Way(corners, (-up, up))
        steps = [(other[1] - one[1]) / (other[0] - one[0]) for one, other in pairwise(corners)]
        return _Way(corners, (-steps[0], steps[-1]))

    def freed(self, axes: Sequence[_Axis]) -> _Way:
        """Return the way with ends that are turned, as little as can be, where straight on they cut other bodies."""
        ends = list(self.beyond_ends)
        for k in (0, 1):
            straight = ends[k]
            for turn in sorted(np.radians(np.arange(-165.0, 180.0, 15.0)), key=abs):
                cos, sin = math.cos(turn), math.sin(turn)
                ends[k] = np.array([cos * straight[0] - sin * straight[1], sin * straight[0] + cos * straight[1]])
                leg = _Way(self.corners, (ends[0], ends[1])).legs[-k]
                if not any(axis.is_crossed(leg) for axis in axes):
                    break
            else:
                ends[k] = straight
        return _Way(self.corners, (ends[0], ends[1]))

    @property
    def legs(self) -> tuple[Leg, ...]:
        """Its straight pieces, from below."""
        low, high = self.corners[0], self.corners[-1]
        below, above = -self.beyond_ends[0], self.beyond_ends[1]
        found = [Leg(-math.inf, low[0], low[1] - low[0] * below, below)]
        for (start, one), (end, other) in pairwise(self.corners):
            along = (other - one) / (end - start)
            found.append(Leg(start, end, one - start * along, along))
        return (*found, Leg(high[0], math.inf, high[1] - high[0] * above, above))

    def at(self, height: float) -> Floats:
        """Return where the way is at a height of the sheet [m]."""
        leg = next(leg for leg in self.legs if height <= leg.high)
        return leg.foot + height * leg.along

    def holds(self, one: _Across) -> bool:
        """Tell whether a shaft lies in the section as it runs."""
        level, foot = self.corners[one.level]
        return all(
            MM * float(np.linalg.norm(self.at(height) - foot - (height - level) * one.up)) < TRUE
            for height in (*one.reach, *(corner for corner, _ in self.corners if one.reach[0] < corner < one.reach[1]))
        )

    def beyond(self, one: _Across) -> _Way | None:
        """Return the way turned beyond its last corner on one side into the plane of a shaft that lies there alone."""
        level = self.corners[one.level][0]
        if one.level == len(self.corners) - 1 and one.reach[0] > level:
            return _Way(self.corners, (self.beyond_ends[0], one.up))
        if one.level == 0 and one.reach[1] < level:
            return _Way(self.corners, (-one.up, self.beyond_ends[1]))
        return None
