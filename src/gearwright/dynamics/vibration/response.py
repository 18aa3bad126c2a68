"""Frequency response to transmission errors and loads, and forced response at operating speed."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import gcd, lcm
from typing import NamedTuple

import numpy as np

from gearwright.base import (
    Complexes,
    DesignError,
    Floats,
    Force,
    Frequency,
    Ints,
    Kind,
    PartId,
    Problem,
    Row,
    Shown,
    SolveError,
    by_name,
    largest_first,
    mesh_part,
    near,
    one_blas_thread,
    verb,
)
from gearwright.dynamics.assembly import assemble, compound_phases, gear_pairs
from gearwright.dynamics.equations import (
    WORKS,
    damped_rates,
    linear,
    split_rigid,
    state_matrix,
    statics,
    stiffness_at,
    unbalanced,
)
from gearwright.dynamics.model import (
    Arrays,
    Labels,
    System,
    entry_matrix,
    finite_numbers,
    line_matrix,
    refuse_not_finite,
)
from gearwright.dynamics.motion import (
    BLOCK,
    GIVEN,
    PARTING,
    SMOOTH,
    UNDAMPED,
    Accuracy,
    Error,
    Forces,
    Samples,
    blank_record,
    default_step,
    endless,
    ends_of,
    equilibrium,
    errors_of,
    index_of,
    shortfall,
    stepper,
)
from gearwright.parts.planetary import planet_phases
from gearwright.sizing import Sizing, governing_case, planet_positions

# ----------------------------------------------------------------------------------------------------------------------
# Sequences of numbers that callers give, speeds and frequencies, as one array.
# ----------------------------------------------------------------------------------------------------------------------


NUMBERS = "iuf"
"""Kinds of arrays that are numbers: no texts that read like one, no truth values."""
LONGEST = 60
"""Characters of what was given that a message repeats."""


def numbers(values: Sequence[float] | Floats, path: str) -> Floats:
    """Return numbers as an array, one at least, all finite.

    Args:
        values: A list, a tuple, an array.
        path: What they are called, for the message.

    Raises:
        DesignError: If they are anything else.
    """
    try:
        given = np.asarray(values)
        array = given.astype(np.float64) if given.dtype.kind in NUMBERS else np.zeros((0, 0))
    except (TypeError, ValueError):
        array = np.zeros((0, 0))
    if array.ndim != 1 or not len(array) or not np.all(np.isfinite(array)):
        raise _refused(values, path, "finite")
    return array


def positive_numbers(values: Sequence[float] | Floats, path: str) -> Floats:
    """Return numbers as an array, one at least, all positive and finite.

    Args:
        values: A list, a tuple, an array.
        path: What they are called, for the message.

    Raises:
        DesignError: If they are anything else.
    """
    array = numbers(values, path)
    if not np.all(array > 0.0):
        raise _refused(values, path, "positive")
    return array


def _refused(values: object, path: str, what: str) -> DesignError:
    shown = repr(values)
    shown = shown if len(shown) <= LONGEST else f"{shown[:LONGEST]} …"
    return DesignError([Problem(path, f"{shown}; give a sequence of {what} numbers, one at least, as [0.5, 1.0]")])


# ----------------------------------------------------------------------------------------------------------------------
# Frequency response: the steady vibration under harmonic errors or loads at mean stiffness.
# ----------------------------------------------------------------------------------------------------------------------


NOISE = 1e-9
"""Force over the largest one of a response below which it is the rounding of none [-]."""


@dataclass(frozen=True, eq=False, repr=False)
class Response(Shown):
    """Complex amplitudes against frequency: the real part times e^(iωt) is the motion."""

    frequency: Floats
    """[Hz], shape (frequencies,)."""
    position: Complexes
    """q [rad or m], shape (frequencies, coordinates)."""
    line_force: Complexes
    """Line forces [N or N m], shape (frequencies, lines)."""
    labels: Labels
    """Names."""

    def force(self, line: str) -> Complexes:
        """Return the force of a line [N or N m], shape (frequencies,).

        Args:
            line: Its name.
        """
        return self.line_force[:, index_of(line, self.labels.lines, "line")]

    def motion(self, coordinate: str) -> Complexes:
        """Return a coordinate's vibration [rad or m], shape (frequencies,).

        Args:
            coordinate: Its name.
        """
        return self.position[:, index_of(coordinate, self.labels.coordinates, "coordinate")]


@dataclass(frozen=True)
class Peak:
    """A maximum of a frequency response."""

    line: str
    frequency: Frequency
    """[Hz]"""
    force: Force
    """Amplitude [N]."""


@verb
@one_blas_thread()
def frequency_response(
    system: System,
    frequency: Sequence[float] | Floats,
    *,
    errors: Mapping[str, complex] | None = None,
    loads: Mapping[str, complex] | None = None,
) -> Response:
    """Return the steady response to errors on lines and loads on coordinates, all of one frequency at a time.

    Args:
        system: Taken at mean stiffness and reference speed, all lines in contact.
        frequency: Exciting frequencies [Hz], positive.
        errors: Line -> complex amplitude of its error [m or rad].
        loads: Coordinate -> complex amplitude of its load [N or N m].

    Raises:
        DesignError: For a frequency that is not positive, or names that do not exist.
        SolveError: If a number of the system or of its response is not finite; with the part.
    """
    rates = 2.0 * np.pi * positive_numbers(frequency, "frequency")
    arrays, labels = system.arrays, system.labels
    error = _amplitudes(errors or {}, labels.lines, "line")
    load = _amplitudes(loads or {}, labels.coordinates, "coordinate")
    with finite_numbers(system):
        position, force = _solved(arrays, rates, error, load)
    refuse_not_finite(position, labels.coordinates, "vibration")
    refuse_not_finite(force, labels.lines, "force")
    return Response(rates / (2.0 * np.pi), position, force, labels)


def _solved(arrays: Arrays, rates: Floats, error: Complexes, load: Complexes) -> tuple[Complexes, Complexes]:
    """Return coordinates and line forces, shapes (frequencies, …)."""
    matrix, model = line_matrix(arrays), linear(arrays)
    modes = damped_rates(arrays, 1.0)
    met = np.abs(1j * rates[:, None] - modes) < UNDAMPED * rates[:, None]
    if np.any(met):
        hertz = rates[np.argmax(np.any(met, axis=1))] / (2.0 * np.pi)
        raise SolveError(f"the mode at {hertz:.6g} Hz has no damping: vibration has no end there; give it damping")
    dynamic = arrays.stiffness + 1j * rates[:, None] * arrays.damping
    inertia = np.diag(model.mass)
    left = model.stiffness + 1j * rates[:, None, None] * model.damping - (rates**2)[:, None, None] * inertia
    right = load + (dynamic * error) @ matrix
    position = np.linalg.solve(left, right[:, :, None])[:, :, 0]
    force = dynamic * (position @ matrix.T - error)
    return position.astype(np.complex128), force.astype(np.complex128)


def _amplitudes(stated: Mapping[str, complex], names: tuple[str, ...], what: str) -> Complexes:
    values = np.zeros(len(names), dtype=np.complex128)
    for name, amplitude in stated.items():
        values[index_of(name, names, what)] = amplitude
    return values


def peaks(response: Response, lines: Sequence[str]) -> list[Peak]:
    """Return the maxima of the forces of some lines against frequency, the highest first.

    A line that what excites does not reach, as meshes behind a cancelled phase, has none: its force is rounding.

    Args:
        response: Of the train.
        lines: Whose forces count.
    """
    maxima, noise = [], NOISE * float(np.max(np.abs(response.line_force), initial=0.0))
    for line in lines:
        amplitude = np.abs(response.force(line))
        highest = (amplitude[1:-1] > amplitude[:-2]) & (amplitude[1:-1] >= amplitude[2:]) & (amplitude[1:-1] > noise)
        inner = np.flatnonzero(highest) + 1
        maxima += [Peak(line, float(response.frequency[i]), float(amplitude[i])) for i in inner]
    return largest_first(maxima, lambda peak: peak.force)


# ----------------------------------------------------------------------------------------------------------------------
# How a train answers to a transmission error: every mesh of a row errs alike, each in its own phase.
# ----------------------------------------------------------------------------------------------------------------------


POINTS = 2000
"""Frequencies of a response."""
RANGE = 1000.0
"""Highest over lowest frequency of a response [-]."""


@verb
@one_blas_thread()
def answer(
    sizing: Sizing, system: System, row: str, *, error: float = 1e-6, top: float = 1e4, case: str | None = None
) -> Response:
    """Return the forces that a harmonic transmission error of a mesh row causes, against its frequency.

    Args:
        sizing: What was sized.
        system: Assembled from it.
        row: Mesh row, such as ``first.sun-planet``; the planets err in their relative mesh phases.
        error: Amplitude along the line of action [m].
        top: Highest frequency [Hz].
        case: For which the system was assembled; left out: as `assemble` takes it.

    Raises:
        DesignError: If there is no such row or case.
    """
    flow = by_name(case or governing_case(sizing), sizing.flows, "case")
    meshes = {mesh.name: mesh for mesh in sizing.train.meshes}
    if row not in meshes:
        raise DesignError([Problem("mesh", f"there is no mesh {row!r}; {near(row, meshes)}")])
    mesh, lines = meshes[row], system.labels.lines_of(meshes[row].part)
    if mesh.row is Row.PAIR:
        errors: dict[str, complex] = dict.fromkeys(lines, error)
    elif mesh.stage in sizing.design.epicyclics:
        phases = compound_phases(sizing, flow, mesh.stage)[row]
        errors = {line: cmath.rect(error, 2.0 * cmath.pi * phase) for line, phase in zip(lines, phases, strict=True)}
    else:
        pairs, positions = gear_pairs(sizing), planet_positions(sizing.design, mesh.stage, sizing.teeth)
        inner, outer = (pairs[str(mesh_part(mesh.stage, kind))] for kind in (Row.SUN_PLANET, Row.PLANET_RING))
        both = planet_phases(inner, outer, positions)
        phases = both.sun if mesh.row is Row.SUN_PLANET else both.ring
        errors = {line: cmath.rect(error, 2.0 * cmath.pi * phase) for line, phase in zip(lines, phases, strict=True)}
    return frequency_response(system, np.geomspace(top / RANGE, top, POINTS), errors=errors)


def first_meshes(sizing: Sizing, system: System) -> list[str]:
    """Return the line of every mesh row, of a planetary set that of its first planet.

    Args:
        sizing: What was sized.
        system: Assembled from it.
    """
    return [system.labels.lines_of(mesh.part)[0] for mesh in sizing.train.meshes]


# ----------------------------------------------------------------------------------------------------------------------
# Forced response at operating speed: what varying stiffness and stated errors add to the mean force of every mesh.
# ----------------------------------------------------------------------------------------------------------------------


UNLOADED = 1e-3
"""Mean force of a mesh over the largest one below which it bears nothing that a factor could count [-]."""


@verb
@one_blas_thread()
def forced_factors(sizing: Sizing, case: str) -> dict[str, float]:
    """Return by how much the steady vibration of a load case raises the force of every mesh row that bears load [-].

    The amplitudes of all tones are added up, as if they met: with teeth that keep contact no instant is worse.

    Args:
        sizing: As sized.
        case: Load case.

    Source: linear response at mean stiffness to the first order of what varies: M ẍ + B ẋ + K x = -Dᵀ (k_n δ_0 - k e_n)
        at every tone; ISO 6336-1:2006, clause 6, method A asks for such an analysis of the whole system.
    """
    system = assemble(sizing, case)
    mean = np.abs(statics(system, balance="accelerate").force)
    swing = np.abs(_line_forces(system)).sum(axis=0)
    meshes = np.array([kind == "mesh" for kind in system.labels.line_kinds])
    least = UNLOADED * float(np.max(mean[meshes], initial=0.0))
    factors = {}
    for mesh in sizing.meshes:
        places = [place for place in system.labels.places_of(mesh.part) if mean[place] > least]
        if places:
            factors[mesh.name] = max(1.0 + float(swing[place] / mean[place]) for place in places)
    return factors


@one_blas_thread()
def row_swings(sizing: Sizing, case: str) -> dict[str, float]:
    """Return by how much the sum of the forces of every mesh row swings over its mean [-], of rows that bear load.

    What planets do one after the other cancels in what they do together: a ring, and with it the housing, feels less
    than a tooth. The amplitudes of all tones are added up, as if they met.

    Args:
        sizing: As sized.
        case: Load case.

    Source: as `forced_factors`: Σ_tones |Σ_planets F|/Σ_planets |F_mean|, with the phases of planets.
    """
    system = assemble(sizing, case)
    mean, forces = statics(system, balance="accelerate").force, _line_forces(system)
    meshes = np.array([kind == "mesh" for kind in system.labels.line_kinds])
    least = UNLOADED * float(np.max(np.abs(mean)[meshes], initial=0.0))
    found = {}
    for mesh in sizing.meshes:
        places = [place for place in system.labels.places_of(mesh.part) if abs(mean[place]) > least]
        if places:
            together = np.abs(forces[:, places] @ np.sign(mean[places])).sum()
            found[mesh.name] = float(together / np.abs(mean[places]).sum())
    return found


class SupportForce(NamedTuple):
    """What the bearings of one shaft give to the housing together, across the shaft."""

    mean: float
    """[N]"""
    swing: float
    """Amplitude, all tones added up as if they met [N]."""


@one_blas_thread()
def support_forces(sizing: Sizing, case: str) -> dict[str, SupportForce]:
    """Return shaft -> what its bearings give to the housing in a load case; of shafts that the design lets move.

    Args:
        sizing: As sized.
        case: Load case.

    Source: as `forced_factors`, of the lines of supports: f = k q + c q̇ of each direction.
    """
    if not sizing.design.supports:
        return {}
    system = assemble(sizing, case)
    mean, swing = statics(system, balance="accelerate").force, np.abs(_line_forces(system)).sum(axis=0)
    found = {}
    for shaft in sizing.design.supports:
        places = [
            place
            for place in system.labels.places_of(PartId(Kind.SHAFT, shaft))
            if system.labels.line_kinds[place] == "support" and system.labels.line_units[place] == "m"
        ]
        across = [place for place in places if system.labels.line_owners[place].what in ("y", "z")] or places
        found[shaft] = SupportForce(math.hypot(*mean[across]), math.hypot(*swing[across]))
    return found


def _line_forces(system: System) -> Complexes:
    """Return the complex amplitude of every line's force at every tone [N or N m], shape (tones, lines)."""
    arrays, matrix, model = system.arrays, line_matrix(system.arrays), linear(system.arrays)
    exciting = _exciting(system)
    rates = np.abs(arrays.tone_rate[: len(exciting)]) * float(arrays.profile.factor[0])
    loud = np.any(exciting != 0.0, axis=1) & (rates > 0.0)
    exciting, rates = exciting[loud], rates[loud]
    left = model.stiffness + 1j * rates[:, None, None] * model.damping
    left = left - (rates**2)[:, None, None] * np.diag(model.mass)
    moved = np.linalg.solve(left, -(exciting @ matrix)[:, :, None])[:, :, 0]
    dynamic = arrays.stiffness + 1j * rates[:, None] * arrays.damping
    return np.asarray(exciting + dynamic * (moved @ matrix.T))


def _exciting(system: System) -> Complexes:
    """Return what varying stiffness at the static deflection and errors put on each line, shape (tones, lines)."""
    arrays = system.arrays
    exciting = np.zeros((len(system.labels.tones), len(arrays.stiffness)), dtype=np.complex128)
    force = statics(system, balance="accelerate").force
    for series, scale in ((arrays.variation, force), (arrays.error, -arrays.stiffness)):
        for row, place in series_terms(series.start):
            tone = int(series.tone[place])
            sign = 1.0 if arrays.tone_rate[tone] >= 0.0 else -1.0
            exciting[tone, row] += scale[row] * complex(series.cosine[place], -sign * series.sine[place])
    return exciting


def series_terms(start: Ints) -> Iterator[tuple[int, int]]:
    """Yield the row and the place of every term of the series of all lines.

    Args:
        start: Of every row among the places, and the end, shape (rows + 1,).
    """
    for row in range(len(start) - 1):
        for place in range(int(start[row]), int(start[row + 1])):
            yield row, place


# ----------------------------------------------------------------------------------------------------------------------
# Variation: how motions beside a periodic one go, which decides whether it is stable.
#
# A disturbance obeys η̇ = A(t) η, A from the stiffness of the lines that touch at that instant of the orbit. Over two
# of its steps A is taken to its fourth order in time and solved by the exponential of a matrix, so that a constant A
# is exact and no step damps what the system does not.
# ----------------------------------------------------------------------------------------------------------------------


NODES = (slice(0, -1, 2), slice(1, None, 2), slice(2, None, 2))
"""First, middle and last instants of each two steps."""


def every_step(system: System, start: Floats, step: float, steps: int) -> Samples:
    """Return every instant of a motion from q and q̇ at time 0.

    Args:
        system: Bodies, lines, loads.
        start: q and q̇, shape (2 coordinates,).
        step: [s].
        steps: How many.
    """
    arrays = system.arrays
    size, lines = len(arrays.mass), len(arrays.stiffness)
    advance, record = stepper(arrays, "runge-kutta", step), blank_record(arrays, steps + 1)
    state = np.concatenate([start, np.zeros(WORKS)])
    for first in range(0, len(record), BLOCK):
        advance(first, record[first : first + BLOCK], state)
    ends = [size, 2 * size, 2 * size + lines, 2 * size + 2 * lines]
    position, velocity, force, deflection, _ = np.split(np.asarray(record), ends, axis=1)
    drive = np.zeros((steps + 1, 0))
    time = np.asarray(step * np.arange(steps + 1), dtype=np.float64)
    return Samples(time, position, velocity, force, deflection, system.labels, drive)


def monodromy(system: System, samples: Samples) -> Floats:
    """Return the derivative of a motion's end by its start, shape (2 coordinates, 2 coordinates).

    Args:
        system: At constant speed.
        samples: Every step of the motion, an even number of them.

    Source: Magnus series to fourth order with Simpson's nodes, Blanes, Casas, Oteo & Ros 2009, Phys. Rep. 470, 151,
        section 5.
    """
    from scipy import linalg  # statics, whose layer this is, do without it

    arrays = system.arrays
    stiffness, share = stiffness_at(system, samples.time), _touching(arrays, samples.line_deflection)
    first, middle, last = (_matrices(arrays, share * stiffness[nodes]) for nodes in NODES)
    step = 2.0 * float(samples.time[1] - samples.time[0])
    exponents = step / 6.0 * (first + 4.0 * middle + last) - step**2 / 12.0 * (first @ last - last @ first)
    total = np.eye(2 * len(arrays.mass))
    with one_blas_thread():
        for turn in linalg.expm(exponents):
            total = turn @ total
    return np.asarray(total)


def _touching(arrays: Arrays, deflection: Floats) -> Floats:
    """Return the share of each two steps in which lines touch, shape (steps / 2, lines).

    Between instants a deflection is taken as straight, so that flanks part and meet inside a step.
    """
    low, high = np.minimum(deflection[:-1], deflection[1:]), np.maximum(deflection[:-1], deflection[1:])
    gap = np.minimum(high, 0.0) - np.maximum(low, -arrays.backlash)
    length = high - low
    still = np.where(gap > 0.0, 1.0, 0.0)
    opened = np.divide(np.maximum(gap, 0.0), length, out=still, where=length > 0.0)
    touching = np.where(arrays.backlash > 0.0, 1.0 - opened, 1.0)
    return np.asarray(0.5 * (touching[::2] + touching[1::2]))


def _matrices(arrays: Arrays, stiffness: Floats) -> Floats:
    """Return A at many instants, shape (instants, 2 coordinates, 2 coordinates)."""
    factor, size = float(arrays.profile.factor[0]), len(arrays.mass)
    matrix = line_matrix(arrays)
    turned = factor**2 * entry_matrix(arrays.centripetal, size)
    found = np.repeat(state_matrix(linear(arrays, factor))[None], len(stiffness), axis=0)
    held = np.einsum("li,tl,lj->tij", matrix, stiffness, matrix, optimize=True) - turned
    found[:, size:, :size] = -held / arrays.mass[:, None]
    return np.asarray(found)


# ----------------------------------------------------------------------------------------------------------------------
# Steady state: the periodic motion by shooting, and its Floquet multipliers.
#
# One period is integrated from a start and from starts displaced along each state, eight at a time; Newton moves the
# start until the motion closes. The monodromy matrix, from the equations of what is next to the motion (`variation`),
# has eigenvalues that tell whether it is stable: all within the unit circle, but for those of rigid motions, left out.
# ----------------------------------------------------------------------------------------------------------------------


CLOSED = 1e-9
"""Gap between end and start of the period over the size of the motion, at which it counts as closed [-]."""
ROUNDS = 30
"""Newton rounds before giving up."""
STILL = 1e-6
"""Size of the states of what stands still, without load and error [m or rad]."""
NUDGE = 1e-6
"""Displacement of a start, over the size of its kind of state, for the derivative [-]."""
HALVED = 6
"""Times that the steps of a period are halved, whatever their number."""
QUICK = 30_000
"""Steps of a period up to which they are halved on, since they cost little: contact converges by second order."""
LOCKED = 1e-2
"""Angle by which an undamped mode may leave a tone in a period and still count as met by it [rad]."""
SETTLING = 64
"""Periods that a motion is left to itself where Newton's method does not find it from static equilibrium."""
MULTIPLIER_ROUNDING = 1e-10
"""What rounding leaves of the size of a multiplier [-]."""
LARGEST_DENOMINATOR = 10_000
"""Teeth: ratios of tones are fractions of whole numbers no larger."""


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Shown):
    """A periodic motion, measured from the rigid one."""

    period: float
    """[s]."""
    samples: Samples
    """Every step of one period."""
    multipliers: Complexes
    """Floquet multipliers, largest first, shape (2 coordinates,); those of rigid motions (1) are left out."""
    monodromy: Floats
    """Derivative of the end of a period by its start, shape (2 coordinates, 2 coordinates)."""
    error: float = 0.0
    """Measured error of the peaks of line forces over them [-]."""
    rms_error: float = 0.0
    """And of their root mean squares [-]."""
    multiplier_error: float = 0.0
    """How far the size of the largest multiplier may be off [-]."""
    notes: tuple[str, ...] = ()
    """What is less sure than was asked, and why."""

    @property
    def stable(self) -> bool:
        """Whether every disturbance dies out."""
        return bool(np.all(np.abs(self.multipliers) < 1.0))


def common_period(arrays: Arrays) -> float:
    """Return the time after which all tones repeat together [s].

    Args:
        arrays: The system's numbers, at constant speed.

    Raises:
        DesignError: If nothing turns, or the speed changes.
    """
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    rates = np.abs(arrays.tone_rate[used]) * float(arrays.profile.factor[0])
    rates = rates[rates > 0.0]
    if not len(rates) or np.any(arrays.profile.factor != arrays.profile.factor[0]):
        raise DesignError([Problem("period", "no tone turns at constant speed; a periodic motion needs one")])
    ratios = [Fraction(float(rate / rates[0])).limit_denominator(LARGEST_DENOMINATOR) for rate in rates]
    bottom = lcm(*(ratio.denominator for ratio in ratios))
    top = gcd(*(int(ratio * bottom) for ratio in ratios))
    return float(2.0 * np.pi / rates[0] * bottom / top)


@verb
@one_blas_thread()
def periodic(system: System, *, period: float | None = None, step: float | Accuracy | None = None) -> Orbit:
    """Return the periodic motion near static equilibrium.

    The period is cut finer until forces, and whether multipliers lie within the unit circle, are as sure as was asked.

    Args:
        system: At constant speed.
        period: [s]; left out, the time after which all tones repeat, which with hunting teeth may be long.
        step: Largest step [s], taken as it is; the period is cut into equal ones. Or an `Accuracy`, as in `simulate`.

    Raises:
        SolveError: If Newton's method does not close the motion; under heavy contact loss there may be several
            motions, or none of this period.
    """
    arrays = system.arrays
    asked = step if isinstance(step, Accuracy) else Accuracy()
    given = None if step is None or isinstance(step, Accuracy) else step
    period = common_period(arrays) if period is None else period
    for path, value in (("period", period), ("step", period if given is None else given)):
        if not 0.0 < value < np.inf:
            raise DesignError([Problem(path, f"{value:g} s; it must be positive and finite")])
    steps = 2 * int(np.ceil(0.5 * period / (default_step(arrays, asked) if given is None else given)))
    start = np.zeros(2 * len(arrays.mass))
    start[: len(arrays.mass)] = equilibrium(system)
    orbit = _orbit(system, _closed(system, start, period, steps), period=period, steps=steps)
    most = 2 * steps if given is not None else max(steps * 2**HALVED, QUICK)
    while steps < most:
        steps, other = 2 * steps, orbit
        orbit = _orbit(system, _closed(system, _start(other), period, steps), period=period, steps=steps)
        error, uncertain = _error(arrays, orbit, other), _uncertain(orbit, other)
        sure = abs(float(np.max(np.abs(orbit.multipliers), initial=0.0)) - 1.0) > uncertain
        if error.over(asked) <= 1.0 and sure:
            break
    notes = [] if sure else [f"the largest multiplier is 1 to within {uncertain:.1e}: on the border of stability"]
    notes += shortfall(error, asked, f"{steps} steps did not bring it down" if given is None else GIVEN)
    return replace(orbit, error=error.peak, rms_error=error.rms, multiplier_error=uncertain, notes=tuple(notes))


def _closed(system: System, start: Floats, period: float, steps: int) -> Floats:
    """Return the start of a motion that repeats itself: by Newton's method, then from where the motion goes by itself.

    Raises:
        SolveError: If neither closes.
    """
    gap = np.inf
    for wait in (0, SETTLING):
        left = ends_of(system, start[None], wait * period, period / steps)[0] if wait else start
        found, gap = _newton(system, left, period, steps)
        if gap < CLOSED:
            return found
    reasons = [*endless(system.arrays, LOCKED / period), *filter(None, [unbalanced(system)])]
    missed = (
        f"no motion of period {period:.4g} s closed, neither in {ROUNDS} rounds of Newton's method nor after "
        f"{SETTLING} periods; the gap is {gap:.1e}: try a multiple of the period, or simulate"
    )
    raise SolveError("; ".join([*reasons, missed]))


def _newton(system: System, start: Floats, period: float, steps: int) -> tuple[Floats, float]:
    """Return the start of a motion that nearly repeats itself, and the gap that is left."""
    for _ in range(ROUNDS):
        end, matrix, scale = _period(system, start, period, steps)
        gap = (end - start) / scale
        if np.max(np.abs(gap)) < CLOSED:
            break
        # Rigid motions may start anywhere: the shortest step leaves them where they are.
        change = np.linalg.lstsq(np.eye(len(start)) - matrix / scale[:, None] * scale, gap, rcond=1e-9)[0]
        start = start + change * scale
    return start, float(np.max(np.abs(gap)))


def _period(system: System, start: Floats, period: float, steps: int) -> tuple[Floats, Floats, Floats]:
    """Return the end of a period, its derivative by the start, and the size of each state."""
    size = len(start) // 2
    position = float(np.max(np.abs(start[:size]))) or STILL
    rate = 2.0 * np.pi / period
    scale = np.repeat([position, max(position * rate, float(np.max(np.abs(start[size:]))))], size)
    starts = np.vstack([start, start + NUDGE * np.diag(scale), start - NUDGE * np.diag(scale)])
    ends = ends_of(system, starts, period, period / steps)
    many = len(start)
    matrix = (ends[1 : many + 1] - ends[many + 1 :]).T / (2.0 * NUDGE * scale)
    return ends[0], matrix, scale


def _start(orbit: Orbit) -> Floats:
    return np.concatenate([orbit.samples.position[0], orbit.samples.velocity[0]])


def _orbit(system: System, start: Floats, *, period: float, steps: int) -> Orbit:
    """Return the orbit from its start, with the multipliers of what is next to it."""
    arrays = system.arrays
    samples = every_step(system, start, period / steps, steps)
    matrix = monodromy(system, samples)
    elastic = split_rigid(arrays)[1]
    basis = np.kron(np.eye(2), elastic)
    inverse = np.kron(np.eye(2), elastic.T * arrays.mass)
    multipliers = np.linalg.eigvals(inverse @ matrix @ basis).astype(np.complex128)
    order = np.argsort(-np.abs(multipliers))
    return Orbit(period, samples, multipliers[order], matrix)


def _forces(orbit: Orbit) -> Forces:
    force = orbit.samples.line_force[:-1]
    size, lines = np.abs(force), np.arange(force.shape[1])
    place, rms = np.argmax(size, axis=0), np.sqrt(np.mean(force**2, axis=0))[None]
    before, peak, after = (force[(place + shift) % len(force), lines] for shift in (-1, 0, 1))
    return Forces(np.abs(peak)[None], rms, 0.125 * np.abs(before - 2.0 * peak + after)[None], 0.0 * rms)


def _error(arrays: Arrays, orbit: Orbit, other: Orbit) -> Error:
    """Return the error of forces, from the orbit at twice the step."""
    units, order = orbit.samples.labels.line_units, PARTING if _parts(arrays, orbit) else SMOOTH
    return errors_of(_forces(orbit), _forces(other), units, ratio=2.0, order=order)[0]


def _parts(arrays: Arrays, orbit: Orbit) -> bool:
    """Whether teeth part."""
    return bool(np.any(orbit.samples.line_deflection[:, arrays.backlash > 0.0] <= 0.0))


def _uncertain(orbit: Orbit, other: Orbit) -> float:
    """Return how far the size of the largest multiplier may be off, from the orbit at twice the step [-]."""
    one, two = (float(np.max(np.abs(found.multipliers), initial=0.0)) for found in (orbit, other))
    return abs(one - two) + MULTIPLIER_ROUNDING
