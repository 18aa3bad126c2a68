"""The table ``[search]`` of a study: how the best designs along its axes are looked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import Field

from gearwright.errors import Problem
from gearwright.spec.record import Record
from gearwright.spec.studies.axis import Axis, axis_problems
from gearwright.units import Ratio

MOST = 10_000_000
"""Designs of one search at most [-]."""
GUIDED = 1000
"""Designs of a search with a surrogate at most [-]: its processes take the cube of their number."""


class Search(Record):
    """A search in layers: points that fill the axes, generations on the best of them, each found design polished."""

    screened: int = Field(
        16384, ge=0, le=1_000_000, description="Designs of the first layer, Sobol' points over all axes, of each design"
    )
    population: int = Field(256, ge=8, le=10_000, description="Designs of one generation")
    evaluations: int = Field(
        25_600, ge=1, le=1_000_000, description="Designs of generations and polish together, at most"
    )
    still: int = Field(8, ge=1, le=10_000, description="Generations without growth of the hypervolume that end them")
    growth: Ratio = Field(1e-3, ge=0, le=1, description="Growth of the hypervolume that counts, over itself")
    polished: int = Field(32, ge=0, le=200, description="Designs of the front whose teeth are kept and sizes polished")
    samples: int = Field(256, ge=8, le=65_536, description="Of what is uncertain, for the regret")
    surrogate: bool = Field(
        False, description="Gaussian processes choose the designs of generations: for results that take seconds"
    )
    seed: int = Field(1, ge=0, description="Start of the random numbers: the same seed, the same answer")


def search_problems(
    search: Search | None, axes: Mapping[str, Axis], objectives: Mapping[str, Any], uncertain: Mapping[str, Axis]
) -> list[Problem]:
    """Return what a search lacks, and what is given for one that is not there.

    Args:
        search: As written.
        axes: What it may change.
        objectives: What it wants.
        uncertain: What nobody knows.
    """
    if search is None:
        return [Problem("uncertain", "only a search reads it; write [search], too")] if uncertain else []
    problems = []
    if search.surrogate and search.evaluations > GUIDED:
        message = f"{search.evaluations} designs; a surrogate is for {GUIDED} at most: write less, such as 100"
        problems.append(Problem("search.evaluations", message))
    if not axes:
        problems.append(Problem("axes", "a search has nothing to vary; give a range or a list"))
    if not objectives:
        problems.append(Problem("objectives", 'a search needs at least one: [objectives] mass = "minimum"'))
    for path in uncertain.keys() & axes.keys():
        problems.append(Problem(f"uncertain.{path}", "is an axis, too: the search chooses it; keep one of them"))
    for path, axis in uncertain.items():
        problems += [
            Problem(f"uncertain.{path}", problem.message) for problem in axis_problems(path, axis, sampled=True)
        ]
    return problems
