"""Command export: a sized design as a file that other tools open."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

import typer

from gearwright.cli.ends import named_after
from gearwright.cli.options import DesignArgument
from gearwright.cli.terminal.output import show
from gearwright.formats import FORMATS, Wanted, ending
from gearwright.writing import write_bytes


def export(
    design: DesignArgument,
    to: Annotated[
        str,
        typer.Option(
            "--to",
            help="glb: solids that turn; html: a page on which they do; step: solids for CAD;"
            " rexs, rexs-1.6, rexsj, rexsz: REXS; fmu, fmu-3.0: FMI; xlsx, csv, parquet, netcdf: every table;"
            " svg, dxf: the general arrangement;"
            " json: the sizing",
        ),
    ],
    file: Annotated[Path | None, typer.Option("--out", help="File; left out: NAME-gearbox.FORMAT here")] = None,
    detail: Annotated[
        Literal["fine", "coarse"] | None, typer.Option(help="Of the solids of glb and html; left out: fine")
    ] = None,
    case: Annotated[str | None, typer.Option(help="Load case of fmu; left out: the governing one")] = None,
    step: Annotated[
        float | None, typer.Option("--step", help="Of fmu's integration [s]; left out: that of simulate")
    ] = None,
    mission: Annotated[str | None, typer.Option(help="Mission whose window is the fmu, with its drives")] = None,
    window: Annotated[str | None, typer.Option(help="Window of that mission")] = None,
    table: Annotated[str | None, typer.Option(help="Of csv: one table alone, such as gears; left out: all")] = None,
) -> None:
    """Export a sized design: solids as GLB or STEP, a page on which it turns, REXS, its dynamics as FMU, JSON."""
    from gearwright.cli.designs import placed_in, sized

    _refuse_unknown(to)
    given = {"--detail": detail, "--case": case, "--step": step, "--mission": mission, "--window": window}
    given |= {"--table": table}
    _refuse_unused(to, given)
    _refuse_other_ending(to, file)
    sizing = sized(design)
    with placed_in(design):
        content, words = FORMATS[to](sizing, Wanted(detail or "fine", case, step, mission, window, table))
    path = file or named_after(design, f"gearbox.{ending(to)}")
    write_bytes(path, content)
    show(f"wrote {path}: {words}")


def _refuse_unknown(name: str) -> None:
    from gearwright.errors import Problem, near, refuse

    if name not in FORMATS:
        refuse([Problem("--to", f"{name!r} is not written; {near(name, list(FORMATS))}")])


def _refuse_other_ending(name: str, file: Path | None) -> None:
    """Refuse a name that ends as files of another format do: what opens it would not know it."""
    from gearwright.errors import Problem, refuse

    given = "" if file is None else file.suffix.removeprefix(".").lower()
    if given != ending(name) and given in map(ending, FORMATS):
        refuse([Problem("--out", f"{str(file)!r} ends as {given} does; write .{ending(name)}, or --to {given}")])


def _refuse_unused(name: str, given: Mapping[str, object]) -> None:
    from gearwright.errors import Problem, refuse

    takers = {option: _TAKERS.get(option, ("fmu", "fmu-3.0")) for option in given}
    unused = [option for option, value in given.items() if value is not None and name not in takers[option]]
    refuse(Problem(option, f"it is of {' and '.join(takers[option])}; leave it out with {name}") for option in unused)
    fix = "--mission and --window belong together, and a case is none of them"
    named = [option for option in ("--case", "--mission", "--window") if given[option] is not None]
    if named not in ([], ["--case"], ["--mission", "--window"]):
        refuse([Problem(", ".join(named), f"{fix}; give both, or --case, or neither")])


_TAKERS = {"--detail": ("glb", "html"), "--table": ("csv",)}
"""Option -> formats that have it; all others are of FMUs."""
