"""The answer of a review: one verdict, and every check with its value, its limit and the unit of both."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from gearwright.checks import Check, Status
from gearwright.identity import Kind
from gearwright.render.answers.plain import named
from gearwright.reviews import Review, Verdict
from gearwright.sizing.mass import CompleteMass, Statistics
from gearwright.units import Quantity, shown, unit

Factor = Annotated[float | None, Quantity("ratio")]


@dataclass(frozen=True)
class ReviewedCheck:
    """One property of one part against its limit."""

    name: str
    """Part and mode, as a waiver calls it."""
    part: str
    kind: Kind
    mode: str
    symbol: str
    place: str
    case: str
    """Load case or phase that governs; empty where no single one does."""
    source: str
    value: float | None
    """In the unit; null where it is infinite or not assessed."""
    limit: float | None
    """In the unit."""
    unit: str
    at_most: bool
    """True where the limit is the largest allowed value."""
    ratio: Factor
    """1 is just enough."""
    reserve: Factor
    """By which loads may grow; null where no load moves it."""
    status: Status
    waiver: str
    """Reason for which the design accepts it; empty where it does not."""
    why: str
    """Why it is not assessed, or what else to know."""


@dataclass(frozen=True)
class ReviewAnswer:
    """A design, and perhaps a mission, judged by every check."""

    mission: str
    """That was flown; empty without one."""
    verdict: Verdict
    worst: str | None
    """Name of the worst check; null where nothing is assessed."""
    margin: Factor
    """Of the worst check."""
    facts: Mapping[str, float | str]
    """What the design amounts to: name with its unit -> value."""
    complete_mass: CompleteMass
    """Part by part; machines are not in it."""
    statistics: Statistics
    """What real gearboxes of its power and speeds weigh."""
    checks: tuple[ReviewedCheck, ...]
    """The worst first."""
    unneeded_waivers: tuple[str, ...]
    """Waivers of what passes."""


def review_answer(review: Review) -> ReviewAnswer:
    """Return what `gearwright review --json` answers.

    Args:
        review: Of a design.
    """
    first = review.worst
    return ReviewAnswer(
        mission=review.mission,
        verdict=review.verdict,
        worst=None if first is None else first.name,
        margin=None if first is None else first.margin,
        facts=dict(named(review.facts)),
        complete_mass=review.complete,
        statistics=review.statistics,
        checks=tuple(reviewed_check(check) for check in review.checks),
        unneeded_waivers=tuple(review.unneeded),
    )


def reviewed_check(check: Check) -> ReviewedCheck:
    """Return a check with value and limit in the unit that people read.

    Args:
        check: Any.
    """
    value, limit = (None if number is None else shown(number, check.dimension) for number in (check.value, check.limit))
    return ReviewedCheck(
        name=check.name,
        part=str(check.part),
        kind=check.part.kind,
        mode=check.mode,
        symbol=check.symbol,
        place=check.place,
        case=check.case,
        source=check.clause,
        value=value,
        limit=limit,
        unit=unit(check.dimension),
        at_most=check.at_most,
        ratio=check.ratio,
        reserve=check.reserve,
        status=check.status,
        waiver=check.waiver,
        why=check.why,
    )
