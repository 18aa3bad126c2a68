"""Who is let in to the workbench: the table of docs/reliability.md."""

import random

import pytest
from asking import BASE, PORT, TOKEN

import gearwright as gw
from gearwright.app.form import form
from gearwright.app.guard import LARGEST_BODY

pytestmark = pytest.mark.extra("starlette", "httpx", "tomlkit", "uvicorn")
NOBODY = {"cookie": None}


def test_nobody_without_the_token_sees_anything(asked):
    for path in (
        "/",
        "/static/app.css",
        "/api/start",
        "/?token=",
        "/?token=wrong",
        "/?token=a&token=b",
        f"/x?token={TOKEN}",
    ):
        assert asked.ask("GET", path, headers=NOBODY).status_code == 401, path
    assert asked.post("/api/size", NOBODY, text="").status_code == 401
    assert asked.ask("GET", "/", headers={"cookie": f"gearwright-{PORT}=wrong"}).status_code == 401
    assert asked.ask("GET", "/", headers={"cookie": f"gearwright-{PORT + 1}={TOKEN}"}).status_code == 401
    assert asked.ask("GET", "/", headers={"cookie": "=;=\x7f;;" + "a" * 5000}).status_code == 401


def test_the_token_becomes_a_cookie_that_no_script_reads_and_no_site_sends(asked):
    opened = asked.ask("GET", f"/?token={TOKEN}", headers=NOBODY)
    assert (opened.status_code, opened.headers["location"]) == (303, "/")
    cookie = opened.headers["set-cookie"]
    assert cookie == f"gearwright-{PORT}={TOKEN}; HttpOnly; SameSite=Strict; Path=/"
    assert asked.ask("GET", "/").status_code == 200


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        f"evil.example:{PORT}",
        "127.0.0.1",
        f"127.0.0.1:{PORT + 1}",
        "",
        f"127.0.0.1.evil.example:{PORT}",
    ],
)
def test_another_host_name_is_no_way_in(asked, host):
    """DNS rebinding: a name of the attacker's that leads to 127.0.0.1."""
    assert asked.ask("GET", "/", headers={"host": host}).status_code == 421
    assert asked.ask("GET", f"/?token={TOKEN}", headers={"host": host, **NOBODY}).status_code == 421


@pytest.mark.parametrize(
    "origin",
    [
        None,
        "null",
        "http://evil.example",
        f"https://127.0.0.1:{PORT}",
        f"{BASE}.evil.example",
        f"http://127.0.0.1:{PORT + 1}",
        "",
    ],
)
def test_a_question_from_another_page_is_not_answered(asked, origin):
    assert asked.post("/api/size", {"origin": origin}, text="").status_code == 403
    assert asked.ask("PUT", "/api/files/a.toml", json={"text": ""}, headers={"origin": origin}).status_code == 403


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_another_site_reads_nothing(asked, site):
    assert asked.ask("GET", "/api/start", headers={"sec-fetch-site": site}).status_code == 403
    assert asked.post("/api/size", {"sec-fetch-site": site}, text="").status_code == 403


@pytest.mark.parametrize(
    "kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "", "text/json"]
)
def test_what_any_form_can_send_is_refused(asked, kind):
    sent = asked.ask("POST", "/api/size", content='{"text": ""}', headers={"content-type": kind})
    assert sent.status_code == 415


@pytest.mark.parametrize("method", ["DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT"])
def test_other_methods_are_refused_and_nothing_is_shared_with_other_origins(asked, method):
    answer = asked.ask(method, "/api/size")
    assert answer.status_code == 405
    assert not [name for name in answer.headers if name.startswith("access-control")]


def test_what_is_too_large_is_refused_with_and_without_its_length(asked):
    json_ = {"content-type": "application/json"}
    assert asked.ask("POST", "/api/size", content=b"x" * (LARGEST_BODY + 1), headers=json_).status_code == 413

    async def pieces():
        for _ in range(40):
            yield b"x" * 50_000

    assert asked.ask("POST", "/api/size", content=pieces(), headers=json_).status_code == 413
    for length in ("-1", "1e3", "9" * 40, "٣"):
        headers = {**json_, "content-length": length.encode()}
        assert asked.ask("POST", "/api/size", content=b"{}", headers=headers).status_code == 413


@pytest.mark.parametrize(
    "body", [b"", b"nope", b"[]", b"1", b"{}", b'{"text": 1}', b'{"text": "\\ud800"}', b"[" * 100_000, b"\xff"]
)
def test_what_says_nothing_is_told_so(asked, body):
    sent = asked.ask("POST", "/api/size", content=body, headers={"content-type": "application/json"})
    assert sent.status_code == 400, sent.text


@pytest.mark.parametrize(
    "name",
    [
        "../serve.py",
        "%2e%2e/serve.py",
        "..%2fserve.py",
        "/etc/passwd",
        "vendor/../../guard.py",
        "index.html",
        "vendor/vendor.toml",
    ],
)
def test_only_listed_files_are_given_out(asked, name):
    assert asked.ask("GET", f"/static/{name}").status_code == 404


def test_an_entry_of_the_form_names_its_diagram(asked):
    groups = {group.path: (*group.written, *group.possible) for group in form("[pairs.one]\nmodule_in = 0.1\n")}
    named = {field.key: field.diagram for field in groups["pairs", "one"]}
    assert (named["module_in"], named["centre_distance_mm"], named["pinion"]) == ("input-teeth", "input-pair", "")
    answer = asked.ask("GET", f"/diagrams/{named['module_in']}")
    assert answer.headers["content-type"] == "image/svg+xml" and b"module_mm" in answer.content
    assert asked.ask("GET", "/diagrams/..%2fform.py").status_code == 404


@pytest.mark.parametrize("name", ["..%2f..%2f..%2fetc%2fpasswd", "nope", "in-line-h2.toml", "%00", "con"])
def test_only_shipped_designs_are_given_out_by_their_names(asked, name):
    assert asked.ask("GET", f"/api/designs/{name}").status_code in (404, 422)


def test_every_answer_carries_the_headers_of_safety(asked):
    for answer in (asked.ask("GET", "/"), asked.ask("GET", "/api/start"), asked.ask("GET", "/", headers=NOBODY)):
        policy = answer.headers["content-security-policy"]
        assert policy.startswith("default-src 'none'; script-src 'self'; ")
        assert "unsafe" not in policy and "frame-ancestors 'none'" in policy
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["cache-control"] == "no-store"
        assert answer.headers["cross-origin-resource-policy"] == "same-origin"
        assert not [name for name in answer.headers if name.startswith("access-control")]


def test_a_script_in_a_name_comes_back_as_data(asked):
    answer = asked.post("/api/size", text='name = "<script>alert(1)</script>"\n[x]')
    assert answer.status_code == 422 and answer.headers["content-type"] == "application/json"
    name = "</text><script>alert(1)</script>"
    text = (
        gw.shipped_design("in-line-h2")
        .read_text(encoding="utf-8")
        .replace("Regional turboprop, in-line hybrid 2", name)
    )
    drawn = asked.post("/api/flow", text=text)
    assert drawn.status_code == 200 and "<script" not in drawn.text


def test_random_requests_are_answered_and_none_breaks_the_server(asked):
    """Methods, paths, headers and bodies drawn from pieces that servers trip over; docs/reliability.md has more."""
    known = {200, 303, 400, 401, 403, 404, 405, 409, 412, 413, 415, 421, 422, 428, 429}
    assert random_requests(asked, 400, seed=28) <= known


PATHS = (
    "/", "/api/start", "/api/form", "/api/edit", "/api/size", "/api/files/a.toml", "/api/files/%2e%2e", "//",
    "/?token=x", "/api/designs/star", "/static/app.css", "/api/nope", "/%ff",
    "/api/jobs/rows", "/api/jobs/mission", "/api/jobs/x/stop",
    "/api/jobs/x/events", "/api/jobs/x/result",
)  # fmt: skip
PIECES = ("{", "}", "[", "]", '"text"', ":", '"[a]"', '"a = 1"', "null", "1e999", "\\ud800", ",", '"path"', "\x00", "é")
VALUES = ('"[a]\\nb = 1"', '""', "1", '["a", "b"]', "[]", "null", '"x"', "1e400")
KINDS = ("application/json", "application/json", "application/json", "text/plain")
COOKIES = ("", "a=b", f"gearwright-{PORT}=x")


def random_requests(asked, count, *, seed):
    """Return the statuses with which random requests are answered; nobody without the token gets in."""
    draw, seen = random.Random(seed), set()

    async def asking():
        async with asked.client() as client:
            for _ in range(count):
                headers = {"origin": draw.choice([BASE, BASE, BASE, "null"]), "content-type": draw.choice(KINDS)}
                stranger = draw.random() < 0.2
                if stranger:
                    headers["cookie"] = draw.choice(COOKIES)
                if draw.random() < 0.1:
                    headers["host"] = draw.choice(["evil.example", "", "localhost"])
                body = "".join(draw.choices(PIECES, k=draw.randrange(6)))
                if draw.random() < 0.4:
                    named = [f'"{name}": {draw.choice(VALUES)}' for name in ("text", "path", "value")]
                    body = f"{{{', '.join(named)}}}"
                method = draw.choice(["GET", "POST", "POST", "PUT", "HEAD", "DELETE"])
                content = body.encode() if method in ("POST", "PUT") else None
                answer = await client.request(method, draw.choice(PATHS), headers=headers, content=content)
                seen.add(answer.status_code)
                assert answer.status_code < 500, (method, answer.request.url, body, answer.text)
                assert not (stranger and answer.status_code < 400), answer.request.url

    asked.runner.run(asking())
    return seen
