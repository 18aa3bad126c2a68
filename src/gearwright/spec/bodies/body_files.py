"""Files of reduced bodies: one .npz, or a .toml that names matrices in .csv, .txt or Matrix Market (.mtx) beside it."""

from __future__ import annotations

import io
import tomllib
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import DesignError, Problem, near
from gearwright.reading import beside, refuse_irregular, text_of
from gearwright.spec.bodies.reduced_body import ReducedBody, reduced_body
from gearwright.verbs import verb

KEYS = ("mass", "stiffness", "points", "length_unit", "mass_unit")
"""Of either kind of file."""
LARGEST = 64 * 2**20
"""Size of the largest text of a matrix [bytes]."""
FORMS = (".csv", ".txt", ".mtx")
"""Of a matrix in a file of its own."""


@verb
def read_body(path: str | Path) -> ReducedBody:
    """Return a body that was reduced to its interfaces and modes, checked and in SI units.

    Args:
        path: A ``.npz`` with the arrays mass, stiffness, points, length_unit, mass_unit, or a ``.toml`` with the same
            keys, whose mass and stiffness name files beside it.

    Raises:
        DesignError: With everything that is wrong with the files or the matrices.
    """
    path = Path(path)
    given = _archive(path) if path.suffix == ".npz" else _manifest(path)
    missing = [key for key in KEYS if key not in given]
    unknown = [key for key in given if key not in KEYS]
    problems = [Problem(key, "missing; a body needs " + ", ".join(KEYS)) for key in missing]
    problems += [Problem(key, f"there is no such key; {near(key, KEYS)}") for key in unknown]
    if problems:
        raise DesignError(problems, source=str(path))
    units = {key: str(given[key]) for key in ("length_unit", "mass_unit")}
    points = [str(point) for point in np.atleast_1d(given["points"])]
    return reduced_body(_matrix(given, "mass"), _matrix(given, "stiffness"), points, **units)


def _matrix(given: Mapping[str, Any], key: str) -> Floats:
    try:
        return np.asarray(given[key], dtype=float)
    except (TypeError, ValueError):
        raise DesignError([Problem(key, "it is no matrix of numbers")]) from None


def _archive(path: Path) -> dict[str, Any]:
    refuse_irregular(path)
    try:
        with np.load(path, allow_pickle=False) as archive:
            return {key: archive[key] for key in archive.files}
    except (OSError, ValueError, zipfile.BadZipFile, EOFError):
        raise DesignError([Problem(str(path), "it is no .npz of plain arrays, as numpy.savez writes")]) from None


def _manifest(path: Path) -> dict[str, Any]:
    try:
        given = tomllib.loads(text_of(path))
    except tomllib.TOMLDecodeError as error:
        raise DesignError([Problem(str(path), f"it is no TOML: {error}")]) from None
    for key in ("mass", "stiffness"):
        if key in given:
            given[key] = _from_file(beside(str(given[key]), path.parent, key), key)
    return given


def _from_file(path: Path, key: str) -> Floats:
    if path.suffix not in FORMS:
        raise DesignError([Problem(key, f"{path.name} is none of {', '.join(FORMS)}")])
    text = text_of(path, key, largest=LARGEST)
    try:
        if path.suffix == ".mtx":
            from scipy.io import mmread  # readers of designs do without it

            found = mmread(io.StringIO(text))
            return np.asarray(found.toarray() if hasattr(found, "toarray") else found, dtype=float)
        return np.loadtxt(io.StringIO(text), delimiter="," if path.suffix == ".csv" else None, ndmin=2)
    except (ValueError, TypeError, StopIteration) as error:
        raise DesignError([Problem(key, f"{path.name} is no matrix of numbers: {error}")]) from None
