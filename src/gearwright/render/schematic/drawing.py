"""The skeleton of a train on paper: its shafts, planetary sets, pairs, clutches and machines."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from gearwright.identity import SIDES, Kind, Role
from gearwright.render.schematic import glyphs
from gearwright.render.schematic.compound import bars, draw_compound, is_compound
from gearwright.render.schematic.layout import Layout, centre_distance, element, pair_meshes
from gearwright.render.vector.axes import Axes
from gearwright.spec import GROUND
from gearwright.train import INTERNAL, Attachment, Gear, Mesh, Train, attachments

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
