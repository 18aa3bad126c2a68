"""The envelope in which every command answers with ``--json`` and ``--jsonl``, and the schema of it.

``--json`` prints one object; ``--jsonl`` the same without its rows, and then a line for every row. Neither writes a
file that is not asked for by its name.
"""

from __future__ import annotations

import json
import signal
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import wraps
from importlib import import_module
from pathlib import Path
from types import FrameType, MappingProxyType
from typing import TYPE_CHECKING, Any, ParamSpec

import typer

from gearwright.cli.options import refuse_idle
from gearwright.cli.terminal import show_json, tell
from gearwright.signals import ENDING, answered, heard_by, interrupt
from gearwright.version import __version__

if TYPE_CHECKING:
    from gearwright.dynamics import Trace
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# The envelope in which every command answers with ``--json`` and ``--jsonl``, and the schema of it.
# ----------------------------------------------------------------------------------------------------------------------


_ROOM = "gearwright.render.answers."
ANSWERS: Mapping[str, tuple[str, str]] = MappingProxyType({
    "new": (f"{_ROOM}weights:NewAnswer", ""),
    "run": (f"{_ROOM}motion:RunAnswer", ""),
    "check": (f"{_ROOM}design:CheckAnswer", ""),
    "size": (f"{_ROOM}design:SizeAnswer", ""),
    "arrange": (f"{_ROOM}review:ArrangeAnswer", ""),
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
    "architectures": 4, "arrange": 2, "campbell": 3, "check": 2, "close": 5, "compare": 3, "compare closed": 6,
    "duty": 2, "fly": 8, "modes": 2, "optimise": 3, "propeller": 2, "replay colibri": 2, "response": 2, "resume": 3,
    "review": 4, "run": 23, "runup": 3, "simulate": 3, "size": 23, "study": 3, "turboshaft": 3, "window": 4,
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
    'urn:gearwright:answer:replay-colibri:2'
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


# ----------------------------------------------------------------------------------------------------------------------
# How a command ends: its exit codes, and what is kept of one that is interrupted.
# ----------------------------------------------------------------------------------------------------------------------


FAILED, WRONG = 1, 2
CTRL_C = 128 + signal.SIGINT
BROKEN_PIPE = 141
"""Nobody reads what is printed: 128 and the number of SIGPIPE."""

P = ParamSpec("P")
_heard, _said = list[int](), list[str]()
"""Signals that have asked the command to end, and what was said of it."""


@contextmanager
def listening() -> Iterator[None]:
    """Let every signal that asks a command to end, and is not ignored, interrupt it as Ctrl-C does."""
    usual = (signal.SIG_DFL, signal.default_int_handler)
    _heard.clear()
    _said.clear()
    with heard_by(_interrupt, [number for number in ENDING if signal.getsignal(number) in usual]):
        try:
            yield
        finally:
            answered()


def _interrupt(number: int, frame: FrameType | None) -> None:
    _heard.append(number)
    interrupt(number, frame)


def is_interrupted() -> bool:
    """Tell whether a signal has asked the command to end: what goes wrong from then on follows from that."""
    return bool(_heard)


def interrupted_code() -> int:
    """Return the exit code of an interruption: 128 and the number of the signal, as shells have it; 130 for Ctrl-C."""
    return 128 + (_heard[0] if _heard else signal.SIGINT)


def interrupted(kept: str = "") -> int:
    """Say that the command is interrupted, and what is kept, where nothing has yet; return its exit code.

    Args:
        kept: In words.
    """
    answered()
    if not _said:
        _said.append(f"interrupted: {kept}" if kept else "interrupted")
        tell(_said[0])
    return interrupted_code()


def ended_well(command: Callable[P, None]) -> Callable[P, None]:
    """Return a command that ends without a word about itself when it is interrupted or nobody reads it.

    What is given to it and would do nothing is refused first.
    """

    @wraps(command)
    def run(*args: P.args, **kwargs: P.kwargs) -> None:
        refuse_idle(command, kwargs)
        try:
            command(*args, **kwargs)
        except BrokenPipeError:
            raise typer.Exit(BROKEN_PIPE) from None
        except (KeyboardInterrupt, Exception) as reason:  # libraries that are interrupted as they load raise others
            if isinstance(reason, typer.Exit) or not (is_interrupted() or isinstance(reason, KeyboardInterrupt)):
                raise
            raise typer.Exit(interrupted()) from None

    return run


def interrupted_name(path: Path) -> Path:
    """Return the name that a file gets whose run was interrupted: it never stands where a complete one is looked for.

    >>> interrupted_name(Path("run.nc")).name
    'run-interrupted.nc'
    """
    return path.with_stem(f"{path.stem}-interrupted")


def save_run(path: Path, trace: Trace, sizing: Sizing, case: str) -> Path:
    """Write a run, an interrupted one under its own name; return that name."""
    from gearwright.store import StoredRun, save

    target = interrupted_name(path) if trace.interrupted else path
    save(StoredRun(sizing.design, case, trace), target)
    return target


def save_runs(path: Path, traces: Mapping[str, Trace], sizing: Sizing) -> list[Path]:
    """Write the runs of some load cases, the first under the name itself, others with the case behind it.

    Args:
        path: Of the first.
        traces: Load case -> run.
        sizing: They are of.

    Returns:
        Where they are.
    """
    names = [path, *(path.with_stem(f"{path.stem}-{case}") for case in list(traces)[1:])]
    return [save_run(name, trace, sizing, case) for name, (case, trace) in zip(names, traces.items(), strict=True)]


def end_interrupted(trace: Trace, kept: Path | None) -> None:
    """End with the code of an interruption, and say what is kept, if the run was interrupted."""
    if trace.interrupted:
        words = f"its first {trace.duration:.4g} s are in {kept}" if kept else "nothing is kept; --output keeps it"
        raise typer.Exit(interrupted(words))


def named_after(design: str, what: str) -> Path:
    """Return where a command writes by itself: here, under the name of the design, so that two designs do not meet.

    >>> named_after("designs/mine.toml", "report.html").name
    'mine-report.html'
    """
    return Path(f"{Path(design).stem}-{what}")
