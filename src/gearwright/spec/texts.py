"""Changes of a design in the text of its file, whose comments, order and units stay."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gearwright.base import verb
from gearwright.spec.design import Design
from gearwright.spec.edit import design_text, key_of, name_text, value_text
from gearwright.spec.read import HEADER, KEY
from gearwright.spec.record import Key, Record, keys_of

# ----------------------------------------------------------------------------------------------------------------------
# What a changed design gives, as tables in the keys and units of a file: what stands there and is unchanged stays.
# ----------------------------------------------------------------------------------------------------------------------


DIGITS = 12
"""Digits of a number that is written: 12.7, not 12.700000000000001."""
SAME = 1e-12
"""Relative difference of two numbers that are written alike [-]."""
Path = tuple[str, ...]


@verb
def design_text_like(design: Design, text: str, before: Design) -> str:
    """Return the text of a file with what was changed of its design: comments, order and units of the rest stay.

    What is new stands behind what its table gives, in the usual unit. A text that cannot be changed so is written anew,
    without its comments, as `design_text` does it.

    Args:
        design: With its changes.
        text: Of the file, in TOML.
        before: Read from it.
    """
    given = tomllib.loads(text)
    wanted = _table(design, before, given)
    changed = _changed(text, given, wanted)
    return design_text(design) if changed is None else changed


def _table(record: Record, before: object, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a record gives, in the keys of a table; what is as it was is as the table has it."""
    old = before if isinstance(before, Record) else None
    table = dict[str, Any]()
    for name, info in type(record).model_fields.items():
        value = getattr(record, name)
        was = getattr(old, name) if old is not None and name in old.model_fields_set else None
        stands = _standing(type(record), info.alias or name, given)
        if was is not None and name in record.model_fields_set and _equal(value, was):
            table |= {key: given[key] for key in stands}
        elif name in record.model_fields_set and value is not None:
            key, meant = next(iter(stands.items()), None) or key_of(type(record), info.alias or name, value)
            table[key] = _written(value, was, given.get(key), meant)
    for name, value in (record.model_extra or {}).items():
        was = None if old is None else (old.model_extra or {}).get(name)
        table[name] = (
            given[name] if name in given and _equal(value, was) else _written(value, was, given.get(name), None)
        )
    return {key: table[key] for key in (*(key for key in given if key in table), *table)}


def _standing(kind: type[Record], field: str, given: Mapping[str, Any]) -> dict[str, Key]:
    """Return the keys of a field that a table has."""
    return {key: meant for key, meant in keys_of(kind).items() if meant.field == field and key in given}


def _equal(one: object, other: object) -> bool:
    """Tell whether two values are written alike; tables are gone through entry by entry."""
    if isinstance(one, Record | Mapping):
        return False
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=SAME)
    return one == other


def _written(value: Any, was: object, given: object, meant: Key | None) -> Any:
    """Return a value as TOML has it, tables in the keys of what is given."""
    inner = given if isinstance(given, Mapping) else {}
    if isinstance(value, Record):
        return _table(value, was, inner)
    if isinstance(value, Mapping):
        old = was if isinstance(was, Mapping) else {}
        found = {str(key): _written(own, old.get(key), inner.get(key), None) for key, own in value.items()}
        return {key: found[key] for key in (*(key for key in inner if key in found), *found)}
    if isinstance(value, list | tuple):
        return [_written(own, None, None, None) for own in value]
    if isinstance(value, float):
        return number(meant.written(value) if meant is not None and meant.suffix else value)
    return value


def number(value: float) -> float | int:
    """Return a number as people write it: without digits that rounding made, whole ones without a point.

    Args:
        value: In its unit.

    >>> number(12.700000000000001), number(5000.0)
    (12.7, 5000)
    """
    rounded = float(f"{value:.{DIGITS}g}")
    return int(rounded) if rounded.is_integer() and abs(rounded) < 1e15 else rounded


# ----------------------------------------------------------------------------------------------------------------------
# The statements of a TOML text, and the text with other values, without some of them and with more.
# ----------------------------------------------------------------------------------------------------------------------


_STRINGS = re.compile(
    r'''"""(?:[^"\\]|\\.|"(?!""))*+"""|\'\'\'(?:[^']|'(?!\'\'))*+\'\'\'|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+'|#[^\n]*+''',
    re.DOTALL,
)
_PART = re.compile(r"""\s*(?:"([^"]*)"|'([^']*)'|([^.\s"']+))\s*(?:\.|$)""")


@dataclass(frozen=True)
class _Statement:
    """A heading, or a key with its value."""

    table: Path
    """Heading that it stands below; of a heading itself."""
    path: Path
    """Of its value; of a heading its own."""
    lines: tuple[int, int]
    """First line, and the one behind its last."""
    value: tuple[int, int] | None
    """Where its value begins in its first line and ends in its last; None of a heading."""

    @property
    def is_heading(self) -> bool:
        """Whether it opens a table."""
        return self.value is None


def _statements(text: str) -> Iterator[_Statement]:
    """Yield every statement of a text in its order; what reads on over lines is one."""
    lines, bare = text.split("\n"), _masked(text).split("\n")
    table: Path = ()
    number = 0
    while number < len(lines):
        header, key = HEADER.match(lines[number]), KEY.match(lines[number])
        if header and not key:
            table = _parts(header[1])
            yield _Statement(table, table, (number, number + 1), None)
        elif key:
            end = number + 1
            while end < len(lines) and _is_open("\n".join(bare[number:end])):
                end += 1
            start = key.end() + len(lines[number][key.end() :]) - len(lines[number][key.end() :].lstrip())
            stop = len(bare[end - 1].rstrip())
            yield _Statement(table, (*table, *_parts(key[1])), (number, end), (start, stop))
            number = end
            continue
        number += 1


def _masked(text: str) -> str:
    """Return a text of equal length: texts in quotes as marks, in brackets where they go on; comments as blanks."""

    def mask(found: re.Match[str]) -> str:
        words = found[0]
        if words.startswith("#"):
            return " " * len(words)
        marks = "".join("\n" if letter == "\n" else "_" for letter in words)
        return f"[{marks[1:-1]}]" if "\n" in words else marks

    return _STRINGS.sub(mask, text)


def _is_open(bare: str) -> bool:
    """Tell whether a value goes on in the next line: brackets are open, or a text in quotes."""
    value = bare.partition("=")[2]
    return sum(map(value.count, "[{")) > sum(map(value.count, "]}")) or not value.strip()


def _parts(key: str) -> Path:
    return tuple("".join(match) for match in _PART.findall(key))


def _changed(text: str, given: Mapping[str, Any], wanted: Mapping[str, Any]) -> str | None:
    """Return a text that gives what is wanted; None where its statements cannot be changed one by one."""
    try:
        found = _Editing(text, given, wanted).text()
        return found if _plain(tomllib.loads(found)) == _plain(wanted) else None
    except (tomllib.TOMLDecodeError, LookupError):
        return None


def _plain(value: Any) -> Any:
    """Return tables as they are compared: those without an entry are the same as none."""
    if isinstance(value, Mapping):
        rows = {key: _plain(own) for key, own in value.items()}
        return {key: own for key, own in rows.items() if own != {}}
    return [_plain(own) for own in value] if isinstance(value, list) else value


class _Editing:
    """A text that is being changed: what stands in the place of each of its statements, and what is put behind it."""

    def __init__(self, text: str, given: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
        self.lines = text.rstrip("\n").split("\n")
        self.statements = list(_statements(text.rstrip("\n")))
        self.given, self.wanted = given, wanted
        self.behind = dict[int, list[str]]()
        """Number of a line -> lines that follow it; -1: before all."""
        self.gone = set[int]()
        """Lines that are left out."""
        self.fresh = dict[Path, list[tuple[str, Any]]]()
        """New table -> what it gives."""

    def text(self) -> str:
        """Return the changed text."""
        for statement in self.statements:
            self._replace(statement)
        self._add((), self.given, self.wanted)
        for table, rows in self.fresh.items():
            self._new_table(table, rows)
        kept = list(self.behind.get(-1, []))
        for number, line in enumerate(self.lines):
            kept += [] if number in self.gone else [line]
            kept += self.behind.get(number, [])
        return "\n".join(kept).strip("\n") + "\n"

    def _replace(self, statement: _Statement) -> None:
        """Write another value, or leave out what is not wanted any more."""
        was, now = _at(self.given, statement.path), _at(self.wanted, statement.path)
        first, end = statement.lines
        if now is None and was is not None:
            self.gone.update(range(first, end))
        elif statement.value is not None and now != was:
            start, stop = statement.value
            line = self.lines[first][:start] + _inline(now) + self.lines[end - 1][stop:]
            self.lines[first] = line
            self.gone.update(range(first + 1, end))

    def _add(self, table: Path, given: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
        """Put what is new where its table stands."""
        if any(one.path == table and not one.is_heading for one in self.statements):
            return  # a table in one line, which was replaced
        new = [(key, value) for key, value in wanted.items() if key not in given and not isinstance(value, Mapping)]
        if new:
            self._put(table, new)
        for key, value in wanted.items():
            if isinstance(value, Mapping):
                self._add((*table, key), given.get(key, {}), value)

    def _put(self, table: Path, rows: Sequence[tuple[str, Any]]) -> None:
        """Put rows behind the last one of their table; below a new heading where it has none."""
        heading = next((one for one in self.statements if one.is_heading and one.path == table), None)
        own = [one for one in self.statements if not one.is_heading and one.path[:-1] == table]
        beneath = [one for one in own if one.table == table]
        dotted = [one for one in own if one.table != table]
        if heading is not None or (beneath and not table):
            last = beneath[-1] if beneath else heading
            assert last is not None
            self._behind(last, [f"{name_text(key)} = {_inline(value)}" for key, value in rows])
        elif dotted:
            names = ".".join(map(name_text, table[len(dotted[-1].table) :]))
            self._behind(dotted[-1], [f"{names}.{name_text(key)} = {_inline(value)}" for key, value in rows])
        else:
            self.fresh[table] = list(rows)

    def _behind(self, statement: _Statement, lines: Sequence[str]) -> None:
        self.behind.setdefault(statement.lines[1] - 1, []).extend(lines)

    def _new_table(self, table: Path, rows: Sequence[tuple[str, Any]]) -> None:
        """Put a new table behind the last statement of those nearest to it: of its own kind, or of all."""
        near = next(
            last
            for depth in range(len(table), -1, -1)
            if (last := [one for one in self.statements if one.table[:depth] == table[:depth]])
        )
        heading = f"[{'.'.join(map(name_text, table))}]"
        body = [f"{name_text(key)} = {_inline(value)}" for key, value in rows]
        apart = [] if len(table) > 1 and near[-1].table[:-1] == table[:-1] and not _apart(self, near[-1]) else [""]
        self._behind(near[-1], [*apart, heading, *body])


def _apart(editing: _Editing, last: _Statement) -> bool:
    """Tell whether the table of a statement has an empty line before it."""
    heading = next((one for one in editing.statements if one.is_heading and one.path == last.table), None)
    return heading is None or not editing.lines[heading.lines[0] - 1].strip()


def _at(table: Mapping[str, Any], path: Path) -> Any:
    """Return what stands at a path; None where nothing does."""
    found: Any = table
    for part in path:
        if not isinstance(found, Mapping) or part not in found:
            return None
        found = found[part]
    return found


def _inline(value: Any) -> str:
    """Return a value in one line."""
    if isinstance(value, Mapping):
        rows = ", ".join(f"{name_text(key)} = {_inline(own)}" for key, own in value.items())
        return f"{{ {rows} }}" if rows else "{}"
    return value_text(value)
