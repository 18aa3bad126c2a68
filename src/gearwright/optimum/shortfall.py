"""Why a search has found nothing: the design that comes nearest, what it misses, and which checks keep it from it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gearwright.errors import GearwrightError, Problem
from gearwright.optimum.course import Archive
from gearwright.optimum.keeping import sizing_of
from gearwright.spec import Design, Study
from gearwright.study.answers import Row
from gearwright.units import margin_text

FEW = 3
"""Checks that are named [-]."""


def shortfall(study: Study, designs: Mapping[str, Design], archive: Archive) -> list[Problem]:
    """Return why no design of a search is good.

    Args:
        study: With its constraints.
        designs: Name -> design.
        archive: Everything that was looked at, none of it good.
    """
    if archive.nearest is None:
        return [Problem("axes", f"every design is refused, the first with {archive.refusal}")]
    row = archive.nearest
    problems = list(_missed(study, archive, row))
    at = ", ".join(f"{path} = {value:.6g}" if isinstance(value, float) else f"{path} = {value}"
                   for path, value in row.inputs.items())  # fmt: skip
    failing = "; ".join(_failing(study, designs, row))
    told = f"the nearest of all that were looked at is {row.design}: {at}"
    why = f"; its sizing fails {failing}" if failing else ""
    return [*problems, Problem("axes", f"{told}{why}: free what these depend on, or widen the axes")]


def _missed(study: Study, archive: Archive, row: Row) -> Iterator[Problem]:
    """Yield every constraint that the nearest design breaks, and how near any design comes to it."""
    for name, least in zip(study.constraints, archive.least_broken.tolist(), strict=True):
        value, bound = row.shown(name), study.constraints[name]
        for limit, over in ((bound.minimum, -1.0), (bound.maximum, 1.0)):
            if limit is not None and over * (value - limit) > 0.0:
                asked = f"at {'least' if over < 0.0 else 'most'} {limit:g} is asked"
                share = abs(value - limit) / (abs(limit) or 1.0)
                others = "others come nearer and break another" if least < share * (1.0 - 1e-9) else "none comes nearer"
                reached = f"the nearest design has {value:.4g}, {100 * share:.1f} % off; {others}"
                yield Problem(f"constraints.{name}", f"{asked}, and {reached}: relax it")


def _failing(study: Study, designs: Mapping[str, Design], row: Row) -> Iterator[str]:
    """Yield the checks of its sizing that fail, the worst first."""
    try:
        checks = sizing_of(study, designs, row).checks
    except GearwrightError:
        return
    worst = sorted((check for check in checks if check.fails), key=lambda check: check.margin or 0.0)
    yield from (f"{check.name} ({margin_text(check.margin or 0.0)} of what is asked)" for check in worst[:FEW])
