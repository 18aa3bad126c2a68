"""Command draw: technical drawings of a design's parts."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearwright.cli.completion import designs
from gearwright.cli.ends import named_after
from gearwright.cli.options import DateOption, ReportOption
from gearwright.cli.terminal.output import show, tell
from gearwright.writing import make_folder, write_text

if TYPE_CHECKING:
    from gearwright.render.drawings.sheet.sheets import Sheet
    from gearwright.sizing import Sizing

FORMATS = ("svg", "dxf")


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
    from gearwright.render.drawings.sheet.sheets import scale_text

    wanted = _formats(formats)
    sizing = _sized(design)
    drawn = sheets(sizing, _names(what))
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
    from gearwright.render.drawings.sheet.sheets import scale_text
    from gearwright.render.drawings.sheet.svg import sheet_svg
    from gearwright.render.pages.designs.sheets import DrawnSheet, sheets_page
    from gearwright.render.pages.page import Stamp

    rows = [
        DrawnSheet(sheet.name, sheet.name, sheet.size.name, scale_text(sheet.scale), sheet_svg(sheet, f"{sheet.name}-"))
        for sheet in drawn
    ]
    return sheets_page(sizing, rows, stamp=Stamp(date))


def _sized(name: str) -> Sizing:
    """Return the sizing of a design, or of the design that a run belongs to."""
    from gearwright.cli.designs import sized
    from gearwright.sizing import size
    from gearwright.store import load_run

    return size(load_run(Path(name)).design) if Path(name).suffix == ".nc" else sized(name)


def _names(what: str | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in what.split(",")) if what else ()


def _formats(written: str) -> tuple[str, ...]:
    from gearwright.errors import Problem, refuse

    formats = tuple(dict.fromkeys(name.strip() for name in written.split(",")))
    wrong = [name for name in formats if name not in FORMATS]
    allowed = f"allowed: {', '.join(sorted(FORMATS))}; browsers print svg to PDF"
    refuse(Problem("--format", f"{name!r} is not drawn; {allowed}") for name in wrong)
    if "dxf" in formats and find_spec("ezdxf") is None and len(formats) > 1:
        tell("DXF is not written: it needs the package ezdxf, which is not here; pip install ezdxf")
        return tuple(name for name in formats if name != "dxf")
    return formats


def _text(sheet: Sheet, suffix: str) -> str:
    from gearwright.render.drawings.sheet.dxf import sheet_dxf
    from gearwright.render.drawings.sheet.svg import sheet_svg

    return sheet_svg(sheet) if suffix == "svg" else sheet_dxf(sheet)
