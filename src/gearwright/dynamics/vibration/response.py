"""Frequency response to transmission errors and loads, and forced response at operating speed."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Complexes, Floats, Ints, largest_first
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly import assemble, compound_phases, gear_pairs
from gearwright.dynamics.equations import damped_rates, linear, statics
from gearwright.dynamics.model import Arrays, Labels, System, finite_numbers, line_matrix, refuse_not_finite
from gearwright.dynamics.motion import UNDAMPED, index_of
from gearwright.errors import DesignError, Problem, SolveError, by_name, near
from gearwright.identity import Row, mesh_part
from gearwright.parts.planetary import planet_phases
from gearwright.showing import Shown
from gearwright.sizing import Sizing, governing_case, planet_positions
from gearwright.units import Force, Frequency
from gearwright.verbs import verb

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
        for row, place in _terms(series.start):
            tone = int(series.tone[place])
            sign = 1.0 if arrays.tone_rate[tone] >= 0.0 else -1.0
            exciting[tone, row] += scale[row] * complex(series.cosine[place], -sign * series.sine[place])
    return exciting


def _terms(start: Ints) -> Iterator[tuple[int, int]]:
    for row in range(len(start) - 1):
        for place in range(int(start[row]), int(start[row + 1])):
            yield row, place
