"""A run on one screen: the verdict, ten key numbers, and nothing that a table says better."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.vibration import SpeedCase, dynamic_loads
from gearwright.render.words.headline import energy_text, headline, sizing_headline
from gearwright.render.words.masses import complete_words, train_mass
from gearwright.reviews import Review
from gearwright.sizing import Sizing
from gearwright.sizing.arrangement.envelope import envelope
from gearwright.units import shown, text, written

LABEL = 20
"""Width of the names of numbers [characters]."""


def run_text(
    sizing: Sizing,
    modes: Modes,
    traces: Mapping[str, Trace],
    *,
    review: Review | None = None,
    campbell: Sequence[SpeedCase] = (),
) -> RenderableType:
    """Return the verdict and the key numbers of a run, one below the other.

    Args:
        sizing: As sized.
        modes: Of its train.
        traces: Load case -> run of it.
        review: Of the design; None where the run was interrupted.
        campbell: Critical speeds that were looked at.
    """
    numbers = (*_sized(sizing), *_moved(modes, traces, campbell), *_peaks(sizing, traces))
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
    yield "train as sized" if complete else "mass", train_mass(sizing)
    yield "power", f"{text(sizing.rated_power, 'power')}, {text(sizing.power_density, 'specific_power')}"
    speeds = [f"{machine.name} {abs(shown(flow.speeds[machine.shaft], 'speed')):.0f}" for machine in sizing.machines]
    yield "speeds", f"{', '.join(speeds)} rpm{f', case {flow.case}' if len(sizing.flows) > 1 else ''}"
    yield "teeth", ", ".join(f"{gear.name} {gear.teeth}" for gear in sizing.gears)
    sides = " x ".join(f"{shown(side, 'length'):.0f}" for side in (box.width, box.height, box.length))
    yield "envelope", f"{sides} mm, without housing"


def _moved(modes: Modes, traces: Mapping[str, Trace], campbell: Sequence[SpeedCase]) -> Iterator[tuple[str, str]]:
    lowest = next((float(frequency) for frequency, _ in modes.groups() if frequency > 0.0), None)
    if lowest is not None:
        yield "lowest frequency", f"{text(lowest, 'frequency')}, of {len(modes.frequency) - modes.rigid} modes"
    judged = [critical for case in campbell for critical in case.nearest]
    if judged:
        near = min(judged, key=lambda critical: critical.over_limit)
        above = "above" if near.separation_margin > 0.0 else "below"
        apart = f"the gearbox runs {abs(near.separation_margin):.1%} {above} it"
        yield "nearest resonance", f"{near.order} meets mode {near.mode}; {apart}"
    for case, trace in traces.items():
        closes = f"closes {energy_text(trace.work.imbalance)} over {trace.duration:.4g} s"
        yield "energy balance", f"{closes}, case {case}"


def _peaks(sizing: Sizing, traces: Mapping[str, Trace]) -> Iterator[tuple[str, str]]:
    for case, trace in traces.items():
        if loads := dynamic_loads(sizing, trace):
            peak = max(loads, key=lambda load: load.peak_over_mean)
            words = f"{written(peak.peak_over_mean, 3)} in the teeth of {peak.mesh}, case {case}"
            yield "peak over mean", words
