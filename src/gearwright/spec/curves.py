"""A user's own mesh stiffness: CSV files beside the design file become part of the design, which then needs no file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem, near
from gearwright.parts.stiffness import sampled_curve
from gearwright.reading import beside, numbers_of, text_of
from gearwright.spec.design import Design, MeshCurve

COLUMNS = ("phase_cycles", "stiffness_n_m")
"""Of the file, in its first row; others are left alone."""


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
    sets += [
        f"{name}.{first}-{second}"
        for name, epicyclic in design.epicyclics.items()
        for first, second in epicyclic.mesh_pairs
    ]
    if mesh not in (*sets, *design.pairs):
        yield Problem(path, f"there is no mesh {mesh!r}; {near(mesh, [*sets, *design.pairs])}")


def _filled(path: str, curve: MeshCurve, folder: Path) -> MeshCurve:
    has_points = bool(curve.phase_cycles or curve.stiffness_n_m)
    if curve.file is None and not has_points:
        raise DesignError([Problem(path, "has no points; give file, or phase_cycles and stiffness_n_m")])
    if curve.file is not None and not has_points:
        phase, stiffness = _columns(f"{path}.file", beside(curve.file, folder, f"{path}.file"))
        curve = curve.model_copy(update={"phase_cycles": phase, "stiffness_n_m": stiffness})
    try:
        sampled_curve(2.0 * math.pi * np.array(curve.phase_cycles), curve.stiffness_n_m, harmonics=1, source="")
    except DesignError as error:
        raise DesignError([Problem(path, f"{problem.path}: {problem.message}") for problem in error.problems]) from None
    return curve


def _columns(path: str, file: Path) -> tuple[list[float], list[float]]:
    try:
        points = numbers_of(text_of(file, path), COLUMNS)
    except ValueError as error:
        raise DesignError([Problem(path, f"{file} {error}")]) from None
    return [phase for phase, _ in points], [stiffness for _, stiffness in points]
