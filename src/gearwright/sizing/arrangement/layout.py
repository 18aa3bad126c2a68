"""Where things sit along a shaft: its gears side by side, its machines at the ends, its two bearings.

Along x, from the end where power enters: driven clutches, turbines and motors; the gears of pairs and the members of
planetary sets in the order of the design; driving clutches and propellers. The gears of pairs stand between bearings,
with equal gaps. What gives torque only stands at the end on its side of the gears, or, on a shaft without gears of
pairs, at equal distances. The design's ``layout`` says otherwise where it must.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from types import MappingProxyType

from gearwright.errors import DesignError, Problem, near, refuse
from gearwright.identity import SIDES, carrier_part
from gearwright.sizing.arranged import ShaftPlan
from gearwright.sizing.arrangement.seats import radial_places, seats_of
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.spec.design import NOTHING_GIVEN, Design, ShaftLayout
from gearwright.train import Train
from gearwright.units import apart

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
