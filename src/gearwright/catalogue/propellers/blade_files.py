"""Blades from a CSV file: chord and angle over the radius, with what a file may say of sections."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path

import numpy as np

from gearwright.arrays import Floats
from gearwright.errors import Problem, refuse
from gearwright.machines.propellers import BladeShape
from gearwright.reading import numbers_of, text_of
from gearwright.verbs import verb

STATIONS = ("radius_ratio", "chord_ratio", "blade_angle_deg")
"""What every row of a blade file has: r/R, c/R, and the angle of the chord to the plane of turning."""
SECTIONS: Mapping[str, float] = {"design_lift": 0.5, "thickness_ratio": 0.1}
"""What it may have beside them, and what counts where it has not; assumptions of a usual blade."""
_SENSIBLE: Mapping[str, tuple[float, float]] = {
    "radius_ratio": (0.02, 1.0),
    "chord_ratio": (0.0, 2.0),
    "blade_angle_deg": (-90.0, 120.0),
    "design_lift": (-1.0, 1.5),
    "thickness_ratio": (0.01, 1.0),
}
"""Column -> range of what a blade can have."""
FEWEST = 5
"""Stations that say how a blade is made, at least."""
OUTERMOST = 0.75
"""Radius ratio that the stations must reach: where the blade angle is told [-]."""
ELEMENTS = 30
"""Elements of equal width into which blades are cut."""
MOST_BLADES = 12


@verb
def read_blades(path: str | Path, number: int) -> BladeShape:
    """Return the blades of a propeller from a CSV file of stations.

    Args:
        path: Of the file: columns radius_ratio, chord_ratio (over the tip radius), blade_angle_deg, and perhaps
            design_lift (0.5 if left out) and thickness_ratio (0.1).
        number: Of blades [-].

    Source: between stations linear; the tip has the last one's angle and, where no station is at 1, its chord.

    Raises:
        DesignError: The file is missing or holds no such blade, with all that is wrong.
    """
    text = text_of(path, "blades")
    head = [word.strip() for word in text.partition("\n")[0].split(",")]
    columns = (*STATIONS, *(name for name in SECTIONS if name in head))
    try:
        rows = numbers_of(text, columns)
    except ValueError as error:
        refuse([Problem("blades", str(error))], str(path))
        raise
    problems = [*_wrong_cells(rows, columns), *_wrong_stations([row[0] for row in rows])]
    if not 1 < number <= MOST_BLADES:
        problems.append(Problem("number", f"{number} blades: give 2 to {MOST_BLADES}"))
    refuse(problems, str(path))
    table = {name: np.array([row[k] for row in rows]) for k, name in enumerate(columns)}
    return _shape(number, table)


def _wrong_cells(rows: list[list[float]], columns: tuple[str, ...]) -> list[Problem]:
    return [
        Problem(f"blades.line {line}", f"{name} {value:g} is not from {low:g} to {high:g}")
        for line, row in enumerate(rows, start=2)
        for name, value in zip(columns, row, strict=True)
        for low, high in (_SENSIBLE[name],)
        if not low <= value <= high
    ]


def _wrong_stations(radii: list[float]) -> list[Problem]:
    problems = []
    if len(radii) < FEWEST:
        problems.append(Problem("blades", f"{len(radii)} stations: give at least {FEWEST}"))
    for line, (inner, outer) in enumerate(pairwise(radii), start=3):
        if outer <= inner:
            problems.append(Problem(f"blades.line {line}", f"radius_ratio {outer:g} does not rise beyond {inner:g}"))
    if radii and max(radii) < OUTERMOST:
        problems.append(Problem("blades", f"stations end at {max(radii):g} of the radius; go on to {OUTERMOST:g}"))
    return problems


def _shape(number: int, table: Mapping[str, Floats]) -> BladeShape:
    known = table["radius_ratio"]
    edges = np.linspace(min(float(known[0]), 0.5), 1.0, ELEMENTS + 1)
    radius = 0.5 * (edges[1:] + edges[:-1])

    def along(name: str) -> Floats:
        return np.interp(radius, known, table[name]) if name in table else np.full(ELEMENTS, SECTIONS[name])

    angle = np.radians(table["blade_angle_deg"])
    return BladeShape(
        number=number,
        radius=radius,
        width=np.diff(edges),
        chord=np.maximum(along("chord_ratio"), 1e-4),
        twist=np.interp(radius, known, angle) - float(np.interp(OUTERMOST, known, angle)),
        design_lift=along("design_lift"),
        thickness=along("thickness_ratio"),
        hub=float(edges[0]),
    )
