"""Results of the verbs beside size, by name: ``modes.…`` and ``simulate.…``."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from gearwright.dynamics import Outputs, modes, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.vibration import critical_speeds
from gearwright.sizing import Named, Sizing
from gearwright.spec import Simulated

LISTED = 6
"""Natural frequencies that have a name."""
START = 0.25
"""Share of a simulated time that is left to the start [-]."""


def modal_results(sizing: Sizing) -> dict[str, Named]:
    """Return natural frequencies and critical speeds by name.

    Args:
        sizing: What was sized.

    Returns:
        ``modes.frequency_1`` … the lowest natural frequencies of the governing load case [Hz];
        ``modes.lowest_critical_speed``, of the first machine's shaft, of all load cases [rad/s];
        ``modes.critical_margin``: least separation margin of all that a review judges, |n/n_crit − 1| [-].
        Infinite where nothing is excited in the range that is looked at.
    """
    elastic = [frequency for frequency in modes(assemble(sizing)).frequency if frequency > 0.0]
    results = {
        f"modes.frequency_{k}": Named(float(frequency), "frequency")
        for k, frequency in enumerate(elastic[:LISTED], start=1)
    }
    cases = critical_speeds(sizing)
    excited = [crossing for case in cases for crossing in case.critical if crossing.excited]
    lowest = min((crossing.speed for crossing in excited), default=math.inf)
    judged = [crossing for case in cases for crossing in case.nearest]
    nearest = min((abs(crossing.separation_margin) for crossing in judged), default=math.inf)
    return {
        **results,
        "modes.lowest_critical_speed": Named(lowest, "speed"),
        "modes.critical_margin": Named(nearest, "ratio"),
    }


def simulated_results(sizing: Sizing, asked: Simulated) -> dict[str, Named]:
    """Return the forces of a simulated load case by name.

    Args:
        sizing: What was sized.
        asked: Load case and time.

    Returns:
        ``simulate.LINE.largest`` and ``.mean`` of every line's force or torque, and ``simulate.LINE.factor``, the
        largest over the mean [-]; ``simulate.largest_factor`` of all lines that carry a mean force. Of a pair with
        parallel meshes ``simulate.PAIR.share``, the largest share of the mean load that one of them carries, and
        ``simulate.PAIR.factor``, the largest force of one of them over an equal share [-].
    """
    system = assemble(sizing, asked.case)
    trace = simulate(system, asked.duration, outputs=Outputs(start=START * asked.duration)).whole()
    force, results, factors = trace.force, dict[str, Named](), [1.0]
    for k, line in enumerate(force.names):
        kind = "torque" if trace.labels.line_units[k] == "rad" else "force"
        largest = float(np.max(np.abs([force.minimum[:, k], force.maximum[:, k]])))
        mean = float(abs(np.mean(force.mean[:, k])))
        results[f"simulate.{line}.largest"] = Named(largest, kind)
        results[f"simulate.{line}.mean"] = Named(mean, kind)
        if mean > 1e-9 * largest:
            factors.append(largest / mean)
            results[f"simulate.{line}.factor"] = Named(factors[-1], "ratio")
    return {**results, "simulate.largest_factor": Named(max(factors), "ratio"), **dict(_shared(sizing, results))}


def _shared(sizing: Sizing, results: Mapping[str, Named]) -> Iterator[tuple[str, Named]]:
    """Yield how the parallel meshes of a pair share its load."""
    for stage in sizing.design.pairs:
        lines = [f"simulate.{mesh.name}" for mesh in sizing.train.meshes if mesh.stage == stage]
        means = [float(results[f"{line}.mean"].value) for line in lines]
        if len(lines) > 1 and sum(means) > 0.0:
            largest = max(float(results[f"{line}.largest"].value) for line in lines)
            yield f"simulate.{stage}.share", Named(max(means) / sum(means), "ratio")
            yield f"simulate.{stage}.factor", Named(largest * len(lines) / sum(means), "ratio")
