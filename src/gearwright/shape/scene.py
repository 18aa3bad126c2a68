"""A sized gearbox as solids, turned so that teeth mesh, with its speeds; what it weighs; its file (GLB)."""

import json
import math
import struct
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import HOUSING, Floats, Kind, Mass, PartId, Problem, Role, carrier_part, near, refuse, verb
from gearwright.catalogue import STEEL_DENSITY, housing_materials
from gearwright.parts.gears import Blank
from gearwright.shape.bodies import (
    CHAMBER,
    INNER,
    Leaning,
    bearing_bodies,
    bearing_solid,
    bell_solid,
    bridge_axes,
    bridge_solid,
    gear_solid,
    held_at,
    holder_solid,
    housing_nodes,
    leanings,
    pin_solid,
    planet_bearing,
    plate_outline,
    plate_solid,
    seat_solids,
    shaft_solid,
)
from gearwright.shape.casings import FLANGES, MOUNT, RIB, SCREW
from gearwright.shape.chambers import Chamber
from gearwright.shape.solids import Fastener, Fineness, Solid
from gearwright.shape.stands import (
    Axes,
    Contact,
    Node,
    Scene,
    Stand,
    axes_at,
    contacts_of,
    halves_of,
    kind_of,
    middle_of,
    set_frame,
    stands_of,
    triangles_of,
)
from gearwright.shape.surfaces import Surface
from gearwright.sizing import Sizing, tips_in_fillets
from gearwright.sizing.casing import ring_frame, ring_seats
from gearwright.sizing.mass import Cage, bell_name, cage_of, complete_mass, gear_blanks, seat_names
from gearwright.sizing.places import Run, bells, plates_of, runs
from gearwright.sizing.shafts import holders_of
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# How every gear is turned so that teeth stand in gaps, and which way every shaft turns in space.
#
# Two gears mesh where z_1 (φ_1 − θ_1) − s z_2 (φ_2 − θ_2) is an odd number of half turns: φ says where a tooth of
# each stands, θ where they touch and s which way teeth go there (`contacts`); a helix adds what it turns by along the
# axis from one gear's middle to the other's. A gear on a shaft is turned freely against its neighbours there, planets
# of equal sets alike: the steps of all stepped planets stand to each other as those of the first.
# ----------------------------------------------------------------------------------------------------------------------


CLOSES = 1e-6
"""Of a pitch by which a mesh may miss the middle of its gap and is still met [-]."""


class Phases(NamedTuple):
    """How all gears stand."""

    turned: Mapping[str, float]
    """Gear -> angle of the middle of one of its teeth [rad]."""
    missed: Mapping[str, float]
    """Mesh, as its two gears -> how far its teeth stand beside the middle of their gaps, in pitches [-]; those that
    are met left out."""
    senses: Mapping[str, float]
    """Shaft or planets' node -> +1 where it turns about its own axis as the speeds of the train count, −1 where
    against it [-]."""
    against: tuple[str, ...]
    """Meshes whose shafts cannot turn in space as the train's speeds say."""


def helix_rate(stand: Stand, hand: float) -> float:
    """Return by how much the teeth of a cylindrical gear turn along its axis [rad/m].

    Args:
        stand: The gear.
        hand: +1 right, −1 left.
    """
    return hand * math.tan(stand.gear.helix_angle) / (stand.gear.pitch_diameter / 2.0)


def phases_of(
    sizing: Sizing, stands: Sequence[Stand], contacts: Sequence[Contact], hands: Mapping[str, float]
) -> Phases:
    """Return how every gear stands.

    Args:
        sizing: As sized.
        stands: Its gears.
        contacts: Their meshes.
        hands: Gear -> +1 for a right-hand helix, −1 for a left-hand one, 0 for straight or double-helical teeth.
    """
    turned: dict[str, float] = {}
    steps: dict[tuple[str, str], float] = {}
    for start in _ordered(stands):
        if start.name not in turned:
            turned[start.name] = 0.0
            _spread(contacts, stands, turned, steps, hands)
    missed = {}
    for contact in contacts:
        off = residual(contact, turned, hands)
        if abs(off) > CLOSES:
            missed[f"{contact.first.name} and {contact.second.name}"] = off
    senses, against = _senses(sizing, contacts)
    return Phases(turned, missed, senses, against)


def residual(contact: Contact, turned: Mapping[str, float], hands: Mapping[str, float]) -> float:
    """Return how far a mesh is from teeth in the middle of gaps, in pitches, within ±½.

    Args:
        contact: The mesh.
        turned: Gear -> where its teeth stand [rad].
        hands: Of their helices.
    """
    one, other = contact.first, contact.second
    lean = helix_rate(other, hands[other.name]) * contact.offset
    first = one.gear.teeth * (turned[one.name] - contact.angles[0])
    second = other.gear.teeth * (turned[other.name] - lean - contact.angles[1])
    off = (first - contact.sense * second) / (2.0 * math.pi) - 0.5
    return off - round(off)


def _ordered(stands: Sequence[Stand]) -> Iterator[Stand]:
    """Yield the gears in the order in which their turns are free: suns and pinions first."""
    order = (Role.SUN, Role.PINION, Role.WHEEL, Role.PLANET, Role.RING)
    yield from sorted(stands, key=lambda stand: (order.index(stand.gear.role), stand.place))


def _spread(
    contacts: Sequence[Contact],
    stands: Sequence[Stand],
    turned: dict[str, float],
    steps: dict[tuple[str, str], float],
    hands: Mapping[str, float],
) -> None:
    """Turn every gear that meshes with a turned one, or is one piece with it, until none is left."""
    moved = True
    while moved:
        moved = False
        for contact in sorted(contacts, key=lambda contact: max(contact.first.place, contact.second.place)):
            known = [stand.name in turned for stand in (contact.first, contact.second)]
            if sum(known) != 1:
                continue
            new = contact.second if known[0] else contact.first
            turned[new.name] = 0.0
            turned[new.name] = _closing(contact, new, turned, hands)
            if new.carrier:
                _one_piece(new, contacts, stands, turned=turned, steps=steps, hands=hands)
            moved = True
            break


def _closing(contact: Contact, new: Stand, turned: Mapping[str, float], hands: Mapping[str, float]) -> float:
    """Return the angle at which a gear that stands at 0 meshes."""
    off = residual(contact, turned, hands) * 2.0 * math.pi / new.gear.teeth
    return -off if new is contact.first else contact.sense * off


def _one_piece(
    new: Stand, contacts: Sequence[Contact], stands: Sequence[Stand],
    *, turned: dict[str, float], steps: dict[tuple[str, str], float], hands: Mapping[str, float],
) -> None:  # fmt: skip
    """Turn the other steps of a planet as the first planet has them, by the whole teeth that let all of them mesh."""
    others = [stand for stand in stands if stand.node == new.node and stand.place == new.place and stand is not new]
    others = [stand for stand in others if (new.gear.name, stand.gear.name) in steps or new.place == 0]
    if not others:
        return
    for other in others:
        if new.place == 0 and (new.gear.name, other.gear.name) not in steps:
            meshes = [c for c in contacts if other in (c.first, c.second)
                      and (c.second if c.first is other else c.first).name in turned]  # fmt: skip
            turned[other.name] = 0.0
            if meshes:
                turned[other.name] = _closing(meshes[0], other, turned, hands)
            steps[new.gear.name, other.gear.name] = turned[other.name] - turned[new.name]
            steps[other.gear.name, new.gear.name] = turned[new.name] - turned[other.name]
    base, best = turned[new.name], (math.inf, 0.0)
    for k in range(new.gear.teeth):
        trial = base + 2.0 * math.pi * k / new.gear.teeth
        placed = {**turned, new.name: trial}
        placed |= {other.name: trial + steps[new.gear.name, other.gear.name] for other in others}
        ends = {new.name, *(other.name for other in others)}
        offs = [abs(residual(c, placed, hands)) for c in contacts
                if {c.first.name, c.second.name} & ends and {c.first.name, c.second.name} <= placed.keys()]  # fmt: skip
        best = min(best, (round(max(offs, default=0.0), 9), trial))
    turned[new.name] = best[1]
    turned |= {other.name: best[1] + steps[new.gear.name, other.gear.name] for other in others}


def _senses(sizing: Sizing, contacts: Sequence[Contact]) -> tuple[dict[str, float], tuple[str, ...]]:
    """Return which way shafts turn in space; what is in line turns as the train counts."""
    ties: list[tuple[str, str, float, str]] = []
    for contact in contacts:
        if contact.mesh.stage in sizing.design.pairs:
            ends = contact.mesh.nodes[:2]
            ties.append((ends[0], ends[1], contact.sense * contact.mesh.sign, contact.mesh.name))
    for stage in sizing.design.sets.values():
        ties += [(stage.members[0], shaft, 1.0, "") for shaft in stage.members[1:]]
    ties += [(link.driving, link.driven, 1.0, "") for link in sizing.train.links]
    senses: dict[str, float] = {"ground": 1.0}
    ties = [tie for tie in ties if "ground" not in tie[:2]] + _past_ground(sizing)
    for start in sizing.design.shafts:
        if start in senses:
            continue
        senses[start] = 1.0
        moved = True
        while moved:
            moved = False
            for first, second, sign, _ in ties:
                for here, there in ((first, second), (second, first)):
                    if here in senses and there not in senses:
                        senses[there] = senses[here] * sign
                        moved = True
    for gear in sizing.train.gears:
        if gear.role is Role.PLANET:
            members = [shaft for shaft in sizing.design.sets[gear.stage].members if shaft != "ground"]
            senses[gear.nodes[0]] = senses[members[0]]
    against = tuple(dict.fromkeys(name for first, second, sign, name in ties
                                  if senses[first] * sign != senses[second] and np.isfinite(sign)))  # fmt: skip
    return senses, against


def _past_ground(sizing: Sizing) -> list[tuple[str, str, float, str]]:
    """Return what joins the turning members of sets of which one stands still."""
    found = []
    for stage in sizing.design.sets.values():
        moving = [shaft for shaft in stage.members if shaft != "ground"]
        found += [(moving[0], shaft, 1.0, "") for shaft in moving[1:]]
    return found


# ----------------------------------------------------------------------------------------------------------------------
# What of a scene is not as it would be made, in sentences.
# ----------------------------------------------------------------------------------------------------------------------


BESIDE = 1e-3
"""How far gears in mesh may stand from each other along their axes before it is said [m]."""


def approximations(sizing: Sizing, phases: Phases) -> tuple[str, ...]:
    """Return what is approximated, assumed or cannot be, as far as it concerns this gearbox.

    Args:
        sizing: As sized.
        phases: How its gears stand.
    """
    told = [one.sentence for one in tips_in_fillets(sizing)]
    return (*_teeth(sizing), *_bodies(sizing), *told, *_meets(sizing, phases))


def _teeth(sizing: Sizing) -> Iterator[str]:
    kinds = {kind_of(sizing, gear.stage) for gear in sizing.gears}
    if "bevel" in kinds:
        yield "bevel teeth are those of Tredgold's virtual gears, spirals cross the cone at a constant angle"
    if "face" in kinds:
        yield "teeth of face gears are racks in every cylinder about the axis; their wheels' bodies are assumed"
    if any(gear.rim for gear in sizing.gears):
        yield "roots of rings are those of a shaper with as many teeth as their smallest mate"
    if any(halves_of(gear) > 1 for gear in sizing.gears):
        yield "double helices have no gap between their halves"
    yield "teeth have no backlash, crowning or tip relief"


def _bodies(sizing: Sizing) -> Iterator[str]:
    for carrier in sizing.carriers:
        if len(plates_of(sizing, carrier.stage)) == 1:
            yield f"{carrier.part} has one plate: beyond its planets another body stands where a second one would"
    if any(gear.rim and gear.shafts[0] in sizing.arrangement.frames for gear in sizing.gears):
        yield "bells that tie turning rings to their shafts are assumed"
    if sizing.bearings:
        yield "bearings are envelopes with the rings and the row of rolling elements assumed"
    if sizing.design.housing.own:
        yield (
            "the housing is the shell of the complete mass, a statistical one, as thick as it is weighed, with its "
            "flanges and their screws, ribs and mounts, bosses around sized bearings and what carries these; openings "
            "for shafts of a first sizing that leave it across the first one are left out"
        )
    if any(holder.lip for holder in holders_of(sizing)):
        yield "radial seals are rings of their sizes, without the lip's form"
    yield "labyrinths and other seals, other screws, machines and what holds rings that stand still are not drawn"


def _meets(sizing: Sizing, phases: Phases) -> Iterator[str]:
    for mesh, off in phases.missed.items():
        yield f"the teeth of {mesh} miss each other's gaps by {abs(off):.2f} of a pitch: the loop does not close"
    for mesh in phases.against:
        yield f"the shafts of {mesh} cannot turn in space as the speeds of the train have them"
    for mesh, off in sizing.arrangement.apart.items():
        if abs(off) > BESIDE:
            yield f"the gears of {mesh} stand {1e3 * abs(off):.3g} mm beside each other along their axes"


# ----------------------------------------------------------------------------------------------------------------------
# The verb: a sized gearbox as solids, each where it stands, turned so that teeth mesh, with its speeds.
# ----------------------------------------------------------------------------------------------------------------------


DETAILS: Mapping[str, Fineness] = {
    "fine": Fineness(3, 4, 48, 0.06, 6),
    "coarse": Fineness(2, 2, 30, 0.2, 3),
    "smooth": Fineness(8, 10, 90, 0.03, 6),
}
"""Level of detail -> how finely surfaces are cut."""
PLATE_PLACES = 12
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
            alike = tuple(round(size, PLATE_PLACES) for size in (*plate_outline(plate), plate.body.length))
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
            axes, phase = Axes(axes.origin, axes.turned * np.array([1.0, -1.0, -1.0])), -phase
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


# ----------------------------------------------------------------------------------------------------------------------
# What the solids of a scene weigh, beside what sizing has for the same parts.
# ----------------------------------------------------------------------------------------------------------------------


PARTS = {
    "housing flanges": FLANGES, "housing bolts": SCREW, "housing ribs": RIB, "housing mounts": MOUNT,
    "housing inner walls": INNER,
}  # fmt: skip
"""What of a housing is drawn as it is weighed -> word in the names of its bodies."""
NEAR = 5e-3
"""By how much what is drawn may differ from what is weighed [-]."""
CORNERS = 720
"""Of circles whose volumes are taken: their chords lose 1.3e-5 [-]."""


@dataclass(frozen=True)
class SolidMass:
    """One kind of equal bodies, or all pieces of a carrier."""

    part: PartId
    bodies: int
    """Equal ones in the scene [-]."""
    solid: Mass
    """Of one as drawn: the volume of its solid, circles round, times the density of its material [kg]."""
    sized: Mass | None
    """Of one in the sizing's mass, by which designs are chosen; None of a housing, which is not in it [kg]."""
    weighed: Mass | None
    """Of one in the complete mass; None where that counts it within something else [kg]."""


def solid_masses(sizing: Sizing, scene: Scene) -> tuple[SolidMass, ...]:
    """Return what gears, shafts, carriers and a housing's shell weigh as drawn, as sized and in the complete mass.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    weighed = {(item.group, item.part): item.each for item in complete_mass(sizing).parts}
    exact = {name: triangles_of(solid, CORNERS).volume for name, solid in scene.solids.items()}
    found = []
    for gear in sizing.gears:
        nodes = [node for node in scene.nodes if node.part.kind is Kind.GEAR and _of(node, gear.stage, gear.part)]
        density = sizing.design.gear_material(gear.stage).density
        volume = sum(exact[node.surface] for node in nodes) / gear.bodies
        found.append(SolidMass(gear.part, gear.bodies, volume * density, gear.mass, weighed.get(("gears", gear.name))))
    density = sizing.design.shaft_material.density
    volumes: defaultdict[str, float] = defaultdict(float)
    for node in scene.nodes:
        if node.part.kind in (Kind.SHAFT, Kind.CARRIER):
            volumes[str(node.part)] += exact[node.surface]
    for shaft in sizing.shafts:
        part = PartId(Kind.SHAFT, shaft.name)
        solid = volumes[shaft.name] * density
        found.append(SolidMass(part, 1, solid, shaft.mass, weighed.get(("shafts", shaft.name))))
    for carrier in sizing.carriers:
        solid = volumes[str(carrier.part)] * density
        found.append(SolidMass(carrier.part, 1, solid, carrier.mass, weighed.get(("carriers", str(carrier.part)))))
    chambers = [node for node in scene.nodes if node.part == HOUSING and CHAMBER in node.name]
    if chambers:
        density = housing_materials()[sizing.design.housing.material].density
        solid = sum(exact[node.surface] for node in chambers) * density
        found.append(SolidMass(HOUSING, 1, solid, None, weighed.get(("housing", "housing shell"))))
    return tuple(found)


def casing_masses(sizing: Sizing, scene: Scene) -> dict[str, tuple[float, float]]:
    """Return what is drawn of a housing but its shell -> what its solids weigh, and what the complete mass has [kg].

    Args:
        sizing: As sized.
        scene: Of it.
    """
    weighed = {item.part: item.count * item.each for item in complete_mass(sizing).parts if item.group == "housing"}
    material = housing_materials()[sizing.design.housing.material]
    exact = {name: triangles_of(scene.solids[name], CORNERS).volume
             for name in {node.surface for node in scene.nodes if node.part == HOUSING}}  # fmt: skip
    volumes: dict[str, float] = dict.fromkeys(set(PARTS) & weighed.keys(), 0.0)
    for node in scene.nodes:
        part = next((part for part, word in PARTS.items() if f"housing, {word} " in node.name), "")
        if part in weighed:
            volumes[part] += exact[node.surface]
    density = {part: STEEL_DENSITY if word == SCREW else material.density for part, word in PARTS.items()}
    return {part: (volume * density[part], weighed[part]) for part, volume in volumes.items()}


def short_of(sizing: Sizing, scene: Scene) -> dict[str, tuple[float, float]]:
    """Return what of a housing is drawn otherwise than it is weighed, as `casing_masses`: walls leave no more room.

    Args:
        sizing: As sized.
        scene: Of it.
    """
    drawn = casing_masses(sizing, scene)
    return {part: masses for part, masses in drawn.items() if abs(masses[0] - masses[1]) > NEAR * masses[1]}


def _of(node: Node, stage: str, part: PartId) -> bool:
    same = (node.part.name, node.part.role, node.part.own) == (stage, part.role, part.own)
    return same and node.look not in ("bell", "seat")


# ----------------------------------------------------------------------------------------------------------------------
# A scene as a binary glTF 2.0 file, which browsers, slides and modellers open: one mesh a surface, one node a body.
#
# It asks readers for no extension of glTF; arrays that are equal to the bit, as those of tubes with equal corners are,
# are written once.
#
# Every node says in its extras whose body it is, as what it is painted, and how fast it turns about its own z in every
# load case; planets are children of their carrier and turn against it.
# ----------------------------------------------------------------------------------------------------------------------


COLOURS: Mapping[str, tuple[float, float, float]] = {
    "sun": (0.80, 0.33, 0.18),
    "pinion": (0.80, 0.33, 0.18),
    "planet": (0.20, 0.46, 0.72),
    "wheel": (0.20, 0.46, 0.72),
    "ring": (0.50, 0.54, 0.58),
    "bell": (0.50, 0.54, 0.58),
    "seat": (0.50, 0.54, 0.58),
    "shaft": (0.70, 0.71, 0.70),
    "pin": (0.70, 0.71, 0.70),
    "carrier": (0.85, 0.63, 0.13),
    "bearing": (0.33, 0.60, 0.53),
    "holder": (0.36, 0.39, 0.44),
    "screw": (0.36, 0.39, 0.44),
    "housing": (0.62, 0.68, 0.74),
}
"""What a body is -> its colour, red, green and blue, told apart by those who do not tell red from green [-]."""
SEEN_THROUGH = 0.25
"""How much of a housing is seen of what is seen through it [-]."""
PLACES = 12
"""Decimals of places [m] and of quaternions [-]: beyond what readers of single precision see."""
_FLOAT, _SHORT, _LONG = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963


def glb(scene: Scene) -> bytes:
    """Return a scene as a binary glTF 2.0 file, lengths in metres.

    Args:
        scene: The scene.

    Source: glTF 2.0 specification, Khronos Group (ISO/IEC 12113:2022): header, a JSON chunk, a binary chunk.

    >>> import gearwright as gw
    >>> glb(gw.scene(gw.size(gw.read("off-set")), detail="coarse"))[:4]
    b'glTF'
    """
    buffer = _Buffer()
    looks = list(dict.fromkeys(node.look for node in scene.nodes))
    meshes: dict[tuple[str, str], int] = {}
    listed: list[dict[str, Any]] = []
    attributes = {key: _attributes(buffer, surface) for key, surface in scene.surfaces.items()}
    for node in scene.nodes:
        key = (node.surface, node.look)
        if node.surface and key not in meshes:
            meshes[key] = len(listed)
            primitive = {**attributes[node.surface], "material": looks.index(node.look)}
            listed.append({"name": node.surface, "primitives": [primitive]})
    document = {
        "asset": {"version": "2.0", "generator": f"gearwright {__version__}"},
        "scene": 0,
        "scenes": [
            {
                "name": scene.name,
                "nodes": [k for k, node in enumerate(scene.nodes) if not node.on],
                "extras": {"cases": list(scene.cases), "approximations": list(scene.approximations)},
            }
        ],
        "nodes": _nodes(scene, meshes),
        "meshes": listed,
        "materials": [_material(look) for look in looks],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": buffer.length}],
    }
    return _packed(document, buffer)


class _Buffer:
    """The binary chunk as it grows, with what stands where."""

    def __init__(self) -> None:
        self.known: dict[tuple[bytes, str, int], int] = {}
        self.parts: list[bytes] = []
        self.length = 0
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: NDArray[Any], kind: str, component: int, target: int, *, bounds: bool) -> int:
        """Add an array, where none is equal to the bit; return the number of its accessor."""
        data = values.tobytes()
        key = (data, kind, component)
        if key in self.known:
            return self.known[key]
        self.views.append({"buffer": 0, "byteOffset": self.length, "byteLength": len(data), "target": target})
        entry: dict[str, Any] = {"bufferView": len(self.views) - 1, "componentType": component, "type": kind,
                                 "count": len(values)}  # fmt: skip
        if bounds:
            entry |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.known[key] = len(self.accessors)
        self.accessors.append(entry)
        data += b"\0" * (-len(data) % 4)
        self.parts.append(data)
        self.length += len(data)
        return len(self.accessors) - 1


def _attributes(buffer: _Buffer, surface: Surface) -> dict[str, Any]:
    points, normals = (np.ascontiguousarray(rows, dtype="<f4") for rows in (surface.points, surface.normals))
    short = len(points) < 65535
    numbers = surface.triangles.astype("<u2" if short else "<u4").ravel()
    return {
        "attributes": {
            "POSITION": buffer.add(points, "VEC3", _FLOAT, _VERTICES, bounds=True),
            "NORMAL": buffer.add(normals, "VEC3", _FLOAT, _VERTICES, bounds=False),
        },
        "indices": buffer.add(numbers, "SCALAR", _SHORT if short else _LONG, _INDICES, bounds=False),
    }


def _material(look: str) -> dict[str, Any]:
    surface = {"baseColorFactor": [*COLOURS[look], 1.0], "metallicFactor": 0.4, "roughnessFactor": 0.45}
    if look != "housing":
        return {"name": look, "pbrMetallicRoughness": surface}
    surface["baseColorFactor"] = [*COLOURS[look], SEEN_THROUGH]
    return {"name": look, "pbrMetallicRoughness": surface, "alphaMode": "BLEND"}


def _nodes(scene: Scene, meshes: Mapping[tuple[str, str], int]) -> list[dict[str, Any]]:
    """Return all nodes, carriers with the numbers of what is on them."""
    carried: dict[str, list[int]] = {}
    for k, node in enumerate(scene.nodes):
        if node.on:
            carried.setdefault(node.on, []).append(k)
    turns: dict[bytes, list[float]] = {}
    found = [_node(scene, node, meshes, turns) for node in scene.nodes]
    for node, entry in zip(scene.nodes, found, strict=True):
        if node.name in carried:
            entry["children"] = carried[node.name]
    return found


def _node(
    scene: Scene, node: Node, meshes: Mapping[tuple[str, str], int], turns: dict[bytes, list[float]]
) -> dict[str, Any]:
    """Return a node with its place beside its carrier, which stands unturned; turns that are known are kept."""
    turned, place = node.axes.turned, node.axes.origin
    if node.phase:
        turned = turned @ turn_about_axis(node.phase)
    if node.on:
        above = scene.by_name[node.on].axes
        turned, place = above.turned.T @ turned, above.turned.T @ (place - above.origin)
    extras = {"part": str(node.part), "kind": str(node.part.kind), "look": node.look,
              "spin_rad_s": dict(node.spins)}  # fmt: skip
    key = turned.tobytes()
    if key not in turns:
        turns[key] = [round(x, PLACES) for x in quaternion(turned)]
    found: dict[str, Any] = {"name": node.name, "translation": [round(x, PLACES) for x in place.tolist()],
                             "rotation": turns[key], "extras": extras}  # fmt: skip
    if node.surface:
        found["mesh"] = meshes[node.surface, node.look]
    return found


def turn_about_axis(angle: float) -> Floats:
    """Return the matrix of a turn about the third axis.

    Args:
        angle: Of the turn [rad].
    """
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


def quaternion(turned: Floats) -> list[float]:
    """Return a rotation as a unit quaternion x, y, z, w [-].

    Args:
        turned: Its matrix, shape (3, 3).

    Source: the largest of the four squares first, so that no root of a small number divides.
    """
    m = turned
    squares = [1.0 + m[0, 0] - m[1, 1] - m[2, 2], 1.0 - m[0, 0] + m[1, 1] - m[2, 2],
               1.0 - m[0, 0] - m[1, 1] + m[2, 2], 1.0 + m[0, 0] + m[1, 1] + m[2, 2]]  # fmt: skip
    k = int(np.argmax(squares))
    rows = [
        [squares[0], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0], m[2, 1] - m[1, 2]],
        [m[0, 1] + m[1, 0], squares[1], m[1, 2] + m[2, 1], m[0, 2] - m[2, 0]],
        [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[2], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], squares[3]],
    ]
    found = np.array(rows[k])
    return [float(x) for x in found / np.linalg.norm(found)]


def _packed(document: Mapping[str, Any], buffer: _Buffer) -> bytes:
    words = json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode()
    words += b" " * (-len(words) % 4)
    length = 12 + 8 + len(words) + 8 + buffer.length
    head = struct.pack("<4sIIII", b"glTF", 2, length, len(words), 0x4E4F534A)
    return b"".join([head, words, struct.pack("<II", buffer.length, 0x004E4942), *buffer.parts])
