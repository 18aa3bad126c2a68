"""The verbs: any value of gearwright's verbs into one file, and back as it was.

Runs are netCDF-4, because other tools read their samples; everything else is JSON: text, that nothing has to be
installed for, with arrays by type and shape.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gearwright.dynamics import Trace
from gearwright.errors import DesignError, Problem
from gearwright.reading import begins_with, text_of
from gearwright.store.netcdf import StoredRun, read_run, save_run
from gearwright.store.tree import Damaged, Unkept, decoded, encoded, is_record
from gearwright.verbs import verb
from gearwright.version import __version__
from gearwright.writing import write_text

KIND = "gearwright value"
"""What stands first in a file."""
VERSION = 1
"""Of the form of the file."""
LARGEST = 2_000_000_000
"""Largest file that is read [bytes]."""
_HDF = b"\x89HDF"
"""How netCDF-4 begins."""


@verb
def save(value: object, path: str | Path) -> None:
    """Write a value to a file; a file that is there is replaced only when the new one is complete.

    Args:
        value: What a verb of gearwright returned: a design, mission, sizing, system, modes, flight, trace, study, or
            several of them as a tuple, list or dict. A run with its design is a `StoredRun`.
        path: Of the file; a trace and a run become netCDF-4, usually ``*.nc``, all else JSON.

    Raises:
        DesignError: If the value is none of gearwright's, or no file can be there.
        SolveError: If the disk does not take it.
    """
    if isinstance(value, StoredRun | Trace):
        save_run(value, Path(path))
        return
    write_text(Path(path), text_of_value(value))


def text_of_value(value: object) -> str:
    """Return what `save` writes of a value that is no run.

    Args:
        value: What a verb of gearwright returned.

    Raises:
        DesignError: If the value is none of gearwright's.
    """
    if not _kept(value):
        raise DesignError([Problem("value", f"{_shown(value)}; give what a verb returned, as gw.size(design)")], "save")
    try:
        tree = encoded(value, type(value).__name__)
    except Unkept as unkept:
        message = f"{unkept}, which no file keeps; give what a verb returned, as gw.size(design)"
        raise DesignError([Problem("value", message)], "save") from None
    head = {"format": KIND, "version": VERSION, "gearwright": __version__}
    return json.dumps({**head, "value": tree}, allow_nan=False) + "\n"


def _kept(value: object) -> bool:
    """Tell whether a value is a record, or holds some."""
    if isinstance(value, tuple | list | dict) and not is_record(type(value)):
        members = list(value.values()) if isinstance(value, dict) else list(value)
        return bool(members) and all(_kept(member) for member in members)
    return is_record(type(value))


def _shown(value: object) -> str:
    kind = type(value).__name__
    return f"an empty {kind}" if isinstance(value, tuple | list | dict) and not value else f"this is of type {kind}"


@verb
def load(path: str | Path) -> Any:
    """Return the value that a file holds, equal to what was saved; of a run with its design a `StoredRun`.

    Args:
        path: Of the file.

    Raises:
        DesignError: If there is no such file, it is not one of gearwright's, is damaged, or a newer version wrote it.
    """
    if begins_with(path, _HDF):
        return read_run(path)
    head = _head(path)
    try:
        return decoded(head["value"])
    except (Damaged, RecursionError) as damage:
        message = f"the file is incomplete or damaged ({damage}); save the value again"
        raise DesignError([Problem("", message)], str(path)) from None


def _head(path: str | Path) -> dict[str, Any]:
    """Return the file as an object, if gearwright wrote it and this version reads it."""
    try:
        head = json.loads(text_of(path, largest=LARGEST))
    except (ValueError, RecursionError) as error:
        message = f"the file is damaged, or none of gearwright's: {error}; gw.save(value, path) writes one"
        raise DesignError([Problem("", message)], str(path)) from None
    if not isinstance(head, dict) or head.get("format") != KIND or "value" not in head:
        raise DesignError([Problem("", "gw.save did not write this file; gw.save(value, path) writes one")], str(path))
    version = head.get("version")
    if version != VERSION:
        newer = isinstance(version, int) and version > VERSION
        fix = "update gearwright" if newer else "save the value again"
        by = f"gearwright {head.get('gearwright', '?')}"
        message = f"{by} wrote this file in form {version}; this version reads form {VERSION}: {fix}"
        raise DesignError([Problem("version", message)], str(path))
    return head
