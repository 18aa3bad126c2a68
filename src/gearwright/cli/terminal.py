"""Standard output and standard error: encoding, words, tables, JSON, progress, and sections of `--help`.

It knows no command, no design and no result; what is said is made by `render`.
"""

from __future__ import annotations

import os
import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from typer import BadParameter
from typer.core import TyperGroup

from gearwright.cli.streams import clean_json
from gearwright.errors import DesignError, Problem
from gearwright.files import write_bytes, write_text

if TYPE_CHECKING:
    from rich.console import RenderableType

    from gearwright.cli.screen import Screen
    from gearwright.render.style import Drawing


# ----------------------------------------------------------------------------------------------------------------------
# What commands print and write: words, tables, JSON, figures, and a bar of progress.
#
# All that is printed goes through here: cleaned of control characters, in the letters that the stream knows, folded
# between words on a terminal and not at all elsewhere.
# ----------------------------------------------------------------------------------------------------------------------


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
    from gearwright.cli.screen import Screen

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
    from gearwright.render.style import to_png, to_svg

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


# ----------------------------------------------------------------------------------------------------------------------
# The list of commands that ``--help`` shows: in sections, every summary whole.
#
# Typer's own list cuts each summary to one line and loads rich's Markdown, which takes longer than all the rest.
# ----------------------------------------------------------------------------------------------------------------------


class Sections(TyperGroup):
    """A group of commands listed under their headings, which typer calls panels."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the list.

        Args:
            ctx: Of the call.
            formatter: Writes the help.
        """
        listed = defaultdict[str, list[tuple[str, str]]](list)
        for name, command in self.commands.items():
            if not command.hidden:
                title = getattr(command, "rich_help_panel", None)
                listed[title if isinstance(title, str) else "Commands"].append((name, _summary(command.help or "")))
        for title, rows in listed.items():
            with formatter.section(title):
                formatter.write_dl(rows)

    def invoke(self, ctx: Any) -> Any:
        """Call the command; what is wrong with an option is said without the words of the library that found it.

        Args:
            ctx: Of the call.
        """
        try:
            return super().invoke(ctx)
        except BadParameter as error:
            error.message = error.message.removeprefix("Value error, ")
            raise


def _summary(help_text: str) -> str:
    """Return the first sentence of a command's help.

    >>> _summary("Size a design: teeth, masses.")
    'Size a design: teeth, masses'
    """
    return help_text.partition("\n\n")[0].replace("\n", " ").strip().removesuffix(".")
