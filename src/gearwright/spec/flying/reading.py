"""Reading a mission: the file, its problems all at once, and the propeller map and engine deck that it names."""

from __future__ import annotations

from pathlib import Path
from typing import cast

from gearwright.errors import DesignError, Problem
from gearwright.reading import beside
from gearwright.shipped import find_mission
from gearwright.spec.flying.checks import mission_problems
from gearwright.spec.missions import Mission
from gearwright.spec.read import file_text, placed, toml_tables
from gearwright.spec.record import build
from gearwright.verbs import verb

_MAP_FILE = ".csv"
"""How the name of a map ends that is a file."""


@verb
def read_mission(path: str | Path) -> Mission:
    """Return the mission that a file describes.

    Args:
        path: A TOML file, or the name of a shipped mission; a file of that name comes first.

    Raises:
        DesignError: With every problem of the file.
    """
    file = find_mission(str(path))
    return parse_mission(file_text(file), source=str(path), folder=file.parent)


def parse_mission(text: str, *, source: str = "", folder: Path | None = None) -> Mission:
    """Return the mission that a TOML text describes.

    Args:
        text: The file's content.
        source: Name of the file, for messages.
        folder: Where propeller map and engine deck are looked for; left out: where the program runs.

    Raises:
        DesignError: With every problem of the text.
    """
    record, written = build(Mission, toml_tables(text, source))
    problems = list(written.problems)
    if record is not None and not problems:
        problems += mission_problems(cast(Mission, record))
        problems += map_problems(cast(Mission, record).propeller_map, folder or Path())
        problems += deck_problems(cast(Mission, record).engine.deck, folder or Path())
    if problems:
        raise DesignError(placed(problems, text), source)
    return cast(Mission, record)


def is_map_file(name: str) -> bool:
    """Tell whether a propeller map is a file of the user's, not a shipped one.

    Args:
        name: As a mission or a study gives it.
    """
    return name.endswith(_MAP_FILE)


def map_problems(name: str, folder: Path) -> tuple[Problem, ...]:
    """Return why a propeller map cannot be had from where it is said to be.

    Args:
        name: Of a shipped map or a file.
        folder: Of the mission, in which the file must stand.
    """
    try:
        if is_map_file(name):
            beside(name, folder, "propeller_map")
    except DesignError as error:
        return error.problems
    return ()


def deck_problems(name: str | None, folder: Path) -> tuple[Problem, ...]:
    """Return why an engine deck cannot be had from where it is said to be.

    Args:
        name: Of the file; None: there is none.
        folder: Of the mission, in which the file must stand.
    """
    try:
        if name is not None:
            beside(name, folder, "engine.deck")
    except DesignError as error:
        return error.problems
    return ()
