"""The sized gearbox in flight: torques, losses and speeds of many intervals as arrays, and what else takes power."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearwright.base import Bools, DesignError, Floats, GearwrightError, Ints, Problem, Role, SolveError, by_name, verb
from gearwright.mission.profile import runs_of, spread
from gearwright.sizing import Sizing
from gearwright.sizing.bearing_seats import Seat, bearing_seats, seat_forces_along
from gearwright.sizing.losses import ORIGINS, Oil, Teeth, gear_losses, mesh_loss_parts, rubbing, seal_losses, teeth_of
from gearwright.spec import GROUND, Accessory, Case, Drive, drives_of
from gearwright.train import (
    STANDSTILL,
    Damper,
    Joint,
    Turn,
    Turning,
    along,
    asked_speeds,
    can_be_along,
    is_slight,
    left_alone,
    overruns,
    power_flow,
)

__all__ = ["Oil"]


# ----------------------------------------------------------------------------------------------------------------------
# What takes power in flight: the propeller or rotor that balances, accessories by demand, others by their part.
# ----------------------------------------------------------------------------------------------------------------------


def flown_airscrew(sizing: Sizing) -> str:
    """Return the propeller or rotor that a mission is flown with: the one that balances in its first case.

    Args:
        sizing: What was sized.

    Raises:
        DesignError: If there is none, or more than one.
    """
    drives = drives_of(sizing.design, sizing.reference.case)
    names = [name for name in sizing.design.airscrews if not drives[name].stated]
    if len(names) != 1:
        balance = f"{len(names)} propellers or rotors balance in case {sizing.reference.case}"
        raise DesignError([Problem("propellers", f"{balance}; a mission is flown with one per gearbox")])
    return names[0]


def taken_parts(sizing: Sizing) -> dict[str, float]:
    """Return every other machine that only takes -> its part of the power that the train is given [-].

    Tail rotors, generators and loads take in flight the part that they take in the case that speaks for the design;
    accessories are not among them: they take their own power at any speed, as in a case that says nothing of them.

    Args:
        sizing: What was sized.
    """
    flown, powers = flown_airscrew(sizing), sizing.reference.machine_powers
    given = sum(power for power in powers.values() if power > 0.0)
    takers = [
        name
        for name, machine in sizing.design.machines.items()
        if name != flown and not machine.drives and not isinstance(machine, Accessory)
    ]
    return {name: powers[name] / given for name in takers} if given else dict.fromkeys(takers, 0.0)


# ----------------------------------------------------------------------------------------------------------------------
# The sized gearbox as the mission sees it: what no load changes.
# ----------------------------------------------------------------------------------------------------------------------


_CASE = "mission"


class Drag(NamedTuple):
    """What the gearbox takes beside its meshes, shape (n,) each [W]."""

    bearings: Floats
    """And seals, where there are some."""
    windage: Floats
    churning: Floats


class Point(NamedTuple):
    """Operating points of the gearbox."""

    speeds: Floats
    """Of the train's nodes, shape (n, nodes) [rad/s]."""
    shaft_torques: Floats
    """Transmitted by each node: half the sum of what acts on it, shape (n, nodes) [N m]."""
    machine_powers: Floats
    """Into the train without drag, shape (n, machines) [W]."""
    mesh_torques: Floats
    """On gear a of one single mesh of each row, shape (n, meshes) [N m]."""
    mesh_losses: Floats
    """Of all equal meshes of a row, shape (n, meshes) [W]."""

    @property
    def mesh_loss(self) -> Floats:
        """Of all meshes, shape (n,) [W]."""
        return np.asarray(self.mesh_losses.sum(axis=1))

    @property
    def work(self) -> Floats:
        """Power that reaches the propeller, shape (n,) [W]."""
        return np.asarray(self.machine_powers.sum(axis=1) - self.mesh_loss)


class Way(NamedTuple):
    """One way in which a train turns in flight."""

    turn: Turn
    speeds: Floats
    """Of the nodes over that of the propeller, shape (nodes,) [-]."""
    joints: tuple[Joint, ...]
    """Clutches that hold."""
    at_once: bool
    """Whether equilibrium has one solution for every load."""


@dataclass(frozen=True)
class Gearbox:
    """A sizing with everything that does not change in flight worked out."""

    sizing: Sizing
    propeller: str
    """Name of its propeller."""
    oil: Oil
    teeth: Teeth
    """Contacts of the meshes."""
    inertia: float
    """Of everything that turns, at the propeller [kg m²]."""
    turning: Turning
    """Speeds of the train: intervals often turn alike."""
    taken: Mapping[str, float]
    """What takes its part of the power that the train is given -> this part [-]."""
    demand: Mapping[str, float]
    """Accessory -> what it takes whatever is given [W]; without any, torques and powers are proportional."""
    seats: tuple[Seat, ...]
    """Of the bearings whose load follows from the meshes."""
    machines: tuple[str, ...]
    """Machines without the propeller, in the order of a point's powers."""
    stages: tuple[str, ...]
    """That have meshes."""
    stage_of: Floats
    """Part of each mesh in the mean of its stage, shape (stages, meshes) [-]."""
    ways: dict[tuple[object, ...], Way] = field(default_factory=dict, compare=False)
    """How it was found to turn."""

    @cached_property
    def places(self) -> list[int]:
        """Nodes of the machines without the propeller."""
        train = self.sizing.train
        return [train.column[train.machines[name]] for name in self.machines]

    @cached_property
    def node(self) -> int:
        """Of the propeller."""
        train = self.sizing.train
        return train.column[train.machines[self.propeller]]

    @cached_property
    def counts(self) -> Floats:
        """Equal meshes of every row, shape (meshes,) [-]."""
        return np.array([float(row.count) for row in self.sizing.train.meshes])

    @cached_property
    def staged(self) -> list[int]:
        """Number of the stage of every mesh row."""
        return [self.stages.index(row.stage) for row in self.sizing.train.meshes]

    @cached_property
    def ends(self) -> list[list[int]]:
        """Columns of the rows' gears and carriers among the nodes; the ground is the last one."""
        column = {node: k for k, node in enumerate((*self.sizing.train.nodes, GROUND))}
        return [[column[row.nodes[place]] for row in self.sizing.train.meshes] for place in range(3)]

    @cached_property
    def takers(self) -> Bools:
        """Machines that take their part of the power that is given, shape (machines,)."""
        return np.array([name in self.taken for name in self.machines])

    def way(self, joints: tuple[Joint, ...], driving: frozenset[str]) -> Way:
        """Return how the train turns, found once.

        Args:
            joints: Clutches that hold.
            driving: Machines that may drive.

        Raises:
            DesignError: One speed does not set all others.
        """
        train, design = self.sizing.train, self.sizing.design
        still = self.turning.locked(joints) | left_alone(train, driving, joints)
        key = (joints, still)
        if key not in self.ways:
            asked = {**asked_speeds(design, {self.propeller: Drive(speed=1.0)}), **dict.fromkeys(still, 0.0)}
            signed = {name: abs(speed) * self.turning.senses[train.machines[name]] for name, speed in asked.items()}
            turn = self.turning.turn(signed, joints)
            turns = np.abs(turn.speeds) > STANDSTILL * np.abs(turn.speeds).max(initial=0.0)
            speeds = np.where(turns, turn.speeds, 0.0)
            self.ways[key] = Way(turn, speeds, joints, can_be_along(turn, self.node))
        return self.ways[key]


@verb
def gearbox_of(sizing: Sizing, propeller: str, oil: Oil) -> Gearbox:
    """Return a sizing made ready to fly.

    Args:
        sizing: The sized transmission.
        propeller: Name of the propeller that flies.
        oil: Its oil.
    """
    by_name(propeller, sizing.design.airscrews, "propeller")
    _refuse_slip(sizing)
    train = sizing.train
    stages = tuple(dict.fromkeys(row.stage for row in train.meshes))
    shares = np.array([[float(row.stage == stage) for row in train.meshes] for stage in stages])
    return Gearbox(
        sizing=sizing,
        propeller=propeller,
        oil=oil,
        teeth=teeth_of(sizing),
        inertia=_inertia(sizing, propeller),
        turning=Turning(sizing.design, train, sizing.teeth),
        taken=taken_parts(sizing),
        demand={name: accessory.power for name, accessory in sizing.design.accessories.items() if accessory.power},
        seats=bearing_seats(sizing),
        machines=tuple(name for name in train.machines if name != propeller),
        stages=stages,
        stage_of=shares / shares.sum(axis=1, keepdims=True),
    )


def _refuse_slip(sizing: Sizing) -> None:
    """Refuse dampers that slip: an operating point is scaled with its power, which their heat does not follow."""
    slipping = [name for name, damper in sizing.reference.dampers.items() if damper.slip]
    message = "its shafts turn at different speeds, and a mission does not fly with its heat; leave it out, or join"
    if slipping:
        raise DesignError([Problem(f"dampers.{name}", f"{message} shafts that turn alike") for name in slipping])


def _inertia(sizing: Sizing, propeller: str) -> float:
    """Everything that turns, reduced to the propeller by the speeds of the rated case."""
    speeds = sizing.reference.speeds
    carriers = {carrier.stage: carrier for carrier in sizing.carriers}
    energy = 0.0
    for gear in sizing.gears:
        energy += gear.turning_inertia * gear.bodies * float(np.mean([speeds[node] ** 2 for node in gear.shafts]))
        if gear.role is Role.PLANET:
            carrier = carriers[gear.stage]
            energy += gear.turning_mass * gear.bodies * (carrier.radius * speeds[carrier.shaft]) ** 2
    energy += sum(shaft.inertia * speeds[shaft.name] ** 2 for shaft in sizing.shafts)
    energy += sum(carrier.inertia * speeds[carrier.shaft] ** 2 for carrier in sizing.carriers)
    energy += sum(machine.inertia * speeds[machine.shaft] ** 2 for machine in sizing.machines)
    return float(energy / speeds[sizing.train.machines[propeller]] ** 2)


# ----------------------------------------------------------------------------------------------------------------------
# What the train carries under many loads: by clutches that hold, and one after the other where losses are large.
# ----------------------------------------------------------------------------------------------------------------------


Faults = NDArray[np.object_]
"""Why there is no balance under each load, or None, shape (n,)."""


def has_fault(faults: Faults) -> Bools:
    """Tell under which loads there is no balance, shape (n,).

    Args:
        faults: Of every load.
    """
    return np.array([fault is not None for fault in faults])


class Carried(NamedTuple):
    """What a train carries under many loads."""

    speeds: Floats
    """Of the nodes, shape (n, nodes) [rad/s]."""
    powers: Floats
    """Of the machines without the propeller, shape (n, machines) [W]."""
    first: Floats
    """Torque on gear a of every mesh row, all equal meshes together, shape (n, meshes) [N m]."""
    second: Floats
    """Torque on gear b, likewise [N m]."""
    third: Floats
    """Torque on the carrier, likewise [N m]."""
    balancing: Floats
    """Torque of the propeller, shape (n,) [N m]."""
    links: Floats
    """Torque that every clutch and damper gives to its driven shaft, shape (n, links) [N m]."""
    faults: Faults

    def at(self, places: Any) -> Carried:
        """Return what is carried under some loads.

        Args:
            places: Which.
        """
        return Carried(*(column[places] for column in self))

    def put(self, places: Any, other: Carried) -> None:
        """Put what is carried under other loads in the place of some.

        Args:
            places: Which.
            other: What is put there.
        """
        for column, values in zip(self, other, strict=True):
            column[places] = values

    def scaled(self, factor: Floats) -> Carried:
        """Return it with all torques and powers changed, accessories' among them.

        Args:
            factor: Of each load, shape (n,) [-].
        """
        columns: Any = [column * (factor[:, None] if column.ndim == 2 else factor) for column in self[1:-1]]
        return self._replace(**dict(zip(self._fields[1:-1], columns, strict=True)))


def machine_powers(gearbox: Gearbox, parts: Floats, taken: Floats, power: Floats) -> Floats:
    """Return what the machines without the propeller give, shape (n, machines) [W].

    Args:
        gearbox: The gearbox.
        parts: Of the power that machines give, shape (n, machines) [-].
        taken: Part of it that others take, shape (n, machines) [-].
        power: That they give together, shape (n,) [W].
    """
    given = parts * power[:, None]
    total = np.abs(np.where(gearbox.takers, 0.0, given).sum(axis=1))
    powers = np.where(gearbox.takers & (parts == 0.0), taken * total[:, None], given)
    for name, demand in gearbox.demand.items():
        powers[:, gearbox.machines.index(name)] = -demand
    return powers


def balanced(gearbox: Gearbox, powers: Floats, propeller_speed: Floats, lost: Floats) -> Carried:
    """Return what the train carries where the propeller takes what is left.

    Args:
        gearbox: The gearbox.
        powers: Of the machines without it, shape (n, machines) [W].
        propeller_speed: Shape (n,) [rad/s].
        lost: Part that the meshes of each stage lose, shape (n, stages) [-].

    Raises:
        DesignError: One speed does not set all others.
    """
    train, count = gearbox.sizing.train, len(propeller_speed)
    held = tuple(joint for joint in train.joints if joint.overrunning or not joint.is_open)
    if not train.joints:
        return _turned(gearbox, gearbox.way(held, frozenset(train.machines)), powers, propeller_speed, lost)
    found: Carried | None = None
    left = [(np.arange(count), held)]
    while left:
        lanes, joints = left.pop()
        for own, way in _ways(gearbox, lanes, joints, powers):
            part = _turned(gearbox, way, powers[own], propeller_speed[own], lost[own])
            found = (
                Carried(*(np.zeros((count, *column.shape[1:]), column.dtype) for column in part))
                if found is None
                else found
            )
            open_ = np.zeros(len(own), bool)
            for joint in joints:  # one that has nothing to transmit lets go, and the others are asked again
                torque = -part.links[:, train.links.index(joint)]
                slips = np.broadcast_to(overruns(joint, torque, train, way.speeds), open_.shape) & ~open_
                if slips.any() and way.at_once:
                    left.append((own[slips], tuple(other for other in joints if other is not joint)))
                    open_ |= slips
            found.put(own[~open_], part.at(~open_))
    assert found is not None  # there are loads
    return found


def _ways(gearbox: Gearbox, lanes: Ints, joints: tuple[Joint, ...], powers: Floats) -> Iterator[tuple[Ints, Way]]:
    """Yield loads under which the same machines may drive, and how the train then turns."""
    drives = powers[lanes] > 0.0
    if len(joints) == len(gearbox.sizing.train.joints):
        drives = np.zeros_like(drives)  # nothing is parted from anything
    for pattern in np.unique(drives, axis=0):
        driving = {name for name, drive in zip(gearbox.machines, pattern, strict=True) if drive} | {gearbox.propeller}
        alike = lanes[(drives == pattern).all(axis=1)]
        if len(joints) == len(gearbox.sizing.train.joints):
            driving |= set(gearbox.machines)
        yield alike, gearbox.way(joints, frozenset(driving))


def _turned(gearbox: Gearbox, way: Way, powers: Floats, propeller_speed: Floats, lost: Floats) -> Carried:
    """Return what the train carries where it turns one way; large losses may leave it several states."""
    part = lost[:, gearbox.staged]
    slight = is_slight(way.turn, gearbox.node, part) if way.at_once else np.zeros(len(part), bool)
    if slight.all():
        found = _turned_slightly(gearbox, way, powers, propeller_speed, part)
        return _one_by_one(gearbox, powers, propeller_speed, lost) if found is None else found
    alone = _one_by_one(gearbox, powers[~slight], propeller_speed[~slight], lost[~slight])
    if not slight.any():
        return alone
    rest = _turned(gearbox, way, powers[slight], propeller_speed[slight], lost[slight])
    whole = Carried(*(np.zeros((len(part), *column.shape[1:]), column.dtype) for column in alone))
    whole.put(slight, rest)
    whole.put(~slight, alone)
    return whole


def _turned_slightly(
    gearbox: Gearbox, way: Way, powers: Floats, propeller_speed: Floats, part: Floats
) -> Carried | None:
    """Return what the train carries where losses leave one state; None where the sides that drive do not settle."""
    train, speeds = gearbox.sizing.train, way.speeds * propeller_speed[:, None]
    applied, powers = np.zeros_like(speeds), _of_turning(gearbox, way, powers)
    for k, node in enumerate(gearbox.places):
        applied[:, node] += torque_of(powers[:, k], speeds[:, node])
    dragged = {damper.name: _dragged(train.column, damper, speeds) for damper in train.dampers}
    for damper in train.dampers:
        applied[:, train.column[damper.driven]] += dragged[damper.name]
        applied[:, train.column[damper.driving]] -= dragged[damper.name]
    loads = along(way.turn, gearbox.node, part, applied)
    if loads is None:
        return None
    links = np.zeros((len(speeds), len(train.links)))
    for k, link in enumerate(train.links):
        if isinstance(link, Joint) and link in way.joints:
            links[:, k] = -loads.multipliers[:, len(train.meshes) + way.joints.index(link)]
        elif link.name in dragged:
            links[:, k] = dragged[link.name]
    faults = _still(gearbox, powers, speeds)
    return Carried(speeds, powers, loads.first, loads.second, loads.third, loads.balancing, links, faults)


def _of_turning(gearbox: Gearbox, way: Way, powers: Floats) -> Floats:
    """Return the powers of machines without those of accessories that stand still."""
    still = [
        k for k, name in enumerate(gearbox.machines) if name in gearbox.demand and not way.speeds[gearbox.places[k]]
    ]
    if still:
        powers = powers.copy()
        powers[:, still] = 0.0
    return powers


def torque_of(power: Floats, speed: Floats) -> Floats:
    """Return the torque of a power; none where nothing turns.

    Args:
        power: [W].
        speed: [rad/s].
    """
    none = (power == 0.0) | (speed == 0.0)
    return np.where(none, 0.0, power / np.where(none, 1.0, speed))


def _dragged(column: Mapping[str, int], damper: Damper, speeds: Floats) -> Floats:
    """Return the torque that a damper gives to its driven shaft [N m]; a slip that is rounding is none."""
    slip = speeds[:, column[damper.driving]] - speeds[:, column[damper.driven]]
    slips = np.abs(slip) > STANDSTILL * np.abs(speeds).max(axis=1)
    return np.where(slips, damper.damping * slip, 0.0)


def _still(gearbox: Gearbox, powers: Floats, speeds: Floats) -> Faults:
    """Return what is wrong with powers of machines whose shafts stand still; accessories take none there."""
    faults: Faults = np.full(len(powers), None, object)
    for k, node in enumerate(gearbox.places):
        name = gearbox.machines[k]
        if name in gearbox.demand or speeds[:, node].all():
            continue
        for place in np.flatnonzero((powers[:, k] != 0.0) & (speeds[:, node] == 0.0)):
            shaft, power = gearbox.sizing.train.machines[name], powers[place, k] / 1e3
            message = f"{power:g} kW at standstill: its shaft {shaft!r} does not turn; give its torque"
            faults[place] = DesignError([Problem(f"cases.{_CASE}.{name}", message)])
    return faults


def _one_by_one(gearbox: Gearbox, powers: Floats, propeller_speed: Floats, lost: Floats) -> Carried:
    """Return what the train carries, one load after the other: losses so large that several states may be."""
    sizing, train, count = gearbox.sizing, gearbox.sizing.train, len(powers)
    speeds, links = np.ones((count, len(train.nodes))), np.zeros((count, len(train.links)))
    torques, balancing = np.zeros((3, count, len(train.meshes))), np.zeros(count)
    faults: Faults = np.full(count, None, object)
    for k in range(count):
        given = zip(gearbox.machines, powers[k].tolist(), strict=True)
        drives = {name: Drive(power=power) for name, power in given if power and name not in gearbox.demand}
        drives[gearbox.propeller] = Drive(speed=float(propeller_speed[k]))
        design = sizing.design.model_copy(update={"cases": {_CASE: Case.model_validate(drives)}})
        efficiency = {stage: 1.0 - part for stage, part in zip(gearbox.stages, lost[k].tolist(), strict=True)}
        try:
            flow = power_flow(design, train, sizing.teeth, _CASE, efficiency=efficiency, turning=gearbox.turning)
        except GearwrightError as error:
            faults[k] = error
            continue
        speeds[k] = [flow.speeds[node] for node in train.nodes]
        torques[:, k] = np.array([flow.meshes[mesh.name].torques for mesh in train.meshes]).T
        balancing[k] = flow.machine_torques[gearbox.propeller]
        links[k] = [flow.given(link.name) for link in train.links]
    return Carried(speeds, powers, torques[0], torques[1], torques[2], balancing, links, faults)


def _mesh_losses(gearbox: Gearbox, carried: Carried) -> Floats:
    """Return what each mesh row loses, shape (n, meshes) [W]."""
    full = np.concatenate([carried.speeds, np.zeros((len(carried.speeds), 1))], axis=1)
    first, second, third = (full[:, places] for places in gearbox.ends)
    return np.asarray(-carried.first * (first - third) - carried.second * (second - third))


def point_of(gearbox: Gearbox, carried: Carried) -> Point:
    """Return the operating points of what is carried.

    Args:
        gearbox: The gearbox.
        carried: By its train.
    """
    train, speeds, powers = gearbox.sizing.train, carried.speeds, carried.powers
    total = np.zeros((speeds.shape[0], speeds.shape[1] + 1))
    for places, torque in zip(gearbox.ends, (carried.first, carried.second, carried.third), strict=True):
        for k, place in enumerate(places):
            total[:, place] += np.abs(torque[:, k])
    for k, node in enumerate(gearbox.places):
        total[:, node] += np.abs(torque_of(powers[:, k], speeds[:, node]))
    total[:, gearbox.node] += np.abs(carried.balancing)
    for k, link in enumerate(train.links):
        for name in {link.driving, link.driven} - {GROUND}:
            total[:, train.column[name]] += np.abs(carried.links[:, k])
    losses = _mesh_losses(gearbox, carried)
    return Point(speeds, 0.5 * total[:, :-1], powers, carried.first / gearbox.counts, losses)


# ----------------------------------------------------------------------------------------------------------------------
# What the gearbox loses: teeth by their loads, bearings by theirs, and what turns in oil and mist whatever is carried.
# ----------------------------------------------------------------------------------------------------------------------


def warm_oil(gearbox: Gearbox, temperature: Floats) -> Oil:
    """Return the oil of the gearbox.

    Args:
        gearbox: The gearbox.
        temperature: Under each load, shape (n,) [K]; NaN: as the mission says.
    """
    return gearbox.oil if np.isnan(temperature).all() else gearbox.oil._replace(temperature=temperature)


def node_speeds(gearbox: Gearbox, speeds: Floats) -> dict[str, Floats]:
    """Return node -> speed under every load, of the ground too, shape (n,) [rad/s].

    Args:
        gearbox: The gearbox.
        speeds: Of the nodes, shape (n, nodes) [rad/s].
    """
    return {**dict(zip(gearbox.sizing.train.nodes, speeds.T.copy(), strict=True)), GROUND: np.zeros(1)}


def stage_losses(gearbox: Gearbox, mesh_torques: Floats, speeds: Floats, oil: Floats) -> Floats:
    """Return the part that the meshes of each stage lose: of its meshes the mean, shape (n, stages) [-].

    Args:
        gearbox: The gearbox.
        mesh_torques: On gear a of one single mesh of each row, shape (n, meshes) [N m].
        speeds: Of the nodes, shape (n, nodes) [rad/s].
        oil: Its temperature, shape (n,) [K]; NaN: as the mission says.
    """
    found = mesh_loss_parts(
        gearbox.sizing, gearbox.teeth, mesh_torques.T,
        speeds=node_speeds(gearbox, speeds), oil=warm_oil(gearbox, oil),
    )  # fmt: skip
    parts = np.stack(list(found.values()), axis=1)
    return np.stack([(parts * share).sum(axis=1) for share in gearbox.stage_of], axis=1)


class Idle(NamedTuple):
    """What takes power whatever is carried, shape (n,) each [W]."""

    windage: Floats
    churning: Floats
    seals: Floats


def idle_of(gearbox: Gearbox, speeds: Floats, oil: Floats) -> Idle:
    """Return what takes power whatever is carried.

    Args:
        gearbox: The gearbox.
        speeds: Of the nodes, shape (n, nodes) [rad/s].
        oil: Its temperature, shape (n,) [K]; NaN: as the mission says.
    """
    turning, state = node_speeds(gearbox, speeds), warm_oil(gearbox, oil)
    total = {origin: np.zeros(len(speeds)) for origin in ORIGINS}
    for row in (*gear_losses(gearbox.sizing, turning, state), *seal_losses(gearbox.sizing, turning, state)):
        total[row.origin] = total[row.origin] + row.power
    return Idle(*(total[origin] for origin in Idle._fields))


def drag_of(gearbox: Gearbox, mesh_torques: Floats, speeds: Floats, oil: Floats, idle: Idle | None = None) -> Drag:
    """Return what bearings, windage and churning take from the machines.

    Args:
        gearbox: The gearbox.
        mesh_torques: On gear a of one single mesh of each row, shape (n, meshes) [N m].
        speeds: Of the nodes, shape (n, nodes) [rad/s].
        oil: Its temperature, shape (n,) [K]; NaN: as the mission says.
        idle: From `idle_of`; left out: found here.
    """
    turning, taken = node_speeds(gearbox, speeds), np.zeros(len(speeds))
    forces = {seat.name: seat_forces_along(seat, mesh_torques, turning[seat.carrier]) for seat in gearbox.seats}
    for seat in rubbing(gearbox.sizing, gearbox.seats, forces, speeds=turning, oil=warm_oil(gearbox, oil)):
        taken = taken + seat.power
    idle = idle_of(gearbox, speeds, oil) if idle is None else idle
    return Drag(taken + idle.seals, idle.windage, idle.churning)


# ----------------------------------------------------------------------------------------------------------------------
# Rounds over all intervals at once, in which loads and what teeth lose under the loads of the one before agree.
# ----------------------------------------------------------------------------------------------------------------------


TRIAL_POWER = 1e5
"""Power at which an operating point is found before it is scaled [W]; torques and powers are proportional."""
MET = 1e-12
"""Difference of the propeller's power from the asked one that is met, over all that is given [-]."""
MOST_TRIALS = 20
"""Trials for it: the power is nearly linear in what is given, and two or three do."""
_SETTLED = 1e-13
"""Change of a part that is lost below which rounds have settled [-]."""
ROUNDS = 5
"""Every one leaves some 0.002 of the error of the one before, which begins with all losses, about 0.01."""


class Asked(NamedTuple):
    """What intervals ask of the gearbox; arrays have a first axis of n."""

    first: Bools
    """Where a flight begins."""
    again: Bools
    """Where a phase begins: losses are found twice."""
    wanted: Floats
    """Power of the propeller's shaft; NaN: of the machines [W]."""
    given: Floats
    """Power of the machines [W]."""
    speed: Floats
    """Of the propeller [rad/s]."""
    spin_up: Floats
    """Power into everything that turns [W]."""
    dragged: Floats
    """By shafts that turn motors without current [W]."""
    oil: Floats
    """Its temperature; NaN: as the mission says [K]."""
    parts: Floats
    """Of the machines, in the order of a point's powers, shape (n, machines) [-]."""
    taken: Floats
    """Of what is given, by machines that take their part of it, shape (n, machines) [-]."""

    def at(self, lanes: Any) -> Asked:
        """Return what some intervals ask.

        Args:
            lanes: Which.
        """
        return Asked(*(column[lanes] for column in self))


class Balanced(NamedTuple):
    """A gearbox in balance."""

    point: Point
    friction: Drag
    short: Floats
    """Power of the machines that nothing is left of for the propeller; NaN where there is some [W]."""
    faults: Faults
    lost: Floats
    """Part that teeth of each stage lose, shape (n, stages) [-]."""
    change: Floats
    """Of that part in the last round, shape (n,) [-]."""

    @property
    def settled(self) -> Bools:
        """Where another round would change nothing."""
        return np.asarray(self.change <= _SETTLED)

    @property
    def fails(self) -> Bools:
        """Where there is no balance."""
        return ~np.isnan(self.short) | has_fault(self.faults)


class Known(NamedTuple):
    """What a round has found, for the next one."""

    lost: Floats
    """Part that teeth of each stage lose, shape (n, stages) [-]."""
    torques: Floats
    """On gear a of one single mesh of each row, shape (n, meshes) [N m]."""
    nodes: Floats
    """Speeds of the train's nodes, shape (n, nodes) [rad/s]."""


def balanced_rounds(gearbox: Gearbox, asked: Asked, known: Known | None = None) -> Balanced:
    """Return the gearbox in balance after a few rounds.

    Args:
        gearbox: The gearbox.
        asked: Of it.
        known: By the round before, for one more; left out: nothing is known, and there are as many rounds as it takes.

    Source: the losses of an interval are those of the loads of the one before; where a phase starts they are found
        twice. Rounds over all intervals end where nothing changes, which is where one after the other leads. Of
        intervals that ask what the one before asks, as many are computed as there are rounds.
    """
    if known is not None:
        return _rounds(gearbox, asked, known.lost, 1, known)
    columns = (*asked[2:-2], *asked.parts.T.copy(), *asked.taken.T.copy())
    kept, source = runs_of(columns, asked.first | asked.again, ROUNDS)
    found: Balanced = spread(_rounds(gearbox, asked.at(kept), no_losses(gearbox, len(kept)), ROUNDS), source)
    return found


def given_powers(machines: Sequence[str], asked: Asked, found: Balanced) -> dict[str, Floats]:
    """Return machine -> power into the train, with drag and spin-up, shape (n,) [W].

    Args:
        machines: Without the propeller, in the order of a point's powers.
        asked: Of the gearbox.
        found: What it carries.
    """
    carried, point = sum(found.friction) + asked.dragged + asked.spin_up, found.point
    return {name: point.machine_powers[:, k] + asked.parts[:, k] * carried for k, name in enumerate(machines)}


def no_losses(gearbox: Gearbox, count: int) -> Floats:
    """Return losses that are none, shape (n, stages) [-].

    Args:
        gearbox: The gearbox.
        count: Intervals [-].
    """
    return np.zeros((count, len(gearbox.stages)))


def _rounds(gearbox: Gearbox, asked: Asked, lost: Floats, count: int, known: Known | None = None) -> Balanced:
    first, again = asked.first[:, None], np.flatnonzero(asked.again | asked.first)
    starting, idle = asked.at(again), _idle(gearbox, asked)
    idle_starts = None if idle is None else Idle(*(column[again] for column in idle))
    met: _Met | None = None
    change = lost[:, 0]
    for _ in range(count):  # always as many: a flight is the same whatever others it is found with
        met = _met(gearbox, asked, idle, np.where(first, 0.0, _handed_on(gearbox, asked, lost, known)))
        begun = met.carried.at(again)
        twice = _met(gearbox, starting, idle_starts, _losses(gearbox, begun, starting.oil))
        met.carried.put(again, twice.carried)
        met.short[again] = twice.short
        anew = _losses(gearbox, met.carried, asked.oil)
        change, lost = np.abs(anew - lost).max(axis=1), anew
    assert met is not None  # there are rounds
    point = point_of(gearbox, met.carried)
    friction = drag_of(gearbox, point.mesh_torques, point.speeds, asked.oil, idle)
    return Balanced(point, friction, met.short, met.carried.faults, lost, change)


def _handed_on(gearbox: Gearbox, asked: Asked, lost: Floats, known: Known | None) -> Floats:
    """Return what teeth lose by the loads of the interval before, with the oil of this one [-]."""
    if known is None or np.isnan(asked.oil).all():
        return np.roll(lost, 1, axis=0)
    torques, nodes = np.roll(known.torques, 1, axis=0), np.roll(known.nodes, 1, axis=0)
    return stage_losses(gearbox, torques, nodes, asked.oil)


def _idle(gearbox: Gearbox, asked: Asked) -> Idle | None:
    """Return what takes power whatever is carried; None where speeds follow from clutches that let go."""
    train = gearbox.sizing.train
    if train.joints:
        return None
    speeds = gearbox.way((), frozenset(train.machines)).speeds * asked.speed[:, None]
    return idle_of(gearbox, speeds, asked.oil)


class _Met(NamedTuple):
    """Loads in balance."""

    carried: Carried
    short: Floats


def _met(gearbox: Gearbox, asked: Asked, idle: Idle | None, lost: Floats) -> _Met:
    """Return the loads under which propeller or machines have their power.

    A propeller that the air drives has a negative power: it is found with machines that take power, so that losses
    stay losses.
    """
    by_work, none = ~np.isnan(asked.wanted), np.full(len(lost), np.nan)
    trial = np.where(asked.wanted < 0.0, -TRIAL_POWER, TRIAL_POWER)
    if gearbox.demand:
        return _met_by_trials(gearbox, asked, idle, lost)
    powers = machine_powers(gearbox, asked.parts, asked.taken, trial)
    carried = balanced(gearbox, powers, asked.speed, lost)
    work = powers.sum(axis=1) - _mesh_losses(gearbox, carried).sum(axis=1)
    factor = np.where(by_work, asked.wanted / np.where(work == 0.0, 1.0, work), 0.0)
    if by_work.all():
        return _Met(carried.scaled(factor), none)
    torques = np.where(by_work, 0.0, asked.given / TRIAL_POWER)[:, None] * carried.first / gearbox.counts
    left = _left(gearbox, asked, idle, torques, carried.speeds)
    factor = np.where(by_work, factor, left / TRIAL_POWER)
    return _Met(carried.scaled(factor), np.where(~by_work & (left <= 0.0), left, np.nan))


def _left(gearbox: Gearbox, asked: Asked, idle: Idle | None, torques: Floats, speeds: Floats) -> Floats:
    """Return what is left of the machines' power for the train, shape (n,) [W]."""
    drag = drag_of(gearbox, torques, speeds, asked.oil, idle)
    return asked.given - asked.spin_up - sum(drag) - asked.dragged


def _met_by_trials(gearbox: Gearbox, asked: Asked, idle: Idle | None, lost: Floats) -> _Met:
    """Return the same beside accessories, whose power is not proportional to what is given: by secants."""
    by_work = ~np.isnan(asked.wanted)

    def given(places: Any, power: Floats) -> tuple[Carried, Floats]:
        """Return what is carried where the machines give a power [W], and what then reaches the propeller."""
        powers = machine_powers(gearbox, asked.parts[places], asked.taken[places], power)
        carried = balanced(gearbox, powers, asked.speed[places], lost[places])
        return carried, carried.powers.sum(axis=1) - _mesh_losses(gearbox, carried).sum(axis=1)

    everywhere = slice(None)
    power = np.where(by_work, asked.wanted + sum(gearbox.demand.values()), asked.given)
    carried, work = given(everywhere, power)
    if not by_work.all():
        left = _left(gearbox, asked, idle, carried.first / gearbox.counts, carried.speeds)
        short = np.where(~by_work & (left <= 0.0), left, np.nan)
        places = np.flatnonzero(~by_work)
        going_on = np.where(left > 0.0, left, asked.given)  # what is short is refused whatever it would carry
        carried.put(places, given(places, going_on[places])[0])
    else:
        short = np.full(len(power), np.nan)
    slope, going = np.ones(len(power)), np.flatnonzero(by_work)
    for _ in range(MOST_TRIALS):
        missing = asked.wanted[going] - work[going]
        open_ = ~(np.abs(missing) <= MET * (np.abs(asked.wanted[going]) + np.abs(power[going]))) & (slope[going] != 0.0)
        going, missing = going[open_], missing[open_]
        if not len(going):
            break
        power[going] += missing / slope[going]
        found, reached = given(going, power[going])
        slope[going] *= (reached - work[going]) / missing
        work[going] = reached
        carried.put(going, found)
    missed = by_work & ~(np.abs(asked.wanted - work) <= MET * (np.abs(asked.wanted) + np.abs(power)))
    for k in np.flatnonzero(missed & ~has_fault(carried.faults)):
        carried.faults[k] = SolveError(
            f"no power of the machines gives the propeller its {asked.wanted[k] / 1e3:.4g} kW"
        )
    return _Met(carried, short)


def _losses(gearbox: Gearbox, carried: Carried, oil: Floats) -> Floats:
    """Return what the teeth of each stage lose under what is carried [-]."""
    return stage_losses(gearbox, carried.first / gearbox.counts, carried.speeds, oil)
