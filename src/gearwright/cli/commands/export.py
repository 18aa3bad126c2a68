"""Command export: a sized design as a file that other tools open."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from gearwright.cli.ends import named_after
from gearwright.cli.options import DesignArgument
from gearwright.cli.terminal.output import show
from gearwright.writing import write_bytes

if TYPE_CHECKING:
    from gearwright.sizing import Sizing


def export(
    design: DesignArgument,
    to: Annotated[
        str,
        typer.Option(
            "--to", help="glb: solids that turn; html: a page on which they do; rexs, rexs-1.6: REXS; json: the sizing"
        ),
    ],
    file: Annotated[Path | None, typer.Option("--out", help="File; left out: NAME-gearbox.FORMAT here")] = None,
    detail: Annotated[Literal["fine", "coarse"], typer.Option(help="Of the solids of glb")] = "fine",
) -> None:
    """Export a sized design: solids as GLB, a page on which the gearbox turns, REXS, or the sizing as JSON."""
    from gearwright.cli.designs import sized

    _refuse_unknown(to)
    sizing = sized(design)
    content, words = FORMATS[to](sizing, detail)
    path = file or named_after(design, f"gearbox.{to.partition('-')[0]}")
    write_bytes(path, content)
    show(f"wrote {path}: {words}")


def _refuse_unknown(name: str) -> None:
    from gearwright.errors import Problem, near, refuse

    if name in ("svg", "dxf"):
        refuse([Problem("--to", f"{name!r} is a format of drawings; use gearwright draw DESIGN --format {name}")])
    if name not in FORMATS:
        refuse([Problem("--to", f"{name!r} is not written; {near(name, list(FORMATS))}")])


def _glb(sizing: Sizing, detail: Literal["fine", "coarse"]) -> tuple[bytes, str]:
    from gearwright.shape import glb, scene

    built = scene(sizing, detail=detail)
    content = glb(built)
    triangles = sum(len(built.surfaces[node.surface].triangles) for node in built.nodes)
    return content, f"{len(built.nodes)} bodies, {triangles} triangles, {len(content) / 1e6:.2f} MB"


def _html(sizing: Sizing, detail: Literal["fine", "coarse"]) -> tuple[bytes, str]:
    from gearwright.render.pages.turning import turning

    content = turning(sizing, detail=detail).encode()
    return content, f"{len(content) / 1e6:.2f} MB, opens in a browser and loads nothing"


def _rexs(sizing: Sizing, _: Literal["fine", "coarse"]) -> tuple[bytes, str]:
    return _rexs_of(sizing, "1.7")


def _rexs_16(sizing: Sizing, _: Literal["fine", "coarse"]) -> tuple[bytes, str]:
    return _rexs_of(sizing, "1.6")


def _rexs_of(sizing: Sizing, version: Literal["1.7", "1.6"]) -> tuple[bytes, str]:
    from gearwright.exchange import to_rexs

    file = to_rexs(sizing, version=version)
    words = f"REXS {version}, {file.components} components; not in it:"
    return file.content, "\n  ".join((words, *file.left_out))


def _json(sizing: Sizing, _: Literal["fine", "coarse"]) -> tuple[bytes, str]:
    from gearwright.store import text_of_value

    content = text_of_value(sizing).encode()
    return content, "the sizing; gw.load reads it"


FORMATS: Mapping[str, Callable[[Sizing, Literal["fine", "coarse"]], tuple[bytes, str]]] = {
    "glb": _glb,
    "html": _html,
    "json": _json,
    "rexs": _rexs,
    "rexs-1.6": _rexs_16,
}
"""Name -> what it holds, and in words what was written."""
