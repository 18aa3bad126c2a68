"""Connections whose requests do not arrive: they end, and meanwhile everybody else is answered."""

import socket
import threading
import time

import pytest

pytestmark = pytest.mark.extra("starlette", "httpx", "tomlkit", "uvicorn")
HALF = b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: "
REFUSED_AND_ON = b"POST /x HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100000\r\n\r\nbody"


async def answering(scope, receive, send):
    """An application that says the same to everyone, whatever was sent."""
    await send({"type": "http.response.start", "status": 200, "headers": [(b"content-length", b"2")]})
    await send({"type": "http.response.body", "body": b"ok"})


@pytest.fixture
def served():
    """Yield the port of a server on this machine."""
    import uvicorn

    from gearwright.app.guard import arriving
    from gearwright.app.serving import MOST_CONNECTIONS

    bound = socket.create_server(("127.0.0.1", 0), backlog=256)
    given = {"log_level": "critical", "lifespan": "off", "ws": "none", "limit_concurrency": MOST_CONNECTIONS}
    server = uvicorn.Server(uvicorn.Config(answering, http=arriving(), **given))
    thread = threading.Thread(target=server.run, kwargs={"sockets": [bound]})
    thread.start()
    yield bound.getsockname()[1]
    server.should_exit = True
    thread.join()
    bound.close()
    assert not arriving().waiting


def asked(port):
    with socket.create_connection(("127.0.0.1", port), timeout=30.0) as line:
        line.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n")
        return line.makefile("rb").readline()


@pytest.mark.parametrize("sent", [b"", HALF, REFUSED_AND_ON], ids=["nothing", "half a header", "half a body"])
def test_very_many_who_send_half_a_request_keep_nobody_out(served, sent):
    lines = [socket.create_connection(("127.0.0.1", served), timeout=30.0) for _ in range(200)]
    try:
        for line in lines:
            line.sendall(sent)
        for _ in range(20):
            assert b"200" in asked(served)
    finally:
        for line in lines:
            line.close()


@pytest.mark.parametrize("sent", [HALF, REFUSED_AND_ON], ids=["a header", "a body"])
def test_a_request_that_trickles_in_is_given_up(served, sent, monkeypatch):
    import gearwright.app.guard

    monkeypatch.setattr(gearwright.app.guard, "LATEST", 0.5)
    with socket.create_connection(("127.0.0.1", served), timeout=30.0) as line:
        line.sendall(sent)
        with pytest.raises(OSError):  # whoever goes on is told so by the system
            for _ in range(3000):
                line.sendall(b"x")
                time.sleep(0.01)


def test_one_line_serves_many_requests(served):
    with socket.create_connection(("127.0.0.1", served), timeout=30.0) as line:
        answers = line.makefile("rb")
        for _ in range(50):
            line.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
            assert b"200" in answers.readline()
            while answers.readline().strip():
                pass
            assert answers.read(2) == b"ok"
