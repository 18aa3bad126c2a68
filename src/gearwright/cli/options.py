"""Arguments and options that several commands take, each written once."""

from __future__ import annotations

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
CaseOption = Annotated[str | None, typer.Option(help="Load case; left out: the design's first one, or 'rated'")]
DateOption = Annotated[str, typer.Option("--date", help="Date for the head of the page; left out: none")]
FigureOption = Annotated[Path | None, typer.Option(help="Write the figure (.svg or .png)")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print one JSON object for machines, and write no files")]
LinesOption = Annotated[
    bool, typer.Option("--jsonl", help="Print JSON Lines: the answer without its rows, then a line for every row")
]
