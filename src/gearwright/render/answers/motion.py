"""Answers about motion: natural frequencies, a run, critical speeds, responses, run-ups, load sharing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

from gearwright.base import Angle, Force, Length, Number, Quantity, Ratio, Speed, Time, Torque
from gearwright.dynamics import Modes, Trace
from gearwright.dynamics.assembly import Assumption
from gearwright.dynamics.sharing import Allocation, Distribution, SharingStudy
from gearwright.dynamics.vibration import Loudest, Peak, SpeedCase
from gearwright.particulars import Particulars
from gearwright.render.answers.design import SizeAnswer, size_answer
from gearwright.render.tables.dynamics import (
    ByMachine,
    Critical,
    EnergyBook,
    LineForce,
    LineTorque,
    Mode,
    critical_rows,
    energy_book,
    line_forces,
    line_torques,
    machine_rows,
    mode_rows,
)

# ----------------------------------------------------------------------------------------------------------------------
# Answers about motion: natural frequencies, a simulated run and what follows from it.
# ----------------------------------------------------------------------------------------------------------------------


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


def run_answer(facts: Particulars, modes: Modes, traces: Mapping[str, Trace], *, verdict: tuple[str, ...]) -> RunAnswer:
    """Return what `gearwright run --json` answers.

    Args:
        facts: Of a sizing.
        modes: Of its train.
        traces: Load case -> run of it; the modes are those of the first.
        verdict: In sentences.
    """
    first = next(iter(traces))
    return RunAnswer(verdict, size_answer(facts), modes_answer(modes, first), simulate_answer(traces))


# ----------------------------------------------------------------------------------------------------------------------
# Answers about what shakes a train: critical speeds, frequency response, run-ups, load sharing.
# ----------------------------------------------------------------------------------------------------------------------


PERCENTILES = (50.0, 95.0, 99.0)


@dataclass(frozen=True)
class CriticalSpeeds:
    """Critical speeds of one set of speeds."""

    case: str
    """Load cases that run at it."""
    critical_speeds: tuple[Critical, ...]
    """The worst first."""
    orders_of_machines: tuple[ByMachine, ...]
    """Those of blades, poles, slots, teeth and planets that pass, the worst first; their strength is assumed."""


@dataclass(frozen=True)
class CampbellAnswer:
    """Critical speeds with their separation margins."""

    cases: tuple[CriticalSpeeds, ...]
    assumptions: tuple[Assumption, ...]
    """What the dynamic model rests on."""


def campbell_answer(cases: Iterable[SpeedCase], assumptions: Sequence[Assumption]) -> CampbellAnswer:
    """Return what `gearwright campbell --json` answers.

    Args:
        cases: From `critical_speeds`.
        assumptions: Of the dynamic model.
    """
    rows = (CriticalSpeeds(case.cases, critical_rows(case.critical), machine_rows(case)) for case in cases)
    return CampbellAnswer(tuple(rows), tuple(assumptions))


@dataclass(frozen=True)
class ResponseAnswer:
    """How mesh forces answer to a transmission error of one mesh row."""

    case: str
    mesh: str
    """Row whose teeth err."""
    error: Annotated[float, Quantity("length")]
    """Amplitude."""
    peaks: tuple[Peak, ...]
    """The highest first."""


@dataclass(frozen=True)
class RunUpAnswer:
    """Where each mesh is loudest."""

    case: str
    shaft: str
    """Whose speed is given: the first machine's."""
    speed: Speed
    """Its operating speed."""
    loudest: tuple[Loudest, ...]
    error: Ratio
    """Measured at the worst speed, of the peaks of line forces."""
    rms_error: Ratio
    """And of their root mean squares."""
    notes: tuple[str, ...]
    """Speeds that are less accurate than promised, and why."""


@dataclass(frozen=True)
class PathSharing:
    """One of several parallel paths."""

    path: str
    stated: Ratio | None
    """Share that the design states and sizing takes; null where it states none."""
    without_errors: Ratio
    """Share of the load, by stiffness alone."""
    minimum: Ratio
    """Over a tooth cycle, with the errors as given."""
    maximum: Ratio


@dataclass(frozen=True)
class ErrorInfluence:
    """What one error alone does."""

    error: str
    size: Length | None
    """Of an error in length."""
    angle: Angle | None
    """Of an error in angle."""
    turns: bool
    """True if it turns with its gear."""
    effect: Ratio
    """Change of the load factor of the most loaded path."""


@dataclass(frozen=True)
class RandomErrors:
    """Sharing of many gearboxes with random phases of their errors."""

    seed: int
    share_below: Mapping[str, Ratio]
    """Per cent of gearboxes -> share of the most loaded path that they stay below."""


@dataclass(frozen=True)
class Tolerance:
    """A tolerance as given and as allowed."""

    error: str
    given: Length | None
    allowed: Length | None
    given_angle: Angle | None
    allowed_angle: Angle | None


@dataclass(frozen=True)
class Tolerances:
    """How tight tolerances must be for a sharing that is asked for."""

    target: Ratio
    """Share of the most loaded path."""
    gearboxes: Annotated[float, Quantity("percent")]
    """That must keep it."""
    reached: Ratio
    """Share that the allowed sizes keep for that part of gearboxes."""
    cost: float
    """Σ given/allowed over all errors, less their number: 0 if nothing must be tightened."""
    tolerances: tuple[Tolerance, ...]


@dataclass(frozen=True)
class SharingAnswer:
    """How parallel paths share their load."""

    stage: str
    redundancies: int
    """Loops of the load in the train."""
    method: str
    reason: str
    """Why this method."""
    load_factor: Ratio
    """Mesh load factor K_γ."""
    paths: tuple[PathSharing, ...]
    influences: tuple[ErrorInfluence, ...]
    random: RandomErrors | None
    clocking: Mapping[str, Angle] | None
    """Gear -> angle that makes the sharing equal without errors."""
    clocking_window: Angle | None
    """Around it, within which the target is kept; null where every angle does."""
    allocation: Tolerances | None


def sharing_answer(study: SharingStudy) -> SharingAnswer:
    """Return what `gearwright sharing --json` answers.

    Args:
        study: From `sharing_study`.
    """
    problem, sharing = study.problem, study.sharing
    clocking = study.clocking
    return SharingAnswer(
        stage=problem.stage,
        redundancies=problem.train.count,
        method=sharing.method,
        reason=sharing.reason,
        load_factor=sharing.load_factor,
        paths=_paths(study),
        influences=tuple(
            ErrorInfluence(row.source, *_sized(row.kind, row.size), row.turns, row.effect) for row in study.influences
        ),
        random=_random(study.distribution) if study.distribution is not None else None,
        clocking=dict(clocking.angles) if clocking is not None else None,
        clocking_window=clocking.window if clocking is not None else None,
        allocation=_tolerances(study.allocation) if study.allocation is not None else None,
    )


def _paths(study: SharingStudy) -> tuple[PathSharing, ...]:
    problem, cycle = study.problem, study.sharing.tooth_cycle
    count = len(problem.lines)
    stated = problem.stated if problem.stated is not None else [None] * count
    rows = zip(problem.lines, stated, problem.perfect, cycle.min(axis=0), cycle.max(axis=0), strict=True)
    return tuple(PathSharing(path, said, *(float(share) / count for share in shares)) for path, said, *shares in rows)


def _sized(kind: str, size: float) -> tuple[float | None, float | None]:
    """Return the size of an error as a length or as an angle."""
    return (None, size) if kind == "clocking" else (size, None)


def _random(distribution: Distribution) -> RandomErrors:
    shares = {f"{percent:g}": distribution.percentile(percent) for percent in PERCENTILES}
    return RandomErrors(distribution.seed, shares)


def _tolerances(allocation: Allocation) -> Tolerances:
    rows = []
    for row in allocation.sizes:
        (given, given_angle), (allowed, allowed_angle) = _sized(row.kind, row.given), _sized(row.kind, row.allowed)
        rows.append(Tolerance(row.error, given, allowed, given_angle, allowed_angle))
    return Tolerances(
        allocation.target, allocation.percent / 100.0, allocation.reached, allocation.cost, tuple(rows)
    )  # fmt: skip
