"""Answers about motion: natural frequencies, a simulated run and what follows from it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from gearwright.dynamics import Modes, Trace
from gearwright.render.answers.design import SizeAnswer, size_answer
from gearwright.render.tables.motion import (
    EnergyBook,
    LineForce,
    LineTorque,
    Mode,
    energy_book,
    line_forces,
    line_torques,
    mode_rows,
)
from gearwright.sizing import Sizing
from gearwright.units import Force, Number, Ratio, Time, Torque


@dataclass(frozen=True)
class ModesAnswer:
    """Natural frequencies of a drive train, undamped, at the mean stiffness."""

    case: str
    rigid: int
    """Modes without a frequency: the train turns as a whole."""
    modes: tuple[Mode, ...]


def modes_answer(modes: Modes, case: str) -> ModesAnswer:
    """Return what `gearwright modes --json` answers.

    Args:
        modes: As found.
        case: Load case.
    """
    return ModesAnswer(case, modes.rigid, tuple(mode_rows(modes)))


@dataclass(frozen=True)
class SimulateAnswer:
    """A simulated run of a load case: statistics of every step, and where its energy went."""

    case: str
    method: str
    """Of integration."""
    duration: Time
    step: Time
    error: Ratio
    """Measured, of the peaks of line forces."""
    rms_error: Ratio
    """And of their root mean squares."""
    exponent: Number | None
    """Largest Lyapunov exponent where teeth part, about [1/s]; positive, the motion is chaotic."""
    interrupted: bool
    """True if the run was stopped before its end."""
    notes: tuple[str, ...]
    """What to know of the run."""
    forces: tuple[LineForce, ...]
    """Of meshes, along the line of action, and of supports."""
    torques: tuple[LineTorque, ...]
    """Of shafts."""
    energy: EnergyBook
    others: tuple[SimulateAnswer, ...] = ()
    """Runs of the other cases that fail, where no case is asked for."""


@dataclass(frozen=True)
class Instant:
    """A line of `--jsonl`: one instant of a run."""

    time: Time
    force: Mapping[str, Force]
    """Mesh or support -> its force."""
    torque: Mapping[str, Torque]
    """Shaft -> its torque."""


def simulate_answer(traces: Mapping[str, Trace]) -> SimulateAnswer:
    """Return what `gearwright simulate --json` answers.

    Args:
        traces: Load case -> run; one at least.
    """
    first, *others = (_simulated(case, trace) for case, trace in traces.items())
    return replace(first, others=tuple(others))


def _simulated(case: str, trace: Trace) -> SimulateAnswer:
    return SimulateAnswer(
        case=case,
        method=trace.method,
        duration=trace.duration,
        step=trace.step,
        error=trace.error,
        rms_error=trace.rms_error,
        exponent=trace.exponent,
        interrupted=trace.interrupted,
        notes=tuple(trace.notes),
        forces=line_forces(trace),
        torques=line_torques(trace),
        energy=energy_book(trace),
    )


def instants(trace: Trace) -> Iterator[Instant]:
    """Yield what is recorded of a run, instant by instant.

    Args:
        trace: As simulated.
    """
    lines = list(zip(trace.labels.lines, trace.labels.line_units, strict=True))
    for time, forces in zip(trace.samples.time, trace.samples.line_force, strict=True):
        of_lines = [(name, unit, float(force)) for (name, unit), force in zip(lines, forces, strict=True)]
        yield Instant(
            float(time),
            {name: force for name, unit, force in of_lines if unit == "m"},
            {name: force for name, unit, force in of_lines if unit != "m"},
        )


@dataclass(frozen=True)
class RunAnswer:
    """Everything of one design: what it weighs, how it vibrates, how it runs."""

    verdict: tuple[str, ...]
    """In sentences."""
    size: SizeAnswer
    modes: ModesAnswer
    simulate: SimulateAnswer


def run_answer(sizing: Sizing, modes: Modes, traces: Mapping[str, Trace], *, verdict: tuple[str, ...]) -> RunAnswer:
    """Return what `gearwright run --json` answers.

    Args:
        sizing: As sized.
        modes: Of its train.
        traces: Load case -> run of it; the modes are those of the first.
        verdict: In sentences.
    """
    first = next(iter(traces))
    return RunAnswer(verdict, size_answer(sizing), modes_answer(modes, first), simulate_answer(traces))
