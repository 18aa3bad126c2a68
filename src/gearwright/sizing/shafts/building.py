"""A shaft that the design gives bearings, built: stretches thick enough, bearings that live, joints that hold.

Forces do not depend on diameters, as two bearings are statically determinate. So a shaft is built from thin to thick:
stretches are laid, every section is judged, and what is too weak grows by the cube root of what its safety lacks, until
nothing does. Then slopes are judged, and the whole shaft grows by their fourth root. Sizes that the user gives stay. On
a shaft that the user gives as a whole nothing grows and nothing is refused: `as_given` says what does not fit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from gearwright.catalogue import Bearing
from gearwright.errors import DesignError
from gearwright.parts import Material
from gearwright.parts.shafts import shaft_mass
from gearwright.sizing.arrangement import root_diameter, seats_of
from gearwright.sizing.bearings import Seating, bearing_sizings, seating
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, Check, JointSizing, SectionStrength, ShaftStep
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shafts.as_given import cylinder, joint_checks, room_checks, seat_checks
from gearwright.sizing.shafts.bending import bend, slope_excess
from gearwright.sizing.shafts.joints import Seat, joint_fits, refuse_long, refuse_thick, size_joint, spline_root
from gearwright.sizing.shafts.room import refuse_overlaps, refuse_thin
from gearwright.sizing.shafts.sections import HubNotch, Strength, sections_of, strengths
from gearwright.sizing.shafts.stretches import Item, Stretch, Wanted, lay
from gearwright.spec.checks import MOST_HOLLOW
from gearwright.spec.design import NOTHING_GIVEN, Joint

THINNEST = 10e-3
"""Diameter from which shafts are grown [m]."""
ROUNDS = 60
"""Growths after which no shaft is looked for [-]."""
LEAST_GROWTH, MOST_GROWTH = 1.002, 1.3
"""Growth of a stretch that is too weak in one round [-]."""
TAPER_ROUNDS = 8
"""How often taper bearings are chosen anew for the thrust that they make [-]."""
TOOTH_HEIGHT = 2.25
"""Height of teeth over their module [-] (ISO 53)."""


class Built(NamedTuple):
    """A built shaft with what is on it."""

    shaft: BuiltShaft
    bearings: tuple[BearingSizing, ...]
    joints: tuple[JointSizing, ...]
    fits: tuple[Check, ...] = ()
    """Whether its parts fit, where it is taken as given."""


@dataclass(frozen=True)
class _Task:
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

    @property
    def as_given(self) -> float | None:
        """Diameter of a shaft that is taken as it is [m]; None where it is to be built."""
        return self.core if self.context.design.layout.get(self.name, NOTHING_GIVEN).as_given else None


class _Attempt(NamedTuple):
    """A shaft as it was laid once."""

    stretches: tuple[Stretch, ...]
    chosen: Mapping[str, Bearing]
    bore: float
    sections: tuple[SectionStrength, ...]
    owners: tuple[str, ...]
    joints: tuple[JointSizing, ...]


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
    task = _Task(context, name, forces, material, borne, core, joints)
    shafts: list[Built] = []
    refused: list[DesignError] = []
    for slim in (True, False):
        try:
            shafts.append(_settled(task, slim=slim))
        except DesignError as error:
            refused.append(error)
    if not shafts:
        raise refused[0]
    return min(shafts, key=lambda built: _weight(built, material))


def _weight(built: Built, material: Material) -> float:
    """Return the mass of a shaft and its bearings, which small bores and light bearings lower in turn [kg]."""
    metal = sum(
        shaft_mass(step.diameter, step.end - step.start, material.density, bore=built.shaft.bore)
        for step in built.shaft.steps
    )
    return metal + sum(bearing.bearing.mass for bearing in built.bearings)


def _settled(task: _Task, *, slim: bool) -> Built:
    """Return a shaft whose taper bearings bear the thrust that they make themselves."""
    chosen: Mapping[str, Bearing] = {}
    tried: list[Mapping[str, str]] = []
    for _ in range(TAPER_ROUNDS):
        seated = seating(task.context, task.name, task.forces, chosen, slim=slim)
        attempt = _stiff(task, seated) if task.as_given is None else _attempt(task, seated, {})
        chosen, names = attempt.chosen, {seat: bearing.designation for seat, bearing in attempt.chosen.items()}
        if names in tried or not any(seat.kind == "taper" for seat in seated.seats.values()):
            break
        tried.append(names)
    return _finished(task, seating(task.context, task.name, task.forces, chosen, slim=slim), attempt)


def _stiff(task: _Task, seated: Seating) -> _Attempt:
    """Return a shaft that is strong and, as far as that can be had, stiff."""
    attempt = _strong(task, seated, {})
    for _ in range(ROUNDS):
        bent = bend(task.forces, attempt.stretches, task.material, bore=attempt.bore)
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


def _free(attempt: _Attempt) -> tuple[Stretch, ...]:
    """Return the stretches that may grow; gears of one piece grow with what lies beside them."""
    return tuple(stretch for stretch in attempt.stretches if stretch.kind != "integral")


def _strong(task: _Task, seated: Seating, needed: Mapping[str, float]) -> _Attempt:
    """Return a shaft in which every section is strong enough and every joint holds."""
    wanted, before = dict(needed), None
    for _ in range(ROUNDS):
        attempt = _attempt(task, seated, wanted)
        grown = {**wanted, **_grown(task, attempt, wanted)}
        if grown == wanted or attempt == before:
            break
        wanted, before = grown, attempt
    return attempt


def _grown(task: _Task, attempt: _Attempt, wanted: Mapping[str, float]) -> dict[str, float]:
    """Return what must be thicker."""
    service = task.context.design.service
    diameters = {stretch.name: stretch.diameter for stretch in attempt.stretches}
    walled = attempt.bore / MOST_HOLLOW
    thicker = {stretch.name: walled for stretch in _free(attempt) if stretch.diameter < walled - 1e-9}
    for section, owner in zip(attempt.sections, attempt.owners, strict=True):
        ratio = min(
            section.fatigue_safety / service.shaft_fatigue_safety, section.yield_safety / service.shaft_yield_safety
        )
        if ratio < 1.0 - 1e-9:
            growth = min(max(ratio ** (-1.0 / 3.0), LEAST_GROWTH), MOST_GROWTH) if ratio > 0.0 else MOST_GROWTH
            thicker[owner] = max(thicker.get(owner, 0.0), wanted.get(owner, 0.0), growth * diameters[owner])
    for joint in attempt.joints:
        seat = _seat(task, joint.part, attempt.bore)
        if joint.part in diameters and not joint_fits(task.joints[joint.part], seat, joint):
            thicker[joint.part] = max(thicker.get(joint.part, 0.0), joint.diameter + 1e-3)
    return thicker


def _attempt(task: _Task, seated: Seating, needed: Mapping[str, float]) -> _Attempt:
    """Return a shaft laid for what its stretches need so far."""
    chosen: Mapping[str, Bearing] = {}
    for _ in range(2):  # seats are as wide as their bearings, which are known after the first time
        items = _items(task, chosen)
        stretches, chosen = _laid(task, seated, _wanted(task, items, needed))
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
    sections = sections_of(stretches, task.forces, hubs, roots, fillet_ratio=task.context.design.shafting.fillet_ratio)
    judge = Strength(task.name, task.context.design, task.material, tuple(task.context.flows))
    sized = strengths(sections, task.forces, judge, bore=bore)
    return _Attempt(stretches, chosen, bore, sized, tuple(section.owner for section in sections), joints)


def _laid(task: _Task, seated: Seating, wanted: Wanted) -> tuple[tuple[Stretch, ...], dict[str, Bearing]]:
    """Return the stretches of the shaft and its bearings; of one that is taken as given, what is given."""
    diameter = task.as_given
    if diameter is None:
        return lay(task.name, wanted, seated.choose)
    chosen = {seat: seated.choose(seat, diameter, diameter) for seat in seated.seats}
    return cylinder(wanted.items, wanted.length, diameter, wanted.fixed), chosen


def _items(task: _Task, chosen: Mapping[str, Bearing]) -> tuple[Item, ...]:
    """Return what sits on the shaft and has a width, in order."""
    places = task.forces.plan.places
    items = [
        Item(name, "bearing", seat.position, chosen[name].width if name in chosen else 0.0)
        for name, seat in seats_of(task.context.design, task.name).items()
    ]
    for name, joint in task.joints.items():
        gear = task.gears.get(name)
        width = _width(task, name)
        middle = min(max(places[name], width / 2.0), task.forces.plan.length - width / 2.0)
        if joint.kind == "integral" and gear is not None:
            items.append(Item(name, "integral", middle, width, root_diameter(task.context, gear)))
        elif joint.kind != "integral" and width:
            items.append(Item(name, "hub", middle, width))
    return tuple(sorted(items, key=lambda item: item.middle))


def _width(task: _Task, name: str) -> float:
    """Return the width of a gear, or of a machine's hub [m]."""
    if name in task.gears:
        gear = task.gears[name]
        return gear.face_width * gear.bodies / len(gear.shafts)
    return task.joints[name].hub_length or 0.0


def _wanted(task: _Task, items: tuple[Item, ...], needed: Mapping[str, float]) -> Wanted:
    fixed = {
        name: joint.diameter
        for name, joint in task.joints.items()
        if joint.diameter is not None and joint.kind != "integral"
    }
    plan = task.forces.plan
    ends = {name: max(needed.get(name, 0.0), THINNEST) for name in _loaded(task, items)}
    return Wanted(items, plan.length, {**needed, **ends}, fixed, task.core, plan.bearings)


def _loaded(task: _Task, items: tuple[Item, ...]) -> tuple[str, ...]:
    """Return the stretches beyond the outermost items that carry a load, and every hub."""
    stations = task.forces.drawn.position
    hubs = tuple(item.name for item in items if item.kind == "hub")
    first = ("after",) if stations[0] < items[0].start else ()
    last = (f"after {items[-1].name}",) if stations[-1] > items[-1].end else ()
    return (*hubs, *first, *last)


def _bore(task: _Task, chosen: Mapping[str, Bearing]) -> float:
    """Return the bore: given, or its ratio to the thinnest bearing seat [m]."""
    layout, rules = task.context.design.layout.get(task.name, NOTHING_GIVEN), task.context.design.shafting
    if layout.bore is not None:
        return layout.bore
    ratio = rules.bore_ratio if layout.bore_ratio is None else layout.bore_ratio
    return ratio * (task.as_given or min(bearing.bore for bearing in chosen.values()))


def _joint(task: _Task, part: str, stretches: tuple[Stretch, ...], bore: float) -> JointSizing:
    place = task.forces.plan.places[part]
    seat = _seat(task, part, bore)
    on = next((stretch for stretch in stretches if stretch.name == part), None)
    on = on or next(stretch for stretch in stretches if stretch.start - 1e-9 <= place <= stretch.end + 1e-9)
    return size_joint(task.joints[part], seat, on.diameter, task.material)


def _seat(task: _Task, part: str, bore: float) -> Seat:
    gear, joint, plan = task.gears.get(part), task.joints[part], task.forces.plan
    width = _width(task, part)
    return Seat(
        part=part,
        shaft=task.name,
        position=plan.places[part],
        hub_length=joint.hub_length or width or math.inf,
        root=root_diameter(task.context, gear) if gear is not None else math.inf,
        torque=_torque(task.context, task.name, part) * task.context.design.service.application_factor,
        bore=bore,
        tooth=TOOTH_HEIGHT * gear.module if gear is not None else 0.0,
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


def _finished(task: _Task, seated: Seating, attempt: _Attempt) -> Built:
    """Return what was built, or say what does not fit."""
    if task.as_given is None:
        _refuse(task, attempt)
    bent = bend(task.forces, attempt.stretches, task.material, bore=attempt.bore)
    seats = {name: seat.position for name, seat in seated.seats.items()}
    places = {name: task.forces.plan.places[name] for name in task.gears}
    shaft = BuiltShaft(
        name=task.name,
        steps=tuple(
            ShaftStep(stretch.start, stretch.end, stretch.diameter, _sits(stretch)) for stretch in attempt.stretches
        ),
        bore=attempt.bore,
        sections=tuple(section for section in attempt.sections if section.bending_moment or section.torque)
        or attempt.sections[:1],
        slopes=tuple((name, bent.slope(place)) for name, place in {**places, **seats}.items()),
        deflections=tuple((name, bent.deflection(place)) for name, place in places.items()),
        critical_speed=bent.critical_speed(places, {name: _mass(gear) for name, gear in task.gears.items()}),
        highest_speed=max(abs(flow.speeds[task.name]) for flow in task.context.flows.values()),
    )
    sized = bearing_sizings(seated, attempt.chosen, task.name, tuple(task.context.flows))
    return Built(
        shaft, sized, attempt.joints, () if task.as_given is None else tuple(_fits(task, attempt, task.as_given))
    )


def _refuse(task: _Task, attempt: _Attempt) -> None:
    """Raise where parts do not fit."""
    refuse_overlaps(_items(task, attempt.chosen), task.forces.plan.length)
    refuse_thin(task.name, attempt.stretches, bore=attempt.bore)
    for joint in attempt.joints:
        seat = _seat(task, joint.part, attempt.bore)
        refuse_long(task.joints[joint.part], seat, joint)
        refuse_thick(joint, seat)


def _fits(task: _Task, attempt: _Attempt, diameter: float) -> Iterator[Check]:
    """Yield whether the parts of a shaft that is taken as given fit."""
    yield from room_checks(task.name, _items(task, attempt.chosen), task.forces.plan.length)
    yield from seat_checks(diameter, attempt.chosen)
    for joint in attempt.joints:
        yield from joint_checks(task.joints[joint.part], _seat(task, joint.part, attempt.bore), joint)


def _sits(stretch: Stretch) -> str:
    return "" if stretch.kind == "between" else stretch.name


def _mass(gear: GearSizing) -> float:
    return gear.mass * gear.bodies / len(gear.shafts)
