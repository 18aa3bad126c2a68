"""Read a design file: TOML to `Design`, with every problem of the file at once."""

from __future__ import annotations

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
        DesignError: If it is not TOML.
    """
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # ValueError also for whole numbers of thousands of digits
        found = slip(text, str(error))
        if found is not None:
            raise DesignError([found], source) from None
        reason = "its brackets nest too deeply" if isinstance(error, RecursionError) else excerpt(str(error), _REASON)
        raise DesignError(
            [Problem("", f"this is not TOML: {reason}; a line reads  key = value  or  [table]")], source
        ) from None


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
