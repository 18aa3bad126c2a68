"""A value as a prompt shows it in a few lines, and as a notebook shows it with a table and a figure."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from html import escape
from importlib import import_module
from types import MappingProxyType
from typing import Any

import numpy as np

from gearwright.base import DesignError, Problem, margin_text, text
from gearwright.render import style as theme
from gearwright.render.grid import MARKS, Table
from gearwright.render.pages.page import environment
from gearwright.render.tables.checks import review_tables
from gearwright.render.tables.sizing import chosen_teeth, gear_table
from gearwright.train import build_train

# ----------------------------------------------------------------------------------------------------------------------
# A value in a few lines, as a prompt shows it: what it is, its key numbers with units, what to do next.
# ----------------------------------------------------------------------------------------------------------------------


FIRST = 6
"""Names, rows or frequencies that are written out."""
LONGEST = 100
"""Characters of a name that are written out."""


def short(value: Any) -> str:
    """Return a value in a few lines.

    Args:
        value: Of any verb; one without lines of its own shows its plain fields.
    """
    kind = type(value).__name__
    return "\n".join(_LINES.get(kind, _plain)(value))


def _plain(value: Any) -> Iterator[str]:
    """Yield the fields of any record: plain values as they are, of the others their kind and size."""
    names = [field.name for field in fields(value)] if is_dataclass(value) else list(type(value).model_fields)
    told = [f"{name} {_field(getattr(value, name))}" for name in names]
    yield f"{type(value).__name__}: {', '.join(told)}"


def _field(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, str):
        return repr(str(value)[:LONGEST])
    if value is None or isinstance(value, int):
        return str(value)
    if isinstance(value, np.ndarray):
        return f"[{' × '.join(map(str, value.shape))}]"
    return f"({len(value)})" if hasattr(value, "__len__") else f"({type(value).__name__})"


def _listed(names: Any) -> str:
    """Return the first names, and how many more there are."""
    known = list(names)
    more = f" and {len(known) - FIRST} more" if len(known) > FIRST else ""
    return f"{', '.join(map(str, known[:FIRST]))}{more}"


def _design(design: Any) -> Iterator[str]:
    yield f"Design {design.name[:LONGEST]!r}: shafts {_listed(design.shafts)}; stages {_listed(design.stages)}"
    powers = {name: text(machine.power, "power") for name, machine in (design.turbines | design.motors).items()}
    yield f"machines {_listed(f'{name} {power}' for name, power in powers.items())}"
    yield "next: gw.size(design), gw.review(design), gw.edited(design, {path: value})"


def _sizing(sizing: Any) -> Iterator[str]:
    yield (
        f"Sizing {sizing.design.name[:LONGEST]!r}: {text(sizing.mass, 'mass')} without housing, "
        f"{text(sizing.rated_power, 'power')} rated, worst margin {margin_text(sizing.worst_margin, 4)}"
    )
    yield f"teeth {_listed(f'{gear} {teeth}' for gear, teeth in sizing.teeth.items())}; cases {_listed(sizing.flows)}"
    yield from filter(None, [chosen_teeth(sizing)])
    yield "next: gw.review(sizing.design), gw.assemble(sizing, case), gw.fly(sizing, mission), gw.report(sizing)"


def _scene(scene: Any) -> Iterator[str]:
    triangles = sum(len(scene.surfaces[node.surface].triangles) for node in scene.nodes if node.surface)
    solids = f"{len(scene.nodes)} bodies, {triangles} triangles"
    yield f"Scene {scene.name[:LONGEST]!r}: {solids}; cases {_listed(scene.cases)}"
    yield f"bodies {_listed(scene.by_name)}; {len(scene.approximations)} approximations"
    yield "next: scene.by_name[name], scene.approximations, gearwright.shape.scene(scene)"


def _sizings(sizings: Any) -> Iterator[str]:
    refused = len(sizings.reasons)
    yield f"Sizings: {len(sizings)} designs of {len(sizings.structures)} structures, {refused} refused"
    yield f"columns {_listed(sizings.columns)}"
    yield from (f"row {row}: {reason[: 2 * LONGEST]}" for row, reason in list(sizings.reasons.items())[:2])
    yield "next: sizings.columns[name], sizings.at(row), sizings.reasons"


def _system(system: Any) -> Iterator[str]:
    yield str(system)
    yield "next: gw.modes(system), gw.campbell(system), gw.simulate(system, duration)"


def _short_modes(modes: Any) -> Iterator[str]:
    groups = [f"{frequency:.1f}" + (f" (×{count})" if count > 1 else "") for frequency, count in modes.groups()]
    yield f"Modes: {len(modes.frequency)}, {modes.rigid} rigid; natural frequencies {_listed(groups[:])} Hz"
    yield "next: modes.frequency, modes.shapes, modes.line_energy, gw.campbell(system)"


def _short_trace(trace: Any) -> Iterator[str]:
    stopped = ", interrupted" if trace.interrupted else ""
    yield f"Trace: {trace.duration:g} s by {trace.method}, step {trace.step:.3g} s{stopped}"
    yield _right_to(trace)
    yield f"lines {_listed(trace.labels.lines)}"
    yield from (note[: 3 * LONGEST] for note in trace.notes[:3])
    yield "next: trace.force.of(line), trace.samples.force(line), trace.to_xarray(), gw.save(trace, 'run.nc')"


def _right_to(result: Any) -> str:
    """Return how right forces are, the least right of many."""
    from gearwright.dynamics.motion import Error

    return Error(float(np.max(result.error)), float(np.max(result.rms_error))).words()


def _orbit(orbit: Any) -> Iterator[str]:
    stable = "stable" if orbit.stable else "not stable"
    largest = float(np.max(np.abs(orbit.multipliers), initial=0.0))
    yield f"Orbit: period {orbit.period:.6g} s in {len(orbit.samples.time) - 1} steps, {stable}"
    yield f"largest multiplier {largest:.6g}, right to {orbit.multiplier_error:.1e}; {_right_to(orbit)}"
    yield from (note[: 3 * LONGEST] for note in orbit.notes)
    yield "next: orbit.samples.force(line), orbit.multipliers"


def _ensemble(many: Any) -> Iterator[str]:
    yield f"Ensemble: {len(many.rms)} trajectories, step {many.step:.3g} s; lines {_listed(many.labels.lines)}"
    yield from _of_all(many)
    yield "next: many.of(line)"


def _speed_map(swept: Any) -> Iterator[str]:
    forces = swept.forces
    yield f"SpeedMap: {len(swept.factor)} speeds, step {forces.step:.3g} s; lines {_listed(forces.labels.lines)}"
    yield from _of_all(forces)
    yield "next: swept.swing(line), swept.forces.of(line)"


def _run_up(swept: Any) -> Iterator[str]:
    yield f"RunUp: {len(swept.factor)} speeds, {len(swept.orders)} orders; lines {_listed(swept.lines)}"
    yield from _of_all(swept)
    yield "next: swept.amplitude, swept.order_amplitude, gw.figure(swept)"


def _of_all(many: Any) -> Iterator[str]:
    yield f"in the worst of them {_right_to(many)}"
    yield from (note[: 3 * LONGEST] for note in many.notes[:3])
    if len(many.notes) > 3:
        yield f"and {len(many.notes) - 3} more that are less accurate than asked"


def _window(window: Any) -> Iterator[str]:
    yield f"DynamicWindow {window.name[:LONGEST]!r}: {window.rules.phase}, event {window.rules.event}"
    yield from _short_trace(window.trace)


def _samples(samples: Any) -> Iterator[str]:
    time, labels = samples.time, samples.labels
    span = f", {time[0]:g} to {time[-1]:g} s" if len(time) else ""
    yield f"Samples: {len(time)} instants{span}; {len(labels.coordinates)} coordinates; lines {_listed(labels.lines)}"


def _short_campbell(campbell: Any) -> Iterator[str]:
    factor = campbell.factor
    yield (
        f"Campbell: {campbell.frequency.shape[1]} modes at {len(factor)} speeds, {factor[0]:g} to {factor[-1]:g} of "
        f"the operating ones; {len(campbell.orders)} orders, {len(campbell.crossings)} crossings"
    )
    yield f"first crossings at {_listed(f'{crossing.factor:.3f}' for crossing in campbell.crossings)} of the speed"
    yield "next: campbell.crossings, campbell.margins(), campbell.to_dataframe(), gw.figure(campbell)"


def _speed_case(case: Any) -> Iterator[str]:
    yield f"SpeedCase {case.cases}: {len(case.critical)} critical speeds, the worst first"
    for critical in case.critical[:3]:
        margin = f"separation margin {critical.separation_margin:+.1%}"
        yield f"{critical.order}, mode {critical.mode}: {critical.frequency:.1f} Hz, {margin}"
    yield "next: case.critical, case.campbell, gw.simulate(case.system, duration)"


def _short_flight(flight: Any) -> Iterator[str]:
    yield (
        f"Flight of {flight.mission.name[:LONGEST]!r}: {flight.duration / 60.0:.1f} min, "
        f"{flight.distance / 1e3:.1f} km, fuel {flight.fuel:.2f} kg, gearbox efficiency {flight.efficiency():.4f}"
    )
    yield f"phases {_listed(flight.mission.phases)}; windows {_listed(flight.mission.windows) or 'none'}"
    yield "next: gw.durability(flight), gw.window(flight, name), flight.to_dataframe()"


def _review(review: Any) -> Iterator[str]:
    yield f"Review {review.design[:LONGEST]!r}: {review.verdict}; {len(review.checks)} checks"
    yield f"{len(review.failing)} fail, {len(review.waived)} waived, {len(review.open)} not assessed"
    if review.worst is not None:
        yield f"worst: {review.worst.name}, margin {margin_text(review.worst.margin or 0.0, 4)}"
    yield "next: review.failing, review.open, review.checks"


def _short_table(table: Any) -> Iterator[str]:
    counts = f"{len(table.rows)} rows, {len(table.failed)} failed"
    yield f"Table {table.name[:LONGEST]!r}: {counts}; varies {_listed(table.free) or 'the design'}"
    for name in table.numbers[:FIRST]:
        values = [row.shown(name) for row in table.good]
        yield f"{name} {min(values):.4g} to {max(values):.4g} {table.unit(name)}".rstrip()
    yield "next: table.column(result), table.to_dataframe(), gw.figure(table)"


_LINES: Mapping[str, Callable[[Any], Iterator[str]]] = MappingProxyType(
    {
        "Campbell": _short_campbell, "Design": _design, "DynamicWindow": _window, "Ensemble": _ensemble,
        "Flight": _short_flight,
        "Modes": _short_modes, "Orbit": _orbit, "Review": _review, "RunUp": _run_up, "Samples": _samples,
        "Sizing": _sizing,
        "Scene": _scene, "Sizings": _sizings,
        "SpeedCase": _speed_case, "SpeedMap": _speed_map, "System": _system, "Table": _short_table,
        "Trace": _short_trace,
    }
)  # fmt: skip
"""Type -> its lines; by name, so that a design is shown without loading dynamics."""


# ----------------------------------------------------------------------------------------------------------------------
# A value as a notebook shows it: its few lines, a table and a figure. A value without a figure is words alone.
# ----------------------------------------------------------------------------------------------------------------------


_TABLE = '{% import "macros.html.j2" as macros with context %}{{ macros.show(table) }}'


def figure(value: object) -> theme.Drawing:
    """Return the figure of a value: skeleton of a design, Campbell diagram, forces of a run, power of a flight.

    Args:
        value: Design, Sizing, Modes, Campbell, SpeedCase, Trace, Flight or Table.

    Raises:
        DesignError: If there is none of its type.
    """
    kind = type(value).__name__
    if kind not in _FIGURES:
        message = f"of a value of type {kind} there is no figure; give one of {', '.join(_FIGURES)}"
        raise DesignError([Problem("value", message)], "figure")
    return _FIGURES[kind](value)


def html(value: object) -> str:
    """Return a value as HTML for a notebook.

    Args:
        value: Of any verb.
    """
    kind = type(value).__name__
    parts = [f"<pre>{escape(short(value))}</pre>"]
    tables = _TABLES[kind](value) if kind in _TABLES else ()
    parts += [_table(table) for table in ((tables,) if isinstance(tables, Table) else tables) if table.rows]
    if kind in _FIGURES:
        parts.append(theme.to_svg(_FIGURES[kind](value), f"{kind}-{id(value)}"))
    return "\n".join(parts)


def _table(table: Table) -> str:
    return environment().from_string(_TABLE).render(table=table, marks=MARKS)


def _late(module: str, name: str) -> Callable[[Any], Any]:
    """Return a function of a module of this room, which is loaded when a value is shown."""
    return lambda value: getattr(import_module(f"gearwright.render.{module}"), name)(value)


_SCHEMATIC, _DIAGRAM = _late("schematic", "schematic_figure"), _late("figures.dynamics", "diagram_figure")
_FIGURES: Mapping[str, Callable[[Any], theme.Drawing]] = MappingProxyType(
    {
        "Design": lambda design: _SCHEMATIC(build_train(design)), "Sizing": _SCHEMATIC,
        "Modes": _late("figures.motion", "mode_figure"), "Trace": _late("figures.motion", "time_figure"),
        "Campbell": _DIAGRAM, "SpeedCase": lambda speeds: _DIAGRAM(speeds.campbell),
        "Flight": _late("figures.flights", "power_figure"), "Table": _late("figures.study", "study_figure"),
    }
)  # fmt: skip
"""Type -> its figure."""
_TABLES: Mapping[str, Callable[[Any], Table | tuple[Table, ...]]] = MappingProxyType(
    {
        "Sizing": gear_table, "Modes": _late("tables.dynamics", "mode_table"),
        "Trace": _late("tables.dynamics", "motion_tables"), "SpeedCase": _late("tables.dynamics", "critical_table"),
        "Flight": _late("tables.flights", "phase_table"), "Review": lambda review: review_tables(review.checks),
    }
)  # fmt: skip
"""Type -> its tables."""
