"""Change a design or mission by dotted paths in the user's own keys and units: ``motors.electric.speed_rpm`` = 4200."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from types import UnionType
from typing import Any, NamedTuple, TypeVar, Union, get_args, get_origin

from pydantic import ValidationError

from gearwright.errors import DesignError, Problem, near, refuse
from gearwright.spec.bounds import Range, allowed_in
from gearwright.spec.checks import reference_problems
from gearwright.spec.design import Design
from gearwright.spec.flying import mission_problems
from gearwright.spec.keys import Key, keys_of, longer_keys
from gearwright.spec.missions import Mission
from gearwright.spec.record import Location, Record, Written, brief, message_of
from gearwright.units import suffix_unit
from gearwright.verbs import verb

Value = float | int | str | bool | list[Any] | dict[str, Any] | None
"""What an entry may be changed to; None leaves it out, a table stands for the whole one."""
R = TypeVar("R", bound=Record)


@verb
def edited(design: Design, changes: Mapping[str, Value]) -> Design:
    """Return a design with some of its entries changed; the design itself stays as it is.

    Args:
        design: Where to start.
        changes: Dotted path, with the unit in its last part, -> value in that unit.

    Raises:
        DesignError: For every path that does not exist (with the nearest one) and every value that is not allowed.
    """
    return _edited(design, changes, reference_problems)


@verb
def edited_mission(mission: Mission, changes: Mapping[str, Value]) -> Mission:
    """Return a mission with some of its entries changed, as `edited` does it with a design.

    Args:
        mission: Where to start.
        changes: Dotted path, with the unit in its last part, -> value in that unit.

    Raises:
        DesignError: For every path that does not exist, value that is not allowed, and what does not fit together.
    """
    return _edited(mission, changes, mission_problems)


class Entry(NamedTuple):
    """Where a number of a record stands."""

    location: Location
    """Names of fields and entries that lead to it."""
    key: Key | None
    """How it is written; None of what has no unit."""
    allowed: Range
    """Numbers that it takes [SI]."""

    def si(self, value: float) -> float:
        """Return what is written in SI."""
        return value if self.key is None else self.key.si(value)


def entry_of(design: Design, path: str) -> Entry | None:
    """Return where a path leads in a design; None where no plain number stands there.

    Args:
        design: That has the entry.
        path: Dotted path, with the unit in its last part.
    """
    written = Written()
    if _set(Design, _opened(design), path, 1.0, written) is not None or len(written.keys) != 1:
        return None
    (location,) = written.keys
    holder = _held(design, location[:-1])
    if not isinstance(holder, Record) or type(getattr(holder, location[-1], None)) is not float:
        return None
    return Entry(location, written.units.get(location), allowed_in(type(holder), location[-1]).numbers)


class Standing(NamedTuple):
    """What a path leads to."""

    value: Any
    """As it would be written there, in the unit of the path; None where nothing is written."""
    suffix: str
    """Of the unit; empty of what has none."""
    whole: bool
    """True where only whole numbers, texts or tables may stand."""


def standing_at(record: Record, path: str) -> Standing:
    """Return what a path leads to in a design or mission.

    Args:
        record: That has the entry.
        path: Dotted path, with the unit in its last part.
    """
    written = Written()
    if _set(type(record), _opened(record), path, 1.0, written) is not None or len(written.keys) != 1:
        return Standing(None, "", whole=False)
    (location,) = written.keys
    stands, key = getattr(_held(record, location[:-1]), location[-1], None), written.units.get(location)
    if key is not None and isinstance(stands, float):
        stands = key.written(stands)
    return Standing(stands, key.suffix if key else "", whole=not _takes_parts(written.fields[location].annotation))


def _takes_parts(annotation: Any) -> bool:
    """Tell whether numbers that are not whole may stand under an annotation."""
    return annotation is float or any(map(_takes_parts, get_args(annotation)))


def _held(content: Any, location: Location) -> Any:
    """Return what stands at a location."""
    for part in location:
        if isinstance(content, Record):
            content = (
                getattr(content, part, None)
                if part in type(content).model_fields
                else ((content.model_extra or {}).get(part))
            )
        else:
            content = content.get(part) if isinstance(content, dict) else None
    return content


def replaced(record: R, entries: Mapping[Location, Any]) -> R:
    """Return a record with other values at some of its places, which nobody checks.

    Args:
        record: Where to start.
        entries: Location -> value, in SI and of the type that the place takes.
    """
    below: dict[str, dict[Location, Any]] = {}
    for location, value in entries.items():
        below.setdefault(location[0], {})[location[1:]] = value
    changed = {name: _replaced(_held(record, (name,)), inner) for name, inner in below.items()}
    extra = {name: value for name, value in changed.items() if name not in type(record).model_fields}
    copy = record.model_copy(update={name: value for name, value in changed.items() if name not in extra})
    if extra:
        object.__setattr__(copy, "__pydantic_extra__", {**(record.model_extra or {}), **extra})
    for name in copy.__dict__.keys() - type(record).model_fields.keys():
        del copy.__dict__[name]  # what was remembered of the record as it was
    return copy


def _replaced(content: Any, entries: Mapping[Location, Any]) -> Any:
    if () in entries:
        return entries[()]
    if isinstance(content, Record):
        return replaced(content, entries)
    names = dict.fromkeys(location[0] for location in entries)
    return {**content, **{
        name: _replaced(content[name], {at[1:]: value for at, value in entries.items() if at[0] == name})
        for name in names
    }}  # fmt: skip


def _edited(record: R, changes: Mapping[str, Value], problems_of: Callable[[R], list[Problem]]) -> R:
    data, kind, written = _opened(record), type(record), Written()
    refuse(problem for path, value in changes.items() if (problem := _set(kind, data, path, value, written)))
    try:
        changed = kind.model_validate(data)
    except ValidationError as error:
        raise DesignError(_problem(details, written) for details in error.errors(include_url=False)) from None
    refuse(problems_of(changed))
    return changed


def _problem(details: Any, written: Written) -> Problem:
    """Return what pydantic found, in the key and unit of the change that it is about."""
    location = tuple(map(str, details["loc"]))
    return Problem(written.keys.get(location, ".".join(location)), message_of(details, written, location))


def path_problem(record: Record, path: str) -> Problem | None:
    """Return why a path has no place in a design or mission, or None if it has.

    Args:
        record: The design or mission.
        path: Dotted path with the unit in its last part.
    """
    return next(iter(path_problems(record, [path])), None)


def path_problems(record: Record, paths: Iterable[str]) -> list[Problem]:
    """Return which paths have no place in a design or mission, and which mean an entry that another one means.

    Args:
        record: The design or mission.
        paths: Dotted paths with the unit in their last part.
    """
    data, written, problems = _opened(record), Written(), list[Problem]()
    for path in paths:
        problem = _set(type(record), data, path, 0.0, written)
        if problem is None and isinstance(record, Design):
            problem = _misnamed(data, path)
        problems += [] if problem is None else [problem]
    return problems


def _misnamed(data: dict[str, Any], path: str) -> Problem | None:
    """Return why the table of a path, which it may just have made, belongs to nothing in a design."""
    try:
        problems = reference_problems(Design.model_validate(data))
    except ValidationError:  # the value that stands for others is not allowed here: the real ones are checked later
        return None
    table = path.rpartition(".")[0]
    return next((Problem(path, problem.message) for problem in problems if problem.path == table), None)


def _opened(content: Any) -> dict[str, Any]:
    """Return what a record or table holds, as a new table; what lies deeper stays as it is, already checked."""
    if isinstance(content, Record):
        fields = type(content).model_fields
        given = [name for name in fields if name in content.model_fields_set]
        return {fields[name].alias or name: getattr(content, name) for name in given} | (content.model_extra or {})
    return dict(content or {})


def _set(kind: type[Record], data: dict[str, Any], path: str, value: Value, written: Written) -> Problem | None:
    """Put one value into an opened record and note what is written, or say why it has no place there."""
    annotation: Any = kind
    table, parts, depth = data, path.replace('"', "").split("."), 0
    location: Location = ()
    while depth < len(parts):
        part, last = parts[depth], depth == len(parts) - 1
        record = _record(annotation)
        if record is None:
            inner = get_args(annotation)[1]
            if not _holds_tables(inner):
                table[".".join(parts[depth:])] = value
                return None
            entry = _entry(table, parts[depth:]) or _new_entry(inner, parts[depth:])
            if entry is None:
                return Problem(
                    path,
                    f"there is no {'.'.join(parts[: depth + 1])}; {near('.'.join(parts[depth:-1]) or part, table)}",
                )
            table[entry] = _opened(table.get(entry))
            annotation, table, depth, location = inner, table[entry], depth + entry.count(".") + 1, (*location, entry)
            continue
        keys = keys_of(record)
        if part not in keys and record.others is not None and not last:
            table[part] = _opened(table.get(part))
            annotation, table, depth, location = record.others, table[part], depth + 1, (*location, part)
            continue
        if part not in keys:
            hint = longer_keys(part, keys) or near(part, keys)
            return Problem(path, f"there is no {'.'.join(parts[: depth + 1])}; {hint}")
        meant = keys[part]
        name, suffix = meant.field, meant.suffix
        if last and suffix and value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
            return Problem(path, f"{brief(value)} is not a number; give a number in {suffix_unit(suffix)}")
        if last and suffix and isinstance(value, int) and abs(value) > sys.float_info.max:
            fix = f"give a finite number in {suffix_unit(suffix)}"
            return Problem(path, f"{brief(value)} is not a finite number; {fix}")
        if last:
            if (*location, name) in written.keys:
                return Problem(path, f"{name} is given twice; keep one of {written.keys[(*location, name)]} and {path}")
            table[name] = meant.si(value) if suffix and isinstance(value, int | float) else value
            written.note((*location, name), path, value, model=record, unit=meant)
            return None
        annotation = _plain(record.model_fields[name].annotation)
        if not _holds_tables(annotation):
            return Problem(path, f"{'.'.join(parts[: depth + 1])} has no entries")
        table[name] = _opened(table.get(name))
        table, depth, location = table[name], depth + 1, (*location, name)
    return Problem(path, "this is a table; name one of its entries")


def _entry(table: dict[str, Any], parts: list[str]) -> str | None:
    """Return the entry that a path goes on with; the name of a gear, such as ``first.pinion``, has dots itself."""
    names = [".".join(parts[:count]) for count in range(len(parts), 0, -1)]
    return next((name for name in names if name in table), None)


def _new_entry(annotation: Any, parts: list[str]) -> str | None:
    """Return the name of an entry that a path may add: of records that need nothing, such as the errors of a gear."""
    record = _record(annotation)
    if record is None or record.others is not None or len(parts) < 2:
        return None
    return None if any(info.is_required() for info in record.model_fields.values()) else ".".join(parts[:-1])


def _plain(annotation: Any) -> Any:
    """Return an annotation without its None."""
    if get_origin(annotation) in (Union, UnionType):
        return next(part for part in get_args(annotation) if part is not type(None))
    return annotation


def _record(annotation: Any) -> type[Record] | None:
    return annotation if isinstance(annotation, type) and issubclass(annotation, Record) else None


def _holds_tables(annotation: Any) -> bool:
    return _record(annotation) is not None or get_origin(annotation) is dict
