"""Static cases of a mesh by AGMA 2001: roots must not yield under a momentary overload."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Protocol

import numpy as np

from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.parts.agma2001 import bending_geometry, yield_safety
from gearwright.ranking import smallest
from gearwright.sizing.rating.agma2001.inputs import hobbed_pair, yield_strength_of
from gearwright.sizing.rating.protocol import Load, LoadedMesh
from gearwright.units import Origin, Quantity

_CLAUSE = "AGMA 2001-D04, clause 16.4"


@dataclass(frozen=True)
class YieldingCase:
    """How near to yielding the roots of a mesh come in a static case."""

    case: str
    """Its name."""
    strengths: Annotated[tuple[float, float], Quantity("stress"), Origin("s_ay", _CLAUSE)]
    """Allowable yield strength numbers of both gears [Pa]."""
    safeties: Annotated[tuple[float, float], Quantity("ratio"), Origin("s_ay K_y F m_t J K_f/(W_max K_my)", _CLAUSE)]
    """Safety against yielding of both gears [-]."""


class Rated(Protocol):
    """A mesh with its worst static case."""

    @property
    def static(self) -> YieldingCase | None:
        """That case."""

    @property
    def yielding_asked(self) -> float:
        """Least safety [-]."""


def worst_yielding(mesh: LoadedMesh) -> YieldingCase | None:
    """Return the static case that comes nearest to yielding; None where there is none, or no yield strength is known.

    Args:
        mesh: As loaded.
    """
    known = [yield_strength_of(mesh.rating, gear) for gear in (0, 1)]
    if known[0] is None or known[1] is None:
        return None
    strengths = known[0], known[1]
    cases = [_case(mesh, load, strengths) for load in mesh.loads if load.static]
    return smallest(cases, lambda case: min(case.safeties)) if cases else None


def yielding_checks(rated: Rated, gears: tuple[PartId, PartId]) -> Iterator[Check]:
    """Yield the judgements on yielding.

    Args:
        rated: The mesh.
        gears: Both gears.
    """
    if rated.static is None:
        return
    for gear, safety in zip(gears, rated.static.safeties, strict=True):
        yield Check(gear, "yielding root", _CLAUSE, safety, rated.yielding_asked, symbol="S_y", case=rated.static.case)


def _case(mesh: LoadedMesh, load: Load, strengths: tuple[float, float]) -> YieldingCase:
    pair = hobbed_pair(load.ask, mesh.face_width / mesh.module, mesh.rating)
    transverse = mesh.module / float(np.cos(pair.helix_angle))
    force = load.torque / (float(np.asarray(pair.radii[0])) * mesh.module)
    first, second = (
        float(
            np.asarray(
                yield_safety(
                    force,
                    bending_geometry(pair, gear),
                    strength,
                    face_width=mesh.face_width,
                    module=transverse,
                    factor=mesh.rating.rules.agma2001.yield_factor,
                )
            )
        )
        for gear, strength in enumerate(strengths)
    )
    return YieldingCase(load.case, strengths, (first, second))
