"""The command ``close``, and architectures closed for one life: designs that meet what their checks know.

Imports that cost time stand inside the command, so that ``--help`` stays quick.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.answers import show_answer
from gearwright.cli.completion import missions
from gearwright.cli.designs import design_of, placed_in
from gearwright.cli.options import DesignArgument, FreeOption, JsonOption
from gearwright.cli.terminal.output import show, tell

if TYPE_CHECKING:
    from gearwright.closure import Wishes
    from gearwright.spec import Design


def close(
    design: DesignArgument,
    life_h: Annotated[
        float | None,
        typer.Option(help="Life of gears and bearings; left out: as the design says", min=0.001),
    ] = None,
    mission: Annotated[
        str | None, typer.Option(help="Mission through whose flights its gears live, too", autocompletion=missions)
    ] = None,
    continuous: Annotated[
        bool, typer.Option("--continuous", help="Modules and widths as they come, neither standard nor whole")
    ] = False,
    crossings: Annotated[
        bool, typer.Option("--crossings", help="Keep the lightest teeth, and list the critical speeds that they cross")
    ] = False,
    as_sized: Annotated[
        bool, typer.Option("--as-sized", help="Look for no lighter teeth than those that the sizing chose")
    ] = False,
    free: FreeOption = None,
    rounds: Annotated[
        bool, typer.Option("--rounds", help="Show every round; left out: the first of each kind and the last")
    ] = False,
    variants: Annotated[
        bool, typer.Option("--variants", help="Where it does not close: look for the nearest variant that does")
    ] = False,
    why: Annotated[
        bool,
        typer.Option(
            "--why", help="Tell what stands against what is not met, or against thinner rims and webs that are free"
        ),
    ] = False,
    out: Annotated[
        Path | None, typer.Option(help="Write the closed design to this file, and a variant beside it")
    ] = None,
    json: JsonOption = False,
) -> None:
    """Choose every free size so that a design meets all that is checked; what is not met ends with exit code 1."""
    from gearwright.cli.commands.flights.mission import mission_of
    from gearwright.closure import OnMission, Outcome, contradictions, nearest_variant
    from gearwright.closure import close as closed_by
    from gearwright.render.answers.closure import close_answer
    from gearwright.render.words.review import against_text, closure_text, variants_text
    from gearwright.spec.text import design_text
    from gearwright.writing import write_text

    wishes = replace(wishes_of(life_h, free), rounded=not continuous, separate=not crossings, lighten=not as_sized)
    say = _quiet if json else tell
    with placed_in(design):
        own = design_of(design)
        flights = None if mission is None else OnMission(*mission_of(mission))
        closed = closed_by(own, wishes=wishes, on_mission=flights, tell=say)
        is_open = closed.outcome is Outcome.OPEN
        against = contradictions(own, closed, tell=say) if why else ()
        found = nearest_variant(own, closed, tell=say) if variants and is_open else None
    if json:
        show_answer("close", close_answer(closed, found, against), design=closed.design.name)
    else:
        show(closure_text(closed, all_rounds=rounds))
        if why and (is_open or against):
            show(against_text(against))
        if found is not None:
            show(variants_text(found))
    written = {} if out is None else {out: closed.design}
    if out is not None and found is not None and found.nearest is not None:
        written[out.with_stem(f"{out.stem}-variant")] = found.nearest.closed.design
    for path, result in written.items():
        write_text(path, design_text(result))
        say(f"wrote {path}")
    if closed.outcome is Outcome.OPEN:
        raise typer.Exit(1)


def wishes_of(life_h: float | None, free: str | None) -> Wishes:
    """Return what a closure is asked for.

    Args:
        life_h: Of gears and bearings [h]; None: as designs say.
        free: Names of freedoms with a comma, or ``all``; None: none beside open teeth.

    Raises:
        DesignError: If there is no such freedom.
    """
    from gearwright.closure import FREEDOMS, Wishes
    from gearwright.closure.wishes import HOUR

    names = [name.strip() for name in (free or "").split(",") if name.strip()]
    every = tuple(FREEDOMS) if names == ["all"] else tuple(names)
    return Wishes(life=None if life_h is None else life_h * HOUR, free=every)


def _quiet(_: str) -> None:
    """Say nothing beside the answer."""


def show_equal_life(
    designs: Mapping[str, Design],
    wishes: Wishes,
    *,
    out: Path | None,
    csv: Path | None,
    report: Path | None,
    json: bool,
) -> None:
    """Show designs closed for one life, and write them into a folder.

    Args:
        designs: Name -> design.
        wishes: Life, and what is free.
        out: Folder, made where there is none; None: they are not written.
        csv: File for the table; None: none.
        report: File for the page; None: none.
        json: For machines.
    """
    from gearwright.closure.wishes import HOUR
    from gearwright.render.answers.closure import EqualLifeAnswer
    from gearwright.render.pages.studies.equal_life import equal_life_page
    from gearwright.render.tables.study.equal_life import equal_life_csv, equal_life_table
    from gearwright.render.words.text import table_text
    from gearwright.study import equal_life
    from gearwright.writing import make_folder, write_text

    if out is not None:
        make_folder(out)
    rows = equal_life(designs, wishes=wishes, tell=_quiet if json else tell)
    life = wishes.life or 0.0
    title = f"Closed for {life / HOUR:g} h" + (f", {', '.join(wishes.free)} free" if wishes.free else "")
    if json:
        show_answer("compare closed", EqualLifeAnswer(life, rows))
    else:
        show(table_text(equal_life_table(rows, title)))
    files = {out / f"{row.title}.toml": row.file for row in rows if row.file} if out is not None else {}
    files |= {} if csv is None else {csv: equal_life_csv(rows)}
    files |= {} if report is None else {report: equal_life_page(rows, title)}
    for path, content in files.items():
        write_text(path, content)
        tell(f"wrote {path}")
