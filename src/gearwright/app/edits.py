"""One entry of a design's text changed, its comments and order kept."""

from __future__ import annotations

import math
import re
from collections.abc import MutableMapping, Sequence
from typing import Any

from gearwright.errors import DesignError, Problem, refuse
from gearwright.spec import key_lines, parse, standing_at
from gearwright.spec.read import DEEPEST, dotted_names, toml_tables

MOST_DOTTED = 200
"""Names of dotted keys: what keeps comments takes time with their square [-]."""


def with_entry(text: str, path: Sequence[str], value: Any) -> str:
    """Return a text with one entry changed; None takes it out.

    Args:
        text: In TOML.
        path: Names of tables, and the key with its unit.
        value: A number, text, truth value or list, in the unit of the key.

    Raises:
        DesignError: If the text is no TOML, or there can be no such entry.
    """
    import tomlkit
    from tomlkit.exceptions import TOMLKitError

    _refuse_odd(path, value)
    toml_tables(text, "")  # names the line of what is no TOML, and how much of it is too much
    if (names := dotted_names(text)) > MOST_DOTTED:
        message = f"with {names} names in dotted keys entries are changed in the text alone; write tables, as [a.b]"
        raise _refusal("", message)
    try:
        document = tomlkit.parse(text)
        table: MutableMapping[str, Any] = document
        for name in path[:-1]:
            if name not in table and value is not None:
                table[name] = tomlkit.table()
            table = table[name]
        if value is None:
            table.pop(path[-1], None)
        else:
            table[path[-1]] = value
        return tomlkit.dumps(document)
    except (TOMLKitError, KeyError, TypeError, AttributeError, ValueError) as error:
        where = ".".join(path)
        raise _refusal(where, f"this entry cannot be changed here ({type(error).__name__}); change the text") from None


def in_unit(text: str, path: Sequence[str], key: str) -> str:
    """Return a text with one quantity written in another unit.

    Args:
        text: Of a design without problems.
        path: Names of tables, and the key as it is.
        key: The key with the other unit.

    Raises:
        DesignError: If the design is not whole, or there is no such key.
    """
    _refuse_odd((*path[:-1], key), 0)
    standing = standing_at(parse(text), ".".join((*path[:-1], key)))
    if not isinstance(standing.value, float) or not math.isfinite(standing.value):
        raise _refusal(".".join(path), f"it cannot be written as {key}")
    changed = with_entry(text, path, float(f"{standing.value:.12g}"))
    lines = changed.split("\n")
    at = key_lines(changed).get(".".join(path))
    if at is None:
        raise _refusal(".".join(path), "this entry stands in a table in one line; change the text")
    lines[at - 1] = re.sub(rf"^(\s*){re.escape(path[-1])}(\s*=)", rf"\g<1>{key}\g<2>", lines[at - 1])
    return "\n".join(lines)


def _refuse_odd(path: Sequence[str], value: object) -> None:
    if not 1 <= len(path) <= DEEPEST or not all(path):
        refuse([Problem("path", f"an entry has 1 to {DEEPEST} names")])
    if isinstance(value, float) and not math.isfinite(value):
        refuse([Problem(".".join(path), "a number is needed")])


def _refusal(path: str, sentence: str) -> DesignError:
    return DesignError([Problem(path, sentence)])
