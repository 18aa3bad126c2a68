"""Inertias, shaft connections and supports of a sized design, and the rotation of its bodies in a motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    SIDES,
    Floats,
    Kind,
    PartId,
    Problem,
    Role,
    carrier_part,
    gear_part,
    one_blas_thread,
    refuse,
    smallest,
    verb,
)
from gearwright.dynamics.assembly.meshes import (
    compound_phases,
    gear_pairs,
    mesh_curve,
    own_gears,
    planet_bodies,
    variation_left,
)
from gearwright.dynamics.model import AXES, Contact, DampingRatio, Line, Model, Owner, System, shift_weights
from gearwright.parts.gears import GearPair
from gearwright.parts.shafts import shaft_diameter, torsional_stiffness
from gearwright.parts.stiffness import StiffnessCurve
from gearwright.shape import Node, Scene
from gearwright.sizing import MachineSizing, ShaftSizing, Sizing
from gearwright.spec import GROUND
from gearwright.spec.design import NOTHING_GIVEN
from gearwright.train import Damper, Joint, PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# Bodies: every gear, carrier and machine of a sizing on its shaft, with its share of the shaft's inertia.
# ----------------------------------------------------------------------------------------------------------------------


class TurningBody(NamedTuple):
    """What turns."""

    inertia: float
    """[kg m²]."""
    speed: float
    """In the load case [rad/s]."""
    part: PartId
    """Who it is."""


@dataclass
class Assembly:
    """A model under construction and what it is made from."""

    sizing: Sizing
    """What was sized."""
    flow: PowerFlow
    """The load case."""
    harmonics: int | None
    """Of the mesh stiffness: 0 keeps the mean, None as many as the design says."""
    model: Model = field(default_factory=Model)
    """Gets bodies, lines and loads."""
    members: dict[str, list[str]] = field(default_factory=dict)
    """Shaft -> bodies on it, in order."""
    rotors: dict[str, TurningBody] = field(default_factory=dict)
    """Body -> its inertia and speed."""
    phases: dict[str, dict[str, tuple[float, ...]]] = field(default_factory=dict)
    """Compound set -> phases of its meshes, once they are known."""

    @cached_property
    def pairs(self) -> dict[str, GearPair]:
        """Mesh row -> geometry of one mesh of it."""
        return gear_pairs(self.sizing)

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """Planetary sets whose members also move across."""
        design = self.sizing.design
        return tuple(design.planetaries) if design.dynamics.fidelity == "translational" else ()

    def compound_phases(self, stage: str) -> dict[str, tuple[float, ...]]:
        """Return mesh row -> phase of its mesh in every set of a compound set [cycles].

        Args:
            stage: Name of the set.
        """
        if stage not in self.phases:
            self.phases[stage] = compound_phases(self.sizing, self.flow, stage)
        return self.phases[stage]

    @property
    def machines_turn(self) -> bool:
        """Whether machines are bodies on shafts of their own, or torques on the train."""
        return self.sizing.design.dynamics.machines == "inertia"

    @property
    def turning_machines(self) -> tuple[MachineSizing, ...]:
        """Machines that are bodies on shafts of their own: those whose inertia is known."""
        return tuple(machine for machine in self.sizing.machines if self.machines_turn and machine.inertia)

    def curve(self, row: str) -> StiffnessCurve:
        """Return the stiffness of one mesh of a row along its line of action, as tip relief leaves it in the case.

        Args:
            row: Its name.
        """
        sized = next(mesh for mesh in self.sizing.meshes if mesh.name == row)
        curve = mesh_curve(self.sizing, sized, self.pairs[row], harmonics=self.harmonics)
        left = variation_left(self.sizing, sized, self.flow)
        cosine, sine = (tuple(left * value for value in values) for values in (curve.cosine, curve.sine))
        return curve if left == 1.0 else replace(curve, cosine=cosine, sine=sine)

    def put(self, body: PartId, shaft: str, inertia: float) -> None:
        """Put a body on a shaft; the ground takes none.

        Args:
            body: Who it is.
            shaft: That carries it.
            inertia: [kg m²].
        """
        if shaft != GROUND:
            name = f"{body} hub" if body.kind is Kind.SHAFT else str(body)
            self.rotors[name] = TurningBody(inertia, self.flow.speeds[shaft], body)
            self.members.setdefault(shaft, []).append(name)

    def seat(self, machine: MachineSizing) -> str:
        """Return the body that a machine's shaft joins, or that its torque acts on.

        Args:
            machine: Turbine, motor or propeller.
        """
        members = self.members[machine.shaft]
        return members[0] if self.sizing.design.machines[machine.name].drives else members[-1]

    def loaded_body(self, machine: MachineSizing) -> str:
        """Return the body that feels a machine's torque.

        Args:
            machine: Turbine, motor or propeller.
        """
        return machine.name if machine in self.turning_machines else self.seat(machine)


def add_bodies(assembly: Assembly) -> None:
    """Put every gear and carrier on its shaft, in the order of the stages, then the machines.

    Args:
        assembly: That gets them.
    """
    sizing, speeds = assembly.sizing, assembly.flow.speeds
    for name in sizing.design.planetaries:
        _add_set(assembly, name)
    for name in sizing.design.epicyclics:
        _add_compound(assembly, name)
    for gear in sizing.gears:
        if gear.role in SIDES:
            for shaft in gear.shafts:
                assembly.put(gear.body(shaft), shaft, gear.inertia * gear.bodies / len(gear.shafts))
    for sized in sizing.shafts:
        _share_shaft(assembly, sized)
    for machine in assembly.turning_machines:
        assembly.rotors[machine.name] = TurningBody(
            machine.inertia, speeds[machine.shaft], PartId(Kind.MACHINE, machine.name)
        )


def _add_set(assembly: Assembly, name: str) -> None:
    """Put a planetary set on its shafts; planets turn on none."""
    sizing, planetary = assembly.sizing, assembly.sizing.design.planetaries[name]
    gears = {gear.role: gear for gear in sizing.gears if gear.stage == name}
    planet, carrier = gears[Role.PLANET], next(carrier for carrier in sizing.carriers if carrier.stage == name)
    # Planets that move on their pins are masses of their own.
    carried = 0.0 if name in assembly.moving else planet.bodies * planet.turning_mass * carrier.radius**2
    assembly.put(gears[Role.SUN].part, planetary.sun, gears[Role.SUN].inertia)
    assembly.put(carrier.part, planetary.carrier, carrier.inertia + carried)
    assembly.put(gears[Role.RING].part, planetary.ring, gears[Role.RING].inertia)
    for number in range(1, planetary.planets + 1):
        body = gear_part(name, Role.PLANET, number=number)
        assembly.rotors[str(body)] = TurningBody(planet.turning_inertia, assembly.flow.speeds[planet.name], body)


def _add_compound(assembly: Assembly, name: str) -> None:
    """Put a compound set on its shafts; each planet body of each set turns by itself, its steps together."""
    sizing, epicyclic = assembly.sizing, assembly.sizing.design.epicyclics[name]
    planets, gears = list(planet_bodies(sizing, name)), own_gears(sizing, name)
    carrier = next(carrier for carrier in sizing.carriers if carrier.stage == name)
    for own, central in epicyclic.centrals.items():
        assembly.put(gears[own].part, central.shaft, gears[own].inertia)
    carried = sum(planet.mass * abs(planet.place) ** 2 for planet in planets)
    assembly.put(carrier.part, epicyclic.carrier, carrier.inertia + carried)
    for planet in planets:
        assembly.rotors[str(planet.part)] = TurningBody(planet.inertia, assembly.flow.speeds[planet.node], planet.part)


def _share_shaft(assembly: Assembly, shaft: ShaftSizing) -> None:
    """Give each end of a shaft half of its inertia; a shaft without gears is a body itself."""
    members = assembly.members.setdefault(shaft.name, [])
    if not members:
        assembly.put(PartId(Kind.SHAFT, shaft.name), shaft.name, shaft.inertia)
        return
    for end in {members[0], members[-1]}:
        share, rotor = 1.0 if len(members) == 1 else 2.0, assembly.rotors[end]
        assembly.rotors[end] = rotor._replace(inertia=rotor.inertia + shaft.inertia / share)


# ----------------------------------------------------------------------------------------------------------------------
# Lines along the shafts of a sizing, to its machines and across its clutches.
# ----------------------------------------------------------------------------------------------------------------------


class ShaftLine(NamedTuple):
    """A line that twists."""

    name: str
    """Unique name."""
    part: PartId
    """Shaft, machine or clutch."""
    first: str
    """Body at the end that drives."""
    second: str
    """Body at the other end."""
    stiffness: float
    """[N m/rad]."""


def shaft_lines(assembly: Assembly, slipping: Set[str]) -> Iterator[ShaftLine]:
    """Yield every line along a shaft, to a machine or across a clutch.

    Args:
        assembly: With all bodies.
        slipping: Clutches that are drives instead of lines.
    """
    sizing = assembly.sizing
    shafts = {shaft.name: shaft for shaft in sizing.shafts}
    for name, members in assembly.members.items():
        pieces = len(members) - 1
        for k, (first, second) in enumerate(pairwise(members)):
            line = f"{name} shaft" if pieces == 1 else f"{name} shaft {k + 1}"
            stiffness = _between(assembly, shafts[name], first, second) or shafts[name].stiffness * pieces
            yield ShaftLine(line, PartId(Kind.SHAFT, name), first, second, stiffness)
    for machine in assembly.turning_machines:
        end, shaft = assembly.seat(machine), machine.shaft
        driving = assembly.flow.machine_powers[machine.name] >= 0.0
        ends = (machine.name, end) if driving else (end, machine.name)
        own = PartId(Kind.MACHINE, machine.name)
        alone = sum(neighbour.shaft == shaft for neighbour in sizing.machines) == 1
        if len(assembly.members[shaft]) == 1 and alone:
            stiffness = _between(assembly, shafts[shaft], *ends) or shafts[shaft].stiffness
            yield ShaftLine(f"{shaft} shaft", PartId(Kind.SHAFT, shaft), *ends, stiffness)
        else:
            yield ShaftLine(f"{machine.name} shaft", own, *ends, _stub_stiffness(assembly, machine.torque))
    for joint in sizing.train.joints:
        if joint.name in assembly.flow.joints and joint.name not in slipping and not joint.is_brake:
            yield clutch_line(assembly, joint)


def _between(assembly: Assembly, shaft: ShaftSizing, first: str, second: str) -> float | None:
    """Return the stiffness of a built shaft between two bodies on it [N m/rad]: its ends and seats beyond carry none of
    their torque; None where its steps or their places are not known."""
    sizing = assembly.sizing
    built = next((one for one in sizing.built_shafts if one.name == shaft.name), None)
    given = sizing.design.layout.get(shaft.name, NOTHING_GIVEN).torsional_stiffness
    start, end = (_place(assembly, shaft.name, body) for body in (first, second))
    if built is None or given is not None or start is None or end is None:
        return None
    stiffness = built.stiffness_between(start, end, sizing.design.shaft_material.shear_modulus)
    return stiffness if math.isfinite(stiffness) else None


def _place(assembly: Assembly, shaft: str, body: str) -> float | None:
    """Return where a body stands along a shaft [m]; None of one that has no place of its own."""
    part, places = assembly.rotors[body].part, assembly.sizing.arrangement.plans[shaft].places
    gears = (gear.name for gear in assembly.sizing.gears if shaft in gear.shafts and gear.body(shaft) == part)
    return places.get(next(gears, str(part)))


class Brake(NamedTuple):
    """A line that holds a shaft to the housing."""

    name: str
    part: PartId
    body: str
    """That it holds."""
    stiffness: float
    """[N m/rad]."""


def brakes(assembly: Assembly) -> Iterator[Brake]:
    """Yield every brake that holds, as stiff as the shaft that it holds.

    Args:
        assembly: With all bodies.
    """
    shafts = {shaft.name: shaft for shaft in assembly.sizing.shafts}
    for joint in assembly.sizing.train.joints:
        if joint.is_brake and joint.name in assembly.flow.joints:
            name = joint.driven if joint.driving == GROUND else joint.driving
            part = PartId(Kind.CLUTCH, joint.name)
            yield Brake(f"{joint.name} clutch", part, assembly.members[name][-1], shafts[name].stiffness)


def clutch_line(assembly: Assembly, joint: Joint) -> ShaftLine:
    """Return the line across a clutch, as stiff as the softer of its shafts.

    Args:
        assembly: With all bodies.
        joint: The clutch.
    """
    stiffness = min(shaft.stiffness for shaft in assembly.sizing.shafts if shaft.name in (joint.driving, joint.driven))
    return ShaftLine(f"{joint.name} clutch", PartId(Kind.CLUTCH, joint.name), *link_ends(assembly, joint), stiffness)


def link_ends(assembly: Assembly, link: Joint | Damper) -> tuple[str, str]:
    """Return the bodies that a clutch or damper joins.

    Args:
        assembly: With all bodies.
        link: What joins two shafts.
    """
    return assembly.members[link.driving][-1], assembly.members[link.driven][0]


def _stub_stiffness(assembly: Assembly, torque: float) -> float:
    """Return the stiffness of a machine's own shaft, sized by its torque [N m/rad]."""
    rules = assembly.sizing.design.shafting
    material = assembly.sizing.design.shaft_material
    diameter = shaft_diameter(0.0, torque, (material.yield_strength or 0.0) / rules.safety, bore_ratio=rules.bore_ratio)
    return torsional_stiffness(diameter, rules.end_length, material.shear_modulus, bore=rules.bore_ratio * diameter)


# ----------------------------------------------------------------------------------------------------------------------
# Supports: the shafts that a design lets move across, on their bearings, and what they do to every mesh.
#
# Translations are named ``SHAFT.y`` (and so on), those of a shaft with a sun, a ring or a carrier in the frame of that
# planetary set's carrier. Damping ratios of meshes refer to their rotations alone, with or without translations.
# ----------------------------------------------------------------------------------------------------------------------


def add_supports(model: Model, sizing: Sizing, contacts: tuple[Contact, ...], flow: PowerFlow) -> None:
    """Let the shafts that the design supports move: translations, bearings, and what they do to every mesh.

    Args:
        model: With every mesh as a line of rotations.
        sizing: What was sized.
        contacts: From `contacts_of`.
        flow: The load case, whose carrier speeds turn the frames.

    Raises:
        DesignError: If a shaft carries gears of two frames.
    """
    supports = sizing.design.supports
    if not supports:
        return
    frames, moving = _frames(sizing, contacts, flow), set[str]()
    for shaft, support in supports.items():
        mass = support.mass or _moving_mass(sizing, shaft)
        across = _across(contacts, shaft)
        stiffness = dict.fromkeys((AXES[k] for k in across), support.radial)
        if support.axial is not None:
            stiffness[next(axis for axis in AXES if axis not in stiffness)] = support.axial
        for axis, value in stiffness.items():
            owner = Owner(PartId(Kind.SHAFT, shaft), axis)
            name = model.translation(f"{shaft}.{axis}", mass=mass, owner=owner)
            damping = DampingRatio(support.damping)
            model.support(f"{name} support", name, stiffness=value, damping=damping, owner=owner)
            moving.add(name)
        if frames[shaft]:
            model.rotating_frame(*(f"{shaft}.{AXES[k]}" for k in across), speed=frames[shaft])
    _shift(model, {contact.line: contact for contact in contacts}, moving)


def _across(contacts: tuple[Contact, ...], shaft: str) -> tuple[int, int]:
    return next((side.across for contact in contacts for side in contact.sides if side.shaft == shaft), (1, 2))


def _frames(sizing: Sizing, contacts: tuple[Contact, ...], flow: PowerFlow) -> dict[str, float]:
    """Return shaft -> speed of the frame that its translations are written in [rad/s]."""
    carriers: dict[str, set[str]] = {shaft: set() for shaft in sizing.design.supports}
    for contact in contacts:
        for side in contact.sides:
            if side.shaft in carriers:
                carriers[side.shaft].add(next(iter(side.housing_turns), ""))
    problems = [
        Problem(f"supports.{shaft}", "it carries gears of a planetary set and of another frame; leave its support out")
        for shaft, carrier in carriers.items()
        if len(carrier) > 1
    ]
    refuse(problems)
    speeds = {str(carrier_part(name)): flow.speeds[stage.carrier] for name, stage in sizing.design.sets.items()}
    return {shaft: speeds.get(next(iter(carrier), ""), 0.0) for shaft, carrier in carriers.items()}


def _moving_mass(sizing: Sizing, shaft: str) -> float:
    """Return the mass of a shaft with all that it carries [kg]."""
    alone = next(sized.mass for sized in sizing.shafts if sized.name == shaft)
    gears = sum(gear.mass * gear.bodies / len(gear.shafts) for gear in sizing.gears if shaft in gear.shafts)
    carriers = 0.0
    for carrier in sizing.carriers:
        if carrier.shaft == shaft:
            planets = [gear for gear in sizing.gears if gear.stage == carrier.stage and gear.role is Role.PLANET]
            carriers += carrier.mass + sum(planet.turning_mass * planet.bodies for planet in planets)
    return alone + gears + carriers


def _shift(model: Model, contacts: Mapping[str, Contact], moving: set[str]) -> None:
    inertia = {body.name: body.mass for body in model.bodies}
    for number, line in enumerate(model.lines):
        if line.name in contacts:
            shifts = {name: value for name, value in shift_weights(contacts[line.name]).items() if name in moving}
            weights = {**line.weights, **shifts}
            model.lines[number] = replace(line, weights=weights, damping=_damper(line, inertia))


def _damper(line: Line, inertia: Mapping[str, float]) -> float:
    """Return a mesh's damping for its rotations alone, 2 ζ √(k m_eff) [N s/m]."""
    if not isinstance(line.damping, DampingRatio):
        return line.damping
    mobility = sum(weight**2 / inertia[name] for name, weight in line.weights.items())
    return line.damping.damper(line.stiffness, mobility)


# ----------------------------------------------------------------------------------------------------------------------
# By how much every body of a scene turns in a motion of its train: shapes of modes and simulated runs on solids.
# ----------------------------------------------------------------------------------------------------------------------


@verb
@one_blas_thread()
def turns_of(sizing: Sizing, scene: Scene, system: System, position: Floats) -> Mapping[str, Floats]:
    """Return node → its turn about its own axis, against the carrier that it is on [rad]; what stands is left out.

    A shaft, which has no coordinate of its own, turns as the mean of what sits on it. Bodies are turned alone, not
    moved aside.

    Args:
        sizing: What was sized.
        scene: Of it.
        system: Assembled from it.
        position: q, measured from the rigid motion [rad], shape (..., coordinates).
    """
    places = {name: k for k, name in enumerate(system.labels.coordinates) if system.labels.coordinate_units[k] == "rad"}
    sitting = {name: [places[one] for one in names if one in places] for name, names in _sitting(sizing).items()}
    found: dict[str, Floats] = {}
    for node in scene.nodes:
        own = [places[node.name]] if node.name in places else sitting.get(node.name, [])
        if own:
            base = [places[node.on]] if node.on in places else []
            turn = np.mean(position[..., own], axis=-1)
            turn = turn - np.mean(position[..., base], axis=-1) if base else turn
            found[node.name] = _sense(node, system, own, base) * turn
    return found | dict(_joined(scene, found))


def _joined(scene: Scene, found: Mapping[str, Floats]) -> Iterator[tuple[str, Floats]]:
    """Yield what has no coordinate, such as ties and second toothings: it turns with what it is joined to."""
    for node in scene.nodes:
        if node.name not in found and any(node.spins.values()):
            alike = [one for one in scene.nodes if one.name in found and (one.on, one.spins) == (node.on, node.spins)]
            alike.sort(key=lambda one: one.part.number != node.part.number)
            if alike:
                yield node.name, found[alike[0].name]


def _sitting(sizing: Sizing) -> dict[str, list[str]]:
    """Return node of a shaft → coordinates of what sits on it."""
    found: dict[str, list[str]] = {f"shaft {shaft.name}": [] for shaft in sizing.shafts}
    for shaft, name in _seats(sizing):
        found.get(f"shaft {shaft}", []).append(name)
    return found


def _seats(sizing: Sizing) -> Iterator[tuple[str, str]]:
    for gear in sizing.gears:
        for shaft in gear.shafts:
            yield shaft, str(gear.part) if len(gear.shafts) == 1 else str(gear.part._replace(branch=shaft))
    for carrier in sizing.carriers:
        yield carrier.shaft, str(carrier.part)
    for machine in sizing.machines:
        yield machine.shaft, machine.name


def _sense(node: Node, system: System, own: list[int], base: list[int]) -> float:
    """Return 1, or −1 where a body's own axis points against the direction in which speeds of the train count."""
    if node.part.kind is Kind.SHAFT and not any(node.spins.values()):
        return 1.0
    speed = system.arrays.speed
    relative = float(speed[own[0]] - (speed[base[0]] if base else 0.0))
    spins = [spin for spin in node.spins.values() if spin * relative]
    if not spins:
        return 1.0
    nearest = smallest(spins, lambda spin: abs(abs(spin) - abs(relative)))
    return float(np.sign(nearest * relative))
