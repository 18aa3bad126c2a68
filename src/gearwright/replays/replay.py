"""Replications of published work: their register, and the verdict on each claim."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gearwright.render.pages.motion import Paper
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# What becomes of a published claim.
# ----------------------------------------------------------------------------------------------------------------------


class Verdict(StrEnum):
    """What becomes of a claim."""

    HOLDS = "holds"
    CONDITION = "holds with condition"
    FAILS = "does not hold"


# ----------------------------------------------------------------------------------------------------------------------
# A replay: published work held against what gearwright computes; each folder here registers its own.
# ----------------------------------------------------------------------------------------------------------------------


_REGISTERED: dict[str, Replay] = {}
REPLAYS: Mapping[str, Replay] = MappingProxyType(_REGISTERED)
"""Name -> replay, in alphabetical order."""


@dataclass(frozen=True)
class Replay:
    """Published work that is replayed."""

    name: str
    """Of its folder and its command."""
    title: str
    """Author, year and subject."""
    paper: Callable[[Sizing], Paper | None] | None = None
    """What it adds to the page on load sharing of a design of its kind."""


def register(replay: Replay) -> None:
    """Make a replay known.

    Args:
        replay: Whose name no other has.
    """
    if replay.name in _REGISTERED:
        raise ValueError(f"two replays are called {replay.name}")
    _REGISTERED[replay.name] = replay


def paper_on(sizing: Sizing) -> Paper | None:
    """Return what the first replay that knows such a design adds to its page on load sharing; None if none does.

    Args:
        sizing: Of any design.
    """
    adding = (replay.paper(sizing) for replay in REPLAYS.values() if replay.paper is not None)
    return next((paper for paper in adding if paper is not None), None)
