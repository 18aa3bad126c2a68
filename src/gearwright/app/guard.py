"""Access control of the workbench: local requests only, page token, size and time limits."""

from __future__ import annotations

import asyncio
import hmac
import json
from collections.abc import Awaitable, Callable, Mapping, MutableMapping
from functools import cache
from http.cookies import CookieError, SimpleCookie
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple
from urllib.parse import parse_qs

if TYPE_CHECKING:
    from uvicorn.protocols.http.h11_impl import H11Protocol


# ----------------------------------------------------------------------------------------------------------------------
# Connections on which requests arrive in time, or not at all: who sends half of one takes nobody's place.
# ----------------------------------------------------------------------------------------------------------------------


LATEST = 20.0
"""Until a connection whose request has not arrived is closed [s]."""
MOST_ARRIVING = 32
"""Connections that may wait for their requests; of more the oldest are closed [-]."""


@cache
def arriving() -> type[H11Protocol]:
    """Return the protocol of uvicorn, as soon as that is needed, whose connections are closed if a request is late."""
    import h11
    from uvicorn.protocols.http.h11_impl import H11Protocol

    class Arriving(H11Protocol):
        """A connection of uvicorn that is closed where its next request, headers and body, takes too long."""

        waiting: ClassVar[dict[Any, asyncio.TimerHandle]] = {}
        """Those whose requests are on their way, the oldest first."""

        def connection_made(self, transport: Any) -> None:
            """Wait for the first request."""
            super().connection_made(transport)
            self._watch()

        def data_received(self, data: bytes) -> None:
            """Take in a part of a request."""
            super().data_received(data)
            self._watch()

        def on_response_complete(self) -> None:
            """Wait for the next request."""
            super().on_response_complete()
            self._watch()

        def connection_lost(self, exc: Exception | None) -> None:
            """Forget it."""
            self._rest()
            super().connection_lost(exc)

        def _watch(self) -> None:
            if self.conn.their_state not in (h11.IDLE, h11.SEND_BODY) or self.transport.is_closing():
                self._rest()
            elif self not in self.waiting:
                self.waiting[self] = self.loop.call_later(LATEST, self._refuse)
                if len(self.waiting) > MOST_ARRIVING:
                    next(iter(self.waiting))._refuse()

        def _rest(self) -> None:
            if timer := self.waiting.pop(self, None):
                timer.cancel()

        def _refuse(self) -> None:
            self._rest()
            self.transport.abort()

    return Arriving


# ----------------------------------------------------------------------------------------------------------------------
# Who may ask the workbench, and how: this machine, by a page that this server gave out, in requests of limited size.
#
# A plain ASGI wrapper around everything, static files too. The address that is printed carries a token; it is taken
# once and becomes a cookie that no script reads and no other site sends.
# ----------------------------------------------------------------------------------------------------------------------


Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Message, Receive, Send], Awaitable[None]]

LARGEST_BODY = 1_200_000
"""Most that a request may carry [bytes]: a text file of the largest size that is read, quoted as JSON."""
PATIENCE = 10.0
"""Longest that a request may take to arrive [s]."""
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'{style}; img-src 'self' data: blob:; connect-src 'self';"
    " font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""What a page of the workbench may load: its own files, nothing written into it."""
HEADERS = {
    "content-security-policy": POLICY.format(style=""),
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-store",
}
_CHANGING = ("POST", "PUT")
_READING = ("GET", "HEAD")


class Refusal(NamedTuple):
    """Why a request is not let in."""

    status: int
    sentence: str


def policy(nonce: str) -> str:
    """Return the policy of a page whose editor writes its style under a number used once.

    Args:
        nonce: The number.
    """
    return POLICY.format(style=f" 'nonce-{nonce}'")


class Guard:
    """Lets in who holds the token and asks from this server's own page."""

    def __init__(self, app: App, *, port: int, token: str) -> None:
        self.app = app
        self.token = token
        self.cookie = f"gearwright-{port}"
        self.hosts = {f"{name}:{port}" for name in ("127.0.0.1", "localhost", "[::1]")}
        self.origins = {f"http://{host}" for host in self.hosts}

    async def __call__(self, scope: Message, receive: Receive, send: Send) -> None:
        """Answer one request, or pass it on."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1008})
            return
        headers = _headers(scope)
        refusal = self._refused(scope, headers)
        if refusal is None and not self._known(headers):
            if self._brings_token(scope):
                await _answer(send, 303, b"", {"location": "/", "set-cookie": self._cookie_line()})
                return
            refusal = Refusal(401, "open the address that gearwright app printed: it carries a token")
        body = b""
        if refusal is None and scope["method"] in _CHANGING:
            read = await _body(receive)
            refusal, body = (read, b"") if isinstance(read, Refusal) else (None, read)
        if refusal is not None:
            await _answer(send, refusal.status, json.dumps({"error": refusal.sentence}).encode())
            return
        await self.app(scope, _given(body, receive), _with_headers(send))

    def _refused(self, scope: Message, headers: Mapping[str, list[str]]) -> Refusal | None:
        """Return what is wrong with a request before anybody asks who sends it."""
        if headers.get("host", []) not in [[host] for host in self.hosts]:
            return Refusal(421, "this server answers to 127.0.0.1 and localhost only")
        site = _first(headers, "sec-fetch-site")
        if site in ("cross-site", "same-site") and (scope["method"], scope["path"]) != ("GET", "/"):
            return Refusal(403, "another site asks")
        if scope["method"] in _READING:
            return None
        if scope["method"] not in _CHANGING:
            return Refusal(405, "ask with GET, HEAD, POST or PUT")
        if headers.get("origin", []) not in [[origin] for origin in self.origins]:
            return Refusal(403, "the Origin is not this page")
        if _first(headers, "content-type").split(";")[0].strip().lower() != "application/json":
            return Refusal(415, "send application/json")
        length = _first(headers, "content-length") or "0"
        if not (length.isascii() and length.isdigit()) or len(length) > 12 or int(length) > LARGEST_BODY:
            return _TOO_LARGE
        return None

    def _known(self, headers: Mapping[str, list[str]]) -> bool:
        """Tell whether a request carries the cookie."""
        held = SimpleCookie()
        try:
            held.load("; ".join(headers.get("cookie", [])))
        except CookieError:
            return False
        return self.cookie in held and self._is_token(held[self.cookie].value)

    def _brings_token(self, scope: Message) -> bool:
        """Tell whether a request opens the printed address."""
        if scope["method"] != "GET" or scope["path"] != "/":
            return False
        given = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])
        return len(given) == 1 and self._is_token(given[0])

    def _is_token(self, text: str) -> bool:
        return hmac.compare_digest(text.encode("utf-8", "replace"), self.token.encode())

    def _cookie_line(self) -> str:
        return f"{self.cookie}={self.token}; HttpOnly; SameSite=Strict; Path=/"


_TOO_LARGE = Refusal(413, f"a request may carry {LARGEST_BODY:,} bytes")


def _headers(scope: Message) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for name, value in scope["headers"]:
        found.setdefault(name.decode("latin-1").lower(), []).append(value.decode("latin-1"))
    return found


def _first(headers: Mapping[str, list[str]], name: str) -> str:
    return headers.get(name, [""])[0]


async def _body(receive: Receive) -> bytes | Refusal:
    """Return all that a request carries, in however many pieces it comes, or why it is not read to its end."""
    parts, size = list[bytes](), 0
    try:
        async with asyncio.timeout(PATIENCE):
            while True:
                message = await receive()
                if message["type"] == "http.disconnect":
                    return Refusal(400, "the request ended early")
                parts.append(message.get("body", b""))
                size += len(parts[-1])
                if size > LARGEST_BODY:
                    return _TOO_LARGE
                if not message.get("more_body", False):
                    return b"".join(parts)
    except TimeoutError:
        return Refusal(408, "the request did not arrive in time")


def _given(body: bytes, receive: Receive) -> Receive:
    """Return a receiver that hands out what was read, and then whatever comes."""
    left = [body]

    async def give() -> Message:
        return {"type": "http.request", "body": left.pop(), "more_body": False} if left else await receive()

    return give


def _with_headers(send: Send) -> Send:
    """Return a sender that adds the headers of safety where an answer does not have its own."""

    async def add(message: Message) -> None:
        if message["type"] == "http.response.start":
            given = list(message.get("headers", []))
            own = {name.lower() for name, _ in given}
            more = [(name.encode(), value.encode()) for name, value in HEADERS.items() if name.encode() not in own]
            message = {**message, "headers": [*given, *more]}
        await send(message)

    return add


async def _answer(send: Send, status: int, body: bytes, more: Mapping[str, str] | None = None) -> None:
    own = {**HEADERS, "content-type": "application/json", "content-length": str(len(body)), **(more or {})}
    headers = [(name.encode(), value.encode("latin-1")) for name, value in own.items()]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
