"""A file as read, entry by entry, and what is shipped."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from pydantic.fields import FieldInfo

from gearwright.base import KWH, text
from gearwright.shipped import (
    shipped_design,
    shipped_designs,
    shipped_mission,
    shipped_missions,
    shipped_mix,
    shipped_mixes,
    shipped_notebook,
    shipped_notebooks,
    shipped_studies,
    shipped_study,
)
from gearwright.shipped.gallery import notebook_title
from gearwright.spec import (
    Design,
    Mission,
    Record,
    quantity_of,
    read,
    read_mission,
    read_mix,
    read_study,
)

# ----------------------------------------------------------------------------------------------------------------------
# A design or a mission as read: every entry with its unit, and which ones are defaults.
# ----------------------------------------------------------------------------------------------------------------------


_IN_THE_HEAD = ("schema_version", "name", "description")
"""What the page's head shows already."""
_OF_A_STAGE = re.compile(r"(pairs|planetaries)\.[^.]+\.gears\..")
"""Rules of one stage, which are the design's where it does not state its own."""
_LARGER = {"time": ((3600.0, "life"), (60.0, "flight_time")), "energy": ((KWH, "electric_energy"),)}
"""Dimension -> values from which on it is shown as another dimension does, the largest first."""


@dataclass(frozen=True)
class Entry:
    """One value of the file."""

    path: str
    """Dotted path in the file, without the unit of the key."""
    value: str
    """With its unit."""
    is_given: bool
    """True if the file states it, False for a default."""
    meaning: str
    """What it is."""
    key: str = ""
    """Last part of the path."""


def entries(written: Design | Mission) -> tuple[Entry, ...]:
    """Return every value of a file, in the order of its types; without name, description and what is left open.

    Args:
        written: As read.
    """
    return tuple(_entries_of_record("", written, written.model_fields_set))


def _entries_of_record(path: str, record: Record, given: set[str]) -> Iterator[Entry]:
    for name, info in type(record).model_fields.items():
        value = getattr(record, name)
        key = info.alias if info.alias and quantity_of(info) is None else name
        where = f"{path}.{key}" if path else key
        if value is None or value in ({}, "", []) or where in _IN_THE_HEAD:
            continue
        if _OF_A_STAGE.match(where) and name not in given:
            continue
        if isinstance(value, Record):
            yield from _entries_of_record(where, value, value.model_fields_set)
        elif isinstance(value, Mapping):
            yield from _table(where, value, info)
        else:
            yield Entry(where, _words(value, info), name in given, info.description or "", key)
    for name, table in (record.model_extra or {}).items():  # machines of a case
        yield from _entries_of_record(f"{path}.{name}", table, table.model_fields_set)


def _table(path: str, table: Mapping[str, object], info: FieldInfo) -> Iterator[Entry]:
    for name, value in table.items():
        where = f"{path}.{name}"
        if isinstance(value, Record):
            yield from _entries_of_record(where, value, value.model_fields_set)
        elif isinstance(value, Mapping):
            yield from _table(where, value, info)
        else:
            yield Entry(where, str(value), is_given=True, meaning=info.description or "", key=name)


def _words(value: object, info: FieldInfo) -> str:
    quantity = quantity_of(info)
    if quantity is not None and isinstance(value, int | float):
        # A value in its usual unit, or in a larger one where that reads better.
        for least, larger in _LARGER.get(quantity.dimension, ()):
            if abs(value) >= least:
                return text(value, larger)
        return text(value, quantity.dimension)
    if isinstance(value, list | tuple):
        return ", ".join(map(str, value))
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value)


# ----------------------------------------------------------------------------------------------------------------------
# What comes with gearwright: every shipped file with its kind, its name and its title.
# ----------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ShippedFile:
    """A file that comes with gearwright."""

    kind: Literal["design", "mission", "mix", "study", "notebook"]
    name: str
    """For the commands."""
    title: str


def shipped_files() -> tuple[ShippedFile, ...]:
    """Return designs, missions, mixes, studies and notebooks, each kind by name."""
    return (
        *(ShippedFile("design", name, read(shipped_design(name)).name) for name in shipped_designs()),
        *(ShippedFile("mission", name, read_mission(shipped_mission(name)).name) for name in shipped_missions()),
        *(ShippedFile("mix", name, read_mix(shipped_mix(name)).name) for name in shipped_mixes()),
        *(ShippedFile("study", name, read_study(shipped_study(name)).name) for name in shipped_studies()),
        *(ShippedFile("notebook", name, notebook_title(shipped_notebook(name))) for name in shipped_notebooks()),
    )
