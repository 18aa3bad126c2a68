"""What can be wrong with the bearings of planetary sets: some that nothing reads, or that are given twice."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.errors import Problem
from gearwright.spec.design import Design

MEMBERS = ("sun", "ring", "carrier")
"""The three central members of a planetary set."""


def bearing_problems(design: Design) -> Iterator[Problem]:
    """Yield bearings without effect, and shafts whose bearings stand in two places.

    Args:
        design: As typed.
    """
    moves = design.dynamics.fidelity == "translational"
    for name, planetary in design.planetaries.items():
        path = f"planetaries.{name}.bearings"
        if "bearings" in planetary.model_fields_set and not moves:
            message = (
                'has no effect on sets in rigid bearings; write dynamics.fidelity = "translational", or leave it out'
            )
            yield Problem(path, message)
        for member in MEMBERS:
            shaft = getattr(planetary, member)
            if moves and shaft in design.supports:
                yield Problem(f"supports.{shaft}", f"{name}.{member} has bearings in {path} too; keep one of the two")
