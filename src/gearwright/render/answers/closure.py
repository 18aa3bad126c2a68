"""The answer of a closure: what is met, what is not, lives, masses, the rounds to it and the design as a text."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gearwright.closure import Closed, Contradiction, Outcome, Round, StageLife, Tried, Unmet, Variants
from gearwright.render.answers.review import Factor, ReviewedCheck, reviewed_check
from gearwright.spec.text import design_text
from gearwright.study.running.equal_life import EqualLife
from gearwright.units import Life, Mass


@dataclass(frozen=True)
class UnmetRequirement:
    """A requirement that no freedom meets."""

    requirement: str
    check: ReviewedCheck
    """The best that was found."""
    kept: str
    """What the design gives and the closure does not change; empty where nothing."""
    helps: str


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


def close_answer(
    closed: Closed, variants: Variants | None = None, against: Sequence[Contradiction] = ()
) -> CloseAnswer:
    """Return what `gearwright close --json` answers.

    Args:
        closed: From `close`.
        variants: From `nearest_variant`; None where none were looked for.
        against: From `contradictions`.
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
        design_file=design_text(closed.design),
        variant=None
        if nearest is None
        else VariantAnswer(nearest.what, nearest.closed.whole.total, design_text(nearest.closed.design)),
        tried=() if variants is None else variants.tried,
        contradictions=tuple(against),
    )


def _unmet(unmet: Unmet) -> UnmetRequirement:
    return UnmetRequirement(unmet.requirement, reviewed_check(unmet.check), unmet.kept, unmet.helps)


@dataclass(frozen=True)
class EqualLifeAnswer:
    """Designs closed for one life."""

    life_asked: Life
    rows: tuple[EqualLife, ...]
    """The lightest that meet everything first."""
