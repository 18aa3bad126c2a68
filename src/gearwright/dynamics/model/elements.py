"""Elements between bodies: connections with stiffness and backlash, meshes in space, and drives."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np

from gearwright.base import Floats, Kind, PartId
from gearwright.dynamics.model.system import NOBODY, Drives, Owner, Schedules
from gearwright.machines import Governor, GovernorState, PropellerMap, governor_rates, look_up
from gearwright.spec.design import PartErrors

# ----------------------------------------------------------------------------------------------------------------------
# What joins bodies, as a researcher writes it: a line with stiffness, damping, backlash, variation and errors.
# ----------------------------------------------------------------------------------------------------------------------


LineKind = Literal["mesh", "shaft", "support", "damper", "line"]


@dataclass(frozen=True)
class DampingRatio:
    """Damping as a share of the critical one: c = 2 ζ √(k m_eff) with 1/m_eff = d·M⁻¹d."""

    value: float
    """ζ [-]."""

    def damper(self, stiffness: float, mobility: float) -> float:
        """Return c [N s/m or N m s/rad].

        Args:
            stiffness: k [N/m or N m/rad].
            mobility: 1/m_eff = d·M⁻¹d [1/kg or 1/(kg m²)].
        """
        return 2.0 * self.value * math.sqrt(stiffness / mobility)


@dataclass(frozen=True)
class Periodic:
    """A quantity that repeats with an angle: constant + Σ_n a_n cos nψ + b_n sin nψ, ψ = φ + offset, n = 1, 2, …"""

    phase: Mapping[str, int] = field(default_factory=dict)
    """φ as integers of rotations: teeth for a mesh ({"sun": 28, "carrier": -28}), 1 for run-out."""
    cosine: Sequence[float] = ()
    """a_1, a_2, …: [-] relative to the mean stiffness, or [m or rad] for an error."""
    sine: Sequence[float] = ()
    """b_1, b_2, …, in the unit of a."""
    offset: float = 0.0
    """Angle added to φ [rad]: 2π times the relative mesh phase."""
    constant: float = 0.0
    """Part that does not change; only for errors."""

    def harmonics(self) -> tuple[Floats, Floats]:
        """Return cosine and sine coefficients in φ itself, with the offset worked in, shape (orders,) each."""
        orders = max(len(self.cosine), len(self.sine))
        a, b = np.zeros(orders), np.zeros(orders)
        a[: len(self.cosine)] = self.cosine
        b[: len(self.sine)] = self.sine
        angle = self.offset * np.arange(1, orders + 1)
        return a * np.cos(angle) + b * np.sin(angle), b * np.cos(angle) - a * np.sin(angle)

    def minimum(self) -> float:
        """Return the smallest value over a turn of φ, sampled at 64 points of the highest order."""
        a, b = self.harmonics()
        angle = np.outer(
            2.0 * np.pi * np.linspace(0.0, 1.0, 64 * max(len(a), 1), endpoint=False), np.arange(1, len(a) + 1)
        )
        return self.constant + float(np.min(np.cos(angle) @ a + np.sin(angle) @ b))


@dataclass(frozen=True)
class Line:
    """One spring and damper between coordinates: a mesh's line of action, a shaft's twist, a bearing's direction."""

    name: str
    """Unique name."""
    weights: Mapping[str, float]
    """d: deflection per coordinate, by coordinate name [m/rad for a mesh, - for a shaft or support]."""
    stiffness: float
    """Mean stiffness [N/m, or N m/rad if the deflection is an angle]; 0 for a damper, and for nothing else."""
    damping: float | DampingRatio = 0.0
    """c [N s/m or N m s/rad], or a share of the critical damping."""
    backlash: float = 0.0
    """Dead zone [m or rad]: 0 is linear; infinity never touches on its back. Force is zero for −backlash < δ < 0."""
    variation: Periodic | None = None
    """Stiffness over its mean, less 1, against the mesh phase."""
    errors: Sequence[Periodic] = ()
    """Errors that add up to e(φ) [m or rad]; a positive one opens the line."""
    kind: LineKind = "line"
    """What it stands for, for tables and figures."""
    owner: Owner = NOBODY
    """Whose it is."""
    turns_along: bool = False
    """Whether its other end turns with the rigid motion, as a heavy machine does: it holds what turns beside it."""


# ----------------------------------------------------------------------------------------------------------------------
# Contacts: meshes with a direction in space, so that gears may shift, run out or stand wrong.
#
# A contact is where a tooth of gear a presses on one of gear b along the unit vector n. With displacements u and
# rotations θ of the two,
#
#     δ = n·(u_a − u_b) + l_a θ_a + l_b θ_b − e,   e = −n·(ε_a − ε_b) − …
#
# an error ε that displaces a gear is a displacement like any other. Shafts lie along x, the pinion of a face gear
# across; every shaft has two axes across it, in the order in which a positive rotation meets them. The contacts of a
# planetary set are written in the frame of its carrier, whose y axis passes through the first planet.
# ----------------------------------------------------------------------------------------------------------------------


Vector = tuple[float, float, float]
Turns = Mapping[str, int]
"""An angle as integers of rotations."""
AXES = "xyz"
SMALL = 1e-12
"""Direction cosine below which a direction counts as square to an axis [-]."""


class Carried(NamedTuple):
    """A gear body in a contact, with the shaft (of a planet: the carrier's) that it sits on."""

    gear: str
    """Name of the body, and of its rotation."""
    shaft: str
    """Name of the shaft."""
    lever: float
    """l: weight of its rotation in the contact's line, base radius with sign [m]."""
    gear_turns: Turns
    """Angle of the gear in the contact's frame."""
    shaft_turns: Turns
    """Angle of the shaft in the contact's frame."""
    housing_turns: Turns
    """Angle of the housing in the contact's frame: nothing, but for planetary sets."""
    axis: str = "x"
    """Axis of the shaft: ``"x"``, ``"y"`` or ``"z"``."""
    place: complex | None = None
    """Of a planet: direction from the carrier's axis to its pin, y + i z; None for other gears."""

    @property
    def across(self) -> tuple[int, int]:
        """The two axes across its shaft, as numbers of x, y, z."""
        first = (AXES.index(self.axis) + 1) % 3
        return first, (first + 1) % 3


@dataclass(frozen=True)
class Contact:
    """Where a tooth of one gear presses on a tooth of another."""

    line: str
    """Name of the mesh's line."""
    direction: Vector
    """n: along the line of action, from gear a into gear b [-]."""
    sides: tuple[Carried, Carried]
    """Gears a and b."""


def push_direction(towards: complex, pressure_angle: float, *, sense: float) -> Vector:
    """Return the direction in which a gear's tooth presses on another's, both with axes along x.

    Args:
        towards: From the axis of the pressing gear to the pitch point, y + i z, of any length.
        pressure_angle: Working transverse pressure angle [rad].
        sense: 1 if it pushes on positively about its axis (y to z), −1 if negatively.

    Source: the line of action stands at the pressure angle to the common tangent, ISO 21771:2007, clause 5.2.

    Valid for: a pressing gear with external teeth.
    """
    out = towards / abs(towards)
    push = math.cos(pressure_angle) * sense * 1j * out + math.sin(pressure_angle) * out
    return (0.0, push.real, push.imag)


def face_push_direction(place: complex, pressure_angle: float, *, sense: float) -> Vector:
    """Return the direction in which a pinion presses on a face gear that turns about x.

    The pinion lies along y or z, so that its axis meets the face gear's. A face gear on the positive side of it lies
    at smaller x than the pinion, one on the negative side at larger x: then both turn against it, as two wheels
    do on a cylindrical pinion.

    Args:
        place: From the pinion to the face gear's axis, y + i z, of any length, along y or z.
        pressure_angle: Of the pinion [rad].
        sense: 1 if the pinion pushes on positively about its axis, −1 if negatively.

    Source: geometry of two crossing axes; Wang, Zhao, Tao, Jia & Guo, eqs 5 and 6, whose face gear 1 lies above.
    """
    out = place / abs(place)
    push = math.cos(pressure_angle) * sense * 1j * out
    return (math.copysign(math.sin(pressure_angle), -out.real - out.imag), push.real, push.imag)


def crossing_axis(place: complex) -> str | None:
    """Return the axis along which a face gear's pinion lies, ``"y"`` or ``"z"``; None if along neither.

    Args:
        place: From the pinion to the face gear's axis, y + i z.
    """
    unit = place / abs(place)
    if abs(unit.imag) < SMALL**0.5:
        return "y"
    return "z" if abs(unit.real) < SMALL**0.5 else None


def shift_weights(contact: Contact) -> dict[str, float]:
    """Return the weights of the shafts' displacements in a contact's line: ``"input.y"`` -> direction cosine [-].

    Args:
        contact: The mesh.
    """
    weights: dict[str, float] = {}
    for side, sign in zip(contact.sides, (1.0, -1.0), strict=True):
        for axis, cosine in zip(AXES, contact.direction, strict=True):
            if abs(cosine) > SMALL:
                name = f"{side.shaft}.{axis}"
                weights[name] = weights.get(name, 0.0) + sign * cosine
    return weights


def contact_errors(contact: Contact, parts: Mapping[str, PartErrors]) -> list[Periodic]:
    """Return the errors of a contact's line: what its two gears and their shafts bring along.

    Args:
        contact: The mesh.
        parts: Gear body or shaft -> its errors.

    Source: equivalent mesh errors, e = −J ε; Wang, Zhao, Tao, Jia & Guo, eqs 1 to 4, with the projections that follow
        from the directions of the lines of action instead of the printed phases.
    """
    errors: list[Periodic] = []
    for side, sign in zip(contact.sides, (1.0, -1.0), strict=True):
        direction = [sign * cosine for cosine in contact.direction]
        if side.gear in parts:
            errors += _errors(parts[side.gear], side, side.gear_turns, direction)
        if side.shaft in parts and side.shaft != side.gear:
            errors += _errors(parts[side.shaft], side, side.shaft_turns, direction)
    return [error for error in errors if error.constant or any(error.cosine) or any(error.sine)]


def _errors(part: PartErrors, side: Carried, turns: Turns, direction: Sequence[float]) -> Iterator[Periodic]:
    """Yield what one gear or shaft adds, given the contact's direction on its side."""
    first, second = (direction[axis] for axis in side.across)
    still = part.axial * direction[AXES.index(side.axis)] + part.tooth_thickness + side.lever * part.clocking
    if side.place is not None:
        pin = side.place / abs(side.place) * complex(part.pin_radial, part.pin_tangential)
        still += first * pin.real + second * pin.imag
    yield Periodic(constant=-still)
    yield from _vector(part.radial, part.radial_angle, side.housing_turns, (first, second))
    yield from _vector(part.eccentricity, part.phase, turns, (first, second))


def _vector(length: float, angle: float, turns: Turns, across: tuple[float, float]) -> Iterator[Periodic]:
    """Yield the error of a displacement across the shaft whose direction turns, or stands."""
    first, second = across
    if turns:
        yield Periodic(turns, cosine=(-length * first,), sine=(-length * second,), offset=angle)
    else:
        yield Periodic(constant=-length * (first * math.cos(angle) + second * math.sin(angle)))


# ----------------------------------------------------------------------------------------------------------------------
# Drives: propellers, machines and slipping clutches as named records, as numbers, and in plain numpy.
#
# A drive hands torque to one rotation (a clutch to two) by a law of their speeds; what a law needs to know of the
# flight (density, airspeed, set speed, a command) it reads against time. `encoded` packs the records into one table
# for compiled code; `drive_effects` reads that table in plain Python and is the oracle that the compiled laws must
# agree with.
# ----------------------------------------------------------------------------------------------------------------------


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
        first, second = (drive.first, drive.second) if isinstance(drive, ClutchDrive) else (drive.body, None)
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
