"""Save a simulated run as netCDF-4 (HDF5) and load it again, equal: arrays with dimensions, units and names.

A file holds the design that made it (as JSON, the reader's own form), the case, and one group per part of the `Trace`.
Any netCDF reader opens it; ``xarray.open_dataset(path, group="samples")`` gives labelled arrays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import h5netcdf
import h5py
import numpy as np

from gearwright.dynamics import Labels, Samples, Statistics, Trace
from gearwright.dynamics.equations import Work
from gearwright.dynamics.model import Tone
from gearwright.dynamics.motion import Checkpoints, Orders
from gearwright.errors import DesignError, Problem, by_name
from gearwright.reading import refuse_irregular
from gearwright.showing import Shown
from gearwright.spec import Design, cases_of
from gearwright.store.image import new_netcdf
from gearwright.store.owners import found_owners, read_orders, read_owners, written_orders, written_owners
from gearwright.version import __version__

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
        for dimension, size in zip(dimensions, values.shape, strict=True):
            if dimension not in group.dimensions:
                group.dimensions[dimension] = size
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
