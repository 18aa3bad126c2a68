"""The two ways in which gearwright fails: a design that is wrong, and a computation that does not succeed.

Every message names the place, what was given, what is allowed and what to do. A `DesignError` carries all problems
of a file at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TypeVar

_T = TypeVar("_T")


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with what the user wrote."""

    path: str
    """Dotted path of the entry in the file, such as ``turbines.gas-turbine.power_kw``; empty for the file itself."""
    message: str
    """What was given, what is allowed and what to do, in one sentence or two."""
    line: int | None = None
    """Line of the file, counted from 1, where it is known."""

    def __str__(self) -> str:
        where = f"line {self.line}: " if self.line is not None else ""
        return f"{where}{self.path}: {self.message}" if self.path else f"{where}{self.message}"


class GearwrightError(Exception):
    """Anything that gearwright raises on purpose."""


class DesignError(GearwrightError):
    """What the user wrote cannot be used; carries every problem found."""

    def __init__(self, problems: Iterable[Problem], source: str = "") -> None:
        self.problems: tuple[Problem, ...] = tuple(problems)
        self.source = source
        super().__init__(str(self))

    def __str__(self) -> str:
        count = len(self.problems)
        head = f"{self.source}: " if self.source else ""
        lines = "\n".join(f"  {problem}" for problem in self.problems)
        return f"{head}{count} problem{'s' if count != 1 else ''}\n{lines}"


class SolveError(GearwrightError):
    """A computation that did not succeed; the message names the part, the time and the value."""


def install(extra: str) -> str:
    """Return how the packages of an extra are got: from a clone, and where gearwright is in a package index.

    Args:
        extra: Its name in ``pyproject.toml``.

    >>> install("cluster")
    'in a clone: pip install ".[cluster]"; from a package index: pip install "gearwright[cluster]"'
    """
    return f'in a clone: pip install ".[{extra}]"; from a package index: pip install "gearwright[{extra}]"'


def near(name: str, allowed: Iterable[str]) -> str:
    """Return a hint for a name that is not known: the nearest one, or all of them.

    Args:
        name: What was written.
        allowed: Names that would be accepted.
    """
    names: Sequence[str] = sorted(allowed)
    if not names:
        return "none is defined"
    match = get_close_matches(name, names, n=1, cutoff=0.6)
    return f"did you mean {match[0]}?" if match else f"allowed: {', '.join(names)}"


def by_name(name: str, among: Mapping[str, _T], what: str) -> _T:
    """Return the part of a name.

    Args:
        name: What was asked for.
        among: Name -> part.
        what: Such as ``"case"``, for the message.

    Raises:
        DesignError: If there is none of this name; with the nearest one.
    """
    if name not in among:
        raise DesignError([Problem(what, f"there is no {what} {name!r}; {near(name, among)}")])
    return among[name]
