"""A run on one screen: the verdict, ten key numbers, and nothing that a table says better."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.vibration import SpeedCase, dynamic_loads
from gearwright.render.tables.tables import written
from gearwright.render.words.headline import energy_text, headline, resonances
from gearwright.reviews import Review
from gearwright.sizing import Sizing
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.train import RATED
from gearwright.units import shown, text

LABEL = 20
"""Width of the names of numbers [characters]."""


def run_text(
    sizing: Sizing, modes: Modes, trace: Trace, *, review: Review | None = None, campbell: Sequence[SpeedCase] = ()
) -> str:
    """Return the verdict and the key numbers of a run as lines.

    Args:
        sizing: As sized.
        modes: Of its train.
        trace: A run of it.
        review: Of the design; None where the run was interrupted.
        campbell: Critical speeds that were looked at.
    """
    numbers = (*_sized(sizing), *_moved(sizing, modes, trace, campbell))
    lines = [f"{name:{LABEL}} {value}" for name, value in numbers]
    return "\n".join([sizing.design.name, "", *run_verdict(review, campbell), "", *lines])


def run_verdict(review: Review | None, campbell: Sequence[SpeedCase] = ()) -> tuple[str, ...]:
    """Return in sentences whether everything holds: the worst check first, then resonances.

    Args:
        review: Of the design; None where the run was interrupted.
        campbell: Critical speeds that were looked at.
    """
    said = [f"{headline(review)[:1].upper()}{headline(review)[1:]}."] if review is not None else []
    return (*said, *(f"In resonance: {words}." for words in resonances(campbell)))


def _sized(sizing: Sizing) -> Iterator[tuple[str, str]]:
    masses = (("gears", sizing.gear_mass), ("shafts", sizing.shaft_mass), ("carriers", sizing.carrier_mass))
    parts = ", ".join(f"{what} {text(mass, 'mass')}" for what, mass in masses if mass)
    flow, box = sizing.flows[RATED], envelope(sizing)
    yield "mass", f"{text(sizing.mass, 'mass')} ({parts})"
    yield "power", f"{text(sizing.rated_power, 'power')}, {text(sizing.power_density, 'specific_power')}"
    speeds = [f"{machine.name} {abs(shown(flow.speeds[machine.shaft], 'speed')):.0f}" for machine in sizing.machines]
    yield "speeds", f"{', '.join(speeds)} rpm"
    yield "teeth", ", ".join(f"{gear.name} {gear.teeth}" for gear in sizing.gears)
    sides = " x ".join(f"{shown(side, 'length'):.0f}" for side in (box.width, box.height, box.length))
    yield "envelope", f"{sides} mm, without housing"


def _moved(
    sizing: Sizing, modes: Modes, trace: Trace, campbell: Sequence[SpeedCase]
) -> Iterator[tuple[str, str]]:  # fmt: skip
    yield "minimum margin", f"{sizing.worst_margin:.3f} at the rated loads"
    lowest = next((float(frequency) for frequency, _ in modes.groups() if frequency > 0.0), None)
    if lowest is not None:
        yield "lowest frequency", f"{text(lowest, 'frequency')}, of {len(modes.frequency) - modes.rigid} modes"
    excited = [critical for case in campbell for critical in case.critical if critical.excited]
    if excited:
        near = min(excited, key=lambda critical: abs(critical.margin))
        yield "nearest resonance", f"{near.margin:+.1%} of the speed: {near.order} meets mode {near.mode}"
    loads = dynamic_loads(sizing, trace)
    if loads:
        peak = max(loads, key=lambda load: load.peak_over_mean)
        yield "peak over mean", f"{written(peak.peak_over_mean, 3)} in the teeth of {peak.mesh}"
    yield "energy book", f"closes {energy_text(trace.work.imbalance)} over {trace.duration:.4g} s"
