"""Notebooks that come with gearwright, as notebook files that have not been run."""

import json
from pathlib import Path
from typing import overload

from gearwright.errors import DesignError, Problem
from gearwright.files import write_bytes
from gearwright.shipped import shipped_notebook, shipped_notebooks
from gearwright.verbs import verb


@overload
def notebook() -> dict[str, str]: ...


@overload
def notebook(name: str, file: Path | str | None = None, *, replace: bool = False) -> Path: ...


@verb
def notebook(
    name: str | None = None, file: Path | str | None = None, *, replace: bool = False
) -> dict[str, str] | Path:
    """Write a notebook that comes with gearwright as a file for Jupyter and its like, or tell which there are.

    Args:
        name: Such as ``a-first-architecture``; left out: names and titles of all are returned.
        file: To write; left out: NAME.ipynb in the working folder. It is returned.
        replace: Also a file that is there.

    Raises:
        DesignError: If there is none of this name, with the nearest one; if the file is there already or cannot be.
    """
    if name is None:
        return {known: notebook_title(shipped_notebook(known)) for known in shipped_notebooks()}
    source = shipped_notebook(name)
    target = Path(f"{name}.ipynb" if file is None else file)
    if target.exists() and not replace:
        message = "the file is there already; give another name, or replace=True to replace it"
        raise DesignError([Problem("", message)], str(target))
    write_bytes(target, source.read_bytes())
    return target


def notebook_title(path: Path) -> str:
    """Return the heading of a notebook.

    Args:
        path: Of the notebook file; its first cell begins with the heading.
    """
    first = json.loads(path.read_text(encoding="utf-8"))["cells"][0]
    return str(first["source"][0]).removeprefix("# ").strip()
