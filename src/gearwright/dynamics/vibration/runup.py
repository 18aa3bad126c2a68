"""Run-up: steady running at many speeds with spectra, which show orders and natural frequencies side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model import Excitation, System
from gearwright.dynamics.motion import (
    GIVEN,
    Accuracy,
    Error,
    Outputs,
    Samples,
    default_step,
    index_of,
    shortfall,
    simulate,
)
from gearwright.dynamics.vibration.critical_speeds import OrderName, order_name
from gearwright.dynamics.vibration.sequences import positive_numbers
from gearwright.dynamics.vibration.spectra import tone_amplitudes
from gearwright.dynamics.vibration.speed_map import at_speed
from gearwright.dynamics.vibration.transmission import first_meshes
from gearwright.errors import DesignError, Problem
from gearwright.ranking import largest_first, place_of_largest
from gearwright.showing import Shown
from gearwright.sizing import Sizing
from gearwright.units import Force, Origin, Speed
from gearwright.verbs import verb


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
