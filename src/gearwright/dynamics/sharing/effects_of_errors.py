"""Studies of load sharing by its closed form: which error matters, what chance makes of them all, how to clock.

Shares are those of the most loaded of n parallel lines, as a fraction of the load: 0.52 of two paths is 52/48.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.dynamics.equations import Redundancy
from gearwright.dynamics.model import Contact, System
from gearwright.dynamics.sharing.error_sources import ErrorSource, as_forces, peak_shares, random_sets, unit_source
from gearwright.errors import DesignError, Problem
from gearwright.ranking import largest_first

SETS = 5000
"""Random sets of a study."""


@dataclass(frozen=True)
class Influence:
    """What one error alone does to the sharing."""

    source: str
    """Part and kind."""
    kind: str
    """Of the error."""
    size: float
    """Of the error [m or rad]."""
    turns: bool
    """True if its effect comes and goes with a shaft, False if it stays."""
    effect: float
    """Largest change of a sharing coefficient b that it causes [-]."""
    gain: float
    """The same for each unit of error [1/m or 1/rad]."""


def influences(train: Redundancy, sources: Sequence[ErrorSource], lines: Ints) -> tuple[Influence, ...]:
    """Return what every error does alone, the largest first.

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
    """
    gains = effect_gains(train, sources, lines)
    effects = [
        Influence(
            source.name, source.kind, abs(source.size), source.rate != 0.0, float(gain * abs(source.size)), float(gain)
        )
        for source, gain in zip(sources, gains, strict=True)
    ]
    return tuple(largest_first(effects, lambda influence: influence.effect))


def effect_gains(train: Redundancy, sources: Sequence[ErrorSource], lines: Ints) -> Floats:
    """Return the change of the most affected b for each unit of every error, in its worst direction [1/m or 1/rad].

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.

    Returns:
        Shape (sources,).
    """
    forces = as_forces(train, sources, lines)
    still = np.array([force.still for force in forces]).reshape(-1, 2, len(lines))
    turning = np.array([force.turning for force in forces]).reshape(-1, len(lines))
    scale = len(lines) / float(np.sum(train.perfect[lines]))
    return np.asarray(scale * np.max(np.linalg.norm(still, axis=1) + np.abs(turning), axis=1, initial=0.0))


@dataclass(frozen=True, eq=False)
class Distribution:
    """What chance makes of all errors together."""

    peak: Floats
    """Share of the most loaded line, at its worst moment, of each set [-], shape (sets,)."""
    seed: int
    """Of the random numbers."""

    def percentile(self, percent: float) -> float:
        """Return the share that so many percent of all gearboxes stay below [-].

        Args:
            percent: 0 to 100.
        """
        return float(np.percentile(self.peak, percent))


def monte_carlo(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, count: int = SETS, seed: int = 1
) -> Distribution:
    """Return the peak shares of many gearboxes whose errors have full size and random phases.

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
        count: Number of gearboxes.
        seed: Of the random numbers.
    """
    return Distribution(random_peaks(train, sources, lines, count=count, seed=seed), seed)


def random_peaks(
    train: Redundancy, sources: Sequence[ErrorSource], lines: Ints, *, count: int, seed: int,
    sizes: Floats | None = None,
) -> Floats:  # fmt: skip
    """Return the share of the most loaded line, at its worst moment, of many random gearboxes [-], shape (count,).

    Args:
        train: From `redundancy`.
        sources: Every single error.
        lines: Places of the n parallel lines.
        count: Number of gearboxes.
        seed: Of the random numbers.
        sizes: Of each error [m or rad]; left out: as given.
    """
    forces = random_sets(as_forces(train, sources, lines), count, seed=seed, sizes=sizes)
    return np.asarray(np.max(peak_shares(train.perfect[lines], forces), axis=1) / len(lines))


@dataclass(frozen=True)
class Clocking:
    """Angles between gears of one shaft that make the paths share equally."""

    angles: tuple[tuple[str, float], ...]
    """Gear -> angle on its shaft [rad], positive as it turns positively."""
    window: float
    """Half width of the angles that keep the target, all paths but one at their best [rad]."""
    target: float
    """Share that the window keeps [-]."""


def clocking_optimum(
    system: System, contacts: Sequence[Contact], train: Redundancy, lines: Ints, *, target: float = 0.53
) -> Clocking:
    """Return the clocking angles at which parallel paths share equally, and the window that keeps a share.

    Args:
        system: Whose paths they are.
        contacts: Its meshes in space.
        train: From `redundancy`, with the loads and the errors that stand left out.
        lines: Places of the n parallel lines.
        target: Largest share that is allowed [-].

    Source: clocking of split-path transmissions after Krantz & Delgado 1996, NASA TM-107202; here in closed form.
    """
    gears = _clocked(system, contacts, lines)
    units = [unit_source(system, contacts, gear, "clocking") for gear in gears]
    slopes = np.array([unit.still[0] @ train.gain[:, lines] for unit in units])
    total = float(np.sum(train.perfect[lines]))
    miss = total / len(lines) - train.perfect[lines]
    angles = np.linalg.lstsq(slopes.T, miss, rcond=None)[0]
    steepest = float(np.max(np.abs(slopes[-1]))) / total
    pairs = tuple((gear, float(angle)) for gear, angle in zip(gears, angles, strict=True))
    return Clocking(pairs, (target - 1.0 / len(lines)) / steepest, target)


def _clocked(system: System, contacts: Sequence[Contact], lines: Ints) -> list[str]:
    """Return the gear that each path but the first has of its own, so that turning it shifts the load."""
    names = [system.labels.lines[line] for line in lines]
    rows = [contact for contact in contacts if contact.line in names]
    common = set.intersection(*({side.gear for side in contact.sides} for contact in rows)) if rows else set()
    gears = [next(side.gear for side in contact.sides if side.gear not in common) for contact in rows]
    if len(gears) < 2:
        raise DesignError([Problem("lines", f"{names} are no parallel paths; name the meshes of one stage")])
    return gears[1:]
