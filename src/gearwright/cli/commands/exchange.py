"""Commands `import`, `export` and `draw`: files of other tools, and technical drawings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.answers import named_after
from gearwright.cli.options import DateOption, DesignArgument, ReportOption, designs
from gearwright.cli.terminal import show, tell
from gearwright.errors import GearwrightError, Problem, near, refuse
from gearwright.files import make_folder, write_bytes, write_text
from gearwright.formats import FORMATS, Wanted, ending

if TYPE_CHECKING:
    from gearwright.exchange import ImportedRexs
    from gearwright.render.drawings.paper import Sheet
    from gearwright.sizing import Sizing


# ----------------------------------------------------------------------------------------------------------------------
# Command import: a gearbox of another tool as a design.
# ----------------------------------------------------------------------------------------------------------------------


def import_(
    file: Annotated[Path, typer.Argument(help="A file of REXS 1.0 to 1.7: .rexs, .rexsj or .rexsz", metavar="FILE")],
    out: Annotated[Path | None, typer.Option("--out", help="Design file; left out: NAME.toml here")] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace a file that is there")] = False,
) -> None:
    """Read a gearbox of another tool, in REXS, and write it as a design; say what was assumed and what was not read."""
    from gearwright import design_text, from_rexs

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


# ----------------------------------------------------------------------------------------------------------------------
# Command export: a sized design as a file that other tools open.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.cli.options import placed_in, sized

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
    if name not in FORMATS:
        refuse([Problem("--to", f"{name!r} is not written; {near(name, list(FORMATS))}")])


def _refuse_other_ending(name: str, file: Path | None) -> None:
    """Refuse a name that ends as files of another format do: what opens it would not know it."""
    given = "" if file is None else file.suffix.removeprefix(".").lower()
    if given != ending(name) and given in map(ending, FORMATS):
        refuse([Problem("--out", f"{str(file)!r} ends as {given} does; write .{ending(name)}, or --to {given}")])


def _refuse_unused(name: str, given: Mapping[str, object]) -> None:
    takers = {option: _TAKERS.get(option, ("fmu", "fmu-3.0")) for option in given}
    unused = [option for option, value in given.items() if value is not None and name not in takers[option]]
    refuse(Problem(option, f"it is of {' and '.join(takers[option])}; leave it out with {name}") for option in unused)
    fix = "--mission and --window belong together, and a case is none of them"
    named = [option for option in ("--case", "--mission", "--window") if given[option] is not None]
    if named not in ([], ["--case"], ["--mission", "--window"]):
        refuse([Problem(", ".join(named), f"{fix}; give both, or --case, or neither")])


_TAKERS = {"--detail": ("glb", "html"), "--table": ("csv",)}
"""Option -> formats that have it; all others are of FMUs."""


# ----------------------------------------------------------------------------------------------------------------------
# Command draw: technical drawings of a design's parts.
# ----------------------------------------------------------------------------------------------------------------------


SHEET_FORMATS = ("svg", "dxf")


def draw(
    design: Annotated[
        str,
        typer.Argument(
            help="Design file, name of a shipped design, or a run (*.nc)", metavar="DESIGN", autocompletion=designs
        ),
    ],
    folder: Annotated[Path | None, typer.Option("--out", help="Folder; left out: NAME-drawings here")] = None,
    what: Annotated[
        str | None,
        typer.Option(
            help="Sheets by name, or all of a kind (shaft, gear, carrier, housing), with commas; left out: all"
        ),
    ] = None,
    formats: Annotated[str, typer.Option("--format", help="svg, dxf or both, with a comma")] = "svg,dxf",
    report: ReportOption = None,
    date: DateOption = "",
) -> None:
    """Draw the general arrangement, shafts, gears, carriers and the housing as sheets to ISO conventions."""
    from gearwright.render.drawings.catalogue import sheets
    from gearwright.render.drawings.paper import scale_text
    from gearwright.shape import scene

    wanted = _formats(formats)
    sizing = _sized(design)
    drawn = sheets(sizing, _names(what), solids=scene(sizing, detail="coarse"))
    # Everything is drawn before anything is written: what cannot be drawn leaves no half of it.
    texts = {f"{sheet.name}.{suffix}": _text(sheet, suffix) for sheet in drawn for suffix in wanted}
    page = "" if report is None else _page(sizing, drawn, date)
    folder = folder or named_after(design, "drawings")
    make_folder(folder)
    for name, text in texts.items():
        write_text(folder / name, text)
    for sheet in drawn:
        show(f"{sheet.name:32} {sheet.size.name}  {scale_text(sheet.scale)}")
    show(f"wrote {len(drawn)} sheets as {' and '.join(wanted)} to {folder}")
    if report is not None:
        write_text(report, page)
        tell(f"wrote {report}")


def _page(sizing: Sizing, drawn: Sequence[Sheet], date: str) -> str:
    """Return all sheets on one page."""
    from gearwright.particulars import particulars
    from gearwright.render.drawings.paper import scale_text
    from gearwright.render.drawings.writers import sheet_svg
    from gearwright.render.pages.page import Stamp
    from gearwright.render.pages.report import DrawnSheet, sheets_page

    rows = [
        DrawnSheet(sheet.name, sheet.name, sheet.size.name, scale_text(sheet.scale), sheet_svg(sheet, f"{sheet.name}-"))
        for sheet in drawn
    ]
    return sheets_page(particulars(sizing), rows, stamp=Stamp(date))


def _sized(name: str) -> Sizing:
    """Return the sizing of a design, or of the design that a run belongs to."""
    from gearwright.cli.options import sized
    from gearwright.sizing import size
    from gearwright.store import load_run

    return size(load_run(Path(name)).design) if Path(name).suffix == ".nc" else sized(name)


def _names(what: str | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in what.split(",")) if what else ()


def _formats(written: str) -> tuple[str, ...]:
    formats = tuple(dict.fromkeys(name.strip() for name in written.split(",")))
    wrong = [name for name in formats if name not in SHEET_FORMATS]
    allowed = f"allowed: {', '.join(sorted(SHEET_FORMATS))}; browsers print svg to PDF"
    refuse(Problem("--format", f"{name!r} is not drawn; {allowed}") for name in wrong)
    if "dxf" in formats and find_spec("ezdxf") is None and len(formats) > 1:
        tell("DXF is not written: it needs the package ezdxf, which is not here; pip install ezdxf")
        return tuple(name for name in formats if name != "dxf")
    return formats


def _text(sheet: Sheet, suffix: str) -> str:
    from gearwright.render.drawings.writers import sheet_dxf, sheet_svg

    return sheet_svg(sheet) if suffix == "svg" else sheet_dxf(sheet)
