"""Standard output and standard error: encoding, words, tables, JSON, progress, and sections of `--help`.

It knows no command, no design and no result; what is said is made by `render`.
"""

from __future__ import annotations

import codecs
import io
import os
import re
import sys
import unicodedata
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from typer import BadParameter
from typer.core import TyperGroup

from gearwright.files import write_bytes, write_text

if TYPE_CHECKING:
    from rich.console import RenderableType

    from gearwright.cli.screen import Screen
    from gearwright.render.style import Drawing


# ----------------------------------------------------------------------------------------------------------------------
# What standard output and standard error can show: the letters of their encoding, and no control characters.
#
# A stream that does not know a letter gets the nearest one it knows: σ becomes s, − becomes -, and what has no
# likeness a question mark. A control character, which could move the cursor or recolour the terminal, is shown as its
# code.
# ----------------------------------------------------------------------------------------------------------------------


CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")
"""Characters that steer a terminal or turn the direction of writing; not the tab and the line feed."""
_NOT_PLAIN = re.compile(r"[^\n\x20-\x7e]")
_NEAREST = "nearest"
_ALIKE = {
    **dict(zip("αβγδεζηθικλμνξοπρςστυφχψωΔΣΩΦΘΛΠΓΨΞ", "abgdezhqiklmnxoprsstufcywDSOFQLPGYX", strict=True)),
    **dict.fromkeys("−–—‐‑━─╸╺", "-"), **dict.fromkeys("‘’′", "'"), **dict.fromkeys("“”″„", '"'),
    "µ": "u", "·": ".", "×": "x", "✓": "v", "∞": "inf", "…": "...", "→": "->", "≤": "<=", "≥": ">=", "≈": "~",
    "±": "+/-", "√": "sqrt", "°": "deg ", "§": "sec. ", "ø": "o", "Ø": "O", "ß": "ss", "∂": "d", "•": "*",
}  # fmt: skip


def clean(words: str) -> str:
    """Return words whose control characters are shown as their codes.

    >>> clean("shaft \\x1b[31m")
    'shaft \\\\x1b[31m'
    """
    return CONTROL.sub(lambda match: ascii(match[0])[1:-1], words)


def clean_json(text: str, encoding: str) -> str:
    """Return a JSON text with everything escaped that a stream of this encoding cannot hold or a terminal obeys."""
    return _NOT_PLAIN.sub(lambda match: match[0] if _holds(match[0], encoding) else _escaped(match[0]), text)


def _holds(letter: str, encoding: str) -> bool:
    try:
        letter.encode(encoding)
    except UnicodeEncodeError:
        return False
    return not CONTROL.match(letter)


def _escaped(letter: str) -> str:
    """Return a letter as JSON escapes it, in two halves where it needs them."""
    halves = letter.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{halves[k : k + 2].hex()}" for k in range(0, len(halves), 2))


def _nearest(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_alike, error.object[error.start : error.end])), error.end


def _alike(letter: str) -> str:
    """Return ASCII for a letter that an encoding lacks."""
    plain = unicodedata.normalize("NFKD", _ALIKE.get(letter, letter)).encode("ascii", "ignore").decode()
    return _ALIKE.get(letter, plain) or "?"


def steady_streams() -> None:
    """Let both streams take every letter, and be there: a process may start without them."""
    codecs.register_error(_NEAREST, _nearest)
    # Closed at the start they are None; what is printed then goes nowhere, as with any other tool.
    sys.stdout = sys.stdout or io.StringIO()
    sys.stderr = sys.stderr or io.StringIO()
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors=_NEAREST)


def flushed() -> OSError | None:
    """Return why the last words of standard output cannot be written; Python then does not try them again."""
    try:
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return error
    return None


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
    from gearwright.errors import DesignError, Problem
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
