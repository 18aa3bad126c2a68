"""Which departure of the printed model makes which number: the output torque with each of them, and with all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.dynamics import System, modes
from gearwright.mission.windows import DynamicWindow
from gearwright.replays.pulvirenti.flight.claims import DESIGN, VARYING, Runs
from gearwright.replays.pulvirenti.flight.measures import mean_off_ideal, off_ideal, output_swing
from gearwright.replays.pulvirenti.flight.printed import (
    PRINTED,
    UNITLESS,
    Change,
    in_phase,
    reflown,
    relative_planets,
    spaced,
    square_wave,
)
from gearwright.replays.pulvirenti.runs import sized
from gearwright.sizing import Sizing

DURATION = 1.0
"""Of the runs with one departure [s]."""
WINDOWS = ("cruise", "taxi")
"""Quiet windows, in which only teeth move the output torque."""
SHOWN = 12
"""Natural frequencies that are compared [-]."""


@dataclass(frozen=True)
class Departed:
    """The output torque of a quiet window with some of the thesis's departures."""

    window: str
    equation: str
    """Where they are printed; empty for the model as it should be."""
    words: str
    maximum: float
    """Largest difference to the ideal torque [-]."""
    mean: float
    """Mean absolute difference [-]."""
    swing: float
    """Greatest less least over the ideal torque [-]."""


@dataclass(frozen=True)
class _Way:
    equation: str
    words: str
    changes: Sequence[Change]


def departed(runs: Runs) -> tuple[Departed, ...]:
    """Return the output torque of cruise and taxi with each departure alone, and with all.

    Args:
        runs: Of `chapter_runs`: those with varying stiffness are flown again, a second each.
    """
    return tuple(_row(runs[window, VARYING], way) for window in WINDOWS for way in _ways())


def _ways() -> Sequence[_Way]:
    every = [printed.change for printed in PRINTED]
    return (
        _Way("", "as it should be", []),
        *(_Way(printed.equation, printed.words, [printed.change]) for printed in PRINTED),
        _Way("(3.34)", "planets 360°/(N − 1) apart, with the 54 and 57 teeth of the suns here", [_thesis_spacing]),
        _Way("(3.35), (3.34)", "the square wave, in phase", [square_wave, in_phase]),
        _Way("all of these", "as printed", every),
        *(_Way(f"and {printed.equation}", printed.words, [*every, printed.change]) for printed in UNITLESS),
    )


def _thesis_spacing(system: System, sizing: Sizing) -> System:
    return spaced(system, sizing, lambda planets: 2.0 * np.pi / (planets - 1))


def _row(window: DynamicWindow, way: _Way) -> Departed:
    flown = reflown(window, sized(DESIGN), way.changes, duration=DURATION)
    return Departed(window.name, way.equation, way.words, off_ideal(flown), mean_off_ideal(flown), output_swing(flown))


@dataclass(frozen=True)
class Frequencies:
    """Natural frequencies of In-Line H2, with the planets' inertia as it should be and as printed [Hz]."""

    right: tuple[float, ...]
    printed: tuple[float, ...]


def frequencies(runs: Runs) -> Frequencies:
    """Return the lowest natural frequencies with the planets' inertia as it should be and as printed.

    Args:
        runs: Of `chapter_runs`.
    """
    system = runs["cruise", VARYING].system
    pair = [modes(shown).frequency[:SHOWN] for shown in (system, relative_planets(system, sized(DESIGN)))]
    return Frequencies(tuple(map(float, pair[0])), tuple(map(float, pair[1])))
