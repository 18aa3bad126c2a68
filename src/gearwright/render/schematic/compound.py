"""A compound set on paper: a column for each sun and ring, planets as wide as their mates' columns, one carrier."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from gearwright.identity import Role
from gearwright.render.schematic import glyphs
from gearwright.render.schematic.layout import Layout
from gearwright.render.vector.axes import Axes
from gearwright.spec import GROUND
from gearwright.train import Gear, Mesh, Train

GAP = 1.5
"""Between columns [mm]."""


class Bar(NamedTuple):
    """A gear seen from its side, above the axis."""

    gear: Gear
    left: float
    """[mm]"""
    width: float
    """[mm]"""
    middle: float
    """Height of its own axis over that of the set [mm]."""
    radius: float
    """[mm]"""


def is_compound(train: Train, stage: str) -> bool:
    """Tell whether a stage is a compound set.

    Args:
        train: The graph.
        stage: Its name.
    """
    return any(gear.own for gear in train.gears if gear.stage == stage)


def bars(train: Train, layout: Layout, stage: str) -> Iterator[Bar]:
    """Yield every gear of a compound set with its place.

    Args:
        train: The graph.
        layout: Where everything stands.
        stage: Name of the set.
    """
    gears = [gear for gear in train.gears if gear.stage == stage]
    meshes = [mesh for mesh in train.meshes if mesh.stage == stage]
    width, scale = max(layout.widths[stage] * layout.scale, glyphs.LEAST_WIDTH), layout.scale
    centrals = [gear.name for gear in gears if gear.role is not Role.PLANET]
    left = layout.places[stage].x - (len(centrals) * (width + GAP) - GAP) / 2.0
    column = {name: left + place * (width + GAP) for place, name in enumerate(centrals)}
    for gear in gears:
        radius = layout.outlines[gear.name].radius * scale
        if gear.name in column:
            yield Bar(gear, column[gear.name], width, 0.0, radius)
            continue
        mates = _mates(gear.name, meshes)
        own = [column[name] for name in mates if name in column] or [left]
        yield Bar(gear, min(own), max(own) + width - min(own), _pin(train, layout, gear) * scale, radius)


def _mates(name: str, meshes: list[Mesh]) -> set[str]:
    return {gear for mesh in meshes if name in mesh.gears for gear in mesh.gears} - {name}


def _pin(train: Train, layout: Layout, gear: Gear) -> float:
    """Return how far a planet's pin stands from the axis, by its first sun or ring or those of its body [m]."""
    body = [other.name for other in train.gears if other.nodes == gear.nodes]
    for mesh in train.meshes:
        first, second = (train.gear(name) for name in mesh.gears)
        central = first if first.role is Role.SUN else second if second.role is Role.RING else None
        planet = second if central is first else first
        if central is not None and planet.name in body:
            radii = layout.outlines[central.name].radius, layout.outlines[planet.name].radius
            return radii[0] + radii[1] if central.role is Role.SUN else radii[0] - radii[1]
    return 0.0


def draw_compound(axes: Axes, train: Train, layout: Layout, stage: str) -> None:
    """Draw a compound set, above and below its axis.

    Args:
        axes: In mm of paper.
        train: The graph.
        layout: Where everything stands.
        stage: Name of the set.
    """
    placed = list(bars(train, layout, stage))
    carrier = next(mesh.nodes[2] for mesh in train.meshes if mesh.stage == stage)
    shafts = [node for bar in placed for node in bar.gear.nodes if node in layout.heights]
    y = layout.heights[next(iter([*shafts, carrier]))]
    right = max(bar.left + bar.width for bar in placed) + 3.0
    for bar in placed:
        _draw_bar(axes, bar, layout, y)
    for up in (1.0, -1.0):
        pins = {bar.middle for bar in placed if bar.gear.role is Role.PLANET}
        for pin in pins:
            start = min(bar.left for bar in placed if bar.middle == pin) - 1.5
            glyphs.line(axes, [(start, y + up * pin), (right, y + up * pin)], glyphs.LINE)
        if carrier == GROUND:
            glyphs.ground(axes, (right, y + up * max(pins) - 3.0, glyphs.WALL, 6.0))
        else:
            level = layout.levels[carrier] * glyphs.HOLLOW
            glyphs.line(axes, [(right, y + up * max(pins)), (right, y + up * level)], glyphs.BOLD)


def _draw_bar(axes: Axes, bar: Bar, layout: Layout, y: float) -> None:
    """Draw one gear: a sun across the axis, a planet above and below, a ring as its wall with a web or the ground."""
    if bar.gear.role is Role.SUN:
        glyphs.bar(axes, (bar.left, y - bar.radius, bar.width, 2.0 * bar.radius), Role.SUN)
        if bar.gear.nodes[0] == GROUND:
            glyphs.ground(axes, (bar.left - glyphs.WALL, y - 3.0, glyphs.WALL, 6.0))
        return
    wall = max(layout.outlines[bar.gear.name].rim * layout.scale, glyphs.LEAST_WALL)
    for up in (1.0, -1.0):
        if bar.gear.role is Role.PLANET:
            glyphs.bar(axes, (bar.left, y + up * bar.middle - bar.radius, bar.width, 2.0 * bar.radius), Role.PLANET)
            continue
        glyphs.bar(axes, (bar.left, y + up * bar.radius - (0.0 if up > 0.0 else wall), bar.width, wall), Role.RING)
        outer = y + up * (bar.radius + wall)
        if bar.gear.nodes[0] == GROUND:
            glyphs.ground(axes, (bar.left, min(outer, outer + up * glyphs.WALL), bar.width, glyphs.WALL))
        else:
            shaft = bar.gear.nodes[0]
            web, level = bar.left + bar.width + 5.0, y + up * layout.levels[shaft] * glyphs.HOLLOW
            middle = y + up * (bar.radius + wall / 2.0)
            start, end = layout.spans[shaft]
            reached = min(max(web, start), end)
            points = [(bar.left + bar.width, middle), (web, middle), (web, level), (reached, level)]
            glyphs.line(axes, points, glyphs.LINE)
