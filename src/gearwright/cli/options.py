"""Options and arguments that several commands share, shell completion, and options that would do nothing: refused."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, get_args, get_type_hints

import typer

from gearwright.errors import DesignError, Problem, install, refuse

if TYPE_CHECKING:
    from gearwright.dynamics.vibration import SpeedCase
    from gearwright.render.pages.page import Stamp
    from gearwright.reviews import Review
    from gearwright.sizing import Sizing
    from gearwright.spec import Axis, Bound, Design, Value


# ----------------------------------------------------------------------------------------------------------------------
# What a shell completes: names of shipped designs, missions, mixes, studies and notebooks, and files beside them.
# ----------------------------------------------------------------------------------------------------------------------


def _shipped_of(kind: str) -> Callable[[str], list[str]]:
    def completed(incomplete: str) -> list[str]:
        import gearwright.shipped

        return _beginning(incomplete, getattr(gearwright.shipped, f"shipped_{kind}")())

    return completed


designs, missions, mixes, studies = map(_shipped_of, ("designs", "missions", "mixes", "studies"))
"""Each returns what begins so: shipped files of its kind, and TOML files."""


def shipped(incomplete: str) -> list[str]:
    """Return everything shipped that begins so.

    Args:
        incomplete: What stands on the command line.
    """
    from gearwright.shipped import shipped_designs, shipped_missions, shipped_mixes, shipped_notebooks, shipped_studies

    names = (*shipped_designs(), *shipped_missions(), *shipped_mixes(), *shipped_studies(), *shipped_notebooks())
    return [name for name in names if name.startswith(incomplete)]


def _beginning(incomplete: str, names: Iterable[str]) -> list[str]:
    """Return names, TOML files and folders that begin so; a file may stand in a folder."""
    place = Path(incomplete) if incomplete.endswith("/") else Path(incomplete).parent
    try:
        beside = sorted(place.iterdir())
    except OSError:
        beside = []
    files = [f"{path}/" if path.is_dir() else str(path) for path in beside if path.suffix == ".toml" or path.is_dir()]
    return [name for name in (*names, *files) if name.startswith(incomplete)]


# ----------------------------------------------------------------------------------------------------------------------
# Arguments and options that several commands take, each written once.
# ----------------------------------------------------------------------------------------------------------------------


DesignArgument = Annotated[
    str,
    typer.Argument(
        help="Design file, or the name of a shipped design",
        metavar="DESIGN",
        autocompletion=designs,
    ),
]
MissionArgument = Annotated[
    str,
    typer.Argument(
        help="Mission file, or the name of a shipped mission",
        autocompletion=missions,
    ),
]
CaseOption = Annotated[str | None, typer.Option(help="Load case; left out: the governing one, of least margin")]
DateOption = Annotated[str, typer.Option("--date", help="Date for the head of the page; left out: none")]
PdfOption = Annotated[Path | None, typer.Option("--pdf", help="Print the page to this PDF file, by a browser")]
ReportOption = Annotated[Path | None, typer.Option("--report", help="Write one self-contained HTML page")]


def drawable(path: Path | None) -> Path | None:
    """Return where a figure goes, refused before anything is computed where it could not be drawn.

    Args:
        path: Of the figure, if one is asked for.

    Raises:
        DesignError: If the name ends otherwise than with .svg or .png, or PNG has no matplotlib.
    """
    if path is None or path.suffix == ".svg":
        return path
    from importlib.util import find_spec

    if path.suffix != ".png":
        message = f"{path.suffix!r} is not drawn; end the name with .svg or .png"
        raise DesignError([Problem("--figure", message)])
    if find_spec("matplotlib") is None:
        message = f"PNG needs matplotlib, which is not here; {install('png')}, or end the name with .svg"
        raise DesignError([Problem("--figure", message)])
    return path


FigureOption = Annotated[Path | None, typer.Option(help="Write the figure (.svg or .png)", callback=drawable)]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON object for machines, and write no files")]
LinesOption = Annotated[
    bool, typer.Option("--jsonl", help="Print JSON Lines: the answer without its rows, then a line for every row")
]

FreeOption = Annotated[
    str | None,
    typer.Option(
        help="What may be changed, too, also where the design gives it, while all becomes lighter: teeth, shifts,"
        " planets, helix, material, rims, webs, with a comma; or all"
    ),
]


def steps(text: str, option: str) -> list[float]:
    """Return first, first + step … last.

    Args:
        text: ``first:last:step``.
        option: That gives it, without dashes.

    Raises:
        DesignError: The text is not of that form, or the steps never reach the end.
    """
    try:
        first, last, step = (float(part) for part in text.split(":"))
        count = (last - first) / step
        if not 0.0 < count < 1e6:
            raise ValueError(text)
    except (ValueError, ZeroDivisionError):
        message = f"{text!r} is not first:last:step with a step towards the last, such as 0:4:0.1"
        raise DesignError([Problem(f"--{option}", message)]) from None
    return [round(first + k * step, 9) for k in range(math.floor(count + 1e-9) + 1)]


# ----------------------------------------------------------------------------------------------------------------------
# Freedoms and bounds as a user writes them on the command line.
# ----------------------------------------------------------------------------------------------------------------------


def axis_of(text: str) -> tuple[str, Axis]:
    """Return path and axis of a text such as ``motors.electric.speed_rpm=4000..6000`` or ``gears.material=a,b``.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it is neither a range nor a list.

    >>> axis_of("planetaries.first.planets=3,4,5")[1].values
    [3, 4, 5]
    """
    from gearwright.spec.studies import Axis

    path, equals, written = (part.strip() for part in text.partition("="))
    low, dots, high = written.partition("..")
    if not path or not equals or not written:
        raise DesignError([Problem("--free", f"{text!r} is no freedom; write PATH=FROM..TO, or PATH=VALUE,VALUE")])
    if not dots:
        return path, Axis.model_validate({"values": [_value(part) for part in written.split(",")]})
    ends = [_value(low), _value(high)]
    refuse(
        Problem("--free", f"{path}: {end!r} is no number; a range is FROM..TO, such as 4000..6000")
        for end in ends
        if not isinstance(end, int | float) or not math.isfinite(end)
    )
    return path, Axis.model_validate({"from": ends[0], "to": ends[1]})


def _value(text: str) -> Value:
    """Return a number or a word."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text.strip()


def bound_of(text: str) -> tuple[str, Bound]:
    """Return result and bound of a text such as ``envelope.length<=400``, in the unit of the tables.

    Args:
        text: As a user wrote it.

    Raises:
        DesignError: If it is none.

    >>> bound_of("envelope.length<=400")
    ('envelope.length', Bound(minimum=None, maximum=400.0))
    """
    from gearwright.spec.studies import Bound

    found = re.fullmatch(r"\s*([\w.\-]+)\s*(<=|>=)\s*([-+0-9.eE]+)\s*", text)
    limit = _value(found[3]) if found else ""
    if found is None or not isinstance(limit, int | float):
        raise DesignError([Problem("--keep", f"{text!r} is no bound; write RESULT>=NUMBER or RESULT<=NUMBER")])
    side = "minimum" if found[2] == ">=" else "maximum"
    return found[1], Bound.model_validate({side: limit})


# ----------------------------------------------------------------------------------------------------------------------
# Find, read and size the design that a command names.
# ----------------------------------------------------------------------------------------------------------------------


def design_of(name: str, folder: Path | None = None) -> Design:
    """Return a design from a file, or a shipped one by its name.

    Args:
        name: Path or name.
        folder: Of the study that names it; left out: the path may lead anywhere.
    """
    from gearwright.shipped import find_design
    from gearwright.spec import read

    return read(find_design(name, folder))


def sized(name: str, level: str | None = None, life_h: float | None = None) -> Sizing:
    """Return the sizing of a design; what sizing finds wrong is placed at its line in the file.

    Args:
        name: Path or name of the design.
        level: At which it is sized; None: its own.
        life_h: Life that is asked of gears and bearings [h]; None: its own.

    Raises:
        DesignError: If the design cannot be read or sized.
    """
    from gearwright import at_level, edited, size

    design = design_of(name)
    with placed_in(name):
        design = design if level is None else at_level(design, level)
        lives = {} if life_h is None else dict.fromkeys(("service.life_h", "service.bearing_life_h"), life_h)
        return size(edited(design, lives) if lives else design)


def reviewed(sizing: Sizing, name: str, speeds: Sequence[SpeedCase] | None = None) -> Review:
    """Return the review of a sizing; a waiver of no check is placed at its line in the design's file.

    Args:
        sizing: Of the design.
        name: Path or name of the design.
        speeds: Its critical speeds, where they are known already.

    Raises:
        DesignError: If a waiver names no check.
    """
    from gearwright.reviews import review_of

    with placed_in(name):
        return review_of(sizing, speeds=speeds)


def stamped(name: str, date: str = "") -> Stamp:
    """Return what a page says of where it comes from.

    Args:
        name: Path or name of the design whose lines it shows.
        date: As the user writes it.
    """
    from gearwright.render.pages.page import Stamp
    from gearwright.shipped import find_design
    from gearwright.spec import file_text, key_lines

    return Stamp(date, key_lines(file_text(find_design(name))))


@contextmanager
def placed_in(name: str) -> Iterator[None]:
    """Place what is found wrong at its line in the design's file.

    Args:
        name: Path or name of the design.

    Raises:
        DesignError: What was raised inside, with lines.
    """
    from gearwright.shipped import find_design
    from gearwright.spec import file_text, placed

    try:
        yield
    except DesignError as error:
        raise DesignError(placed(error.problems, file_text(find_design(name))), name) from None


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
