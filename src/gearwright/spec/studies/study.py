"""The study file: designs and a mission, axes over dotted paths of them, and the results that are asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field, ValidationInfo, field_validator

from gearwright.showing import Shown
from gearwright.spec.former import today
from gearwright.spec.missions import Mission
from gearwright.spec.record import Record
from gearwright.spec.studies.axis import Axis, Value
from gearwright.spec.studies.search import Search
from gearwright.units import Time

MOST_REDUCED = 1_000_000_000
"""Cases of a study that keeps no rows."""
MISSION_PATH, FLY_RESULT = "mission.", "fly."
"""How paths into the mission and the results of its flight begin."""
Method = Literal["grid", "list", "random", "sobol", "latin-hypercube", "saltelli", "nsga2", "form", "subset"]
RELIABILITY = ("form", "subset")
"""Methods that find how likely it is that a constraint is broken."""


class Sampling(Record):
    """How cases are taken from the axes."""

    method: Method = Field("grid", description="grid: every combination; list: the k-th values of all axes together")
    count: int | None = Field(
        None, ge=1, le=MOST_REDUCED, description="Samples of each design; evaluations of nsga2, form and subset"
    )
    seed: int = Field(1, ge=0, description="Start of the random numbers: the same seed, the same cases")
    population: int = Field(
        40, ge=4, le=10_000, description="Designs of one generation of nsga2, samples of one level of subset"
    )


class Bound(Record):
    """What a result must keep, in the unit in which tables show it."""

    minimum: float | None = Field(None, description="Smallest value allowed")
    maximum: float | None = Field(None, description="Largest value allowed")


class Simulated(Record):
    """How the results named ``simulate.…`` are had."""

    case: str | None = Field(None, description="Load case; left out: the governing one, of least margin")
    duration: Time = Field(0.05, gt=0, le=1000, description="Simulated time; its last three quarters are looked at")


class Flown(Record):
    """How the results named ``fly.…`` are had."""

    mission: str | None = Field(None, description="Mission file, or name of a shipped mission")
    life: Time | None = Field(
        None, gt=0, le=3.6e9, description="Gears are strengthened until all live so long; left out: as sized"
    )


class Reduction(Record):
    """What a study keeps instead of its rows."""

    best: int = Field(20, ge=1, le=1000, description="Rows of the best cases that are kept, of every objective")


class Study(Shown, Record):
    """Designs varied along axes, with results by name."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the study")
    description: str = Field("", description="What it answers")
    designs: list[str] = Field(min_length=1, description="Design files, or names of shipped designs")
    axes: dict[str, Axis] = Field(
        default_factory=dict, description="Dotted path with unit, of the design or into its mission.… -> values"
    )
    changes: dict[str, Value] = Field(default_factory=dict, description="Dotted path with unit -> value, for all cases")
    frozen: bool = Field(
        False, description="Sizes stay those of each design as it is: axes and changes meet the finished gearbox"
    )
    results: list[str] = Field(default_factory=lambda: ["mass"], min_length=1, description="Results by name")
    sampling: Sampling = Field(default_factory=Sampling, description="How cases are taken from the axes")
    objectives: dict[str, Literal["minimum", "maximum"]] = Field(
        default_factory=dict, description="Result -> whether its minimum or its maximum is wanted"
    )
    constraints: dict[str, Bound] = Field(default_factory=dict, description="Result -> what it must keep")
    simulate: Simulated = Field(default_factory=Simulated, description="How results named simulate.… are had")
    fly: Flown = Field(default_factory=Flown, description="How results named fly.… are had")
    reduced: Reduction | None = Field(
        None, description="Given: no rows are kept, only how results are spread, along which axis, and the best cases"
    )
    search: Search | None = Field(None, description="How `gearwright optimise` looks for the best along the axes")
    uncertain: dict[str, Axis] = Field(
        default_factory=dict, description="Dotted path -> distribution of what nobody knows, for [search]'s regret"
    )
    mission: Mission | None = Field(None, description="What is flown, if it is written here and is no file of its own")

    @field_validator("axes", "uncertain", "changes", "results", "objectives", "constraints", mode="before")
    @classmethod
    def _in_words_of_today(cls, entries: Any, info: ValidationInfo) -> Any:
        """Read paths and results by their former names, too."""
        place = info.field_name or ""
        if isinstance(entries, list):
            return [today(entry, place) if isinstance(entry, str) else entry for entry in entries]
        if not isinstance(entries, Mapping):
            return entries
        renamed = {today(path, place): entry for path, entry in entries.items()}
        if place != "objectives":
            return renamed
        return {path: today(entry, f"{place}.{path}") if isinstance(entry, str) else entry
                for path, entry in renamed.items()}  # fmt: skip

    @property
    def asked(self) -> tuple[str, ...]:
        """Every result that a case computes: those asked for, then those of objectives and constraints."""
        return tuple(dict.fromkeys([*self.results, *self.objectives, *self.constraints]))

    @property
    def searches(self) -> bool:
        """True if its cases follow from the results of earlier ones."""
        return self.search is not None or self.sampling.method in ("nsga2", *RELIABILITY)

    @property
    def flies(self) -> bool:
        """True if a case needs the flight: a result of it is asked for, or a life of the gears."""
        return self.fly.life is not None or any(name.startswith(FLY_RESULT) for name in self.asked)
