"""The signs of a skeleton diagram: gears as bars of pitch radius and face width, carriers, ground, machines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearwright.identity import Kind, Role
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.marks import circle
from gearwright.render.vector.palette import DARK_STEEL, DEEP_STEEL, PALE_STEEL

THIN, LINE, BOLD = 0.7, 1.3, 2.2
"""Line widths [pt]."""
HOLLOW = 2.2
"""Distance from one level of nested shafts to the next [mm]."""
LEAST_WIDTH, LEAST_WALL = 2.0, 1.4
"""Least width of a gear and wall of a ring [mm]."""
MACHINE_HEIGHT = 10.0
"""Half the height of a motor [mm]."""
WALL = 2.0
"""Depth of the ground's hatching [mm]."""


@dataclass(frozen=True)
class Member:
    """A sun, ring or carrier."""

    grounded: bool
    side: float
    """Where its shaft leaves: −1 left, +1 right."""
    level: int
    """Of its shaft."""


@dataclass(frozen=True)
class PlanetaryShape:
    """A planetary set on paper."""

    x: float
    y: float
    sun: float
    """Radii [mm]."""
    planet: float
    ring: float
    wall: float
    """Of the ring [mm]."""
    width: float
    """Of the gears [mm]."""
    members: Mapping[Role | Kind, Member]
    """sun, ring and carrier."""


FILLS = {
    Role.SUN: DARK_STEEL, Role.PLANET: PALE_STEEL, Role.RING: DEEP_STEEL, Role.PINION: DARK_STEEL,
    Role.WHEEL: theme.STEEL,
}  # fmt: skip
"""Shade of each kind of gear, so that neighbours differ."""

Spot = tuple[float, float, float, float]
"""Left, low, width, height [mm]."""


def bar(axes: Axes, spot: Spot, role: Role) -> None:
    """Draw a gear seen from its side.

    Args:
        axes: In mm of paper.
        spot: Where.
        role: What kind of gear.
    """
    axes.rectangle(spot[:2], *spot[2:], fc=FILLS[role], ec=theme.INK, lw=THIN, zorder=4)


def line(axes: Axes, points: list[tuple[float, float]], width: float = LINE) -> None:
    """Draw a shaft, an arm or a web.

    Args:
        axes: In mm of paper.
        points: [mm].
        width: [pt].
    """
    axes.plot([x for x, _ in points], [y for _, y in points], color=theme.INK, lw=width, zorder=5)


def ground(axes: Axes, spot: Spot) -> None:
    """Draw the hatching of what stands still.

    Args:
        axes: In mm of paper.
        spot: Where.
    """
    axes.rectangle(spot[:2], *spot[2:], hatched=True, zorder=3)


def planetary(axes: Axes, shape: PlanetaryShape) -> None:
    """Draw a planetary set, above and below its axis.

    Args:
        axes: In mm of paper.
        shape: The set.
    """
    half = shape.width / 2.0
    bar(axes, (shape.x - half, shape.y - shape.sun, shape.width, 2.0 * shape.sun), Role.SUN)
    pin = shape.sun + shape.planet
    for up in (1.0, -1.0):
        middle = shape.y + up * pin
        bar(axes, (shape.x - half, middle - shape.planet, shape.width, 2.0 * shape.planet), Role.PLANET)
        low = shape.y + up * shape.ring - (0.0 if up > 0.0 else shape.wall)
        bar(axes, (shape.x - half, low, shape.width, shape.wall), Role.RING)
        _ring(axes, shape, up)
        _carrier(axes, shape, up, middle)
    sun = shape.members[Role.SUN]
    if sun.grounded:
        reach = shape.x + sun.side * (half + 5.0)
        line(axes, [(shape.x, shape.y), (reach, shape.y)], BOLD)
        ground(axes, (min(reach, reach + sun.side * WALL), shape.y - 3.0, WALL, 6.0))
        line(axes, [(reach, shape.y - 3.0), (reach, shape.y + 3.0)], THIN)


def _ring(axes: Axes, shape: PlanetaryShape, up: float) -> None:
    ring, half = shape.members[Role.RING], shape.width / 2.0
    outer = shape.y + up * (shape.ring + shape.wall)
    if ring.grounded:
        ground(axes, (shape.x - half - 2.5, min(outer, outer + up * WALL), shape.width + 5.0, WALL))
        line(axes, [(shape.x - half - 2.5, outer), (shape.x + half + 2.5, outer)], LINE)
        return
    web, middle = shape.x + ring.side * (half + 5.0), shape.y + up * (shape.ring + shape.wall / 2.0)
    line(axes, [(shape.x + ring.side * half, middle), (web, middle), (web, shape.y + up * ring.level * HOLLOW)], BOLD)


def _carrier(axes: Axes, shape: PlanetaryShape, up: float, middle: float) -> None:
    carrier, half = shape.members[Kind.CARRIER], shape.width / 2.0
    arm = shape.x + carrier.side * (half + 2.5)
    line(axes, [(shape.x - carrier.side * (half + 1.2), middle), (arm, middle)], BOLD)
    if carrier.grounded:
        ground(axes, (min(arm, arm + carrier.side * WALL), middle - 3.0, WALL, 6.0))
        line(axes, [(arm, middle - 3.0), (arm, middle + 3.0)], LINE)
    else:
        line(axes, [(arm, middle + up * 0.4), (arm, shape.y + up * carrier.level * HOLLOW)], BOLD)


def wheel(
    axes: Axes, at: tuple[float, float], reach: tuple[float, float], *, width: float, halves: int, role: Role
) -> None:
    """Draw a gear of a pair, two halves with their opposite hands where it is double-helical.

    Args:
        axes: In mm of paper.
        at: Where its axis is (x, y) [mm].
        reach: Radius below and above its axis [mm].
        width: Of one half [mm].
        halves: 1 or 2.
        role: Pinion or wheel.
    """
    x, y = at
    down, up = reach
    gap = 1.0 if halves > 1 else 0.0
    left = x - (halves * width + (halves - 1) * gap) / 2.0
    for half in range(halves):
        start = left + half * (width + gap)
        bar(axes, (start, y - down, width, down + up), role)
        if halves > 1:
            slope = min(0.5 * width, 0.3 * (down + up)) * (1.0 if half == 0 else -1.0)
            for share in (0.22, 0.5, 0.78):
                height = y - down + share * (down + up)
                axes.plot([start, start + width], [height - slope / 2.0, height + slope / 2.0], color=theme.MUTED,
                          lw=0.5, zorder=4.5)  # fmt: skip


def internal_wheel(axes: Axes, at: tuple[float, float], radius: float, width: float) -> None:
    """Draw an internal gear, its toothed ring on the side of its pinion.

    Args:
        axes: In mm of paper.
        at: Where its axis is (x, y) [mm].
        radius: Signed: positive if the pinion is above the axis [mm].
        width: [mm].
    """
    x, y = at
    wall = 3.0 if radius > 0.0 else -3.0
    bar(axes, (x - width / 2.0, min(y + radius, y + radius + wall), width, abs(wall)), Role.RING)
    web = x + width / 2.0 + 2.5
    line(axes, [(x + width / 2.0, y + radius + wall / 2.0), (web, y + radius + wall / 2.0), (web, y)], BOLD)


def machine(axes: Axes, at: tuple[float, float], kind: str, *, at_left: bool, around: bool) -> None:
    """Draw a machine: a turbine widens along its flow, a motor is a box, a propeller has blades.

    Args:
        axes: In mm of paper.
        at: Where its shaft is (x, y) [mm].
        kind: turbine, motor or propeller; anything else is a plain box.
        at_left: It sits at the left end of its shaft.
        around: Its shaft goes on to both sides.
    """
    x, y = at
    if kind == "turbine" and not around:
        near, far = (x + 8.0, x - 8.0) if at_left else (x - 8.0, x + 8.0)
        _solid(axes, [(far, y - 5.0), (near, y - 10.0), (near, y + 10.0), (far, y + 5.0)])
    elif kind in ("propeller", "rotor"):
        for up in (1.0, -1.0):
            axes.shape(
                circle((x, y + up * 15.0), 4.0, 25.0), cubic=True, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=6
            )
        nose = 1.0 if not at_left else -1.0
        _solid(axes, [(x - nose * 3.0, y - 3.5), (x - nose * 3.0, y + 3.5), (x + nose * 7.0, y)])
    else:
        height, depth = MACHINE_HEIGHT, 4.5 if around else 6.0
        box = [(x - 7.0, y - height), (x + 7.0, y - height), (x + 7.0, y + height), (x - 7.0, y + height)]
        axes.shape(box, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=4.6 if around else 6.0)
        for side in (depth, -depth):
            axes.plot([x - 7.0, x + 7.0], [y + side, y + side], color=theme.INK, lw=THIN, zorder=6.1)


def _solid(axes: Axes, corners: list[tuple[float, float]]) -> None:
    axes.shape(corners, fc=theme.STEEL, ec=theme.INK, lw=LINE, zorder=6.2)


def clutch(axes: Axes, at: tuple[float, float], *, overrunning: bool, open_now: bool) -> None:
    """Draw a clutch: two plates, with an arrow head if it transmits only one way.

    Args:
        axes: In mm of paper.
        at: Its middle (x, y) [mm].
        overrunning: It transmits only from driving to driven.
        open_now: It does not transmit in this case.
    """
    x, y = at
    gap = 1.8 if open_now else 0.8
    for side in (-gap, gap):
        line(axes, [(x + side, y - 4.0), (x + side, y + 4.0)], BOLD)
    if overrunning:
        axes.shape([(x - 1.5, y + 5.0), (x - 1.5, y + 8.0), (x + 2.0, y + 6.5)], fc=theme.INK, zorder=5)


def damper(axes: Axes, at: tuple[float, float]) -> None:
    """Draw a viscous damper: a piston in an open cylinder.

    Args:
        axes: In mm of paper.
        at: Its middle (x, y) [mm].
    """
    x, y = at
    line(axes, [(x + 2.0, y + 3.0), (x - 1.6, y + 3.0), (x - 1.6, y - 3.0), (x + 2.0, y - 3.0)], BOLD)
    line(axes, [(x + 0.8, y - 2.0), (x + 0.8, y + 2.0)], BOLD)
