"""What a page says first: the verdict of a review with its worst entry, or the worst that a sizing alone knows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearwright.checks import worst
from gearwright.render.tables.checks import check_sentence
from gearwright.sizing import Sizing
from gearwright.spec import Design, implied
from gearwright.spec.design import CONCEPT, PRELIMINARY, STATIC

if TYPE_CHECKING:
    from gearwright.reviews import Review

ROUNDING = 1e-15
"""Relative residual of an energy balance below which nothing but rounding is left [-]."""
FIRST = (
    f'First sizing by level = "{CONCEPT}", with no housing and no oil in its mass: gearwright size --level'
    f" {PRELIMINARY} counts them, rates gears against fatigue and gives planets bearings."
)
"""What is said of a design that states `level = "concept"`."""


def headline(review: Review) -> str:
    """Return the verdict in one sentence that says no more than its worst entry.

    Args:
        review: Of a design.
    """
    said = said_of(review)
    return f"{review.verdict}: {said}" if review.worst else said


def said_of(review: Review) -> str:
    """Return the worst entry and how many fail, without the verdict.

    Args:
        review: Of a design.
    """
    first = review.worst
    said = f"the worst is {check_sentence(first)}" if first else "nothing is assessed"
    counts = [f"{len(review.failing)} {_fail(len(review.failing))}"]
    beside = {"waived": len(review.waived), "not assessed": len(review.open)}
    return f"{said}; {', '.join(counts + [f'{count} {what}' for what, count in beside.items() if count])}"


def sizing_headline(sizing: Sizing) -> str:
    """Return the worst of what a sizing checks, with what helps where it fails, and who looks at the rest.

    Args:
        sizing: As sized.
    """
    first, left = worst(sizing.checks), sum(check.ratio is None for check in sizing.checks)
    count = len(sizing.checks) - left
    entry = check_sentence(first) if first is not None else "none is assessed"
    failing = sum(check.fails for check in sizing.checks)
    said = f"{failing} of {count} sizing checks {_fail(failing)}" if failing else f"{count} sizing checks pass"
    helps = f"; {first.why}" if first is not None and first.fails and first.why else ""
    unsaid = f"; {left} not assessed" if left else ""
    return f"{said}, the worst: {entry}{helps}{unsaid}; peaks, resonances and lives: gearwright review"


def implied_text(design: Design) -> str:
    """Return what a design takes by default at the level that it leaves open, or what a stated concept leaves out.

    One sentence; empty of a level that is stated and higher.

    Args:
        design: As read.
    """
    taken = implied(design)
    if "level" not in taken:
        return FIRST if design.level == CONCEPT else ""
    if design.level == CONCEPT:
        asks = f'its gears ask for {STATIC}; without that it is "{PRELIMINARY}", against fatigue'
        return f'By default level = "{CONCEPT}": {asks}.'
    sets = [name for name, one in design.planetaries.items() if "planet_bearing" not in one.model_fields_set]
    rated = f', gears.rating = "{taken["gears.rating"]}"' if "gears.rating" in taken else ""
    turning = f", bearings of the catalogue in planets of {', '.join(sets)}" if sets else ""
    return f'By default level = "{PRELIMINARY}"{rated}{turning}; level = "{CONCEPT}" is the first sizing without them.'


def _fail(count: int) -> str:
    """Return the verb of so many checks."""
    return "fails" if count == 1 else "fail"


def unneeded_text(name: str) -> str:
    """Return that a waiver is not needed.

    Args:
        name: Of the check.
    """
    return f"The waiver of {name} is not needed: it passes"


def energy_text(residual: float) -> str:
    """Return how well an energy balance closes.

    Args:
        residual: What does not add up, over what goes in [-].

    >>> energy_text(0.0), energy_text(3.2e-7)
    ('to rounding', 'within 3.2e-07')
    """
    return f"within {residual:.1e}" if abs(residual) > ROUNDING else "to rounding"
