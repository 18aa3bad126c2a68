"""Run-up: steady running at many speeds with spectra, which show orders and natural frequencies side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.dynamics.given import positive_numbers
from gearwright.dynamics.model import Floats, System
from gearwright.dynamics.motion import Outputs, Samples, default_step, index_of, simulate
from gearwright.dynamics.vibration.critical_speeds import order_name
from gearwright.dynamics.vibration.spectra import tone_amplitudes
from gearwright.dynamics.vibration.speed_map import at_speed
from gearwright.errors import DesignError, Problem
from gearwright.sizing import Sizing
from gearwright.verbs import verb


@dataclass(frozen=True, eq=False)
class RunUp:
    """Line forces in steady running at many speeds."""

    factor: Floats
    """Speed over operating speed [-], shape (speeds,)."""
    frequency: Floats
    """[Hz], shape (frequencies,)."""
    amplitude: Floats
    """Spectra of the line forces, Hann window [N or N m], shape (speeds, lines, frequencies)."""
    orders: tuple[str, ...]
    """Orders in words, by rising frequency."""
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


@verb
def run_up(
    sizing: Sizing,
    system: System,
    factors: Sequence[float] | Floats,
    *,
    lines: Sequence[str],
    settle: float = 0.05,
    window: float = 0.05,
    progress: Callable[[float], None] | None = None,
) -> RunUp:
    """Return forces and spectra of steady running at each speed, each from its own static equilibrium.

    Args:
        sizing: Names the orders.
        system: Assembled from it; its loads are kept at every speed.
        factors: Rising speeds over the operating speed [-], positive.
        lines: Whose forces are kept.
        settle: Time before the window, for the transient to decay [s].
        window: Time that is kept at every step: 1 over the resolution of the spectra [s].
        progress: Called with the fraction done.

    Raises:
        DesignError: For speeds or times that are not positive, or lines that do not exist.
    """
    speeds = positive_numbers(factors, "factors").tolist()
    if not (settle >= 0.0 and 0.0 < window < math.inf):
        raise DesignError([Problem("window", f"{window:g} s after {settle:g} s; the window must be positive")])
    for line in lines:
        index_of(line, system.labels.lines, "line")
    step = min(default_step(at_speed(system, factor).arrays) for factor in (speeds[0], speeds[-1]))
    outputs = Outputs(samples=2, windows=((settle, settle + window),))
    rows = []
    for number, factor in enumerate(speeds, start=1):
        each = at_speed(system, factor)
        samples = simulate(each, settle + window, step=step, method="runge-kutta", outputs=outputs).whole().windows[0]
        rows.append([_heard(each, samples, samples.force(line)) for line in lines])
        if progress is not None:
            progress(number / len(speeds))
    return _gathered(sizing, system, rows, (speeds, tuple(lines), step))


def _heard(system: System, samples: Samples, force: Floats) -> tuple[Floats, Floats, float, float]:
    """Return spectrum, amplitude of each turning tone, mean and swing of one force."""
    hann = np.hanning(len(force))
    spectrum = 2.0 * np.abs(np.fft.rfft((force - np.mean(force)) * hann)) / np.sum(hann)
    by_tone = {tone: abs(share) for tone, share in tone_amplitudes(system, samples, force)}
    tones = [by_tone.get(tone, 0.0) for tone in system.labels.tones]
    return spectrum, np.array(tones), float(np.mean(force)), float(np.std(force))


def _gathered(
    sizing: Sizing,
    system: System,
    rows: Sequence[Sequence[tuple[Floats, Floats, float, float]]],
    of: tuple[Sequence[float], tuple[str, ...], float],
) -> RunUp:
    factors, lines, step = of
    rate = np.abs(system.arrays.tone_rate) / (2.0 * np.pi)
    turning = [int(place) for place in np.argsort(rate) if rate[place] > 0.0]
    shortest = min(len(each[0]) for row in rows for each in row)
    spectra = np.array([[each[0][:shortest] for each in row] for row in rows])
    tones = np.array([[each[1][turning] for each in row] for row in rows])
    return RunUp(
        factor=np.array(factors, dtype=float),
        frequency=np.fft.rfftfreq(2 * shortest - 1, step)[:shortest].astype(np.float64),
        amplitude=spectra,
        orders=tuple(order_name(sizing, system.labels.tones[place]) for place in turning),
        order_frequency=rate[turning],
        order_amplitude=tones,
        mean=np.array([[each[2] for each in row] for row in rows]),
        swing=np.array([[each[3] for each in row] for row in rows]),
        lines=lines,
    )
