"""The two ways in which gearwright fails: a design that is wrong, and a computation that does not succeed.

Every message names the place, what was given, what is allowed and what to do. A `DesignError` carries all problems
of a file at once. What a user wrote is shown cut to a length that a reader takes in, and without anything that a
terminal would obey.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TypeVar

_T = TypeVar("_T")

LONGEST_EXCERPT = 80
"""Characters of a value, key or name that a message shows."""
MOST_SHOWN = 50
"""Problems of one file that a message lists; the others are counted."""
MOST_NAMES = 28
"""Allowed names that a message lists; the others are counted."""


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
        path = f"{excerpt(self.path, 2 * LONGEST_EXCERPT)}: " if self.path else ""
        return f"{where}{path}{printable(self.message)}"


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
        head = f"{printable(self.source)}: " if self.source else ""
        lines = [f"  {problem}" for problem in self.problems[:MOST_SHOWN]]
        if count > MOST_SHOWN:
            lines.append(f"  ... and {count - MOST_SHOWN:,} more")
        return f"{head}{count} problem{'s' if count != 1 else ''}\n" + "\n".join(lines)


def refuse(problems: Iterable[Problem], source: str = "") -> None:
    """Raise a `DesignError` of all problems, where there are any.

    Args:
        problems: What is wrong.
        source: Name of the file, or of what was called.
    """
    if listed := tuple(problems):
        raise DesignError(listed, source)


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


def printable(text: str) -> str:
    r"""Return a text whose control characters are written out, so that no terminal obeys them.

    Args:
        text: From anywhere.

    >>> printable("a\x1b[2J")
    'a\\x1b[2J'
    """
    if text.isprintable():
        return text
    return "".join(character if character.isprintable() else repr(character)[1:-1] for character in text)


def excerpt(text: str, longest: int = LONGEST_EXCERPT) -> str:
    """Return the beginning of what a user wrote, as a message may show it.

    Args:
        text: A key, name or value.
        longest: Characters that are shown [-].

    >>> excerpt("first.carrier", 8)
    'first...'
    """
    return printable(text if len(text) <= longest else f"{text[: longest - 3]}...")


def near(name: str, allowed: Iterable[str], shown: Iterable[str] | None = None) -> str:
    """Return a hint for a name that is not known: the nearest one in whatever case, or all of them.

    Args:
        name: What was written.
        allowed: Names that would be accepted.
        shown: Those of them that are listed where none is near, such as a key with its usual unit; left out: all.
    """
    names: Sequence[str] = sorted(allowed)
    if not names:
        return "none is defined"
    folded = {allowed_name.casefold(): allowed_name for allowed_name in names}
    match = get_close_matches(name[:LONGEST_EXCERPT].casefold(), folded, n=1, cutoff=0.6)
    if match:
        return f"did you mean {folded[match[0]]}?"
    names = names if shown is None else sorted(shown)
    more = f" and {len(names) - MOST_NAMES:,} more" if len(names) > MOST_NAMES else ""
    return f"allowed: {', '.join(names[:MOST_NAMES])}{more}"


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
        raise DesignError([Problem(what, f"there is no {what} {excerpt(name)!r}; {near(name, among)}")])
    return among[name]
