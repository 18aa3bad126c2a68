"""The data files that come with the catalogue, as text or as rows."""

from __future__ import annotations

import csv
from importlib.resources import files


def data_text(name: str) -> str:
    """Return the text of a data file.

    Args:
        name: Of the file in the folder ``data``.
    """
    return files("gearwright.catalogue").joinpath(f"data/{name}").read_text(encoding="utf-8")


def data_rows(name: str) -> list[dict[str, str]]:
    """Return the rows of a CSV data file, cells by column.

    Args:
        name: Of the file in the folder ``data``.
    """
    return list(csv.DictReader(data_text(name).splitlines()))
