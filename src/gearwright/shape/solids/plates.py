"""Plates of carriers: a hub with arms that end in eyes around pins, and that carry bridges."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Bools, Floats, following
from gearwright.shape.solids.holes import Bores
from gearwright.shape.solids.solid import BORE_STEPS, Section, Solid
from gearwright.shape.solids.surface import circle

SAMPLES = 1440
"""Rays by which the area of an outline is taken [-]."""
LEAST = 4
"""Corners around half of an eye, at least [-]."""
SAME = 1e-7
"""Rays that are nearer to each other are one [rad]."""
TURNED = math.radians(105.0)
"""Of an eye that corners lie on, to both sides of its outermost point [rad]."""
SHARP = 30.0
"""Exponent by which an outline goes from one arm over to the next without a corner: they meet 2.3 % further out [-]."""
_HALVINGS = 30


class Arm(NamedTuple):
    """What a plate reaches out to, away from its axis."""

    angle: float
    """[rad]"""
    radius: float
    """Of the middle of its end, about the axis [m]."""
    half: float
    """Half of its width; of an eye its radius [m]."""
    inner: float = 0.0
    """Where what it carries begins, about the axis, of one that ends square [m]."""
    is_round: bool = True
    """Whether it ends in an eye around a pin; else square, beyond a bridge."""


class Outline(NamedTuple):
    """What a plate is cut to."""

    reach: float
    """Outer radius [m]."""
    bore: float
    """Radius of the hole for shafts; 0: none [m]."""
    fill: float
    """Share of the disc that is left, holes for pins not counted [-]."""


class Form(NamedTuple):
    """The outline of a plate: arms over a hub that leaves as much as is asked."""

    arms: tuple[Arm, ...]
    reach: float
    """Outer radius [m]."""
    hub: float
    """Its radius over the outer one [-]."""
    stem: float
    """Width of arms between the hub and what they hold over that of their ends [-]."""

    def radii(self, angles: Floats) -> Floats:
        """Return the outline about its axis [m], shape (n,).

        Args:
            angles: [rad], shape (n,).
        """
        return np.asarray(self.reach * _joined(_powers(self.arms, angles, self.reach, self.stem), self.hub))


def plate_form(arms: Sequence[Arm], outline: Outline, angles: Floats | None = None) -> Form:
    """Return the outline of a plate.

    Args:
        arms: To pins and bridges.
        outline: Its sizes.
        angles: Of the corners that it is cut to, between which it is straight, rising [rad]; left out: so many that it
            is round.

    Source: rays from the axis to stadiums and rectangles; the hub's radius by halving. Where arms alone leave more than
        is asked, they are narrower between the smallest hub and what they hold, as far as rays past that allow.
    """
    reach, angles = outline.reach, circle(SAMPLES) if angles is None else angles
    left = min(outline.fill + (outline.bore / reach) ** 2, 1.0)
    if left >= 1.0:
        return Form(tuple(arms), reach, 1.0, 1.0)
    least, whole = min(1.05 * outline.bore, 0.95 * reach) / reach, _powers(arms, angles, reach, 1.0)
    if _share(_joined(whole, least), angles) <= left:
        hub = _halved(lambda hub: _share(_joined(whole, hub), angles) > left, least, 1.0)
        return Form(tuple(arms), reach, hub, 1.0)
    stem = _halved(lambda stem: _share(_joined(_powers(arms, angles, reach, stem), least), angles) > left, 0.0, 1.0)
    return Form(tuple(arms), reach, least, stem)


def _halved(is_much: Callable[[float], bool], low: float, high: float) -> float:
    """Return the most that is not too much."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if is_much(middle) else (middle, high)
    return low


def _powers(arms: Sequence[Arm], angles: Floats, reach: float, stem: float) -> Floats:
    """Return how far arms reach, as powers that are added up, with stems as wide as a share of their ends [-]."""
    out = [(_round_arm if arm.is_round else _square_arm)(arm, angles, stem) for arm in arms]
    return np.asarray(np.sum([(each / reach) ** SHARP for each in out], axis=0))


def _joined(powers: Floats, hub: float) -> Floats:
    """Return arms and hub as one outline, over the outer radius [-]."""
    return np.asarray(np.minimum((powers + hub**SHARP) ** (1.0 / SHARP), 1.0))


def _share(radius: Floats, angles: Floats) -> float:
    """Return the area within an outline over that of the circle around it [-]."""
    turn = np.diff(angles, append=angles[0] + 2.0 * math.pi)
    return float(np.sum(radius * following(radius) * np.sin(turn))) / (2.0 * math.pi)


def _round_arm(arm: Arm, angles: Floats, stem: float) -> Floats:
    """Return how far rays from the axis reach within an arm that ends in an eye [m]."""
    off = np.angle(np.exp(1j * (angles - arm.angle)))
    across = np.maximum(np.abs(np.sin(off)), 1e-9)
    eye = arm.radius * np.cos(off) + np.sqrt(np.maximum(arm.half**2 - (arm.radius * across) ** 2, 0.0))
    seen = arm.radius * across <= arm.half
    beside = np.abs(off) >= math.atan2(stem * arm.half, arm.radius)
    side = np.where(beside, stem * arm.half / across, 0.0)
    return _ahead(off, np.maximum(np.where(seen, eye, 0.0), side))


def _square_arm(arm: Arm, angles: Floats, stem: float) -> Floats:
    """Return how far rays from the axis reach within an arm that ends square [m]."""
    off = np.angle(np.exp(1j * (angles - arm.angle)))
    across, along = np.maximum(np.abs(np.sin(off)), 1e-9), np.maximum(np.cos(off), 1e-9)
    end = np.minimum(arm.half / across, arm.radius / along)
    within = np.abs(off) <= math.atan2(arm.half, arm.inner) + SAME  # rays through its near corners reach them
    return _ahead(off, np.where(within, end, stem * arm.half / across))


def _ahead(off: Floats, radius: Floats) -> Floats:
    """Return nothing behind the axis."""
    return np.where(np.abs(off) < math.pi / 2.0, radius, 0.0)


def plate(arms: Sequence[Arm], outline: Outline, thickness: float, *, pin: float, segments: int) -> Solid:
    """Return the plate of a carrier, with holes for its pins.

    Args:
        arms: To pins and bridges.
        outline: Its sizes.
        thickness: [m].
        pin: Radius of the pins [m].
        segments: Corners of a circle; its outline has as many, and more around eyes and beside bridges.
    """
    middles = tuple(complex(arm.radius * np.exp(1j * arm.angle)) for arm in arms if arm.is_round)
    bores, half = Bores(middles, pin), thickness / 2.0
    angles = _corners(arms, segments, bores.as_large(BORE_STEPS).rays(BORE_STEPS))
    radius = plate_form(arms, outline, angles).radii(angles)
    sections = tuple(Section(radius, angles, np.full(len(angles), place)) for place in (-half, half))
    edges: Bools = np.zeros(len(angles), dtype=bool)
    way = ((half, outline.bore), (-half, outline.bore))
    return Solid(way, sections, edges, bores=bores)


def _corners(arms: Sequence[Arm], segments: int, rays: Floats) -> Floats:
    """Return where an outline has corners [rad]: on the rays of bores, closer around eyes and beside bridges."""
    found, more = [], max(LEAST, segments // 12)
    for arm in arms:
        if arm.is_round:
            turn = np.linspace(0.0, TURNED, more)
            off = np.angle(arm.radius + arm.half * np.exp(1j * turn))
            off = off[off < math.asin(min(arm.half / arm.radius, 1.0))]
            found.append(arm.angle + np.concatenate([-off, off]))
        else:
            ends = [math.atan2(arm.half, place) for place in (arm.radius, max(arm.inner, arm.half))]
            found.append(arm.angle + np.array([-ends[1], -ends[0], ends[0], ends[1]]))
    step, angles = 2.0 * math.pi / segments, np.sort(np.mod(rays.ravel(), 2.0 * math.pi))
    middles, spans = rays[:, rays.shape[1] // 2], rays[:, -1] - rays[:, rays.shape[1] // 2]
    for these, apart in ((np.concatenate(found), 0.1 * step), (circle(segments), 0.4 * step)):
        free = np.all(_between(these, middles) > spans, axis=1)
        far = np.min(_between(these, angles), axis=1) > apart
        angles = np.sort(np.concatenate([angles, np.mod(these[free & far], 2.0 * math.pi)]))
    return angles[np.diff(angles, append=angles[0] + 2.0 * math.pi) > SAME]


def _between(these: Floats, others: Floats) -> Floats:
    """Return the angles between every one of some rays and every one of others [rad], shape (n, m)."""
    return np.asarray(np.abs(np.angle(np.exp(1j * (these[:, None] - others[None, :])))))
