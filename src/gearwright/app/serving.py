"""Start and end of the workbench server, and the design files of its folder."""

import hashlib
import os
import re
import socket
import threading
import webbrowser
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from secrets import token_urlsafe
from typing import NamedTuple

from gearwright.errors import DesignError, Problem, install, refuse
from gearwright.files import LARGEST_TEXT, beside, text_of, write_text
from gearwright.signals import heard_after

# ----------------------------------------------------------------------------------------------------------------------
# The design files of one folder, as the workbench reads and saves them: never outside it, never over a change.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# Start the workbench on this machine, say where it is, and end with it.
# ----------------------------------------------------------------------------------------------------------------------


HOST = "127.0.0.1"
"""Nobody else reaches it; from another machine: ssh -L."""
NEEDED = ("starlette", "uvicorn", "tomlkit")
MOST_CONNECTIONS = 64


def serve(
    name: str, *, folder: Path | None = None, port: int = 0, browser: bool = True, told: Callable[[str], None] = print
) -> None:
    """Serve the workbench of a design until it is ended.

    Args:
        name: A design file, or a shipped design.
        folder: In which files are read and written; left out: that of the file, or where the program runs.
        port: Of the address; 0: any that is free.
        browser: Whether the address is opened.
        told: Takes the address.

    Raises:
        DesignError: If there is no such design, the port is taken, or the extra ``app`` is not here.
    """
    if lacking := [module for module in NEEDED if find_spec(module) is None]:
        refuse([Problem("", f"the workbench needs {' and '.join(lacking)}, not here yet; {install('app')}")])
    from gearwright.app.workers import Worker

    where, file, shipped = _opened(name, folder)
    bound, worker = _bound(port), Worker()
    threading.Thread(target=worker.start, daemon=True).start()  # it loads what sizes while this loads what serves
    import uvicorn

    from gearwright.app.guard import Guard, arriving
    from gearwright.app.routes import Opened, workbench

    taken, token = bound.getsockname()[1], token_urlsafe(24)
    address = f"http://{HOST}:{taken}/?token={token}"
    server: list[uvicorn.Server] = []
    opened = Opened(where, file, shipped, lambda: setattr(server[0], "should_exit", True), worker)
    guarded = Guard(workbench(opened), port=taken, token=token)
    server.append(
        uvicorn.Server(
            uvicorn.Config(
                guarded, log_level="critical", access_log=False, server_header=False, ws="none", lifespan="on",
                http=arriving(), limit_concurrency=MOST_CONNECTIONS, timeout_graceful_shutdown=1, proxy_headers=False,
            )
        )
    )  # fmt: skip
    told(address)
    if browser:
        threading.Timer(0.3, webbrowser.open, [address]).start()
    with bound, heard_after(lambda: setattr(server[0], "should_exit", True)):  # also before the server hears by itself
        server[0].run(sockets=[bound])


def _opened(name: str, folder: Path | None) -> tuple[Path, str, bool]:
    """Return the folder, the name in it or of a shipped design, and whether it is shipped."""
    from gearwright.shipped import find_design, shipped_designs

    path = find_design(name)
    if name in shipped_designs() and path.parent != Path(name).parent:
        return (folder or Path()).resolve(), name, True
    where = (folder or path.parent).resolve()
    if path.resolve().parent != where:
        refuse([Problem("--folder", f"{name} does not lie in it; name its folder, or leave it out")])
    kept(where, path.name)
    return where, path.name, False


def _bound(port: int) -> socket.socket:
    bound = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if os.name == "posix":  # who starts it again at once has the same address; elsewhere others could take it over
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        bound.bind((HOST, port))
        bound.listen(MOST_CONNECTIONS)  # who opens the address at once waits, and is not turned away
    except (OSError, OverflowError):
        bound.close()
        refuse([Problem("--port", f"{port} is taken or not allowed; give another one, or leave it out")])
    return bound
