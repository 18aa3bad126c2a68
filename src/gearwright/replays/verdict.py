"""What becomes of a published claim."""

from __future__ import annotations

from enum import StrEnum


class Verdict(StrEnum):
    """What becomes of a claim."""

    HOLDS = "holds"
    CONDITION = "holds with condition"
    FAILS = "does not hold"
