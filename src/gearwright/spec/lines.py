"""Line numbers of the keys of a TOML text, which TOML readers do not give."""

from __future__ import annotations

import re
from collections.abc import Mapping

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
