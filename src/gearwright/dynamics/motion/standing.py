"""Standing: the static equilibrium that runs begin from, and what of a system never comes to rest."""

from __future__ import annotations

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.equations import damped_rates, statics
from gearwright.dynamics.model import Arrays, System, kept, planned
from gearwright.dynamics.motion.record import RUNAWAY
from gearwright.dynamics.motion.steps import damping_bound
from gearwright.errors import SolveError
from gearwright.ranking import place_of_largest

UNDAMPED = 1e-9
"""Damping ratio below which a mode has none but that of rounding [-]."""


def equilibrium(system: System) -> Floats:
    """Return q in static equilibrium; loads that do not balance speed it up.

    Args:
        system: Bodies, lines, loads.

    Raises:
        SolveError: If a line would carry more than any gear comes near, with the line and its load.
    """
    found = kept(system.arrays, (statics,), lambda: statics(system, balance="accelerate"))
    place = place_of_largest(np.abs(found.force)) if len(found.force) else -1
    if place >= 0 and not abs(found.force[place]) < RUNAWAY:
        line, force = system.labels.lines[place], found.force[place]
        raise SolveError(
            f"the loads press line {line} with {force:.3g} before anything moves; at most {RUNAWAY:.0e} N or N m can "
            "be followed: look at the units of the loads"
        )
    return found.position


@planned
def endless(arrays: Arrays, width: float) -> list[str]:
    """Return what to say of modes without damping that a tone meets: their force grows as long as the run lasts.

    Args:
        arrays: The system's numbers.
        width: Distance of a mode from a tone below which they meet [rad/s].
    """
    notes = dict[str, None]()
    used = np.unique(np.concatenate([arrays.variation.tone, arrays.error.tone])).astype(int)
    if damping_bound(arrays, _slowest(arrays, used)) > UNDAMPED:  # far quicker than the modes
        return []
    for factor in {float(np.min(arrays.profile.factor)), float(np.max(arrays.profile.factor))}:
        rates = damped_rates(arrays, factor)
        for rate in rates[-rates.real < UNDAMPED * np.abs(rates)]:
            if np.any(np.abs(np.abs(arrays.tone_rate[used] * factor) - rate.imag) < width):
                hertz = rate.imag / (2.0 * np.pi)
                notes[
                    f"the mode at {hertz:.4g} Hz has no damping and is excited at its own frequency: its force grows "
                    "without end, and statistics are those of this start and this duration; give it damping"
                ] = None
    return list(notes)


def _slowest(arrays: Arrays, tones: Ints) -> float:
    """Return the slowest of some tones that turn, at the lowest speed [rad/s]; 0 without any."""
    rates = np.abs(np.outer(arrays.tone_rate[tones], arrays.profile.factor))
    return float(np.min(rates[rates > 0.0], initial=np.inf)) if np.any(rates > 0.0) else np.inf
