"""Sizing of stepped shafts with their bearings and joints, and shafts of specified geometry."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import Check, DesignError, Kind, PartId, Problem, apart, largest, refuse, smallest_first, text
from gearwright.catalogue import Bearing, key_for_shaft, next_seal_shaft, seals_for
from gearwright.parts import Material
from gearwright.parts.shafts import shaft_mass
from gearwright.sizing.bearings import Checked, Seating, bearing_sizings, seating
from gearwright.sizing.gear_geometry import root_diameter
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.rating import TOOTH_HEIGHT, Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shaft_results import BearingSizing, BuiltShaft, JointSizing, ShaftStep
from gearwright.sizing.shafts.retention import holding_room
from gearwright.sizing.shafts.sections import (
    NO_LIMIT,
    HubNotch,
    JointSeat,
    LoadedSection,
    Section,
    Strength,
    borne,
    hub_bore,
    joint_fits,
    keyway_depth,
    refuse_long,
    refuse_thick,
    sections_of,
    size_joint,
    spline_root,
    strengths,
)
from gearwright.sizing.shafts.stretches import (
    LARGEST_BODY,
    SAME,
    BentShaft,
    SeatedPart,
    ShaftStretch,
    Wanted,
    bend,
    lay,
    slope_excess,
)
from gearwright.spec.checks import MOST_HOLLOW
from gearwright.spec.design import LOCATES, NOTHING_GIVEN, Joint

# ----------------------------------------------------------------------------------------------------------------------
# A shaft that is taken as the design gives it: a cylinder on which nothing grows; what does not fit is a check.
#
# It is laid as it is written, also where that cannot be made. Parts that stand into each other are cut at the middle
# of what they share, so that every section belongs to one of them. The room that they lack is a check, as is every
# seat that is not the bore of its bearing, every shaft that reaches the roots of its gear, every key that no standard
# has.
# ----------------------------------------------------------------------------------------------------------------------


_SAME = 1e-9
"""Lengths that differ by less are the same [m]."""


def cylinder(
    items: Sequence[SeatedPart], length: float, diameter: float, seats: Mapping[str, float]
) -> tuple[ShaftStretch, ...]:
    """Return the stretches of a shaft of one diameter.

    Args:
        items: What sits on it, in order.
        length: Of the shaft [m].
        diameter: Of the shaft [m].
        seats: Hub -> its own diameter, where the user gives one [m].
    """
    shared = [(item.end + after.start) / 2.0 for item, after in pairwise(items)]
    stretches, reached, before = list[ShaftStretch](), 0.0, ""
    for item, limit in zip(items, (*shared, length), strict=True):
        start = max(item.start, reached)
        end = max(min(item.end, limit), start)
        stretches += [ShaftStretch(f"after {before}".strip(), "between", reached, start, diameter)]
        stretches += [ShaftStretch(item.name, item.kind, start, end, _own(item, diameter, seats))]
        reached, before = end, item.name
    stretches.append(ShaftStretch(f"after {before}".strip(), "between", reached, length, diameter))
    return tuple(stretch for stretch in stretches if stretch.length > _SAME)


def _own(item: SeatedPart, diameter: float, seats: Mapping[str, float]) -> float:
    """Return the diameter of a seat; a gear of one piece stiffens its shaft as far as its roots."""
    if item.kind == "integral":
        return max(diameter, min(item.limit, LARGEST_BODY * diameter))
    return seats.get(item.name, diameter)


def room_checks(shaft: str, items: Sequence[SeatedPart], length: float) -> Iterator[Check]:
    """Yield whether parts have room beside each other and between the ends of their shaft.

    Args:
        shaft: Its name.
        items: What sits on it, in order.
        length: Of the shaft [m].
    """
    ends = (SeatedPart("first end", "between", 0.0, 0.0), *items, SeatedPart("second end", "between", length, 0.0))
    part, clause = PartId(Kind.SHAFT, shaft), "half of both widths"
    for left, right in pairwise(ends):
        apart, needed = right.middle - left.middle, (left.width + right.width) / 2.0
        place = f"between {left.name} and {right.name}"
        yield Check(part, "room", clause, apart, needed, "length", exponent=None, place=place)


def seat_checks(seat: float, bearings: Mapping[str, Bearing]) -> Iterator[Check]:
    """Yield whether every bearing has the bore of its seat.

    Args:
        seat: Diameter of the shaft [m].
        bearings: On it, by name.
    """
    for name, bearing in bearings.items():
        part, thick = PartId(Kind.BEARING, name), seat > bearing.bore
        yield Check(
            part, "shaft in its bore", "ISO 15, d", seat, bearing.bore, "length",
            at_most=thick, exponent=None, place=bearing.designation,
        )  # fmt: skip


def joint_checks(joint: Joint, seat: JointSeat, sized: JointSizing) -> Iterator[Check]:
    """Yield whether a shaft stays inside the roots of its gear, and whether a key is one that can be had.

    Args:
        joint: As the design gives it.
        seat: Where it sits.
        sized: As it came out.
    """
    part, length = PartId(Kind.JOINT, sized.part, branch=sized.shaft), sized.length
    if seat.root < math.inf:
        mode = "shaft and keyway in the root circle" if joint.kind == "key" else "shaft in the root circle"
        reach = sized.diameter + 2.0 * keyway_depth(joint, sized.diameter)
        yield _within(part, mode, "ISO 21771, d_f", reach, seat.root)
    if joint.kind != "integral" and seat.hub_length < math.inf:
        yield _within(part, f"{joint.kind} in its hub", "length of the hub", length, seat.hub_length)
    if joint.kind == "key":
        key = key_for_shaft(sized.diameter)
        yield Check(part, "key length", "DIN 6885-1, shortest", length, key.shortest, "length", exponent=None)
        width, mode = key.section.width, "key length over its width"
        yield Check(part, mode, "DIN 6885-1, b", length, width, "length", exponent=None)


def _within(part: PartId, mode: str, clause: str, length: float, room: float) -> Check:
    return Check(part, mode, clause, length, room, "length", at_most=True, exponent=None)


# ----------------------------------------------------------------------------------------------------------------------
# One attempt at a shaft: its stretches laid for what they need so far, its bearings, joints and judged sections.
# ----------------------------------------------------------------------------------------------------------------------


THINNEST = 10e-3
"""Diameter from which shafts are grown [m]."""
SEAL_PLATE = 8e-3
"""Part of a shaft under the cover that carries its seal, beside the seal, at least: an assumption [m]."""


@dataclass(frozen=True)
class ShaftTask:
    """What one shaft is built from."""

    context: Context
    name: str
    forces: ShaftForces
    material: Material
    gears: Mapping[str, GearSizing]
    """Gears on this shaft by name."""
    core: float | None
    """Thickest diameter that the user gives [m]."""
    joints: Mapping[str, Joint] = field(default_factory=dict)
    """Hub or gear on this shaft -> its joint."""
    checked: Checked = field(default_factory=dict)
    """How sizes of bearings bear what they were tried for."""
    bent: dict[tuple[tuple[ShaftStretch, ...], float], BentShaft] = field(default_factory=dict)
    """Stretches and bore -> the shaft bent, as far as tried."""

    @property
    def as_given(self) -> float | None:
        """Diameter of a shaft that is taken as it is [m]; None where it is to be built."""
        return self.core if self.context.design.layout.get(self.name, NOTHING_GIVEN).as_given else None

    @cached_property
    def seats(self) -> Mapping[str, JointSeat]:
        """Joint -> where it sits and what it bears, on a shaft without bore."""
        return {part: _seat(self, part) for part in self.joints}

    @cached_property
    def stations(self) -> list[float]:
        """Where anything acts on the shaft, each place once, in order [m]."""
        return sorted(set(self.forces.drawn.position.tolist()))

    @cached_property
    def judge(self) -> Strength:
        """What its sections are judged by."""
        return Strength(
            self.name, self.context.design, self.material, self.forces.names(self.context.flows), self.forces.rows
        )


class Attempt(NamedTuple):
    """A shaft as it was laid once."""

    stretches: tuple[ShaftStretch, ...]
    chosen: Mapping[str, Bearing]
    bore: float
    sections: tuple[Section, ...]
    borne: tuple[LoadedSection, ...]
    joints: tuple[JointSizing, ...]


def attempt_with(task: ShaftTask, seated: Seating, needed: Mapping[str, float]) -> Attempt:
    """Return a shaft laid for what its stretches need so far.

    Args:
        task: What it is built from.
        seated: What its bearings bear, and their sizes.
        needed: ShaftStretch -> diameter that it needs so far [m].

    Raises:
        DesignError: If no bearing will do, or a part cannot be slid on.
    """
    chosen: Mapping[str, Bearing] = {}
    for _ in range(2):  # seats are as wide as their bearings, which are known after the first time
        stretches, chosen = _laid(task, seated, _wanted(task, items_on(task, chosen), needed))
    return _judged(task, stretches, chosen)


def ended(task: ShaftTask, seated: Seating, attempt: Attempt) -> Attempt:
    """Return a shaft that has grown with room for what holds its bearings at both ends, and diameters for its seals.

    Seats go on where a thinner end would leave no room for a ring or nut that axial force asks for. Diameters of seals
    are thicker than what has grown and no thicker than bearings further in. So the shaft gets no weaker.

    Args:
        task: What it is built from.
        seated: What its bearings bear.
        attempt: As it has grown.
    """
    if task.as_given is not None:
        return attempt
    stretches = _at_ends(attempt.stretches, _pulls(task, seated, attempt.stretches), _leaves(task))
    return attempt if stretches == attempt.stretches else _judged(task, stretches, attempt.chosen)


def _at_ends(
    stretches: tuple[ShaftStretch, ...], pulls: tuple[float, float], leaves: tuple[bool, bool]
) -> tuple[ShaftStretch, ...]:
    """Return a shaft with longer seats at its outermost bearings where force pulls, and seals beyond them."""
    for way in (0, 1):
        side = _sealed(_held(list(stretches[:: 1 - 2 * way]), pulls[way], leaves=leaves[way]), leaves=leaves[way])
        stretches = tuple(side[:: 1 - 2 * way])
    return stretches


def _pulls(task: ShaftTask, seated: Seating, stretches: Sequence[ShaftStretch]) -> tuple[float, float]:
    """Return what pulls the shaft out of bearings, or hubs off it, on each side of its thickest part [N]."""
    thick = largest(stretches, lambda stretch: stretch.diameter)
    middle, factor = (thick.start + thick.end) / 2.0, task.context.design.service.application_factor
    found = [0.0, 0.0]
    for name, seat in seated.seats.items():
        way = int(seat.position > middle)
        if (-1 if way else 1) in LOCATES[seat.locates]:
            found[way] = max(found[way], factor * float(np.abs(seated.axial[name]).max()))
    for name in task.gears:
        way = int(task.forces.plan.places[name] > middle)
        found[way] = max(found[way], _thrust(task, name))
    return found[0], found[1]


def _thrust(task: ShaftTask, name: str) -> float:
    """Return what pushes a gear along its shaft, at most: of a bevel or face gear the force around it [N]."""
    gear, joint = task.gears[name], task.joints[name]
    pair = task.context.design.pairs.get(gear.stage)
    if joint.kind == "integral" or pair is None:
        return 0.0
    slope = math.tan(task.context.ratings[gear.stage].helix_angle) if pair.kind == "cylindrical" else 1.0
    return task.seats[name].torque / (gear.pitch_diameter / 2.0) * slope if pair.halves == 1 else 0.0


def _held(side: list[ShaftStretch], force: float, *, leaves: bool) -> list[ShaftStretch]:
    """Return stretches from an end inwards whose outermost bearing has room beside it for what holds it.

    Where the shaft leaves the housing there, its seal runs on that, too.
    """
    at = next((k for k, stretch in enumerate(side) if stretch.kind == "bearing"), 0)
    if not at or force <= 0.0 or side[at - 1].kind != "between" or side[at - 1].diameter > side[at].diameter - SAME:
        return side
    seat, seals = side[at].diameter, seals_for(side[at].diameter) if leaves else ()
    length = holding_room(seat, force)
    return _cut(side, at, seat, length + (seals[0].width + SEAL_PLATE if seals else 0.0), "beside") if length else side


def _sealed(side: list[ShaftStretch], *, leaves: bool) -> list[ShaftStretch]:
    """Return stretches from an end inwards with the one under its seal, as thick as the next larger seal wants.

    Where that is thicker than the bearing's seat, or nothing lies between the bearing and what sits further out, it
    stays as it is.
    """
    at = next((k for k, stretch in enumerate(side) if stretch.kind == "bearing"), 0)
    if not leaves or not at or not side[at - 1].length > SAME:
        return side
    wanted = next_seal_shaft(side[at - 1].diameter)
    if wanted is None or not side[at - 1].diameter + SAME < wanted <= side[at].diameter + SAME:
        return side
    length = max(side[at].length, seals_for(wanted)[0].width + SEAL_PLATE)
    return _cut(side, at, wanted, length, "seal beside")


def _cut(side: list[ShaftStretch], at: int, diameter: float, length: float, what: str) -> list[ShaftStretch]:
    """Return stretches with the part of one that lies beside a bearing as thick as is wanted there."""
    free, bearing = side[at - 1], side[at]
    if length >= free.length - SAME:
        return [*side[: at - 1], free.of(diameter), *side[at:]]
    if free.end <= bearing.start + SAME:
        parts = free._replace(end=free.end - length), free._replace(start=free.end - length)
    else:
        parts = free._replace(start=free.start + length), free._replace(end=free.start + length)
    inner = parts[1]._replace(name=f"{what} {bearing.name}", diameter=diameter)
    return [*side[: at - 1], parts[0], inner, *side[at:]]


def _judged(task: ShaftTask, stretches: tuple[ShaftStretch, ...], chosen: Mapping[str, Bearing]) -> Attempt:
    """Return a shaft with its bore, joints and judged sections."""
    bore = _bore(task, chosen)
    joints = tuple(_joint(task, joint, stretches, bore) for joint in task.joints)
    roots = {
        joint.part: spline_root(task.joints[joint.part], joint.diameter) for joint in joints if joint.kind == "spline"
    }
    hubs: dict[str, HubNotch] = {
        joint.part: joint.kind  # type: ignore[misc]
        for joint in joints
        if joint.kind in ("key", "spline", "press-fit")
    }
    rules = task.context.design.shafting
    sections = sections_of(stretches, task.forces, hubs, roots, stations=task.stations, rules=rules)
    return Attempt(stretches, chosen, bore, sections, borne(sections, task.forces, task.judge, bore=bore), joints)


def _laid(task: ShaftTask, seated: Seating, wanted: Wanted) -> tuple[tuple[ShaftStretch, ...], dict[str, Bearing]]:
    """Return the stretches of the shaft and its bearings; of one that is taken as given, what is given."""
    diameter = task.as_given
    if diameter is None:
        return lay(task.name, wanted, seated.choose)
    chosen = {seat: seated.choose(seat, diameter, diameter) for seat in seated.seats}
    return cylinder(wanted.items, wanted.length, diameter, wanted.fixed), chosen


def items_on(task: ShaftTask, chosen: Mapping[str, Bearing]) -> tuple[SeatedPart, ...]:
    """Return what sits on the shaft and has a width, in order.

    Args:
        task: What the shaft is built from.
        chosen: Bearing -> the size taken; one that is not in it has no width yet.
    """
    plan = task.forces.plan
    items = [
        SeatedPart(name, "bearing", seat.position, chosen[name].width if name in chosen else 0.0)
        for name, seat in plan.seats.items()
    ]
    for name, joint in task.joints.items():
        gear = task.gears.get(name)
        width = _width(task, name)
        middle = min(max(plan.places[name], width / 2.0), plan.length - width / 2.0)
        if joint.kind == "integral" and gear is not None:
            items.append(SeatedPart(name, "integral", middle, width, root_diameter(task.context, gear)))
        elif joint.kind != "integral" and width:
            items.append(SeatedPart(name, "hub", middle, width))
    return tuple(sorted(items, key=lambda item: item.middle))


def _width(task: ShaftTask, name: str) -> float:
    """Return the width of a gear, or of a machine's hub [m]."""
    if name in task.gears:
        gear = task.gears[name]
        return gear.face_width * gear.bodies / len(gear.shafts)
    return task.joints[name].hub_length or 0.0


def _wanted(task: ShaftTask, items: tuple[SeatedPart, ...], needed: Mapping[str, float]) -> Wanted:
    fixed = {
        name: joint.diameter
        for name, joint in task.joints.items()
        if joint.diameter is not None and joint.kind != "integral"
    }
    plan = task.forces.plan
    ends = {name: max(needed.get(name, 0.0), THINNEST) for name in _loaded(task, items)}
    passes = {name: partial(hub_bore, joint) for name, joint in task.joints.items() if joint.kind == "spline"}
    return Wanted(items, plan.length, {**needed, **ends}, fixed, task.core, plan.bearings, passes)


def _leaves(task: ShaftTask) -> tuple[bool, bool]:
    """Tell at which ends the shaft leaves the housing, beyond all its bearings, through a radial seal."""
    design, plan = task.context.design, task.forces.plan
    machines = [plan.places[name] for name, node in task.context.train.machines.items() if node == task.name]
    if not machines or not design.housing.own or design.shafting.seal == "none":
        return False, False
    seats = [seat.position for seat in plan.seats.values()]
    return min(machines) < min(seats), max(machines) > max(seats)


def _loaded(task: ShaftTask, items: tuple[SeatedPart, ...]) -> tuple[str, ...]:
    """Return the stretches beyond the outermost items that carry a load, and every hub."""
    stations = task.stations
    hubs = tuple(item.name for item in items if item.kind == "hub")
    first = ("after",) if stations[0] < items[0].start else ()
    last = (f"after {items[-1].name}",) if stations[-1] > items[-1].end else ()
    return (*hubs, *first, *last)


def _bore(task: ShaftTask, chosen: Mapping[str, Bearing]) -> float:
    """Return the bore: given, or its ratio to the thinnest bearing seat [m]."""
    layout, rules = task.context.design.layout.get(task.name, NOTHING_GIVEN), task.context.design.shafting
    if layout.bore is not None:
        return layout.bore
    ratio = rules.bore_ratio if layout.bore_ratio is None else layout.bore_ratio
    return ratio * (task.as_given or min(bearing.bore for bearing in chosen.values()))


def _joint(task: ShaftTask, part: str, stretches: tuple[ShaftStretch, ...], bore: float) -> JointSizing:
    place = task.forces.plan.places[part]
    seat = seat_of(task, part, bore)
    on = next((stretch for stretch in stretches if stretch.name == part), None)
    on = on or next(stretch for stretch in stretches if stretch.start - 1e-9 <= place <= stretch.end + 1e-9)
    return size_joint(task.joints[part], seat, on.diameter, task.material)


def seat_of(task: ShaftTask, part: str, bore: float) -> JointSeat:
    """Return where a joint sits and what it bears.

    Args:
        task: What the shaft is built from.
        part: Gear or machine with the joint.
        bore: Of the shaft [m].
    """
    return task.seats[part]._replace(bore=bore)


def _seat(task: ShaftTask, part: str) -> JointSeat:
    gear, joint, plan = task.gears.get(part), task.joints[part], task.forces.plan
    width = _width(task, part)
    return JointSeat(
        part=part,
        shaft=task.name,
        position=plan.places[part],
        hub_length=joint.hub_length or width or math.inf,
        root=root_diameter(task.context, gear) if gear is not None else math.inf,
        torque=_torque(task.context, task.name, part) * task.context.design.service.application_factor,
        bore=0.0,
        tooth=TOOTH_HEIGHT * gear.module if gear is not None else 0.0,
        speed=max(abs(flow.speeds[task.name]) for flow in task.context.flows.values()),
        hub=task.context.ratings[gear.stage].material if gear is not None else None,
    )


def _torque(context: Context, shaft: str, part: str) -> float:
    """Return the largest torque between a part and its shaft over all cases [N m]."""
    torques = []
    for flow in context.flows.values():
        meshes = [
            flow.meshes[mesh.name].torques[side]
            for mesh in context.train.meshes
            for side in (0, 1)
            if mesh.gears[side] == part and mesh.nodes[side] == shaft
        ]
        torques.append(abs(sum(meshes)) if meshes else abs(flow.machine_torques.get(part, 0.0)))
    return max(torques)


# ----------------------------------------------------------------------------------------------------------------------
# Parts of a built shaft that have no room beside each other, and bores that leave too little metal: refused.
# ----------------------------------------------------------------------------------------------------------------------


_OVERLAP = 1e-6
"""How far parts may stand into each other [m]."""


def refuse_overlaps(items: Sequence[SeatedPart], length: float) -> None:
    """Raise where parts stand into each other or out over an end of the shaft.

    Args:
        items: What sits on the shaft, in order.
        length: Of the shaft [m].

    Raises:
        DesignError: With the place that would do, for every such part.
    """
    edges = [("the first end", 0.0), *((item.name, item.end) for item in items)]
    problems = []
    for (before, reached), item in zip(edges, items, strict=False):
        over = reached - item.start
        if over > _OVERLAP:
            problems.append(Problem(_path(item), _close(item, before, over, item.middle + over)))
    last = items[-1]
    over = last.end - length
    if over > _OVERLAP:
        problems.append(Problem(_path(last), _close(last, "the second end", over, last.middle - over)))
    refuse(problems)


def refuse_thin(shaft: str, stretches: Sequence[ShaftStretch], *, bore: float) -> None:
    """Raise where the bore leaves too thin a wall.

    Args:
        shaft: Its name.
        stretches: From end to end.
        bore: Of the shaft [m].

    Raises:
        DesignError: With the largest bore that would do.
    """
    thin = min(stretches, key=lambda stretch: stretch.diameter)
    if thin.diameter < bore / MOST_HOLLOW - 1e-9:
        given, most = apart(bore, MOST_HOLLOW * thin.diameter, "length")
        message = (
            f"{given} leave too thin a wall in {text(thin.diameter, 'length')} ({thin.name}); the bore may be"
            f" {MOST_HOLLOW:.0%} of that: give {most} or less"
        )
        raise DesignError([Problem(f"layout.{shaft}.bore_mm", message)])


def _close(item: SeatedPart, neighbour: str, over: float, place: float) -> str:
    return (
        f"{item.name} is {1e3 * item.width:.4g} mm wide and stands {1e3 * over:.3g} mm into {neighbour}; put its middle"
        f" at {1e3 * place:.4g} mm, or make room"
    )


def _path(item: SeatedPart) -> str:
    return f"bearings.{item.name}.position" if item.kind == "bearing" else f"layout.places.{item.name}"


# ----------------------------------------------------------------------------------------------------------------------
# A shaft that the design gives bearings, built: stretches thick enough, bearings that live, joints that hold.
#
# Forces do not depend on diameters, as two bearings are statically determinate. So a shaft is built from thin to
# thick: stretches are laid, every section is judged, and what is too weak grows by the cube root of what its safety
# lacks, until nothing does. Then slopes are judged, and the whole shaft grows by their fourth root. Sizes that the
# user gives stay. On a shaft that the user gives as a whole nothing grows and nothing is refused: `as_given` says
# what does not fit.
# ----------------------------------------------------------------------------------------------------------------------


ROUNDS = 60
"""Growths after which no shaft is looked for [-]."""
LEAST_GROWTH, MOST_GROWTH = 1.002, 1.3
"""Growth of a stretch that is too weak in one round [-]."""
TAPER_ROUNDS = 8
"""How often taper bearings are chosen anew for the thrust that they make [-]."""


class Built(NamedTuple):
    """A built shaft with what is on it."""

    shaft: BuiltShaft
    bearings: tuple[BearingSizing, ...]
    joints: tuple[JointSizing, ...]
    fits: tuple[Check, ...] = ()
    """Whether its parts fit, where it is taken as given."""


def build_shaft(
    context: Context,
    name: str,
    forces: ShaftForces,
    material: Material,
    *,
    gears: Mapping[str, GearSizing],
    core: float | None,
) -> Built:
    """Return a shaft with bearings, built.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        forces: What acts on it.
        material: Its steel.
        gears: All gears by name.
        core: Thickest diameter that the user gives [m].

    Raises:
        DesignError: If a bearing, a joint or the shaft itself cannot be had; with the nearest that can.
    """
    borne = {place: gears[place] for place in forces.plan.places if place in gears}
    joints = {gear: context.design.joints.get(gear, Joint(kind="integral")) for gear in borne}
    joints |= {part: joint for part, joint in context.design.joints.items() if part in forces.plan.places}
    task = ShaftTask(context, name, forces, material, borne, core, joints)
    settled: list[tuple[bool, Seating, Attempt]] = []
    refused: dict[bool, DesignError] = {}
    for slim in (True, False):
        try:
            settled.append((slim, *_settled(task, slim=slim)))
        except DesignError as error:
            refused[slim] = error
    for slim, seated, attempt in smallest_first(settled, lambda tried: _weight(tried[1], tried[2], material)):
        try:
            return _finished(task, seated, ended(task, seated, attempt))
        except DesignError as error:
            refused[slim] = error
    raise refused[True]


def _weight(seated: Seating, attempt: Attempt, material: Material) -> float:
    """Return the mass of a shaft and its bearings, which small bores and light bearings lower in turn [kg]."""
    metal = sum(
        shaft_mass(stretch.diameter, stretch.end - stretch.start, material.density, bore=attempt.bore)
        for stretch in attempt.stretches
    )
    return metal + sum(attempt.chosen[name].mass for name in seated.seats)


def _settled(task: ShaftTask, *, slim: bool) -> tuple[Seating, Attempt]:
    """Return a shaft whose taper bearings bear the thrust that they make themselves."""
    chosen: Mapping[str, Bearing] = {}
    tried: list[Mapping[str, str]] = []
    for _ in range(TAPER_ROUNDS):
        seated = seating(task.context, task.name, task.forces, chosen, slim=slim, known=task.checked)
        attempt = _stiff(task, seated) if task.as_given is None else attempt_with(task, seated, {})
        chosen, names = attempt.chosen, {seat: bearing.designation for seat, bearing in attempt.chosen.items()}
        if names in tried or not any(seat.kind == "taper" for seat in seated.seats.values()):
            break
        tried.append(names)
    return seating(task.context, task.name, task.forces, chosen, slim=slim, known=task.checked), attempt


def _stiff(task: ShaftTask, seated: Seating) -> Attempt:
    """Return a shaft that is strong and, as far as that can be had, stiff."""
    attempt = _strong(task, seated, {})
    for _ in range(ROUNDS):
        bent = _bent(task, attempt)
        excess = slope_excess(bent, seated.seats, {gear: task.forces.plan.places[gear] for gear in task.gears})
        if excess <= 1.0:
            break
        growth = max(excess**0.25, LEAST_GROWTH)
        try:
            thicker = _strong(task, seated, {stretch.name: growth * stretch.diameter for stretch in _free(attempt)})
        except DesignError:
            break
        if thicker.stretches == attempt.stretches:
            break
        attempt = thicker
    return attempt


def _bent(task: ShaftTask, attempt: Attempt) -> BentShaft:
    """Return the shaft bent by what acts on it, once for each shape."""
    shape = attempt.stretches, attempt.bore
    if shape not in task.bent:
        task.bent[shape] = bend(task.forces, attempt.stretches, task.material, bore=attempt.bore)
    return task.bent[shape]


def _free(attempt: Attempt) -> tuple[ShaftStretch, ...]:
    """Return the stretches that may grow; gears of one piece grow with what lies beside them."""
    return tuple(stretch for stretch in attempt.stretches if stretch.kind != "integral")


def _strong(task: ShaftTask, seated: Seating, needed: Mapping[str, float]) -> Attempt:
    """Return a shaft in which every section is strong enough and every joint holds."""
    wanted, before = dict(needed), None
    for _ in range(ROUNDS):
        attempt = attempt_with(task, seated, wanted)
        grown = {**wanted, **_grown(task, attempt, wanted)}
        if grown == wanted or attempt == before:
            break
        wanted, before = grown, attempt
    return attempt


def _grown(task: ShaftTask, attempt: Attempt, wanted: Mapping[str, float]) -> dict[str, float]:
    """Return what must be thicker."""
    service = task.context.design.service
    diameters = {stretch.name: stretch.diameter for stretch in attempt.stretches}
    walled = attempt.bore / MOST_HOLLOW
    thicker = {stretch.name: walled for stretch in _free(attempt) if stretch.diameter < walled - 1e-9}
    for section, held in zip(attempt.sections, attempt.borne, strict=True):
        owner, safeties = section.owner, (min(held.fatigue), held.yielding, held.limit)
        asked = (service.shaft_fatigue_safety, service.shaft_yield_safety, 1.0)
        ratio = min(min(safety, NO_LIMIT) / least for safety, least in zip(safeties, asked, strict=True))
        if ratio < 1.0 - 1e-9:
            growth = min(max(ratio ** (-1.0 / 3.0), LEAST_GROWTH), MOST_GROWTH) if ratio > 0.0 else MOST_GROWTH
            thicker[owner] = max(thicker.get(owner, 0.0), wanted.get(owner, 0.0), growth * diameters[owner])
    for joint in attempt.joints:
        seat = seat_of(task, joint.part, attempt.bore)
        if joint.part in diameters and not joint_fits(task.joints[joint.part], seat, joint):
            thicker[joint.part] = max(thicker.get(joint.part, 0.0), joint.diameter + 1e-3)
    return thicker


def _finished(task: ShaftTask, seated: Seating, attempt: Attempt) -> Built:
    """Return what was built, or say what does not fit."""
    if task.as_given is None:
        _refuse(task, attempt)
    bent = _bent(task, attempt)
    seats = {name: seat.position for name, seat in seated.seats.items()}
    places = {name: task.forces.plan.places[name] for name in task.gears}
    sections = strengths(attempt.sections, task.forces, task.judge, bore=attempt.bore)
    shaft = BuiltShaft(
        name=task.name,
        steps=tuple(
            ShaftStep(stretch.start, stretch.end, stretch.diameter, _sits(stretch)) for stretch in attempt.stretches
        ),
        bore=attempt.bore,
        sections=tuple(section for section in sections if section.bending_moment or section.torque) or sections[:1],
        slopes=tuple((name, bent.slope(place)) for name, place in {**places, **seats}.items()),
        deflections=tuple((name, bent.deflection(place)) for name, place in places.items()),
        critical_speed=bent.critical_speed(places, {name: _mass(gear) for name, gear in task.gears.items()}),
        highest_speed=max(abs(flow.speeds[task.name]) for flow in task.context.flows.values()),
    )
    sized = bearing_sizings(seated, attempt.chosen, task.name)
    return Built(
        shaft, sized, attempt.joints, () if task.as_given is None else tuple(_fits(task, attempt, task.as_given))
    )


def _refuse(task: ShaftTask, attempt: Attempt) -> None:
    """Raise where parts do not fit."""
    refuse_overlaps(items_on(task, attempt.chosen), task.forces.plan.length)
    refuse_thin(task.name, attempt.stretches, bore=attempt.bore)
    for joint in attempt.joints:
        seat = seat_of(task, joint.part, attempt.bore)
        refuse_long(task.joints[joint.part], seat, joint)
        refuse_thick(joint, seat)


def _fits(task: ShaftTask, attempt: Attempt, diameter: float) -> Iterator[Check]:
    """Yield whether the parts of a shaft that is taken as given fit."""
    yield from room_checks(task.name, items_on(task, attempt.chosen), task.forces.plan.length)
    yield from seat_checks(diameter, attempt.chosen)
    for joint in attempt.joints:
        yield from joint_checks(task.joints[joint.part], seat_of(task, joint.part, attempt.bore), joint)


def _sits(stretch: ShaftStretch) -> str:
    return "" if stretch.kind == "between" else stretch.name


def _mass(gear: GearSizing) -> float:
    return gear.mass * gear.bodies / len(gear.shafts)
