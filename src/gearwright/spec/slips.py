"""What TOML's reader calls a wrong character, as people say it: commas in numbers, things given twice."""

from __future__ import annotations

import re

from gearwright.errors import Problem, excerpt
from gearwright.spec.lines import HEADER, KEY, dotted

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
