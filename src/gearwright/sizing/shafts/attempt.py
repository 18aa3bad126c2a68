"""One attempt at a shaft: its stretches laid for what they need so far, its bearings, joints and judged sections."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import NamedTuple

from gearwright.catalogue import Bearing, next_seal_shaft, seals_for
from gearwright.parts import Material
from gearwright.sizing.bearings import Checked, Seating
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.mounted import JointSizing
from gearwright.sizing.rating import TOOTH_HEIGHT, Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.roots import root_diameter
from gearwright.sizing.shafts.as_given import cylinder
from gearwright.sizing.shafts.bending import Bent
from gearwright.sizing.shafts.joints import Seat, hub_bore, size_joint, spline_root
from gearwright.sizing.shafts.sections import Borne, HubNotch, Section, Strength, borne, sections_of
from gearwright.sizing.shafts.stretches import SAME, Item, Stretch, Wanted, lay
from gearwright.spec.design import NOTHING_GIVEN, Joint

THINNEST = 10e-3
"""Diameter from which shafts are grown [m]."""
SEAL_PLATE = 8e-3
"""Part of a shaft under the cover that carries its seal, beside the seal, at least: an assumption [m]."""


@dataclass(frozen=True)
class Task:
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
    bent: dict[tuple[tuple[Stretch, ...], float], Bent] = field(default_factory=dict)
    """Stretches and bore -> the shaft bent, as far as tried."""

    @property
    def as_given(self) -> float | None:
        """Diameter of a shaft that is taken as it is [m]; None where it is to be built."""
        return self.core if self.context.design.layout.get(self.name, NOTHING_GIVEN).as_given else None

    @cached_property
    def seats(self) -> Mapping[str, Seat]:
        """Joint -> where it sits and what it bears, on a shaft without bore."""
        return {part: _seat(self, part) for part in self.joints}

    @cached_property
    def stations(self) -> list[float]:
        """Where anything acts on the shaft, each place once, in order [m]."""
        return sorted(set(self.forces.drawn.position.tolist()))

    @cached_property
    def judge(self) -> Strength:
        """What its sections are judged by."""
        return Strength(self.name, self.context.design, self.material, tuple(self.context.flows))


class Attempt(NamedTuple):
    """A shaft as it was laid once."""

    stretches: tuple[Stretch, ...]
    chosen: Mapping[str, Bearing]
    bore: float
    sections: tuple[Section, ...]
    borne: tuple[Borne, ...]
    joints: tuple[JointSizing, ...]


def attempt_with(task: Task, seated: Seating, needed: Mapping[str, float]) -> Attempt:
    """Return a shaft laid for what its stretches need so far.

    Args:
        task: What it is built from.
        seated: What its bearings bear, and their sizes.
        needed: Stretch -> diameter that it needs so far [m].

    Raises:
        DesignError: If no bearing will do, or a part cannot be slid on.
    """
    chosen: Mapping[str, Bearing] = {}
    for _ in range(2):  # seats are as wide as their bearings, which are known after the first time
        items = items_on(task, chosen)
        stretches, chosen = _laid(task, seated, _wanted(task, items, needed))
    return _judged(task, stretches, chosen)


def sealed(task: Task, attempt: Attempt) -> Attempt:
    """Return a shaft that has grown with the diameters of radial seals where it leaves the housing.

    They are thicker than what has grown and no thicker than bearings further in, so that the shaft gets no weaker.

    Args:
        task: What it is built from.
        attempt: As it has grown.
    """
    stretches = _with_seals(attempt.stretches, _leaves(task)) if task.as_given is None else attempt.stretches
    return attempt if stretches == attempt.stretches else _judged(task, stretches, attempt.chosen)


def _with_seals(stretches: tuple[Stretch, ...], ends: tuple[bool, bool]) -> tuple[Stretch, ...]:
    """Return a shaft as thick beside its outermost bearings as the next larger radial seals want, where one runs.

    Where that is thicker than the bearing's seat, or nothing lies between the bearing and what sits further out, it
    stays as it is.
    """
    if ends[0]:
        stretches = tuple(_sealed(list(stretches)))
    if ends[1]:
        stretches = tuple(_sealed(list(stretches[::-1]))[::-1])
    return stretches


def _sealed(side: list[Stretch]) -> list[Stretch]:
    """Return stretches from an end inwards with the one under its seal."""
    at = next((k for k, stretch in enumerate(side) if stretch.kind == "bearing"), 0)
    if not at or not side[at - 1].length > SAME:
        return side
    free, bearing = side[at - 1], side[at]
    wanted = next_seal_shaft(free.diameter)
    if wanted is None or not free.diameter + SAME < wanted <= bearing.diameter + SAME:
        return side
    length = max(bearing.length, seals_for(wanted)[0].width + SEAL_PLATE)
    name = f"seal beside {bearing.name}"
    if length >= free.length - SAME:
        return [*side[: at - 1], free.of(wanted), *side[at:]]
    if free.end <= bearing.start + SAME:
        parts = free._replace(end=free.end - length), free._replace(name=name, start=free.end - length)
    else:
        parts = free._replace(start=free.start + length), free._replace(name=name, end=free.start + length)
    return [*side[: at - 1], parts[0], parts[1].of(wanted), *side[at:]]


def _judged(task: Task, stretches: tuple[Stretch, ...], chosen: Mapping[str, Bearing]) -> Attempt:
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


def _laid(task: Task, seated: Seating, wanted: Wanted) -> tuple[tuple[Stretch, ...], dict[str, Bearing]]:
    """Return the stretches of the shaft and its bearings; of one that is taken as given, what is given."""
    diameter = task.as_given
    if diameter is None:
        return lay(task.name, wanted, seated.choose)
    chosen = {seat: seated.choose(seat, diameter, diameter) for seat in seated.seats}
    return cylinder(wanted.items, wanted.length, diameter, wanted.fixed), chosen


def items_on(task: Task, chosen: Mapping[str, Bearing]) -> tuple[Item, ...]:
    """Return what sits on the shaft and has a width, in order.

    Args:
        task: What the shaft is built from.
        chosen: Bearing -> the size taken; one that is not in it has no width yet.
    """
    plan = task.forces.plan
    items = [
        Item(name, "bearing", seat.position, chosen[name].width if name in chosen else 0.0)
        for name, seat in plan.seats.items()
    ]
    for name, joint in task.joints.items():
        gear = task.gears.get(name)
        width = _width(task, name)
        middle = min(max(plan.places[name], width / 2.0), plan.length - width / 2.0)
        if joint.kind == "integral" and gear is not None:
            items.append(Item(name, "integral", middle, width, root_diameter(task.context, gear)))
        elif joint.kind != "integral" and width:
            items.append(Item(name, "hub", middle, width))
    return tuple(sorted(items, key=lambda item: item.middle))


def _width(task: Task, name: str) -> float:
    """Return the width of a gear, or of a machine's hub [m]."""
    if name in task.gears:
        gear = task.gears[name]
        return gear.face_width * gear.bodies / len(gear.shafts)
    return task.joints[name].hub_length or 0.0


def _wanted(task: Task, items: tuple[Item, ...], needed: Mapping[str, float]) -> Wanted:
    fixed = {
        name: joint.diameter
        for name, joint in task.joints.items()
        if joint.diameter is not None and joint.kind != "integral"
    }
    plan = task.forces.plan
    ends = {name: max(needed.get(name, 0.0), THINNEST) for name in _loaded(task, items)}
    passes = {name: partial(hub_bore, joint) for name, joint in task.joints.items() if joint.kind == "spline"}
    return Wanted(items, plan.length, {**needed, **ends}, fixed, task.core, plan.bearings, passes)


def _leaves(task: Task) -> tuple[bool, bool]:
    """Tell at which ends the shaft leaves the housing, beyond all its bearings, through a radial seal."""
    design, plan = task.context.design, task.forces.plan
    machines = [plan.places[name] for name, node in task.context.train.machines.items() if node == task.name]
    if not machines or not design.housing.own or design.shafting.seal == "none":
        return False, False
    seats = [seat.position for seat in plan.seats.values()]
    return min(machines) < min(seats), max(machines) > max(seats)


def _loaded(task: Task, items: tuple[Item, ...]) -> tuple[str, ...]:
    """Return the stretches beyond the outermost items that carry a load, and every hub."""
    stations = task.stations
    hubs = tuple(item.name for item in items if item.kind == "hub")
    first = ("after",) if stations[0] < items[0].start else ()
    last = (f"after {items[-1].name}",) if stations[-1] > items[-1].end else ()
    return (*hubs, *first, *last)


def _bore(task: Task, chosen: Mapping[str, Bearing]) -> float:
    """Return the bore: given, or its ratio to the thinnest bearing seat [m]."""
    layout, rules = task.context.design.layout.get(task.name, NOTHING_GIVEN), task.context.design.shafting
    if layout.bore is not None:
        return layout.bore
    ratio = rules.bore_ratio if layout.bore_ratio is None else layout.bore_ratio
    return ratio * (task.as_given or min(bearing.bore for bearing in chosen.values()))


def _joint(task: Task, part: str, stretches: tuple[Stretch, ...], bore: float) -> JointSizing:
    place = task.forces.plan.places[part]
    seat = seat_of(task, part, bore)
    on = next((stretch for stretch in stretches if stretch.name == part), None)
    on = on or next(stretch for stretch in stretches if stretch.start - 1e-9 <= place <= stretch.end + 1e-9)
    return size_joint(task.joints[part], seat, on.diameter, task.material)


def seat_of(task: Task, part: str, bore: float) -> Seat:
    """Return where a joint sits and what it bears.

    Args:
        task: What the shaft is built from.
        part: Gear or machine with the joint.
        bore: Of the shaft [m].
    """
    return task.seats[part]._replace(bore=bore)


def _seat(task: Task, part: str) -> Seat:
    gear, joint, plan = task.gears.get(part), task.joints[part], task.forces.plan
    width = _width(task, part)
    return Seat(
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
