"""Bores that a design gives to gears and to shafts through them, against the roots of the teeth around them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gearwright.errors import Problem
from gearwright.identity import Role
from gearwright.sizing.rating import Context, bore_of
from gearwright.sizing.result import GearSizing
from gearwright.sizing.roots import bore_problem
from gearwright.spec import Epicyclic
from gearwright.spec.design import NOTHING_GIVEN

ROOTED = (Role.PINION, Role.WHEEL, Role.SUN)
"""Gears that a shaft goes through."""


def bores_beyond_roots(context: Context, gears: Sequence[GearSizing]) -> Iterator[Problem]:
    """Yield bores of gears, and of shafts through them, that leave no rim under the teeth.

    Args:
        context: What gear sizing reads.
        gears: As sized.
    """
    for gear in gears:
        for path, bore in () if gear.name in context.train.internal else _bores(context, gear):
            if (problem := bore_problem(context, gear, path, bore)) is not None:
                yield problem


def _bores(context: Context, gear: GearSizing) -> Iterator[tuple[str, float]]:
    """Yield key and diameter [m] of the bore that a design gives to a gear, and of those of shafts through it."""
    design = context.design
    if (own := bore_of(design, context.train.gear(gear.name))) is not None:
        compound = isinstance(design.stages[gear.stage], Epicyclic)
        key = f"{gear.role.value}s.{gear.own}.bore_mm" if compound else f"{gear.role.value}_bore_mm"
        yield f"{design.table(gear.stage)}.{key}", own
    for shaft in gear.shafts if gear.role in ROOTED else ():
        if (bore := design.layout.get(shaft, NOTHING_GIVEN).bore) is not None:
            yield f"layout.{shaft}.bore_mm", bore
