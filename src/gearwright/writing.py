"""Write files whole or not at all: beside the place, onto the disk, then in one step into the place.

A full disk, a killed process or Ctrl-C leaves what was there before, or nothing; never half a file. What cannot be
replaced, a pipe or a device, is written straight.
"""

from __future__ import annotations

import errno
import os
import secrets
import shutil
from contextlib import suppress
from pathlib import Path

from gearwright.errors import DesignError, GearwrightError, Problem, SolveError

_STREAMS = (Path("/dev"), Path("/dev/fd"))
"""Folders whose files are streams, also where a shell has put a plain file behind one."""
_FULL = frozenset({errno.ENOSPC, errno.EFBIG, errno.EIO, getattr(errno, "EDQUOT", errno.ENOSPC)})
"""What goes wrong with the disk; all else is wrong with the name."""
_NEW = 0o666
"""Permissions of a new file, less what the user's mask takes away."""


def write_text(path: Path, text: str) -> None:
    """Write a text as UTF-8; see `write_bytes`.

    Args:
        path: Of the file.
        text: All of it.
    """
    write_bytes(path, text.encode())


def write_bytes(path: Path, content: bytes | memoryview) -> None:
    """Write a file; one that is there is replaced when the new one is complete and on the disk.

    Args:
        path: Of the file.
        content: All of it.

    Raises:
        DesignError: If no file can be there.
        SolveError: If the disk does not take it; a file that was there is as it was.
    """
    try:
        if path.exists() and (path.parent in _STREAMS or not path.is_file()):
            with path.open("wb") as stream:
                stream.write(content)
        else:
            _replace(path.resolve(), content)
    except OSError as error:
        raise _refusal(path, len(content), error) from None


def make_folder(path: Path, *, mode: int = 0o777) -> None:
    """Make a folder and those above it, where they are not there yet.

    Args:
        path: Of the folder.
        mode: Its permissions, less what the user's mask takes away.

    Raises:
        DesignError: If no folder can be there.
        SolveError: If the disk does not take it.
    """
    try:
        path.mkdir(mode, parents=True, exist_ok=True)
    except OSError as error:
        raise _refusal(path, 0, error) from None


def _replace(final: Path, content: bytes | memoryview) -> None:
    """Write beside and move into place; a file that is there lends its permissions."""
    partial = final.with_name(f".{secrets.token_hex(8)}.part")
    try:
        with os.fdopen(os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, _NEW), "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        if final.exists():
            shutil.copymode(final, partial)
        partial.replace(final)
    except BaseException:
        with suppress(OSError):
            partial.unlink(missing_ok=True)
        raise


def _refusal(path: Path, size: int, error: OSError) -> GearwrightError:
    """Return what to say of a file that could not be written: the place, what went wrong, what is needed."""
    if error.errno in _FULL:
        needs = f"it needs {size / 1e6:.3g} MB" + (_left(path) if error.errno == errno.ENOSPC else "")
        return SolveError(
            f"{path} cannot be written: {error.strerror}; {needs}. What was there is as it was:"
            " free some space, or name another place"
        )
    message = f"it cannot be written: {error.strerror}; name a file in a folder that is there and may be written"
    return DesignError([Problem("", message)], str(path))


def _left(path: Path) -> str:
    try:
        return f", {shutil.disk_usage(path.resolve().parent).free / 1e6:.3g} MB are free"
    except OSError:
        return ""
