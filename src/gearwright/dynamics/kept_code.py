"""Files of compiled code, kept between runs where they can be trusted.

A folder of the user's own holds one file for each function and kind of arguments, and one for each structure. Its
name says what the code was compiled from and for: gearwright's sources, numba, llvmlite, Python, the processor. A file
is read only if it belongs to the user and its checksum is right, since what it holds is executed; all else is compiled
again, in memory where nowhere can be written.
"""

from __future__ import annotations

import os
import shutil
import stat
import sys
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path

from gearwright.base import GearwrightError
from gearwright.files import make_folder, write_bytes
from gearwright.version import __version__, digest

VARIABLE = "GEARWRIGHT_CACHE_DIR"
"""Environment variable that names another folder for the cache."""
KEPT = 16
"""Versions whose code is kept, some 2 MB each and what structures take: the latest."""
STRUCTURES = 256
"""Structures whose code is kept, some 50 kB each: the latest."""
COMPILING = "compiling the steps of this kind of system: some ten seconds the first time, then they are kept"
"""What is said before code is compiled for more than a second."""
_HEAD = b"gearwright code 1\n"


def kept_code(key: str) -> bytes | None:
    """Return the machine code that was kept of an assembly; none if it is not there, or not to be trusted.

    Args:
        key: The assembly, and for what it is compiled.
    """
    path = _structure(key)
    return None if path is None else read_code(path)


def keep_code(key: str, code: bytes) -> None:
    """Keep the machine code of an assembly; a full disk keeps nothing.

    Args:
        key: As for `kept_code`.
        code: An object file.
    """
    path = _structure(key)
    if path is None:
        return
    write_code(path, code)
    with suppress(OSError):  # another process may be at it, too
        known = sorted(path.parent.glob("structure-*"), key=lambda file: file.lstat().st_mtime, reverse=True)
        for old in known[STRUCTURES:]:
            old.unlink()


def _structure(key: str) -> Path | None:
    home = folder()
    return None if home is None else home / f"structure-{sha256(key.encode()).hexdigest()[:32]}"


def write_code(path: Path, content: bytes) -> None:
    """Write a file whole or not at all; a full disk keeps nothing.

    Args:
        path: In `folder`.
        content: Code.
    """
    with suppress(GearwrightError):
        write_bytes(path, _HEAD + sha256(content).digest() + content)


@cache
def folder() -> Path | None:
    """Return the folder of this version's code, made if it is not there; none where none is private to the user."""
    try:
        home = _home() / f"code-{_stamp()}"
        if not home.exists():
            make_folder(home.parent)
            make_folder(home, mode=stat.S_IRWXU)
            _forget(home.parent)
        status = home.lstat()
    except (OSError, RuntimeError, GearwrightError):  # RuntimeError: no home
        return None
    private = os.name == "nt" or not status.st_mode & (stat.S_IRWXG | stat.S_IRWXO)
    return home if stat.S_ISDIR(status.st_mode) and private and _is_own(status) else None


def _home() -> Path:
    """Return the folder of the cache, as XDG and Windows have it."""
    if named := os.environ.get(VARIABLE):
        return Path(named).absolute()
    base = Path(os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", ""))
    return (base if base.is_absolute() else Path.home() / ".cache") / "gearwright"


@cache
def _stamp() -> str:
    """Return what tells this version's code from any other's: its sources, what compiles them, and for which Python."""
    package = Path(__file__).parents[1]
    sources = [digest(package / layer) for layer in ("dynamics", "machines")]
    parts = [__version__, *sources, *map(version, ("numba", "llvmlite", "numpy")), sys.version]
    return sha256("\n".join(parts).encode()).hexdigest()[:16]


def _forget(folders: Path) -> None:
    """Remove the code of all but the latest versions."""
    for old in sorted(folders.glob("code-*"), key=lambda path: path.lstat().st_mtime, reverse=True)[KEPT:]:
        shutil.rmtree(old, ignore_errors=True)


def read_code(path: Path) -> bytes | None:
    """Return what a file holds if it is the user's own and whole, none otherwise.

    Args:
        path: In `folder`.
    """
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(descriptor, "rb") as file:
            status = os.fstat(descriptor)
            text = file.read() if stat.S_ISREG(status.st_mode) and _is_own(status) else b""
    except OSError:
        return None
    head, content = text[: len(_HEAD) + 32], text[len(_HEAD) + 32 :]
    return content if head == _HEAD + sha256(content).digest() else None


def _is_own(status: os.stat_result) -> bool:
    """Tell whether a file belongs to the user; Windows keeps a user's folders to the user by itself."""
    return not hasattr(os, "geteuid") or status.st_uid == os.geteuid()
