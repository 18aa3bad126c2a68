"""Arguments and options that several commands take, each written once."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.completion import designs, missions

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

    from gearwright.errors import DesignError, Problem, install

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
    from gearwright.errors import DesignError, Problem

    try:
        first, last, step = (float(part) for part in text.split(":"))
        count = (last - first) / step
        if not 0.0 < count < 1e6:
            raise ValueError(text)
    except (ValueError, ZeroDivisionError):
        message = f"{text!r} is not first:last:step with a step towards the last, such as 0:4:0.1"
        raise DesignError([Problem(f"--{option}", message)]) from None
    return [round(first + k * step, 9) for k in range(math.floor(count + 1e-9) + 1)]
