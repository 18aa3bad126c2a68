"""Answers about what shakes a train: critical speeds, frequency response, run-ups, load sharing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from gearwright.dynamics.assembly import Assumption
from gearwright.dynamics.sharing import Allocation, Distribution, SharingStudy
from gearwright.dynamics.vibration import Loudest, Peak, SpeedCase
from gearwright.render.tables.dynamics import ByMachine, Critical, critical_rows, machine_rows
from gearwright.units import Angle, Length, Quantity, Ratio, Speed

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
