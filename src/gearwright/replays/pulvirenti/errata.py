"""What Pulvirenti (2023) prints wrong, and what it claims: data, with the evidence and the place of the right formula.

The errata say which equation, why it is wrong, and which function of gearwright has the right one. The claims are the
printed side only; `gearwright.replays.pulvirenti.claims` computes the other.
"""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

SOURCE = "Pulvirenti 2023"
STANDINGS = ("wrong", "incomplete", "approximate", "text", "right")
"""``text``: words, not a formula; ``right``: doubted, and found right."""
EVIDENCE = ("provable", "public source", "general knowledge", "scan")
"""``provable``: by dimension, balance or geometry; ``scan``: the misprint may be that of the scanned text."""


@dataclass(frozen=True)
class Erratum:
    """One passage that cannot be used as it is printed, or that was doubted and holds."""

    equation: str
    """Number of the equation, or page."""
    standing: str
    """One of `STANDINGS`."""
    printed: str
    """What stands there, shortened."""
    correct: str
    """What is right."""
    why: str
    evidence: tuple[str, ...]
    """Some of `EVIDENCE`."""
    used: tuple[str, ...]
    """Functions below ``gearwright`` that have the right one; empty where nothing rests on it."""
    proof: tuple[str, ...]
    """Tests below ``tests/verification`` that show it; empty where the reason is plain or rests on a source."""


@dataclass(frozen=True)
class PrintedClaim:
    """What the thesis says of its gearboxes, and what its wording covers."""

    key: str
    place: str
    """Section or figure."""
    printed: str
    """The claim, in other words."""
    counts: str
    """What number it is about."""
    other: str
    """Second way to count, where the claim hangs on it; else empty."""
    dimension: str
    """Of the number, a key of the shown units."""
    low: float
    """Least value that the wording covers, in the unit that is shown."""
    high: float
    """Greatest value that the wording covers, in the unit that is shown."""
    why: str
    """Reason of the outcome; numbers in braces are filled in from the computation."""

    def covers(self, value: float) -> bool:
        """Tell whether the wording covers a number.

        Args:
            value: In the unit that is shown.
        """
        return self.low <= value <= self.high


@cache
def errata() -> tuple[Erratum, ...]:
    """Return the errata in the order of the equations."""
    return tuple(
        Erratum(
            **{key: row[key] for key in ("equation", "standing", "printed", "correct", "why")},
            evidence=tuple(row["evidence"]),
            used=tuple(row["used"]),
            proof=tuple(row["proof"]),
        )
        for row in _rows("errata")
    )


@cache
def printed_claims() -> tuple[PrintedClaim, ...]:
    """Return what the thesis claims, in the order of its chapters."""
    return tuple(PrintedClaim(**{"other": "", "high": math.inf, **row}) for row in _rows("claims"))


def _rows(name: str) -> list[dict[str, Any]]:
    text = files("gearwright.replays.pulvirenti").joinpath(f"data/{name}.toml").read_text(encoding="utf-8")
    rows: list[dict[str, Any]] = tomllib.loads(text)[name]
    return rows
