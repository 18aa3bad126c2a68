"""Answers of a review, a closure and an arrangement: checks with value and limit, what is met, lives, masses."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from gearwright.base import Check, Kind, Life, Mass, Quantity, Status, shown, unit
from gearwright.closure import (
    Arranged,
    BearingRound,
    Closed,
    ClosedArrangement,
    Contradiction,
    Eased,
    Effort,
    Outcome,
    Round,
    StageLife,
    Tried,
    Unmet,
    Variants,
)
from gearwright.mission.lives import Assumed, HousingSection, Upkeep
from gearwright.render.answers.schema import named
from gearwright.render.tables.arranged import (
    ArrangedBearing,
    ArrangedShaft,
    MassChange,
    Unborne,
    arranged_bearings,
    arranged_shafts,
    mass_changes,
    unborne,
)
from gearwright.reviews import Review, Verdict
from gearwright.sizing.mass import CompleteMass, Statistics
from gearwright.spec.edit import design_text
from gearwright.study.architectures import EqualLife

# ----------------------------------------------------------------------------------------------------------------------
# The answer of a review: one verdict, and every check with its value, its limit and the unit of both.
# ----------------------------------------------------------------------------------------------------------------------


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
    housing: tuple[HousingSection, ...]
    """What tires the housing, section by section, the least safe first."""
    housing_assumed: tuple[Assumed, ...]
    """What that rests on."""
    upkeep: tuple[Upkeep, ...]
    """Maintenance, the shortest interval first."""


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
        housing=review.housing,
        housing_assumed=review.housing_assumed,
        upkeep=review.upkeep,
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


# ----------------------------------------------------------------------------------------------------------------------
# The answer of a closure: what is met, what is not, lives, masses, the rounds to it and the design as a text.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class UnmetRequirement:
    """A requirement that nothing meets over which the closure searched."""

    requirement: str
    check: ReviewedCheck
    """The best that was found."""
    kept: str
    """What the design gives and the closure does not change; empty where nothing."""
    helps: str
    searched: str
    """Over what it was looked for."""


@dataclass(frozen=True)
class VariantAnswer:
    """The nearest variant that meets everything."""

    what: str
    """What was changed of what the design gives."""
    complete_mass: Mass
    design_file: str
    """The closed variant as TOML."""


@dataclass(frozen=True)
class CloseAnswer:
    """A design whose free sizes meet what its checks know, or what they do not meet."""

    outcome: Outcome
    worst: str | None
    """Name of the worst check."""
    margin: Factor
    """Of the worst check."""
    mass: Mass
    """Of gears, shafts and carriers."""
    complete_mass: Mass
    """With housing, bearings, oil and small parts."""
    complete_mass_from: Mass
    complete_mass_to: Mass
    """Its band."""
    life_asked: Life
    lives: tuple[StageLife, ...]
    """The shortest first."""
    unmet: tuple[UnmetRequirement, ...]
    kept: tuple[str, ...]
    """Paths of what the design gives and the closure does not change."""
    rounds: tuple[Round, ...]
    checks: tuple[ReviewedCheck, ...]
    """The worst first."""
    design_file: str
    """The closed design as TOML."""
    variant: VariantAnswer | None
    """None where the design closes, none was looked for, or none closes."""
    tried: tuple[Tried, ...]
    """Variants that do not close."""
    contradictions: tuple[Contradiction, ...] = ()
    """What stands against what is not met, where that was asked for."""
    effort: Effort | None = None
    """What it cost, and over what it searched."""
    changes_nothing: bool = False
    """Whether the design stands in its file as it is closed."""
    eased: VariantAnswer | None = None
    """The nearest in the same sizes, of which less is asked; None where the design closes, or none passes."""


def close_answer(
    closed: Closed,
    variants: Variants | None = None,
    against: Sequence[Contradiction] = (),
    easier: Eased | None = None,
) -> CloseAnswer:
    """Return what `gearwright close --json` answers.

    Args:
        closed: From `close`.
        variants: From `nearest_variant`; None where none were looked for.
        against: From `contradictions`.
        easier: From `eased`; None where there is none.
    """
    first, nearest = closed.worst, None if variants is None else variants.nearest
    return CloseAnswer(
        outcome=closed.outcome,
        worst=None if first is None else first.name,
        margin=None if first is None else first.margin,
        mass=closed.mass,
        complete_mass=closed.whole.total,
        complete_mass_from=closed.whole.band[0],
        complete_mass_to=closed.whole.band[1],
        life_asked=closed.design.service.life,
        lives=closed.lives,
        unmet=tuple(map(_unmet, closed.unmet)),
        kept=closed.kept,
        rounds=closed.rounds,
        checks=tuple(reviewed_check(check) for check in closed.checks),
        design_file=closed.text,
        variant=None
        if nearest is None
        else VariantAnswer(nearest.what, nearest.closed.whole.total, design_text(nearest.closed.design)),
        tried=() if variants is None else variants.tried,
        contradictions=tuple(against),
        effort=closed.effort,
        changes_nothing=closed.changes_nothing,
        eased=None if easier is None else VariantAnswer(easier.what, easier.mass, design_text(easier.design)),
    )


def _unmet(unmet: Unmet) -> UnmetRequirement:
    return UnmetRequirement(unmet.requirement, reviewed_check(unmet.check), unmet.kept, unmet.helps, unmet.searched)


@dataclass(frozen=True)
class EqualLifeAnswer:
    """Designs closed for one life."""

    life_asked: Life
    rows: tuple[EqualLife, ...]
    """The lightest that meet everything first."""


# ----------------------------------------------------------------------------------------------------------------------
# The answer of an arrangement: what fails, bearings, shafts, masses before and after, and the design as a text.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ArrangeAnswer:
    """A design whose shafts stand in bearings."""

    level: str
    """At which it was taken before."""
    worse: tuple[ReviewedCheck, ...]
    """What fails and did not before."""
    failing: tuple[ReviewedCheck, ...]
    """All that fails."""
    bearings: tuple[ArrangedBearing, ...]
    """Shaft by shaft."""
    shafts: tuple[ArrangedShaft, ...]
    unborne: tuple[Unborne, ...]
    """Shafts that were put into no bearings."""
    complete_mass: tuple[MassChange, ...]
    """By groups, their sum last."""
    design_file: str
    """The design as TOML."""
    rounds: tuple[BearingRound, ...] = ()
    """Gearboxes that were put into bearings, one after another; none where sizes are kept."""
    searched: tuple[str, ...] = ()
    """Freedoms that were moved with bearings in the gearbox, in words."""


def arrange_answer(arranged: Arranged, found: ClosedArrangement | None = None) -> ArrangeAnswer:
    """Return what `gearwright arrange --json` answers.

    Args:
        arranged: From `arrange`.
        found: From `close_arranged`; None where sizes are kept.
    """
    checks = arranged.sizing.checks if found is None else found.checks
    return ArrangeAnswer(
        level=arranged.before.design.level,
        worse=tuple(map(reviewed_check, arranged.worse)),
        failing=tuple(reviewed_check(check) for check in checks if check.fails),
        bearings=arranged_bearings(arranged),
        shafts=arranged_shafts(arranged),
        unborne=unborne(arranged),
        complete_mass=mass_changes(arranged),
        design_file=arranged.text,
        rounds=() if found is None else found.rounds,
        searched=() if found is None else found.searched,
    )
