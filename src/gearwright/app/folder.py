"""The design files of one folder, as the workbench reads and saves them: never outside it, never over a change."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.reading import LARGEST_TEXT, beside, text_of
from gearwright.writing import write_text

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}\.toml")
"""Names of files that are read and written."""
JOURNAL = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}\.journal")
"""Names of journals of studies."""
MOST_LISTED = 200
"""Files of the folder that the page offers [-]."""


class Kept(NamedTuple):
    """A file as it stands."""

    text: str
    tag: str
    """Digest of its text: another one says that it has changed."""


class Changed(Exception):
    """A file is not what the page believes it to be."""


def tag_of(text: str) -> str:
    """Return the digest by which a text is told from another.

    Args:
        text: Of a file.
    """
    return hashlib.sha256(text.encode()).hexdigest()


def design_files(folder: Path) -> list[str]:
    """Return the names of the TOML files of a folder that the workbench would open.

    Args:
        folder: Where designs lie.
    """
    names = sorted(path.name for path in folder.glob("*.toml") if NAME.fullmatch(path.name) and path.is_file())
    return names[:MOST_LISTED]


def journals(folder: Path) -> list[str]:
    """Return the names of the journals of studies in a folder.

    Args:
        folder: Where designs lie.
    """
    names = sorted(path.name for path in folder.glob("*.journal") if JOURNAL.fullmatch(path.name) and path.is_file())
    return names[:MOST_LISTED]


def journal_path(folder: Path, name: str) -> Path:
    """Return the path of a journal in the folder.

    Args:
        folder: Where designs lie.
        name: Without a path.

    Raises:
        DesignError: If it has no such name, or a link leads out.
    """
    if not JOURNAL.fullmatch(name):
        rule = "a name of letters, digits, points, - and _ that ends in .journal, without a path"
        raise DesignError([Problem("journal", f"this names no journal; give {rule}")])
    path = beside(name, folder, "journal")
    if path.exists() and not path.is_file():
        raise DesignError([Problem("journal", f"{name} is no regular file; name another one")])
    return path


def kept(folder: Path, name: str) -> Kept:
    """Return a file of the folder.

    Args:
        folder: Where designs lie.
        name: Without a path.

    Raises:
        DesignError: If it has no such name, is not there, is no regular file, too large, or a link leads out.
    """
    text = text_of(_path(folder, name))
    return Kept(text, tag_of(text))


def save(folder: Path, name: str, text: str, known: str) -> str:
    """Write a file of the folder whole or not at all; return its new tag.

    Args:
        folder: Where designs lie.
        name: Without a path.
        text: All of it.
        known: Tag of the file that the page has read; empty where it believes that there is none.

    Raises:
        Changed: If the file on the disk is another one.
        DesignError: If no file of this name can be there.
    """
    path = _path(folder, name)
    if len(text.encode()) > LARGEST_TEXT:
        raise DesignError([Problem("", f"the text has more than {LARGEST_TEXT:,} bytes, the most that is read")], name)
    there = kept(folder, name).tag if path.exists() else ""
    if there != known:
        raise Changed(
            f"{name} has changed on the disk; open it again, or save under another name"
            if there and known
            else f"{name} is there already; open it first, or save under another name"
            if there
            else f"{name} is no longer there; save it as a new file"
        )
    write_text(path, text)
    return tag_of(text)


def _path(folder: Path, name: str) -> Path:
    if not NAME.fullmatch(name):
        rule = "a name of letters, digits, points, - and _ that ends in .toml, without a path"
        raise DesignError([Problem("name", f"this names no design file; give {rule}")])
    return beside(name, folder, "name")
