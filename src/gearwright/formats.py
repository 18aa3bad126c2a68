"""Every file that a sizing is written as: format -> its bytes, and in words what was written.

What a format needs loads when it is asked for. The verbs that make the bytes live in `shape`, `render`, `store` and
`exchange`; this is the one list of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Literal, NamedTuple

if TYPE_CHECKING:
    from gearwright.sizing import Sizing


class Wanted(NamedTuple):
    """How a file is wanted, by those formats that have a choice."""

    detail: Literal["fine", "coarse"] = "fine"
    case: str | None = None
    step: float | None = None
    mission: str | None = None
    window: str | None = None
    table: str | None = None


AS_USUAL = Wanted()
"""Without a choice."""


def ending(name: str) -> str:
    """Return how the name of a file of a format ends.

    Args:
        name: Of the format, a key of `FORMATS`.

    >>> ending("fmu-3.0"), ending("netcdf")
    ('fmu', 'nc')
    """
    return _ENDINGS.get(name, name.partition("-")[0])


def _glb(sizing: Sizing, wanted: Wanted) -> tuple[bytes, str]:
    from gearwright.shape import glb, scene

    built = scene(sizing, detail=wanted.detail)
    content = glb(built)
    triangles = sum(len(built.surfaces[node.surface].triangles) for node in built.nodes)
    return content, f"{len(built.nodes)} bodies, {triangles} triangles, {len(content) / 1e6:.2f} MB"


def _html(sizing: Sizing, wanted: Wanted) -> tuple[bytes, str]:
    from gearwright.particulars import particulars
    from gearwright.render.pages.motion import turning
    from gearwright.shape import glb, scene

    built = scene(sizing, detail=wanted.detail)
    content = turning(particulars(sizing), built, glb(built)).encode()
    return content, f"{len(content) / 1e6:.2f} MB, opens in a browser and loads nothing"


def _step(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.exchange.step import to_step

    file = to_step(sizing)
    return file.content, f"STEP AP214, {file.bodies} bodies of {file.solids} solids, {len(file.content) / 1e6:.1f} MB"


def _rexs(
    sizing: Sizing,
    _: Wanted,
    *,
    version: Literal["1.7", "1.6"] = "1.7",
    form: Literal["rexs", "rexsj", "rexsz"] = "rexs",
) -> tuple[bytes, str]:
    from gearwright.exchange import to_rexs

    file = to_rexs(sizing, version=version, form=form)
    words = f"REXS {version}, {file.components} components; not in it:"
    return file.content, "\n  ".join((words, *file.left_out))


def _json(sizing: Sizing, _: Wanted) -> tuple[bytes, str]:
    from gearwright.store import text_of_value

    return text_of_value(sizing).encode(), "the sizing; gw.load reads it"


def _fmu(sizing: Sizing, wanted: Wanted, *, version: Literal["2.0", "3.0"]) -> tuple[bytes, str]:
    from gearwright.exchange import fmu_of_window, to_fmu

    if wanted.mission is None or wanted.window is None:
        file = to_fmu(sizing, wanted.case, version=version, step=wanted.step)
    else:
        from gearwright.mission import fly
        from gearwright.mission.windows import begun_window
        from gearwright.shipped import find_mission
        from gearwright.spec import read_mission

        path = find_mission(wanted.mission)
        mission, folder = read_mission(path), path.parent
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


def _sheet(sizing: Sizing, _: Wanted, *, form: Literal["svg", "dxf"]) -> tuple[bytes, str]:
    from gearwright.render.drawings.catalogue import sheets
    from gearwright.render.drawings.writers import sheet_dxf, sheet_svg
    from gearwright.shape import scene

    (drawn,) = sheets(sizing, ["arrangement"], solids=scene(sizing, detail="coarse"))
    words = "the general arrangement; gearwright draw writes every sheet"
    return (sheet_svg if form == "svg" else sheet_dxf)(drawn).encode(), words


_ENDINGS = {"netcdf": "nc"}
"""Format -> end of the name of its file, where that is another."""
FORMATS: Mapping[str, Callable[[Sizing, Wanted], tuple[bytes, str]]] = {
    "glb": _glb,
    "html": _html,
    "step": _step,
    "json": _json,
    "rexs": partial(_rexs, version="1.7", form="rexs"),
    "rexs-1.6": partial(_rexs, version="1.6", form="rexs"),
    "rexsj": partial(_rexs, version="1.7", form="rexsj"),
    "rexsz": partial(_rexs, version="1.7", form="rexsz"),
    "fmu": partial(_fmu, version="2.0"),
    "fmu-3.0": partial(_fmu, version="3.0"),
    "xlsx": _xlsx,
    "csv": _csv,
    "parquet": _parquet,
    "netcdf": _netcdf,
    "svg": partial(_sheet, form="svg"),
    "dxf": partial(_sheet, form="dxf"),
}
"""Name -> what it holds, and in words what was written."""
