"""Spectra: what a signal is made of, by tone (any speed) or by frequency against time (waterfall)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Complexes, Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.equations import speed_factors
from gearwright.dynamics.model import System, Tone
from gearwright.dynamics.motion import Samples
from gearwright.errors import DesignError, Problem
from gearwright.showing import Shown
from gearwright.verbs import verb


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
