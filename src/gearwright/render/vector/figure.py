"""A figure: paper of a size, panels in rows and columns, words below all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from gearwright.errors import DesignError, Problem, install
from gearwright.render.vector.axes import Axes
from gearwright.render.vector.axis import Axis
from gearwright.writing import write_bytes, write_text

RESOLUTION = 160.0
"""Of PNG images [dots per inch]."""


@dataclass(frozen=True)
class Parallel:
    """Cases across parallel axes, which a page lets a reader brush."""

    names: tuple[str, ...]
    """Of the axes, with units."""
    values: np.ndarray
    """Shape (cases, axes)."""
    drawn: tuple[int, ...]
    """Places of the cases that are drawn."""
    chosen: tuple[int, ...]
    """Places of those that stand out."""


@dataclass
class Slot:
    """A panel and its place."""

    axes: Axes
    row: int
    column: int


@dataclass
class Figure:
    """What is drawn, until a writer asks for it."""

    width: float
    """Of the paper [mm]."""
    height: float
    """Of the paper [mm]."""
    slots: list[Slot] = field(default_factory=list)
    heights: list[float] = field(default_factory=lambda: [1.0])
    """Of the rows, in parts."""
    widths: list[float] = field(default_factory=lambda: [1.0])
    """Of the columns, in parts."""
    caption: str = ""
    """One line below all panels."""
    shared_key: int = 0
    """Columns of a legend below all panels, of the first one's marks; 0: none."""
    bare: bool = False
    """One panel that is the whole paper, in mm."""
    title: str = ""
    """For readers of screens; left out: the titles of the panels."""
    parallel: Parallel | None = None
    """What stands across parallel axes, where it is that."""

    @property
    def axes(self) -> list[Axes]:
        """Return the panels, row by row."""
        return [slot.axes for slot in self.slots]

    def texts(self) -> list[str]:
        """Return all that is written on it."""
        return [*(word for axes in self.axes for word in axes.texts()), *([self.caption] if self.caption else [])]

    def savefig(self, path: str | Path) -> None:
        """Write the figure as a file.

        Args:
            path: Of the file, ``*.svg`` or ``*.png``.

        Raises:
            DesignError: If the name ends otherwise, or matplotlib is not installed.
        """
        target = Path(path)
        if target.suffix == ".png":
            write_bytes(target, self.png())
        elif target.suffix == ".svg":
            write_text(target, self._repr_html_())
        else:
            message = f"{target.suffix!r} is not drawn; end the name with .svg or .png"
            raise DesignError([Problem("path", message)], "figure")

    def png(self, resolution: float = RESOLUTION) -> bytes:
        """Return it as a PNG image.

        Args:
            resolution: [dots per inch].

        Raises:
            DesignError: If matplotlib is not installed; with how to get it.
        """
        try:
            from gearwright.render.vector.pixels import to_png
        except ModuleNotFoundError:
            message = f"PNG needs matplotlib, which is not here; {install('png')}, or end the name with .svg"
            raise DesignError([Problem("path", message)], "figure") from None
        return to_png(self, resolution)

    def _repr_html_(self) -> str:
        """Return the figure as a notebook shows it."""
        from gearwright.render.vector.svg import svg_text

        return svg_text(self)

    def panel(self) -> Axes:
        """Add the only panel and return it."""
        axes: Axes = self.grid(1, 1)[0, 0]
        return axes

    def grid(
        self, rows: int, columns: int, *, heights: Sequence[float] = (), widths: Sequence[float] = (),
        share_x: bool = False, share_y: str = "",
    ) -> np.ndarray:  # fmt: skip
        """Add panels in rows and columns and return them, shape (rows, columns).

        Args:
            rows: How many.
            columns: How many.
            heights: Of the rows, in parts.
            widths: Of the columns, in parts.
            share_x: One scale along x for all, its numbers below the last row.
            share_y: ``all`` or ``row``: one scale along y, its numbers at the first column.
        """
        self.heights, self.widths = list(heights) or [1.0] * rows, list(widths) or [1.0] * columns
        panels = np.array([[Axes() for _ in range(columns)] for _ in range(rows)], dtype=object).reshape(rows, columns)
        self.slots = [Slot(panels[row, column], row, column) for row in range(rows) for column in range(columns)]
        if share_x:
            _marry([axes.x for axes in panels.flat])
            for axes in panels[:-1].flat:
                axes.x.numbers = False
        for group in [panels.flat] if share_y == "all" else panels if share_y == "row" else []:
            _marry([axes.y for axes in group])
        if share_y:
            for axes in panels[:, 1:].flat:
                axes.y.numbers = False
        return panels


def _marry(axes: list[Axis]) -> None:
    for axis in axes:
        axis.mates = axes
