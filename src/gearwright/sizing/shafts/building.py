"""A shaft that the design gives bearings, built: stretches thick enough, bearings that live, joints that hold.

Forces do not depend on diameters, as two bearings are statically determinate. So a shaft is built from thin to thick:
stretches are laid, every section is judged, and what is too weak grows by the cube root of what its safety lacks, until
nothing does. Then slopes are judged, and the whole shaft grows by their fourth root. Sizes that the user gives stay. On
a shaft that the user gives as a whole nothing grows and nothing is refused: `as_given` says what does not fit.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from gearwright.catalogue import Bearing
from gearwright.checks import Check
from gearwright.errors import DesignError
from gearwright.parts import Material
from gearwright.parts.shafts import shaft_mass
from gearwright.ranking import smallest_first
from gearwright.sizing.bearings import Seating, bearing_sizings, seating
from gearwright.sizing.loads import ShaftForces
from gearwright.sizing.mounted import BearingSizing, BuiltShaft, JointSizing, ShaftStep
from gearwright.sizing.rating import Context
from gearwright.sizing.result import GearSizing
from gearwright.sizing.shafts.as_given import joint_checks, room_checks, seat_checks
from gearwright.sizing.shafts.attempt import Attempt, Task, attempt_with, items_on, sealed, seat_of
from gearwright.sizing.shafts.bending import Bent, bend, slope_excess
from gearwright.sizing.shafts.joints import joint_fits, refuse_long, refuse_thick
from gearwright.sizing.shafts.room import refuse_overlaps, refuse_thin
from gearwright.sizing.shafts.sections import NO_LIMIT, strengths
from gearwright.sizing.shafts.stretches import Stretch
from gearwright.spec.checks import MOST_HOLLOW
from gearwright.spec.design import Joint

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
    task = Task(context, name, forces, material, borne, core, joints)
    settled: list[tuple[bool, Seating, Attempt]] = []
    refused: dict[bool, DesignError] = {}
    for slim in (True, False):
        try:
            settled.append((slim, *_settled(task, slim=slim)))
        except DesignError as error:
            refused[slim] = error
    for slim, seated, attempt in smallest_first(settled, lambda tried: _weight(tried[1], tried[2], material)):
        try:
            return _finished(task, seated, sealed(task, attempt))
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


def _settled(task: Task, *, slim: bool) -> tuple[Seating, Attempt]:
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


def _stiff(task: Task, seated: Seating) -> Attempt:
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


def _bent(task: Task, attempt: Attempt) -> Bent:
    """Return the shaft bent by what acts on it, once for each shape."""
    shape = attempt.stretches, attempt.bore
    if shape not in task.bent:
        task.bent[shape] = bend(task.forces, attempt.stretches, task.material, bore=attempt.bore)
    return task.bent[shape]


def _free(attempt: Attempt) -> tuple[Stretch, ...]:
    """Return the stretches that may grow; gears of one piece grow with what lies beside them."""
    return tuple(stretch for stretch in attempt.stretches if stretch.kind != "integral")


def _strong(task: Task, seated: Seating, needed: Mapping[str, float]) -> Attempt:
    """Return a shaft in which every section is strong enough and every joint holds."""
    wanted, before = dict(needed), None
    for _ in range(ROUNDS):
        attempt = attempt_with(task, seated, wanted)
        grown = {**wanted, **_grown(task, attempt, wanted)}
        if grown == wanted or attempt == before:
            break
        wanted, before = grown, attempt
    return attempt


def _grown(task: Task, attempt: Attempt, wanted: Mapping[str, float]) -> dict[str, float]:
    """Return what must be thicker."""
    service = task.context.design.service
    diameters = {stretch.name: stretch.diameter for stretch in attempt.stretches}
    walled = attempt.bore / MOST_HOLLOW
    thicker = {stretch.name: walled for stretch in _free(attempt) if stretch.diameter < walled - 1e-9}
    for section, held in zip(attempt.sections, attempt.borne, strict=True):
        owner, safeties = section.owner, (min(held.fatigue), held.yielding)
        asked = (service.shaft_fatigue_safety, service.shaft_yield_safety)
        ratio = min(min(safety, NO_LIMIT) / least for safety, least in zip(safeties, asked, strict=True))
        if ratio < 1.0 - 1e-9:
            growth = min(max(ratio ** (-1.0 / 3.0), LEAST_GROWTH), MOST_GROWTH) if ratio > 0.0 else MOST_GROWTH
            thicker[owner] = max(thicker.get(owner, 0.0), wanted.get(owner, 0.0), growth * diameters[owner])
    for joint in attempt.joints:
        seat = seat_of(task, joint.part, attempt.bore)
        if joint.part in diameters and not joint_fits(task.joints[joint.part], seat, joint):
            thicker[joint.part] = max(thicker.get(joint.part, 0.0), joint.diameter + 1e-3)
    return thicker


def _finished(task: Task, seated: Seating, attempt: Attempt) -> Built:
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
    sized = bearing_sizings(seated, attempt.chosen, task.name, tuple(task.context.flows))
    return Built(
        shaft, sized, attempt.joints, () if task.as_given is None else tuple(_fits(task, attempt, task.as_given))
    )


def _refuse(task: Task, attempt: Attempt) -> None:
    """Raise where parts do not fit."""
    refuse_overlaps(items_on(task, attempt.chosen), task.forces.plan.length)
    refuse_thin(task.name, attempt.stretches, bore=attempt.bore)
    for joint in attempt.joints:
        seat = seat_of(task, joint.part, attempt.bore)
        refuse_long(task.joints[joint.part], seat, joint)
        refuse_thick(joint, seat)


def _fits(task: Task, attempt: Attempt, diameter: float) -> Iterator[Check]:
    """Yield whether the parts of a shaft that is taken as given fit."""
    yield from room_checks(task.name, items_on(task, attempt.chosen), task.forces.plan.length)
    yield from seat_checks(diameter, attempt.chosen)
    for joint in attempt.joints:
        yield from joint_checks(task.joints[joint.part], seat_of(task, joint.part, attempt.bore), joint)


def _sits(stretch: Stretch) -> str:
    return "" if stretch.kind == "between" else stretch.name


def _mass(gear: GearSizing) -> float:
    return gear.mass * gear.bodies / len(gear.shafts)
