"""Exit codes of commands, interruption, and refusal of options without effect."""

from __future__ import annotations

import inspect
import math
import signal
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from types import FrameType, MappingProxyType
from typing import TYPE_CHECKING, Any, ParamSpec, get_args, get_type_hints

import typer

from gearwright.cli.terminal import tell
from gearwright.errors import Problem, refuse
from gearwright.signals import ENDING, answered, heard_by, interrupt

if TYPE_CHECKING:
    from gearwright.dynamics import Trace
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# Options that do nothing as they are given, or are no finite number: refused, never passed over in silence.
#
# An option that only means something with another one, or nothing beside another one, stands here by the names of the
# command's parameters. One with its default is not seen as given: it changes nothing anyway.
# ----------------------------------------------------------------------------------------------------------------------


Others = tuple[str, ...]
_POINT = ("diameter_m", "tas_m_s", "altitude_m", "power_kw", "blade_angle_deg", "incidence_deg")
_SLAM = ("slam_mach", "slam_s", "acceleration")
_TRANSIENT = ("inertia_kg_m2", "slam_altitude_m", "isa_offset_k")
_STUDY = (
    "changes", "journal", "shard", "workers", "cluster", "csv", "export", "figure", "report", "json", "jsonl",
)  # fmt: skip
NEEDS: Mapping[str, Mapping[str, Others]] = MappingProxyType({
    "new": {"file": ("name",), "force": ("name",)},
    "review": {"date": ("report", "pdf")},
    "draw": {"date": ("report",)},
    "validate": {"date": ("report",)},
    "sharing": {"percent": ("target",)},
    "fly": {"date": ("report",), **dict.fromkeys(("life_h", "report", "csv", "json", "jsonl"), ("design",))},
    "window": {"date": ("report",),
               **dict.fromkeys(("stiffness", "output", "figure", "report", "json", "jsonl"), ("name",))},
    "propeller": dict.fromkeys(_POINT, ("rpm",)),
    "rotor": {"tail_induced_factor": ("tail_diameter_m",)},
    "turboshaft": {**dict.fromkeys(_SLAM, ("slam_kw",)), **dict.fromkeys(_TRANSIENT, ("slam_kw", "starter_nm")),
                   **dict.fromkeys(("n2_gain", "n2_integral", "n2_limit"), ("rotor_inertia_kg_m2",)),
                   **dict.fromkeys(("starter_cut", "hottest_k"), ("starter_nm",))},
    "study": {**dict.fromkeys(_STUDY, ("name",)), "tls": ("cluster",)},
    "resume": {"tls": ("cluster",)},
    "optimise": {"anyway": ("journal",)},
    "cluster": {"study": ("slurm",)},
})  # fmt: skip
"""Command -> parameter -> those of which one must be given, too."""
BESIDE: Mapping[str, Mapping[str, Others]] = MappingProxyType({
    "new": {"json": ("name",)},
    "run": {"full": ("json",)},
    "close": {"rounds": ("json",)},
    "schema": {"of": ("answer",)},
    "propeller": dict.fromkeys(("activity_factor", "design_lift"), ("file",)),
    "status": {"json": ("verify",)},
    "cluster": dict.fromkeys(("host", "processes", "tls"), ("slurm",)),
    "thesis": dict.fromkeys(("out", "errata"), ("chapter_4",)),
})  # fmt: skip
"""Command -> parameter -> those beside which it does nothing."""


def refuse_idle(command: Callable[..., None], values: Mapping[str, Any]) -> None:
    """Refuse what is given to a command and would do nothing, or is no finite number; all of it at once.

    Args:
        command: As it is registered.
        values: Of its parameters, by name.
    """
    defaults = {name: entry.default for name, entry in inspect.signature(command).parameters.items()}
    given = {name for name, value in values.items() if value != defaults[name] and value not in (None, ())}
    refuse([*_idle(command, given), *_not_finite(command, {name: values[name] for name in sorted(given)})])


def _idle(command: Callable[..., None], given: set[str]) -> Iterator[Problem]:
    """Yield what is given in vain."""
    needs = NEEDS.get(command.__name__, {})
    beside = {"json": ("jsonl",), **BESIDE.get(command.__name__, {})}
    for name, others in needs.items():
        if name in given and not given.intersection(others):
            asked = " or ".join(_written(command, others))
            yield Problem(
                _written(command, [name])[0], f"does nothing without {asked}; give that, too, or leave it out"
            )
    for name, others in beside.items():
        if name in given and (stronger := [other for other in others if other in given]):
            asked = " and ".join(_written(command, stronger))
            yield Problem(_written(command, [name])[0], f"does nothing beside {asked}; leave one of them out")


def _not_finite(command: Callable[..., None], given: Mapping[str, Any]) -> Iterator[Problem]:
    """Yield the numbers that are infinite, or not a number."""
    for name, value in given.items():
        if isinstance(value, float) and not math.isfinite(value):
            yield Problem(_written(command, [name])[0], f"{value}; give a finite number")


def _written(command: Callable[..., None], names: Sequence[str]) -> list[str]:
    """Return parameters as users write them: ``--date``, ``BLADES``."""
    hints = get_type_hints(command, include_extras=True)
    return [_as_given(name, get_args(hints[name])[1]) for name in names]


def _as_given(name: str, mark: Any) -> str:
    declared: Sequence[str] = getattr(mark, "param_decls", None) or ()
    if type(mark).__name__ == "ArgumentInfo":
        return str(mark.metavar or name).strip("[]").upper()
    return next(iter(declared), f"--{name.replace('_', '-')}")


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
