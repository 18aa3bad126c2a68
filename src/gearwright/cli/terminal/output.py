"""What commands print and write: words, tables, JSON, figures, and a bar of progress.

All that is printed goes through here: cleaned of control characters, in the letters that the stream knows, folded
between words on a terminal and not at all elsewhere.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from gearwright.cli.terminal.streams import clean_json
from gearwright.writing import write_bytes, write_text

if TYPE_CHECKING:
    from rich.console import RenderableType

    from gearwright.cli.terminal.screen import Screen
    from gearwright.render.style.theme import Drawing

UNFOLDED = 100_000
"""Width of what is no terminal: no line is folded there [characters]."""
STANDARD_OUTPUT = "standard output"
"""Its name in messages."""


def show(*what: RenderableType) -> None:
    """Print words and tables on standard output.

    Raises:
        OSError: If they cannot be written: the message names standard output.
    """
    console = screen()
    with _named():
        for thing in what:
            console.print(thing, crop=False)


def show_commands(lines: str) -> None:
    """Print lines that are copied into a shell: not folded, so that the terminal keeps them whole."""
    console = screen()
    with _named():
        console.print(lines, crop=False, no_wrap=True, overflow="ignore")


def show_json(text: str) -> None:
    """Print a JSON text on standard output; it stays JSON in every encoding."""
    with _named():
        print(clean_json(text, sys.stdout.encoding or "utf-8"), flush=True)  # noqa: T201


def tell(words: str) -> None:
    """Print what is no result on standard error: what was written, what is wrong. A stream that is full loses it."""
    with suppress(OSError):
        screen(error=True).print(words, crop=False)


def screen(*, error: bool = False) -> Screen:
    """Return the console of one of the streams."""
    from gearwright.cli.terminal.screen import Screen

    stream = sys.stderr if error else sys.stdout
    return Screen(file=stream, width=_width(error=error), markup=False, emoji=False, highlight=False)


def _width(*, error: bool) -> int:
    """Return the width to fold to: of COLUMNS for results, else of the terminal, else none."""
    stream = sys.stderr if error else sys.stdout
    asked = os.environ.get("COLUMNS", "")
    if asked.isdigit() and int(asked) and not error:
        return int(asked)
    if not stream.isatty():
        return UNFOLDED
    try:
        return os.get_terminal_size(stream.fileno()).columns or 80
    except OSError:
        return 80


@contextmanager
def _named() -> Iterator[None]:
    """Let an error of standard output say whose it is."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, STANDARD_OUTPUT) from None


def write_figure(drawn: Drawing, path: Path) -> None:
    """Write a figure in the form that its name asks for.

    Args:
        drawn: The figure.
        path: Of the file, ``*.svg`` or ``*.png``.

    Raises:
        DesignError: If the name ends otherwise, or PNG is asked for and matplotlib is not installed.
    """
    from gearwright.errors import DesignError, Problem
    from gearwright.render.style.theme import to_png, to_svg

    match path.suffix:
        case ".svg":
            write_text(path, to_svg(drawn))
        case ".png":
            write_bytes(path, to_png(drawn))
        case suffix:
            raise DesignError([Problem("--figure", f"{suffix!r} is not drawn; end the name with .svg or .png")])


@contextmanager
def progress(what: str) -> Iterator[Callable[[float], None]]:
    """Show a bar on a terminal; stay silent elsewhere.

    Args:
        what: Is being done.
    """
    from rich.progress import Progress

    with Progress(console=screen(error=True), transient=True, disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task(what, total=1.0)
        yield lambda done: bar.update(task, completed=done)
