"""Ranges in which the formulas of ISO 6336 hold, and what of a mesh lies beyond: it is rated, and said."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gearwright.checks import Check
from gearwright.identity import PartId
from gearwright.parts.iso6336 import MeshGeometry, PairRating
from gearwright.units import Angle, apart, text

_SCOPE, _ROOT = "ISO 6336-1:2019, clause 1", "ISO 6336-3:2019, clause 7"
_CLASSES, _STIFFNESS = "ISO 1328-1:2013, clause 1", "ISO 6336-1:2019, clause 9"
_STEEPEST: Angle = np.radians(30.0)
"""Helix angle as which a larger one counts in Y_β [rad] (ISO 6336-3:2019, clause 8)."""

_STEEPEST_RATIO = 200.0
"""Of 1000 teeth over 5 [-] (ISO 1328-1:2013, clause 1)."""


@dataclass(frozen=True)
class Beyond:
    """A quantity of a mesh that lies beyond the range of a formula."""

    quantity: str
    """With its symbol."""
    dimension: str
    value: float
    """As it is [SI]."""
    least: float
    """Where the range begins [SI]."""
    most: float
    """Where it ends [SI]."""
    clause: str
    """That says so."""


def beyond_ranges(mesh: MeshGeometry, rated: PairRating, *, films: bool = False) -> tuple[Beyond, ...]:
    """Return what of a mesh lies beyond the ranges of the formulas that rate it.

    Args:
        mesh: One mesh.
        rated: Its factors.
        films: Whether its oil film is rated, too.

    Source: ISO 6336-1:2019, clauses 1 and 9 (ε_α, x_1 + x_2), ISO 6336-3:2019, clauses 7 and 8 (q_s, β), ISO
        1328-1:2013, clause 1 (z, d, m_n, b), ISO/TS 6336-22 (external pairs, ε_α).
    """
    ranges = [*_ranges(mesh, rated), *(_of_films(mesh) if films else ())]
    return tuple(entry for entry in ranges if not entry.least <= entry.value <= entry.most)


def _ranges(mesh: MeshGeometry, rated: PairRating) -> Iterator[Beyond]:
    yield _range("ε_α", "ratio", mesh.transverse_contact_ratio, (1.0, 2.5), _SCOPE)
    yield _range("β", "angle", mesh.helix_angle, (0.0, float(_STEEPEST)), "ISO 6336-3:2019, clause 8 (Y_β)")
    yield _range("m_n", "length", mesh.module, (0.5e-3, 70e-3), _CLASSES)
    yield _range("b", "length", mesh.face_width, (4e-3, 1.2), _CLASSES)
    for gear in (0, 1):
        yield _range(f"z_{gear + 1}", "number", abs(float(mesh.teeth[gear])), (5.0, 1000.0), _CLASSES)
        yield _range(f"d_{gear + 1}", "length", mesh.pitch_diameters[gear], (5e-3, 15.0), _CLASSES)
        yield _range(f"q_s{gear + 1}", "ratio", rated.bending[gear].section.notch, (1.0, 8.0), _ROOT)
    if mesh.side > 0:
        shifts = sum(float(proportion.profile_shift) for proportion in mesh.proportions)
        yield _range("x_1 + x_2", "ratio", shifts, (-0.5, 2.0), _STIFFNESS)


def _of_films(mesh: MeshGeometry) -> Iterator[Beyond]:
    yield _range("u of the oil film", "ratio", mesh.ratio, (0.0, _STEEPEST_RATIO), "ISO/TS 6336-22: external pairs")
    yield _range("ε_α of the oil film", "ratio", mesh.transverse_contact_ratio, (1.0, 2.0), "ISO/TS 6336-22, method B")


def _range(quantity: str, dimension: str, value: object, span: tuple[float, float], clause: str) -> Beyond:
    return Beyond(quantity, dimension, float(np.asarray(value)), *span, clause)


def range_checks(beyond: tuple[Beyond, ...], mesh: PartId) -> Iterator[Check]:
    """Yield what lies beyond the range of a formula, as not assessed: nothing says what the formula is worth there.

    Args:
        beyond: Of the mesh.
        mesh: The mesh.
    """
    for entry in beyond:
        below = entry.value < entry.least
        value, bound = apart(entry.value, entry.least if below else entry.most, entry.dimension)
        other = text(entry.most if below else entry.least, entry.dimension)
        least, most = (bound, other) if below else (other, bound)
        words = f"{value}; the formulas hold from {least} to {most}, and the safeties are extrapolated"
        yield Check(mesh, f"range of {entry.quantity}", entry.clause, None, None, why=words)
