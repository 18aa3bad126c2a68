"""Arrangement of axes, gears and bearings, hands of helices, and the envelope of the gearbox.

What loads them there is for `loads`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from types import MappingProxyType
from typing import Annotated

import numpy as np

from gearwright.base import (
    SIDES,
    DesignError,
    Floats,
    Origin,
    Problem,
    Quantity,
    Role,
    Volume,
    apart,
    carrier_part,
    near,
    refuse,
    text,
)
from gearwright.parts.bearings import LoadFactors, taper_pair_thrusts
from gearwright.sizing.axis_order import (
    Axle,
    Way,
    axles_of,
    best_way,
    both_sides,
    spans_a_set,
    stretched,
)
from gearwright.sizing.gear_geometry import rollings
from gearwright.sizing.rating import Context
from gearwright.sizing.result import Arrangement, GearSizing, ShaftPlan, Sizing
from gearwright.spec import Pair
from gearwright.spec.design import LOCATES, NOTHING_GIVEN, SIDE_ANGLES, BearingSeat, Design, ShaftLayout
from gearwright.train import PowerFlow, Train

# ----------------------------------------------------------------------------------------------------------------------
# Where the axes of the shafts stand in the cross-section, so that every mesh force has a direction.
#
# A place is a complex number y + i z [m], seen along x. Shafts joined by a planetary set, clutch or damper share an
# axis. The first shaft of the design stands at the origin. A shaft in mesh with one that is placed stands at their
# centre distance from it, in the direction of its ``angle``. Where none is given, the shafts around one gear are
# evenly spaced; two stand opposite each other, so that their forces on that gear cancel (Pulvirenti 2023, eq. 2.9).
#
# Two layshafts between several gears (the input's, the output's, a motor's) make triangles: they stand opposite each
# other about the gear with the shortest centre distance a_min, and another gear with centre distance a has its axis at
# √(a² − a_min²) from that one, square to the line of the layshafts. That keeps the wheels on the layshafts as far apart
# as the train allows, and clear of the other axes. A shaft tied to two placed axes stands where their circles cross: at
# the crossing in the direction of its ``angle``, or, where none is given, at the one that is farther from all other
# axes (the lower one, −z, where both are equally far).
# ----------------------------------------------------------------------------------------------------------------------


TOLERANCE = 0.01
"""Part of a centre distance that a change of profile shifts is trusted to take up; more does not close."""
TOUCHING = 1e-6
"""Half of what parts two crossings over a centre distance, below which they are one [-]: beyond that a last digit of a
module would say on which side of an axis the next one stands."""


@dataclass(frozen=True)
class Bond:
    """One mesh of a pair, as a distance between two axes."""

    stage: str
    axes: tuple[str, str]
    """Shafts that name the two axes."""
    distance: float
    """Centre distance [m]."""

    def other(self, axis: str) -> str:
        """Return the axis at the other end."""
        return self.axes[1] if self.axes[0] == axis else self.axes[0]


def axes_of(context: Context, gears: tuple[GearSizing, ...], angles: Mapping[str, float]) -> dict[str, complex]:
    """Return where the axis of every shaft stands, y + i z [m].

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].

    Raises:
        DesignError: If the centre distances do not close.
    """
    asked = _asked(context.design, angles)
    axis = shared_axes(context.design)
    faces = {name for name, pair in context.design.pairs.items() if pair.kind == "face"}
    bonds = list(_bonds(context, axis, {gear.name: gear for gear in gears}, faces))
    placed: dict[str, complex] = {}
    while len(placed) < len(set(axis.values())):
        placed |= _next(asked, bonds, placed, [shaft for shaft in axis.values() if shaft not in placed])
    _close(bonds, placed)
    return {shaft: placed[axis[shaft]] for shaft in context.design.shafts}


def shared_axes(design: Design) -> dict[str, str]:
    """Return shaft -> the first shaft on the same axis.

    Args:
        design: As read.
    """
    axis = {name: name for name in design.shafts}
    groups = [stage.members for stage in design.sets.values()]
    for group in (*groups, *((link.driving, link.driven) for link in design.links.values())):
        joined = {axis[name] for name in group if name in axis}
        first = min(joined, key=design.shafts.index)
        axis = {name: first if root in joined else root for name, root in axis.items()}
    return axis


def _bonds(
    context: Context, axis: Mapping[str, str], gears: Mapping[str, GearSizing], faces: Collection[str]
) -> Iterator[Bond]:
    rolls = rollings(context, gears)
    for mesh in context.train.meshes:
        if mesh.nodes[0] not in axis or mesh.nodes[1] not in axis:
            continue
        ends = (axis[mesh.nodes[0]], axis[mesh.nodes[1]])
        if ends[0] == ends[1]:
            message = (
                f"{mesh.nodes[0]!r} and {mesh.nodes[1]!r} share an axis, so their gears cannot mesh; use a layshaft"
            )
            raise DesignError([Problem(f"pairs.{mesh.stage}", message)])
        # The pinion of a face gear lies across: the middle of its face, not its axis, is on the wheel's pitch circle.
        apart = rolls[mesh.name].radii[1] if mesh.stage in faces else rolls[mesh.name].centre_distance
        yield Bond(mesh.stage, ends, apart)


def _next(
    asked: Mapping[str, float], bonds: list[Bond], placed: Mapping[str, complex], waiting: Sequence[str]
) -> dict[str, complex]:
    """Return the next axes that can be placed."""
    ties = {name: [bond for bond in bonds if name in bond.axes and bond.other(name) in placed] for name in waiting}
    for name in waiting:
        known: dict[complex, float] = {}
        for bond in ties[name]:
            place = placed[bond.other(name)]
            if all(abs(place - centre) > TOLERANCE * bond.distance for centre in known):
                known[place] = bond.distance
        if len(known) > 1:
            return {name: _crossing(known, placed, asked.get(name))}
    for name in waiting:
        if ties[name]:
            return _around(asked, bonds, placed, tie=ties[name][0], name=name)
    return {waiting[0]: 0j}


def _asked(design: Design, angles: Mapping[str, float]) -> dict[str, float]:
    """Return shaft -> direction of its axis from its mate [rad]: as given, as found, or the middle of its side."""
    sides = {name: SIDE_ANGLES[layout.side] for name, layout in design.layout.items() if layout.side is not None}
    given = {name: layout.angle for name, layout in design.layout.items() if layout.angle is not None}
    return {**sides, **angles, **given}


def _around(
    asked: Mapping[str, float], bonds: list[Bond], placed: Mapping[str, complex], *, tie: Bond, name: str
) -> dict[str, complex]:
    """Return the places of all shafts that a pair sets around one placed axis."""
    hub = tie.other(name)
    ring = {bond.other(hub): bond.distance for bond in bonds if bond.stage == tie.stage and hub in bond.axes}
    drop = math.acos(_half_distance(bonds, ring) / tie.distance) if len(ring) == 2 else 0.0
    even = {shaft: 2.0 * math.pi * k / len(ring) + (drop if k else -drop) for k, shaft in enumerate(ring)}
    turns = [cmath.phase(placed[shaft] - placed[hub]) - even[shaft] for shaft in ring if shaft in placed]
    places = {}
    for shaft, distance in ring.items():
        angle = asked.get(shaft)
        if angle is None:
            angle = even[shaft] + (turns[0] if turns else 0.0)
        places[shaft] = placed[hub] + cmath.rect(distance, angle)
    return {shaft: place for shaft, place in places.items() if shaft not in placed}


def _half_distance(bonds: list[Bond], ring: Mapping[str, float]) -> float:
    """Return the shortest centre distance of all axes that mesh with both of two shafts: half of what parts them."""
    first, second = (_reach(bonds, name) for name in ring)
    return min(min(first[hub], second[hub]) for hub in first.keys() & second.keys())


def _reach(bonds: list[Bond], name: str) -> dict[str, float]:
    """Return axis -> shortest centre distance from another one [m]; where two pairs differ, `_close` says so."""
    reach: dict[str, float] = {}
    for bond in bonds:
        if name in bond.axes:
            reach[bond.other(name)] = min(bond.distance, reach.get(bond.other(name), math.inf))
    return reach


def _crossing(known: Mapping[complex, float], placed: Mapping[str, complex], angle: float | None) -> complex:
    """Return where two circles about placed axes cross, or come nearest; `_close` judges how near that is."""
    (one, first), (other, second) = list(known.items())[:2]
    apart = abs(other - one)
    along = (first**2 - second**2 + apart**2) / (2.0 * apart)
    across = math.sqrt(max(first**2 - along**2, 0.0))
    if across < TOUCHING * first:
        across = 0.0
    direction = (other - one) / apart
    sides = [one + direction * complex(along, side) for side in (across, -across)]
    if angle is not None:
        return max(sides, key=lambda place: ((place - one) * cmath.rect(1.0, -angle)).real)
    fits = [place for place in sides if _fit(place, known)] or sides
    rest = [place for place in placed.values() if place not in (one, other)]

    def alone(place: complex) -> float:
        return min((abs(place - neighbour) for neighbour in rest), default=0.0)

    return max(fits, key=lambda place: (round(alone(place), 9), -place.imag))


def _fit(place: complex, known: Mapping[complex, float]) -> bool:
    return all(abs(abs(place - centre) - distance) <= TOLERANCE * distance for centre, distance in known.items())


def _close(bonds: list[Bond], placed: Mapping[str, complex]) -> None:
    """Refuse centre distances that the axes do not keep."""
    problems = []
    for bond in bonds:
        first, second = bond.axes
        stand = abs(placed[first] - placed[second])
        if abs(stand - bond.distance) > TOLERANCE * bond.distance:
            here, asked = apart(stand, bond.distance, "length")
            message = (
                f"the axes of {first!r} and {second!r} stand {here} apart where their other meshes put them, but the"
                f" gears ask {asked}; change an angle in [layout], give a module_mm that closes the triangle, or write"
                " coaxial_with where two pairs lie on the same axes"
            )
            problems.append(Problem(f"pairs.{bond.stage}", message))
    refuse(problems)


# ----------------------------------------------------------------------------------------------------------------------
# The bearings of one shaft as the design seats them, and how they share the force along it.
# ----------------------------------------------------------------------------------------------------------------------


_NOTHING = 1e-9
"""Axial over radial force below which it is rounding [-]."""


def seats_of(design: Design, shaft: str) -> dict[str, BearingSeat]:
    """Return the bearings of a shaft by name, in order along it.

    Args:
        design: The design.
        shaft: Name of the shaft.
    """
    seats = {name: seat for name, seat in design.bearings.items() if seat.shaft == shaft}
    return dict(sorted(seats.items(), key=lambda item: item[1].position))


def radial_places(seats: Mapping[str, BearingSeat]) -> tuple[float, float] | None:
    """Return where the two radial bearings of a shaft stand [m]; None where the design gives it no bearings.

    Args:
        seats: From `seats_of`.
    """
    places = [seat.position for seat in seats.values() if seat.radial]
    return (places[0], places[1]) if len(places) == 2 else None


def axial_forces(
    shaft: str,
    seats: Mapping[str, BearingSeat],
    axial: Floats,
    *,
    radial: Mapping[str, Floats],
    factors: Mapping[str, LoadFactors],
    cases: tuple[str, ...],
) -> dict[str, Floats]:
    """Return the axial force in every bearing of a shaft [N], (cases,) each.

    A force goes to the bearing that locates the shaft towards it. Two taper bearings take what `taper_pair_thrusts`
    makes of it and of their radial loads.

    Args:
        shaft: Name of the shaft.
        seats: Its bearings, from its plan.
        axial: Force along the shaft in every case, positive towards its second end [N].
        radial: Bearing -> its radial force in every case [N].
        factors: Taper bearing -> its e, X, Y.
        cases: Names of the load cases.

    Raises:
        DesignError: If nothing takes a force along the shaft.
    """
    tapers = {LOCATES[seat.locates][0]: name for name, seat in seats.items() if seat.kind == "taper"}
    taken = {name: np.zeros_like(axial) for name in seats}
    if len(tapers) == 2:
        second, first = tapers[1], tapers[-1]
        for k, force in enumerate(axial):
            pair = (float(radial[second][k]), float(radial[first][k]))
            thrusts = taper_pair_thrusts(pair, float(force), (factors[second], factors[first]))
            taken[second][k], taken[first][k] = thrusts
        return taken
    largest = max(float(np.max(force)) for force in radial.values())
    for sign in (-1, 1):
        pushed = np.maximum(sign * axial, 0.0)
        if pushed.max() > _NOTHING * largest:
            taken[_taker(shaft, seats, sign, pushed, cases)] += pushed
    return taken


def _taker(shaft: str, seats: Mapping[str, BearingSeat], sign: int, pushed: Floats, cases: tuple[str, ...]) -> str:
    """Return the bearing that takes an axial force of one sign, or say what is missing."""
    for name, seat in seats.items():
        if sign in LOCATES[seat.locates]:
            return name
    end, worst = ("first", "second")[sign > 0], int(np.argmax(pushed))
    able = [name for name, seat in seats.items() if seat.kind != "cylindrical"]
    hint = (
        f'write locates = "both" at {able[0]}'
        if able
        else 'add one of kind = "four-point" with locates = "both" and radial = false'
    )
    message = (
        f"{shaft!r} is pushed towards its {end} end with {text(float(pushed[worst]), 'force')} in case {cases[worst]},"
        f" and no bearing takes that; {hint}"
    )
    raise DesignError([Problem(f"bearings.{able[0] if able else next(iter(seats))}.locates", message)])


# ----------------------------------------------------------------------------------------------------------------------
# Where things sit along a shaft: its gears side by side, its machines at the ends, its two bearings.
#
# Along x, from the end where power enters: driven clutches, turbines and motors; the gears of pairs and the members of
# planetary sets in the order of the design; driving clutches and propellers. The gears of pairs stand between bearings,
# with equal gaps. What gives torque only stands at the end on its side of the gears, or, on a shaft without gears of
# pairs, at equal distances. The design's ``layout`` says otherwise where it must.
# ----------------------------------------------------------------------------------------------------------------------


Moves = Mapping[tuple[str, str], float]
"""Shaft and gear -> how far it stands from where equal gaps put it, along the shaft [m]."""
NO_MOVES: Moves = MappingProxyType({})
"""All gears have equal gaps."""


def plan_of(
    context: Context, name: str, gears: tuple[GearSizing, ...], names: list[str], moves: Moves = NO_MOVES
) -> ShaftPlan:
    """Return where everything on a shaft sits.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        gears: From `size_gears`.
        names: What puts torque on it, in order.
        moves: Of gears, on shafts whose length is open.

    Raises:
        DesignError: If the given length, places or bearings do not fit.
    """
    layout = context.design.layout.get(name, NOTHING_GIVEN)
    widths = {
        gear.name: gear.face_width * gear.bodies / len(gear.shafts)
        for gear in gears
        if name in gear.shafts and gear.role in SIDES
    }
    length = context.given.get(f"{name}.length", _length(context.design, name, widths))
    places = _between_bearings(names, widths, length) if widths else _spread(names, length)
    places |= {part: place.position for part, place in layout.places.items()}
    own = {gear: by for (shaft, gear), by in moves.items() if shaft == name}
    if own:
        length, places = _moved(name, places, widths, length, own)
    seats = seats_of(context.design, name)
    plan = ShaftPlan(length, radial_places(seats) or _bearings(context.design, name, length), places, seats)
    _check(name, layout, plan, names=names, width=sum(widths.values()))
    return plan


def plan_along(context: Context, name: str, length: float, places: Mapping[str, float]) -> ShaftPlan:
    """Return a shaft whose length and places follow from what else is on its axis.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        length: [m].
        places: Of everything on it [m].
    """
    return ShaftPlan(length, _bearings(context.design, name, length), places)


def _bearings(design: Design, name: str, length: float) -> tuple[float, float]:
    """Return the middles of the two radial bearings of a shaft whose bearings the design leaves open [m]."""
    layout = design.layout.get(name, NOTHING_GIVEN)
    seat = min(design.shafting.bearing_length, length / 2.0) / 2.0
    first = seat if layout.first_bearing is None else layout.first_bearing
    return first, length - seat if layout.second_bearing is None else layout.second_bearing


def on_shaft(design: Design, train: Train, shaft: str) -> Iterator[str]:
    """Yield everything that puts torque on a shaft, in the usual order.

    Args:
        design: As read.
        train: Its graph.
        shaft: Name of the shaft.
    """
    yield from (link.name for link in train.links if link.driven == shaft)
    yield from (name for name, machine in design.machines.items() if machine.shaft == shaft and machine.drives)
    for stage in design.stages:
        yield from (gear.name for gear in train.gears if gear.stage == stage and shaft in gear.nodes)
        if stage in design.sets and design.sets[stage].carrier == shaft:
            yield str(carrier_part(stage))
    yield from (link.name for link in train.links if link.driving == shaft)
    yield from (name for name, machine in design.machines.items() if machine.shaft == shaft and not machine.drives)


def _length(design: Design, name: str, widths: Mapping[str, float]) -> float:
    """Return a shaft's length: gears of pairs side by side with gaps, or the standard length between planetary sets."""
    rules = design.shafting
    if widths:
        return sum(widths.values()) + rules.bearing_length * (len(widths) + 1)
    members = sum(name in stage.members for stage in design.sets.values())
    return rules.middle_length if members > 1 else rules.end_length


def _between_bearings(names: list[str], widths: Mapping[str, float], length: float) -> dict[str, float]:
    """Return the places where gears of pairs stand on the shaft: equal gaps between them and at both ends."""
    gap = (length - sum(widths.values())) / (len(widths) + 1)
    places, reached = {}, 0.0
    for name in names:
        if name in widths:
            places[name] = reached + gap + widths[name] / 2.0
            reached += gap + widths[name]
        else:
            places[name] = length if reached else 0.0
    return places


def _moved(
    name: str, places: Mapping[str, float], widths: Mapping[str, float], length: float, moves: Mapping[str, float]
) -> tuple[float, dict[str, float]]:
    """Return length and places with gears moved along a shaft, as far beyond as it must be for the same end gaps."""
    gap = (length - sum(widths.values())) / (len(widths) + 1)
    moved = {gear: places[gear] + moves.get(gear, 0.0) for gear in widths}
    order = sorted(widths, key=moved.__getitem__)
    for before, after in pairwise(order):
        if moved[before] + widths[before] / 2.0 > moved[after] - widths[after] / 2.0 + 1e-9:
            message = f"beside its mate it stands in {before!r}; give both a place of their own"
            raise DesignError([Problem(f"layout.{name}.places.{after}", message)])
    start = min(moved[order[0]] - widths[order[0]] / 2.0 - gap, 0.0)
    end = max(moved[order[-1]] + widths[order[-1]] / 2.0 + gap, length)
    at = {part: moved[part] if part in widths else end if place else start for part, place in places.items()}
    return end - start, {part: place - start for part, place in at.items()}


def _spread(names: list[str], length: float) -> dict[str, float]:
    """Return the places where all give torque only."""
    pieces = max(len(names) - 1, 1)
    return {name: length * k / pieces for k, name in enumerate(names)}


def _check(name: str, layout: ShaftLayout, plan: ShaftPlan, *, names: list[str], width: float) -> None:
    """Refuse what does not fit on a shaft."""
    path, problems, end = f"layout.{name}", [], f"0 to {1e3 * plan.length:.6g} mm"
    if plan.length < width:
        length, least = apart(plan.length, width, "length")
        message = f"{length} is less than the face widths of its gears; give {least} or more"
        problems.append(Problem(f"{path}.length_mm", message))
    for part in layout.places:
        if part not in names:
            problems.append(Problem(f"{path}.places.{part}", f"this is not on the shaft; {near(part, names)}"))
        elif plan.places[part] > plan.length:
            problems.append(Problem(f"{path}.places.{part}.position_mm", _outside(plan.places[part], end)))
    for part in dict.fromkeys(layout.order):
        if part not in names:
            problems.append(Problem(f"{path}.order", f"{part!r} is not on the shaft; {near(part, names)}"))
        elif layout.order.count(part) > 1:
            problems.append(Problem(f"{path}.order", f"{part!r} stands in it more than once; keep one"))
    bearings = dict(zip((f"{path}.first_bearing_mm", f"{path}.second_bearing_mm"), plan.bearings, strict=True))
    if plan.seats:
        bearings = {f"bearings.{seat_name}.position_mm": seat.position for seat_name, seat in plan.seats.items()}
    for key, place in bearings.items():
        if not 0.0 <= place <= plan.length:
            problems.append(Problem(key, _outside(place, end)))
    if plan.bearings[0] == plan.bearings[1]:
        message = f"both bearings stand at {1e3 * plan.bearings[0]:.6g} mm; give two different places"
        problems.append(Problem(f"{path}.second_bearing_mm", message))
    refuse(problems)


def _outside(position: float, allowed: str) -> str:
    return f"{1e3 * position:.6g} mm is outside the shaft; allowed: {allowed}"


# ----------------------------------------------------------------------------------------------------------------------
# The arrangement of a transmission whose gears are sized, found once.
# ----------------------------------------------------------------------------------------------------------------------


NO_ANGLES: Mapping[str, float] = MappingProxyType({})
"""Nothing is turned."""


def arrange(
    context: Context,
    gears: tuple[GearSizing, ...],
    angles: Mapping[str, float] = NO_ANGLES,
    moves: Moves = NO_MOVES,
) -> Arrangement:
    """Return where the axes of all shafts stand, and where everything sits along every shaft.

    Args:
        context: What sizing reads.
        gears: From `size_gears`.
        angles: Shaft -> direction of its axis from its mate, where the design leaves it open [rad].
        moves: Shaft and gear -> how far it stands from equal gaps, along the shaft [m].

    Raises:
        DesignError: If axes do not close, or gears, places or bearings do not fit on their shafts.
    """
    axes = axes_of(context, gears, angles)
    listed = {name: _listed(context, name) for name in context.design.shafts}
    ways = [(axle, best_way(axle)) for axle in axles_of(context, shared_axes(context.design), listed)]
    plans: dict[str, ShaftPlan] = {}
    problems: list[Problem] = []
    for name, names in _ordered(listed, ways).items():
        try:
            plans[name] = plan_of(context, name, gears, names, moves)
        except DesignError as error:
            problems += error.problems
    refuse(problems)
    found = Arrangement(axes, plans)
    for axle, way in ways:
        found = _with(context, gears, found, axle, way)
    return found


def axles_in(context: Context) -> tuple[Axle, ...]:
    """Return what stands on every axis that several shafts share and whose bearings the design leaves open.

    Args:
        context: What sizing reads.
    """
    listed = {name: _listed(context, name) for name in context.design.shafts}
    return axles_of(context, shared_axes(context.design), listed)


def _listed(context: Context, shaft: str) -> tuple[str, ...]:
    """Return everything on a shaft in the usual order, what the design puts in order in that one."""
    names = tuple(on_shaft(context.design, context.train, shaft))
    layout = context.design.layout.get(shaft, NOTHING_GIVEN)
    if not layout.order:
        return names
    wished = (label for label in layout.order if label in names)
    return tuple(next(wished) if label in layout.order else label for label in names)


def _ordered(listed: Mapping[str, tuple[str, ...]], ways: Sequence[tuple[Axle, Way | None]]) -> dict[str, list[str]]:
    """Return shaft -> what stands on it, in the order of its axis; gears of pairs keep theirs."""
    found = {shaft: list(names) for shaft, names in listed.items()}
    for axle, way in ways:
        if way is not None:
            rank = {pair: k for k, token in enumerate(way.order) for pair in axle.tokens[token].labels}
            for shaft in axle.shafts:
                found[shaft].sort(key=lambda label, shaft=shaft: rank[shaft, label])  # type: ignore[misc]
    return found


def _with(
    context: Context, gears: tuple[GearSizing, ...], arrangement: Arrangement, axle: Axle, way: Way | None
) -> Arrangement:
    """Return an arrangement with what one axis adds to it."""
    if way is None:
        return replace(arrangement, unordered=(*arrangement.unordered, axle.shafts))
    if not spans_a_set(axle, way):
        return arrangement
    plans = dict(arrangement.plans)
    for shaft, (length, places) in stretched(context, axle, way, plans, gears).items():
        plans[shaft] = plan_along(context, shaft, length, places)
    within = tuple(pair for pair in way.within if pair[0] in plans and pair[1] in plans)
    return replace(
        arrangement, plans=plans, within=(*arrangement.within, *within), turned=(*arrangement.turned, *way.turned),
        two_sided=(*arrangement.two_sided, *both_sides(axle, way)),
    )  # fmt: skip


# ----------------------------------------------------------------------------------------------------------------------
# The hands of helices: what the axial forces of a sizing belong to, and what a drawing says.
# ----------------------------------------------------------------------------------------------------------------------


def helix_hand(design: Design, train: Train, flows: Mapping[str, PowerFlow], shaft: str) -> float:
    """Return +1 for right-hand helices, −1 for left-hand ones.

    All helices on a shaft have one hand, so that the axial forces of a driven and a driving gear on it oppose each
    other. Mating gears turn opposite ways and have opposite hands, or the same with an internal gear; the sense of
    rotation therefore gives a choice of hands that always fits, and so does its mirror image.

    Args:
        design: As read.
        train: Its graph.
        flows: Load case -> power flow.
        shaft: That carries the gear.
    """
    reference = next(iter(flows.values()))
    turning = -1.0 if reference.speeds[shaft] < 0.0 else 1.0
    return -turning if _mirrored(design, train, reference) else turning


def _mirrored(design: Design, train: Train, rated: PowerFlow) -> bool:
    """Tell whether all helices change hands, so that one on the shaft of a bevel pinion opposes the bevel's force."""
    for name, pair in design.pairs.items():
        if pair.kind != "bevel" or not isinstance(pair.pinion, str):
            continue
        away_from_first = pair.pinion_apex == "first"
        for mesh in train.meshes:
            other = design.pairs.get(mesh.stage)
            if other is None or mesh.stage == name or other.kind != "cylindrical" or pair.pinion not in mesh.nodes[:2]:
                continue
            # Unmirrored, a driven gear pushes its shaft towards the first end, a driving one towards the second.
            torque = rated.meshes[mesh.name].torques[mesh.nodes.index(pair.pinion)]
            return (torque * rated.speeds[pair.pinion] < 0.0) == away_from_first
    return False


# ----------------------------------------------------------------------------------------------------------------------
# The space that gears, shafts and carriers take: a box around their tip circles, and how long the axes are.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Envelope:
    """A box around the gearbox without its housing; the shafts run along its length."""

    width: Annotated[float, Quantity("length"), Origin("tip circles around the axes, along y", "geometry")]
    """Across the shafts, along y [m]."""
    height: Annotated[float, Quantity("length"), Origin("tip circles around the axes, along z", "geometry")]
    """Across the shafts, along z [m]."""
    length: Annotated[
        float, Quantity("length"), Origin("longest axis: its shafts and planetary sets in a row", "layout")
    ]
    """Along the shafts [m]."""

    @property
    def volume(self) -> Volume:
        """Of the box [m³]."""
        return self.width * self.height * self.length


def envelope(sizing: Sizing) -> Envelope:
    """Return the box around all gears and shafts.

    Args:
        sizing: What was sized; its axes stand where its layout says.
    """
    discs = list(_discs(sizing))
    sides = [(min(disc[k] - disc[2] for disc in discs), max(disc[k] + disc[2] for disc in discs)) for k in (0, 1)]
    (left, right), (low, high) = sides
    return Envelope(right - left, high - low, max(_lengths(sizing).values()))


def _discs(sizing: Sizing) -> Iterator[tuple[float, float, float]]:
    """Yield y, z and radius of every gear on a shaft, of every ring, and of every shaft [m]."""
    axis = {shaft.name: shaft.axis for shaft in sizing.shafts}
    for shaft in sizing.shafts:
        yield (*shaft.axis, shaft.diameter / 2.0)
    for gear in sizing.gears:
        for shaft_name in _carriers_of(sizing, gear):
            yield (*axis[shaft_name], gear.pitch_diameter / 2.0 + (gear.rim or _addendum(gear)))


def _addendum(gear: GearSizing) -> float:
    """Return how far the tip circle of a disc stands outside its pitch circle [m]."""
    return gear.module * (1.0 + gear.profile_shift + gear.tip_alteration)


def _carriers_of(sizing: Sizing, gear: GearSizing) -> Iterator[str]:
    """Yield the shafts around which a gear turns or stands; a ring on the ground stands around its set's shafts."""
    stage = sizing.design.stages[gear.stage]
    carried = not isinstance(stage, Pair)
    members = gear.shafts if isinstance(stage, Pair) else stage.members
    names = {shaft.name for shaft in sizing.shafts}
    if gear.role is not Role.PLANET:
        borne = [shaft for shaft in members if shaft in names]
        yield from borne[:1] if carried else borne


def _set_length(sizing: Sizing, name: str) -> float:
    """Return how long a planetary set is: the longest planet, or the longest of each plane of steps in a row [m]."""
    longest: dict[str, float] = {}
    for gear in sizing.train.gears:
        if gear.stage == name and gear.role is Role.PLANET:
            width = next(sized.face_width for sized in sizing.gears if sized.name == gear.name)
            longest[gear.group] = max(longest.get(gear.group, 0.0), width)
    return sum(longest.values())


def _lengths(sizing: Sizing) -> dict[tuple[float, float], float]:
    """Return the length of every axis: its shafts in a row and the face widths of its planetary sets [m]."""
    length: dict[tuple[float, float], float] = {}
    axis = {shaft.name: shaft.axis for shaft in sizing.shafts}
    for shaft in sizing.shafts:
        length[shaft.axis] = length.get(shaft.axis, 0.0) + shaft.length
    for name, stage in sizing.design.sets.items():
        place = next(axis[member] for member in stage.members if member in axis)
        length[place] += _set_length(sizing, name)
    return length
