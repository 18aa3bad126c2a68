"""Addresses of the workbench: pages, scripts, designs and questions."""

from __future__ import annotations

import asyncio
import json
import tomllib
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files as resources
from importlib.resources.abc import Traversable
from pathlib import Path
from secrets import token_urlsafe
from typing import TYPE_CHECKING, Any, NamedTuple

from gearwright.app.guard import policy
from gearwright.app.questions import BESIDE, LIMITS, LONG, QUICK, Question
from gearwright.app.serving import Changed, design_files, journals, kept, save, tag_of
from gearwright.app.workers import Busy, Job, Jobs, Lane, Stopped, Superseded, Worker, stop_all
from gearwright.errors import DesignError, GearwrightError
from gearwright.formats import FORMATS
from gearwright.version import __version__

if TYPE_CHECKING:
    from starlette.applications import Starlette
    from starlette.requests import Request
    from starlette.responses import Response


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
