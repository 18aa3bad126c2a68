"""The mix file: missions by name or path, how often each is flown, and how many flights a life has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, cast

from pydantic import Field

from gearwright.errors import DesignError, Problem, excerpt
from gearwright.reading import beside
from gearwright.shipped import find_mission, find_mix, shipped_missions, shipped_mixes
from gearwright.showing import Shown
from gearwright.spec.edit import edited_mission
from gearwright.spec.flying import is_map_file, read_mission
from gearwright.spec.missions import BearingLifeRules, Mission
from gearwright.spec.read import file_text, placed, toml_tables
from gearwright.spec.record import Record, build
from gearwright.spec.studies.axis import Value
from gearwright.units import Ratio
from gearwright.verbs import verb

MOST_FLIGHTS = 100_000_000
"""Flights of a life [-]: no gearbox makes a thousand a day for two hundred years."""
WHOLE = 1e-6
"""By how much the shares of a file may miss 1: what is left of thirds with six digits [-]."""


class MixedMission(Record):
    """One mission of a mix: how often it is flown, and what differs from its file."""

    mission: str = Field(description="Mission file, or name of a shipped mission")
    share: Ratio | None = Field(None, gt=0, le=1, description="Part of all flights; the sum of a mix is 1")
    count: int | None = Field(
        None, ge=1, le=MOST_FLIGHTS, description="Flights of the life, instead of a share; all missions alike"
    )
    changes: dict[str, Value] = Field(
        default_factory=dict, description="Dotted path of the mission, with unit -> value, such as a shorter cruise"
    )


class MixFile(Record):
    """Several missions that one gearbox flies in its life."""

    schema_version: Literal[1] = Field(1, alias="schema", description="Version of this file format")
    name: str = Field(description="Name of the mix")
    description: str = Field("", description="Whose life it is, and what of it is assumed")
    flights: int | None = Field(
        None, ge=1, le=MOST_FLIGHTS, description="Of the whole life; left out: the sum of all counts"
    )
    missions: dict[str, MixedMission] = Field(min_length=1, description="Missions by a name of one's own")
    bearings: BearingLifeRules | None = Field(
        None, description="Chosen from the catalogue where the design names none; left out: as each mission says"
    )


@dataclass(frozen=True, repr=False)
class Mix(Shown):
    """Missions that one gearbox flies in its life, read and ready to fly."""

    name: str
    description: str
    flights: int
    """Of the whole life [-]."""
    missions: Mapping[str, Mission]
    """By their names in the mix."""
    shares: Mapping[str, float]
    """Mission -> part of all flights, with sum 1 [-]."""

    def count(self, mission: str) -> float:
        """Return how often a mission is flown [-].

        Args:
            mission: By its name in the mix.
        """
        return self.shares[mission] * self.flights


@verb
def read_mix(path: str | Path) -> Mix:
    """Return the mix that a file describes, with the missions that it names.

    Args:
        path: A TOML file, or the name of a shipped mix; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file: shares that do not add up to 1, missions that are not there.
    """
    file = find_mix(str(path))
    return parse_mix(file_text(file), source=str(path), folder=file.parent)


def parse_mix(text: str, *, source: str = "", folder: Path | None = None) -> Mix:
    """Return the mix that a TOML text describes, with the missions that it names.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where mission files are looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    tables = toml_tables(text, source)
    if "phases" in tables and "missions" not in tables:
        message = f"this is a mission; gearwright fly DESIGN {source or 'FILE'} flies it, and a mix names it"
        raise DesignError([Problem("phases", message)], source)
    record, written = build(MixFile, tables)
    problems, missions = list(written.problems), dict[str, Mission]()
    if record is not None and not problems:
        file = cast(MixFile, record)
        problems += _problems(file)
        for name, entry in file.missions.items():
            try:
                missions[name] = _mission(file, entry, folder or Path())
            except DesignError as error:
                problems += _said(name, entry, error)
    if problems:
        raise DesignError(placed(problems, text), source)
    return _mix(cast(MixFile, record), missions)


def _mix(file: MixFile, missions: Mapping[str, Mission]) -> Mix:
    parts = {name: entry.share or float(entry.count or 0) for name, entry in file.missions.items()}
    whole = sum(parts.values())
    flights = file.flights or round(whole)
    shares = {name: part / whole for name, part in parts.items()}
    return Mix(file.name, file.description, flights, missions, shares)


def _problems(file: MixFile) -> Iterator[Problem]:
    """Yield what does not fit together in shares and counts."""
    entries = file.missions
    for name, entry in entries.items():
        if (entry.share is None) == (entry.count is None):
            given = "neither is" if entry.share is None else "both are"
            yield Problem(f"missions.{name}", f"{given} given; give share, a part of all flights, or count")
    shares = [entry.share for entry in entries.values() if entry.share is not None]
    counts = [entry.count for entry in entries.values() if entry.count is not None]
    if shares and counts:
        yield Problem("missions", "some have a share and some a count; give all of them the same")
    elif shares and abs(sum(shares) - 1.0) > WHOLE:
        yield Problem("missions", f"their shares add up to {sum(shares):g}; they have to add up to 1")
    elif shares and file.flights is None:
        yield Problem("flights", "is required beside shares; write how many flights the life has, such as 30000")
    elif counts and file.flights not in (None, sum(counts)):
        message = f"{file.flights} flights, and counts of {sum(counts)}; leave flights out, or change the counts"
        yield Problem("flights", message)


def _mission(file: MixFile, entry: MixedMission, folder: Path) -> Mission:
    """Return a mission as the mix flies it, whose map and deck are found from anywhere on this machine."""
    if entry.mission in shipped_mixes() and entry.mission not in shipped_missions():
        raise _mix_in_mix(entry.mission)
    path = find_mission(entry.mission, folder, key="")
    tables = toml_tables(file_text(path), str(path))
    if "missions" in tables and "phases" not in tables:
        raise _mix_in_mix(entry.mission)
    mission = edited_mission(read_mission(path), entry.changes) if entry.changes else read_mission(path)
    update: dict[str, object] = {} if file.bearings is None else {"bearings": file.bearings}
    if is_map_file(mission.propeller_map):
        update["propeller_map"] = str(beside(mission.propeller_map, path.parent, "propeller_map").resolve())
    if mission.engine.deck is not None:
        found = str(beside(mission.engine.deck, path.parent, "engine.deck").resolve())
        update["engine"] = mission.engine.model_copy(update={"deck": found})
    return mission.model_copy(update=update)


def _mix_in_mix(name: str) -> DesignError:
    message = f"{excerpt(name)!r} is a mix itself; a mix is made of missions: name those of it, with their shares"
    return DesignError([Problem("", message)])


def _said(name: str, entry: MixedMission, error: DesignError) -> Iterator[Problem]:
    """Yield what is wrong with a mission, at its place in the mix."""
    for problem in error.problems:
        changed = next((path for path in entry.changes if problem.path == path), None)
        at = f"missions.{name}.mission" if changed is None else f"missions.{name}.changes.{changed}"
        told = (error.source, problem.path if problem.path not in ("name", changed) else "", problem.message)
        yield Problem(at, ": ".join(filter(None, told)))
