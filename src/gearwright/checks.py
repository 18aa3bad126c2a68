"""A check: one property of one part held against its limit. Every judgement on a gearbox is a list of them.

Whoever checks (a rating method, a shaft, a flight) yields this record, so that all pages show the same list, the same
worst entry and the same verdict.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from operator import attrgetter
from typing import Annotated

from gearwright.errors import Problem, near
from gearwright.identity import PartId
from gearwright.units import Endless, Quantity

ROUNDING = 1e-9
"""Of a value over its limit that counts as rounding [-]."""
NOT_ASSESSED = 6
"""Group behind all that is assessed, in the order of `worst_first` [-]."""
BEYOND_SIZING = (
    "peak bending",
    "peak contact",
    "resonance of",
    "pitting life",
    "bending life",
    "bearing life",
    "bearing static safety",
    "speed factor",
    "room for its bearing",
    "charge",
    "axial retention",
    "fatigue at its",
    "yield at its",
    "running clearance",
    "wheel that grinds it",
    "plate through its ring",
    "assembly",
    "access to a nut",
    "access to a screw",
    "bridges between planets",
    "webs of bosses",
    "shell fatigue",
    "wall fatigue",
    "web fatigue",
    "collar fatigue",
    "mount fatigue",
    "arm fatigue",
    "overhaul interval",
    "ring seat pressure",
    "seal speed",
    "seal temperature",
    "seal seat",
    "seal hardness",
)
"""How the modes begin that only a review, a run or a flight judges: a sizing knows no check of them."""


class Status(StrEnum):
    """What came of a check."""

    PASSES = "passes"
    FAILS = "fails"
    NOT_ASSESSED = "not assessed"


@dataclass(frozen=True)
class Check:
    """One property of one part against its limit."""

    part: PartId
    mode: str
    """What could go wrong, in words that are the same in every design: ``pitting``, ``static safety``."""
    clause: str
    """Standard and clause, or source."""
    value: Annotated[float | None, Endless()]
    """As computed, in SI; None where it is not assessed."""
    limit: Annotated[float | None, Endless()]
    """What is allowed, in SI; None where nothing is asked."""
    dimension: str = "ratio"
    """Of value and limit."""
    at_most: bool = False
    """True where the limit is the largest allowed value, False where it is the least."""
    exponent: float | None = 1.0
    """Power p of the load with which `ratio` falls [-]: 1 for safeties, 3 or 10/3 for lives of bearings; None where no
    load moves it, as for room and resonance."""
    symbol: str = ""
    """Such as ``S_H``."""
    place: str = ""
    """Where on the part, such as ``shoulder at bearing 1a``."""
    case: str = ""
    """Load case or phase of a flight that governs; empty where no single one does."""
    why: str = ""
    """Why it is not assessed, or what else to know."""
    waiver: str = ""
    """Reason for which the design accepts what fails; empty where it does not."""

    @property
    def name(self) -> str:
        """What a waiver calls it: ``first.sun pitting``."""
        return f"{self.part} {self.mode}"

    @property
    def what(self) -> str:
        """Mode, symbol and place, as tables show them: ``fatigue n_f, shoulder at bearing 1a``."""
        return ", ".join(text for text in (f"{self.mode} {self.symbol}".strip(), self.place) if text)

    @cached_property
    def ratio(self) -> float | None:
        """Value over limit, or limit over value where less is better [-]: 1 is just enough; None if not assessed."""
        if self.value is None or self.limit is None:
            return None
        over, under = (self.limit, self.value) if self.at_most else (self.value, self.limit)
        return over / under if under else math.inf

    @cached_property
    def reserve(self) -> float | None:
        """Factor by which the loads could grow [-], 1 is just enough; None where that says nothing.

        A safety against a stress counts as it is; a life L of which L_asked is asked as (L/L_asked)^(1/p).
        """
        ratio = self.ratio
        return None if ratio is None or self.exponent is None else ratio ** (1.0 / self.exponent)

    @property
    def margin(self) -> Annotated[float | None, Quantity("ratio")]:
        """Reserve, or the ratio to its limit where no load moves it [-]: 1 is just enough; None if not assessed."""
        return self.ratio if self.reserve is None else self.reserve

    @property
    def status(self) -> Status:
        """Whether it passes."""
        ratio = self.ratio
        if ratio is None:
            return Status.NOT_ASSESSED
        return Status.PASSES if ratio >= 1.0 - ROUNDING else Status.FAILS

    @property
    def fails(self) -> bool:
        """Whether it fails and no waiver accepts that."""
        return self.status is Status.FAILS and not self.waiver

    @cached_property
    def rank(self) -> tuple[int, float, str, str]:
        """Its place in a list: a group, and what orders it there."""
        ratio, reserve = self.ratio, self.reserve
        if ratio is None:
            return NOT_ASSESSED, 0.0, str(self.part), self.mode
        group = 2 if self.waiver else 4 if ratio >= 1.0 - ROUNDING else 0
        margin = ratio if reserve is None else reserve
        return group + (reserve is None), round(margin or 0.0, 9), str(self.part), self.what


_rank = attrgetter("rank")


def stressed(part: PartId, mode: str, clause: str, stress: float, margin: float, *, case: str) -> Check:
    """Return the check of a stress of which the margin to its allowable is known.

    Args:
        part: That bears it.
        mode: What could go wrong.
        clause: Standard and clause, or source.
        stress: As computed [Pa].
        margin: Allowable over actual, the asked factor included [-]; infinite where nothing loads the part.
        case: Load case that governs.
    """
    limit = stress * margin if math.isfinite(margin) else math.inf
    return Check(part, mode, clause, stress, limit, "stress", at_most=True, case=case)


def not_assessed(part: PartId, mode: str, clause: str, why: str) -> Check:
    """Return what is left open, and why.

    Args:
        part: Whose property it would be.
        mode: What could go wrong.
        clause: Standard and clause, or source.
        why: Why nothing can be said, and what would help.
    """
    return Check(part, mode, clause, None, None, why=why)


def worst_first(checks: Iterable[Check]) -> tuple[Check, ...]:
    """Return checks in the order in which an engineer wants to read them.

    What fails comes first, by its reserve and then, where no load moves it, by its ratio; waived failures stand before
    what passes, in the same order; what is not assessed comes last.

    Args:
        checks: In any order.
    """
    return tuple(sorted(checks, key=_rank))


def worst(checks: Iterable[Check]) -> Check | None:
    """Return the entry that every page shows as the worst; None where nothing is assessed.

    Args:
        checks: In any order.
    """
    assessed = [check for check in checks if check.ratio is not None and not check.waiver]
    return min(assessed, key=_rank, default=None)


def lacking_of(checks: Iterable[Check]) -> float:
    """Return what failing checks lack of their limits together [-].

    Args:
        checks: That fail; one without a margin lacks all of it.
    """
    return sum(1.0 - (check.margin or 0.0) for check in checks)


def accepted(checks: Iterable[Check], waivers: Mapping[str, str]) -> tuple[Check, ...]:
    """Return checks with the reasons for which a design accepts what fails, in the order of `worst_first`.

    Args:
        checks: In any order.
        waivers: Name of a check -> reason.
    """
    return worst_first(
        replace(check, waiver=waivers.get(check.name, "")) if check.status is Status.FAILS else check
        for check in checks
    )


def unneeded(checks: Iterable[Check], waivers: Mapping[str, str]) -> tuple[str, ...]:
    """Return the waivers of what is assessed and passes.

    Args:
        checks: Of the gearbox.
        waivers: Name of a check -> reason.
    """
    assessed = {check.name: False for check in checks if check.status is not Status.NOT_ASSESSED}
    assessed |= {check.name: True for check in checks if check.status is Status.FAILS}
    return tuple(name for name in waivers if assessed.get(name) is False)


def unknown_waivers(checks: Iterable[Check], waivers: Mapping[str, str], *, left: Iterable[str] = ()) -> list[Problem]:
    """Return the waivers whose check there is not, each with the nearest.

    Args:
        checks: Of the gearbox.
        waivers: Name of a check -> reason.
        left: How the modes begin that somebody else judges.
    """
    names = sorted({check.name for check in checks})
    return [
        Problem(f"waivers.{name}", f"there is no such check; {near(name, names)}")
        for name in waivers
        if name not in names and not any(f" {mode}" in name for mode in left)
    ]
