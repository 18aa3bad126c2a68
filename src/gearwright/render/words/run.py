"""A run on one screen: the verdict, ten key numbers, and nothing that a table says better."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.vibration import SpeedCase, dynamic_loads
from gearwright.ranking import largest, smallest
from gearwright.render.grid.table import written
from gearwright.render.words.headline import energy_text, headline, sizing_headline
from gearwright.render.words.masses import complete_words, train_mass
from gearwright.reviews import Review
from gearwright.sizing import Sizing
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.units import shown, text

LABEL = 20
"""Width of the names of numbers [characters]."""


def run_text(
    sizing: Sizing, modes: Modes, trace: Trace, *, review: Review | None = None, campbell: Sequence[SpeedCase] = ()
) -> RenderableType:
    """Return the verdict and the key numbers of a run, one below the other.

    Args:
        sizing: As sized.
        modes: Of its train.
        trace: A run of it.
        review: Of the design; None where the run was interrupted.
        campbell: Critical speeds that were looked at.
    """
    numbers = (*_sized(sizing), *_moved(modes, trace, campbell), *_peaks(sizing, trace))
    grid = Table.grid(padding=(0, 1))
    grid.add_column(no_wrap=True, min_width=LABEL)
    grid.add_column()
    for name, value in numbers:
        grid.add_row(name, value)
    return Group(Text("\n".join([sizing.design.name, "", *run_verdict(sizing, review), ""])), grid)


def run_verdict(sizing: Sizing, review: Review | None) -> tuple[str, ...]:
    """Return in a sentence whether everything holds, with the worst check.

    Args:
        sizing: As sized.
        review: Of the design; None where the run was interrupted: sizing then speaks for itself.
    """
    said = sizing_headline(sizing) if review is None else headline(review)
    return (f"{said[:1].upper()}{said[1:]}.",)


def _sized(sizing: Sizing) -> Iterator[tuple[str, str]]:
    complete = complete_words(sizing)
    flow, box = sizing.reference, envelope(sizing)
    if complete:
        yield "complete mass", complete
    yield "mass of the train" if complete else "mass", train_mass(sizing)
    yield "power", f"{text(sizing.rated_power, 'power')}, {text(sizing.power_density, 'specific_power')}"
    speeds = [f"{machine.name} {abs(shown(flow.speeds[machine.shaft], 'speed')):.0f}" for machine in sizing.machines]
    yield "speeds", f"{', '.join(speeds)} rpm"
    yield "teeth", ", ".join(f"{gear.name} {gear.teeth}" for gear in sizing.gears)
    sides = " x ".join(f"{shown(side, 'length'):.0f}" for side in (box.width, box.height, box.length))
    yield "envelope", f"{sides} mm, without housing"


def _moved(modes: Modes, trace: Trace, campbell: Sequence[SpeedCase]) -> Iterator[tuple[str, str]]:
    lowest = next((float(frequency) for frequency, _ in modes.groups() if frequency > 0.0), None)
    if lowest is not None:
        yield "lowest frequency", f"{text(lowest, 'frequency')}, of {len(modes.frequency) - modes.rigid} modes"
    excited = [critical for case in campbell for critical in case.critical if critical.excited]
    if excited:
        near = smallest(excited, lambda critical: abs(critical.margin))
        yield "nearest resonance", f"{near.margin:+.1%} of the speed: {near.order} meets mode {near.mode}"
    yield "energy balance", f"closes {energy_text(trace.work.imbalance)} over {trace.duration:.4g} s"


def _peaks(sizing: Sizing, trace: Trace) -> Iterator[tuple[str, str]]:
    loads = dynamic_loads(sizing, trace)
    if loads:
        peak = largest(loads, lambda load: load.peak_over_mean)
        yield "peak over mean", f"{written(peak.peak_over_mean, 3)} in the teeth of {peak.mesh}"
