"""Compiled code, kept between runs where it can be trusted.

A folder of the user's own holds one file for each function and kind of arguments. Its name says what the code was
compiled from and for: gearwright's sources, numba, llvmlite, Python, the processor. A file is read only if it belongs
to the user and its checksum is right, since what it holds is executed; all else is compiled again, in memory where
nowhere can be written.
"""

from __future__ import annotations

import os
import pickle
import shutil
import stat
import sys
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

from numba import njit
from numba.core import sigutils
from numba.core.ccallback import CFunc
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from gearwright.errors import GearwrightError
from gearwright.version import __version__, digest
from gearwright.writing import make_folder, write_bytes

VARIABLE = "GEARWRIGHT_CACHE_DIR"
"""Environment variable that names another folder for the cache."""
KEPT = 16
"""Versions whose code is kept, some 2 MB each: the latest."""
_HEAD = b"gearwright code 1\n"

Given = ParamSpec("Given")
Result = TypeVar("Result")


def compiled(function: Callable[Given, Result]) -> Callable[Given, Result]:
    """Return a function that is compiled for its arguments when it is first called, or taken from the cache.

    Args:
        function: In the part of Python that numba compiles.
    """
    dispatcher: Any = njit(error_model="numpy")(function)
    dispatcher._cache = CodeCache(function)
    return dispatcher  # type: ignore[no-any-return]


def compiled_callback(signature: Any) -> Callable[[Callable[..., Any]], Any]:
    """Return what compiles a function for calls through a pointer, or takes it from the cache.

    Args:
        signature: numba's, of the function.
    """

    def made(function: Callable[..., Any]) -> Any:
        kinds = sigutils.normalize_signature(signature)  # type: ignore[no-untyped-call]
        callback: Any = CFunc(function, kinds, locals={}, options={"error_model": "numpy"})
        callback._cache = CodeCache(function)
        callback.compile()
        return callback

    return made


class CodeCache:
    """What numba asks before it compiles a function, and gives what it has compiled."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.name = f"{function.__module__}.{function.__qualname__}"

    @property
    def cache_path(self) -> str:
        """Where code is kept; empty for nowhere."""
        return str(folder() or "")

    def load_overload(self, signature: Any, target: Any) -> Any:
        """Return the code for arguments; none if it is not there, or not to be trusted.

        Args:
            signature: Kinds of the arguments.
            target: What numba compiles for.
        """
        target.refresh()
        path = self._path(signature, target.codegen())
        content = None if path is None else _verified(path)
        if content is None:
            return None
        return CompileResult._rebuild(target, *pickle.loads(content))  # type: ignore[no-untyped-call]

    def save_overload(self, signature: Any, result: Any) -> None:
        """Keep what has been compiled; code with addresses of this process in it, and a full disk, keep nothing.

        Args:
            signature: Kinds of the arguments.
            result: numba's, compiled.
        """
        path = self._path(signature, result.codegen)
        if path is None or result.lifted or result.library.has_dynamic_globals:
            return
        content: bytes = dumps(result._reduce())  # type: ignore[no-untyped-call]
        with suppress(GearwrightError):
            write_bytes(path, _HEAD + sha256(content).digest() + content)

    def _path(self, signature: Any, codegen: Any) -> Path | None:
        home = folder()
        key = sha256(repr((self.name, str(signature), codegen.magic_tuple())).encode()).hexdigest()
        return None if home is None else home / f"{self.name.rpartition('.')[2]}-{key[:32]}"


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
    known = sorted(folders.glob("code-*"), key=lambda path: path.lstat().st_mtime, reverse=True)
    for old in known[KEPT:]:
        shutil.rmtree(old, ignore_errors=True)


def _verified(path: Path) -> bytes | None:
    """Return what a file holds if it is the user's own and whole, none otherwise."""
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
