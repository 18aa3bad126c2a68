"""The study file: designs, axes over dotted paths of them, and the results that are asked for."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path
from typing import Literal, cast

from pydantic import Field

from gearwright.errors import DesignError, Problem
from gearwright.spec.lines import key_lines, line_of
from gearwright.spec.read import file_text
from gearwright.spec.record import Record, build

Value = float | int | str | bool
MOST_CASES = 10_000_000
"""More cases than this are refused: at 2 ms each they would take half a day."""


class Axis(Record):
    """The values that one entry of the design takes: a list, or equal steps from a first to a last one."""

    values: list[Value] | None = Field(None, min_length=1, description="The values themselves")
    first: float | None = Field(None, alias="from", description="First value of equal steps")
    last: float | None = Field(None, alias="to", description="Last value of equal steps")
    step: float | None = Field(None, gt=0, description="Step between values")


class Study(Record):
    """Designs varied along axes, with results by name."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the study")
    description: str = Field("", description="What it answers")
    designs: list[str] = Field(min_length=1, description="Design files, or names of shipped designs")
    axes: dict[str, Axis] = Field(default_factory=dict, description="Dotted path with unit -> values")
    changes: dict[str, Value] = Field(default_factory=dict, description="Dotted path with unit -> value, for all cases")
    results: list[str] = Field(default_factory=lambda: ["mass"], min_length=1, description="Results by name")


def axis_values(path: str, axis: Axis) -> list[Value]:
    """Return the values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: If neither a list nor first, last and step are given, or they do not go together.
    """
    length = axis_length(path, axis)
    if axis.values is not None:
        return axis.values
    return [(axis.first or 0.0) + (axis.step or 0.0) * k for k in range(length)]


def axis_length(path: str, axis: Axis) -> int:
    """Return the number of values of an axis.

    Args:
        path: Of the entry, for messages.
        axis: As written.

    Raises:
        DesignError: As `axis_values`.
    """
    if axis.values is not None:
        return len(axis.values)
    if axis.first is None or axis.last is None or axis.step is None:
        raise DesignError([Problem(f"axes.{path}", "give a list of values, or all of from, to and step")])
    steps = (axis.last - axis.first) / axis.step
    if steps < 0 or not math.isfinite(steps):
        message = f"there is nothing from {axis.first:g} up to {axis.last:g}; exchange them"
        raise DesignError([Problem(f"axes.{path}", message)])
    return math.floor(steps + 1e-9) + 1


def case_count(study: Study) -> int:
    """Return the number of cases of a study.

    Args:
        study: As read.

    Raises:
        DesignError: If there are more than can be run.
    """
    count = len(study.designs) * math.prod(axis_length(path, axis) for path, axis in study.axes.items())
    if count > MOST_CASES:
        message = f"{count:,} cases; at most {MOST_CASES:,} are run: take larger steps, or fewer axes"
        raise DesignError([Problem("axes", message)])
    return count


def read_study(path: str | Path) -> Study:
    """Return the study that a file describes.

    Args:
        path: A TOML file.

    Raises:
        DesignError: With every problem of the file.
    """
    text = file_text(Path(path))
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise DesignError([Problem("", f"this is not TOML: {error}")], str(path)) from None
    record, written = build(Study, raw)
    if written.problems:
        lines = key_lines(text)
        raise DesignError(
            (Problem(each.path, each.message, line_of(each.path, lines)) for each in written.problems), str(path)
        )
    return cast(Study, record)
