"""A server with the workbench, a browser, and its windows."""

import os
import shutil

import pytest
from workbench import MASS, PATIENT, ended, started


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    server, found = started(tmp_path_factory.mktemp("designs"))
    yield found
    ended(server)


@pytest.fixture(scope="module")
def chromium():
    """Yield a browser; skip with the reason where none is installed, and fail where one is demanded."""
    from playwright.sync_api import Error, sync_playwright

    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    software = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=path, args=software)
        except Error as reason:
            if os.environ.get("GEARWRIGHT_BROWSER") == "1":
                raise
            pytest.skip(f"no browser starts: {str(reason).splitlines()[0]}")
        yield browser
        browser.close()


@pytest.fixture
def opened(chromium, address):
    """Return a function that opens the workbench, and what its browser complained of or asked of others."""
    contexts = []

    def opening(at=address, **given):
        context = chromium.new_context(viewport={"width": 1280, "height": 720}, reduced_motion="reduce", **given)
        context.set_default_timeout(PATIENT)
        contexts.append(context)
        page, told = context.new_page(), []
        host = at.partition("?")[0]
        page.on("console", lambda message: told.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: told.append(str(error)))
        page.on(
            "request",
            lambda request: None if request.url.startswith((host, "blob:", "data:")) else told.append(request.url),
        )
        page.on("dialog", lambda dialog: dialog.accept())
        page.goto(at)
        page.wait_for_selector(f"{MASS} b")
        return page, told

    yield opening
    for context in contexts:
        context.close()
