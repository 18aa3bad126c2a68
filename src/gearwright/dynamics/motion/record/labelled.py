"""Samples of a run with names and units: as an xarray ``Dataset`` and as columns of a table."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from gearwright.arrays import Floats
from gearwright.dynamics.model import Labels
from gearwright.showing import extra

LINES = {"m": ("line", ("force", "N"), ("deflection", "m")), "rad": ("shaft", ("torque", "N m"), ("twist", "rad"))}
"""Unit of a line's deflection -> dimension, and variable with unit of its load and of its deflection."""
COORDINATES = {
    "rad": ("rotation", ("angle", "rad"), ("angular_velocity", "rad/s")),
    "m": ("translation", ("displacement", "m"), ("velocity", "m/s")),
}
"""Unit of a coordinate -> dimension, and variable with unit of its place and of its rate."""


def dataset(samples: Any) -> Any:
    """Return samples as an xarray ``Dataset``: one unit a variable, dimensions whose coordinates are the names.

    Args:
        samples: Of a run.

    Raises:
        DesignError: If xarray is not installed.
    """
    labels: Labels = samples.labels
    lines = (labels.lines, labels.line_units, LINES, (samples.line_force, samples.line_deflection))
    moves = (labels.coordinates, labels.coordinate_units, COORDINATES, (samples.position, samples.velocity))
    variables: dict[str, Any] = {}
    names: dict[str, Any] = {"time": ("time", samples.time, {"units": "s"})}
    for labelled, units, kinds, arrays in (lines, moves):
        for unit, (dimension, *quantities) in kinds.items():
            places = [place for place, own in enumerate(units) if own == unit]
            if places:
                names[dimension] = [labelled[place] for place in places]
                for (name, shown), array in zip(quantities, arrays, strict=True):
                    variables[name] = (("time", dimension), array[:, places], {"units": shown})
    for place, (name, unit) in enumerate(zip(labels.drives, labels.drive_units, strict=True)):
        variables[name] = ("time", samples.drives[:, place], {"units": unit})
    return extra("xarray").Dataset(variables, names)


def line_columns(samples: Any) -> dict[str, tuple[Floats, str]]:
    """Return time, the load of every line and the drives as columns with units.

    Args:
        samples: Of a run.
    """
    return dict(_columns(samples))


def _columns(samples: Any) -> Iterator[tuple[str, tuple[Floats, str]]]:
    labels: Labels = samples.labels
    yield "time", (samples.time, "s")
    for place, (name, unit) in enumerate(zip(labels.lines, labels.line_units, strict=True)):
        yield name, (samples.line_force[:, place], LINES[unit][1][1])
    for place, (name, unit) in enumerate(zip(labels.drives, labels.drive_units, strict=True)):
        yield name, (samples.drives[:, place], unit)
