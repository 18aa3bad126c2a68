"""Results of a review by name: ``review.…``."""

from __future__ import annotations

import math

from gearwright.mission import Flight, durability
from gearwright.reviews import Review, review_of
from gearwright.sizing import TEXT, Named, Sizing


def review_results(sizing: Sizing, flight: Flight | None = None, *, life: float | None = None) -> dict[str, Named]:
    """Return what a review says, by name.

    Args:
        sizing: As sized.
        flight: Of it, where the study flies.
        life: Of gears that the study asks for [s].

    Returns:
        ``review.verdict`` and ``review.worst`` (the worst check) as texts, ``review.margin`` (its margin) and
        ``review.failing`` (checks that fail and are not waived).
    """
    lives = durability(flight) if flight is not None else None
    return named_review(review_of(sizing, flight, lives, life=life))


def named_review(reviewed: Review) -> dict[str, Named]:
    """Return a review by the names of its results.

    Args:
        reviewed: Of a design.
    """
    first = reviewed.worst
    margin = math.inf if first is None or first.margin is None else first.margin
    return {
        "review.verdict": Named(str(reviewed.verdict), TEXT),
        "review.worst": Named("" if first is None else first.name, TEXT),
        "review.margin": Named(margin, "ratio"),
        "review.failing": Named(float(len(reviewed.failing)), "number"),
    }
