"""Command export: a sized design as a file that other tools open."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

import typer

from gearwright.cli.ends import named_after
from gearwright.cli.options import DesignArgument
from gearwright.cli.terminal.output import show
from gearwright.writing import write_bytes

if TYPE_CHECKING:
    from gearwright.sizing import Sizing


class Wanted(NamedTuple):
    """How a file is wanted, by those formats that have a choice."""

    detail: Literal["fine", "coarse"]
    case: str | None
    step: float | None
    mission: str | None
    window: str | None
    table: str | None


def export(
    design: DesignArgument,
    to: Annotated[
        str,
        typer.Option(
            "--to",
            help="glb: solids that turn; html: a page on which they do; step: solids for CAD; rexs, rexs-1.6: REXS;"
            " fmu, fmu-3.0: FMI; xlsx, csv, parquet, netcdf: every table; svg, dxf: the general arrangement;"
            " json: the sizing",
        ),
    ],
    file: Annotated[Path | None, typer.Option("--out", help="File; left out: NAME-gearbox.FORMAT here")] = None,
    detail: Annotated[
        Literal["fine", "coarse"] | None, typer.Option(help="Of the solids of glb and html; left out: fine")
    ] = None,
    case: Annotated[str | None, typer.Option(help="Load case of fmu; left out: the design's first one")] = None,
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
    sizing = sized(design)
    with placed_in(design):
        content, words = FORMATS[to](sizing, Wanted(detail or "fine", case, step, mission, window, table))
    path = file or named_after(design, f"gearbox.{_ENDINGS.get(to, to.partition('-')[0])}")
    write_bytes(path, content)
    show(f"wrote {path}: {words}")


def _refuse_unknown(name: str) -> None:
    from gearwright.errors import Problem, near, refuse

    if name not in FORMATS:
        refuse([Problem("--to", f"{name!r} is not written; {near(name, list(FORMATS))}")])


def _refuse_unused(name: str, given: Mapping[str, object]) -> None:
    from gearwright.errors import Problem, refuse

    takers = {option: _TAKERS.get(option, ("fmu", "fmu-3.0")) for option in given}
    unused = [option for option, value in given.items() if value is not None and name not in takers[option]]
    refuse(Problem(option, f"it is of {' and '.join(takers[option])}; leave it out with {name}") for option in unused)
    fix = "--mission and --window belong together, and a case is none of them"
    named = [option for option in ("--case", "--mission", "--window") if given[option] is not None]
    if named not in ([], ["--case"], ["--mission", "--window"]):
        refuse([Problem(", ".join(named), f"{fix}; give both, or --case, or neither")])


def _glb(sizing: Sizing, wanted: Wanted) -> tuple[bytes, str]:
    from gearwright.shape import glb, scene

    built = scene(sizing, detail=wanted.detail)
    content = glb(built)
    triangles = sum(len(built.surfaces[node.surface].triangles) for node in built.nodes)
    return content, f"{len(built.nodes)} bodies, {triangles} triangles, {len(content) / 1e6:.2f} MB"


def _html(sizing: Sizing, wanted: Wanted) -> tuple[bytes, str]:
    from gearwright.render.pages.turning import turning

    content = turning(sizing, detail=wanted.detail).encode()
    return content, f"{len(content) / 1e6:.2f} MB, opens in a browser and loads nothing"


def _step(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.step import to_step

    file = to_step(sizing)
    return file.content, f"STEP AP214, {file.bodies} bodies of {file.solids} solids, {len(file.content) / 1e6:.1f} MB"


def _rexs(sizing: Sizing, _: Wanted, *, version: Literal["1.7", "1.6"]) -> tuple[bytes, str]:
    from gearwright.exchange import to_rexs

    file = to_rexs(sizing, version=version)
    words = f"REXS {version}, {file.components} components; not in it:"
    return file.content, "\n  ".join((words, *file.left_out))


def _json(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.store import text_of_value

    content = text_of_value(sizing).encode()
    return content, "the sizing; gw.load reads it"


def _fmu(sizing: Sizing, wanted: Wanted, *, version: Literal["2.0", "3.0"]) -> tuple[bytes, str]:
    from gearwright.exchange import fmu_of_window, to_fmu

    if wanted.mission is None or wanted.window is None:
        file = to_fmu(sizing, wanted.case, version=version, step=wanted.step)
    else:
        from gearwright.cli.commands.mission import mission_of
        from gearwright.mission import fly
        from gearwright.mission.windows import begun_window

        mission, folder = mission_of(wanted.mission)
        file = fmu_of_window(
            begun_window(fly(sizing, mission, folder=folder), wanted.window), version=version, step=wanted.step
        )
    held = f"binary for {file.platform} and sources" if file.platform else f"sources only, as {file.missing}"
    variables = f"{len(file.ports)} variables, steps of {file.step:.3g} s"
    return file.content, f"FMI {file.version} co-simulation, {variables}, {len(file.content) / 1e3:.0f} kB: {held}"


def _xlsx(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.tables import to_xlsx

    content = to_xlsx(sizing)
    return content, f"every table, a sheet each, with units and sources, {len(content) / 1e3:.0f} kB"


def _csv(sizing: Sizing, wanted: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.tables import table_csv, to_csv

    if wanted.table is not None:
        text = table_csv(sizing, wanted.table)
        return text.encode("utf-8-sig"), f"the table {wanted.table}, {text.count(chr(10)) - 1} rows"

    text = to_csv(sizing)
    words = f"{text.count(chr(10)) - 1} values of every table, a line each with unit and source"
    return text.encode("utf-8-sig"), words


def _parquet(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.tables import to_parquet

    content = to_parquet(sizing)
    return content, f"every value of every table, a row each with unit and source, {len(content) / 1e3:.0f} kB"


def _netcdf(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.tables import to_netcdf

    content = to_netcdf(sizing)
    return content, f"every table, a group each with its rows as coordinate, {len(content) / 1e3:.0f} kB"


def _svg(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.render.drawings.catalogue import sheets
    from gearwright.render.drawings.sheet.svg import sheet_svg

    return sheet_svg(sheets(sizing, ["arrangement"])[0]).encode(), _DRAWN


def _dxf(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.render.drawings.catalogue import sheets
    from gearwright.render.drawings.sheet.dxf import sheet_dxf

    return sheet_dxf(sheets(sizing, ["arrangement"])[0]).encode(), _DRAWN


_ENDINGS = {"netcdf": "nc"}
"""Format -> end of the name of its file, where that is another."""
_TAKERS = {"--detail": ("glb", "html"), "--table": ("csv",)}
"""Option -> formats that have it; all others are of FMUs."""
_DRAWN = "the general arrangement; gearwright draw writes every sheet"
FORMATS: Mapping[str, Callable[[Sizing, Wanted], tuple[bytes, str]]] = {
    "glb": _glb,
    "html": _html,
    "step": _step,
    "json": _json,
    "rexs": partial(_rexs, version="1.7"),
    "rexs-1.6": partial(_rexs, version="1.6"),
    "fmu": partial(_fmu, version="2.0"),
    "fmu-3.0": partial(_fmu, version="3.0"),
    "xlsx": _xlsx,
    "csv": _csv,
    "parquet": _parquet,
    "netcdf": _netcdf,
    "svg": _svg,
    "dxf": _dxf,
}
"""Name -> what it holds, and in words what was written."""
