"""Names become indices: a written model as the flat arrays of a System."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.model.drives import drive_columns, encoded
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.reference_speeds import reference_speeds
from gearwright.dynamics.model.system import (
    Arrays,
    Entries,
    Excitation,
    Films,
    Labels,
    Loads,
    Profile,
    Schedules,
    Series,
    System,
    Tone,
)
from gearwright.dynamics.model.written import Load, Order, Pair, Written, problems
from gearwright.errors import refuse


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
        loads=_loads(model.loads, index),
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


def _loads(loads: Sequence[Load], index: Mapping[str, int]) -> Loads:
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
