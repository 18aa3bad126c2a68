"""A closure whose course is kept in a journal: one that was broken off goes on where it was."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from hashlib import sha256
from pathlib import Path

from gearwright.base import DesignError, Problem, refuse
from gearwright.closure import Course, OnMission, Wishes
from gearwright.spec import Design
from gearwright.store import load, save
from gearwright.study.journal import made_with


@dataclass(frozen=True)
class KeptClosure:
    """What a journal holds."""

    asked: str
    """Digest of everything that moves a result."""
    design: str
    """Its name."""
    known: Mapping[str, tuple[float, ...]]
    """Change of a design -> what was found of it."""


def digest_of(
    design: Design, wishes: Wishes, on_mission: OnMission | None = None, start: Design | None = None
) -> str:  # fmt: skip
    """Return the digest of everything that moves the result of a closure, what computes it included.

    Args:
        design: As read.
        wishes: What is asked.
        on_mission: What is flown.
        start: Design that was closed before.
    """
    records = (design, None if on_mission is None else on_mission.mission, start)
    stated = [None if one is None else one.model_dump_json(by_alias=True, exclude_unset=True) for one in records]
    asked = [
        wishes.life,
        wishes.rounded,
        wishes.separate,
        wishes.lighten,
        list(wishes.free),
        sorted(wishes.left_out),
    ]
    return sha256(json.dumps([dict(made_with()), asked, stated]).encode()).hexdigest()


def course_of(journal: Path, asked: str, design: Design) -> Course:
    """Return the course of a closure with what its journal knows, and that keeps there what is found.

    Args:
        journal: File; it is begun where there is none.
        asked: From `digest_of`.
        design: As read.

    Raises:
        DesignError: If the file is no journal, is damaged, or was begun with something else.
        SolveError: If it cannot be written.
    """
    known = known_by(journal, asked) if journal.exists() else {}
    keep_in(journal, asked, design, known)
    return Course(known, partial(keep_in, journal, asked, design))


def keep_in(journal: Path, asked: str, design: Design, found: Mapping[str, tuple[float, ...]]) -> None:
    """Write what a closure has found.

    Args:
        journal: File, which is replaced.
        asked: From `digest_of`.
        design: As read.
        found: Change of a design -> what was found of it.

    Raises:
        DesignError: If no file can be there.
        SolveError: If the disk does not take it.
    """
    save(KeptClosure(asked, design.name, dict(found)), journal)


def known_by(journal: Path, asked: str) -> dict[str, tuple[float, ...]]:
    """Return what a journal knows: change of a design -> what was found of it.

    Args:
        journal: A file.
        asked: From `digest_of`.

    Raises:
        DesignError: If it is no journal of a closure, is damaged, or was begun with something else.
    """
    fix = "take it away, or name another file"
    try:
        kept = load(journal)
    except DesignError as error:
        why = "; ".join(problem.message for problem in error.problems)
        raise DesignError([Problem("journal", f"{journal} cannot be gone on with: {why}; {fix}")]) from None
    if not isinstance(kept, KeptClosure):
        refuse([Problem("journal", f"{journal} is no journal of a closure; {fix}")])
    assert isinstance(kept, KeptClosure)
    if kept.asked != asked:
        why = f"{kept.design!r}, as it was then, with its wishes and the gearwright of then"
        refuse([Problem("journal", f"{journal} was begun with another design, wishes or version ({why}); {fix}")])
    return dict(kept.known)
