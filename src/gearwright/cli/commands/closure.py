"""The command ``close``: a design becomes a gearbox that meets what its checks know, written out.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.designs import design_of, placed_in
from gearwright.cli.options import DesignArgument, JsonOption
from gearwright.cli.terminal.output import show, tell


def close(
    design: DesignArgument,
    life_h: Annotated[
        float | None, typer.Option(help="Life of gears and bearings; left out: as the design says", min=0.0)
    ] = None,
    continuous: Annotated[
        bool, typer.Option("--continuous", help="Modules and widths as they come, neither standard nor whole")
    ] = False,
    crossings: Annotated[
        bool, typer.Option("--crossings", help="Keep the lightest teeth, and list the critical speeds that they cross")
    ] = False,
    out: Annotated[Path | None, typer.Option(help="Write the closed design to this file")] = None,
    json: JsonOption = False,
) -> None:
    """Choose every free size so that a design meets all that is checked; what is not met ends with exit code 1."""
    from gearwright.closure import Outcome, Wishes
    from gearwright.closure import close as closed_by
    from gearwright.closure.wishes import HOUR
    from gearwright.render.answers.closure import close_answer
    from gearwright.render.words.review import closure_text
    from gearwright.spec.text import design_text
    from gearwright.writing import write_text

    life = None if life_h is None else life_h * HOUR
    wishes = Wishes(life=life, rounded=not continuous, separate=not crossings)
    with placed_in(design):
        closed = closed_by(design_of(design), wishes=wishes, tell=_quiet if json else tell)
    if json:
        show_answer("close", close_answer(closed), design=closed.design.name)
    else:
        show(closure_text(closed))
    if out is not None:
        write_text(out, design_text(closed.design))
        tell(f"wrote {out}")
    if closed.outcome is Outcome.OPEN:
        raise typer.Exit(1)


def _quiet(_: str) -> None:
    """Say nothing beside the answer."""
