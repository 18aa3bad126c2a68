"""The command ``thesis``: the claims and errata of Pulvirenti (2023), on the terminal and as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def thesis(
    out: Annotated[Path, typer.Option(help="Page to write; .md gives Markdown, all else HTML")] = Path("thesis.html"),
    errata: Annotated[bool, typer.Option("--errata", help="Print the errata, too")] = False,
) -> None:
    """Hold the claims of the thesis behind the first sizing against what its corrected equations give."""
    from rich.console import Console

    from gearwright.catalogue.errata import errata as all_errata
    from gearwright.render.thesis_page import claims_table, errata_table, thesis_markdown, thesis_page
    from gearwright.study.claims import claims

    console = Console()
    console.print(claims_table(claims()))
    if errata:
        console.print(errata_table(all_errata()))
    page = thesis_markdown() if out.suffix == ".md" else thesis_page()
    out.write_text(page, encoding="utf-8")
    typer.echo(f"wrote {out}, with the reasons")
