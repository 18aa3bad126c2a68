"""What a page says first: the worst of all that it shows, peaks of a run and resonances included."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from gearwright.checks import worst
from gearwright.render.tables.checks import check_sentence
from gearwright.sizing import Sizing

if TYPE_CHECKING:
    from gearwright.dynamics import Trace
    from gearwright.dynamics.vibration import CriticalSpeed, SpeedCase
    from gearwright.reviews import Review

ROUNDING = 1e-15
"""Relative residual of an energy book below which nothing but rounding is left [-]."""


def headline(review: Review) -> str:
    """Return the verdict in one sentence that says no more than its worst entry.

    Args:
        review: Of a design.
    """
    first = review.worst
    said = f"{review.verdict}: the worst is {check_sentence(first)}" if first else "nothing is assessed"
    counts = {"fail": len(review.failing), "waived": len(review.waived), "not assessed": len(review.open)}
    return f"{said}; {', '.join(f'{count} {what}' for what, count in counts.items() if count or what == 'fail')}"


def sizing_headline(sizing: Sizing) -> str:
    """Return the worst of what a sizing checks, and who looks at the rest.

    Args:
        sizing: As sized.
    """
    first, count = worst(sizing.checks), len(sizing.checks)
    entry = check_sentence(first) if first is not None else "none is assessed"
    failing = sum(check.fails for check in sizing.checks)
    said = f"{failing} of {count} sizing checks fail" if failing else f"{count} sizing checks pass"
    return f"{said}, the worst: {entry}; peaks, resonances and lives: gearwright review"


def worst_margin(sizing: Sizing, trace: Trace | None = None) -> str:
    """Return the least margin of all checks, or the one at the peaks of a run where that is less.

    Args:
        sizing: As sized.
        trace: A run of it, if the page shows one.
    """
    rated = f"{sizing.worst_margin:.3f}"
    if trace is None:
        return rated
    from gearwright.dynamics.vibration import dynamic_loads

    loads = dynamic_loads(sizing, trace)
    if not loads:
        return rated
    first = loads[0]
    peak = min(first.bending_margin, first.contact_margin)
    if peak >= sizing.worst_margin:
        return rated
    kind = "bending" if peak == first.bending_margin else "contact"
    return f"{peak:.3f} ({kind} of {first.mesh} at its simulated peak; {rated} at the rated loads)"


def resonances(campbell: Sequence[SpeedCase]) -> tuple[str, ...]:
    """Return one sentence for each set of speeds that runs in a resonance: the nearest one, and how many there are.

    Args:
        campbell: Critical speeds that the page shows.
    """
    return tuple(words for case in campbell if (words := _resonance(case)))


def _resonance(case: SpeedCase) -> str:
    near = [critical for critical in case.critical if critical.excited and critical.in_resonance]
    if not near:
        return ""
    more = f", and {len(near) - 1} more" if len(near) > 1 else ""
    return f"{_distance(near[0])} (case {case.cases}){more}"


def _distance(critical: CriticalSpeed) -> str:
    side = "above" if critical.margin > 0.0 else "below"
    return f"{critical.order} meets mode {critical.mode} {abs(critical.margin):.2%} {side} the operating speed"


def energy_text(residual: float) -> str:
    """Return how well an energy book closes.

    Args:
        residual: What does not add up, over what goes in [-].

    >>> energy_text(0.0), energy_text(3.2e-7)
    ('to rounding', 'within 3.2e-07')
    """
    return f"within {residual:.1e}" if abs(residual) > ROUNDING else "to rounding"
