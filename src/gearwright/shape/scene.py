"""The verb: a sized gearbox as solids, each where it stands, turned so that teeth mesh, with its speeds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from gearwright.errors import Problem, near, refuse
from gearwright.identity import Kind, PartId, Role, carrier_part
from gearwright.parts.gears import Blank
from gearwright.shape.carriers import (
    bridge_axes,
    bridge_solid,
    held_at,
    pin_solid,
    planet_bearing,
    plate_outline,
    plate_solid,
)
from gearwright.shape.contacts import contacts_of
from gearwright.shape.gears import Leaning, gear_solid, leanings
from gearwright.shape.housing import housing_nodes
from gearwright.shape.phases import Phases, phases_of
from gearwright.shape.record import Node, Scene
from gearwright.shape.shafts import bearing_bodies, bearing_solid, bell_solid, holder_solid, seat_solids, shaft_solid
from gearwright.shape.solids import Chamber, Fastener, Fineness, Solid
from gearwright.shape.stands import Axes, Stand, axes_at, middle_of, set_frame, stands_of
from gearwright.shape.teeth import halves_of, kind_of
from gearwright.shape.words import approximations
from gearwright.sizing import Sizing
from gearwright.sizing.casing import ring_frame, ring_seats
from gearwright.sizing.mass import Cage, bell_name, cage_of, gear_blanks, seat_names
from gearwright.sizing.places import Run, bells, runs
from gearwright.sizing.shafts import holders_of
from gearwright.verbs import verb

DETAILS: Mapping[str, Fineness] = {
    "fine": Fineness(3, 4, 48, 0.06, 6),
    "coarse": Fineness(2, 2, 30, 0.2, 3),
    "smooth": Fineness(8, 10, 90, 0.03, 6),
}
"""Level of detail -> how finely surfaces are cut."""
PLACES = 12
"""Decimals to which plates of a carrier are equal that share a solid [m]."""


@verb
def scene(sizing: Sizing, *, detail: Literal["fine", "coarse", "smooth"] = "fine") -> Scene:
    """Return a sized gearbox as solids: teeth of the true tool, bodies as weighed, shafts, carriers, bearings.

    Args:
        sizing: As sized.
        detail: ``fine``, ``coarse`` with half of the gears' triangles, or ``smooth`` with the points that splines need.

    >>> import gearwright as gw
    >>> scene = gw.scene(gw.size(gw.read("in-line-h2")))
    >>> round(scene.by_name["first.sun"].spins["rated"] / scene.by_name["first.carrier"].spins["rated"], 4)
    4.4444
    """
    if detail not in DETAILS:
        refuse([Problem("detail", f"{detail!r} is no level of detail; {near(detail, list(DETAILS))}")])
    stands = stands_of(sizing)
    leaning, contacts = leanings(sizing, stands), contacts_of(sizing, stands)
    phases = phases_of(sizing, stands, contacts, {name: lean.turning for name, lean in leaning.items()})
    drawn, shortened = runs(sizing)
    cages = {carrier.stage: cage_of(sizing, carrier, drawn) for carrier in sizing.carriers}
    task = _Task(sizing, DETAILS[detail], stands, leaning, phases, gear_blanks(sizing), drawn, cages)
    nodes = [
        *_carriers(task),
        *_gears(task),
        *_shafts(task),
        *_on_pins(task),
        *_bearings(task),
        *_bells(task),
        *_seats(task),
        *_holders(task),
    ]
    nodes += _housing(task, nodes)
    words = (*approximations(sizing, phases), *shortened)
    return Scene(sizing.design.name, task.solids, task.fine.circle, tuple(nodes), tuple(sizing.flows), words)


@dataclass(frozen=True)
class _Task:
    """What a scene is made of."""

    sizing: Sizing
    fine: Fineness
    stands: tuple[Stand, ...]
    leaning: Mapping[str, Leaning]
    phases: Phases
    blanks: Mapping[str, Blank]
    runs: tuple[Run, ...]
    cages: Mapping[str, Cage]
    """Set -> its carrier as it is made."""
    solids: dict[str, Solid | Chamber | Fastener] = field(default_factory=dict)

    def spins(self, node: str, carrier: str = "") -> dict[str, float]:
        """Return load case -> speed of a node about its own axis, against a carrier [rad/s]."""
        sense = self.phases.senses[node]
        base = {case: flow.speeds[carrier] if carrier else 0.0 for case, flow in self.sizing.flows.items()}
        return {case: sense * (flow.speeds[node] - base[case]) for case, flow in self.sizing.flows.items()}


def _carriers(task: _Task) -> Iterator[Node]:
    """Yield both plates of every carrier, then its bridges, which go round with the first plate."""
    sizing = task.sizing
    for carrier in sizing.carriers:
        frame, cage = set_frame(sizing, carrier.stage), task.cages[carrier.stage]
        own = [stand for stand in task.stands if stand.gear.stage == carrier.stage and stand.carrier]
        axes = axes_at(frame, middle_of(cage.plates[0].body))
        held = held_at(cage, axes, own)
        cut: dict[tuple[float, ...], str] = {}
        for k, plate in enumerate(cage.plates):
            label = str(carrier.part) if k == 0 else f"{carrier.part}, plate {k + 1}"
            alike = tuple(round(size, PLACES) for size in (*plate_outline(plate), plate.body.length))
            surface = cut.setdefault(alike, label)
            if surface == label:
                task.solids[label] = plate_solid(cage, plate, held, task.fine.circle)
            place = axes_at(frame, middle_of(plate.body))
            yield Node(label, carrier.part, "carrier", surface, place, 0.0, task.spins(carrier.shaft))
        if cage.bridge is None:
            continue
        key = f"{carrier.part} bridge"
        task.solids[key] = bridge_solid(cage, cage.bridge)
        still, on = dict.fromkeys(sizing.flows, 0.0), str(carrier.part)
        for k, arm in enumerate(arm for arm in held if not arm.is_round):
            place = bridge_axes(cage, cage.bridge.radius, axes, arm.angle)
            yield Node(f"{key} {k + 1}", carrier.part, "carrier", key, place, 0.0, still, on)


def _gears(task: _Task) -> Iterator[Node]:
    sizing = task.sizing
    for stand in task.stands:
        lean, part = task.leaning[stand.name], stand.part._replace(number=None)
        phase, axes = task.phases.turned[stand.name], stand.axes
        if _faces_back(sizing, task, stand):  # built with its tips towards −z
            axes, phase = _flipped(axes), -phase
        key = f"{stand.gear.name} {lean.hand:+.0f}" if lean.hand else stand.gear.name
        if key not in task.solids:
            task.solids[key] = gear_solid(sizing, stand, lean, task.blanks, fine=task.fine)
        spins = task.spins(stand.node, stand.carrier)
        if axes is not stand.axes:
            spins = {case: -speed for case, speed in spins.items()}
        on = str(carrier_part(stand.gear.stage)) if stand.carrier else ""
        yield Node(stand.name, part, str(stand.gear.role), key, axes, phase, spins, on)


def _faces_back(sizing: Sizing, task: _Task, stand: Stand) -> bool:
    """Tell whether the tips of a bevel or face gear look along its shaft, from the first end to the second."""
    kind = kind_of(sizing, stand.gear.stage)
    if kind == "bevel":
        pair = sizing.design.pairs[stand.gear.stage]
        return (pair.pinion_apex if stand.gear.role is Role.PINION else pair.wheel_apex) == "second"
    if kind == "face" and stand.gear.role is Role.WHEEL:
        pinion = next(one for one in task.stands if one.gear.stage == stand.gear.stage and one.gear is not stand.gear)
        return float((pinion.axes.origin - stand.axes.origin) @ stand.axes.along) > 0.0
    return False


def _flipped(axes: Axes) -> Axes:
    """Return axes turned by half a turn about x, so that z looks the other way."""
    return Axes(axes.origin, axes.turned * np.array([1.0, -1.0, -1.0]))


def _shafts(task: _Task) -> Iterator[Node]:
    for run in task.runs:
        frame, part = task.sizing.arrangement.frames[run.shaft], PartId(Kind.SHAFT, run.shaft)
        middle = (run.steps[0][0] + run.steps[-1][1]) / 2.0
        label = run.label
        task.solids[label] = shaft_solid(run, middle)
        place = np.asarray(frame.origin) + middle * np.asarray(frame.along)
        yield Node(label, part, "shaft", label, axes_at(frame, place), 0.0, task.spins(run.shaft))


def _on_pins(task: _Task) -> Iterator[Node]:
    """Yield the pins of planets, and what planets turn on."""
    sizing = task.sizing
    carriers = {carrier.stage: carrier for carrier in sizing.carriers}
    seen = set()
    for stand in task.stands:
        if not stand.carrier:
            continue
        carrier = carriers[stand.gear.stage]
        on, still = str(carrier.part), dict.fromkeys(sizing.flows, 0.0)
        if (stand.node, stand.place) not in seen:
            seen.add((stand.node, stand.place))
            key = f"{stand.node} pin"
            task.solids.setdefault(key, pin_solid(task.cages[carrier.stage], stand.axes))
            yield Node(f"{stand.node} pin {stand.place + 1}", carrier.part, "pin", key, stand.axes, 0.0, still, on)
        blank = task.blanks[stand.gear.name]
        ring = planet_bearing(carrier, stand.gear, blank, halves_of(stand.gear))
        if ring is not None:
            key, part = f"{stand.gear.name} bearing", stand.gear.part._replace(kind=Kind.BEARING)
            task.solids.setdefault(key, ring)
            yield Node(f"{stand.name} bearing", part, "bearing", key, stand.axes, 0.0, still, on)


def _bearings(task: _Task) -> Iterator[Node]:
    frames = task.sizing.arrangement.frames
    for part, body in bearing_bodies(task.sizing):
        label = f"bearing {part}"
        task.solids[label] = bearing_solid(body)
        axes = axes_at(frames[body.shaft], middle_of(body))
        yield Node(label, part, "bearing", label, axes, 0.0, dict.fromkeys(task.sizing.flows, 0.0))


def _bells(task: _Task) -> Iterator[Node]:
    """Yield what joins turning rings to their shafts."""
    for bell in bells(task.sizing):
        shaft, label = bell.ring.shafts[0], bell_name(bell.ring)
        frame = task.sizing.arrangement.frames[shaft]
        task.solids[label] = bell_solid(bell)
        place = np.asarray(frame.origin) + bell.middle * np.asarray(frame.along)
        yield Node(label, bell.ring.part, "bell", label, axes_at(frame, place), 0.0, task.spins(shaft))


def _seats(task: _Task) -> Iterator[Node]:
    """Yield the splines of rings that stand in the housing, and what keeps them there."""
    still = dict.fromkeys(task.sizing.flows, 0.0)
    for seat in ring_seats(task.sizing):
        frame, place = ring_frame(task.sizing, seat.ring)
        axes = axes_at(frame, np.asarray(frame.origin) + place * np.asarray(frame.along))
        for name, solid in zip(seat_names(seat.ring), seat_solids(seat), strict=True):
            task.solids[name] = solid
            yield Node(name, seat.ring.part, "seat", name, axes, 0.0, still)


def _holders(task: _Task) -> Iterator[Node]:
    """Yield rings, nuts, end plates, spacers and covers."""
    for holder in holders_of(task.sizing):
        frame, part = task.sizing.arrangement.frames[holder.shaft], PartId(Kind.BEARING, holder.beside)
        task.solids[holder.name] = holder_solid(holder)
        place = np.asarray(frame.origin) + (holder.start + holder.end) / 2.0 * np.asarray(frame.along)
        spins = task.spins(holder.shaft) if holder.turns else dict.fromkeys(task.sizing.flows, 0.0)
        yield Node(holder.name, part, "holder", holder.name, axes_at(frame, place), 0.0, spins)


def _housing(task: _Task, nodes: Sequence[Node]) -> Iterator[Node]:
    """Yield the pieces of the housing around bodies that turn about the axes of their shafts."""
    central = [node for node in nodes
               if node.look == "carrier" or not (node.on or node.look in ("bearing", "holder", "seat"))]  # fmt: skip
    inside = [(node, solid) for node in central if isinstance(solid := task.solids[node.surface], Solid)]
    for node, solid in housing_nodes(task.sizing, task.runs, inside):
        task.solids.setdefault(node.surface, solid)
        yield node
