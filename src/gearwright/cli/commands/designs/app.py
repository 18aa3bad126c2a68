"""The command ``app``: the workbench, in a browser on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.completion import designs
from gearwright.cli.ends import CTRL_C, interrupted_code
from gearwright.cli.terminal.output import show, show_commands
from gearwright.signals import answered


def app(
    design: Annotated[
        str,
        typer.Argument(help="Design file, or the name of a shipped design", metavar="[DESIGN]", autocompletion=designs),
    ] = "in-line-h2",
    port: Annotated[int, typer.Option(help="Port of the address; 0: any that is free", min=0, max=65535)] = 0,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the address in a browser")] = True,
    folder: Annotated[
        Path | None, typer.Option(help="Folder in which designs are read and saved; left out: that of the file")
    ] = None,
) -> None:
    """Open the workbench: change a design in a browser and see its numbers, margins, power flow and solids follow."""
    from gearwright.app import serve

    def told(address: str) -> None:
        show_commands(address)
        show("the workbench answers there, to this machine alone; Ctrl-C ends it")

    try:
        serve(design, folder=folder, port=port, browser=browser, told=told)
    except KeyboardInterrupt:
        if interrupted_code() != CTRL_C:  # which is the usual end
            raise
        answered()
