"""Module and face width of one stage: the lightest with which every strength of its teeth just does, both ways."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from gearwright.closure.requirements import STRENGTH, requirement_of
from gearwright.ranking import smallest
from gearwright.sizing.insight import Trial
from gearwright.sizing.rating import STANDARD_MODULES

_MM = 1e-3
CLOSE = 1e-5
"""Distance of the governing margin from 1 at which a continuous size counts as found [-]."""
NEAR = 5e-3
"""The same where whole millimetres are looked at afterwards [-]."""
ROUNDING = 1e-9
"""Of a margin, and of a width over another [-]."""
MOST_STEPS = 40
"""Steps of the search for a width [-]."""
LARGER = 1
"""Modules above the least one that are looked at, as a narrower face may weigh less [-]."""


class StageSize(NamedTuple):
    """Size of a stage."""

    module: float
    """m_n [m]."""
    face_width: float
    """b [m]."""
    margin: float
    """Of the check that governs, as in `Check.reserve` [-]."""
    governs: str
    """Name of that check."""
    volume: float
    """Of its gears as cylinders [m³]."""


class StageTask(NamedTuple):
    """A stage that is proportioned."""

    trial: Trial
    name: str
    left_out: frozenset[str]
    rounded: bool
    """Whole millimetres."""
    target: float = 1.0
    """Margin that is asked of its strengths, above 1 where a flight asks for more than the design's own cases [-]."""

    def widest(self, module: float) -> float:
        """Return the widest face that its rules call usual [m].

        Args:
            module: m_n [m].
        """
        return self.trial.widest(self.name, module)

    def least(self, module: float) -> float:
        """Return the narrowest face that its rules allow [m].

        Args:
            module: m_n [m].
        """
        return self.trial.least(self.name, module)

    def volume(self, module: float, width: float) -> float:
        """Return what its gears fill as cylinders [m³].

        Args:
            module: m_n [m].
            width: b [m].
        """
        return self.trial.volume(self.name, module, width)

    def governing(self, module: float, width: float) -> tuple[float, str]:
        """Return the least margin of its strengths at a size over what is asked [-], and the name of that check.

        Args:
            module: m_n [m].
            width: b [m].
        """
        worst, name = math.inf, ""
        for check in self.trial.checks(self.name, module, width):
            requirement = requirement_of(check)
            counts = requirement in STRENGTH and requirement not in self.left_out
            if counts and check.reserve is not None and check.reserve < worst:
                worst, name = check.reserve, check.name
        return worst / self.target, name


def sized_at(task: StageTask, module: float) -> StageSize | None:
    """Return the stage at a module with the least face width that does; None where none that is allowed does.

    Args:
        task: The stage.
        module: m_n [m].
    """
    widest = task.widest(module)
    least = min(task.least(module), widest)
    if (above := task.governing(module, widest)[0]) < 1.0 - ROUNDING:
        return None
    width = _crossing(task, module, least, (widest, above))
    if task.rounded:
        width = _whole(task, module, width)
        width = widest if width > widest * (1.0 + ROUNDING) else width
    margin, governs = task.governing(module, width)
    return StageSize(module, width, margin, governs, task.volume(module, width))


def _crossing(task: StageTask, module: float, least: float, wide: tuple[float, float]) -> float:
    """Return the width at which the margin is 1, or the least one: by the secant, held in a bracket [m].

    Args:
        task: The stage.
        module: m_n [m].
        least: Width to look down to [m].
        wide: The widest one that does [m], and its margin [-].
    """
    (high, above), low, below, steep = wide, least, 0.0, 1.0
    close = NEAR if task.rounded else CLOSE
    for _ in range(MOST_STEPS):
        if above - 1.0 < close or high <= least:
            break
        width = high * (above / (1.0 + 0.3 * close)) ** (-1.0 / steep)
        if not low < width < high:
            width = math.sqrt(low * high) if below or width > low else low
        margin = task.governing(module, width)[0]
        known = (width, margin)
        if abs(math.log(high / width)) > ROUNDING and above != margin:
            steep = min(max(math.log(above / margin) / math.log(high / width), 0.2), 5.0)
        if margin >= 1.0:
            high, above = known
        else:
            low, below = known
            if high / low - 1.0 < ROUNDING:
                break
    return high


def _whole(task: StageTask, module: float, width: float) -> float:
    """Return the least whole millimetres near a width that do, with one less shown to fail [m]."""
    count, least = math.ceil(width / _MM - 1e-6), task.least(module)
    while task.governing(module, count * _MM)[0] < 1.0 and count * _MM < task.widest(module):
        count += 1
    while (count - 1) * _MM >= least and task.governing(module, (count - 1) * _MM)[0] >= 1.0:
        count -= 1
    return count * _MM


def lightest(task: StageTask, start: float, *, standard: bool) -> StageSize | None:
    """Return the lightest size of a stage among modules from the least that does, searched both ways from a start.

    Args:
        task: The stage.
        start: Module to begin at [m].
        standard: Modules of ISO 54 alone.
    """
    sizes = [size for module in _modules(task, start, standard=standard) if (size := sized_at(task, module))]
    return smallest(sizes, lambda size: size.volume) if sizes else None


def _modules(task: StageTask, start: float, *, standard: bool) -> Iterator[float]:
    """Yield the least module that does at its widest face, and the next larger ones [m]."""
    if not standard:
        yield _least_module(task, start)
        return
    series = [value * _MM for value in STANDARD_MODULES]
    place = smallest(range(len(series)), lambda k: abs(math.log(series[k] / start)))
    while place > 0 and _does(task, series[place - 1]):
        place -= 1
    while place < len(series) - 1 and not _does(task, series[place]):
        place += 1
    yield from series[place : place + 1 + LARGER]


def _does(task: StageTask, module: float) -> bool:
    return task.governing(module, task.widest(module))[0] >= 1.0


def _least_module(task: StageTask, start: float) -> float:
    """Return the module at which the widest face just does [m]; the load that teeth bear grows with its cube."""
    low = high = start
    while _does(task, low):
        high, low = low, low / 1.2
    while not _does(task, high) and high < 1.0:
        low, high = high, high * 1.2
    while high / low - 1.0 > CLOSE:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if _does(task, middle) else (middle, high)
    return high
