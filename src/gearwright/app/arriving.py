"""Connections on which requests arrive in time, or not at all: who sends half of one takes nobody's place."""

from __future__ import annotations

import asyncio
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from uvicorn.protocols.http.h11_impl import H11Protocol

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
