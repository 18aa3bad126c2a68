"""What a researcher wrote, as plain records, and everything that can be wrong with it."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from gearwright.dynamics.model.drives import ClutchDrive, Drive, MachineDrive, PropellerDrive, inputs_of, points_of
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.system import NOBODY, Owner
from gearwright.errors import Problem, near


class Body(NamedTuple):
    """One coordinate."""

    name: str
    """Unique name."""
    mass: float
    """Mass or inertia [kg or kg m²]."""
    unit: str
    """``"rad"`` or ``"m"``."""
    speed: float | None
    """Reference speed [rad/s or m/s]; None: from the lines."""
    owner: Owner = NOBODY
    """Whose it is."""


class Load(NamedTuple):
    """Load on one coordinate."""

    body: str
    """Coordinate."""
    constant: float
    """[N or N m]."""
    damping: float
    """[N s/m or N m s/rad]."""
    quadratic: float
    """[N m s²/rad²]."""
    schedule: Sequence[tuple[float, float]]
    """(time [s], load [N or N m])."""


class Pair(NamedTuple):
    """Two coordinates that a rotating frame or a spinning rotor couples."""

    first: str
    """Coordinate."""
    second: str
    """Coordinate."""
    frame_speed: float
    """Speed of the frame [rad/s]."""
    moment: float | None
    """Gyroscopic moment [N m s/rad]; None: from mass and frame speed."""


class Order(NamedTuple):
    """An excitation in proportion to speeds."""

    name: str
    """What it is called."""
    turns: Mapping[str, float]
    """Rotation -> how often it acts in a turn of it."""
    on: Sequence[str]
    """Coordinates or lines that it shakes."""
    why: str
    """Where the multiple is from."""
    owner: Owner = NOBODY
    """Whose it is."""


class Following(NamedTuple):
    """What a turning film does to a journal: force along x from a motion along y, and back with the other sign."""

    x: Mapping[str, float]
    """Motion along x."""
    y: Mapping[str, float]
    """Motion along y."""
    stiffness: float
    """½ (k_xy − k_yx) [N/m]."""
    damping: float
    """½ (c_xy − c_yx) [N s/m]."""


class Written(NamedTuple):
    """A whole model."""

    bodies: Sequence[Body]
    """Coordinates."""
    lines: Sequence[Line]
    """Lines."""
    loads: Sequence[Load]
    """Loads."""
    pairs: Sequence[Pair]
    """Gyroscopic and centripetal terms."""
    profile: Sequence[tuple[float, float]]
    """(time [s], speed factor [-])."""
    drives: Sequence[Drive] = ()
    """Propellers, machines, slipping clutches."""
    orders: Sequence[Order] = ()
    """Excitations that no line makes."""
    following: Sequence[Following] = ()
    """Unsymmetric terms of bearings."""


def problems(model: Written) -> list[Problem]:
    """Return everything that is wrong, in the order in which it was written.

    Args:
        model: What was written.
    """
    units = {body.name: body.unit for body in model.bodies}
    return [
        *(*_bodies(model), *_loads(model), *_pairs(model), *_points("speed profile", model.profile)),
        *(problem for line in model.lines for problem in _line(line, units)),
        *_duplicates("lines", [line.name for line in model.lines]),
        *_drives(model, units),
        *_duplicates("drives", [drive.name for drive in model.drives]),
        *_orders(model, units),
        *_duplicates("orders", [order.name for order in model.orders]),
    ]


def _drives(model: Written, units: dict[str, str]) -> Iterator[Problem]:
    rotations = [name for name, unit in units.items() if unit == "rad"]
    for drive in model.drives:
        path = f"drives.{drive.name}"
        for name in (drive.first, drive.second) if isinstance(drive, ClutchDrive) else (drive.body,):
            if name not in rotations:
                yield Problem(path, f"no such rotation: {name}; {near(name, rotations)}")
        for curve in inputs_of(drive):
            yield from _points(path, points_of(curve))
        for field, value in _positive(drive).items():
            if not value > 0.0:
                yield Problem(path, f"{field} is {value:g}; it must be positive")


def _orders(model: Written, units: Mapping[str, str]) -> Iterator[Problem]:
    rotations = [name for name, unit in units.items() if unit == "rad"]
    parts = [*units, *(line.name for line in model.lines)]
    for order in model.orders:
        path = f"orders.{order.name}"
        for name in order.turns:
            if name not in rotations:
                yield Problem(path, f"no such rotation: {name}; {near(name, rotations)}")
        if not any(order.turns.values()) or not all(math.isfinite(times) for times in order.turns.values()):
            message = f"turns are {dict(order.turns)}; say how often it acts in a turn, such as 6 for six blades"
            yield Problem(path, message)
        for name in order.on:
            if name not in parts:
                yield Problem(path, f"it shakes {name}, which is no coordinate and no line; {near(name, parts)}")


def _positive(drive: Drive) -> dict[str, float]:
    """Return the numbers of a drive that must be positive, by name."""
    match drive:
        case PropellerDrive():
            return {"diameter": drive.diameter, "governor.time_constant": drive.governor.time_constant}
        case MachineDrive():
            return {"speed": drive.speed, "highest_torque": drive.highest_torque, "highest_power": drive.highest_power}
        case ClutchDrive():
            return {"stiffness": drive.stiffness, "damping": drive.damping}


def _bodies(model: Written) -> Iterator[Problem]:
    if not model.bodies:
        yield Problem("bodies", "there is none; add rotations or translations")
    if not model.lines:
        yield Problem("lines", "there is none; join the bodies with meshes, shafts or supports")
    yield from _duplicates("bodies", [body.name for body in model.bodies])
    for body in model.bodies:
        if not 0.0 < body.mass < math.inf:
            what = "inertia" if body.unit == "rad" else "mass"
            yield Problem(f"bodies.{body.name}", f"{what} is {body.mass:g}; it must be positive and finite")
        if body.speed is not None and not math.isfinite(body.speed):
            yield Problem(f"bodies.{body.name}", f"speed is {body.speed:g}; it must be finite")


def _duplicates(group: str, names: Sequence[str]) -> Iterator[Problem]:
    for name, count in sorted(Counter(names).items()):
        if count > 1:
            yield Problem(f"{group}.{name}", f"the name is used {count} times; names must differ")


def _loads(model: Written) -> Iterator[Problem]:
    names = [body.name for body in model.bodies]
    for load in model.loads:
        path = f"loads.{load.body}"
        if load.body not in names:
            yield Problem(path, f"no such body; {near(load.body, names)}")
        for what, value in zip(("constant", "damping", "quadratic"), load[1:4], strict=True):
            if not math.isfinite(value):
                yield Problem(path, f"{what} is {value:g}; it must be finite")
        if load.schedule:
            yield from _points(path, load.schedule)


def _pairs(model: Written) -> Iterator[Problem]:
    masses = {body.name: body.mass for body in model.bodies}
    for pair in model.pairs:
        path = f"gyroscopic.{pair.first}-{pair.second}"
        unknown = [name for name in pair[:2] if name not in masses]
        yield from (Problem(path, f"no such body: {name}; {near(name, masses)}") for name in unknown)
        if not unknown and pair.moment is None and masses[pair.first] != masses[pair.second]:
            yield Problem(path, "the two translations of one body must have the same mass")


def _points(path: str, points: Sequence[tuple[float, float]]) -> Iterator[Problem]:
    times = [time for time, _ in points]
    if not times or not all(math.isfinite(number) for point in points for number in point):
        yield Problem(path, "needs at least one point (time, value), all finite")
    elif any(later <= earlier for earlier, later in itertools.pairwise(times)):
        yield Problem(path, f"times must rise from point to point; given {times}")


def _line(line: Line, units: dict[str, str]) -> Iterator[Problem]:
    path = f"lines.{line.name}"
    for name in line.weights:
        if name not in units:
            yield Problem(path, f"no such body: {name}; {near(name, units)}")
    if not any(line.weights.values()) or not all(math.isfinite(weight) for weight in line.weights.values()):
        yield Problem(path, f"weights are {dict(line.weights)}; give at least one, finite and not zero")
    if line.kind == "damper":
        yield from _damper(path, line)
    elif not 0.0 < line.stiffness < math.inf:
        yield Problem(path, f"stiffness is {line.stiffness:g}; it must be positive and finite")
    damping = line.damping.value if isinstance(line.damping, DampingRatio) else line.damping
    if not 0.0 <= damping < math.inf:
        yield Problem(path, f"damping is {damping:g}; it must be zero or positive and finite")
    if not line.backlash >= 0.0:
        yield Problem(path, f"backlash is {line.backlash:g}; it must be zero or positive")
    for series in (*([line.variation] if line.variation else []), *line.errors):
        yield from _phase(path, series, units)
    if line.variation is not None:
        yield from _variation(path, line.variation)


def _damper(path: str, line: Line) -> Iterator[Problem]:
    if line.stiffness or line.backlash or line.errors or line.variation is not None:
        yield Problem(path, "a damper has damping only; leave out stiffness, backlash, variation and errors")
    if not isinstance(line.damping, float | int) or line.damping == 0.0:
        yield Problem(path, "a damper needs its damping c, positive [N m s/rad]; there is no critical one to share")


def _variation(path: str, variation: Periodic) -> Iterator[Problem]:
    if variation.constant != 0.0:
        yield Problem(path, "a stiffness variation has no constant part; change the mean stiffness instead")
    elif (lowest := 1.0 + variation.minimum()) < 0.0:
        yield Problem(path, f"the stiffness curve goes negative, to {lowest:.3g} of its mean; it must stay positive")


def _phase(path: str, series: Periodic, units: dict[str, str]) -> Iterator[Problem]:
    for name, count in series.phase.items():
        if units.get(name) != "rad":
            rotations = [body for body, unit in units.items() if unit == "rad"]
            yield Problem(path, f"the phase names {name}, which is no rotation; {near(name, rotations)}")
        if not float(count).is_integer():
            yield Problem(path, f"the phase takes {count:g} times {name}; it must be a whole number (of teeth)")
    if (len(series.cosine) or len(series.sine)) and not series.phase:
        yield Problem(path, "harmonics need a phase, such as {'sun': 28}")
    values = (*series.cosine, *series.sine, series.offset, series.constant)
    if not all(math.isfinite(value) for value in values):
        yield Problem(path, "every coefficient of a periodic quantity must be finite")
