"""What can be wrong with bearings: some that nothing reads, designations that are not, halves of a rating."""

from __future__ import annotations

from collections.abc import Iterator

from gearwright.catalogue import bearing
from gearwright.errors import DesignError, Problem
from gearwright.identity import MEMBERS
from gearwright.spec.design import Design


def bearing_problems(design: Design) -> Iterator[Problem]:
    """Yield bearings without effect, shafts whose bearings stand in two places, and bearings of planets that are not.

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
    yield from _planet_bearings(design)


def _planet_bearings(design: Design) -> Iterator[Problem]:
    for name, stage in design.planetaries.items():
        planet_bearing, path = stage.planet_bearing, f"planetaries.{name}.planet_bearing"
        if planet_bearing is None:
            continue
        if (planet_bearing.dynamic_rating is None) != (planet_bearing.static_rating is None):
            yield Problem(path, "one rating without the other; give dynamic_rating_kn and static_rating_kn, or neither")
        try:
            bearing(planet_bearing.designation)
        except DesignError as error:
            yield from (Problem(f"{path}.designation", problem.message) for problem in error.problems)
