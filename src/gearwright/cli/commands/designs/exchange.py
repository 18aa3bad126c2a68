"""Command import: a gearbox of another tool as a design."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.terminal.output import show, tell
from gearwright.writing import write_text

if TYPE_CHECKING:
    from gearwright.exchange import ImportedRexs


def import_(
    file: Annotated[Path, typer.Argument(help="A file of REXS 1.0 to 1.7: .rexs, .rexsj or .rexsz", metavar="FILE")],
    out: Annotated[Path | None, typer.Option("--out", help="Design file; left out: NAME.toml here")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that is there")] = False,
) -> None:
    """Read a gearbox of another tool, in REXS, and write it as a design; say what was assumed and what was not read."""
    from gearwright.errors import Problem, refuse
    from gearwright.exchange import from_rexs
    from gearwright.spec import design_text

    read = from_rexs(file)
    target = out or Path(f"{file.stem}.toml")
    if target.exists() and not force:
        refuse([Problem("--out", "the file is there already; name another, or replace it with --force")], str(target))
    write_text(target, design_text(read.design))
    show(f"wrote {target}: REXS {read.version} of {read.application}; next: gearwright check {target}")
    for title, lines in (("assumed", read.assumed), ("not read", read.not_read), ("stated", _stated(read))):
        if lines:
            tell(f"{title}:")
        for line in lines:
            tell(f"  {line}")


def _stated(read: ImportedRexs) -> tuple[str, ...]:
    """Return the safeties that a file states in words, each beside what comes out here."""
    from gearwright.errors import GearwrightError
    from gearwright.sizing import size

    if not read.stated:
        return ()
    try:
        sizing = size(read.design)
    except GearwrightError as error:  # the design is written, and `check` says the same
        return (f"{len(read.stated)} safeties, beside which none stands here: {error}",)
    words = []
    for stated in read.stated:
        ours = stated.ours(sizing)
        here = "not rated by ISO here" if ours is None else f"{ours:.3f} here"
        words.append(
            f"{stated.gear} with {stated.mate}: {stated.symbol} {stated.value:.3f} by {stated.standard}, {here}"
        )
    return tuple(words)


import_.__name__ = "import"
