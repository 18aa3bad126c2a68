"""Reduced elastic bodies by Craig and Bampton: matrices, interface coordinates and their file formats.

How a body joins a system is in `gearwright.dynamics.model`.
"""

from __future__ import annotations

import io
import tomllib
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gearwright.base import DesignError, Floats, Problem, near, one_blas_thread, refuse, verb
from gearwright.files import beside, refuse_irregular, text_of

# ----------------------------------------------------------------------------------------------------------------------
# A body reduced to its interfaces and some modes (Craig & Bampton): mass, stiffness, and what each coordinate is.
# ----------------------------------------------------------------------------------------------------------------------


LENGTHS: Mapping[str, float] = {"m": 1.0, "mm": 1e-3}
"""Unit -> [m]."""
MASSES: Mapping[str, float] = {"kg": 1.0, "t": 1e3}
"""Unit -> [kg]."""
TRANSLATIONS, ROTATIONS = ("x", "y", "z"), ("tilt x", "tilt y", "twist")
"""Directions of an interface; any other coordinate is a mode."""
ASYMMETRY = 1e-6
"""Largest difference of a matrix from its transpose over its largest entry [-]."""
NEGATIVE = 1e-8
"""Smallest eigenvalue of a stiffness over its largest that counts as rounding [-]."""


@dataclass(frozen=True, eq=False)
class ReducedBody:
    """Matrices in SI; time is in seconds in every file."""

    mass: Floats
    """M [kg, kg m, kg m²], shape (coordinates, coordinates)."""
    stiffness: Floats
    """K [N/m, N, N m], shape (coordinates, coordinates)."""
    points: tuple[str, ...]
    """What each coordinate is: a place and a direction, such as ``seat-1 x``, or a mode by any other name."""

    @property
    def places(self) -> tuple[tuple[str, str], ...]:
        """Place and direction of each coordinate; a mode is its own place."""
        pairs = (point.partition(" ") for point in self.points)
        return tuple((place, direction) for place, _, direction in pairs)


@one_blas_thread()
def reduced_body(
    mass: Floats, stiffness: Floats, points: Sequence[str], *, length_unit: str, mass_unit: str
) -> ReducedBody:
    """Return a body in SI units from its matrices.

    Args:
        mass: M, in the units that are named.
        stiffness: K, in the same ones; forces are mass unit × length unit/s² (t and mm: N).
        points: What each coordinate is.
        length_unit: ``"m"`` or ``"mm"``.
        mass_unit: ``"kg"`` or ``"t"``.

    Raises:
        DesignError: With everything that is wrong: sizes, names, units, symmetry, signs.

    Source: Craig & Bampton 1968, AIAA J. 6, 1313-1319.
    """
    refuse(_units(length_unit, mass_unit))
    refuse(_sizes(mass, stiffness, points))
    refuse(_values(mass, stiffness))
    length = LENGTHS[length_unit]
    scale = np.array([1.0 / length if point.partition(" ")[2] in TRANSLATIONS else 1.0 for point in points])
    energy = MASSES[mass_unit] * length**2 * np.outer(scale, scale)
    return ReducedBody(
        0.5 * energy * (mass + mass.T), 0.5 * energy * (stiffness + stiffness.T), tuple(map(str, points))
    )


def _units(length_unit: str, mass_unit: str) -> Iterator[Problem]:
    for path, unit, known in (("length_unit", length_unit, LENGTHS), ("mass_unit", mass_unit, MASSES)):
        if unit not in known:
            yield Problem(path, f"{unit!r} given; name the unit of the matrices, {near(unit, known)}")


def _sizes(mass: Floats, stiffness: Floats, points: Sequence[str]) -> Iterator[Problem]:
    for path, matrix in (("mass", mass), ("stiffness", stiffness)):
        if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not matrix.size:
            yield Problem(path, f"it has shape {matrix.shape}; a square matrix is needed")
        elif len(points) != len(matrix):
            yield Problem("points", f"{len(points)} names for {len(matrix)} coordinates of {path}; name each once")
    for point in sorted({point for point in points if list(points).count(point) > 1}):
        yield Problem("points", f"{point!r} stands there twice; names must differ")
    if not any(point.partition(" ")[2] in (*TRANSLATIONS, *ROTATIONS) for point in points):
        yield Problem(
            "points", "none is a place (one word) and a direction, as 'seat-1 x'; bearings have nothing to join"
        )


def _values(mass: Floats, stiffness: Floats) -> Iterator[Problem]:
    for path, matrix in (("mass", mass), ("stiffness", stiffness)):
        if not np.all(np.isfinite(matrix)):
            yield Problem(path, "every entry must be a finite number")
            continue
        apart = float(np.max(np.abs(matrix - matrix.T)))
        largest = float(np.max(np.abs(matrix)))
        if apart > ASYMMETRY * largest:
            row, column = np.unravel_index(int(np.argmax(np.abs(matrix - matrix.T))), matrix.shape)
            yield Problem(
                path, f"it is not symmetric: entries {row}, {column} and {column}, {row} differ by {apart:.3g}"
            )
            continue
        values = np.linalg.eigvalsh(matrix)
        least, most = float(values[0]), float(values[-1])
        if path == "mass" and least <= 0.0:
            yield Problem(path, f"its smallest eigenvalue is {least:.3g}; a mass is positive in every motion")
        if path == "stiffness" and least < -NEGATIVE * most:
            yield Problem(path, f"its smallest eigenvalue is {least:.3g}; a stiffness is nowhere negative")


# ----------------------------------------------------------------------------------------------------------------------
# Files of reduced bodies: one .npz, or a .toml that names matrices in .csv, .txt or Matrix Market (.mtx) beside it.
# ----------------------------------------------------------------------------------------------------------------------


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
