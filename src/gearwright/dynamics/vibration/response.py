"""Frequency response: the steady vibration under harmonic errors or loads at mean stiffness."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import damped_rates, linear
from gearwright.dynamics.model import Arrays, Labels, System, finite_numbers, line_matrix, refuse_not_finite
from gearwright.dynamics.motion import UNDAMPED, index_of
from gearwright.dynamics.vibration.sequences import positive_numbers
from gearwright.errors import SolveError
from gearwright.ranking import largest_first
from gearwright.showing import Shown
from gearwright.units import Force, Frequency
from gearwright.verbs import verb

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
