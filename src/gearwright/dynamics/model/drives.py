"""Drives: propellers, machines and slipping clutches as named records, as numbers, and in plain numpy.

A drive hands torque to one rotation (a clutch to two) by a law of their speeds; what a law needs to know of the flight
(density, airspeed, set speed, a command) it reads against time. `encoded` packs the records into one table for compiled
code; `drive_effects` reads that table in plain Python and is the oracle that the compiled laws must agree with.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.dynamics.model.system import Drives, Owner, Schedules
from gearwright.identity import Kind, PartId
from gearwright.machines import Governor, GovernorState, PropellerMap, governor_rates, look_up

Curve = float | Sequence[tuple[float, float]]
"""A constant, or (time [s], value) joined by straight lines."""

HEADER = 8
"""Numbers before those of a law: length, kind, rotation, its Ω, second rotation, its Ω, first state, first input."""
PROPELLER, MACHINE, CLUTCH = 0, 1, 2
"""Kinds of records."""
OUTPUTS = 3
"""Numbers that each drive reports: torque, speed, flag."""
STANDSTILL = 1e-9
"""Revolutions per second at least, so that an advance ratio is a number [1/s]."""


class PropellerDrive(NamedTuple):
    """A propeller by its map, with the governor that moves its pitch; states: pitch, its rate, sum of speed errors.

    Its flag is 1 where the point lies outside the map.
    """

    name: str
    body: str
    """Rotation that carries it."""
    chart: PropellerMap
    """Its map."""
    diameter: float
    """D [m]."""
    governor: Governor
    """Its settings."""
    start: GovernorState
    """State at time 0."""
    density: Curve
    """ρ [kg/m³]."""
    airspeed: Curve
    """V, along the axis [m/s]."""
    set_speed: Curve
    """Speed that the governor holds [rad/s]."""
    pitch_command: Curve = 0.0
    """Added to the governor's reference [rad]."""
    beyond: bool = False
    """True: beyond the largest advance ratio C_P grows with J², as of blades that hardly turn in a stream."""


class MachineDrive(NamedTuple):
    """A turbine or motor, T = u(t) (1 + κ (1 − ω/ω_r)) within its limits; its flag is 1 where a limit holds it."""

    name: str
    body: str
    """Rotation that it drives."""
    command: Curve
    """u: torque at the reference speed, negative where it brakes [N m]."""
    speed: float
    """ω_r [rad/s]."""
    slope: float = 0.0
    """κ: 0 is a source of torque, 1 falls as constant power does at ω_r [-]."""
    highest_torque: float = math.inf
    """[N m]"""
    highest_power: float = math.inf
    """[W]"""


class ClutchDrive(NamedTuple):
    """A clutch: a spring and a damper that slip at the capacity; state: twist of the spring.

    Its torque is positive if the first rotation leads. Its flag is 1 while it slips.
    """

    name: str
    first: str
    second: str
    stiffness: float
    """k [N m/rad]."""
    damping: float
    """c, positive [N m s/rad]."""
    capacity: Curve
    """Torque at which it slips [N m]."""
    one_way: bool = False
    """True: it overruns freely when the second rotation leads."""
    carried: float = 0.0
    """Torque at the start [N m]."""


Drive = PropellerDrive | MachineDrive | ClutchDrive


class Acting(NamedTuple):
    """What all drives do at one instant."""

    torque: Floats
    """On each coordinate [N m], shape (coordinates,)."""
    rate: Floats
    """Rate of each state, shape (states,)."""
    output: Floats
    """States, then torque, speed and flag of each drive, shape (columns,)."""


def inputs_of(drive: Drive) -> tuple[Curve, ...]:
    """Return what a drive reads against time, in the order in which its law does.

    Args:
        drive: The record.
    """
    match drive:
        case PropellerDrive():
            return drive.density, drive.airspeed, drive.set_speed, drive.pitch_command
        case MachineDrive():
            return (drive.command,)
        case ClutchDrive():
            return (drive.capacity,)


def _states_of(drive: Drive) -> tuple[float, ...]:
    match drive:
        case PropellerDrive():
            return tuple(drive.start)
        case MachineDrive():
            return ()
        case ClutchDrive():
            return (drive.carried / drive.stiffness,)


def _bodies_of(drive: Drive) -> tuple[str, str | None]:
    return (drive.first, drive.second) if isinstance(drive, ClutchDrive) else (drive.body, None)


def _numbers_of(drive: Drive, sense: float) -> list[float]:
    match drive:
        case PropellerDrive():
            chart = drive.chart
            sizes = [float(len(chart.advance_ratio)), float(len(chart.blade_angle))]
            grids = np.concatenate([np.ravel(grid).astype(float) for grid in chart])
            return [drive.diameter, *drive.governor, *sizes, *(float(value) for value in grids), float(drive.beyond)]
        case MachineDrive():
            return [sense, drive.speed, drive.slope, drive.highest_torque, drive.highest_power]
        case ClutchDrive():
            return [drive.stiffness, drive.damping, 0.0 if drive.one_way else -1.0]


def encoded(drives: Sequence[Drive], index: Mapping[str, int], speed: Floats) -> Drives:
    """Return drives as the kernel reads them.

    Args:
        drives: The records.
        index: Coordinate -> its number.
        speed: Ω of each coordinate, shape (coordinates,); a machine drives in its sense [rad/s].
    """
    table, start, inputs = [float(len(drives)), float(len(speed))], list[float](), list[tuple[int, Curve]]()
    for number, drive in enumerate(drives):
        first, second = _bodies_of(drive)
        dof, second_dof = index[first], -1 if second is None else index[second]
        numbers = _numbers_of(drive, -1.0 if speed[dof] < 0.0 else 1.0)
        kind = (PropellerDrive, MachineDrive, ClutchDrive).index(type(drive))
        ends = [dof, speed[dof], second_dof, 0.0 if second_dof < 0 else speed[second_dof]]
        table += [HEADER + len(numbers), kind, *ends, len(start), len(inputs), *numbers]
        start += _states_of(drive)
        inputs += [(number, curve) for curve in inputs_of(drive)]
    return Drives(np.array(table if drives else [], dtype=float), np.array(start, dtype=float), _schedules(inputs))


def _schedules(inputs: Sequence[tuple[int, Curve]]) -> Schedules:
    points = [points_of(curve) for _, curve in inputs]
    return Schedules(
        dof=np.array([number for number, _ in inputs], dtype=np.int64),
        start=np.cumsum([0, *(len(point) for point in points)]).astype(np.int64),
        time=np.array([time for point in points for time, _ in point], dtype=float),
        value=np.array([value for point in points for _, value in point], dtype=float),
    )


def points_of(curve: Curve) -> Sequence[tuple[float, float]]:
    """Return a curve as points (time [s], value).

    Args:
        curve: Constant or points.
    """
    return ((0.0, float(curve)),) if isinstance(curve, int | float) else curve


class Column(NamedTuple):
    """One number that is recorded of a drive."""

    owner: Owner
    """Machine or clutch, and what it is of it."""
    unit: str

    @property
    def name(self) -> str:
        """Such as ``propeller pitch``."""
        return f"{self.owner.part} {self.owner.what}"


def drive_columns(drives: Sequence[Drive]) -> tuple[Column, ...]:
    """Return what is recorded of drives, in order: all states, then torque, speed and flag of each.

    Args:
        drives: The records.
    """
    states = [column for drive in drives for column in _columns(drive, _STATES[type(drive)])]
    return (*states, *(column for drive in drives for column in _columns(drive, _REPORTS[type(drive)])))


def _columns(drive: Drive, quantities: Mapping[str, str]) -> list[Column]:
    part = PartId(Kind.CLUTCH if isinstance(drive, ClutchDrive) else Kind.MACHINE, drive.name)
    return [Column(Owner(part, what), unit) for what, unit in quantities.items()]


TORQUE, SPEED, PITCH = "torque", "speed", "pitch"
"""What is recorded of drives, of machines and propellers, of propellers."""
OUTSIDE_MAP = "outside map"
"""Flag of a propeller; a run that raises it is refused."""
_STATES: Mapping[type, Mapping[str, str]] = {
    PropellerDrive: {PITCH: "rad", "pitch rate": "rad/s", "error sum": "rad"},
    MachineDrive: {},
    ClutchDrive: {"twist": "rad"},
}
"""Kind of drive -> its states with their units."""
_REPORTS: Mapping[type, Mapping[str, str]] = {
    PropellerDrive: {TORQUE: "N m", SPEED: "rad/s", OUTSIDE_MAP: "-"},
    MachineDrive: {TORQUE: "N m", SPEED: "rad/s", "limited": "-"},
    ClutchDrive: {TORQUE: "N m", "slip": "rad/s", "slipping": "-"},
}
"""Kind of drive -> what it reports with its unit."""


def drive_effects(drives: Drives, total: Floats, inputs: Floats, states: Floats) -> Acting:
    """Return what all drives do, in plain Python.

    Args:
        drives: As encoded.
        total: Speed of each coordinate, with that of the rigid motion [rad/s], shape (coordinates,).
        inputs: What they read at this instant, shape (inputs,).
        states: Shape (states,).

    Source: propeller Q = C_P ρ n² D⁵/(2 π) with its map and `governor_rates`; machine and clutch as their records say.
    """
    torque, rate, reports = np.zeros(len(total)), np.zeros(len(states)), list[float]()
    place = 2
    while place < len(drives.table):
        length, kind, dof, _, second, _, state, first = (int(value) for value in drives.table[place : place + HEADER])
        numbers, read = drives.table[place + HEADER : place + length], inputs[first:]
        if kind == PROPELLER:
            value, flag, moved = _propeller(numbers, read, float(total[dof]), GovernorState(*states[state : state + 3]))
            rate[state : state + 3] = moved
        elif kind == MACHINE:
            value, flag = _machine(numbers, float(read[0]), float(total[dof]))
        else:
            slip = float(total[dof] - total[second])
            value, flag, rate[state] = _clutch(numbers, float(read[0]), slip, float(states[state]))
            torque[second] += value
            value = -value
        torque[dof] += value
        report = -value if kind != MACHINE else value
        reports += [report, float(total[dof] - (total[second] if kind == CLUTCH else 0.0)), flag]
        place += length
    return Acting(torque, rate, np.concatenate([states, reports]))


def _propeller(numbers: Floats, read: Floats, speed: float, state: GovernorState) -> tuple[float, float, GovernorState]:
    diameter, governor = float(numbers[0]), Governor(*numbers[1:9])
    rows, columns = int(numbers[9]), int(numbers[10])
    sizes = (rows, columns, rows * columns, rows * columns, rows, rows)
    parts, beyond = np.split(numbers[11:-1], np.cumsum(sizes)[:-1]), bool(numbers[-1])
    power, thrust = (grid.reshape(rows, columns) for grid in parts[2:4])
    chart = PropellerMap(parts[0], parts[1], power, thrust, parts[4].astype(int), parts[5].astype(int))
    density, airspeed, wanted, command = (float(value) for value in read[:4])
    turns = max(abs(speed) / (2.0 * math.pi), STANDSTILL)
    ratio, last = airspeed / (turns * diameter), float(chart.advance_ratio[-1])
    past = max(ratio / last, 1.0) if beyond else 1.0
    blade = look_up(chart, ratio / past, state.pitch)
    torque = blade.power * past**2 * density * turns**2 * diameter**5 / (2.0 * math.pi)
    governor = governor._replace(reference=governor.reference + command)
    return torque if speed < 0.0 else -torque, float(blade.status), governor_rates(governor, state, wanted - abs(speed))


def _machine(numbers: Floats, command: float, speed: float) -> tuple[float, float]:
    sense, reference, slope, highest, power = (float(value) for value in numbers)
    wanted = command * (1.0 + slope * (1.0 - sense * speed / reference))
    limit = min(highest, power / abs(speed) if speed else math.inf)
    return sense * min(max(wanted, -limit), limit), float(abs(wanted) > limit)


def _clutch(numbers: Floats, capacity: float, slip: float, twist: float) -> tuple[float, float, float]:
    stiffness, damping, back = (float(value) for value in numbers)
    sticking = stiffness * twist + damping * slip
    torque = min(max(sticking, back * capacity), capacity)
    return torque, float(torque != sticking), slip if torque == sticking else (torque - stiffness * twist) / damping
