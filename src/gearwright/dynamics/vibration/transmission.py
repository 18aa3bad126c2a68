"""How a train answers to a transmission error: every mesh of a row errs alike, each in its own phase."""

from __future__ import annotations

import cmath

import numpy as np

from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.assembly import compound_phases, gear_pairs
from gearwright.dynamics.model import System
from gearwright.dynamics.vibration.response import Response, frequency_response
from gearwright.errors import DesignError, Problem, by_name, near
from gearwright.identity import Row, mesh_part
from gearwright.parts.planetary import planet_phases
from gearwright.sizing import Sizing, governing_case, planet_positions
from gearwright.verbs import verb

POINTS = 2000
"""Frequencies of a response."""
RANGE = 1000.0
"""Highest over lowest frequency of a response [-]."""


@verb
@one_blas_thread()
def answer(
    sizing: Sizing, system: System, row: str, *, error: float = 1e-6, top: float = 1e4, case: str | None = None
) -> Response:
    """Return the forces that a harmonic transmission error of a mesh row causes, against its frequency.

    Args:
        sizing: What was sized.
        system: Assembled from it.
        row: Mesh row, such as ``first.sun-planet``; the planets err in their relative mesh phases.
        error: Amplitude along the line of action [m].
        top: Highest frequency [Hz].
        case: For which the system was assembled; left out: as `assemble` takes it.

    Raises:
        DesignError: If there is no such row or case.
    """
    flow = by_name(case or governing_case(sizing), sizing.flows, "case")
    meshes = {mesh.name: mesh for mesh in sizing.train.meshes}
    if row not in meshes:
        raise DesignError([Problem("mesh", f"there is no mesh {row!r}; {near(row, meshes)}")])
    mesh, lines = meshes[row], system.labels.lines_of(meshes[row].part)
    if mesh.row is Row.PAIR:
        errors: dict[str, complex] = dict.fromkeys(lines, error)
    elif mesh.stage in sizing.design.epicyclics:
        phases = compound_phases(sizing, flow, mesh.stage)[row]
        errors = {line: cmath.rect(error, 2.0 * cmath.pi * phase) for line, phase in zip(lines, phases, strict=True)}
    else:
        pairs, positions = gear_pairs(sizing), planet_positions(sizing.design, mesh.stage, sizing.teeth)
        inner, outer = (pairs[str(mesh_part(mesh.stage, kind))] for kind in (Row.SUN_PLANET, Row.PLANET_RING))
        both = planet_phases(inner, outer, positions)
        phases = both.sun if mesh.row is Row.SUN_PLANET else both.ring
        errors = {line: cmath.rect(error, 2.0 * cmath.pi * phase) for line, phase in zip(lines, phases, strict=True)}
    return frequency_response(system, np.geomspace(top / RANGE, top, POINTS), errors=errors)


def first_meshes(sizing: Sizing, system: System) -> list[str]:
    """Return the line of every mesh row, of a planetary set that of its first planet.

    Args:
        sizing: What was sized.
        system: Assembled from it.
    """
    return [system.labels.lines_of(mesh.part)[0] for mesh in sizing.train.meshes]
