"""Save and load values: runs as netCDF-4, everything else as JSON."""

import json
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from importlib import import_module
from io import BytesIO
from pathlib import Path
from types import MappingProxyType
from typing import Any

import h5netcdf
import h5py
import numpy as np
from pydantic import BaseModel

from gearwright.base import DesignError, Kind, PartId, Problem, Role, Row, Shown, by_name, verb
from gearwright.dynamics import Labels, Samples, Statistics, Trace
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.equations import Work
from gearwright.dynamics.model import NOBODY, Excitation, Owner, Tone
from gearwright.dynamics.motion import Checkpoints, Orders
from gearwright.files import begins_with, refuse_irregular, text_of, write_bytes, write_text
from gearwright.former_names import present_name
from gearwright.sizing import size
from gearwright.spec import Design, cases_of
from gearwright.version import __version__

# ----------------------------------------------------------------------------------------------------------------------
# NetCDF-4 files, filled in memory and then written whole.
#
# HDF5 ends the process where a disk that is full meets one of its destructors; in memory it meets none.
# ----------------------------------------------------------------------------------------------------------------------


def netcdf_bytes(fill: Callable[[Any], None]) -> bytes:
    """Return a netCDF-4 file as bytes.

    Args:
        fill: What writes into the empty file.
    """
    image = BytesIO()
    with h5netcdf.File(image, "w") as file:
        fill(file)
    return image.getvalue()


@contextmanager
def new_netcdf(path: Path) -> Iterator[Any]:
    """Hold an empty netCDF-4 file to fill; it is written when it is complete.

    Args:
        path: Of the file.

    Raises:
        DesignError: If no file can be there.
        SolveError: If the disk does not take it.
    """
    image = BytesIO()
    with h5netcdf.File(image, "w") as file:
        yield file
    write_bytes(path, image.getbuffer())


# ----------------------------------------------------------------------------------------------------------------------
# Whose the coordinates, lines and numbers of a stored run are: a line of text for each, and for runs without them.
# ----------------------------------------------------------------------------------------------------------------------


def written_owners(owners: Iterable[Owner]) -> str:
    """Return owners as text, one a line.

    Args:
        owners: Of coordinates, lines or numbers of drives.
    """
    return "\n".join(json.dumps([owner.what, *(owner.part or ())]) for owner in owners)


def read_owners(text: str) -> tuple[Owner, ...]:
    """Return owners as they were.

    Args:
        text: From `written_owners`.
    """
    return tuple(_owner(json.loads(line)) for line in text.splitlines())


def _owner(record: object) -> Owner:
    match record:
        case [str(what)]:
            return Owner(None, what)
        case [str(what), str(kind), str(name), None | str() as role, str(branch), None | int() as number, *words]:
            which = None if role is None else Row(role) if kind == Kind.MESH else Role(role)
            return Owner(PartId(Kind(kind), name, which, branch, number, *map(str, words)), what)
    raise ValueError(f"{record} is no owner")


def written_orders(orders: Iterable[Excitation]) -> str:
    """Return orders of machines and teeth as text.

    Args:
        orders: As labelled.
    """
    rows = list(orders)
    return json.dumps({"rows": [row[:5] for row in rows], "owners": written_owners(row.owner for row in rows)})


def read_orders(text: str) -> tuple[Excitation, ...]:
    """Return orders from their text.

    Args:
        text: From `written_orders`; empty: none.
    """
    if not text:
        return ()
    stored = json.loads(text)
    return tuple(
        Excitation(name, tuple((body, float(times)) for body, times in turns), tuple(on), why, float(rate), owner)
        for (name, turns, on, why, rate), owner in zip(stored["rows"], read_owners(stored["owners"]), strict=True)
    )


def found_owners(
    coordinates: Sequence[str], lines: Sequence[str], design: Design | None, case: str
) -> tuple[tuple[Owner, ...], tuple[Owner, ...]]:
    """Return the owners of coordinates and lines of a run that was stored without them: those of its design.

    Args:
        coordinates: Names.
        lines: Names.
        design: That made the run; None where it is not known.
        case: Load case.
    """
    if design is None:
        return (NOBODY,) * len(coordinates), (NOBODY,) * len(lines)
    labels = assemble(size(design), case).labels
    of_coordinate = dict(zip(labels.coordinates, labels.coordinate_owners, strict=True))
    of_line = dict(zip(labels.lines, labels.line_owners, strict=True))
    owners = tuple(of_coordinate.get(name, NOBODY) for name in coordinates)
    return owners, tuple(of_line.get(name, NOBODY) for name in lines)


# ----------------------------------------------------------------------------------------------------------------------
# Save a simulated run as netCDF-4 (HDF5) and load it again, equal: arrays with dimensions, units and names.
#
# A file holds the design that made it (as JSON, the reader's own form), the case, and one group per part of the
# `Trace`. Any netCDF reader opens it; ``xarray.open_dataset(path, group="samples")`` gives labelled arrays.
# ----------------------------------------------------------------------------------------------------------------------


FORMAT, FORMER_FORMAT = "gearwright trace 2", "gearwright trace 1"
"""Of what is written; what else is read: the same, with the variables named as `_FORMER` says."""
_FORMER = {"minimum": "least", "maximum": "most"}

_DIMENSIONS: Mapping[type, Mapping[str, tuple[tuple[str, ...], str]]] = {
    Samples: {
        "time": (("time",), "s"),
        "position": (("time", "coordinate"), "rad or m, see coordinate_unit"),
        "velocity": (("time", "coordinate"), "rad/s or m/s, see coordinate_unit"),
        "line_force": (("time", "line"), "N or N m, see line_unit"),
        "line_deflection": (("time", "line"), "m or rad, see line_unit"),
    },
    Statistics: {
        "edges": (("edge",), "s"),
        "mean": (("bin", "name"), "as the quantity"),
        "minimum": (("bin", "name"), "as the quantity"),
        "maximum": (("bin", "name"), "as the quantity"),
        "rms": (("bin", "name"), "as the quantity"),
    },
    Checkpoints: {"step": (("checkpoint",), "1"), "state": (("checkpoint", "state"), "SI")},
}
"""Array fields of each part: dimensions and unit."""

_STATISTICS = ("force", "deflection", "velocity")
_OWNERS = ("coordinate_owners", "line_owners", "drive_owners")
_SCALARS = ("method", "step", "duration", "error", "rms_error", "tolerance")


@dataclass(frozen=True, eq=False, repr=False)
class StoredRun(Shown):
    """What a file holds."""

    design: Design
    """The design that made the run."""
    case: str
    """Load case."""
    trace: Trace
    """The run."""


def save_run(run: StoredRun | Trace, path: Path) -> None:
    """Write a run to a netCDF-4 file; a file that is there is replaced only when the new one is complete.

    Args:
        run: With the design that made it, or without.
        path: Of the file, usually ``*.nc``.

    Raises:
        DesignError: If no file can be there, or the design has no such case.
        SolveError: If the disk does not take it.
    """
    if isinstance(run, StoredRun):
        by_name(run.case, dict.fromkeys(cases_of(run.design)), "case")
    with new_netcdf(path) as file:
        file.attrs["format"], file.attrs["gearwright"] = FORMAT, __version__
        if isinstance(run, StoredRun):
            file.attrs["design"] = run.design.model_dump_json(by_alias=True, exclude_unset=True)
            file.attrs["case"] = run.case
        _write_trace(file, run.trace if isinstance(run, StoredRun) else run)


def _write_trace(file: Any, trace: Trace) -> None:
    _write_labels(file, trace.labels)
    for name in _SCALARS:
        file.attrs[name] = getattr(trace, name)
    file.attrs["notes"] = "\n".join(trace.notes)
    file.attrs["interrupted"] = int(trace.interrupted)
    file.attrs.update({f"work_{field.name}": getattr(trace.work, field.name) for field in fields(Work)})
    _write_samples(file.create_group("samples"), trace.samples)
    for number, window in enumerate(trace.windows):
        _write_samples(file.create_group(f"window_{number}"), window)
    for name, statistics in _statistics_of(trace).items():
        group = file.create_group(name)
        group.attrs["what"] = statistics.what
        group.attrs["names"] = "\n".join(statistics.names)
        _write_part(group, statistics)
        _write_coordinate(group, "name", statistics.names)
    _write_part(file.create_group("checkpoints"), trace.checkpoints)
    if trace.orders is not None:
        _write_orders(file.create_group("orders"), trace.orders)


def _statistics_of(trace: Trace) -> dict[str, Statistics]:
    """Return the statistics that a run has, by name; only runs with drives have those of drives."""
    statistics = {name: getattr(trace, name) for name in (*_STATISTICS, "drive")}
    return {name: value for name, value in statistics.items() if value is not None}


def load_run(path: str | Path) -> StoredRun:
    """Return the run that a netCDF file holds, with its design.

    Args:
        path: Of the file.

    Raises:
        DesignError: If there is no such file, or it is not one of gearwright's, or holds no design.
    """
    run = read_run(path)
    if isinstance(run, Trace):
        message = "this run was saved without its design; gw.save(gw.StoredRun(design, case, trace), path) keeps both"
        raise DesignError([Problem("", message)], str(path))
    return run


def read_run(path: str | Path) -> StoredRun | Trace:
    """Return the run that a netCDF file holds, equal to what was saved.

    Args:
        path: Of the file.

    Raises:
        DesignError: If there is no such file, or it is not one of gearwright's.
    """
    refuse_irregular(path)
    try:
        with h5netcdf.File(Path(path), "r") as file:
            _check_format(str(file.attrs.get("format", "")), path)
            return _read(file)
    except OSError as error:
        raise DesignError([Problem("", f"the file cannot be read as netCDF-4: {error}")], str(path)) from None
    except (KeyError, ValueError) as error:  # ValueError also of a design that is none
        message = f"the file is incomplete or damaged: {error}; simulate again"
        raise DesignError([Problem("", message)], str(path)) from None


def _check_format(written: str, path: str | Path) -> None:
    """Refuse what is no run, and what a newer version wrote."""
    if written in (FORMAT, FORMER_FORMAT):
        return
    kind, _, number = written.rpartition(" ")
    if kind == FORMAT.rpartition(" ")[0] and number.isdigit():
        message = f"a newer gearwright wrote this run ({written!r}; this one reads {FORMAT!r}); update gearwright"
    else:
        message = "this is not a gearwright run; `gearwright simulate --output` writes one"
    raise DesignError([Problem("", message)], str(path))


def _read(file: Any) -> StoredRun | Trace:
    trace = _read_trace(file)
    design, case = _origin(file)
    return trace if design is None else StoredRun(design, case, trace)


def _origin(file: Any) -> tuple[Design | None, str]:
    """Return the design that made a run, if it is known, and its load case."""
    if "design" not in file.attrs:
        return None, ""
    return Design.model_validate_json(str(file.attrs["design"])), str(file.attrs["case"])


def _read_trace(file: Any) -> Trace:
    labels = _read_labels(file)
    windows = sorted((name for name in file.groups if name.startswith("window_")), key=lambda name: int(name[7:]))
    return Trace(
        method=str(file.attrs["method"]),
        step=float(file.attrs["step"]),
        duration=float(file.attrs["duration"]),
        error=float(file.attrs["error"]),
        work=Work(**{field.name: float(file.attrs[f"work_{field.name}"]) for field in fields(Work)}),
        samples=_read_samples(file.groups["samples"], labels),
        windows=tuple(_read_samples(file.groups[name], labels) for name in windows),
        force=_read_statistics(file.groups["force"]),
        deflection=_read_statistics(file.groups["deflection"]),
        velocity=_read_statistics(file.groups["velocity"]),
        checkpoints=Checkpoints(**_read_part(file.groups["checkpoints"], Checkpoints)),
        notes=_lines(file.attrs["notes"]),
        labels=labels,
        tolerance=float(file.attrs["tolerance"]),
        rms_error=float(file.attrs.get("rms_error", 0.0)),
        interrupted=bool(file.attrs.get("interrupted", 0)),
        orders=_read_orders(file.groups["orders"]) if "orders" in file.groups else None,
        drive=_read_statistics(file.groups["drive"]) if "drive" in file.groups else None,
    )


def _write_part(group: Any, part: Any) -> None:
    for name, (dimensions, unit) in _DIMENSIONS[type(part)].items():
        values = np.asarray(getattr(part, name))
        for dimension, length in zip(dimensions, values.shape, strict=True):
            if dimension not in group.dimensions:
                group.dimensions[dimension] = length
        variable = group.create_variable(name, dimensions, values.dtype, data=values)
        variable.attrs["units"] = unit


def _read_part(group: Any, kind: type) -> dict[str, Any]:
    names = {name: name if name in group.variables else _FORMER.get(name, name) for name in _DIMENSIONS[kind]}
    return {name: np.asarray(group.variables[stored][...]) for name, stored in names.items()}


def _write_samples(group: Any, samples: Samples) -> None:
    """Write instants, with what drives did where there are any."""
    _write_part(group, samples)
    for dimension, names in (("coordinate", samples.labels.coordinates), ("line", samples.labels.lines)):
        _write_coordinate(group, dimension, names)
    if samples.labels.drives:
        group.dimensions["drive"] = len(samples.labels.drives)
        variable = group.create_variable("drives", ("time", "drive"), float, data=samples.drives)
        variable.attrs["units"] = "see drive_unit"
        _write_coordinate(group, "drive", samples.labels.drives)


def _write_coordinate(group: Any, dimension: str, names: Sequence[str]) -> None:
    """Write what the places along a dimension are, so that readers of netCDF select by name."""
    if names:
        group.create_variable(dimension, (dimension,), h5py.string_dtype(), data=np.array(names, dtype=object))


def _read_samples(group: Any, labels: Labels) -> Samples:
    part = _read_part(group, Samples)
    drives = np.asarray(group.variables["drives"][...]) if labels.drives else np.zeros((len(part["time"]), 0))
    return Samples(**part, labels=labels, drives=drives)


def _write_orders(group: Any, orders: Orders) -> None:
    """Write complex amplitudes as real and imaginary part, which every reader knows."""
    group.attrs["names"], group.attrs["tones"] = _joined(orders.names), _joined(map(_written_tone, orders.tones))
    group.dimensions.update(dict(zip(("bin", "name", "tone"), orders.amplitude.shape, strict=True)))
    group.dimensions["edge"] = len(orders.edges)
    group.create_variable("edges", ("edge",), float, data=orders.edges).attrs["units"] = "s"
    for part in ("real", "imag"):
        variable = group.create_variable(part, ("bin", "name", "tone"), float, data=getattr(orders.amplitude, part))
        variable.attrs["units"] = "N or N m, see line_unit"


def _read_orders(group: Any) -> Orders:
    edges, real, imag = (np.asarray(group.variables[name][...]) for name in ("edges", "real", "imag"))
    tones = tuple(map(_read_tone, _lines(group.attrs["tones"])))
    return Orders(_lines(group.attrs["names"]), tones, edges, real + 1j * imag)


def _read_statistics(group: Any) -> Statistics:
    names = _lines(group.attrs["names"])
    return Statistics(names=names, what=str(group.attrs["what"]), **_read_part(group, Statistics))


def _write_labels(file: Any, labels: Labels) -> None:
    """Write names as text with one name a line: plain attributes that every reader shows."""
    file.attrs["coordinates"], file.attrs["coordinate_unit"] = (
        _joined(labels.coordinates),
        _joined(labels.coordinate_units),
    )
    file.attrs["lines"], file.attrs["line_unit"] = _joined(labels.lines), _joined(labels.line_units)
    file.attrs["line_kinds"] = _joined(labels.line_kinds)
    for name in _OWNERS:
        file.attrs[name] = written_owners(getattr(labels, name))
    file.attrs["tones"] = _joined(map(_written_tone, labels.tones))
    file.attrs["orders"] = written_orders(labels.orders)
    file.attrs["drives"], file.attrs["drive_unit"] = _joined(labels.drives), _joined(labels.drive_units)


def _read_labels(file: Any) -> Labels:
    names = {name: _lines(file.attrs[name]) for name in ("coordinates", "lines")}
    owners = {name: read_owners(str(file.attrs[name])) for name in _OWNERS if name in file.attrs}
    if not owners:
        found = found_owners(names["coordinates"], names["lines"], *_origin(file))
        owners = dict(zip(_OWNERS, found, strict=False))
    return Labels(
        coordinates=names["coordinates"],
        coordinate_units=_lines(file.attrs["coordinate_unit"]),
        lines=names["lines"],
        line_units=_lines(file.attrs["line_unit"]),
        line_kinds=_lines(file.attrs["line_kinds"]),
        tones=tuple(map(_read_tone, _lines(file.attrs["tones"]))),
        drives=_lines(file.attrs.get("drives", "")),
        drive_units=_lines(file.attrs.get("drive_unit", "")),
        orders=read_orders(str(file.attrs.get("orders", ""))),
        **owners,
    )


def _written_tone(tone: Tone) -> str:
    return "\t".join(f"{count} {name}" for name, count in tone.counts)


def _read_tone(line: str) -> Tone:
    parts = (part.partition(" ") for part in line.split("\t") if part)
    return Tone(tuple((name, int(count)) for count, _, name in parts))


def _joined(names: Any) -> str:
    return "\n".join(names)


def _lines(text: Any) -> tuple[str, ...]:
    return tuple(str(text).split("\n")) if str(text) else ()


# ----------------------------------------------------------------------------------------------------------------------
# Values as trees of JSON and back, bit for bit: records, arrays, mappings, tuples, enumerations, numbers.
#
# Text, whole numbers, finite floats, True, False and None stand as they are, a tuple is a list, a mapping of plain
# names an object; everything else is an object with one ``$`` key. Records are named by their module and class, and
# only records and enumerations of gearwright are made from a name: nothing in a file is run.
# ----------------------------------------------------------------------------------------------------------------------


_ROOM = "gearwright."
_NAME = re.compile(r"[a-z][a-z0-9_]*(\.[a-z][a-z0-9_]*)*:[A-Za-z_][A-Za-z0-9_]*(\.[A-Za-z_][A-Za-z0-9_]*)*")
_DTYPE = re.compile(r"\|b1|[<>|][iu][1248]|[<>]f[248]|[<>]c(8|16)|[<>]U[0-9]+")
_PLAIN = (bool, int, str)
_TAG = "$"


class Unkept(Exception):
    """A value that no file keeps; with where it stands."""


class Damaged(Exception):
    """A tree that no value makes."""


def is_record(kind: type) -> bool:
    """Tell whether files keep a class: a frozen dataclass, a named tuple or a record of files, of gearwright.

    Args:
        kind: The class.
    """
    if not kind.__module__.startswith(_ROOM) or "<" in kind.__qualname__:
        return False
    named = issubclass(kind, tuple) and hasattr(kind, "_fields")
    frozen = is_dataclass(kind) and kind.__dataclass_params__.frozen  # type: ignore[attr-defined]
    return named or frozen or issubclass(kind, BaseModel)


def encoded(value: object, at: str = "") -> Any:
    """Return a value as a tree.

    Args:
        value: Of records, arrays, mappings, tuples, enumerations and numbers.
        at: Where it stands, for the message.

    Raises:
        Unkept: It holds something else.
    """
    kind = type(value)
    if value is None or kind in _PLAIN:
        return value
    if isinstance(value, float) and kind is float:
        return value if math.isfinite(value) else {"$float": str(value)}
    if isinstance(value, Enum) and kind.__module__.startswith(_ROOM):
        return {"$enum": _name(kind), "value": encoded(value.value, at)}
    if is_record(kind):
        members = {name: encoded(member, f"{at}.{name}") for name, member in _members(value)}
        return {"$record": _name(kind), "fields": members}
    if isinstance(value, np.ndarray | np.generic):
        return _array(value, at)
    return _container(value, at)


def _name(kind: type) -> str:
    return f"{kind.__module__.removeprefix(_ROOM)}:{kind.__qualname__}"


def _members(value: Any) -> list[tuple[str, object]]:
    """Return the fields of a record; of a record of a file those that were given."""
    if isinstance(value, BaseModel):
        declared = [name for name in type(value).model_fields if name in value.model_fields_set]
        return [*((name, getattr(value, name)) for name in declared), *(value.model_extra or {}).items()]
    names = [field.name for field in fields(value) if field.init] if is_dataclass(value) else value._fields
    return [(name, getattr(value, name)) for name in names]


def _array(value: Any, at: str) -> dict[str, Any]:
    """Return an array, or one of its numbers, with its type."""
    if not _DTYPE.fullmatch(value.dtype.str):
        raise Unkept(f"{at} is an array of {value.dtype}")
    flat = np.ravel(value)
    flat = flat.view(f"{flat.dtype.str[0]}f{flat.dtype.itemsize // 2}") if flat.dtype.kind == "c" else flat
    values = flat.tolist()
    if flat.dtype.kind == "f" and not np.isfinite(flat).all():
        values = [number if math.isfinite(number) else str(number) for number in values]
    tag = "$array" if isinstance(value, np.ndarray) else "$scalar"
    return {tag: value.dtype.str, "shape": list(value.shape), "values": values}


def _container(value: object, at: str) -> Any:
    kind = type(value)
    if isinstance(value, tuple | list) and kind in (tuple, list):
        members = [encoded(member, f"{at}[{k}]") for k, member in enumerate(value)]
        return members if kind is tuple else {"$list": members}
    if isinstance(value, complex) and kind is complex:
        return {"$complex": [encoded(value.real), encoded(value.imag)]}
    if isinstance(value, Path):
        return {"$path": str(value)}
    if isinstance(value, MappingProxyType):
        return {"$fixed": encoded(dict(value), at)}
    if isinstance(value, dict) and kind is dict:
        return _mapping(value, at)
    raise Unkept(f"{at or 'the value'} is of type {kind.__name__}")


def _mapping(value: Mapping[Any, object], at: str) -> dict[str, Any]:
    if all(type(key) is str and not key.startswith(_TAG) for key in value):
        return {key: encoded(member, f"{at}[{key!r}]") for key, member in value.items()}
    return {"$pairs": [[encoded(key, at), encoded(member, f"{at}[{key!r}]")] for key, member in value.items()]}


def decoded(tree: Any) -> Any:
    """Return the value of a tree.

    Args:
        tree: As `encoded` makes it.

    Raises:
        Damaged: It is none, or names what gearwright does not have.
    """
    if isinstance(tree, list):
        return tuple(decoded(member) for member in tree)
    if not isinstance(tree, dict):
        return tree
    if not any(key.startswith(_TAG) for key in tree):
        return {key: decoded(member) for key, member in tree.items()}
    try:
        return _made(tree)
    except (TypeError, ValueError, KeyError, OverflowError, AttributeError) as error:
        raise Damaged(f"{next(iter(tree.values()))}: {error}") from None


def _made(tree: dict[str, Any]) -> Any:
    """Return the value of an object with a tag."""
    match tree:
        case {"$record": str(name), "fields": dict(members)}:
            return _record(name, members)
        case {"$enum": str(name), "value": value}:
            return _enum(name, value)
        case {"$array": str(dtype), "shape": list(shape), "values": list(values)}:
            return _numbers(dtype, shape, values)
        case {"$scalar": str(dtype), "shape": [], "values": list(values)}:
            return _numbers(dtype, [], values)[()]
        case {"$float": "inf" | "-inf" | "nan" as number}:
            return float(number)
        case {"$complex": [real, imaginary]}:
            return complex(decoded(real), decoded(imaginary))
        case {"$list": list(members)}:
            return [decoded(member) for member in members]
        case {"$fixed": members}:
            return MappingProxyType(decoded(members))
        case {"$pairs": list(pairs)}:
            return dict(decoded(pairs))
        case {"$path": str(path)}:
            return Path(path)
        case _:
            raise Damaged(f"{next(key for key in tree if key.startswith(_TAG))!r} is not known")


def _record(record: str, fields: dict[str, Any]) -> Any:
    kind: Any = _class(record)
    if not is_record(kind):
        raise Damaged(f"{record} is no record")
    members = {name: decoded(member) for name, member in fields.items()}
    if issubclass(kind, BaseModel):
        known = kind.model_fields
        return kind.model_validate(
            {(known[name].alias or name) if name in known else name: value for name, value in members.items()}
        )
    return kind(**members)


def _enum(enum: str, value: Any) -> Any:
    kind = _class(enum)
    if not issubclass(kind, Enum):
        raise Damaged(f"{enum} is no enumeration")
    return kind(decoded(value))


def _class(name: str) -> type:
    """Return a class of gearwright by its name in a file; nothing else is looked up."""
    if not _NAME.fullmatch(name):
        raise Damaged(f"{name!r} is no name of a record")
    found, module = _found(name), name.partition(":")[0]
    if found is None:  # a file of before
        now = present_name(name)
        found, module = _found(now), now.partition(":")[0]
    if found is None:
        raise Damaged(f"this version has no {name}")
    if not isinstance(found, type) or found.__module__ != _ROOM + module:
        raise Damaged(f"{name} is no record")
    return found


def _found(name: str) -> Any:
    """Return what a module has by a name, or None."""
    module, _, path = name.partition(":")
    try:
        found: Any = import_module(_ROOM + module)
        for part in path.split("."):
            found = vars(found)[part]
    except (ImportError, KeyError, TypeError):
        return None
    return found


def _numbers(dtype: str, shape: list[int], values: list[Any]) -> Any:
    if not _DTYPE.fullmatch(dtype) or any(size < 0 for size in shape) or any(isinstance(v, list) for v in values):
        raise ValueError("no array of numbers or texts")
    kind = np.dtype(dtype)
    if kind.kind == "c":
        return np.array(values, f"{dtype[0]}f{kind.itemsize // 2}").view(kind).reshape(shape)
    return np.array(values, kind).reshape(shape)


# ----------------------------------------------------------------------------------------------------------------------
# The verbs: any value of gearwright's verbs into one file, and back as it was.
#
# Runs are netCDF-4, because other tools read their samples; everything else is JSON: text, that nothing has to be
# installed for, with arrays by type and shape.
# ----------------------------------------------------------------------------------------------------------------------


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
