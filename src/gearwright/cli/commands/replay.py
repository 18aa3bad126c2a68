"""The commands ``replay NAME``: published work held against what gearwright computes.

``thesis`` and ``colibri`` are older names of two of them.
"""

from collections.abc import Callable
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.answers import ended_well, show_answer
from gearwright.cli.options import JsonOption, sized
from gearwright.cli.terminal import Sections, show, tell, write_figure
from gearwright.errors import DesignError, Problem
from gearwright.files import make_folder, write_bytes, write_text

PAGE_RESOLUTION = 110.0
"""Of the figures beside the page of chapter 4: enough to read, and light [dots per inch]."""


def thesis(
    out: Annotated[Path, typer.Option(help="Page to write; .md gives Markdown, all else HTML")] = Path("thesis.html"),
    errata: Annotated[bool, typer.Option("--errata", help="Print the errata, too")] = False,
    chapter_4: Annotated[
        Path | None,
        typer.Option("--chapter-4", help="Fly chapter 4 again, and write its page (.md) and figures"),
    ] = None,
    figures: Annotated[
        Path | None, typer.Option(help="Folder for counterparts of figures 4.2 to 4.23, with --chapter-4")
    ] = None,
) -> None:
    """Hold the claims of the thesis against what its corrected equations give, or fly its chapter 4 again."""
    if chapter_4 is not None:
        for folder in (chapter_4.parent, figures or chapter_4.parent):
            make_folder(folder)  # before the minutes that it takes
        _chapter(chapter_4, figures)
        return
    if figures is not None:
        raise DesignError([Problem("--figures", "these are figures of chapter 4; give --chapter-4 PAGE.md, too")])
    from gearwright.replays.pulvirenti.claims import claims, errata as all_errata
    from gearwright.replays.pulvirenti.pages import claims_table, errata_table, thesis_markdown, thesis_page

    show(claims_table(claims()), *([errata_table(all_errata())] if errata else []))
    write_text(out, thesis_markdown() if out.suffix == ".md" else thesis_page())
    show(f"wrote {out}, with the reasons")


def _chapter(page: Path, figures: Path | None) -> None:
    """Write the page of chapter 4 with a figure for each window beside it, and all counterparts into a folder."""
    from gearwright.render.style import to_png
    from gearwright.replays.pulvirenti.flight import (
        chapter_runs,
        departed,
        flight_claims,
        frequencies,
        printed_runs,
    )
    from gearwright.replays.pulvirenti.pages import (
        FIGURES,
        PANELS,
        SHOWN_STIFFNESS,
        STIFFNESS,
        Chapter,
        Side,
        chapter_figure,
        chapter_markdown,
    )

    tell("flying the windows as they should be, as printed, and with one departure at a time: some minutes")
    right = chapter_runs()
    printed = printed_runs(right)
    sides = (Side("as printed", printed), Side("as it should be", right))
    images = {window: f"{page.stem}-{window}.png" for window in PANELS}
    for window, name in images.items():
        figure = chapter_figure(sides, window, PANELS[window], stiffness=SHOWN_STIFFNESS[window])
        write_bytes(page.with_name(name), to_png(figure, PAGE_RESOLUTION))
    chapter = Chapter(flight_claims(printed, right), departed(right), frequencies(right), images)
    write_text(page, chapter_markdown(chapter))
    show(f"wrote {page} and {len(images)} figures beside it")
    if figures is not None:
        for number, (window, panel) in FIGURES.items():
            figure = chapter_figure(sides, window, (panel,), stiffness=STIFFNESS[number])
            write_figure(figure, figures / f"{number}.svg")
        show(f"wrote {len(FIGURES)} figures to {figures}")


class Part(StrEnum):
    """Parts of the report."""

    REQUIREMENT = "requirement"
    MATERIAL = "material"
    HELICAL_PINION = "helical-pinion"
    HELICAL_WHEEL = "helical-wheel"
    BEVEL_PINION = "bevel-pinion"
    BEVEL_WHEEL = "bevel-wheel"
    SHAFT_1 = "shaft-1"
    SHAFT_2 = "shaft-2"
    ROTOR_SHAFT = "rotor-shaft"


def colibri(
    part: Annotated[Part | None, typer.Option(help="Show one part only")] = None,
    wrong: Annotated[bool, typer.Option("--wrong", help="Show only the numbers that are wrong")] = False,
    out: Annotated[Path | None, typer.Option(help="Page to write, whole; .md gives Markdown, all else HTML")] = None,
    json: JsonOption = False,
) -> None:
    """Compute every printed number of the EC120B term project, and say which are wrong, why, and what is right."""
    from gearwright.replays.colibri.pages import colibri_markdown, colibri_page
    from gearwright.replays.colibri.replay import chosen, counts_text, findings_table, replay, replay_tables

    replayed = replay()
    numbers = chosen(replayed, part=part or "", wrong=wrong)
    if json:
        from gearwright.replays.colibri.pages import colibri_answer

        show_answer("replay colibri", colibri_answer(numbers, replayed))
    else:
        findings = [findings_table(replayed.findings)] if part is None else []
        show(replay_tables(numbers, replayed), *findings, counts_text(replayed))
    if out is not None:
        write_text(out, colibri_markdown() if out.suffix == ".md" else colibri_page())
        (tell if json else show)(f"wrote {out}")


def wang(
    design: Annotated[
        str, typer.Argument(help="A face-gear split torque: a file, or the name of a shipped design")
    ] = "face-gear-split-torque",
    out: Annotated[Path | None, typer.Option(help="Page to write, with counterparts of the paper's figures")] = None,
) -> None:
    """Hold the claims of the paper on a face-gear split torque against what gearwright computes."""
    from gearwright.dynamics.sharing import floating, sharing_problem, sharing_study
    from gearwright.render.pages.motion import sharing_page
    from gearwright.replays import paper_on
    from gearwright.replays.wang.claims import claims_table

    sizing = sized(design)
    paper = paper_on(sizing)
    if paper is None:
        message = (
            "not a face-gear split torque with a floating shaft and errors, which the paper is about;"
            " start from: gearwright new face-gear-split-torque mine.toml"
        )
        raise DesignError([Problem("pairs", message)], design)
    show(claims_table(paper.claims))
    if out is not None:
        study = sharing_study(sharing_problem(sizing))
        write_text(out, sharing_page(sizing, [study], floats=floating(sizing), paper=paper))
        show(f"wrote {out}")


COMMANDS: dict[str, Callable[..., None]] = {"pulvirenti": thesis, "colibri": colibri, "wang": wang}
"""Replay -> its command."""
replay = typer.Typer(
    name="replay", cls=Sections, help="Hold published work against what gearwright computes.", no_args_is_help=True
)
for _name, _command in COMMANDS.items():
    replay.command(_name)(ended_well(_command))
