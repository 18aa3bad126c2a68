"""Read a design file: TOML to `Design`, with every problem of the file at once."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, cast

from gearwright.errors import DesignError, Problem, excerpt
from gearwright.reading import text_of
from gearwright.shipped import find_design
from gearwright.spec.checks import bearing_problems, reference_problems
from gearwright.spec.curves import with_curves
from gearwright.spec.design import Design
from gearwright.spec.lines import key_lines, line_of
from gearwright.spec.record import STAND_INS, Location, build
from gearwright.spec.slips import slip
from gearwright.verbs import verb

_MISSING = "there is no such file; `gearwright new` lists the shipped designs, `fly` missions, `study` studies"
_REASON = 160
"""Characters of what TOML's reader says, which may repeat a key [-]."""
DEEPEST = 8
"""Names that a dotted key or a heading may have: a reader takes time with the square of them [-]."""
MOST_ENTRIES = 5_000
"""Tables and entries that a file may have: each is looked up, and what is wrong with it is explained [-]."""
_TEXT = re.compile(
    r'''"""(?:[^"\\]|\\.|"(?!""))*+"""|\'\'\'(?:[^']|'(?!\'\'))*+\'\'\''''
    r"""|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+'|#[^\n]*+""",
    re.DOTALL,
)
"""Texts in quotes and comments, in which points are only points."""
_DEEP = re.compile(rf"(?<![\w-])(?:[\w-]++[ \t]*+\.[ \t]*+){{{DEEPEST}}}")
_DOTTED = re.compile(r"(?<![\w-])((?:[\w-]++[ \t]*+\.[ \t]*+)++)[\w-]++[ \t]*+=")
_PLACE = re.compile(r"at line (\d+)")


@verb
def read(path: str | Path) -> Design:
    """Return the design that a file describes.

    Args:
        path: A TOML file, or the name of a shipped design; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file: its path, line, what was given, what is allowed and the fix.
    """
    file = find_design(str(path))
    return parse(file_text(file), source=str(path), folder=file.parent)


@verb
def parse(text: str, *, source: str = "", folder: Path | None = None) -> Design:
    """Return the design that a TOML text describes.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where the files that it names are looked for; left out: where the program runs.

    Raises:
        DesignError: As `read`.
    """
    if not text.strip():
        raise DesignError(
            [Problem("", "the file is empty; `gearwright new` writes a complete one to start from")], source
        )
    tables = toml_tables(text, source)
    record, written = build(Design, tables)
    problems = list(written.problems)
    if record is not None:
        more = _in_written_keys(reference_problems(cast(Design, record)), written.keys)
        problems += _without_stand_ins(more, problems, tables) if problems else more
    if problems:
        raise DesignError(placed(problems, text), source)
    design, problems = with_curves(cast(Design, record), folder or Path())
    problems += bearing_problems(design)
    if problems:
        raise DesignError(placed(problems, text), source)
    return design


def _without_stand_ins(more: list[Problem], told: list[Problem], tables: dict[str, Any]) -> list[Problem]:
    """Return problems that are none of what stands for faulty and missing quantities: other ones give them, too."""
    other, written = build(Design, tables, stand_in=STAND_INS[1])
    if other is None:
        return []
    again = _in_written_keys(reference_problems(cast(Design, other)), written.keys)
    paths = {problem.path for problem in told}
    return [problem for problem in more if problem in again and problem.path not in paths]


def toml_tables(text: str, source: str) -> dict[str, Any]:
    """Return the tables of a TOML text that a user wrote.

    Args:
        text: The file's content.
        source: Name of the file, for messages.

    Raises:
        DesignError: If it is not TOML, or too much of it.
    """
    if deep := _DEEP.search(_keys(text)):
        message = (
            f"a key or heading has more than {DEEPEST} names with points between them; put shorter keys below headings"
        )
        raise DesignError([Problem("", message, deep.string.count("\n", 0, deep.start()) + 1)], source)
    try:
        tables = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # ValueError also for whole numbers of thousands of digits
        found = slip(text, str(error))
        if found is not None:
            raise DesignError([found], source) from None
        reason = "its brackets nest too deeply" if isinstance(error, RecursionError) else excerpt(str(error), _REASON)
        place = _PLACE.search(str(error))
        line = int(place[1]) if place else text.count("\n") + 1 if "end of document" in str(error) else None
        message = f"this is not TOML: {reason}; a line reads  key = value  or  [table]"
        raise DesignError([Problem("", message, line)], source) from None
    if (count := _entries(tables)) > MOST_ENTRIES:
        message = f"the file has {count:,} tables and entries; {MOST_ENTRIES:,} are allowed: divide it"
        raise DesignError([Problem("", message)], source)
    return tables


def dotted_names(text: str) -> int:
    """Return how many names the dotted keys of a TOML text have before their last ones.

    Args:
        text: The file's content, with keys of no more than `DEEPEST` names.

    >>> dotted_names("x.y = 1.5  # a.b\\n[p.q]\\nz = {a.b.c = 1}")
    3
    """
    return sum(found.count(".") for found in _DOTTED.findall(_keys(text)))


def _keys(text: str) -> str:
    """Return a TOML text line by line, with a mark in the place of every text in quotes and comment."""
    return _TEXT.sub(lambda found: "_" + "\n" * found[0].count("\n"), text)


def _entries(value: object) -> int:
    """Return how many tables and entries there are."""
    if isinstance(value, dict):
        return len(value) + sum(map(_entries, value.values()))
    return sum(map(_entries, value)) if isinstance(value, list) else 0


def placed(problems: Iterable[Problem], text: str) -> list[Problem]:
    """Return problems with their lines, in the order of the file.

    Args:
        problems: With paths in the keys of the file.
        text: The file's content.
    """
    lines = key_lines(text)
    at_lines = [Problem(problem.path, problem.message, line_of(problem.path, lines)) for problem in problems]
    return sorted(at_lines, key=lambda problem: (problem.line or 0, problem.path))


def _in_written_keys(problems: Iterable[Problem], keys: Mapping[Location, str]) -> list[Problem]:
    """Return problems whose paths end in the key with its unit, as the user wrote it."""
    written = {".".join(location): path for location, path in keys.items()}
    return [Problem(written.get(problem.path, problem.path), problem.message) for problem in problems]


def file_text(path: str | Path) -> str:
    """Return the text of a file that a user writes, or say why there is none to be had.

    Args:
        path: Of a design file, or of any other TOML file that a user writes.

    Raises:
        DesignError: If there is no such text file, or it is too large.
    """
    return text_of(path, missing=_MISSING)
