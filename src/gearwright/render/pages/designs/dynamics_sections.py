"""Chapters of the report on dynamics: critical speeds, drawn mode shapes, transmission error and paths, assumptions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.dynamics import Modes, System, Trace
from gearwright.dynamics.assembly import assumptions
from gearwright.dynamics.vibration import SpeedCase, first_meshes
from gearwright.render.figures.dynamics import campbell_figure
from gearwright.render.figures.motion import every_step, mesh_frequencies
from gearwright.render.figures.paths import moving_centres, orbit_figure, phase_figure, transmission_error_figure
from gearwright.render.pages.page import Figure, Section, figure
from gearwright.render.schematic.mode_shapes import drawn_modes_figure
from gearwright.render.tables.dynamics import assumption_table, critical_table, machine_table
from gearwright.sizing import Sizing

MOST_DRAWN = 4
"""Mode shapes that are drawn on the train."""
MOST_PATHS = 6
"""Meshes or centres in one figure of paths."""


def dynamics_sections(
    sizing: Sizing,
    system: System,
    *,
    case: str,
    modes: Modes | None = None,
    trace: Trace | None = None,
    campbell: Sequence[SpeedCase] = (),
) -> tuple[Section, ...]:
    """Return the report's chapters on dynamics beside the tables of modes and forces, as far as there is something.

    Args:
        sizing: As sized.
        system: Assembled from it for the case.
        case: Load case of the run.
        modes: Of the system.
        trace: A run of the system.
        campbell: From `critical_speeds`.
    """
    sections = [
        _critical(sizing, campbell),
        _shapes(sizing, system, modes, campbell, case=case),
        _paths(sizing, system, trace, case),
        Section("Assumptions of the dynamic model", tables=(assumption_table(assumptions(sizing, system)),)),
    ]
    return tuple(section for section in sections if section.tables or section.figures)


def _critical(sizing: Sizing, campbell: Sequence[SpeedCase]) -> Section:
    caption = "Natural frequencies, orders and excited resonances against speed; separation margins of the nearest."
    figures = [figure(campbell_figure(sizing, case), f"campbell-{n}", caption) for n, case in enumerate(campbell)]
    tables = (*map(critical_table, campbell), *map(machine_table, campbell))
    return Section("Critical speeds", tables=tables, figures=tuple(figures))


def _shapes(
    sizing: Sizing, system: System, modes: Modes | None, campbell: Sequence[SpeedCase], *, case: str
) -> Section:
    """Draw the modes that are excited nearest to the operating speed, or the lowest ones if none is known."""
    if modes is None:
        return Section("Mode shapes")
    near = [critical.modes[0] for case in campbell for critical in case.nearest]
    lowest = list(range(modes.rigid + 1, len(modes.frequency) + 1))
    numbers = sorted(list(dict.fromkeys([*near, *lowest]))[:MOST_DRAWN])
    which = "Modes excited nearest to the operating speed" if near else "Lowest modes"
    caption = f"{which}, on the train, case {case}."
    drawing = drawn_modes_figure(sizing, system, modes, numbers=numbers)
    return Section("Mode shapes", figures=(figure(drawing, "drawn-modes", caption),))


def _paths(sizing: Sizing, system: System, trace: Trace | None, case: str) -> Section:
    samples = every_step(trace) if trace is not None else None
    if samples is None:
        return Section("Transmission error and paths")
    lines = first_meshes(sizing, system)
    centres = moving_centres(samples)[:MOST_PATHS]
    caption = f"Phase portraits of the meshes, case {case}: a closed curve repeats; the teeth part left of zero."
    figures = [
        *_errors(sizing, lines, trace, case),
        figure(phase_figure(samples, lines[:MOST_PATHS]), "phase", caption),
    ]
    if centres:
        caption = f"Paths of centres about their means, case {case}; of planetary sets in the frame of the carrier."
        figures.append(figure(orbit_figure(samples, centres), "orbits", caption))
    return Section("Transmission error and paths", figures=tuple(figures))


def _errors(sizing: Sizing, lines: Sequence[str], trace: Trace | None, case: str) -> Iterator[Figure]:
    """Yield one figure for each stage: its meshes share a mesh frequency."""
    samples, rates = every_step(trace) if trace is not None else None, mesh_frequencies(sizing, case)
    for stage in sizing.design.stages:
        rows = {mesh.name: line for mesh, line in zip(sizing.train.meshes, lines, strict=True) if mesh.stage == stage}
        meshes, rate = list(rows.values()), max(rates[row] for row in rows)
        if samples is not None and meshes and rate > 0.0:
            drawing = transmission_error_figure(samples, meshes, mesh_frequency=rate)
            yield figure(drawing, f"error-{_safe(stage)}", f"Dynamic transmission error of {stage}, case {case}.")


def _safe(stage: str) -> str:
    return "".join(letter if letter.isalnum() else "-" for letter in stage)
