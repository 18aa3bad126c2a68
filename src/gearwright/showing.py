"""Values show themselves: a few lines at a prompt, tables and a figure in a notebook.

Only `render` words and draws, and it stands above the values: what asks for it here finds it by name when it is asked,
so that no layer depends on it and none loads it before.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from importlib import import_module
from typing import Any

from gearwright.errors import DesignError, Problem, install


class Shown:
    """A value that people look at."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(import_module("gearwright.render.pages.notebook").short(self))

    def _repr_html_(self) -> str:
        return str(import_module("gearwright.render.pages.notebook").html(self))


def extra(package: str) -> Any:
    """Return a package that only an extra of the same name brings.

    Args:
        package: ``pandas`` or ``xarray``.

    Raises:
        DesignError: If it is not installed; with how to get it.
    """
    try:
        return import_module(package)
    except ModuleNotFoundError:
        message = f"this needs {package}, which is not here; {install(package)}"
        raise DesignError([Problem("", message)]) from None


def frame(columns: Mapping[str, tuple[Iterable[Any], str]], index: str) -> Any:
    """Return columns as a pandas ``DataFrame`` whose ``attrs["units"]`` says the unit of each.

    Args:
        columns: Name -> values and unit.
        index: Column that names the rows; empty: they are counted.

    Raises:
        DesignError: If pandas is not installed.
    """
    made = extra("pandas").DataFrame({name: values for name, (values, _) in columns.items()})
    made = made.set_index(index) if index else made
    made.attrs["units"] = {name: unit for name, (_, unit) in columns.items()}
    return made
