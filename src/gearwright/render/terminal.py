"""Tables on a terminal: no word is broken and no number cut, however narrow it is.

Prose is folded between words; columns without room stand in a block below, beside the names of the rows again.
"""

from collections.abc import Sequence

from rich.box import SIMPLE_HEAD
from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, JustifyMethod, RenderableType, RenderResult
from rich.table import Table
from rich.text import Text

PROSE = 20
"""Width that a column of prose keeps while another column can go into a block below [characters]."""
GAP = 2
"""Between columns [characters]."""


class Grid:
    """A table of words that fits what it is printed on."""

    def __init__(
        self, title: str = "", *, caption: str = "", names: int = 1, show_header: bool = True, spaced: bool = False
    ) -> None:
        self.title = title
        self.caption = caption
        """What stands below it."""
        self.names = names
        """Leading columns that name a row: they stand in every block."""
        self.spaced = spaced
        """Whether an empty line stands between rows."""
        self.table = Table(show_header=show_header)
        """What is in it."""

    def add_column(self, header: str, *, justify: JustifyMethod = "left", no_wrap: bool = False) -> None:
        """Add a column; one that is not wrapped is never narrower than its cells."""
        self.table.add_column(header, justify=justify, no_wrap=no_wrap)

    def add_row(self, *cells: str | Text, style: str = "") -> None:
        """Add a row; cells that are left out are empty."""
        self.table.add_row(*cells, style=style)

    def add_section(self) -> None:
        """Set off what follows."""
        self.table.add_section()

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Yield title, blocks and caption, each folded between words alone."""
        for number, columns in enumerate(self._blocks(options.max_width)):
            if self.title:
                yield Text(f"{self.title}, continued" if number else self.title, style="bold")
            widths = self._widths(columns, options.max_width)
            yield from self._block(columns, widths).__rich_console__(console, options.update(width=_total(widths)))
        if self.caption:
            yield Text(self.caption, style="dim")

    def _blocks(self, width: int) -> list[list[int]]:
        """Return the columns of every block."""
        least = [self._least(k) for k in range(len(self.table.columns))]
        names = list(range(min(self.names, len(least))))
        blocks = [names]
        for k in range(len(names), len(least)):
            if _total([least[column] for column in (*blocks[-1], k)]) > width and len(blocks[-1]) > len(names):
                blocks.append([*names])
            blocks[-1] = [*blocks[-1], k]
        return blocks

    def _widths(self, columns: Sequence[int], width: int) -> list[int]:
        """Return the width of every column: as it likes, the widest ones cut to what is there, no word broken."""
        widths, words = [self._natural(k) for k in columns], [self._longest_word(k) for k in columns]
        for most in range(max(widths, default=0), 0, -1):
            if _total(widths) <= width:
                break
            widths = [max(min(current, most), word) for current, word in zip(widths, words, strict=True)]
        return widths

    def _least(self, k: int) -> int:
        return max(self._longest_word(k), min(self._natural(k), PROSE))

    def _natural(self, k: int) -> int:
        return max((cell_len(line) for text in self._texts(k) for line in text.split("\n")), default=0)

    def _longest_word(self, k: int) -> int:
        if self.table.columns[k].no_wrap:
            return self._natural(k)
        return max((cell_len(word) for text in self._texts(k) for word in text.split()), default=0)

    def _texts(self, k: int) -> list[str]:
        head = [self.table.columns[k].header] if self.table.show_header else []
        return [str(cell) for cell in (*head, *self.table.columns[k].cells)]

    def _block(self, columns: Sequence[int], widths: Sequence[int]) -> Table:
        block = Table(box=SIMPLE_HEAD, pad_edge=False, padding=(0, 1, 0, 0), show_lines=self.spaced,
                      show_header=self.table.show_header)  # fmt: skip
        for k, width in zip(columns, widths, strict=True):
            column = self.table.columns[k]
            block.add_column(
                column.header, justify=column.justify, width=width, no_wrap=column.no_wrap, overflow="fold"
            )
        cells = zip(*(self.table.columns[k].cells for k in columns), strict=True)
        for row, texts in zip(self.table.rows, cells, strict=True):
            block.add_row(*map(_plain, texts), style=row.style, end_section=row.end_section)
        return block


def _plain(cell: RenderableType) -> RenderableType:
    """Return a cell in which brackets are brackets."""
    return Text(cell) if isinstance(cell, str) else cell


def _total(widths: Sequence[int]) -> int:
    return sum(widths) + GAP * len(widths) + 1
