"""Runs the notebooks and makes a page of each, with what every cell prints and shows: python docs/gallery.py FOLDER.

The documentation's build makes the same pages; nothing of them is kept.
"""

from __future__ import annotations

import ast
import contextlib
import io
import json
import os
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

NOTEBOOKS = Path(__file__).parents[1] / "src" / "gearwright" / "shipped" / "notebooks"


@dataclass(frozen=True)
class Cell:
    """A cell of a notebook, run."""

    is_code: bool
    source: str
    printed: str = ""
    value: Any = None
    """What it ends with; None of one that ends with nothing to show."""


def cells(text: str) -> Iterator[Cell]:
    """Yield the cells of a notebook file, not yet run."""
    for cell in json.loads(text)["cells"]:
        yield Cell(is_code=cell["cell_type"] == "code", source="".join(cell["source"]))


def run(cell: Cell, names: dict[str, Any]) -> Cell:
    """Run a cell, as a notebook does."""
    tree, printed = ast.parse(cell.source), io.StringIO()
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    return Cell(is_code=True, source=cell.source, printed=printed.getvalue(), value=value)


def executed(notebook: Path) -> list[Cell]:
    """Run a notebook from top to bottom in an empty folder."""
    names: dict[str, Any] = {"__name__": "__main__"}
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            return [run(cell, names) if cell.is_code else cell for cell in cells(notebook.read_text(encoding="utf-8"))]
        finally:
            os.chdir(before)


def page(notebook: Path, cells: list[Cell]) -> tuple[str, list[str]]:
    """Return the page of a notebook in Markdown, with marks for what is shown as HTML, and that HTML."""
    parts, shown = list[str](), list[str]()
    for cell in cells:
        parts.append(f"```python\n{cell.source}\n```" if cell.is_code else cell.source)
        if cell.printed:
            parts.append(f"```text\n{cell.printed.rstrip()}\n```")
        if hasattr(cell.value, "_repr_html_"):
            parts.append(mark(len(shown)))
            shown.append(f'<div class="shown">{cell.value._repr_html_()}</div>')
        elif cell.value is not None:
            parts.append(f"```text\n{cell.value!r}\n```")
    parts.append(f"`gearwright new {notebook.stem}` writes this notebook as a file; the page is its run.")
    return "\n\n".join(parts) + "\n", shown


def mark(place: int) -> str:
    """Return what stands in a page for what a cell shows."""
    return f"⟦shown {place}⟧"


def main() -> None:
    """Write every page with its figures as HTML into a folder."""
    folder = Path(sys.argv[1])
    for notebook in sorted(NOTEBOOKS.glob("*.ipynb")):
        text, shown = page(notebook, executed(notebook))
        for place, html in enumerate(shown):
            text = text.replace(mark(place), html)
        (folder / f"{notebook.stem}.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
