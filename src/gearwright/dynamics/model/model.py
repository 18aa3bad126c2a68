"""Dynamic model of named bodies, connections and loads: its checks, reference speeds and flat arrays."""

from __future__ import annotations

import itertools
import math
from collections import Counter, deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import NamedTuple

import numpy as np

from gearwright.base import Bools, DesignError, Floats, Ints, Problem, near, refuse
from gearwright.dynamics.model.elements import (
    ClutchDrive,
    DampingRatio,
    Drive,
    Line,
    MachineDrive,
    Periodic,
    PropellerDrive,
    drive_columns,
    encoded,
    inputs_of,
    points_of,
)
from gearwright.dynamics.model.system import (
    LARGE,
    NOBODY,
    Arrays,
    Entries,
    Excitation,
    Films,
    Labels,
    Loads,
    Owner,
    Profile,
    Schedules,
    Series,
    System,
    Tone,
)

# ----------------------------------------------------------------------------------------------------------------------
# What a researcher wrote, as plain records, and everything that can be wrong with it.
# ----------------------------------------------------------------------------------------------------------------------


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
        *(*_bodies(model), *_load_problems(model), *_pairs(model), *_points("speed profile", model.profile)),
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
        for name, value in _positive(drive).items():
            if not value > 0.0:
                yield Problem(path, f"{name} is {value:g}; it must be positive")


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


def _load_problems(model: Written) -> Iterator[Problem]:
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


# ----------------------------------------------------------------------------------------------------------------------
# Reference speeds: those that are not given follow from lines that may not stretch steadily, one after the other.
# ----------------------------------------------------------------------------------------------------------------------


SPEED_TOLERANCE = 1e-6
"""Largest stretch rate of a line at the reference speeds over the sum of its parts [-]: room for rounded radii."""
ROUNDING = 1e-12
"""Rate of a line over the fastest part of any that is rounding [-]."""


class Rows(NamedTuple):
    """Weights of lines, of unit length, one after the other."""

    line: Ints
    """Line of each weight."""
    dof: Ints
    """Coordinate of each weight."""
    weight: Floats
    lines: int
    """How many."""

    def rates(self, speed: Floats) -> Floats:
        """Return the steady stretch of each line, shape (lines,)."""
        return np.asarray(np.bincount(self.line, self.weight * speed[self.dof], self.lines), float)


def reference_speeds(lines: Sequence[Line], index: Mapping[str, int], given: Sequence[float | None]) -> Floats:
    """Return the speed of each coordinate; those that nothing determines are the least that fit.

    Args:
        lines: That may not stretch steadily.
        index: Coordinate -> its number.
        given: Speeds, None where they follow.

    Raises:
        DesignError: With every line that would stretch.
    """
    rows, stated = _rows(lines, index), np.array([value is not None for value in given], dtype=bool)
    speed = np.array([value or 0.0 for value in given])
    known = _spread(rows, speed, stated) if rows.lines > LARGE else stated
    left = np.flatnonzero(~known)
    used = np.unique(rows.line[~known[rows.dof]])
    if len(left) and len(used):
        matrix, rate = np.zeros((len(used), len(left))), rows.rates(np.where(known, speed, 0.0))[used]
        open_ = ~known[rows.dof]
        place = np.searchsorted(used, rows.line[open_]), np.searchsorted(left, rows.dof[open_])
        np.add.at(matrix, place, rows.weight[open_])
        speed[left] = np.linalg.lstsq(matrix, -rate, rcond=1e-10)[0]
    if stretching := _stretching(lines, rows, speed):
        raise DesignError(stretching)
    return speed


def _rows(lines: Sequence[Line], index: Mapping[str, int]) -> Rows:
    entries = [(row, index[name], weight) for row, line in enumerate(lines) for name, weight in line.weights.items()]
    line, dof = (np.array([entry[part] for entry in entries], dtype=np.int64) for part in (0, 1))
    weight = np.array([entry[2] for entry in entries], dtype=float)
    length = np.sqrt(np.bincount(line, weight**2, len(lines)))
    return Rows(line, dof, weight / length[line], len(lines))


def _spread(rows: Rows, speed: Floats, stated: Bools) -> Bools:
    """Fill speeds that a line with a single unknown one determines, and return which are known then.

    Speeds that are given may contradict each other; what follows is then told by the lines that stretch.
    """
    known, starts = stated.copy(), np.searchsorted(rows.line, np.arange(rows.lines + 1)).tolist()
    unknown = np.bincount(rows.line, ~known[rows.dof], rows.lines).astype(int).tolist()
    by_dof: list[list[int]] = [[] for _ in speed]
    for line, dof in zip(rows.line.tolist(), rows.dof.tolist(), strict=True):
        by_dof[dof].append(line)
    queue = deque(line for line, count in enumerate(unknown) if count == 1)
    while queue:
        line = queue.popleft()
        part = slice(starts[line], starts[line + 1])
        (open_,) = np.flatnonzero(~known[rows.dof[part]])[:1] if unknown[line] == 1 else (-1,)
        if open_ < 0 or abs(rows.weight[part][open_]) < SPEED_TOLERANCE:
            continue
        dof, others = int(rows.dof[part][open_]), known[rows.dof[part]]
        rest = float(rows.weight[part][others] @ speed[rows.dof[part][others]])
        speed[dof], known[dof] = -rest / float(rows.weight[part][open_]), True
        for other in by_dof[dof]:
            unknown[other] -= 1
            if unknown[other] == 1:
                queue.append(other)
    return known


def _stretching(lines: Sequence[Line], rows: Rows, speed: Floats) -> list[Problem]:
    rate = rows.rates(speed)
    size = rows._replace(weight=np.abs(rows.weight)).rates(np.abs(speed))
    allowed = SPEED_TOLERANCE * size + ROUNDING * np.max(size, initial=0.0)
    wrong = np.flatnonzero(np.abs(rate) > allowed).tolist()
    return [
        Problem(
            f"lines.{lines[row].name}",
            f"it would stretch steadily at the given speeds (by {abs(rate[row]) / size[row]:.1e} of its parts); "
            "speeds and weights (base radii, signs) must fit together",
        )
        for row in wrong
    ]


# ----------------------------------------------------------------------------------------------------------------------
# Names become indices: a written model as the flat arrays of a System.
# ----------------------------------------------------------------------------------------------------------------------


def flatten(model: Written) -> System:
    """Return the system of a written model.

    Args:
        model: Bodies, lines, loads by name.

    Raises:
        DesignError: With every problem found.
    """
    refuse(problems(model))
    index = {body.name: number for number, body in enumerate(model.bodies)}
    mass = np.array([body.mass for body in model.bodies])
    start, dof, weight = _weights(model.lines, index)
    speed = _speeds(model, index)
    tones = _Tones(index, speed)
    arrays = Arrays(
        mass=mass,
        speed=speed,
        line_start=start,
        line_dof=dof,
        line_weight=weight,
        stiffness=np.array([line.stiffness for line in model.lines]),
        damping=np.array([_damping(line, mass, index) for line in model.lines]),
        slip=_slip(model.lines, index, speed),
        backlash=np.array([line.backlash for line in model.lines], dtype=float),
        variation=_series([[line.variation] if line.variation else [] for line in model.lines], tones),
        error=_series([line.errors for line in model.lines], tones),
        tone_rate=np.array(tones.rates, dtype=float),
        gyroscopic=_gyroscopic(model.pairs, mass, index),
        centripetal=_centripetal(model.pairs, mass, index),
        loads=_flat_loads(model.loads, index),
        profile=profile_of(model.profile),
        drives=encoded(model.drives, index, speed),
        following=Films(_following(model, index, "stiffness"), _following(model, index, "damping")),
    )
    return System(arrays, _labels(model, tones))


def _weights(lines: Sequence[Line], index: Mapping[str, int]) -> tuple[Ints, Ints, Floats]:
    entries = [(index[name], weight) for line in lines for name, weight in line.weights.items()]
    start = np.cumsum([0, *(len(line.weights) for line in lines)])
    return start.astype(np.int64), _ints([dof for dof, _ in entries]), np.array([w for _, w in entries], dtype=float)


def _ints(values: Sequence[int]) -> Ints:
    return np.array(values, dtype=np.int64)


def _damping(line: Line, mass: Floats, index: Mapping[str, int]) -> float:
    if not isinstance(line.damping, DampingRatio):
        return float(line.damping)
    mobility = sum(weight**2 / mass[index[name]] for name, weight in line.weights.items())
    return line.damping.damper(line.stiffness, float(mobility))


def _slip(lines: Sequence[Line], index: Mapping[str, int], speed: Floats) -> Floats:
    """Return the steady rate of the deflection of dampers; what has a stiffness has none."""
    weights = [line.weights.items() if line.kind == "damper" else () for line in lines]
    return np.array([sum(weight * speed[index[name]] for name, weight in row) for row in weights], dtype=float)


def _speeds(model: Written, index: Mapping[str, int]) -> Floats:
    """Solve for the speeds that are not given: no line with a stiffness may stretch steadily."""
    lines = [line for line in model.lines if line.kind != "damper" and not line.turns_along]
    return reference_speeds(lines, index, [body.speed for body in model.bodies])


@dataclass
class _Tones:
    """Tones met so far, each once."""

    index: Mapping[str, int]
    speed: Floats
    numbers: dict[Tone, int] = field(default_factory=dict)
    rates: list[float] = field(default_factory=list)

    def number(self, phase: Mapping[str, int], order: int) -> int:
        """Return the number of a tone, new or met before."""
        counts = [(name, int(count) * order) for name, count in sorted(phase.items()) if count and order]
        tone = Tone(tuple(counts))
        if tone not in self.numbers:
            self.numbers[tone] = len(self.numbers)
            self.rates.append(sum(count * float(self.speed[self.index[name]]) for name, count in counts))
        return self.numbers[tone]


def _series(sums: Sequence[Sequence[Periodic]], tones: _Tones) -> Series:
    start, terms = [0], list[tuple[int, float, float]]()
    for periodics in sums:
        for periodic in periodics:
            terms += _terms(periodic, tones)
        start.append(len(terms))
    coefficients = np.array([term[1:] for term in terms], dtype=float).reshape(-1, 2).T.copy()
    return Series(_ints(start), _ints([term[0] for term in terms]), coefficients[0], coefficients[1])


def _terms(periodic: Periodic, tones: _Tones) -> list[tuple[int, float, float]]:
    terms = [(tones.number({}, 0), periodic.constant, 0.0)] if periodic.constant else []
    for order, (a, b) in enumerate(zip(*periodic.harmonics(), strict=True), start=1):
        if a or b:
            terms.append((tones.number(periodic.phase, order), float(a), float(b)))
    return terms


def _gyroscopic(pairs: Sequence[Pair], mass: Floats, index: Mapping[str, int]) -> Entries:
    row, column, value = list[int](), list[int](), list[float]()
    for pair in pairs:
        x, y = index[pair.first], index[pair.second]
        moment = -2.0 * float(mass[x]) * pair.frame_speed if pair.moment is None else pair.moment
        row += [x, y]
        column += [y, x]
        value += [moment, -moment]
    return Entries(_ints(row), _ints(column), np.array(value, dtype=float))


def _following(model: Written, index: Mapping[str, int], what: str) -> Entries:
    sums = dict[tuple[int, int], float]()
    for film in model.following:
        for (one, x), (other, y) in product(film.x.items(), film.y.items()):
            row, column, value = index[one], index[other], getattr(film, what) * x * y
            sums[row, column] = sums.get((row, column), 0.0) + value
            sums[column, row] = sums.get((column, row), 0.0) - value
    places = sorted(place for place, value in sums.items() if value)
    values = np.array([sums[place] for place in places], dtype=float)
    return Entries(_ints([row for row, _ in places]), _ints([column for _, column in places]), values)


def _centripetal(pairs: Sequence[Pair], mass: Floats, index: Mapping[str, int]) -> Entries:
    framed = [(index[name], pair.frame_speed) for pair in pairs if pair.moment is None for name in pair[:2]]
    dof = _ints([number for number, _ in framed])
    return Entries(dof, dof, np.array([mass[number] * speed**2 for number, speed in framed], dtype=float))


def _flat_loads(loads: Sequence[Load], index: Mapping[str, int]) -> Loads:
    sums = np.zeros((3, len(index)))
    for load in loads:
        sums[:, index[load.body]] += load[1:4]
    scheduled = [load for load in loads if load.schedule]
    points = [point for load in scheduled for point in load.schedule]
    schedules = Schedules(
        dof=_ints([index[load.body] for load in scheduled]),
        start=np.cumsum([0, *(len(load.schedule) for load in scheduled)]).astype(np.int64),
        time=np.array([time for time, _ in points], dtype=float),
        value=np.array([value for _, value in points], dtype=float),
    )
    return Loads(sums[0].copy(), sums[1].copy(), sums[2].copy(), schedules)


def profile_of(points: Sequence[tuple[float, float]]) -> Profile:
    """Return a speed profile.

    Args:
        points: (time [s], speed factor [-]).
    """
    time = np.array([time for time, _ in points], dtype=float)
    factor = np.array([factor for _, factor in points], dtype=float)
    # The factor is held before the first point, so travel there is the first factor times its time.
    pieces = 0.5 * (factor[1:] + factor[:-1]) * np.diff(time)
    return Profile(time, factor, time[0] * factor[0] + np.concatenate([[0.0], np.cumsum(pieces)]))


def _labels(model: Written, tones: _Tones) -> Labels:
    units = {body.name: body.unit for body in model.bodies}

    def unit(line: Line) -> str:
        # A shaft joins rotations with pure numbers; anything else measures along a direction.
        angular = line.kind in ("shaft", "support", "damper") and all(units[name] == "rad" for name in line.weights)
        return "rad" if angular else "m"

    recorded = drive_columns(model.drives)
    return Labels(
        coordinates=tuple(units),
        coordinate_units=tuple(units.values()),
        lines=tuple(line.name for line in model.lines),
        line_units=tuple(unit(line) for line in model.lines),
        line_kinds=tuple(line.kind for line in model.lines),
        tones=tuple(tones.numbers),
        drives=tuple(column.name for column in recorded),
        drive_units=tuple(column.unit for column in recorded),
        coordinate_owners=tuple(body.owner for body in model.bodies),
        line_owners=tuple(line.owner for line in model.lines),
        drive_owners=tuple(column.owner for column in recorded),
        orders=tuple(_excitation(order, tones) for order in model.orders),
    )


def _excitation(order: Order, tones: _Tones) -> Excitation:
    rate = sum(times * float(tones.speed[tones.index[name]]) for name, times in order.turns.items())
    return Excitation(order.name, tuple(order.turns.items()), tuple(order.on), order.why, abs(rate), order.owner)


# ----------------------------------------------------------------------------------------------------------------------
# Model: bodies, lines and loads by name; `build` checks them all and gives the flat `System`.
#
# >>> model = Model()
# >>> motor, wheel = model.rotation("motor", inertia=211.4), model.rotation("wheel", inertia=8.3)
# >>> model.shaft("shaft", motor, wheel, stiffness=9.775e6)
# >>> print(model.build())
# System: 2 coordinates, 1 lines, 0 tones
# ----------------------------------------------------------------------------------------------------------------------


@dataclass
class Model:
    """A drive train while it is being written down. Problems are reported by `build`, all at once."""

    bodies: list[Body] = field(default_factory=list)
    """Coordinates in the order in which they were added."""
    lines: list[Line] = field(default_factory=list)
    """Lines in the order in which they were added."""
    loads: list[Load] = field(default_factory=list)
    """Loads; several on one coordinate add up."""
    pairs: list[Pair] = field(default_factory=list)
    """Gyroscopic and centripetal terms."""
    profile: Sequence[tuple[float, float]] = ((0.0, 1.0),)
    """Speed factor: (time [s], factor [-])."""
    drives: list[Drive] = field(default_factory=list)
    """Propellers, machines and slipping clutches."""
    orders: list[Order] = field(default_factory=list)
    """Excitations that no line makes."""
    follows: list[Following] = field(default_factory=list)
    """Unsymmetric terms of bearings."""

    def rotation(self, name: str, *, inertia: float, speed: float | None = None, owner: Owner = NOBODY) -> str:
        """Add a rotation θ and return its name.

        Args:
            name: Unique name.
            inertia: Polar mass moment of inertia [kg m²].
            speed: Reference speed [rad/s]; left out, it follows from the lines and the speeds that are given.
            owner: Whose it is.
        """
        self.bodies.append(Body(name, inertia, "rad", speed, owner))
        return name

    def translation(self, name: str, *, mass: float, owner: Owner = NOBODY) -> str:
        """Add a translation and return its name.

        Args:
            name: Unique name, such as ``"sun.x"``.
            mass: Mass that moves [kg].
            owner: Whose it is, and the direction.
        """
        self.bodies.append(Body(name, mass, "m", 0.0, owner))
        return name

    def add(self, line: Line) -> None:
        """Add any line.

        Args:
            line: Weights, stiffness and the rest.
        """
        self.lines.append(line)

    def mesh(
        self,
        name: str,
        weights: Mapping[str, float],
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        backlash: float = 0.0,
        variation: Periodic | None = None,
        errors: Sequence[Periodic] = (),
        owner: Owner = NOBODY,
    ) -> None:
        """Add a gear mesh: one line along its line of action.

        Args:
            name: Unique name.
            weights: Coordinate -> signed base radius [m/rad], or direction cosine of a translation [-].
            stiffness: Mean mesh stiffness [N/m].
            damping: c [N s/m] or a `DampingRatio`.
            backlash: Along the line of action [m]; 0 keeps the teeth in contact both ways.
            variation: Stiffness over its mean, less 1, in the mesh phase.
            errors: Errors along the line of action [m].
            owner: Whose it is.
        """
        self.lines.append(Line(name, weights, stiffness, damping, backlash, variation, tuple(errors), "mesh", owner))

    def shaft(
        self,
        name: str,
        first: str,
        second: str,
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        owner: Owner = NOBODY,
    ) -> None:
        """Add a torsional shaft, spline or key: its torque is positive if `first` leads.

        Args:
            name: Unique name.
            first: Rotation at one end.
            second: Rotation at the other.
            stiffness: Torsional stiffness [N m/rad].
            damping: c [N m s/rad] or a `DampingRatio`.
            owner: Shaft, machine or clutch.
        """
        self.lines.append(Line(name, _between(first, second), stiffness, damping, kind="shaft", owner=owner))

    def damper(self, name: str, first: str, second: str, *, damping: float, owner: Owner = NOBODY) -> None:
        """Add a viscous damper: its torque is c times the speed at which `first` leads, steady slip with it.

        It holds nothing at rest, so that its bodies may turn at different reference speeds.

        Args:
            name: Unique name.
            first: Rotation at one end.
            second: Rotation at the other.
            damping: c [N m s/rad].
            owner: Damper.
        """
        self.lines.append(Line(name, _between(first, second), 0.0, damping, kind="damper", owner=owner))

    def support(
        self,
        name: str,
        body: str,
        *,
        stiffness: float,
        damping: float | DampingRatio = 0.0,
        owner: Owner = NOBODY,
    ) -> None:
        """Hold a coordinate to the housing: a bearing's direction or a torsional anchor.

        Args:
            name: Unique name.
            body: Coordinate that is held.
            stiffness: [N/m or N m/rad].
            damping: c [N s/m or N m s/rad] or a `DampingRatio`.
            owner: Whose it is, and the direction.
        """
        self.lines.append(Line(name, {body: 1.0}, stiffness, damping, kind="support", owner=owner))

    def load(
        self,
        body: str,
        *,
        constant: float = 0.0,
        damping: float = 0.0,
        quadratic: float = 0.0,
        schedule: Sequence[tuple[float, float]] = (),
    ) -> None:
        """Load a coordinate with constant + schedule − damping q̇ − quadratic |θ̇| θ̇.

        Args:
            body: Coordinate that is loaded.
            constant: [N or N m], positive along the coordinate.
            damping: Loss per speed above the reference [N s/m or N m s/rad].
            quadratic: Resistance over speed squared [N m s²/rad²].
            schedule: (time [s], load [N or N m]), joined by straight lines.
        """
        self.loads.append(Load(body, constant, damping, quadratic, tuple(schedule)))

    def drive(self, drive: Drive) -> None:
        """Add a propeller, a machine or a slipping clutch.

        Args:
            drive: A `PropellerDrive`, `MachineDrive` or `ClutchDrive`.
        """
        self.drives.append(drive)

    def order(
        self, name: str, turns: Mapping[str, float], *, on: Sequence[str] = (), why: str = "", owner: Owner = NOBODY
    ) -> None:
        """Add an excitation in proportion to speeds that no line makes: blades, poles, slots, planets that pass.

        It is a ray of the Campbell diagram; what it shakes decides which natural frequencies it excites.

        Args:
            name: Unique name, such as ``"propeller blade pass"``.
            turns: Rotation -> how often it acts in a turn of it [-]; several add up.
            on: Coordinates or lines that it shakes.
            why: Where the multiple is from, such as ``"6 blades"``.
            owner: Whose it is.
        """
        self.orders.append(Order(name, turns, on, why, owner))

    def following(self, x: Mapping[str, float], y: Mapping[str, float], *, stiffness: float, damping: float) -> None:
        """Add what a turning film does to a journal: F_x = −k y − c ẏ, F_y = +k x + c ẋ.

        It is in `campbell` and `frequency_response`; runs and statics, which need a potential, refuse it.

        Args:
            x: Motion along x, by coordinates.
            y: Motion along y.
            stiffness: k = ½ (k_xy − k_yx) [N/m].
            damping: c = ½ (c_xy − c_yx) [N s/m].
        """
        self.follows.append(Following(x, y, stiffness, damping))

    def rotating_frame(self, x: str, y: str, *, speed: float) -> None:
        """Write two translations of one mass in a frame that turns: Coriolis and centripetal terms.

        Args:
            x: First translation.
            y: Second, a quarter turn ahead.
            speed: Of the frame at the reference speeds [rad/s].

        Source: Lin, Parker 1999, J. Vib. Acoust. 121, eq. 3: G = [[0, −2m], [2m, 0]], K_Ω = diag(m, m).
        """
        self.pairs.append(Pair(x, y, speed, None))

    def gyroscopic(self, first: str, second: str, *, moment: float) -> None:
        """Couple two coordinates gyroscopically: the first feels −moment·q̇ of the second, the second +moment·q̇.

        Args:
            first: Coordinate with the term +moment q̇_second on the left of its equation.
            second: Coordinate with the term −moment q̇_first.
            moment: J_p Ω of a rotor that tilts, at the reference speeds [N m s/rad].
        """
        self.pairs.append(Pair(first, second, 0.0, moment))

    def build(self) -> System:
        """Check everything and return the flat system.

        Raises:
            DesignError: With every problem: names, inertias, stiffness, phases, speeds that do not fit together.
        """
        return flatten(
            Written(
                self.bodies,
                self.lines,
                self.loads,
                self.pairs,
                self.profile,
                self.drives,
                self.orders,
                self.follows,
            )
        )


def _between(first: str, second: str) -> dict[str, float]:
    """Return the weights of what joins two rotations; none where they are the same one, which `build` refuses."""
    return {first: 1.0, second: -1.0} if first != second else {first: 0.0}
