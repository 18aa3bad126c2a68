"""How a command ends: its exit codes, and what is kept of one that is interrupted."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, ParamSpec

import typer

from gearwright.cli.terminal.output import tell

if TYPE_CHECKING:
    from gearwright.dynamics import Trace
    from gearwright.sizing import Sizing

FAILED, WRONG = 1, 2
INTERRUPTED = 130
"""After Ctrl-C: 128 and the number of SIGINT, as shells have it."""
BROKEN_PIPE = 141
"""Nobody reads what is printed: 128 and the number of SIGPIPE."""

P = ParamSpec("P")


def ended_well(command: Callable[P, None]) -> Callable[P, None]:
    """Return a command that ends without a word about itself when it is interrupted or nobody reads it."""

    @wraps(command)
    def run(*args: P.args, **kwargs: P.kwargs) -> None:
        try:
            command(*args, **kwargs)
        except KeyboardInterrupt:
            tell("interrupted")
            raise typer.Exit(INTERRUPTED) from None
        except BrokenPipeError:
            raise typer.Exit(BROKEN_PIPE) from None

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
        tell(f"interrupted: {words}")
        raise typer.Exit(INTERRUPTED)


def named_after(design: str, what: str) -> Path:
    """Return where a command writes by itself: here, under the name of the design, so that two designs do not meet.

    >>> named_after("designs/mine.toml", "report.html").name
    'mine-report.html'
    """
    return Path(f"{Path(design).stem}-{what}")
