"""How a command ends: its exit codes, and what is kept of one that is interrupted."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, ParamSpec

import typer

from gearwright.cli.idle_options import refuse_idle
from gearwright.cli.terminal import tell
from gearwright.signals import ENDING, answered, heard_by, interrupt

if TYPE_CHECKING:
    from gearwright.dynamics import Trace
    from gearwright.sizing import Sizing

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
