"""How a train answers to a transmission error: every mesh of a row errs alike, each in its own phase."""

from __future__ import annotations

import cmath

import numpy as np

from gearwright.dynamics.assembly import gear_pairs
from gearwright.dynamics.model import System
from gearwright.dynamics.vibration.response import Response, frequency_response
from gearwright.errors import DesignError, Problem, near
from gearwright.parts.planetary import even_positions, planet_phases
from gearwright.sizing import Sizing

POINTS = 2000
"""Frequencies of a response."""
RANGE = 1000.0
"""Highest over lowest frequency of a response [-]."""


def answer(sizing: Sizing, system: System, row: str, *, error: float, top: float) -> Response:
    """Return the forces that a harmonic transmission error of a mesh row causes, against its frequency.

    Args:
        sizing: What was sized.
        system: Assembled from it.
        row: Mesh row, such as ``first.sun-planet``; the planets err in their relative mesh phases.
        error: Amplitude along the line of action [m].
        top: Highest frequency [Hz].

    Raises:
        DesignError: If there is no such row.
    """
    names = {mesh.name: mesh for mesh in sizing.train.meshes}
    if row not in names:
        raise DesignError([Problem("mesh", f"there is no mesh {row!r}; {near(row, names)}")])
    stage = names[row].stage
    if stage not in sizing.design.planetaries:
        errors: dict[str, complex] = {row: error}
    else:
        pairs, count = gear_pairs(sizing), sizing.design.planetaries[stage].planets
        both = planet_phases(pairs[f"{stage}.sun-planet"], pairs[f"{stage}.planet-ring"], even_positions(count))
        phases = both.sun if row.endswith("sun-planet") else both.ring
        errors = {f"{row}-{k}": cmath.rect(error, 2.0 * cmath.pi * phase) for k, phase in enumerate(phases, start=1)}
    return frequency_response(system, np.geomspace(top / RANGE, top, POINTS), errors=errors)


def first_meshes(sizing: Sizing, system: System) -> list[str]:
    """Return the line of every mesh row, of a planetary set that of its first planet.

    Args:
        sizing: What was sized.
        system: Assembled from it.
    """
    lines = system.labels.lines
    return [mesh.name if mesh.name in lines else f"{mesh.name}-1" for mesh in sizing.train.meshes]
