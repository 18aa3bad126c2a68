"""The course of one closure: what it has looked at and what that cost, the best design so far, what a journal keeps."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from gearwright.base import GearwrightError
from gearwright.sizing import Sizing, size, size_unturned
from gearwright.spec import Design

if TYPE_CHECKING:
    from gearwright.closure.loop import Settled

# ----------------------------------------------------------------------------------------------------------------------
# What a closure has cost, and over what it searched.
# ----------------------------------------------------------------------------------------------------------------------


KEPT_EVERY = 2.0
"""Time between two writings of a journal [s]."""
Seen = tuple[float, ...]
"""What was found of a change, numbers alone; empty where it cannot be sized."""


@dataclass(frozen=True)
class Effort:
    """What a closure cost, and over what it searched."""

    sizings: int
    """Whole designs that were sized [-]."""
    looked_at: int
    """Changes of a design that were proportioned once [-]."""
    confirmed: int
    """Changes whose dynamic and load factors were settled [-]."""
    taken: int
    """Changes that were made [-]."""
    from_journal: int
    """Answers that a journal had already [-]."""
    starts: int
    """Designs from which the search began: it is local, and one start says nothing of the distance to the best [-]."""
    searched: tuple[str, ...]
    """Freedoms that were searched, in words."""
    not_searched: tuple[str, ...]
    """What could be changed, too, and was not looked at."""


@dataclass
class Course:
    """A closure on its way."""

    known: dict[str, Seen] = field(default_factory=dict)
    """Name of a change of a design -> what was found of it."""
    keep: Callable[[Mapping[str, Seen]], None] | None = None
    """Takes what is known, to be kept in a journal."""
    best: Settled | None = None
    """The best design so far."""
    sizings: int = 0
    looked_at: int = 0
    confirmed: int = 0
    taken: int = 0
    from_journal: int = 0
    starts: int = 0
    searched: dict[str, None] = field(default_factory=dict)
    """Freedoms that were searched, in words."""
    begun: frozenset[str] = frozenset()
    """Names of what a journal knew at the start."""
    kept_at: float = 0.0

    def __post_init__(self) -> None:
        self.begun = frozenset(self.known)

    def seen(self, name: str, found: Callable[[], Seen]) -> Seen:
        """Return what is known of a change, found once; empty where it cannot be sized.

        Args:
            name: Of the change and of the design that it changes.
            found: Finds it.
        """
        if name in self.known:
            self.from_journal += name in self.begun
            return self.known[name]
        try:
            self.known[name] = found()
        except GearwrightError:
            self.known[name] = ()
        if self.keep is not None and time.monotonic() - self.kept_at >= KEPT_EVERY:
            self.keep(self.known)
            self.kept_at = time.monotonic()
        return self.known[name]

    def effort(self, not_searched: tuple[str, ...]) -> Effort:
        """Return what it has cost.

        Args:
            not_searched: What could be changed, too.
        """
        return Effort(
            self.sizings, self.looked_at, self.confirmed, self.taken, self.from_journal, self.starts,
            tuple(self.searched), not_searched,
        )  # fmt: skip


_NOW: ContextVar[Course | None] = ContextVar("course", default=None)


@contextmanager
def under_way(course: Course) -> Iterator[Course]:
    """Let everything within count for a closure.

    Args:
        course: Of it.
    """
    token = _NOW.set(course)
    try:
        yield course
    finally:
        _NOW.reset(token)


def now() -> Course:
    """Return the closure that is on its way; a new one where none is."""
    return _NOW.get() or Course()


def sized(design: Design, *, still: bool = False, among: dict[str, Sizing] | None = None) -> Sizing:
    """Return a sized design, which counts for the closure that is on its way.

    Args:
        design: As `size` takes it.
        still: Whether open axes stay where they stand first, room or not.
        among: Those that were sized so before, by what they state, to which it is added; None: it is sized.

    Raises:
        DesignError: If it cannot be sized.
    """
    stated = "" if among is None else f"{still} {design.model_dump_json(by_alias=True, exclude_unset=True)}"
    if among is not None and stated in among:
        return among[stated]
    now().sizings += 1
    sizing = size_unturned(design) if still else size(design)
    if among is not None:
        among[stated] = sizing
    return sizing
