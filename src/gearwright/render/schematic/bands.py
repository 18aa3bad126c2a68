"""The power flow on a skeleton: bands as wide as the power, in the colours of the machines that it comes from."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gearwright.identity import Kind
from gearwright.render.schematic.layout import Layout, pair_meshes
from gearwright.render.schematic.power import NOTHING, Feed, Stretch, Traced
from gearwright.render.style import theme
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.palette import tinted
from gearwright.train import PowerFlow, Train

WIDEST = 9.0
"""Band of the largest power [mm]."""
ABOVE_GEARS = 4.6
"""Layer of power that goes through a mesh."""
HEAD = 3.0
"""Length of an arrow head [mm]."""


@dataclass(frozen=True)
class Pen:
    """How power is drawn."""

    axes: Axes
    scale: float
    """Width over power [mm/W]."""
    colours: Mapping[str, str]
    """Machine -> colour."""


def source_colours(train: Train, flow: PowerFlow, kinds: Mapping[str, str]) -> dict[str, str]:
    """Return machine -> colour for those that give power in a case: each its own, as long as there are any.

    Args:
        train: The graph.
        flow: The case.
        kinds: Machine -> turbine, motor or propeller.
    """
    colours: dict[str, str] = {}
    for name in train.machines:
        if flow.machine_powers[name] > 0.0:
            first = theme.KIND_COLOURS.get(kinds.get(name, ""), theme.BLUE)
            taken = Counter(colours.values())
            colours[name] = min((first, *theme.CYCLE, theme.MUTED), key=taken.__getitem__)
    return colours


def band_scale(traced: Traced) -> float:
    """Return width over power [mm/W].

    Args:
        traced: From `trace_power`.
    """
    powers = [stretch.power for stretch in traced.stretches] + [feed.branch.power for feed in traced.feeds]
    largest = max(map(abs, powers), default=0.0)
    return WIDEST / largest if largest else 0.0


def draw_bands(pen: Pen, train: Train, flow: PowerFlow, *, layout: Layout, traced: Traced) -> None:
    """Draw the power of every shaft, of every mesh between axes, and of machines around their shafts.

    Args:
        pen: How power is drawn.
        train: The graph.
        flow: The case.
        layout: Where everything stands.
        traced: From `trace_power`.
    """
    for stretch in traced.stretches:
        if abs(stretch.power) * pen.scale > WIDEST * NOTHING:
            _along(pen, stretch, layout, traced.stretches)
    for mesh in pair_meshes(train):
        power = flow.meshes[mesh.name].tooth_power
        if abs(power) * pen.scale > WIDEST * NOTHING:
            driver, driven = mesh.nodes[:2] if power > 0.0 else mesh.nodes[1::-1]
            feed = next(f for f in traced.feeds if f.branch.shaft == driver and f.branch.stage == mesh.stage)
            start, end = layout.heights[driver], layout.heights[driven]
            _across(pen, layout.places[mesh.stage].x, abs(power), start=start, end=end, shares=feed.sources)
    for feed in traced.feeds:
        start, end = layout.spans[feed.branch.shaft]
        if feed.branch.part.kind is Kind.MACHINE and start < feed.x < end:
            y = layout.heights[feed.branch.shaft]
            _around(pen, (feed.x, y), feed)


def half_width(stretch: Stretch, pen: Pen, layout: Layout, stretches: Sequence[Stretch]) -> float:
    """Return how far a stretch's band reaches from its axis, the bands inside it included [mm].

    Args:
        stretch: The stretch.
        pen: How power is drawn.
        layout: Where everything stands.
        stretches: Of all shafts.
    """
    return _inside(stretch, pen, layout, stretches) + abs(stretch.power) * pen.scale / 2.0


def _inside(stretch: Stretch, pen: Pen, layout: Layout, stretches: Sequence[Stretch]) -> float:
    """Return half the width of the bands on the shafts inside a hollow one [mm]."""
    return sum(
        max(abs(inner.power) * pen.scale / 2.0 for inner in stretches if inner.shaft == shaft)
        for shaft in {inner.shaft for inner in stretches if _is_within(inner, stretch, layout)}
    )


def _is_within(inner: Stretch, outer: Stretch, layout: Layout) -> bool:
    return (
        layout.heights[inner.shaft] == layout.heights[outer.shaft]
        and layout.levels[inner.shaft] < layout.levels[outer.shaft]
        and min(inner.end, outer.end) > max(inner.start, outer.start)
    )


def _along(pen: Pen, stretch: Stretch, layout: Layout, stretches: Sequence[Stretch]) -> None:
    y, width = layout.heights[stretch.shaft], abs(stretch.power) * pen.scale
    inner = _inside(stretch, pen, layout, stretches)
    spot = spots(stretch, layout)[0]
    head = HEAD if stretch.power > 0.0 else -HEAD
    lanes = (
        [(y - width / 2.0, width)]
        if inner == 0.0
        else [(y + inner, width / 2.0), (y - inner - width / 2.0, width / 2.0)]
    )
    for low, room in lanes:
        for name, share in stretch.sources.items():
            _patch(pen, (stretch.start, low, stretch.end - stretch.start, share * room), name)
            low += share * room
        middle = low - room / 2.0
        tip = [(spot - head / 2.0, middle - 1.6), (spot - head / 2.0, middle + 1.6), (spot + head / 2.0, middle)]
        pen.axes.shape(tip, fc=theme.INK, lw=0.0, zorder=6)


def spots(stretch: Stretch, layout: Layout) -> list[float]:
    """Return places along a stretch that no column covers, the middle ones first [mm].

    Args:
        stretch: The stretch.
        layout: Where everything stands.
    """
    middle = (stretch.start + stretch.end) / 2.0
    free = [gap for gap in layout.gaps() if stretch.start < gap < stretch.end]
    return sorted(free, key=lambda gap: (abs(gap - middle), gap)) or [middle]


def _across(pen: Pen, x: float, power: float, *, start: float, end: float, shares: Mapping[str, float]) -> None:
    """Draw power from one height to another."""
    width = power * pen.scale
    left = x - width / 2.0
    for name, share in shares.items():
        _patch(pen, (left, min(start, end), share * width, abs(end - start)), name, ABOVE_GEARS)
        left += share * width
    middle, head = (start + end) / 2.0, HEAD if end > start else -HEAD
    tip = [(x - 1.6, middle - head / 2.0), (x + 1.6, middle - head / 2.0), (x, middle + head / 2.0)]
    pen.axes.shape(tip, fc=theme.INK, lw=0.0, zorder=6)


def _around(pen: Pen, at: tuple[float, float], feed: Feed) -> None:
    """Draw arrow heads inside a machine that its shaft goes through: towards the shaft if it drives."""
    colour = pen.colours.get(feed.branch.part.name, theme.MUTED)
    if feed.branch.power == 0.0:
        return
    for up in (1.0, -1.0):
        middle = at[1] + up * 7.25
        tip = -up * HEAD / 2.0 if feed.branch.power > 0.0 else up * HEAD / 2.0
        corners = [(at[0] - 2.0, middle - tip), (at[0] + 2.0, middle - tip), (at[0], middle + tip)]
        pen.axes.shape(corners, fc=colour, lw=0.0, zorder=6.3)


def _patch(pen: Pen, box: tuple[float, float, float, float], name: str, layer: float = 2.0) -> None:
    left, low, width, height = box
    pen.axes.rectangle((left, low), width, height, fc=tinted(pen.colours[name]), lw=0.0, zorder=layer)
