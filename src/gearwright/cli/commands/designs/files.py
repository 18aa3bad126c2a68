"""The commands ``new`` and ``schema``: files to start from, and what editors and scripts need to know of files."""

from __future__ import annotations

import json as json_text
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from gearwright.cli.answers import ANSWERS, answer_schema, show_answer
from gearwright.cli.completion import shipped
from gearwright.cli.options import JsonOption
from gearwright.cli.terminal.output import show, show_json
from gearwright.writing import write_bytes, write_text


class File(StrEnum):
    """Files that users write."""

    DESIGN = "design"
    MISSION = "mission"
    MIX = "mix"
    STUDY = "study"


def new(
    name: Annotated[
        str | None,
        typer.Argument(
            help="A shipped design, mission, mix, study or notebook; left out: list them",
            autocompletion=shipped,
        ),
    ] = None,
    file: Annotated[
        Path | None, typer.Argument(help="File to write; left out: NAME.toml here, of a notebook NAME.ipynb")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that is there")] = False,
    json: JsonOption = False,
) -> None:
    """Write a shipped design, mission, mix, study or notebook as a file to start from, or list all of them."""
    from gearwright.errors import DesignError, Problem
    from gearwright.shipped import shipped_file

    if name is None:
        _list(json=json)
        return
    source = shipped_file(name)
    target = file or Path(source.name)
    if target.exists() and not force:
        raise DesignError(
            [Problem("", "the file is there already; give another name, or --force to replace it")], str(target)
        )
    if source.parent.name == "notebooks":
        write_bytes(target, source.read_bytes())
        show(f"wrote {target}; next: jupyter lab {target}, or any editor of notebooks")
        return
    _write_headed(source, target)


def _write_headed(source: Path, target: Path) -> None:
    """Write a shipped file under a line that names its schema, and the schema beside it; say what follows."""
    kind = {"designs": File.DESIGN, "missions": File.MISSION, "mixes": File.MIX, "studies": File.STUDY}[
        source.parent.name
    ]
    beside = target.with_name(f"gearwright-{kind.value}.schema.json")
    write_text(target, f"#:schema ./{beside.name}\n{source.read_text(encoding='utf-8')}")
    write_text(beside, _schema_text(kind))
    follows = {"designs": "run", "missions": "fly DESIGN", "mixes": "mix DESIGN", "studies": "study"}[
        source.parent.name
    ]
    show(f"wrote {target}; next: gearwright {follows} {target}")


def _schema_text(kind: File) -> str:
    """Return the schema of a file, which lies beside it so that editors find it without a network."""
    from gearwright.spec import schema as file_schema

    return json_text.dumps(file_schema(kind.value), indent=1, ensure_ascii=False) + "\n"


def _list(*, json: bool) -> None:
    """Print every shipped file with its name, under what it is."""
    from gearwright.render.answers.weights import NewAnswer
    from gearwright.render.words.shipped import shipped_files

    files = shipped_files()
    if json:
        show_answer("new", NewAnswer(files))
        return
    width = max(len(file.name) for file in files)
    for kind, title in (
        ("design", "designs"),
        ("mission", "\nmissions"),
        ("mix", "\nmixes"),
        ("study", "\nstudies"),
        ("notebook", "\nnotebooks"),
    ):
        show(title)
        for file in files:
            if file.kind == kind:
                show(f"{file.name:{width}} {file.title}")


def schema(
    of: Annotated[File, typer.Option(help="File whose keys it describes, for editors")] = File.DESIGN,
    answer: Annotated[
        str | None, typer.Option(help="Command whose JSON it describes instead, such as size", metavar="COMMAND")
    ] = None,
) -> None:
    """Print the JSON Schema of a design, mission, mix or study file, or of what a command prints with --json."""
    from gearwright.errors import DesignError, Problem, near
    from gearwright.spec import schema as file_schema

    if answer is not None and answer not in ANSWERS:
        raise DesignError([Problem("--answer", f"{answer!r} prints no JSON; {near(answer, ANSWERS)}")])
    made = file_schema(of.value) if answer is None else answer_schema(answer)
    show_json(json_text.dumps(made, indent=2, ensure_ascii=False))
