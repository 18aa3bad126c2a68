"""The command ``colibri``: every number of the EC120B term project computed, its mistakes in red."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.options import JsonOption
from gearwright.cli.output import show, show_json, tell
from gearwright.writing import write_text


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
    import json as notation

    from gearwright.replays.colibri.page import colibri_markdown, colibri_page
    from gearwright.replays.colibri.replay import replay
    from gearwright.replays.colibri.words import chosen, counts_text, findings_table, replay_record, replay_tables

    found = replay()
    numbers = chosen(found, part=part or "", wrong=wrong)
    if json:
        show_json(notation.dumps(replay_record(numbers, found), indent=2, ensure_ascii=False, allow_nan=False))
    else:
        findings = [findings_table(found.findings)] if part is None else []
        show(replay_tables(numbers, found), *findings, counts_text(found))
    if out is not None:
        write_text(out, colibri_markdown() if out.suffix == ".md" else colibri_page())
        (tell if json else show)(f"wrote {out}")
