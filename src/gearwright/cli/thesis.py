"""The command ``thesis``: the claims and errata of Pulvirenti (2023), on the terminal and as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.output import show, write_figure
from gearwright.writing import make_folder, write_bytes, write_text

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
        _chapter(chapter_4, figures)
        return
    from gearwright.replays.pulvirenti.claims import claims
    from gearwright.replays.pulvirenti.errata import errata as all_errata
    from gearwright.replays.pulvirenti.page import claims_table, errata_table, thesis_markdown, thesis_page

    show(claims_table(claims()), *([errata_table(all_errata())] if errata else []))
    page = thesis_markdown() if out.suffix == ".md" else thesis_page()
    write_text(out, page)
    show(f"wrote {out}, with the reasons")


def _chapter(page: Path, figures: Path | None) -> None:
    """Write the page of chapter 4 with a figure for each window beside it, and all counterparts into a folder."""
    from gearwright.render.style.theme import to_png
    from gearwright.replays.pulvirenti.flight_claims import chapter_runs, flight_claims
    from gearwright.replays.pulvirenti.flight_page import FIGURES, PANELS, chapter_figure, chapter_markdown
    from gearwright.replays.pulvirenti.flight_phases import phased

    runs = chapter_runs()
    images = {window: f"{page.stem}-{window}.png" for window in PANELS}
    for window, name in images.items():
        write_bytes(page.with_name(name), to_png(chapter_figure(runs, window, PANELS[window]), PAGE_RESOLUTION))
    write_text(page, chapter_markdown(flight_claims(runs), phased(runs), images))
    show(f"wrote {page} and {len(images)} figures beside it")
    if figures is not None:
        make_folder(figures)
        for number, (window, panel) in FIGURES.items():
            write_figure(chapter_figure(runs, window, (panel,)), figures / f"{number}.svg")
        show(f"wrote {len(FIGURES)} figures to {figures}")
