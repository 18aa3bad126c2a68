"""Tables of Modes, of a Trace and of a train's vibration, and simulated peaks beside rated loads."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from typing import Annotated

import numpy as np

from gearwright.base import Energy, Force, Frequency, Origin, Quantity, Speed, Torque, place_of_largest
from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.assembly import Assumption
from gearwright.dynamics.motion import Error
from gearwright.dynamics.vibration import (
    SWING,
    CriticalSpeed,
    DynamicLoad,
    Response,
    RunUp,
    SpeedCase,
    dynamic_loads,
    loudest_speeds,
    peaks,
)
from gearwright.render.grid import Table, table
from gearwright.sizing import Sizing
from gearwright.sizing.rating import METHODS

# ----------------------------------------------------------------------------------------------------------------------
# What a reader wants to know of a train's dynamics beside modes and forces, as tables.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Critical:
    """One critical speed, in words."""

    order: str
    mode: str
    frequency: Frequency
    """[Hz]"""
    speed: Speed
    """Of the first machine's shaft [rad/s]."""
    separation_margin: Annotated[float, Quantity("percent"), Origin("n_op/n − 1", "definition")]
    """n_op/n − 1 of operating speed n_op and critical speed n [-]."""
    limit: Annotated[float | None, Quantity("percent"), Origin("|n_op/n − 1|", "ISO 6336-1, clause 6; API 617")]
    """Least of its amount [-]; none where no criterion is made for the order."""
    dynamic_force: Annotated[float, Quantity("percent"), Origin("q = φᵀf/(2 ζ ω²)", "first order, at resonance")]
    """Amplitude over mean [-]."""
    verdict: str


@dataclass(frozen=True)
class ByMachine:
    """One critical speed of an order that no line makes, in words."""

    order: str
    why: str
    mode: str
    frequency: Frequency
    """[Hz]"""
    speed: Speed
    """Of the first machine's shaft [rad/s]."""
    separation_margin: Annotated[float, Quantity("percent"), Origin("n_op/n − 1", "definition")]
    """n_op/n − 1 of operating speed n_op and critical speed n [-]."""
    limit: Annotated[float | None, Quantity("percent"), Origin("|n_op/n − 1|", "ISO 6336-1, clause 6; API 617")]
    """Least of its amount [-]; none where no criterion is made for the order."""
    dynamic_force: Annotated[float, Quantity("percent"), Origin("q = φᵀf/(2 ζ ω²)", "first order, at resonance")]
    """Amplitude over mean, of an assumed swing [-]."""
    verdict: str


_DEFINED = (
    "n: critical speed of the first machine's shaft; n_op: its operating speed; f: damped frequency at n. In resonance:"
    " the separation margin n_op/n − 1 is less than the limit, whatever its sign."
)


def critical_table(speeds: SpeedCase, *, maximum: int = 25) -> Table:
    """Return the critical speeds of one set of speeds, worst first.

    Args:
        speeds: From `critical_speeds`.
        maximum: Rows at most, but for those in resonance, which are all there; what is not excited stands last.
    """
    rows, maximum = critical_rows(speeds.critical), _shown(speeds.critical, maximum)
    note = (
        f"{_DEFINED} The limit of a mesh frequency and its multiples is that of ISO 6336-1, clause 6, of a shaft's"
        " turning that of API 617. Dynamic force: estimated amplitude of the worst mesh force at the resonance over its"
        f" mean, from the stiffness variation and errors of the design.{_left_out(len(rows), maximum)}"
    )
    fields = ("order", "mode", "frequency", "speed", "separation_margin", "limit", "dynamic_force", "verdict")
    return table(f"Critical speeds, case {speeds.cases}", rows[:maximum], fields, note=note)


def machine_table(speeds: SpeedCase, *, maximum: int = 25) -> Table:
    """Return the critical speeds of blades, poles, slots, teeth and planets that pass, worst first.

    Args:
        speeds: From `critical_speeds`.
        maximum: Rows at most, but for those in resonance, which are all there; what is not excited stands last.
    """
    rows, maximum = machine_rows(speeds), _shown(speeds.assumed, maximum)
    note = (
        f"{_DEFINED} The limit is that of API 617; what comes less than once in a turn of any shaft, as hunting teeth"
        " do, has none. Nobody states how hard they shake: dynamic force is what follows if"
        f" {100.0 * SWING:g} % of the mean torque of the machine, or of the force of one mesh, swings."
        f"{_left_out(len(rows), maximum)}"
    )
    fields = ("order", "why", "mode", "frequency", "speed", "separation_margin", "limit", "dynamic_force", "verdict")
    return table(f"Orders of machines, teeth and planets, case {speeds.cases}", rows[:maximum], fields, note=note)


def _shown(criticals: Sequence[CriticalSpeed], maximum: int) -> int:
    """Return how many rows a table shows: those in resonance at least."""
    within = [place for place, critical in enumerate(criticals, 1) if critical.excited and critical.in_resonance]
    return max(maximum, *within[-1:], 0)


def _left_out(rows: int, maximum: int) -> str:
    """Return how many rows a table does not show, as the last sentence of its note."""
    return f" {rows - maximum} more are left out." if rows > maximum else ""


def machine_rows(speeds: SpeedCase) -> tuple[ByMachine, ...]:
    """Return the critical speeds of orders that no line makes in words, worst first.

    Args:
        speeds: From `critical_speeds`.
    """
    return tuple(ByMachine(critical.order, critical.why, *_met(critical)) for critical in speeds.assumed)


def critical_rows(critical_speeds: Sequence[CriticalSpeed]) -> tuple[Critical, ...]:
    """Return critical speeds in words, in their order.

    Args:
        critical_speeds: Of one set of speeds.
    """
    return tuple(Critical(critical.order, *_met(critical)) for critical in critical_speeds)


def _met(critical: CriticalSpeed) -> tuple[str, float, float, float, float | None, float, str]:
    """Return the mode that is met, its frequency and speed, separation margin, limit, dynamic force and verdict."""
    limit = None if critical.criterion is None else critical.criterion.limit
    return (
        critical.mode, critical.frequency, critical.speed, critical.separation_margin, limit,
        critical.dynamic_force, _verdict(critical),
    )  # fmt: skip


def _verdict(critical: CriticalSpeed) -> str:
    if not critical.excited:
        return "not excited"
    if critical.criterion is None:
        return "no criterion"
    return "in resonance" if critical.in_resonance else "clear"


def assumption_table(listed: Sequence[Assumption]) -> Table:
    """Return what the dynamic model rests on.

    Args:
        listed: From `assumptions`.
    """
    return table("Assumptions of the dynamic model", listed, ("subject", "value", "origin", "path"))


def peak_table(response: Response, lines: Sequence[str], *, excited: str, maximum: int = 12) -> Table:
    """Return the highest peaks of a frequency response.

    Args:
        response: Of the train.
        lines: Whose forces count.
        excited: What excites, in which case.
        maximum: Rows at most.
    """
    rows = peaks(response, lines)
    note = f"Amplitudes along the line of action, the highest first.{_left_out(len(rows), maximum)}"
    return table(f"Peaks: {excited}", rows[:maximum], ("line", "frequency", "force"), note=note)


def excited_by(row: str, error: float, case: str) -> str:
    """Return what excites a response: ``transmission error of 1 µm in first.sun-planet, case rated``.

    Args:
        row: Mesh row whose teeth err.
        error: Amplitude [m].
        case: Load case.
    """
    return f"transmission error of {error * 1e6:g} µm in {row}, case {case}"


def loudest_table(run_up: RunUp, speed: float, *, case: str) -> Table:
    """Return for each line the speed at which its force swings most, and the order that does it.

    Args:
        run_up: Speeds and spectra.
        speed: Operating speed of the first machine's shaft [rad/s].
        case: Load case.
    """
    worst = Error(float(np.max(run_up.error)), float(np.max(run_up.rms_error)))
    note = (
        "Swing: root mean square of the force about its mean F_m over the window of steady running T,"
        " √(1/T ∫ (F − F_m)² dt); order: what has the largest amplitude there. Steady running at each speed with the"
        f" torques of the case; {worst.words()}, at the worst speed."
    )
    note = " ".join([note, *(f"{less[0].upper()}{less[1:]}." for less in run_up.notes)])
    return table(
        f"Loudest speeds, case {case}",
        loudest_speeds(run_up, speed),
        ("line", "speed", "swing", "mean", "order"),
        note=note,
    )


# ----------------------------------------------------------------------------------------------------------------------
# What a reader wants to see of Modes and of a Trace, as tables.
# ----------------------------------------------------------------------------------------------------------------------


ALONG = "Mesh forces act along the line of action; F_t = F cos α_t."
"""What tells simulated mesh forces from the tangential ones of the sizing."""


@dataclass(frozen=True)
class Mode:
    """One natural frequency."""

    number: str
    """Of the mode, or of the first and last that share the frequency."""
    frequency: Frequency
    """[Hz]"""
    highest_kinetic_energy: str
    """Coordinate of the largest kinetic energy."""
    highest_strain_energy: str
    """Line of the largest share of the elastic energy."""
    energy: Annotated[float, Quantity("percent"), Origin("½ k δ² of the line over that of all", "K φ = ω² M φ")]
    """That line's share [-]."""


@dataclass(frozen=True)
class LineForce:
    """Force of one mesh or support over the time of the statistics."""

    name: str
    mean: Force
    """[N]"""
    minimum: Force
    """[N]"""
    maximum: Force
    """[N]"""
    rms: Force
    """[N]"""
    peak_to_peak: Force
    """[N]"""


@dataclass(frozen=True)
class LineTorque:
    """Torque of one shaft over the time of the statistics."""

    name: str
    mean: Torque
    """[N m]"""
    minimum: Torque
    """[N m]"""
    maximum: Torque
    """[N m]"""
    rms: Torque
    """[N m]"""
    peak_to_peak: Torque
    """[N m]"""


@dataclass(frozen=True)
class EnergyBook:
    """Where the energy of a run came from and went."""

    driven: Energy
    """[J]"""
    braked: Energy
    """[J]"""
    dissipated: Energy
    """[J]"""
    stored: Energy
    """[J]"""
    imbalance: float
    """[-]"""


def mode_table(modes: Modes, *, case: str = "", maximum: int = 30) -> Table:
    """Return natural frequencies with what moves and what is strained.

    Args:
        modes: As found.
        case: Load case, if they are of a design.
        maximum: Modes that are listed at most.
    """
    rows = mode_rows(modes)
    left = f" {len(rows) - maximum} higher ones are left out." if len(rows) > maximum else ""
    note = f"{modes.rigid} rigid. Undamped, at the mean stiffness.{left}"
    fields = ("number", "frequency", "highest_kinetic_energy", "highest_strain_energy", "energy")
    return table(f"Natural frequencies{f', case {case}' if case else ''}", rows[:maximum], fields, note=note)


def mode_rows(modes: Modes) -> list[Mode]:
    """Return a row for every natural frequency, the lowest first.

    Args:
        modes: As found.
    """
    rows, first = [], 0
    for frequency, count in modes.groups():
        rows.append(_mode(modes, frequency, first, count))
        first += count
    return rows


def _mode(modes: Modes, frequency: float, first: int, count: int) -> Mode:
    number = str(first + 1) if count == 1 else f"{first + 1}–{first + count}"
    strain = np.mean(modes.line_energy[:, first : first + count], axis=1)
    if frequency == 0.0:
        return Mode(number, frequency, "rigid", "none", 0.0)
    motion = np.sum(modes.shapes[:, first : first + count] ** 2, axis=1)
    holds = place_of_largest(strain)
    moves = modes.labels.coordinates[place_of_largest(motion)]
    return Mode(number, frequency, moves, modes.labels.lines[holds], float(strain[holds]))


def motion_tables(trace: Trace) -> tuple[Table, ...]:
    """Return the statistics of forces and of torques, over all bins together; nothing where there are none.

    Args:
        trace: As simulated.
    """
    if not trace.force.bins:
        return ()
    fields = ("name", "mean", "minimum", "maximum", "rms", "peak_to_peak")
    span = f"From every step between {trace.force.edges[0]:.4g} and {trace.force.edges[-1]:.4g} s."
    tables = (
        table("Forces", line_forces(trace), fields, note=f"{span} {ALONG}"),
        table("Shaft torques", line_torques(trace), fields, note=span),
    )
    return tuple(listed for listed in tables if listed.rows)


def line_forces(trace: Trace) -> tuple[LineForce, ...]:
    """Return the statistics of every mesh and support over all bins together; none where there are no bins.

    Args:
        trace: As simulated.
    """
    return tuple(LineForce(*statistics) for statistics in _statistics(trace, "m"))


def line_torques(trace: Trace) -> tuple[LineTorque, ...]:
    """Return the statistics of every shaft over all bins together; none where there are no bins.

    Args:
        trace: As simulated.
    """
    return tuple(LineTorque(*statistics) for statistics in _statistics(trace, "rad"))


def _statistics(trace: Trace, deflects_in: str) -> Iterator[tuple[str, float, float, float, float, float]]:
    """Yield name, mean, minimum, maximum, rms and peak-to-peak of the lines that deflect in m or in rad."""
    for name, unit in zip(trace.labels.lines, trace.labels.line_units, strict=True):
        if unit == deflects_in and trace.force.bins:
            mean, minimum, maximum, rms = trace.force.whole(name)
            yield name, mean, minimum, maximum, rms, maximum - minimum


def energy_table(trace: Trace) -> Table:
    """Return the energy balance of a run.

    Args:
        trace: As simulated.
    """
    return table("Energy", [energy_book(trace)], ("driven", "braked", "dissipated", "stored", "imbalance"))


def energy_book(trace: Trace) -> EnergyBook:
    """Return where the energy of a run came from and went.

    Args:
        trace: As simulated.
    """
    work = trace.work
    return EnergyBook(work.driven, work.braked, work.dissipated, work.stored, work.imbalance)


# ----------------------------------------------------------------------------------------------------------------------
# Simulated peaks beside the rated loads as a table.
# ----------------------------------------------------------------------------------------------------------------------


_NOTE = (
    "Tangential peak of the worst line of each mesh row over its simulated mean, and over the force it is sized for:"
)


def dynamic_table(sizing: Sizing, trace: Trace) -> Table:
    """Return the peaks as a table.

    Args:
        sizing: As sized.
        trace: A run of it.
    """
    names = tuple(field.name for field in fields(DynamicLoad))
    return table("Peaks beside rated loads", dynamic_loads(sizing, trace), names, note=_note(sizing))


def _note(sizing: Sizing) -> str:
    """Return what the force is that each mesh is sized for, by its method."""
    methods = {name: METHODS[name] for name in dict.fromkeys(mesh.rating.method for mesh in sizing.meshes) if name}
    forces = [f"{f'F_t {method.peaks}'.rstrip()} by {method.edition}" for method in methods.values()]
    return f"{_NOTE} {', '.join(forces)}; a margin below 1 there asks for a larger safety."
