"""What commands write beside words: figures, and a bar of progress."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from gearwright.writing import write_bytes, write_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def write_figure(drawn: Figure, path: Path) -> None:
    """Write a figure in the form that its name asks for.

    Args:
        drawn: The figure.
        path: Of the file, ``*.svg`` or ``*.png``.

    Raises:
        DesignError: If the name ends otherwise.
    """
    from gearwright.errors import DesignError, Problem
    from gearwright.render.style.theme import to_png, to_svg

    match path.suffix:
        case ".svg":
            write_text(path, to_svg(drawn))
        case ".png":
            write_bytes(path, to_png(drawn))
        case other:
            raise DesignError([Problem("--figure", f"{other!r} is not drawn; end the name with .svg or .png")])


@contextmanager
def progress(what: str) -> Iterator[Callable[[float], None]]:
    """Show a bar on a terminal; stay silent elsewhere.

    Args:
        what: Is being done.
    """
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task(what, total=1.0)
        yield lambda done: bar.update(task, completed=done)
