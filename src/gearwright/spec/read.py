"""Read a design file: TOML to `Design`, with every problem of the file at once."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import cast

from gearwright.errors import DesignError, Problem
from gearwright.spec.check import reference_problems
from gearwright.spec.design import Design
from gearwright.spec.lines import key_lines, line_of
from gearwright.spec.record import build

LARGEST_FILE = 1_000_000
"""Largest design file that is read [bytes]; the shipped ones have about a thousand."""


def read(path: str | Path) -> Design:
    """Return the design that a file describes.

    Args:
        path: A TOML file.

    Raises:
        DesignError: With every problem of the file: its path, line, what was given, what is allowed and the fix.
    """
    return parse(_text(Path(path)), source=str(path))


def parse(text: str, *, source: str = "") -> Design:
    """Return the design that a TOML text describes.

    Args:
        text: The file's content.
        source: Name of the file, for messages.

    Raises:
        DesignError: As `read`.
    """
    if not text.strip():
        raise DesignError(
            [Problem("", "the file is empty; `gearwright new` writes a complete one to start from")], source
        )
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise DesignError(
            [Problem("", f"this is not TOML: {error}; a line reads  key = value  or  [table]")], source
        ) from None
    record, written = build(Design, raw)
    problems = list(written.problems)
    if record is not None:
        problems += reference_problems(cast(Design, record))
    if problems:
        lines = key_lines(text)
        placed = [Problem(each.path, each.message, line_of(each.path, lines)) for each in problems]
        raise DesignError(sorted(placed, key=lambda each: (each.line or 0, each.path)), source)
    return cast(Design, record)


def _text(path: Path) -> str:
    """Return the file's text, or say why there is none to be had."""
    name = str(path)
    if path.is_dir():
        raise DesignError([Problem("", "this is a folder; name a design file in it, such as design.toml")], name)
    try:
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise DesignError(
                [Problem("", f"the file has {size:,} bytes; a design file has at most {LARGEST_FILE:,}")], name
            )
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise DesignError(
            [Problem("", "there is no such file; `gearwright new` lists the designs to start from")], name
        ) from None
    except UnicodeDecodeError:
        raise DesignError([Problem("", "this is not a text file in UTF-8; a design file is TOML")], name) from None
    except OSError as error:
        raise DesignError([Problem("", f"the file cannot be read: {error.strerror}")], name) from None
