"""A user's own mesh stiffness: CSV files beside the design file become part of the design, which then needs no file."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem, near
from gearwright.parts.stiffness import sampled_curve
from gearwright.spec.design import Design, MeshCurve

COLUMNS = ("phase_cycles", "stiffness_n_m")
"""Of the file, in its first row; others are left alone."""
LARGEST_CURVE = 1_000_000
"""Largest file that is read [bytes]."""


def with_curves(design: Design, folder: Path) -> tuple[Design, list[Problem]]:
    """Return a design whose own stiffness curves hold their points, and what is wrong with them.

    Args:
        design: As written.
        folder: Where the files are looked for.
    """
    curves, problems = dict(design.dynamics.curves), []
    for mesh, curve in design.dynamics.curves.items():
        path = f"dynamics.curves.{mesh}"
        problems += list(_unknown(path, mesh, design))
        try:
            curves[mesh] = _filled(path, curve, folder)
        except DesignError as error:
            problems += error.problems
    if not curves or problems:
        return design, problems
    dynamics = design.dynamics.model_copy(update={"curves": curves})
    return design.model_copy(update={"dynamics": dynamics}), []


def _unknown(path: str, mesh: str, design: Design) -> Iterator[Problem]:
    sets = [f"{name}.{end}" for name in design.planetaries for end in ("sun-planet", "planet-ring")]
    if mesh not in (*sets, *design.pairs):
        yield Problem(path, f"there is no mesh {mesh!r}; {near(mesh, [*sets, *design.pairs])}")


def _filled(path: str, curve: MeshCurve, folder: Path) -> MeshCurve:
    given = bool(curve.phase_cycles or curve.stiffness_n_m)
    if curve.file is None and not given:
        raise DesignError([Problem(path, "has no points; give file, or phase_cycles and stiffness_n_m")])
    if curve.file is not None and not given:
        phase, stiffness = _columns(f"{path}.file", folder / curve.file)
        curve = curve.model_copy(update={"phase_cycles": phase, "stiffness_n_m": stiffness})
    try:
        sampled_curve(2.0 * math.pi * np.array(curve.phase_cycles), curve.stiffness_n_m, harmonics=1, source="")
    except DesignError as error:
        raise DesignError([Problem(path, f"{each.path}: {each.message}") for each in error.problems]) from None
    return curve


def _columns(path: str, file: Path) -> tuple[list[float], list[float]]:
    try:
        if file.is_file() and file.stat().st_size > LARGEST_CURVE:
            raise DesignError([Problem(path, f"{file} has more than {LARGEST_CURVE:,} bytes; thin the points out")])
        rows = list(csv.DictReader(file.read_text(encoding="utf-8-sig").splitlines()))
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not text in UTF-8"
        raise DesignError([Problem(path, f"{file} cannot be read: {reason}")]) from None
    missing = [name for name in COLUMNS if not rows or name not in rows[0]]
    if missing:
        message = f"{file} lacks {' and '.join(missing)}; its first row must name the columns {', '.join(COLUMNS)}"
        raise DesignError([Problem(path, message)])
    phase, stiffness = ([_number(path, row[name], line) for line, row in enumerate(rows, 2)] for name in COLUMNS)
    return phase, stiffness


def _number(path: str, text: str | None, line: int) -> float:
    try:
        return float(text or "")
    except ValueError:
        raise DesignError([Problem(path, f"line {line}: {text!r} is not a number")]) from None
