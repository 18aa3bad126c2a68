"""Reading of user files with a size limit, and writing of files as a whole by replacement."""

import csv
import errno
import math
import os
import secrets
import shutil
import stat
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path, PureWindowsPath

from gearwright.errors import DesignError, GearwrightError, Problem, SolveError, excerpt

# ----------------------------------------------------------------------------------------------------------------------
# Files that a user names, read in one way: regular files only, up to a limit, and never a word of what is in others.
#
# A path that a command is given may lead anywhere. A path that stands inside a file leads into the folder of that file
# or below it, links followed, so that a design from elsewhere cannot make gearwright open what is not its own.
# ----------------------------------------------------------------------------------------------------------------------


LARGEST_TEXT = 1_000_000
"""Largest text file that is read [bytes]; shipped designs have about a thousand, propeller maps ten thousand."""
_OPEN = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)
"""How files are opened: a pipe that nobody writes into, or a device, does not make the caller wait."""
_SHOWN = 200
"""Characters of a path in a message [-]."""


def text_of(
    path: str | Path, key: str = "", *, missing: str = "there is no such file", largest: int = LARGEST_TEXT
) -> str:
    """Return the text of a regular file, with the line ends of Unix.

    Args:
        path: Of the file.
        key: Entry that names the file, if it is not the caller itself.
        missing: What is said if there is none.
        largest: Size of the largest file that is read [bytes].

    Raises:
        DesignError: If there is no such file, it is none that can be read, is too large, or is no text in UTF-8.
    """
    try:
        return _content(path, key, missing, largest).decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        raise _refused(path, key, "this is not a text file in UTF-8") from None


def bytes_of(path: str | Path, *, largest: int) -> bytes:
    """Return the bytes of a regular file.

    Args:
        path: Of the file.
        largest: Size of the largest file that is read [bytes].

    Raises:
        DesignError: If there is no such file, it is none that can be read, or is too large.
    """
    return _content(path, "", "there is no such file", largest)


def begins_with(path: str | Path, mark: bytes) -> bool:
    """Tell whether a regular file begins with a mark, such as that of its kind.

    Args:
        path: Of the file.
        mark: First bytes.

    Raises:
        DesignError: If there is no such file, or it is none that can be read.
    """
    try:
        with os.fdopen(_opened(path, "", "there is no such file"), "rb") as file:
            return file.read(len(mark)) == mark
    except OSError as error:
        raise _refused(path, "", f"the file cannot be read: {error.strerror}") from None


def refuse_irregular(path: str | Path, *, missing: str = "there is no such file") -> None:
    """Raise for what is no regular file, before a library that knows no such rule opens it.

    Args:
        path: Of the file.
        missing: What is said if there is none.

    Raises:
        DesignError: If there is no such file, or it is a folder, a pipe or a device.
    """
    os.close(_opened(path, "", missing))


def numbers_of(text: str, names: Sequence[str]) -> list[list[float]]:
    """Return columns of a CSV text, row by row.

    Args:
        text: With the names of its columns in the first row; columns that are not asked for are left alone.
        names: Of the columns.

    Raises:
        ValueError: A column is missing, or a number is none, with the line, but not with what stands there.
    """
    rows, line = csv.DictReader(text.splitlines()), 1
    try:
        missing = [name for name in names if name not in (rows.fieldnames or ())]
        if missing:
            raise ValueError(f"lacks {' and '.join(missing)}; its first row must name the columns {', '.join(names)}")
        table = []
        for line, row in enumerate(rows, start=2):  # noqa: B007 - said below
            table.append([_finite(row[name]) for name in names])
    except (csv.Error, _NoNumber):
        raise ValueError(f"has no {len(names)} numbers in line {line}") from None
    return table


def _finite(cell: str | None) -> float:
    try:
        number = float(cell or "")
    except ValueError:
        raise _NoNumber from None
    if not math.isfinite(number):
        raise _NoNumber
    return number


class _NoNumber(Exception):
    """A cell of a table holds something else."""


def beside(name: str, folder: Path, key: str) -> Path:
    """Return the path of a file that is named inside a file.

    Args:
        name: As written.
        folder: Of the file in which it is written.
        key: Entry that names it.

    Raises:
        DesignError: If the path is absolute, leads upwards, or leaves the folder through a link.
    """
    path, windows = Path(name), PureWindowsPath(name)
    rule = "name a file in the folder of this file, or below it"
    if path.is_absolute() or windows.drive or windows.root:
        raise _refused(name, key, f"this path is absolute; {rule}")
    if ".." in windows.parts:
        raise _refused(name, key, f"this path leads upwards; {rule}")
    try:
        inside = (folder / path).resolve().is_relative_to(folder.resolve())
    except (OSError, ValueError, RuntimeError):  # a null byte; links in a circle
        raise _refused(name, key, f"this is no path; {rule}") from None
    if not inside:
        raise _refused(name, key, f"a link leads out of the folder; {rule}")
    return folder / path


def _content(path: str | Path, key: str, missing: str, largest: int) -> bytes:
    too_large = f"the file has more than {largest:,} bytes, the most that is read"
    try:
        with os.fdopen(_opened(path, key, missing), "rb") as file:
            if os.fstat(file.fileno()).st_size > largest:
                raise _refused(path, key, too_large)
            content = file.read(largest + 1)
    except OSError as error:
        raise _refused(path, key, f"the file cannot be read: {error.strerror}") from None
    if len(content) > largest:
        raise _refused(path, key, too_large)
    return content


def _opened(path: str | Path, key: str, missing: str) -> int:
    """Return the descriptor of a regular file."""
    if Path(path).is_dir():
        raise _refused(path, key, "this is a folder; name a file in it")
    try:
        descriptor = os.open(path, _OPEN)
    except FileNotFoundError:
        raise _refused(path, key, missing) from None
    except OSError as error:
        raise _refused(path, key, f"the file cannot be read: {error.strerror}") from None
    except ValueError:  # a null byte
        raise _refused(path, key, "this is no path") from None
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise _refused(path, key, "this is a pipe or a device; name a regular file")
    return descriptor


def _refused(path: str | Path, key: str, reason: str) -> DesignError:
    name = excerpt(str(path), _SHOWN)
    return DesignError([Problem(key, f"{name}: {reason}")]) if key else DesignError([Problem("", reason)], name)


# ----------------------------------------------------------------------------------------------------------------------
# Write files whole or not at all: beside the place, onto the disk, then in one step into the place.
#
# A full disk, a killed process or Ctrl-C leaves what was there before, or nothing; never half a file. What cannot be
# replaced, a pipe or a device, is written straight.
# ----------------------------------------------------------------------------------------------------------------------


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
