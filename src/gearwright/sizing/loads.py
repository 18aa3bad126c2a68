"""Loads on shafts and planet pins in every load case, and the reactions of the bearings.

What it does to them is for `shafts`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.base import Complexes, Floats, carrier_part
from gearwright.parts.shafts import Diagram, PointLoads, diagram, supported
from gearwright.sizing.airscrew_loads import AirscrewRows, LoadRow, shaft_rows
from gearwright.sizing.arrangement import helix_hand
from gearwright.sizing.gear_geometry import rolling_of, set_pins, set_rollings, towards
from gearwright.sizing.rating import Context, bevel_push
from gearwright.sizing.result import GearSizing, ShaftPlan
from gearwright.sizing.shaft_results import BearingLoad, ShaftDiagram
from gearwright.spec import Epicyclic
from gearwright.train import INTERNAL, Mesh, PowerFlow

# ----------------------------------------------------------------------------------------------------------------------
# What acts on one shaft, in both planes and every load case: mesh forces as point loads, and all torques.
#
# A mesh of a pair gives a tangential force that makes its torque, a radial force that parts the gears, and, with a
# single helix, an axial force whose lever about the shaft's axis is the working pitch radius. Both halves of a
# double-helical gear take half of it, each in its own middle; their axial forces meet inside the gear's body. The
# members of a planetary set load their shaft by torque only: the forces of equal planets cancel. So does the pinion
# of face gears, which lies across and stands between opposite ones. A bevel mesh acts at its mean cone; in the
# cross-sections its two shafts stand side by side, as if the wheel's were turned into the pinion's. Forces carry the
# mesh load factor K_γ, torques are those of the power flow. The thrust and the moments of a propeller are not in it.
# ----------------------------------------------------------------------------------------------------------------------


class _Load(NamedTuple):
    """What a mesh puts on a shaft over all cases; transverse values are complex, y + i z."""

    position: float
    torque: Floats
    force: Complexes
    couple: Complexes
    axial: Floats

    def part(self, position: float, share: float) -> _Load:
        """Return a share of the load at another place."""
        return _Load(position, share * self.torque, share * self.force, share * self.couple, share * self.axial)


def shaft_loads(
    context: Context, name: str, plan: ShaftPlan, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> tuple[PointLoads, Floats]:
    """Return the point loads on a shaft, bearings left out, and the axial force of each case [N].

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.
        axes: Where all axes stand, y + i z [m].
        gears: By name.

    Returns:
        Forces and couples (cases, 2 planes, n), torques (cases, n); axial forces (cases,), positive along x.

    Source: forces of a mesh: ISO 21771:2007; equilibrium of the shaft: Pulvirenti 2023, §2.4.
    """
    pure, meshes = list(pure_torques(context, name, plan)), list(_meshes(context, name, plan, axes, gears))
    position = np.array([*(place for place, _ in pure), *(load.position for load in meshes)])
    torque = np.array([*(torques for _, torques in pure), *(load.torque for load in meshes)]).T
    force, couple = np.zeros((len(torque), 2, len(position))), np.zeros((len(torque), 2, len(position)))
    axial = np.zeros(len(torque))
    for k, load in enumerate(meshes, start=len(pure)):
        force[:, 0, k], force[:, 1, k] = load.force.real, load.force.imag
        couple[:, 0, k], couple[:, 1, k] = load.couple.real, load.couple.imag
        axial += load.axial
    return PointLoads(position, force, couple, torque), axial


def pure_torques(context: Context, name: str, plan: ShaftPlan) -> Iterator[tuple[float, list[float]]]:
    """Yield what loads a shaft by torque only: machines, clutches, dampers, members of planetary sets.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.

    Returns:
        Place [m], and the torque of every load case [N m].
    """
    train, flows = context.train, context.flows.values()
    for machine, shaft in train.machines.items():
        if shaft == name:
            yield plan.places[machine], [flow.machine_torques.get(machine, 0.0) for flow in flows]
    for link in train.links:
        if name in (link.driving, link.driven):
            sign = 1.0 if name == link.driven else -1.0
            yield plan.places[link.name], [sign * flow.given(link.name) for flow in flows]
    for mesh in train.meshes:
        if mesh.stage in context.design.sets and name in mesh.nodes:
            side = mesh.nodes.index(name)
            member = str(carrier_part(mesh.stage)) if side == 2 else mesh.gears[side]
            yield plan.places[member], [flow.meshes[mesh.name].torques[side] for flow in flows]


def _meshes(
    context: Context, name: str, plan: ShaftPlan, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> Iterator[_Load]:
    """Yield what every mesh of a pair puts on the shaft, once for each half of its gear."""
    for mesh in context.train.meshes:
        if mesh.stage in context.design.pairs and name in mesh.nodes[:2]:
            side = mesh.nodes.index(name)
            gear = gears[mesh.gears[side]]
            kind = context.design.pairs[mesh.stage].kind
            if kind != "cylindrical":
                crossing = _face_load if kind == "face" else _bevel_load
                yield crossing(context, mesh, side, axes, gear).part(plan.places[gear.name], 1.0)
                continue
            load = _mesh_load(context, mesh, side, axes, (gears[mesh.gears[0]], gears[mesh.gears[1]]))
            for half in range(mesh.count):
                offset = (half - (mesh.count - 1) / 2.0) * gear.face_width
                yield load.part(plan.places[gear.name] + offset, 1.0 / mesh.count)


def _mesh_load(
    context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], pair: tuple[GearSizing, GearSizing]
) -> _Load:
    """Return what all halves of a mesh together put on one of its two gears, at the origin."""
    rating, rolls = context.ratings[mesh.stage], rolling_of(context.rating(mesh), pair, mesh)
    radius = rolls.radii[side]
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    tangential = torque / radius * rating.load_factor
    radial = np.abs(tangential) * math.tan(rolls.pressure_angle)
    toward = _toward_mesh(mesh, side, axes)
    outward = 1.0 if mesh.sign == INTERNAL and side == 1 else -1.0
    force = toward * (1j * tangential + outward * radial)
    hand = helix_hand(context.design, context.train, context.flows, mesh.nodes[side])
    slope = hand * rolls.lean if mesh.count == 1 else 0.0
    axial = -slope * tangential
    return _Load(0.0, torque, force, -toward * radius * axial, axial)


def _face_load(context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], gear: GearSizing) -> _Load:
    """Return what a face-gear mesh puts on its wheel (1: tangential and axial force) or on its pinion (0: torque)."""
    rating, radius = context.ratings[mesh.stage], gear.pitch_diameter / 2.0
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    none = np.zeros_like(torque)
    if side == 0:
        return _Load(0.0, torque, none.astype(complex), none.astype(complex), none)
    tangential = torque / radius * rating.load_factor
    toward = _toward_mesh(mesh, side, axes)
    # The pinion pushes the wheel away from itself, to the side on which the wheel lies.
    away = 1.0 if toward.real + toward.imag > 0.0 else -1.0
    axial = away * np.abs(tangential) * math.tan(rating.rules.pressure_angle)
    return _Load(0.0, torque, toward * 1j * tangential, -toward * radius * axial, axial)


def _bevel_load(context: Context, mesh: Mesh, side: int, axes: Mapping[str, complex], gear: GearSizing) -> _Load:
    """Return what a bevel mesh puts on its pinion (0) or wheel (1), at the mean cone.

    The hand of spiral is the one that pushes the pinion away from the apex in the rated case, which keeps backlash.
    """
    rating, pair, radius = context.ratings[mesh.stage], context.design.pairs[mesh.stage], gear.pitch_diameter / 2.0
    torque = np.array([flow.meshes[mesh.name].torques[side] for flow in context.flows.values()])
    tangential = torque / radius * rating.load_factor
    rated = context.reference.meshes[mesh.name].torques[side]
    pushed = np.sign(torque * rated) * (1.0 if side == 0 else -1.0)
    here, mate = (context.teeth[mesh.gears[k]] for k in (side, 1 - side))
    forces = bevel_push(rating, np.abs(tangential), here / mate, pushed=pushed)
    away, radial = np.asarray(forces[0]), np.asarray(forces[1])
    apex = pair.pinion_apex if side == 0 else pair.wheel_apex
    axial = away if apex == "first" else -away
    toward = _toward_mesh(mesh, side, axes)
    return _Load(0.0, torque, toward * (1j * tangential - radial), -toward * radius * axial, axial)


def _toward_mesh(mesh: Mesh, side: int, axes: Mapping[str, complex]) -> complex:
    """Return the direction from a gear's axis to its pitch point: towards its mate, or, inside a ring, away from it."""
    between = axes[mesh.nodes[1]] - axes[mesh.nodes[0]]
    from_first = between / abs(between)
    if mesh.sign == INTERNAL:
        return -from_first
    return from_first if side == 0 else -from_first


# ----------------------------------------------------------------------------------------------------------------------
# All that acts on one shaft in every load case, held in balance by its two radial bearings.
#
# To the meshes and machines of `loads` come the rotors: a propeller's thrust along the shaft, its force across and the
# moment at its hub. These two turn with the flow and not with the shaft, so that they bend a turning shaft as a mesh
# does. Where they point is not known, the moment but in the sense in which the force bends: every bearing and every
# section is judged with them where they load it most, and diagrams and deflections show them where they bend the shaft
# most. What a design states of them acts in every load case; on a shaft in bearings the rest is taken by default, in
# rows of their own (`airscrew_loads`), each with the torques of one load case.
# ----------------------------------------------------------------------------------------------------------------------


_NO_FORCE = 1e-9
"""Force of a bearing over the largest force on its shaft below which it is rounding [-]."""
_ROUNDING = 1e-6
"""Moment over the largest one below which it is rounding [-]."""
_BESIDE = 1e-9
"""How far left and right of a section its moments are read [m]; they jump where a couple acts."""


class LoadComponent(NamedTuple):
    """Some of what acts on one shaft, in balance by itself."""

    loads: PointLoads
    """The two last ones are the reactions of its bearings."""
    drawn: Diagram


class ShaftForces(NamedTuple):
    """What acts on one shaft, reactions included, and what that makes inside it."""

    plan: ShaftPlan
    whole: PointLoads
    """Loads in balance; where anything bends the shaft, the two last ones are the reactions of its bearings."""
    drawn: Diagram
    axial: Floats
    """Force along the shaft that its bearings take, positive towards its second end [N], (cases,)."""
    bends: bool
    apart: tuple[LoadComponent, ...] = ()
    """Where rotors bend the shaft: the meshes alone, and each rotor alone, which may point anywhere."""
    rows: tuple[LoadRow, ...] = ()
    """What each row of these loads is; empty where each is a load case of the design."""

    @property
    def of_use(self) -> list[int]:
        """Numbers of the rows that last, by which shafts must be stiff: all, or those for life [-]."""
        return [k for k in range(len(self.axial)) if not self.rows or self.rows[k].use == "life"]

    def names(self, cases: Iterable[str]) -> tuple[str, ...]:
        """Return what every row is called.

        Args:
            cases: Names of the load cases of the design.
        """
        return tuple(row.name for row in self.rows) or tuple(cases)

    def by_row(self, values: Sequence[float]) -> list[float]:
        """Return values of the load cases for every row.

        Args:
            values: Of every load case of the design.
        """
        return [values[row.case] for row in self.rows] or list(values)

    def radial(self) -> Floats:
        """Return the forces of both radial bearings [N], (cases, 2 planes, 2); zero where nothing bends."""
        return self.whole.force[..., -2:] if self.bends else np.zeros((len(self.axial), 2, 2))

    def largest_radial(self) -> Floats:
        """Return what both radial bearings must bear [N], (cases, 2): rotors point where they load each one most.

        Meshes that balance each other leave rounding, which is no force.
        """
        parts = [part.loads.force[..., -2:] for part in self.apart] or [self.radial()]
        borne = np.asarray(np.sum([np.hypot(part[:, 0], part[:, 1]) for part in parts], axis=0))
        return np.where(borne > _NO_FORCE * np.abs(self.whole.force).max(initial=0.0), borne, 0.0)

    def moments(self, positions: Floats) -> tuple[Floats, Floats]:
        """Return bending moment and torque at sections, the larger of both sides [N m], each (cases, n).

        Args:
            positions: From the shaft's first end [m], (n,). Rotors point where they bend each one most.
        """
        parts = [part.drawn for part in self.apart] or [self.drawn]
        beside, count = np.concatenate([positions - _BESIDE, positions + _BESIDE]), len(positions)
        sides = [sum(both) for both in zip(*(_at(part, beside) for part in parts), strict=True)]
        bending, torque = (np.maximum(values[:, :count], values[:, count:]) for values in sides)
        return _cleaned(bending), _cleaned(torque)

    def bearing_loads(self, case: int) -> tuple[BearingLoad, ...]:
        """Return what both radial bearings give to the shaft in one case; none where only torque acts.

        Args:
            case: Its number [-].
        """
        pairs = self.radial()[case].T.tolist() if self.bends else []
        return tuple(BearingLoad(at, (y, z)) for at, (y, z) in zip(self.plan.bearings, pairs, strict=False))

    def diagram(self, case: int) -> ShaftDiagram:
        """Return shear, bending and torsion of one case.

        Args:
            case: Its number [-].
        """
        shear, bending = self.drawn.shear[case].tolist(), self.drawn.bending[case].tolist()
        return ShaftDiagram(
            position=tuple(self.drawn.position.tolist()),
            shear=(tuple(shear[0]), tuple(shear[1])),
            bending=(tuple(bending[0]), tuple(bending[1])),
            torsion=tuple(self.drawn.torsion[case].tolist()),
        )


def _cleaned(values: Floats) -> Floats:
    """Return values without what the width of `_BESIDE` and rounding leave at free ends."""
    return np.where(values > _ROUNDING * values.max(initial=0.0), values, 0.0)


def _at(drawn: Diagram, positions: Floats) -> tuple[Floats, Floats]:
    """Return bending moment of both planes together, and torque, at places between the stations."""
    places = drawn.position
    right = np.minimum(np.maximum(places.searchsorted(positions), 1), len(places) - 1)
    left, inside = right - 1, (positions >= places[0]) & (positions <= places[-1])
    start = places[left]
    steps = places[right] - start
    weight = (positions - start) / np.where(steps > 0.0, steps, np.inf)
    bending = drawn.bending.take(left, axis=-1) * (1.0 - weight) + drawn.bending.take(right, axis=-1) * weight
    return np.hypot(bending[:, 0], bending[:, 1]) * inside, np.abs(drawn.torsion.take(left, axis=-1)) * inside


def shaft_forces(
    context: Context, name: str, plan: ShaftPlan, *, axes: Mapping[str, complex], gears: Mapping[str, GearSizing]
) -> ShaftForces:
    """Return what acts on a shaft in every load case.

    Args:
        context: What sizing reads.
        name: Of the shaft.
        plan: Where things sit along it.
        axes: Where all axes stand, y + i z [m].
        gears: By name.

    Raises:
        DesignError: If a load stands outside the shaft.
    """
    meshes, axial = shaft_loads(context, name, plan, axes=axes, gears=gears)
    rows, rotors = shaft_rows(context.design, context.flows, name, in_bearings=bool(plan.seats))
    if rows:
        meshes, axial = _in_rows(meshes, axial, rows)
    loads, apart = meshes, [meshes]
    for rotor_name, rotor in rotors.items():
        axial = axial + rotor_side(plan, rotor_name) * rotor.thrust
        if rotor.force.any() or rotor.moment.any():
            alone = _alone(loads, plan, rotor, position=plan.places[rotor_name])
            loads, apart = _joined(loads, alone, plan), [*apart, alone]
    bends = bool(loads.force.any() or loads.couple.any())
    balanced = supported(loads, plan.bearings, length=plan.length) if bends else loads
    parts = tuple(_part(part_loads, plan) for part_loads in apart) if len(apart) > 1 else ()
    return ShaftForces(plan, balanced, diagram(balanced), axial, bends, parts, rows)


def _in_rows(loads: PointLoads, axial: Floats, rows: Sequence[LoadRow]) -> tuple[PointLoads, Floats]:
    """Return the loads of meshes and machines in every row, with its share of their torque."""
    at, factor = [row.case for row in rows], np.array([row.torque_factor for row in rows])
    force, couple = (factor[:, None, None] * load[at] for load in (loads.force, loads.couple))
    return PointLoads(loads.position, force, couple, factor[:, None] * loads.torque[at]), factor * axial[at]


def _part(loads: PointLoads, plan: ShaftPlan) -> LoadComponent:
    held = supported(loads, plan.bearings, length=plan.length)
    return LoadComponent(held, diagram(held))


def rotor_side(plan: ShaftPlan, rotor: str) -> float:
    """Return the end of the shaft, as a sign, that a rotor looks at: away from all else on the shaft.

    Args:
        plan: Where things sit along the shaft.
        rotor: Name of the propeller.
    """
    others = [*plan.bearings, *(place for part, place in plan.places.items() if part != rotor)]
    return 1.0 if plan.places[rotor] >= sum(others) / len(others) else -1.0


def _alone(loads: PointLoads, plan: ShaftPlan, rotor: AirscrewRows, *, position: float) -> PointLoads:
    """Return a rotor's force and moment along y, beside other loads of nothing."""
    side = 1.0 if position >= sum(plan.bearings) / 2.0 else -1.0
    wider = _padded(loads, position)
    alone = PointLoads(wider.position, *(np.zeros_like(load) for load in wider[1:]))
    alone.force[:, 0, -1], alone.couple[:, 0, -1] = rotor.force, side * rotor.moment
    return alone


def _joined(loads: PointLoads, alone: PointLoads, plan: ShaftPlan) -> PointLoads:
    """Return loads with a rotor's among them, in the direction that bends the shaft most."""
    joined = _padded(loads, alone.position[-1])
    rotor_bending, others = (np.swapaxes(_part(loads, plan).drawn.bending, 0, 1) for loads in (alone, joined))
    direction = _worst_direction(rotor_bending[0], others)
    joined.force[..., -1] = alone.force[:, :1, -1] * direction
    joined.couple[..., -1] = alone.couple[:, :1, -1] * direction
    return joined


def _worst_direction(rotor: Floats, others: Floats) -> Floats:
    """Return in which direction a rotor bends a shaft most in every case, along y and z [-].

    Args:
        rotor: Its bending along y at sections [N m], (cases, n).
        others: Bending of all else [N m], (2, cases, n).
    """
    meshes = others[0] + 1j * others[1]
    worst = np.argmax(np.abs(meshes) + np.abs(rotor), axis=-1)
    cases = np.arange(len(worst))
    turn = np.exp(1j * np.angle(meshes[cases, worst] * np.sign(rotor[cases, worst])))
    return np.stack([turn.real, turn.imag], axis=-1)


def _padded(loads: PointLoads, position: float) -> PointLoads:
    """Return loads with one more, of nothing, at a place."""
    wider = [np.concatenate([load, np.zeros((*load.shape[:-1], 1))], axis=-1) for load in loads[1:]]
    return PointLoads(np.append(loads.position, position), *wider)


# ----------------------------------------------------------------------------------------------------------------------
# What the planets of a compound set put on their pins: tooth forces of every mesh, added as vectors.
# ----------------------------------------------------------------------------------------------------------------------


class ToothForce(NamedTuple):
    """What one mesh of the first set puts on a planet, or on one step of it."""

    planet: str
    """In the design's words."""
    mate: str
    """In the design's words."""
    radial: float
    """Outwards [N]."""
    tangential: float
    """Around the axis of the carrier, signed as torques are [N]."""


class PinLoad(NamedTuple):
    """What one case puts on the pin of one planet body."""

    case: str
    body: str
    tangential: float
    """From its teeth, around the axis of the carrier, signed as torques are [N]."""
    radial: float
    """From its teeth, outwards [N]."""
    centrifugal: float
    """From its mass [N]."""
    pin: float
    """Both together as vectors [N]."""
    lever: float
    """Bending moment at the root of the pin over half of that force [m]: the width, where it acts in the middle."""


def pin_loads(context: Context, name: str, gears: Mapping[str, GearSizing]) -> list[PinLoad]:
    """Return what every case puts on every pin of the first set.

    Args:
        context: What sizing reads.
        name: Of a compound set.
        gears: Its gears by the design's names.

    Source: equilibrium of a planet: tangential and separating force of each mesh, ISO 21771:2007, and m r ω_c².
    """
    epicyclic = context.design.epicyclics[name]
    pins, loads = set_pins(context, name, gears), []
    for case, flow in context.flows.items():
        forces = [force for row in tooth_forces(context, name, gears, flow).values() for force in row]
        speed = flow.speeds[epicyclic.carrier]
        for body, place in pins.items():
            own = [force for force in forces if epicyclic.body(force.planet) == body]
            swung = {step: gears[step].turning_mass * speed**2 * abs(place) for step in steps_of(epicyclic, body)}
            radial, tangential = sum(force.radial for force in own), sum(force.tangential for force in own)
            centrifugal = sum(swung.values())
            pin = math.hypot(tangential, radial + centrifugal)
            lever = _lever(epicyclic, gears, own, swung, pin)
            loads.append(PinLoad(case, body, tangential, radial, centrifugal, pin, lever))
    return loads


def steps_of(epicyclic: Epicyclic, body: str) -> list[str]:
    """Return the planets that turn as one piece, in the design's words.

    Args:
        epicyclic: A compound set.
        body: The first of them.
    """
    return [planet for planet in epicyclic.planets if epicyclic.body(planet) == body]


def pin_length(epicyclic: Epicyclic, body: str, gears: Mapping[str, GearSizing]) -> float:
    """Return how far a pin stands out of its plate: to the last of its steps, or as far as they side by side [m].

    Args:
        epicyclic: A compound set.
        body: The first planet of the piece that turns on it.
        gears: Its gears by the design's names.
    """
    steps = steps_of(epicyclic, body)
    ends = [place + gears[step].face_width / 2.0 for step in steps if (place := epicyclic.planets[step].place)]
    return max(ends) if len(ends) == len(steps) else sum(gears[step].face_width for step in steps)


def tooth_forces(
    context: Context, name: str, gears: Mapping[str, GearSizing], flow: PowerFlow
) -> dict[str, list[ToothForce]]:
    """Return mesh row -> what it puts on the planets of the first set: on one of them, or on the two that mesh.

    Both gears of a mesh bear one force. Its moment about the carrier's axis, of the two pins that it ends in, is what
    the mesh puts on the carrier: so it balances with the losses, with which neither gear's own torque does.

    Args:
        context: What sizing reads.
        name: Of a compound set.
        gears: Its gears by the design's names.
        flow: Torques of a case.

    Source: equilibrium of a mesh; separating force F_t tan α, ISO 21771:2007.
    """
    epicyclic, rating = context.design.epicyclics[name], context.ratings[name]
    parts, rolls = {gear.name: own for own, gear in gears.items()}, set_rollings(context, name, gears)
    pins = set_pins(context, name, gears)
    forces = dict[str, list[ToothForce]]()
    for mesh in (mesh for mesh in context.train.meshes if mesh.stage == name):
        first, second = (parts[gear] for gear in mesh.gears)
        here, there = (pins[epicyclic.body(own)] if own in epicyclic.planets else 0j for own in (first, second))
        moment = flow.meshes[mesh.name].torques[2] / mesh.count * rating.load_factor
        tangential = moment / abs(here - there)
        separating = rolls[mesh.own].radial(abs(tangential))
        around = 1j * (here - there) / abs(here - there) * tangential
        for own, mate, pin, sense in ((first, second, here, 1.0), (second, first, there, -1.0)):
            if own in epicyclic.planets:
                force = (sense * around - separating * towards(epicyclic, pins, own, mate)) / pin * abs(pin)
                forces.setdefault(mesh.name, []).append(ToothForce(own, mate, force.real, force.imag))
    return forces


def mesh_place(epicyclic: Epicyclic, gears: Mapping[str, GearSizing], planet: str, mate: str) -> float | None:
    """Return how far from the carrier's plate a planet meshes with a mate: in the middle of the width that both have.

    Args:
        epicyclic: A compound set.
        gears: Its gears by the design's names.
        planet: In the design's words.
        mate: In the design's words.

    Returns:
        Place along the axis [m]; the planet's own where the mate's is not given, None where neither is.
    """
    own, other = (epicyclic.toothed[gear].place for gear in (planet, mate))
    if own is None or other is None:
        return own
    half, reach = (gears[gear].face_width / 2.0 for gear in (planet, mate))
    return (max(own - half, other - reach) + min(own + half, other + reach)) / 2.0


def _lever(
    epicyclic: Epicyclic, gears: Mapping[str, GearSizing], forces: Iterable[ToothForce], swung: Mapping[str, float],
    pin: float,
) -> float:  # fmt: skip
    """Return the moment at the root of a pin over half of its force [m]: by the places of its gears if all are given.

    Else the force acts in the middle of the pin, which is as long as its steps side by side.
    """
    places = {step: epicyclic.planets[step].place for step in swung}
    if pin == 0.0 or None in places.values():
        return sum(gears[step].face_width for step in swung)
    around = outwards = 0.0
    for force in forces:
        place = mesh_place(epicyclic, gears, force.planet, force.mate) or 0.0
        around, outwards = around + place * force.tangential, outwards + place * force.radial
    outwards += sum(force * (places[step] or 0.0) for step, force in swung.items())
    return 2.0 * math.hypot(around, outwards) / pin
