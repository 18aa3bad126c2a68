"""The workbench server: start and end, design files of its folder, and the addresses of pages and questions."""

from __future__ import annotations

import asyncio
import hashlib
import json
import os
import re
import socket
import threading
import tomllib
import webbrowser
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files as resources
from importlib.resources.abc import Traversable
from importlib.util import find_spec
from pathlib import Path
from secrets import token_urlsafe
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.app.guard import policy
from gearwright.app.questions import BESIDE, LIMITS, LONG, QUICK, Question
from gearwright.app.workers import Busy, Job, Jobs, Lane, Stopped, Superseded, Worker, stop_all
from gearwright.errors import DesignError, GearwrightError, Problem, install, refuse
from gearwright.files import LARGEST_TEXT, beside, text_of, write_text
from gearwright.formats import FORMATS
from gearwright.signals import heard_after
from gearwright.version import __version__

if TYPE_CHECKING:
    from starlette.applications import Starlette
    from starlette.requests import Request
    from starlette.responses import Response


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


# ----------------------------------------------------------------------------------------------------------------------
# The files that the browser gets: the page, its scripts and styles, and the scripts that turn the gearbox.
#
# Only what is listed here is ever given out, by its name alone.
# ----------------------------------------------------------------------------------------------------------------------


NONCE = "THE-NONCE"
"""In the page, where a number that is used once stands."""
ROOMS = ("dynamics", "flight", "studies", "vendor")
"""Folders of scripts."""
LENT = {
    "solids": ("three.min.js", "model.js", "view.js", "motion.js", "panel.js"),
    "uplot": ("uplot.min.js", "uplot.min.css"),
}
"""Files that pages of `render` have too."""
_KINDS = {"js": "text/javascript", "css": "text/css", "svg": "image/svg+xml"}


class Given(NamedTuple):
    """A file that is given out."""

    at: Traversable
    kind: str

    def read_bytes(self) -> bytes:
        """Return its content."""
        return self.at.read_bytes()


@cache
def files() -> dict[str, Given]:
    """Return name in the address -> file."""
    own = resources("gearwright.app") / "static"
    found = {at.name: at for at in own.iterdir()}
    found |= {f"{room}/{at.name}": at for room in ROOMS for at in (own / room).iterdir()}
    for name, given in LENT.items():
        found |= {f"{name}/{file}": resources(f"gearwright.render.{name}") / file for file in given}
    kinds = {name: _KINDS.get(name.rpartition(".")[2], "") for name in found}
    return {name: Given(at, kinds[name]) for name, at in found.items() if kinds[name]}


@cache
def index() -> str:
    """Return the page."""
    return (resources("gearwright.app") / "static" / "index.html").read_text(encoding="utf-8")


def bundled() -> dict[str, Any]:
    """Return bundle -> version of its packages, their licences and its digest."""
    place = resources("gearwright.app") / "static" / "vendor" / "vendor.toml"
    return tomllib.loads(place.read_text(encoding="utf-8"))


# ----------------------------------------------------------------------------------------------------------------------
# The addresses of the workbench: its page and files, the designs of the folder, and the verbs.
# ----------------------------------------------------------------------------------------------------------------------


LIMIT = 60.0
"""After which an answer is no longer waited for [s]."""
LATER = 4.0
"""After what the page needs first, until what motion needs is loaded: it would hold up the page that just opens [s]."""
WARM = "\0"
"""How the server calls itself where a window has its name."""
LONGEST_PAGE = 64
"""Of the name by which a window calls itself [characters]."""


@dataclass(frozen=True)
class Opened:
    """What the workbench was started with."""

    folder: Path
    name: str
    """File of the folder or shipped design."""
    shipped: bool
    end: Callable[[], None] = field(default=lambda: None)
    """Ends the server."""
    worker: Worker = field(default_factory=Worker)
    """What answers quickly; it may have been started before."""


def workbench(opened: Opened) -> Starlette:
    """Return the workbench as an application, without its guard.

    Args:
        opened: What it was started with.
    """
    from starlette.applications import Starlette
    from starlette.routing import Route

    desk = Desk(opened)
    routes = [
        Route("/", desk.page),
        Route("/static/{name:path}", desk.file),
        Route("/diagrams/{name}", desk.diagram),
        Route("/api/start", desk.start),
        Route("/api/designs/{name}", desk.shipped),
        Route("/api/files/{name}", desk.read, methods=["GET"]),
        Route("/api/files/{name}", desk.write, methods=["PUT"]),
        Route("/api/quit", desk.quit, methods=["POST"]),
        *(Route(f"/api/{verb}", desk.answer, methods=["POST"]) for verb in QUICK),
        *(Route(f"/api/jobs/{verb}", desk.begin, methods=["POST"]) for verb in LONG),
        Route("/api/jobs/{name}/events", desk.events),
        Route("/api/jobs/{name}/result", desk.result),
        Route("/api/jobs/{name}/stop", desk.stop, methods=["POST"]),
    ]
    refusals: dict[Any, Any] = {DesignError: _problems, GearwrightError: _problems, NotUsable: _unusable}
    return Starlette(routes=routes, lifespan=desk.open, exception_handlers=refusals)


class NotUsable(Exception):
    """A request that says nothing."""


class Desk:
    """What answers, the files of a folder, and what the page asks of them."""

    def __init__(self, opened: Opened) -> None:
        self.opened = opened
        self.quick = Lane(opened.worker, seconds=LIMIT)
        self.beside = {name: Lane(Worker(), seconds=limit) for name, limit in LIMITS.items()}
        self.jobs = Jobs()

    @asynccontextmanager
    async def open(self, _: Starlette) -> AsyncIterator[None]:
        """Let what answers quickly begin before it is asked; end them with the server."""
        warm = asyncio.create_task(self._warm())
        try:
            yield
        finally:
            warm.cancel()
            self.jobs.close()
            stop_all([*(lane.worker for lane in (self.quick, *self.beside.values())), *self.jobs.workers])

    async def _warm(self) -> None:
        """Size what was opened before a page asks for it, and load what motion needs."""
        opened = self.opened
        with suppress(GearwrightError, Superseded, Stopped, asyncio.CancelledError):
            text = self._shipped_text(opened.name) if opened.shipped else kept(opened.folder, opened.name).text
            for verb in ("size", "flow", "form"):
                await self._lane(verb).ask(Question(verb, text, str(opened.folder)), WARM)
            await asyncio.sleep(LATER)
            self.jobs.begin(Question("modes", text, str(opened.folder)), WARM)

    async def page(self, _: Request) -> Response:
        """The page, with the number under which its editor may write its style."""
        from starlette.responses import HTMLResponse

        nonce = token_urlsafe(16)
        return HTMLResponse(index().replace(NONCE, nonce), headers={"content-security-policy": policy(nonce)})

    async def file(self, request: Request) -> Response:
        """A script, style or picture of the page."""
        from starlette.responses import Response

        found = files().get(request.path_params["name"])
        if found is None:
            return _error(404, "there is no such file")
        return Response(found.read_bytes(), media_type=found.kind)

    async def diagram(self, request: Request) -> Response:
        """What an entry of the form is measured from."""
        from starlette.responses import Response

        from gearwright.render.diagrams import DIAGRAMS

        found = next((known for known in DIAGRAMS if known.name == request.path_params["name"]), None)
        if found is None:
            return _error(404, "there is no such diagram")
        return Response(found.svg(), media_type="image/svg+xml")

    async def start(self, _: Request) -> Response:
        """What the page shows first."""
        from gearwright.shipped import shipped_designs, shipped_missions, shipped_studies

        opened = self.opened
        text = self._shipped_text(opened.name) if opened.shipped else kept(opened.folder, opened.name).text
        return _as_json({
            "version": __version__,
            "name": opened.name,
            "shipped": opened.shipped,
            "text": text,
            "tag": "" if opened.shipped else tag_of(text),
            "designs": list(shipped_designs()),
            "files": design_files(opened.folder),
            "missions": list(shipped_missions()),
            "studies": list(shipped_studies()),
            "journals": journals(opened.folder),
            "formats": list(FORMATS),
        })  # fmt: skip

    async def shipped(self, request: Request) -> Response:
        """A shipped design, mission or study."""
        return _as_json({"text": self._shipped_text(request.path_params["name"]), "tag": ""})

    def _shipped_text(self, name: str) -> str:
        from gearwright.shipped import shipped_file

        return shipped_file(name).read_text(encoding="utf-8")

    async def read(self, request: Request) -> Response:
        """A file of the folder, with its tag."""
        found = kept(self.opened.folder, request.path_params["name"])
        return _as_json({"text": found.text, "tag": found.tag}, etag=found.tag)

    async def write(self, request: Request) -> Response:
        """Save a file that is still what the page has read, or that is new."""
        text = _text(await _body(request))
        match = request.headers.get("if-match", "").strip('"')
        if not match and request.headers.get("if-none-match") != "*":
            return _error(428, "say which text is replaced (If-Match), or that there is none (If-None-Match: *)")
        try:
            tag = save(self.opened.folder, request.path_params["name"], text, match)
        except Changed as reason:
            return _error(412, str(reason))
        return _as_json({"tag": tag}, etag=tag)

    async def answer(self, request: Request) -> Response:
        """The answer of a verb."""
        from starlette.responses import Response

        body = await _body(request)
        verb = request.url.path.rpartition("/")[2]
        question = Question(verb, _text(body), str(self.opened.folder), body)
        try:
            answer = await self._lane(verb).ask(question, str(body.get("page", ""))[:LONGEST_PAGE])
        except Superseded:
            return _error(409, "a newer question took the place of this one")
        except Busy:
            return _error(429, "too many questions wait")
        except Stopped as reason:
            return _error(409, str(reason))
        return Response(answer.content, answer.status, media_type=answer.kind)

    def _lane(self, verb: str) -> Lane:
        return self.beside[BESIDE[verb]] if verb in BESIDE else self.quick

    async def begin(self, request: Request) -> Response:
        """Begin a computation that takes long; its name is told at once."""
        body = await _body(request)
        verb = request.url.path.rpartition("/")[2]
        question = Question(verb, _text(body), str(self.opened.folder), body)
        try:
            job = self.jobs.begin(question, str(body.get("page", ""))[:LONGEST_PAGE])
        except Busy:
            return _error(429, "too many computations wait; stop one")
        return _as_json({"job": job.name})

    async def events(self, request: Request) -> Response:
        """What happens to a computation, as events; a page that lost its line goes on after the last one it knows."""
        from starlette.responses import StreamingResponse

        last = request.headers.get("last-event-id", "0")
        job = self.jobs.of(request.path_params["name"])
        if job is None or not (last.isascii() and last.isdigit() and len(last) < 12):
            return _error(404, "there is no such computation")
        return StreamingResponse(self._lines(job, int(last)), media_type="text/event-stream")

    async def _lines(self, job: Job, after: int) -> AsyncIterator[str]:
        async for event in self.jobs.events(job, after):
            yield f"id: {event['number']}\ndata: {json.dumps(event)}\n\n"

    async def result(self, request: Request) -> Response:
        """What a computation has found."""
        from starlette.responses import Response

        job = self.jobs.of(request.path_params["name"])
        if job is None or job.answer is None:
            return _error(404, "there is no such result")
        return Response(job.answer.content, job.answer.status, media_type=job.answer.kind)

    async def stop(self, request: Request) -> Response:
        """End a computation."""
        await _body(request)
        job = self.jobs.of(request.path_params["name"])
        if job is None:
            return _error(404, "there is no such computation")
        await self.jobs.stop(job)
        return _as_json({"stopped": True})

    async def quit(self, request: Request) -> Response:
        """End the server."""
        await _body(request)
        self.opened.end()
        return _as_json({"ended": True})


async def _body(request: Request) -> dict[str, Any]:
    try:
        body = json.loads(await request.body())
    except (ValueError, RecursionError):
        raise NotUsable("the body is not JSON") from None
    if not isinstance(body, dict):
        raise NotUsable("the body is no JSON object")
    return body


def _text(body: dict[str, Any]) -> str:
    text = body.pop("text", None)
    if not isinstance(text, str) or not _is_unicode(text):
        raise NotUsable("text: a string is needed")
    return text


def _is_unicode(text: str) -> bool:
    """Tell whether a text can be written: JSON lets halves of characters through."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def _as_json(value: object, etag: str = "") -> Response:
    from starlette.responses import JSONResponse

    return JSONResponse(value, headers={"etag": f'"{etag}"'} if etag else None)


def _error(status: int, sentence: str) -> Response:
    from starlette.responses import JSONResponse

    return JSONResponse({"error": sentence}, status)


async def _problems(_: Request, error: DesignError | GearwrightError) -> Response:
    from starlette.responses import JSONResponse

    listed = error.problems if isinstance(error, DesignError) else ()
    told = [{"path": one.path, "message": one.message, "line": one.line} for one in listed]
    return JSONResponse({"problems": told or [{"path": "", "message": str(error), "line": None}]}, 422)


async def _unusable(_: Request, error: NotUsable) -> Response:
    return _error(400, str(error))
