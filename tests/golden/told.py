"""Values as golden files tell them, one a line: by the path of fields and the identity of the row, and what moved.

A key reads ``answer: path.of.fields [identity of the rows]``. Rows are known by the names of parts, meshes and cases,
never by their place or by a label in words; only members of a plain sequence of numbers are counted. Where a path has
more than `FULL` values it keeps how many there are, the first, last, least and greatest, and the mean; where all are
equal, the one value.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

import numpy as np

Value = float | int | bool | str
Group = dict[str, Value]
"""Identity -> value, of one path."""

FULL = 40
"""Values that a path may have and still keep each of them."""
DIGITS = 9
EQUAL = 3
"""From so many on, values that are all equal are told once."""
SHOWN = 20
"""Lines of each kind that a message has."""
ROUNDING = 1e-7
"""Relative difference that rounding and searches that stop at a tolerance leave."""
NOISE = 1e-6
"""Difference beside the largest of a path, or in SI units where that is above 1, that rounding leaves."""
ZERO = 1e-6
"""What is a zero with rounding wherever an answer has it; none has a quantity that small."""

IDENTITY: dict[str, tuple[str, ...]] = {
    "Assumption": ("path",),
    "Loss": ("part", "origin"),
    "Body": ("part", "shaft"),
    "Branch": ("shaft", "part", "stage"),
    "Attachment": ("shaft", "part", "stage"),
}
"""Record -> fields that tell one from another, where the usual ones do not."""
USUAL = ("name", "case", "shaft", "stage", "part", "machine", "mesh", "gear", "line", "place")


THERE = "there"
"""Value of a row that has nothing but its identity."""


class Fields(dict[str, Any]):
    """A mapping whose keys are fields, thus part of a path, and not names of parts."""


def values(value: Any, path: str = "", of: tuple[str, ...] = ()) -> Iterator[tuple[str, tuple[str, ...], Value]]:
    """Yield path, identity and value of every number, truth value and word inside an answer; no sentences.

    Args:
        value: Records, named rows, mappings and sequences.
        path: Of fields that lead to it.
        of: Identities of the rows around it.
    """
    value = value.value if isinstance(value, Enum) else value
    if isinstance(value, bool | np.bool_ | str | int | float | complex | np.number):
        yield from ((f"{path}{part}", of, own) for part, own in _single(value))
    elif _named(value):
        yield from _of_record(value, path, of, ())
    elif isinstance(value, Fields):
        for name, member in value.items():
            yield from values(member, f"{path}.{name}".lstrip("."), of)
    elif isinstance(value, Mapping):
        for key, member in value.items():
            yield from values(member, path, (*of, _word(key)))
    elif isinstance(value, np.ndarray):
        yield from values(list(value.ravel()), path, of)
    elif isinstance(value, set | frozenset):
        yield from values(sorted(value, key=_word), path, of)
    elif isinstance(value, tuple | list):
        yield from _of_sequence(value, path, of)


def _single(value: Any) -> Iterator[tuple[str, Value]]:
    if isinstance(value, bool | np.bool_):
        yield "", bool(value)
    elif isinstance(value, str):
        yield from [("", value)] if value and " " not in value else []
    elif isinstance(value, complex | np.complexfloating):
        yield from ((".real", float(value.real)), (".imag", float(value.imag)))
    elif isinstance(value, int | np.integer):
        yield "", int(value)
    else:
        yield "", float(value) if np.isfinite(value) else str(float(value))


def _named(value: Any) -> bool:
    return is_dataclass(value) or hasattr(value, "_fields")


def _members(row: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields(row)) if is_dataclass(row) else row._fields


def _of_record(row: Any, path: str, of: tuple[str, ...], but: Iterable[str]) -> Iterator[tuple[str, tuple, Value]]:
    for name in _members(row):
        member = getattr(row, name)
        if name not in but and not (name in USUAL and isinstance(member, str) and member in of):
            yield from values(member, f"{path}.{name}".lstrip("."), of)


def _of_sequence(rows: Any, path: str, of: tuple[str, ...]) -> Iterator[tuple[str, tuple, Value]]:
    if rows and all(isinstance(row, str) and " " not in row for row in rows):
        yield path, of, ", ".join(rows)
        return
    met: Counter[str] = Counter()
    for place, row in enumerate(rows, 1):
        name, used = _identity(row)
        met[name] += 1
        name = name if met[name] == 1 else f"{name} #{met[name]}".lstrip()
        if not used:
            yield from values(row, path, (*of, str(place)) if len(rows) > 1 else of)
        elif inner := list(_of_record(row, path, (*of, name), used)):
            yield from inner
        else:
            yield path, (*of, name), THERE


def _identity(row: Any) -> tuple[str, tuple[str, ...]]:
    """Return the name of a row and the fields that are told by it; neither where it has none."""
    if not _named(row):
        return "", ()
    if type(row).__name__ in IDENTITY:
        used: tuple[str, ...] = IDENTITY[type(row).__name__]
    elif isinstance(getattr(row, "name", None), str):
        return row.name, ("name",)
    else:
        used = tuple(name for name in USUAL if name in _members(row) and _tells(getattr(row, name)))
    return ", ".join(filter(None, (_word(getattr(row, name)) for name in used))), used


def _tells(value: Any) -> bool:
    return isinstance(value, str | Enum) or _named(value)


def _word(key: Any) -> str:
    """Return a key, or a record that stands for a part, as a word."""
    if isinstance(key, Enum):
        return str(key.value)
    if _named(key):
        return ".".join(filter(None, (_word(getattr(key, name)) for name in _members(key))))
    if isinstance(key, tuple):
        return ".".join(map(_word, key))
    return "" if key is None else str(key)


def groups(answer: Any) -> dict[str, Group]:
    """Return path -> identity -> value, every one of them.

    Args:
        answer: As `values` takes it.
    """
    found: dict[str, Group] = {}
    for path, of, value in values(answer):
        group, name = found.setdefault(path, {}), ", ".join(filter(None, of))
        again = 2
        while name in group:
            name, again = f"{', '.join(filter(None, of))} #{again}".lstrip(), again + 1
        group[name] = value
    return found


def condensed(group: Group) -> Group:
    """Return what is kept of the values of one path.

    Args:
        group: All of them.
    """
    group = {name: 0 if isinstance(value, float) and abs(value) <= ZERO else value for name, value in group.items()}
    one = next(iter(group.values()))
    if len(group) >= EQUAL and one != THERE and len({written(value) for value in group.values()}) == 1:
        return {f"all {len(group)}": one}
    return group if len(group) <= FULL else _summary(group)


def _summary(group: Group) -> Group:
    every = list(group.values())
    if any(isinstance(value, bool | str) for value in every):
        return {f"count of {word}": count for word, count in Counter(map(str, every)).items()}
    return {
        "count": len(every),
        "first": every[0],
        "last": every[-1],
        "least": min(every),
        "greatest": max(every),
        "mean": float(np.mean(every)),
    }


def written(value: Value) -> str:
    """Return a value as a golden file has it.

    Args:
        value: A number has `DIGITS` digits.
    """
    if isinstance(value, float):
        short = float(f"{value:.{DIGITS}g}")
        return json.dumps(int(short) if short.is_integer() and abs(short) < 1e15 else short)
    return json.dumps(value, ensure_ascii=False)


def same(was: Value, now: Value, scale: float = 0.0, zero: float = ZERO) -> bool:
    """Tell whether a value is what it was, but for rounding.

    Args:
        was: As recorded.
        now: As it is.
        scale: Size of the largest value on its path.
        zero: Up to where values are zeros.
    """
    if any(isinstance(value, bool | str) for value in (was, now)):
        return was == now
    if max(abs(was), abs(now)) <= zero:
        return True
    return abs(was - now) <= max(ROUNDING * abs(was), NOISE * min(1.0, scale))


def scale_of(group: Group) -> float:
    """Return the size of the largest number of a path."""
    return max((abs(value) for value in group.values() if not isinstance(value, bool | str)), default=0.0)


class Moved:
    """What moved between a record and now, as lines of a message."""

    def __init__(self) -> None:
        self.changed: list[str] = []
        self.added: list[str] = []
        self.removed: list[str] = []

    def __bool__(self) -> bool:
        return bool(self.changed or self.added or self.removed)

    def compare(self, path: str, kept: Group, group: Group, zero: float = ZERO) -> None:
        """Note how the values of one path differ.

        Args:
            path: With the name of its answer.
            kept: As recorded; empty where the path is new.
            group: All values that it has now; empty where it is gone.
            zero: Up to where values are zeros.
        """
        if not kept or not group:
            new = condensed(group) if group else {}
            self.added += [f"{named(path, name)}: {written(value)}" for name, value in new.items()]
            self.removed += [f"{named(path, name)}: {written(value)}" for name, value in kept.items()]
            return
        scale, first = scale_of(kept), next(iter(kept))
        if first.startswith("all ") and len(kept) == 1:
            if (count := int(first[4:])) != len(group):
                self.changed.append(f"{named(path, 'count')}: {count} -> {len(group)}")
            kept, now = dict.fromkeys(group, kept[first]), group
        else:
            now = _summary(group) if "mean" in kept or first.startswith("count of ") else group
        for name in kept.keys() & now.keys():
            if not same(kept[name], now[name], scale, zero):
                self.changed.append(f"{named(path, name)}: {written(kept[name])} -> {written(now[name])}")
        self.added += [f"{named(path, name)}: {written(now[name])}" for name in now.keys() - kept.keys()]
        self.removed += [f"{named(path, name)}: {written(kept[name])}" for name in kept.keys() - now.keys()]

    def message(self) -> str:
        """Return at most `SHOWN` lines of each kind, and how many more there are."""
        lines = []
        for title, found in (("moved, recorded -> now", self.changed), ("added", self.added), ("gone", self.removed)):
            if found:
                lines += [f"{len(found)} {title}:", *(f"  {line}" for line in sorted(found)[:SHOWN])]
                lines += [f"  and {len(found) - SHOWN} more"] if len(found) > SHOWN else []
        return "\n".join(lines)


def named(path: str, identity: str) -> str:
    """Return the key of a value."""
    return f"{path} [{identity}]" if identity else path


def parsed(key: str) -> tuple[str, str]:
    """Return path and identity of a key."""
    path, _, identity = key.partition(" [")
    return path, identity.removesuffix("]")
