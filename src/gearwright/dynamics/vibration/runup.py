"""Run-up over many speeds: connection forces, order spectra and waterfall diagram."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.base import (
    Complexes,
    DesignError,
    Floats,
    Force,
    Origin,
    Problem,
    Shown,
    Speed,
    largest_first,
    one_blas_thread,
    place_of_largest,
    verb,
)
from gearwright.dynamics.equations import speed_factors
from gearwright.dynamics.model import Excitation, System, Tone, check_finite
from gearwright.dynamics.motion import (
    GIVEN,
    Accuracy,
    Ensemble,
    Error,
    Outputs,
    Samples,
    default_step,
    index_of,
    shortfall,
    simulate,
    simulate_many,
)
from gearwright.dynamics.vibration.critical_speeds import OrderName, order_name
from gearwright.dynamics.vibration.response import first_meshes, positive_numbers
from gearwright.sizing import Sizing

# ----------------------------------------------------------------------------------------------------------------------
# Speed map: line forces of steady running at many speeds, all side by side.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False, repr=False)
class SpeedMap(Shown):
    """Line forces against speed."""

    factor: Floats
    """Speed over reference speed [-], shape (speeds,)."""
    forces: Ensemble
    """Statistics at each speed."""

    def swing(self, line: str) -> Floats:
        """Return the root mean square of a line's force about its mean [N or N m], shape (speeds,).

        Args:
            line: Its name.
        """
        values = self.forces.of(line)
        return np.sqrt(np.maximum(values["rms"] ** 2 - values["mean"] ** 2, 0.0))


@verb
@one_blas_thread()
def speed_map(
    system: System,
    factors: Sequence[float] | Floats,
    *,
    settle: float,
    duration: float,
    accuracy: Accuracy | None = None,
    progress: Callable[[float], None] | None = None,
) -> SpeedMap:
    """Return the forces at steady running, each speed from its own static equilibrium.

    Args:
        system: Its loads are kept as they are at every speed.
        factors: Speeds over the reference speeds [-], positive; any sequence of numbers.
        settle: Time left out, for the transient to decay [s].
        duration: Whole time at each speed [s].
        accuracy: Of the forces; left out, peaks to 1 %, root mean squares to 0.1 %; the errors are in `forces`.
        progress: Called with the fraction done.

    Raises:
        DesignError: For speeds that are not positive.
    """
    speeds = positive_numbers(factors, "factors")
    check_finite(system)
    systems = [at_speed(system, factor) for factor in speeds]
    forces = simulate_many(systems, duration, step=accuracy, settle=settle, progress=progress)
    return SpeedMap(speeds, forces)


def at_speed(system: System, factor: float) -> System:
    """Return a system that runs steadily at another speed.

    Args:
        system: Any.
        factor: Speed over reference speed [-].
    """
    zero = np.zeros(1)
    profile = system.arrays.profile._replace(time=zero, factor=np.array([float(factor)]), travel=zero)
    return replace(system, arrays=system.arrays._replace(profile=profile))


# ----------------------------------------------------------------------------------------------------------------------
# Spectra: what a signal is made of, by tone (any speed) or by frequency against time (waterfall).
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False, repr=False)
class Waterfall(Shown):
    """Amplitude spectra of successive stretches of time."""

    time: Floats
    """Middle of each stretch [s], shape (stretches,)."""
    frequency: Floats
    """[Hz], shape (frequencies,)."""
    amplitude: Floats
    """Peak amplitude in the unit of the signal, shape (stretches, frequencies)."""


@verb
@one_blas_thread()
def tone_amplitudes(system: System, samples: Samples, signal: Floats) -> list[tuple[Tone, complex]]:
    """Return the complex amplitude of each tone in a signal, largest first: its real part times e^(iφ) is the share.

    Found by least squares on the tones' angles, so that speed may change.

    Args:
        system: Its tones.
        samples: Instants, at least three for each tone.
        signal: Such as ``samples.force("mesh")``, shape (instants,).

    Raises:
        DesignError: If there are fewer instants than amplitudes to find.
    """
    arrays = system.arrays
    turning = [number for number, rate in enumerate(arrays.tone_rate) if rate != 0.0]
    if len(signal) < 2 * len(turning) + 1:
        raise DesignError([Problem("samples", f"{len(signal)} instants cannot tell {len(turning)} tones apart")])
    travel = speed_factors(arrays.profile, samples.time)[2]
    angle = np.outer(travel, arrays.tone_rate[turning])
    basis = np.hstack([np.ones((len(angle), 1)), np.cos(angle), np.sin(angle)])
    amplitudes = np.linalg.lstsq(basis, signal, rcond=None)[0]
    cos, sin = amplitudes[1 : len(turning) + 1], amplitudes[len(turning) + 1 :]
    shares: Complexes = (cos - 1j * sin).astype(np.complex128)
    order = np.argsort(-np.abs(shares))
    return [(system.labels.tones[turning[place]], complex(shares[place])) for place in order]


@verb
@one_blas_thread()
def waterfall(samples: Samples, signal: Floats, *, stretches: int = 64) -> Waterfall:
    """Return amplitude spectra of overlapping stretches of a signal, Hann window.

    Args:
        samples: Evenly spaced instants, such as a window of every step.
        signal: Shape (instants,).
        stretches: How many; each overlaps half of the next.

    Raises:
        DesignError: If the stretches would be shorter than 16 instants.
    """
    length = 2 * len(signal) // (stretches + 1)
    if length < 16:
        raise DesignError([Problem("stretches", f"{stretches} stretches of {len(signal)} instants are too short")])
    step = float(samples.time[1] - samples.time[0])
    starts = np.arange(stretches) * (length // 2)
    pieces = np.lib.stride_tricks.sliding_window_view(signal, length)[starts]
    window = np.hanning(length)
    amplitude = 2.0 * np.abs(np.fft.rfft((pieces - np.mean(pieces, axis=1, keepdims=True)) * window)) / np.sum(window)
    frequency = np.fft.rfftfreq(length, step).astype(np.float64)
    return Waterfall(samples.time[starts + length // 2], frequency, amplitude)


# ----------------------------------------------------------------------------------------------------------------------
# Run-up: steady running at many speeds with spectra, which show orders and natural frequencies side by side.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False, repr=False)
class RunUp(Shown):
    """Line forces in steady running at many speeds."""

    factor: Floats
    """Speed over operating speed [-], shape (speeds,)."""
    frequency: Floats
    """[Hz], shape (frequencies,)."""
    amplitude: Floats
    """Spectra of the line forces, Hann window [N or N m], shape (speeds, lines, frequencies)."""
    orders: tuple[OrderName, ...]
    """Orders by rising frequency."""
    order_frequency: Floats
    """Of each order at the operating speed [Hz], shape (orders,)."""
    order_amplitude: Floats
    """Amplitude of each order [N or N m], shape (speeds, lines, orders)."""
    mean: Floats
    """Mean force [N or N m], shape (speeds, lines)."""
    swing: Floats
    """Root mean square about the mean [N or N m], shape (speeds, lines)."""
    lines: tuple[str, ...]
    """Names."""
    error: Floats
    """Measured error of the peaks of line forces over them [-], shape (speeds,)."""
    rms_error: Floats
    """And of their root mean squares [-], shape (speeds,)."""
    machine_orders: tuple[Excitation, ...]
    """Orders of machines, teeth and planets that no line makes."""
    notes: tuple[str, ...]
    """Speeds whose error is larger than asked, and why."""


@dataclass(frozen=True)
class Loudest:
    """The speed at which a line's force swings most."""

    line: str
    speed: Speed
    """[rad/s]"""
    swing: Annotated[Force, Origin("√(1/T ∫ (F − F_m)² dt)", "root mean square about the mean, of a run")]
    """Root mean square about the mean [N]."""
    mean: Force
    """[N]"""
    order: str
    """What swings most there."""


@verb
@one_blas_thread()
def run_up(
    sizing: Sizing,
    system: System,
    factors: Sequence[float] | Floats,
    *,
    lines: Sequence[str] | None = None,
    settle: float = 0.05,
    window: float = 0.05,
    progress: Callable[[float], None] | None = None,
) -> RunUp:
    """Return forces and spectra of steady running at each speed, each from its own static equilibrium.

    Args:
        sizing: Names the orders.
        system: Assembled from it; its loads are kept at every speed.
        factors: Rising speeds over the operating speed [-], positive.
        lines: Whose forces are kept; left out: of every mesh row, of a planetary set that of its first planet.
        settle: Time before the window, for the transient to decay [s].
        window: Time that is kept at every step: 1 over the resolution of the spectra [s].
        progress: Called with the fraction done.

    Raises:
        DesignError: For speeds or times that are not positive, or lines that do not exist.
    """
    speeds = positive_numbers(factors, "factors").tolist()
    if not (settle >= 0.0 and 0.0 < window < math.inf):
        raise DesignError([Problem("window", f"{window:g} s after {settle:g} s; the window must be positive")])
    lines = first_meshes(sizing, system) if lines is None else lines
    for line in lines:
        index_of(line, system.labels.lines, "line")
    step = min(default_step(at_speed(system, factor).arrays) for factor in speeds)
    outputs = Outputs(samples=2, start=settle, windows=((settle, settle + window),))
    rows, errors, notes = [], [], []
    for number, factor in enumerate(speeds, start=1):
        running = at_speed(system, factor)
        trace = simulate(running, settle + window, step=step, method="runge-kutta", outputs=outputs).whole()
        errors.append(Error(trace.error, trace.rms_error))
        notes += [f"at {factor:g} of the speed {note}" for note in shortfall(errors[-1], Accuracy(), GIVEN)]
        rows.append([_heard(running, trace.windows[0], line) for line in lines])
        if progress is not None:
            progress(number / len(speeds))
    rate = np.abs(system.arrays.tone_rate) / (2.0 * np.pi)
    turning = [place for place in np.argsort(rate).tolist() if rate[place] > 0.0]
    shortest = min(len(heard.spectrum) for row in rows for heard in row)
    return RunUp(
        factor=np.array(speeds, dtype=float),
        frequency=np.fft.rfftfreq(2 * shortest - 1, step)[:shortest].astype(np.float64),
        amplitude=np.array([[heard.spectrum[:shortest] for heard in row] for row in rows]),
        orders=tuple(order_name(sizing, system.labels.tones[place]) for place in turning),
        order_frequency=rate[turning],
        order_amplitude=np.array([[heard.tones[turning] for heard in row] for row in rows]),
        mean=np.array([[heard.mean for heard in row] for row in rows]),
        swing=np.array([[heard.swing for heard in row] for row in rows]),
        lines=tuple(lines),
        error=np.array([error.peak for error in errors]),
        rms_error=np.array([error.rms for error in errors]),
        machine_orders=system.labels.orders,
        notes=tuple(notes),
    )


class _Heard(NamedTuple):
    """What one line's force is made of at one speed."""

    spectrum: Floats
    tones: Floats
    """Amplitude of every tone, also of those that stand."""
    mean: float
    swing: float


def _heard(system: System, samples: Samples, line: str) -> _Heard:
    force = samples.force(line)
    hann = np.hanning(len(force))
    spectrum = 2.0 * np.abs(np.fft.rfft((force - np.mean(force)) * hann)) / np.sum(hann)
    by_tone = {tone: abs(share) for tone, share in tone_amplitudes(system, samples, force)}
    tones = [by_tone.get(tone, 0.0) for tone in system.labels.tones]
    return _Heard(spectrum, np.array(tones), float(np.mean(force)), float(np.std(force)))


def loudest_speeds(steady: RunUp, speed: float) -> list[Loudest]:
    """Return for each line the speed at which its force swings most and the order that does it, the loudest first.

    Args:
        steady: Speeds and spectra.
        speed: Operating speed of the first machine's shaft [rad/s].
    """
    rows = []
    for number, line in enumerate(steady.lines):
        place = place_of_largest(steady.swing[:, number])
        order = steady.orders[place_of_largest(steady.order_amplitude[place, number])]
        rows.append(
            Loudest(line, float(steady.factor[place]) * speed, float(steady.swing[place, number]),
                    float(steady.mean[place, number]), str(order))
        )  # fmt: skip
    return largest_first(rows, lambda row: row.swing)
