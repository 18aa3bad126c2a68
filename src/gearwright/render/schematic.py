"""The skeleton of a train as a drawing, and the power flow of a load case on it.

To scale, with dimensions, parts are drawn in `drawings`.
"""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import SIDES, Kind, Role, by_name, shown, text, written
from gearwright.render import skeleton as glyphs, style as theme
from gearwright.render.skeleton import Layout, centre_distance, element, lay_out, pair_meshes
from gearwright.render.style import Board
from gearwright.render.vector.figure import Axes, Figure, Slot, tinted
from gearwright.render.vector.layout import text_width
from gearwright.sizing import Sizing
from gearwright.spec import GROUND
from gearwright.train import INTERNAL, Attachment, Branch, Gear, Mesh, PowerFlow, Train, attachments, branches

# ----------------------------------------------------------------------------------------------------------------------
# A compound set on paper: a column for each sun and ring, planets as wide as their mates' columns, one carrier.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# The skeleton of a train on paper: its shafts, planetary sets, pairs, clutches and machines.
# ----------------------------------------------------------------------------------------------------------------------


STUB = 4.0
"""How far a shaft sticks out of a pair's gear [mm]."""
_SIDES: Mapping[Role | Kind, float] = {Role.SUN: -1.0, Role.RING: 1.0, Kind.CARRIER: 1.0}
"""Where a member's shaft leaves if nothing else says so."""


def draw_train(
    axes: Axes, train: Train, layout: Layout, *, kinds: Mapping[str, str], open_clutches: Collection[str] = ()
) -> None:
    """Draw the skeleton.

    Args:
        axes: In mm of paper.
        train: The graph.
        layout: Where everything stands.
        kinds: Machine -> turbine, motor or propeller.
        open_clutches: Clutches that do not transmit.
    """
    seats = attachments(train)
    for name in dict.fromkeys(seat.stage for seat in seats if seat.member is Kind.CARRIER):
        if is_compound(train, name):
            draw_compound(axes, train, layout, name)
        else:
            glyphs.planetary(axes, _planetary(name, train, layout, seats))
    _draw_pairs(axes, train, layout)
    for shaft in layout.spans:
        _draw_shaft(axes, shaft, layout, seats)
    for name, shaft in train.machines.items():
        x, (start, end) = layout.places[name].x, layout.spans[shaft]
        glyphs.machine(
            axes, (x, layout.heights[shaft]), kinds.get(name, ""), at_left=x <= start, around=start < x < end
        )
    for joint in train.joints:
        at = (layout.places[joint.name].x, layout.heights[joint.driving])
        glyphs.clutch(axes, at, overrunning=joint.overrunning, open_now=joint.name in open_clutches)
    for damper in train.dampers:
        glyphs.damper(axes, (layout.places[damper.name].x, layout.heights[damper.driving]))


def _planetary(name: str, train: Train, layout: Layout, seats: Collection[Attachment]) -> glyphs.PlanetaryShape:
    members = {seat.member: seat for seat in seats if seat.stage == name}
    shafts = [seat.shaft for seat in members.values() if seat.shaft != GROUND]
    sun, planet, ring = (layout.outlines[train.gear_of(name, role).name] for role in (Role.SUN, Role.PLANET, Role.RING))
    scale = layout.scale
    return glyphs.PlanetaryShape(
        x=layout.places[name].x,
        y=layout.heights[shafts[0]],
        sun=sun.radius * scale,
        planet=planet.radius * scale,
        ring=ring.radius * scale,
        wall=max(ring.rim * scale, glyphs.LEAST_WALL),
        width=max(sun.width * scale, glyphs.LEAST_WIDTH),
        members=_members(members, layout),
    )


def _members(seats: Mapping[Role | Kind, Attachment], layout: Layout) -> dict[Role | Kind, glyphs.Member]:
    """Return sun, carrier and ring; a web that would cut a shaft outside it goes to the other side."""
    members: dict[Role | Kind, glyphs.Member] = {}
    for kind in (Role.SUN, Kind.CARRIER, Role.RING):
        shaft = seats[kind].shaft
        if shaft == GROUND:
            members[kind] = glyphs.Member(grounded=True, side=_SIDES[kind], level=0)
            continue
        side, level = member_side(seats[kind], layout), layout.levels[shaft]
        inside = [member for member in members.values() if not member.grounded and member.side == side]
        if any(member.level >= level for member in inside):
            side = -side
        members[kind] = glyphs.Member(grounded=False, side=side, level=level)
    return members


def member_side(seat: Attachment, layout: Layout) -> float:
    """Return where the shaft of a planetary's member goes on: −1 left, +1 right.

    Args:
        seat: The member.
        layout: Where everything stands.
    """
    x, (start, end) = layout.places[seat.stage].x, layout.spans[seat.shaft]
    if start == end:
        return _SIDES[seat.member]
    return 1.0 if end - x > x - start else -1.0


def _draw_shaft(axes: Axes, shaft: str, layout: Layout, seats: Collection[Attachment]) -> None:
    start, end = layout.spans[shaft]
    on = [seat for seat in seats if seat.shaft == shaft]
    left = start + max(
        (_reach(seat, layout, -1.0) for seat in on if layout.places[element(seat)].x == start), default=0.0
    )
    right = end + max((_reach(seat, layout, 1.0) for seat in on if layout.places[element(seat)].x == end), default=0.0)
    y, offset = layout.heights[shaft], layout.levels[shaft] * glyphs.HOLLOW
    for height in {y - offset, y + offset}:
        glyphs.line(axes, [(left, height), (right, height)], glyphs.BOLD if offset == 0.0 else glyphs.LINE)


def _reach(seat: Attachment, layout: Layout, outward: float) -> float:
    """Return how far a shaft goes beyond the middle of its last column [mm]; a carrier's shaft ends at its arm."""
    if not seat.stage:
        return 0.0
    width = layout.widths[seat.stage]
    half = max(width * layout.scale, glyphs.LEAST_WIDTH) / 2.0
    inward = {Role.SUN: 0.0, Kind.CARRIER: half + 2.5, Role.RING: half + 5.0}
    if seat.member in inward:
        # The shaft comes from the side away from `outward`.
        return -outward * inward[seat.member]
    return outward * (2.0 * half + STUB)


def drawn_radii(mesh: Mesh, layout: Layout) -> tuple[float, float]:
    """Return the radii on paper of a pair's gears [mm]: in their true ratio, meeting between their axes.

    Args:
        mesh: Of a pair.
        layout: Where everything stands.
    """
    first, second = (layout.outlines[gear].radius for gear in mesh.gears)
    scale = abs(layout.heights[mesh.nodes[0]] - layout.heights[mesh.nodes[1]]) / centre_distance(mesh, layout.outlines)
    return first * scale, second * scale


def _draw_pairs(axes: Axes, train: Train, layout: Layout) -> None:
    reach: dict[tuple[str, str, str], dict[float, float]] = {}
    count: dict[tuple[str, str, str], int] = {}
    for mesh in pair_meshes(train):
        for k, radius in enumerate(drawn_radii(mesh, layout)):
            shaft, partner = mesh.nodes[k], mesh.nodes[1 - k]
            up = 1.0 if layout.heights[partner] > layout.heights[shaft] else -1.0
            width = max(layout.outlines[mesh.gears[k]].width * layout.scale, glyphs.LEAST_WIDTH)
            if mesh.sign == INTERNAL and k == 1:
                at = (layout.places[mesh.stage].x, layout.heights[shaft])
                glyphs.internal_wheel(axes, at, up * radius, width)
                continue
            key = (mesh.stage, mesh.gears[k], shaft)
            reach.setdefault(key, {})[up] = radius
            count[key] = mesh.count
    for (stage, gear, shaft), sides in reach.items():
        down, up = (sides.get(side, min(sides.values())) for side in (-1.0, 1.0))
        width = max(layout.outlines[gear].width * layout.scale, glyphs.LEAST_WIDTH)
        at = (layout.places[stage].x, layout.heights[shaft])
        glyphs.wheel(axes, at, (down, up), width=width, halves=count[stage, gear, shaft], role=train.gear(gear).role)


def gear_sides(train: Train, layout: Layout) -> Iterator[tuple[str, float, float]]:
    """Yield every gear with the point (x, y) of its middle beside which there is room for its tooth number [mm].

    Args:
        train: The graph.
        layout: Where everything stands.
    """
    for gear in train.gears:
        x, outlines = layout.places[gear.stage].x, layout.outlines
        if gear.role in SIDES:
            yield gear.name, x, layout.heights[gear.nodes[0]] + 0.6 * _drawn_radius(gear, train, layout)
            continue
        seats = [seat for seat in attachments(train) if seat.stage == gear.stage and seat.shaft != GROUND]
        if gear.own:
            bar = next(bar for bar in bars(train, layout, gear.stage) if bar.gear is gear)
            above = bar.middle + 0.6 * bar.radius if gear.role is not Role.RING else bar.radius
            yield gear.name, bar.left + bar.width / 2.0, layout.heights[seats[0].shaft] + above
            continue
        sun, planet = (outlines[train.gear_of(gear.stage, role).name].radius for role in (Role.SUN, Role.PLANET))
        share = {Role.SUN: 0.7 * sun, Role.PLANET: sun + 1.5 * planet, Role.RING: outlines[gear.name].radius}[gear.role]
        yield gear.name, x, layout.heights[seats[0].shaft] + share * layout.scale


def _drawn_radius(gear: Gear, train: Train, layout: Layout) -> float:
    mesh = next(mesh for mesh in pair_meshes(train) if gear.name in mesh.gears)
    return drawn_radii(mesh, layout)[mesh.gears.index(gear.name)]


# ----------------------------------------------------------------------------------------------------------------------
# Power on its way through a train: what each stretch of each shaft carries, and which machines it comes from.
# ----------------------------------------------------------------------------------------------------------------------


NOTHING = 1e-9
"""Power that is not drawn, over the largest [-]."""


@dataclass(frozen=True)
class Stretch:
    """A piece of a shaft between two neighbouring columns, or the step from a part to its shaft."""

    shaft: str
    start: float
    """Left end [mm]."""
    end: float
    """Right end [mm]."""
    speed: float
    """[rad/s]"""
    torque: float
    """Inside the shaft [N m]."""
    power: float
    """To the right [W]."""
    sources: Mapping[str, float]
    """Machine -> share of the power [-]."""


@dataclass(frozen=True)
class Feed:
    """Power between a part and the shaft that it sits on."""

    branch: Branch
    x: float
    """Column [mm]."""
    sources: Mapping[str, float]
    """Machine -> share of the power [-]."""


class Traced(NamedTuple):
    """The power of a load case on its way."""

    stretches: list[Stretch]
    """Of all shafts."""
    feeds: list[Feed]
    """Of all parts."""


Node = tuple[str, float]
"""Shaft and column, or the name of a part with no column."""


class Edge(NamedTuple):
    """Power from one place to another."""

    origin: Node
    """Whence it comes."""
    to: Node
    """Where it goes."""
    power: float
    """Not negative [W]."""


def trace_power(train: Train, flow: PowerFlow, layout: Layout) -> Traced:
    """Return what every stretch of every shaft carries, and what every part gives to its shaft, with the sources.

    Power that meets at a place mixes: what goes on has the shares of what came in.

    Args:
        train: The graph.
        flow: The load case.
        layout: Where everything stands.
    """
    on = [branch for branch in branches(train, flow) if branch.shaft != GROUND]
    pieces = [piece for shaft in layout.spans for piece in _pieces(shaft, on, flow, layout)]
    edges = [_directed((piece.shaft, piece.start), (piece.shaft, piece.end), piece.power) for piece in pieces]
    edges += [_directed((_part(branch), 0.0), (branch.shaft, _column(branch, layout)), branch.power) for branch in on]
    largest = max((edge.power for edge in edges), default=0.0)
    shares = _shares([edge for edge in edges if edge.power > NOTHING * largest], list(train.machines))
    stretches = [
        replace(piece, sources=shares.get((piece.shaft, piece.start if piece.power > 0.0 else piece.end), {}))
        for piece in pieces
    ]
    feeds = [Feed(branch, _column(branch, layout), shares.get(_upstream(branch, layout), {})) for branch in on]
    return Traced(stretches, feeds)


def _part(branch: Branch) -> str:
    return branch.stage or branch.part.name


def _column(branch: Branch, layout: Layout) -> float:
    return layout.places[_part(branch)].x


def _upstream(branch: Branch, layout: Layout) -> Node:
    return (_part(branch), 0.0) if branch.power > 0.0 else (branch.shaft, _column(branch, layout))


def _pieces(shaft: str, on: Sequence[Branch], flow: PowerFlow, layout: Layout) -> Iterator[Stretch]:
    """Yield every piece of a shaft with what the parts to its left give, its sources still open."""
    columns = sorted({_column(branch, layout) for branch in on if branch.shaft == shaft})
    for start, end in pairwise(columns):
        left = [branch for branch in on if branch.shaft == shaft and _column(branch, layout) <= start]
        torque, power = sum(branch.torque for branch in left), sum(branch.power for branch in left)
        yield Stretch(shaft, start, end, flow.speeds[shaft], torque, power, {})


def _directed(origin: Node, to: Node, power: float) -> Edge:
    return Edge(origin, to, power) if power >= 0.0 else Edge(to, origin, -power)


def _shares(edges: Sequence[Edge], machines: Sequence[str]) -> dict[Node, dict[str, float]]:
    """Return place -> machine -> share of the power there: mixing, solved at once as power may circle."""
    nodes = list(dict.fromkeys(node for edge in edges for node in (edge.origin, edge.to)))
    number = {node: k for k, node in enumerate(nodes)}
    matrix, sources = np.eye(len(nodes)), np.zeros((len(nodes), len(machines)))
    inflow = np.zeros(len(nodes))
    for edge in edges:
        inflow[number[edge.to]] += edge.power
    for edge in edges:
        matrix[number[edge.to], number[edge.origin]] -= edge.power / inflow[number[edge.to]]
    for k, name in enumerate(machines):
        if (name, 0.0) in number and inflow[number[name, 0.0]] == 0.0:
            sources[number[name, 0.0], k] = 1.0
    solved = np.linalg.lstsq(matrix, sources, rcond=None)[0] if nodes else sources
    return {node: {name: float(solved[k, j]) for j, name in enumerate(machines) if solved[k, j] > NOTHING}
            for node, k in number.items()}  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The power flow on a skeleton: bands as wide as the power, in the colours of the machines that it comes from.
# ----------------------------------------------------------------------------------------------------------------------


WIDEST = 9.0
"""Band of the largest power [mm]."""
ABOVE_GEARS = 4.6
"""Layer of power that goes through a mesh."""
HEAD = 3.0
"""Length of an arrow head [mm]."""


@dataclass(frozen=True)
class PowerPen:
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


def draw_bands(pen: PowerPen, train: Train, flow: PowerFlow, *, layout: Layout, traced: Traced) -> None:
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


def half_width(stretch: Stretch, pen: PowerPen, layout: Layout, stretches: Sequence[Stretch]) -> float:
    """Return how far a stretch's band reaches from its axis, the bands inside it included [mm].

    Args:
        stretch: The stretch.
        pen: How power is drawn.
        layout: Where everything stands.
        stretches: Of all shafts.
    """
    return _inside(stretch, pen, layout, stretches) + abs(stretch.power) * pen.scale / 2.0


def _inside(stretch: Stretch, pen: PowerPen, layout: Layout, stretches: Sequence[Stretch]) -> float:
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


def _along(pen: PowerPen, stretch: Stretch, layout: Layout, stretches: Sequence[Stretch]) -> None:
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


def _across(pen: PowerPen, x: float, power: float, *, start: float, end: float, shares: Mapping[str, float]) -> None:
    """Draw power from one height to another."""
    width = power * pen.scale
    left = x - width / 2.0
    for name, share in shares.items():
        _patch(pen, (left, min(start, end), share * width, abs(end - start)), name, ABOVE_GEARS)
        left += share * width
    middle, head = (start + end) / 2.0, HEAD if end > start else -HEAD
    tip = [(x - 1.6, middle - head / 2.0), (x + 1.6, middle - head / 2.0), (x, middle + head / 2.0)]
    pen.axes.shape(tip, fc=theme.INK, lw=0.0, zorder=6)


def _around(pen: PowerPen, at: tuple[float, float], feed: Feed) -> None:
    """Draw arrow heads inside a machine that its shaft goes through: towards the shaft if it drives."""
    colour = pen.colours.get(feed.branch.part.name, theme.MUTED)
    if feed.branch.power == 0.0:
        return
    for up in (1.0, -1.0):
        middle = at[1] + up * 7.25
        tip = -up * HEAD / 2.0 if feed.branch.power > 0.0 else up * HEAD / 2.0
        corners = [(at[0] - 2.0, middle - tip), (at[0] + 2.0, middle - tip), (at[0], middle + tip)]
        pen.axes.shape(corners, fc=colour, lw=0.0, zorder=6.3)


def _patch(pen: PowerPen, box: tuple[float, float, float, float], name: str, layer: float = 2.0) -> None:
    left, low, width, height = box
    pen.axes.rectangle((left, low), width, height, fc=tinted(pen.colours[name]), lw=0.0, zorder=layer)


# ----------------------------------------------------------------------------------------------------------------------
# The two schematics: the skeleton of any train, and the power flow of a load case on it.
# ----------------------------------------------------------------------------------------------------------------------


BORDER = 4.0
"""Around the drawing [mm]."""
_NOT_TRUE = "Parallel paths meet again: each mesh is in its true ratio, the axes are not to one scale."
_HANGING = (12.0, 16.0, 20.0, 26.0, 32.0, 40.0)
"""Distances from an axis at which a machine's name is tried [mm]."""


@theme.drawn
def schematic_figure(source: Train | Sizing) -> Figure:
    """Return the skeleton of a train: to scale where it is sized, in common proportions otherwise.

    Args:
        source: A train, or a sizing of one.
    """
    board, train, layout, kinds = _start(source)
    draw_train(board.axes, train, layout, kinds=kinds)
    board.take_parts()
    _name_machines(board, train, layout, {name: name for name in train.machines})
    _name_shafts(board, layout)
    if isinstance(source, Sizing):
        _number_teeth(board, train, layout, source)
    _caption_stages(board, layout, source if isinstance(source, Sizing) else None)
    scale = f"Radii and face widths 1 : {1e3 / layout.scale:.1f}" if isinstance(source, Sizing) else "Not to scale"
    title = source.design.name if isinstance(source, Sizing) else "Train"
    return _finish(board, [title, scale if layout.exact else _NOT_TRUE], {})


@theme.drawn
def power_flow_figure(sizing: Sizing, case: str) -> Figure:
    """Return the power flow of a case on the skeleton: bands as wide as the power, kW, N m and rpm on every branch.

    Args:
        sizing: As sized.
        case: Load case.
    """
    flow = by_name(case, sizing.flows, "case")
    board, train, layout, kinds = _start(sizing)
    traced = trace_power(train, flow, layout)
    pen = PowerPen(board.axes, band_scale(traced), source_colours(train, flow, kinds))
    opened = [joint.name for joint in train.joints if joint.name not in flow.joints]
    draw_train(board.axes, train, layout, kinds=kinds, open_clutches=opened)
    draw_bands(pen, train, flow, layout=layout, traced=traced)
    board.take_parts()
    _name_machines(board, train, layout, _machine_texts(traced.feeds, layout))
    _label_stretches(board, pen, layout, traced.stretches)
    _number_teeth(board, train, layout, sizing)
    _caption_stages(board, layout, sizing)
    legend = {f"{name} {text(flow.machine_powers[name], 'power')}": colour for name, colour in pen.colours.items()}
    heading = [sizing.design.name, f"Power flow, case {case}", *_losses(flow), *([] if layout.exact else [_NOT_TRUE])]
    return _finish(board, heading, legend)


def _start(source: Train | Sizing) -> tuple[Board, Train, Layout, Mapping[str, str]]:
    sized = source if isinstance(source, Sizing) else None
    train = sized.train if sized else source
    assert isinstance(train, Train)
    kinds = {machine.name: machine.kind for machine in sized.machines} if sized else {}
    layout = lay_out(train, sized.gears if sized else (), kinds)
    axes = Axes()
    axes.set_axis_off()
    return Board(axes), train, layout, kinds


def _losses(flow: PowerFlow) -> list[str]:
    return [f"Lost in the meshes: {text(flow.loss, 'power')}"] if flow.loss else []


def _machine_texts(feeds: Sequence[Feed], layout: Layout) -> dict[str, str]:
    """Return machine -> name; with its power and torque where its shaft goes through, as no stretch shows them."""
    texts = {}
    for feed in feeds:
        if feed.branch.part.kind is Kind.MACHINE:
            start, end = layout.spans[feed.branch.shaft]
            alone = start < feed.x < end or start == end
            values = [text(abs(feed.branch.power), "power"), _torque(feed.branch.torque)]
            name = feed.branch.part.name
            texts[name] = "\n".join([name, *(values if alone else [])])
    return texts


def _name_machines(board: Board, train: Train, layout: Layout, texts: Mapping[str, str]) -> None:
    for name, words in texts.items():
        x, y = layout.places[name].x, layout.heights[train.machines[name]]
        depth = 1.5 * len(words.split("\n"))
        places = [(x, y + side * (away + depth)) for away in _HANGING for side in (-1.0, 1.0)]
        board.place(words, places, size=7.0, bold=True)


def _name_shafts(board: Board, layout: Layout) -> None:
    for shaft, (start, end) in layout.spans.items():
        gaps = [gap for gap in layout.gaps() if start < gap < end] or [(start + end) / 2.0]
        y = layout.heights[shaft]
        places = [(gap, y + side * away) for gap in gaps for away in (2.5, 4.5, 7.0, 10.0) for side in (1.0, -1.0)]
        board.place(shaft, places, colour=theme.MUTED)


def _label_stretches(board: Board, pen: PowerPen, layout: Layout, stretches: Sequence[Stretch]) -> None:
    """Write kW and N m at every stretch, and the shaft's name and speed at its first."""
    fastest = max((abs(stretch.speed) for stretch in stretches), default=0.0)
    largest = max((abs(stretch.power) for stretch in stretches), default=0.0)
    strongest = max((abs(stretch.torque) for stretch in stretches), default=0.0)
    for place, stretch in enumerate(stretches):
        first = all(other.shaft != stretch.shaft for other in stretches[:place])
        lines = [stretch.shaft, text(_clean(stretch.speed, fastest), "speed").replace("-", "−")] if first else []
        lines += [text(_clean(abs(stretch.power), largest), "power"), _torque(_clean(stretch.torque, strongest))]
        clear = half_width(stretch, pen, layout, stretches) + 1.0 + len(lines) * 1.5
        y = layout.heights[stretch.shaft]
        away = [(spot, y + side * (clear + more)) for spot in spots(stretch, layout)
                for more in (0.0, 3.0, 6.0, 10.0, 15.0) for side in (1.0, -1.0)]  # fmt: skip
        board.place("\n".join(lines), away, bold=first)


def _torque(value: float) -> str:
    """Return a torque as people read it: in kN m from 100 000 N m on."""
    size = abs(value)
    return f"{size / 1e3:.4g} kN m" if size >= 1e5 else text(size, "torque")


def _clean(value: float, largest: float) -> float:
    """Return zero for what is only rounding beside the largest value."""
    return value if abs(value) > NOTHING * largest else 0.0


def _number_teeth(board: Board, train: Train, layout: Layout, sizing: Sizing) -> None:
    """Write the tooth number beside every gear, on the side that is free."""
    for gear, x, y in gear_sides(train, layout):
        half = layout.places[train.gear(gear).stage].half
        words = f"$z$ {sizing.teeth[gear]}"
        reach = text_width(words, 6.0, math=True) / 2.0 + 1.0
        width = layout.outlines[gear].width * layout.scale / 2.0
        away = [(x + side * (width * k + reach), y + up) for k in (1.0, 2.1) for up in (0.0, 2.0, -2.0, 4.0, -4.0)
                for side in (-1.0, 1.0) if width * k < half]  # fmt: skip
        board.place(words, away, size=6.0, colour=theme.MUTED)


def _caption_stages(board: Board, layout: Layout, sizing: Sizing | None) -> None:
    """Write tooth numbers, module and width below the drawing, stages of one column one below the other."""
    floor = board.extent()[1] - 2.0
    below: dict[float, float] = {}
    stages = dict.fromkeys(gear.stage for gear in sizing.gears) if sizing else {}
    for stage in stages:
        assert sizing is not None
        words = "\n".join([stage, *_stage_lines(sizing, stage)])
        x, height = layout.places[stage].x, len(words.split("\n")) * 6.5 * 1.3 * theme.INCH / 72.0
        low = below.get(x, floor)
        board.place(words, [(x, low - height / 2.0)], bold=True)
        below[x] = low - height - 2.0


def _stage_lines(sizing: Sizing, stage: str) -> list[str]:
    gears = [gear for gear in sizing.gears if gear.stage == stage]
    if not gears:
        return []
    teeth = {gear.role: gear.teeth for gear in gears}
    lines = [f"{gear.bodies} planets" for gear in gears if gear.role is Role.PLANET and not gear.own]
    if stage in sizing.design.epicyclics:
        lines.append(f"{sizing.design.epicyclics[stage].sets} sets of planets")
    elif Role.RING in teeth:
        lines.append(f"$1 + z_r/z_s$ = {1.0 + teeth[Role.RING] / teeth[Role.SUN]:.4g}")
    else:
        pinion, wheel = next(mesh.gears for mesh in sizing.train.meshes if mesh.stage == stage)
        lines.append(f"$z_2/z_1$ = {sizing.teeth[wheel] / sizing.teeth[pinion]:.4g}")
    lines.append(f"$m_n$ {written(shown(gears[0].module, 'length'), 3)} mm")
    lines.append(f"$b$ {written(shown(gears[0].face_width, 'length'), 3)} mm")
    return lines


def _finish(board: Board, heading: Sequence[str], legend: Mapping[str, str]) -> Figure:
    """Write heading and legend above the drawing and cut the paper to what is on it."""
    axes = board.axes
    left, low, right, high = board.extent()
    x, y = left, high + 6.0
    for name, colour in legend.items():
        axes.rectangle((x, y - 1.2), 5.0, 2.6, fc=tinted(colour), lw=0.0)
        axes.text(x + 6.5, y, name, va="center_baseline", fontsize=7.0)
        x += text_width(name, 7.0) + 14.0
    y += 5.0 if legend else 0.0
    for k, words in enumerate(reversed(heading)):
        is_title = k == len(heading) - 1
        axes.text(left, y, words, va="center_baseline", fontsize=9.0 if is_title else 7.0,
                  weight="bold" if is_title else "normal")  # fmt: skip
        y += 5.0
    right = max(right, x - 8.0, left + max(text_width(words, 9.0) for words in heading))
    axes.set(xlim=(left - BORDER, right + BORDER), ylim=(low - BORDER, y + BORDER - 3.0))
    figure = Figure(right - left + 2.0 * BORDER, y - 3.0 - low + 2.0 * BORDER, bare=True, title=": ".join(heading[:2]))
    figure.slots = [Slot(axes, 0, 0)]
    return figure
