"""Study files and the missions that they name, made a study that needs no file from then on."""

from __future__ import annotations

from pathlib import Path
from typing import cast

from gearwright.errors import DesignError, Problem
from gearwright.reading import beside
from gearwright.shipped import find_mission, find_study
from gearwright.spec.flying import is_map_file, read_mission
from gearwright.spec.missions import Mission
from gearwright.spec.read import file_text, placed, toml_tables
from gearwright.spec.record import build
from gearwright.spec.studies.axis import Value
from gearwright.spec.studies.checks import study_problems
from gearwright.spec.studies.study import MISSION_PATH, Study
from gearwright.verbs import verb

MAP_PATH = f"{MISSION_PATH}propeller_map"


@verb
def read_study(path: str | Path) -> Study:
    """Return the study that a file describes, with the mission that it names.

    Args:
        path: A TOML file, or the name of a shipped study; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file.
    """
    file = find_study(str(path))
    return parse_study(file_text(file), source=str(path), folder=file.parent)


def parse_study(text: str, *, source: str = "", folder: Path | None = None) -> Study:
    """Return the study that a TOML text describes, with the mission that it names.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where a mission file is looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    record, written = build(Study, toml_tables(text, source))
    problems = list(written.problems) or study_problems(cast(Study, record))
    if problems:
        raise DesignError(placed(problems, text), source)
    return with_mission(cast(Study, record), folder or Path())


def with_mission(study: Study, folder: Path) -> Study:
    """Return a study that holds the mission that it names, so that it needs no file from then on.

    Args:
        study: As written.
        folder: Where a mission file is looked for.

    Raises:
        DesignError: If a mission is needed and none is given, or the one that is named cannot be read.
    """
    if study.fly.mission is not None:
        study = study.model_copy(update={"mission": _mission_of(study.fly.mission, folder)})
    elif study.mission is not None:
        study = study.model_copy(update={"mission": _with_map(study.mission, folder)})
    paths = [f"axes.{path}" for path in study.axes if path.startswith(MISSION_PATH)]
    paths += [f"changes.{path}" for path in study.changes if path.startswith(MISSION_PATH)]
    if study.mission is None and (study.flies or paths):
        message = 'nothing says what is flown; write [fly] mission = "thesis", or another mission file'
        raise DesignError([Problem(paths[0] if paths else "fly.mission", message)])
    return _with_maps(study, folder)


def mission_changed(study: Study, folder: Path) -> bool:
    """Tell whether the mission file that a study names, if it is still there, says something else now.

    Args:
        study: With the mission as it was.
        folder: Where the file is looked for.
    """
    if study.fly.mission is None or not find_mission(study.fly.mission, folder).is_file():
        return False
    return _mission_of(study.fly.mission, folder) != study.mission


def _mission_of(name: str, folder: Path) -> Mission:
    path = find_mission(name, folder)
    return _with_map(read_mission(path), path.parent)


def _with_map(mission: Mission, folder: Path) -> Mission:
    """Return a mission whose propeller map and engine deck, where files, are found from anywhere on this machine."""
    update: dict[str, object] = {"propeller_map": _map_from(mission.propeller_map, folder, "mission.propeller_map")}
    if mission.engine.deck is not None:
        deck = str(beside(mission.engine.deck, folder, "mission.engine.deck").resolve())
        update["engine"] = mission.engine.model_copy(update={"deck": deck})
    return mission.model_copy(update=update)


def _with_maps(study: Study, folder: Path) -> Study:
    """Return a study whose other propeller maps, too, which it varies, are found from anywhere on this machine."""
    changes, axes = dict(study.changes), dict(study.axes)
    if MAP_PATH in changes:
        changes[MAP_PATH] = _map_from(changes[MAP_PATH], folder, f"changes.{MAP_PATH}")
    if MAP_PATH in axes and axes[MAP_PATH].values is not None:
        values = [_map_from(value, folder, f"axes.{MAP_PATH}") for value in axes[MAP_PATH].values or []]
        axes[MAP_PATH] = axes[MAP_PATH].model_copy(update={"values": values})
    return study.model_copy(update={"changes": changes, "axes": axes})


def _map_from(name: Value, folder: Path, key: str) -> Value:
    if not isinstance(name, str) or not is_map_file(name):
        return name
    return str(beside(name, folder, key).resolve())
