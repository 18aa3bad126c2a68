"""Edits of designs and missions by key path, and the design as TOML text, in which comments, order and units stay."""

from __future__ import annotations

import json
import math
import re
import sys
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import UnionType
from typing import Any, NamedTuple, TypeVar, Union, get_args, get_origin

from pydantic import ValidationError

from gearwright.base import DesignError, Problem, near, refuse, shown, suffix_unit, verb
from gearwright.spec.checks import reference_problems
from gearwright.spec.design import CONCEPT, FATIGUE, PRELIMINARY, RATINGS, STATIC, Design, GearRules
from gearwright.spec.missions import Mission
from gearwright.spec.read import HEADER, KEY, mission_problems
from gearwright.spec.record import (
    Key,
    Location,
    Range,
    Record,
    Written,
    allowed_in,
    brief,
    is_path,
    keys_of,
    longer_keys,
    message_of,
    quantity_of,
)

# ----------------------------------------------------------------------------------------------------------------------
# Change a design or mission by dotted paths in the user's own keys and units: ``motors.electric.speed_rpm`` = 4200.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# A design at another level, and what a design takes by default that states none.
# ----------------------------------------------------------------------------------------------------------------------


LEVELS = (CONCEPT, PRELIMINARY)
"""That a design without bearings of shafts can be sized at."""


@verb
def at_level(design: Design, level: str) -> Design:
    """Return a design at a level: preliminary rates by ISO 6336 what knows no fatigue, and gives planets bearings.

    What the design gives stays, but for the rules of the method that is left; with a life, or rules of ISO 6336, a
    concept is rated by it, too.

    Args:
        design: As read.
        level: ``concept`` or ``preliminary``.

    Raises:
        DesignError: If the level is none of these, or the design has bearings on its shafts.
    """
    if level not in LEVELS:
        raise DesignError([Problem("level", f"{level!r} is not known; {near(level, LEVELS)}")])
    return edited(design, as_concept(design)) if level == CONCEPT else against_fatigue(design, {"level": level})


def as_concept(design: Design) -> dict[str, Value]:
    """Return the changes with which a design is a first sizing: path -> value.

    Args:
        design: As read.
    """
    rules = (design.gears, *_own_rules(design).values())
    fatigue = set(RATINGS[FATIGUE].reads) - set(RATINGS[STATIC].reads)
    implied_rating = design.gears.rating == FATIGUE and "rating" not in design.gears.model_fields_set
    asks = "service" in design.model_fields_set or any(fatigue & one.model_fields_set for one in rules)
    return {"level": CONCEPT, **({"gears.rating": FATIGUE} if implied_rating and asks else {})}


def implied(design: Design) -> dict[str, str]:
    """Return what a design leaves open and its level gives: path -> value, as its file would have them.

    Args:
        design: As read.
    """
    stated = "level" in design.model_fields_set
    entries: dict[str, str] = {} if stated else {"level": design.level}
    if not (stated and design.level == CONCEPT) and "rating" not in design.gears.model_fields_set:
        entries["gears.rating"] = design.gears.rating
    if design.level != CONCEPT:
        for name, stage in design.planetaries.items():
            if stage.planet_bearing is not None and "planet_bearing" not in stage.model_fields_set:
                entries[f"planetaries.{name}.planet_bearing.kind"] = stage.planet_bearing.kind
    return entries


def against_fatigue(design: Design, changes: Mapping[str, Value] | None = None) -> Design:
    """Return a design whose stages are rated against fatigue, by ISO 6336 where their own method knows none.

    Args:
        design: As read; the rules that only the method reads which is left go with it.
        changes: What else is changed: path -> value.

    Raises:
        DesignError: Values that the keys of the design do not allow.
    """
    return edited(_freed(design), {**dict(_rated(design)), **(changes or {})})


def _rated(design: Design) -> Iterator[tuple[str, Value]]:
    """Yield the changes of rules with which every stage is rated against fatigue."""
    tables = {"gears": design.gears} | {f"{design.table(name)}.gears": own for name, own in _own_rules(design).items()}
    for path, rules in tables.items():
        if (path == "gears" or "rating" in rules.model_fields_set) and not RATINGS[rules.rating].fatigue:
            yield f"{path}.rating", FATIGUE


def _own_rules(design: Design) -> dict[str, GearRules]:
    """Return stage -> its own rules, of those that have some."""
    return {name: stage.gears for name, stage in design.stages.items() if stage.gears is not None}


def _freed(design: Design) -> Design:
    """Return a design without the rules that only the method reads which the closure does not rate by."""
    if not RATINGS[design.gears.rating].fatigue:
        design = design.model_copy(update={"gears": _without(design.gears)})
    for name, rules in _own_rules(design).items():
        if not RATINGS[design.rules(name).rating].fatigue:
            kind = design.kind(name)
            stage = design.stages[name].model_copy(update={"gears": _without(rules)})
            design = design.model_copy(update={kind: {**getattr(design, kind), name: stage}})
    return design


def _without(rules: GearRules) -> GearRules:
    """Return rules without those that the former method alone reads."""
    former = set(RATINGS[STATIC].reads) - set(RATINGS[FATIGUE].reads)
    return GearRules.model_validate({key: getattr(rules, key) for key in rules.model_fields_set - former})


# ----------------------------------------------------------------------------------------------------------------------
# A design as the text of a file: what it gives, in the usual units, table by table.
# ----------------------------------------------------------------------------------------------------------------------


HOUR = 3600.0
"""[s]"""
DIGITS = 15
"""Digits of a quantity in its unit, so that 0.0035 m is written as 3.5 mm."""


@verb
def design_text(design: Design) -> str:
    """Return a design as TOML, which `gearwright.read` reads as the same design.

    Only what the design gives is written; defaults stay defaults. Comments of a file that it was read from are lost.

    Args:
        design: As read, edited or closed.
    """
    return "\n".join(_table(design, "")).strip() + "\n"


def _table(record: Record, path: str) -> Iterator[str]:
    """Yield the lines of a table: its own values, then the tables in it."""
    values, tables = list[str](), list[tuple[str, Record | Mapping[str, Any]]]()
    for key, value in _entries(record):
        at = f"{path}.{name_text(key)}" if path else name_text(key)
        if isinstance(value, Record | dict):
            tables.append((at, value))
        else:
            values.append(f"{name_text(key)} = {value_text(value)}")
    if path and (values or not tables):
        yield from ("", f"[{path}]")
    yield from values
    for at, inner in tables:
        yield from _inner(inner, at)


def _inner(inner: Record | Mapping[str, Any], at: str) -> Iterator[str]:
    """Yield a table, or every table of a table of them."""
    if isinstance(inner, Record):
        yield from _table(inner, at)
        return
    plain = [
        f"{name_text(key)} = {value_text(value)}"
        for key, value in inner.items()
        if not isinstance(value, Record | dict)
    ]
    if plain:
        yield from ("", f"[{at}]", *plain)
    for key, value in inner.items():
        if isinstance(value, Record | dict):
            yield from _inner(value, f"{at}.{name_text(key)}")


def _entries(record: Record) -> Iterator[tuple[str, Any]]:
    """Yield what a record gives, each by one of the keys that a file may have for it."""
    fields = type(record).model_fields
    for name, info in fields.items():
        value = getattr(record, name)
        if name not in record.model_fields_set or value is None:
            continue
        key, meant = key_of(type(record), info.alias or name, value)
        yield key, _rounded(meant.written(value)) if meant.suffix else value
    yield from (record.model_extra or {}).items()


def key_of(kind: type[Record], field: str, value: object = None) -> tuple[str, Key]:
    """Return the key of a field in the unit in which people read its quantity, or the first that it has.

    Args:
        kind: Of the record.
        field: As its file has it, without a unit.
        value: That is to be written [SI]: times of an hour and more are read in hours.
    """
    keys = [(key, meant) for key, meant in keys_of(kind).items() if meant.field == field and not meant.inverse]
    quantity = quantity_of(kind.model_fields[field]) if field in kind.model_fields else None
    if quantity is None:
        return keys[0]
    if quantity.dimension == "time" and isinstance(value, float) and value >= HOUR:
        return next((pair for pair in keys if pair[1].factor == HOUR), keys[0])
    return next((pair for pair in keys if math.isclose(pair[1].factor * shown(1.0, quantity.dimension), 1.0)), keys[0])


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")


def name_text(key: str) -> str:
    """Return a key as TOML has it, in quotes where it has dots or other marks.

    Args:
        key: One name.
    """
    return key if is_path(key) and "." not in key and key.isascii() and " " not in key else json.dumps(key)


def value_text(value: Any) -> str:
    """Return a value in TOML.

    Args:
        value: A number, text, truth value, or list of them.
    """
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list | tuple):
        return f"[{', '.join(value_text(entry) for entry in value)}]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


# ----------------------------------------------------------------------------------------------------------------------
# What a changed design gives, as tables in the keys and units of a file: what stands there and is unchanged stays.
# ----------------------------------------------------------------------------------------------------------------------


KEPT_DIGITS = 12
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
    changed = _changed(text, given, _table_in_keys(design, before, given))
    return design_text(design) if changed is None else changed


def _table_in_keys(record: Record, before: object, given: Mapping[str, Any]) -> dict[str, Any]:
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
        return _table_in_keys(value, was, inner)
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
    rounded = float(f"{value:.{KEPT_DIGITS}g}")
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
        return found if _without_empty(tomllib.loads(found)) == _without_empty(wanted) else None
    except (tomllib.TOMLDecodeError, LookupError):
        return None


def _without_empty(value: Any) -> Any:
    """Return tables as they are compared: those without an entry are the same as none."""
    if isinstance(value, Mapping):
        rows = {key: _without_empty(own) for key, own in value.items()}
        return {key: own for key, own in rows.items() if own != {}}
    return [_without_empty(own) for own in value] if isinstance(value, list) else value


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
            self.lines[first] = self.lines[first][:start] + _inline(now) + self.lines[end - 1][stop:]
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
