"""The console behind both streams: words are never broken, brackets and colons mean themselves, nothing steers it."""

import re
from collections.abc import Iterable

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderableType
from rich.segment import Segment
from rich.text import Text

from gearwright.cli.streams import clean

_WORD = re.compile(r"\s*\S+\s*")


class Screen(Console):
    """A console on which names are shown as they are, whatever is in them."""

    def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Iterable[Segment]:
        """Yield the pieces of words or a table: folded between words, control characters shown as their codes."""
        room = options or self.options
        if isinstance(renderable, Text) and not (renderable.no_wrap or room.no_wrap):
            renderable = folded(renderable, room.max_width)
        for segment in super().render(renderable, options):
            yield segment if segment.control else Segment(clean(segment.text), segment.style)

    def on_broken_pipe(self) -> None:
        """Let the error that rich handles be: rich would end the process with a code of its own."""
        raise


def folded(text: Text, width: int) -> Text:
    """Return a text with new lines between words where a line would be too wide; a word that is wider stands whole."""
    lines = [part for line in text.split("\n", allow_blank=True) for part in line.divide(_breaks(line.plain, width))]
    for line in lines:
        line.rstrip()
    wrapped = Text("\n").join(lines)
    wrapped.no_wrap, wrapped.justify, wrapped.end = True, text.justify, text.end
    if any(line.cell_len > width for line in lines):
        wrapped.overflow = "ignore"  # it keeps a wide word whole, and would take away the alignment of all others
    return wrapped


def _breaks(line: str, width: int) -> list[int]:
    """Return where the words begin that stand on a new line."""
    breaks, used = [], 0
    for word in _WORD.finditer(line):
        if used and used + cell_len(word[0].rstrip()) > width:
            breaks.append(word.start())
            used = 0
        used += cell_len(word[0])
    return breaks
