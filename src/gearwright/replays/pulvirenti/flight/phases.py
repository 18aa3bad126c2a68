"""What the planets' mesh phases do to the output torque: as placed, as the thesis spaces them, and in phase."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from gearwright.dynamics import Outputs, System, simulate
from gearwright.identity import PartId, Role, Row, gear_part, mesh_part
from gearwright.mission.windows import DynamicWindow
from gearwright.replays.pulvirenti.flight.claims import DESIGN, VARYING, Runs
from gearwright.replays.pulvirenti.flight.measures import mean_off_ideal, off_ideal, output_swing
from gearwright.replays.pulvirenti.runs import sized

DURATION = 1.0
"""Of the runs with other phases [s]."""
END = 0.01
"""Stretch at their end of which every step is kept [s]."""


@dataclass(frozen=True)
class Phased:
    """The output torque of a quiet window with one way of phasing the planets."""

    window: str
    phases: str
    """In words."""
    maximum: float
    """Largest difference to the ideal torque [-]."""
    mean: float
    """Mean absolute difference [-]."""
    swing: float
    """Greatest less least over the ideal torque [-]."""


def phased(runs: Runs) -> tuple[Phased, ...]:
    """Return the output torque of cruise and taxi with three ways of phasing the planets.

    Args:
        runs: Of `chapter_runs`.

    Source: phases of Parker and Lin 2004 as assembled; Pulvirenti 2023, (3.34): planets at 360°/(N − 1); none.
    """
    ways: dict[str, Callable[[int], float] | None] = {
        "2π/N, as planets are placed": None,
        "360°/(N − 1), the thesis's (3.34)": lambda planets: 2.0 * np.pi / (planets - 1),
        "all in phase": lambda planets: 0.0,
    }
    return tuple(
        _row(name, words, runs[name, VARYING] if spacing is None else _rephased(runs[name, VARYING], spacing))
        for name in ("cruise", "taxi")
        for words, spacing in ways.items()
    )


def _row(name: str, words: str, window: DynamicWindow) -> Phased:
    return Phased(name, words, off_ideal(window), mean_off_ideal(window), output_swing(window))


def _rephased(window: DynamicWindow, spacing: Callable[[int], float]) -> DynamicWindow:
    """Return a window flown again with each set's planets spaced by an angle."""
    system = window.system
    for stage, planetary in sized(DESIGN).design.planetaries.items():
        for row in (Row.SUN_PLANET, Row.PLANET_RING):
            angle = sized(DESIGN).teeth[str(gear_part(stage, Role.SUN))] * spacing(planetary.planets)
            system = _spaced(system, mesh_part(stage, row), angle)
    outputs = Outputs(windows=((DURATION - END, DURATION),))
    trace = simulate(system, DURATION, step=window.trace.step, outputs=outputs)
    return replace(window, system=system, trace=trace.whole())


def _spaced(system: System, row: PartId, angle: float) -> System:
    """Return a system in which each line of a row follows the one before by a mesh phase [rad]."""
    series = system.arrays.variation
    lines = system.labels.places_of(row)
    cosine, sine = series.cosine.copy(), series.sine.copy()
    first = slice(series.start[lines[0]], series.start[lines[0] + 1])
    wave = series.cosine[first] - 1j * series.sine[first]
    for number, line in enumerate(lines):
        turned = wave * np.exp(1j * number * angle * np.arange(1, len(wave) + 1))
        part = slice(series.start[line], series.start[line + 1])
        cosine[part], sine[part] = turned.real, -turned.imag
    return replace(system, arrays=system.arrays._replace(variation=series._replace(cosine=cosine, sine=sine)))
