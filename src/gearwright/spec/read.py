"""Reader of design files in TOML: syntax errors with line numbers, mesh stiffness curves from CSV files."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np

from gearwright.errors import DesignError, Problem, excerpt, near
from gearwright.files import beside, numbers_of, text_of
from gearwright.parts.stiffness import sampled_curve
from gearwright.shipped import find_design
from gearwright.spec.checks import bearing_problems, reference_problems
from gearwright.spec.design import Design, MeshCurve
from gearwright.spec.record import STAND_INS, Location, build
from gearwright.verbs import verb

# ----------------------------------------------------------------------------------------------------------------------
# Line numbers of the keys of a TOML text, which TOML readers do not give.
# ----------------------------------------------------------------------------------------------------------------------


HEADER = re.compile(r"^\s*\[{1,2}([^\[\]]+)\]{1,2}\s*(?:#.*)?$")
KEY = re.compile(r"""^\s*((?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+)(?:\s*\.\s*(?:"[^"]*"|'[^']*'|[A-Za-z0-9_-]+))*)\s*=""")
_PART = re.compile(r"""\s*(?:"([^"]*)"|'([^']*)'|([^.\s"']+))\s*(?:\.|$)""")
_MULTILINE = ('"""', "'''")


def key_lines(text: str) -> dict[str, int]:
    """Return the line, counted from 1, of every table and key by its dotted path.

    Args:
        text: A TOML document. Keys of inline tables are not listed; their table is.
    """
    lines: dict[str, int] = {}
    table, closing = "", ""
    for number, line in enumerate(text.split("\n"), start=1):
        if closing:
            closing = "" if closing in line else closing
            continue
        header, key = HEADER.match(line), KEY.match(line)
        if header and not key:
            table = dotted(header[1])
            lines.setdefault(table, number)
        elif key:
            path = dotted(key[1])
            lines.setdefault(f"{table}.{path}" if table else path, number)
            closing = next((mark for mark in _MULTILINE if line.count(mark) == 1), "")
    return lines


def line_of(path: str, lines: Mapping[str, int]) -> int | None:
    """Return the line of a path, or of the nearest table above it.

    Args:
        path: Dotted path.
        lines: As `key_lines` gives them.
    """
    while path:
        if path in lines:
            return lines[path]
        path = path.rpartition(".")[0]
    return None


def line_in(path: str, lines: Mapping[str, int]) -> int | None:
    """Return the line of a path whose key has its unit behind it, or of the nearest table above it.

    Args:
        path: Dotted path without the unit of its key.
        lines: As `key_lines` gives them.

    >>> line_in("motors.electric.power", {"motors.electric": 3, "motors.electric.power_kw": 4})
    4
    """
    head = f"{path}_"
    exact = next((line for key, line in lines.items() if key == path or key.startswith(head)), None)
    return line_of(path, lines) if exact is None else exact


def dotted(key: str) -> str:
    """Return a key of TOML, whose parts may stand in quotes, as a dotted path.

    Args:
        key: As written.
    """
    return ".".join("".join(match) for match in _PART.findall(key))


# ----------------------------------------------------------------------------------------------------------------------
# What TOML's reader calls a wrong character, as people say it: commas in numbers, things given twice.
# ----------------------------------------------------------------------------------------------------------------------


_PLACE = re.compile(r"at line (\d+)")
_COMMA = re.compile(r"=\s*([-+]?\d+),(\d+)\s*(?:#.*)?$")


def slip(text: str, reason: str) -> Problem | None:
    """Return the slip behind an error of TOML's reader, with its line; None if it is none of those that are known.

    Args:
        text: Of the file.
        reason: What the reader says, which ends in the place.

    >>> slip("ratio = 2,67", "Expected newline (at line 1, column 10)").message
    'numbers have a decimal point, not a comma; write 2.67'
    """
    place = _PLACE.search(reason)
    lines = text.split("\n")
    if place is None or int(place[1]) > len(lines):
        return None
    number = int(place[1])
    line, paths = lines[number - 1].rstrip("\r"), _paths(lines[:number])
    path, comma = paths[-1], _COMMA.search(line)
    if comma:
        return Problem(path, f"numbers have a decimal point, not a comma; write {comma[1]}.{comma[2]}", number)
    if not path or path not in paths[:-1]:
        return None
    first = paths.index(path) + 1
    if HEADER.match(line):
        said = f"the table [{excerpt(path)}] stands in line {first} already; put all its keys below one heading"
    else:
        said = f"is given in line {first} already; keep one of them"
    return Problem(path, said, number)


def _paths(lines: list[str]) -> list[str]:
    """Return the dotted path that each line gives a table or a value; empty where it gives none."""
    table, paths = "", []
    for line in lines:
        header, key = HEADER.match(line), KEY.match(line)
        if header and not key:
            table = dotted(header[1])
            paths.append(table)
        else:
            path = dotted(key[1]) if key else ""
            paths.append(f"{table}.{path}" if table and path else path)
    return paths


# ----------------------------------------------------------------------------------------------------------------------
# A user's own mesh stiffness: CSV files beside the design file become part of the design, which then needs no file.
# ----------------------------------------------------------------------------------------------------------------------


COLUMNS = ("phase_cycles", "stiffness_n_m")
"""Of the file, in its first row; others are left alone."""


def with_curves(design: Design, folder: Path) -> tuple[Design, list[Problem]]:
    """Return a design whose own stiffness curves hold their points, and what is wrong with them.

    Args:
        design: As written.
        folder: Where the files are looked for.
    """
    curves, problems = dict(design.dynamics.curves), []
    for mesh, curve in design.dynamics.curves.items():
        path = f"dynamics.curves.{mesh}"
        problems += list(_unknown(path, mesh, design))
        try:
            curves[mesh] = _filled(path, curve, folder)
        except DesignError as error:
            problems += error.problems
    if not curves or problems:
        return design, problems
    dynamics = design.dynamics.model_copy(update={"curves": curves})
    return design.model_copy(update={"dynamics": dynamics}), []


def _unknown(path: str, mesh: str, design: Design) -> Iterator[Problem]:
    sets = [f"{name}.{end}" for name in design.planetaries for end in ("sun-planet", "planet-ring")]
    sets += [
        f"{name}.{first}-{second}"
        for name, epicyclic in design.epicyclics.items()
        for first, second in epicyclic.mesh_pairs
    ]
    if mesh not in (*sets, *design.pairs):
        yield Problem(path, f"there is no mesh {mesh!r}; {near(mesh, [*sets, *design.pairs])}")


def _filled(path: str, curve: MeshCurve, folder: Path) -> MeshCurve:
    has_points = bool(curve.phase_cycles or curve.stiffness_n_m)
    if curve.file is None and not has_points:
        raise DesignError([Problem(path, "has no points; give file, or phase_cycles and stiffness_n_m")])
    if curve.file is not None and not has_points:
        phase, stiffness = _columns(f"{path}.file", beside(curve.file, folder, f"{path}.file"))
        curve = curve.model_copy(update={"phase_cycles": phase, "stiffness_n_m": stiffness})
    try:
        sampled_curve(2.0 * math.pi * np.array(curve.phase_cycles), curve.stiffness_n_m, harmonics=1, source="")
    except DesignError as error:
        raise DesignError([Problem(path, f"{problem.path}: {problem.message}") for problem in error.problems]) from None
    return curve


def _columns(path: str, file: Path) -> tuple[list[float], list[float]]:
    try:
        points = numbers_of(text_of(file, path), COLUMNS)
    except ValueError as error:
        raise DesignError([Problem(path, f"{file} {error}")]) from None
    return [phase for phase, _ in points], [stiffness for _, stiffness in points]


# ----------------------------------------------------------------------------------------------------------------------
# Read a design file: TOML to `Design`, with every problem of the file at once.
# ----------------------------------------------------------------------------------------------------------------------


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
