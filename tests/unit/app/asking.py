"""A workbench without a network: its guard and routes, asked as a browser would ask."""

from __future__ import annotations

import asyncio
import json
import struct
from contextlib import asynccontextmanager

PORT, TOKEN = 8808, "a-token-for-tests"
BASE = f"http://127.0.0.1:{PORT}"


class Asked:
    """Asks in a loop of its own, with the cookie and Origin of the page."""

    def __init__(self, folder, name="in-line-h2", *, shipped=True):
        from gearwright.app.guard import Guard
        from gearwright.app.serving import Opened, workbench

        self.ended, self.folder = [], folder
        self.app = workbench(Opened(folder, name, shipped, lambda: self.ended.append(True)))
        self.guarded = Guard(self.app, port=PORT, token=TOKEN)
        self.runner = asyncio.Runner()
        self.life = self.app.router.lifespan_context(self.app)
        self.runner.run(self.life.__aenter__())

    @property
    def desk(self):
        """What answers."""
        return next(route.endpoint.__self__ for route in self.app.routes if route.path == "/api/start")

    def close(self):
        """End its processes."""
        self.runner.run(self.life.__aexit__(None, None, None))
        self.runner.close()

    @asynccontextmanager
    async def client(self, headers=None):
        """Yield a client that knows the cookie."""
        import httpx

        own = {"origin": BASE, "cookie": f"gearwright-{PORT}={TOKEN}"} | (headers or {})
        own = {name: value for name, value in own.items() if value is not None}
        transport = httpx.ASGITransport(app=self.guarded, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url=BASE, headers=own, timeout=120) as client:
            yield client

    def ask(self, method, path, *, headers=None, **given):
        """Return the response to one request."""

        async def asking():
            async with self.client(headers) as client:
                return await client.request(method, path, **given)

        return self.runner.run(asking())

    def post(self, path, headers=None, /, **body):
        """Return the response to a question."""
        return self.ask("POST", path, json=body, headers=headers)

    def job(self, verb, /, **body):
        """Return the events of a computation and the response with its result."""

        async def asking():
            async with self.client() as client:
                begun = await client.post(f"/api/jobs/{verb}", json=body)
                assert begun.status_code == 200, begun.text
                place = f"/api/jobs/{begun.json()['job']}"
                told = await client.get(f"{place}/events")
                return events_of(told.text), await client.get(f"{place}/result")

        return self.runner.run(asking())

    def found(self, verb, /, **body):
        """Return the result of a computation: words, and columns by name where it has some."""
        answer = self.job(verb, **body)[1]
        assert answer.status_code == 200, answer.text
        if answer.headers["content-type"].startswith("application/json"):
            return answer.json(), {}
        return unpacked(answer.content)


def events_of(text):
    """Return what a stream of events says."""
    return [json.loads(line.removeprefix("data: ")) for line in text.splitlines() if line.startswith("data: ")]


def unpacked(content):
    """Return words and columns as the page reads them."""
    import numpy as np

    (length,) = struct.unpack_from("<I", content)
    head = json.loads(content[4 : 4 + length])
    numbers = np.frombuffer(content, dtype="<f4", offset=4 + length)
    return head, {name: numbers[at : at + count] for name, (at, count) in head["columns"].items()}
