"""The envelope in which every command answers with ``--json`` and ``--jsonl``, and the schema of it.

``--json`` prints one object; ``--jsonl`` the same without its rows, and then a line for every row. Neither writes a
file that is not asked for by its name.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from importlib import import_module
from types import MappingProxyType
from typing import Any

from gearwright.cli.terminal import show_json
from gearwright.version import __version__

_ROOM = "gearwright.render.answers."
ANSWERS: Mapping[str, tuple[str, str]] = MappingProxyType({
    "new": (f"{_ROOM}weights:NewAnswer", ""),
    "run": (f"{_ROOM}motion:RunAnswer", ""),
    "check": (f"{_ROOM}design:CheckAnswer", ""),
    "size": (f"{_ROOM}design:SizeAnswer", ""),
    "close": (f"{_ROOM}review:CloseAnswer", ""),
    "review": (f"{_ROOM}review:ReviewAnswer", ""),
    "modes": (f"{_ROOM}motion:ModesAnswer", ""),
    "simulate": (f"{_ROOM}motion:SimulateAnswer", f"{_ROOM}motion:Instant"),
    "campbell": (f"{_ROOM}motion:CampbellAnswer", ""),
    "response": (f"{_ROOM}motion:ResponseAnswer", ""),
    "runup": (f"{_ROOM}motion:RunUpAnswer", ""),
    "sharing": (f"{_ROOM}motion:SharingAnswer", ""),
    "fly": (f"{_ROOM}flights:FlyAnswer", f"{_ROOM}flights:Moment"),
    "mix": (f"{_ROOM}flights:MixAnswer", ""),
    "duty": (f"{_ROOM}flights:DutyAnswer", ""),
    "propeller": (f"{_ROOM}flights:PropellerAnswer", f"{_ROOM}flights:MapPoint"),
    "rotor": ("gearwright.catalogue:RotorTrim", ""),
    "turboshaft": (f"{_ROOM}flights:TurboshaftAnswer", "gearwright.catalogue.turboshafts:DeckRow"),
    "window": (f"{_ROOM}flights:WindowAnswer", f"{_ROOM}motion:Instant"),
    "compare": (f"{_ROOM}studies:StudyAnswer", f"{_ROOM}studies:StudyRow"),
    "compare closed": (f"{_ROOM}review:EqualLifeAnswer", ""),
    "architectures": (f"{_ROOM}studies:ArchitecturesAnswer", ""),
    "optimise": (f"{_ROOM}studies:OptimiseAnswer", ""),
    "study": (f"{_ROOM}studies:StudyAnswer", f"{_ROOM}studies:StudyRow"),
    "study reduced": (f"{_ROOM}studies:ReducedAnswer", ""),
    "resume": (f"{_ROOM}studies:StudyAnswer", f"{_ROOM}studies:StudyRow"),
    "status": (f"{_ROOM}studies:StatusAnswer", ""),
    "mass": (f"{_ROOM}weights:MassAnswer", ""),
    "engines": (f"{_ROOM}weights:EnginesAnswer", f"{_ROOM}weights:EngineRow"),
    "validate": (f"{_ROOM}weights:ValidateAnswer", "gearwright.validate:Checked"),
    "replay colibri": ("gearwright.replays.colibri.pages:ColibriAnswer", ""),
})  # fmt: skip
"""Command -> type of its answer, and of its rows where it has any."""
REVISIONS: Mapping[str, int] = MappingProxyType({
    "campbell": 3, "check": 2, "close": 3, "compare": 3, "compare closed": 3, "duty": 2, "fly": 8, "modes": 2,
    "optimise": 2, "propeller": 2, "response": 2, "resume": 3, "review": 3, "run": 20, "runup": 3, "simulate": 3,
    "size": 20, "study": 3, "turboshaft": 3, "window": 4,
})  # fmt: skip
"""Command -> number of its schema, where keys of its answer have changed since the first."""
ROWS = "rows"
"""Key that `--jsonl` leaves out of an answer, as its rows follow."""


def show_answer(command: str, answer: object, *, design: str | None = None) -> None:
    """Print an answer as one JSON object.

    Args:
        command: A key of `ANSWERS`.
        answer: A record of the command's type.
        design: Name of the design that it is about, if it is about one.
    """
    show_json(answer_text(command, answer, design=design))


def answer_text(command: str, answer: object, *, design: str | None = None) -> str:
    """Return an answer as JSON.

    Args:
        command: A key of `ANSWERS`.
        answer: A record of the command's type.
        design: Name of the design that it is about, if it is about one.
    """
    return json.dumps(_envelope(command, answer, design), indent=2, ensure_ascii=False, allow_nan=False)


def show_rows(command: str, answer: object, rows: Iterable[object], *, design: str | None = None) -> None:
    """Print an answer as JSON Lines: the envelope without rows, then one row a line.

    Args:
        command: A key of `ANSWERS`.
        answer: A record of the command's type.
        rows: Records of the type of the command's rows.
        design: Name of the design that it is about, if it is about one.
    """
    envelope = _envelope(command, answer, design)
    envelope["result"].pop(ROWS, None)
    show_json(json.dumps(envelope, ensure_ascii=False, allow_nan=False))
    for row in rows:
        show_row(row)


def show_row(row: object) -> None:
    """Print one row as a line of JSON.

    Args:
        row: A record of the type of a command's rows.
    """
    from gearwright.render.answers.schema import plain

    show_json(json.dumps(plain(row), ensure_ascii=False, allow_nan=False))


def _envelope(command: str, answer: object, design: str | None) -> dict[str, Any]:
    from gearwright.render.answers.schema import plain

    return {
        "schema": schema_id(command),
        "version": __version__,
        "design": design,
        "command": command,
        "result": plain(answer),
    }


def schema_id(command: str) -> str:
    """Return the name of the schema of a command's answer.

    >>> schema_id("replay colibri")
    'urn:gearwright:answer:replay-colibri:1'
    """
    return f"urn:gearwright:answer:{command.replace(' ', '-')}:{REVISIONS.get(command, 1)}"


def answer_schema(command: str) -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of what a command prints with ``--json``.

    Args:
        command: A key of `ANSWERS`.
    """
    from gearwright.render.answers.schema import described
    from gearwright.spec.schema import DIALECT

    answer, row = ANSWERS[command]
    definitions: dict[str, Any] = {}
    properties = {
        "schema": {"const": schema_id(command), "description": "The name of this schema"},
        "version": {"type": "string", "description": "Of gearwright"},
        "design": {"type": ["string", "null"], "description": "Name of the design; null where it is about none"},
        "command": {"const": command},
        "result": described(_type(answer), definitions),
    }
    lines = {"rows": described(_type(row), definitions)} if row else {}
    return {
        "$schema": DIALECT,
        "$id": schema_id(command),
        "title": f"gearwright {command} --json",
        "description": "Every key of a quantity ends in its unit. null: infinite, or there is no such number. A line of"
        " --jsonl after the first is what stands under rows.",
        "type": "object",
        "properties": properties,
        "required": list(properties),
        "additionalProperties": False,
        **lines,
        "$defs": definitions,
    }


def _type(name: str) -> type:
    module, _, kind = name.partition(":")
    found: type = getattr(import_module(module), kind)
    return found
