"""Start the workbench on this machine, say where it is, and end with it."""

from __future__ import annotations

import os
import socket
import threading
import webbrowser
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from secrets import token_urlsafe

from gearwright.errors import Problem, install, refuse

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
    from gearwright.app.worker import Worker

    where, file, shipped = _opened(name, folder)
    bound, worker = _bound(port), Worker()
    threading.Thread(target=worker.start, daemon=True).start()  # it loads what sizes while this loads what serves
    import uvicorn

    from gearwright.app.arriving import arriving
    from gearwright.app.guard import Guard
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
    with bound:
        server[0].run(sockets=[bound])


def _opened(name: str, folder: Path | None) -> tuple[Path, str, bool]:
    """Return the folder, the name in it or of a shipped design, and whether it is shipped."""
    from gearwright.app.folder import kept
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
