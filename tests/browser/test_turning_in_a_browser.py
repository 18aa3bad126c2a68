"""The 3-D page of every shipped design in a browser: it draws, asks for nothing, turns at the speeds of its train."""

import math
import os
import shutil

import pytest

import gearwright as gw
from gearwright.particulars import particulars
from gearwright.render.pages.motion import turning
from gearwright.shape import glb, scene
from shipped_work import sized

pytestmark = pytest.mark.extra("playwright")
LOOK = """() => {
  const {gearbox, view, motion} = window.gearbox, found = {};
  const seconds = 1e-3 / motion.fastest();
  for (const name of gearbox.cases) {
    gearbox.pose(seconds, name);
    found[name] = {};
    for (const body of gearbox.bodies) {
      const turn = body.rest.clone().invert().multiply(body.frame.quaternion);
      found[name][body.name] = 2 * Math.atan2(turn.z, turn.w) / seconds;
    }
  }
  view.renderer.render(view.scene, view.camera);
  const copy = document.createElement("canvas"), from = view.canvas;
  [copy.width, copy.height] = [from.width, from.height];
  const pen = copy.getContext("2d");
  pen.drawImage(from, 0, 0);
  const dots = new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer), counts = new Map();
  for (const dot of dots) counts.set(dot, (counts.get(dot) || 0) + 1);
  return {found, colours: counts.size, empty: Math.max(...counts.values()) / dots.length};
}"""


@pytest.fixture(scope="module")
def chromium():
    """Yield a browser without a network; skip where none is installed."""
    from playwright.sync_api import Error, sync_playwright

    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(
                executable_path=path, args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
            )
        except Error as reason:
            pytest.skip(f"no browser starts: {str(reason).splitlines()[0]}")
        yield browser
        browser.close()


@pytest.fixture
def opened(chromium, tmp_path):
    """Return a function that opens the page of a design, and what its browser complained of and asked for."""
    context = chromium.new_context(viewport={"width": 900, "height": 700}, offline=True)

    def opening(name):
        file = tmp_path / f"{name}.html"
        built = scene(sized(name), detail="coarse")
        file.write_text(turning(particulars(sized(name)), built, glb(built)), encoding="utf-8")
        page, said, asked = context.new_page(), [], []
        page.on("console", lambda words: said.append(words.text) if words.type == "error" else None)
        page.on("pageerror", lambda reason: said.append(str(reason)))
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"file://{file}#still")
        page.wait_for_selector("body[data-ready=yes]", timeout=60_000)
        return page, said, [url for url in asked if not url.startswith(f"file://{file}")]

    yield opening
    context.close()


@pytest.mark.parametrize("name", gw.shipped_designs())
def test_every_gearbox_is_drawn_and_turns_as_its_train_does(name, opened):
    """Angles of the poses after a moment in which the fastest part turns a milliradian, over that moment."""
    page, said, asked = opened(name)
    seen = page.evaluate(LOOK)
    assert not said and not asked
    assert seen["colours"] > 50 and seen["empty"] < 0.98
    sizing = sized(name)
    for case, flow in sizing.flows.items():
        found = seen["found"][case]
        spins = {shaft.name: found[f"shaft {shaft.name}"] for shaft in sizing.shafts if f"shaft {shaft.name}" in found}
        bare = {shaft.name for shaft in sizing.shafts} - spins.keys()
        assert bare == ({"cage"} if name == "wolfrom-reducer" else set())  # an idle cage, which nothing drives
        fastest = max(abs(flow.speeds[shaft]) for shaft in spins)
        for shaft, spin in spins.items():  # angles of 1e-3 rad in double precision, kept in numbers of 1e-16
            assert math.isclose(abs(spin), abs(flow.speeds[shaft]), rel_tol=1e-6, abs_tol=1e-9 * fastest)


def test_colours_follow_part_margin_and_force(opened):
    page, said, _ = opened("ec120b")
    colours = {}
    for by in ("part", "margin", "force"):
        page.select_option("#colour", by)
        colours[by] = page.eval_on_selector_all("#parts .swatch", "all => all.map(one => one.style.background)")
        words = page.eval_on_selector_all("#parts .margin", "all => all.map(one => one.textContent)")
        assert page.is_visible("#legend") == (by == "margin") and page.is_visible("#burden") == (by == "force")
        assert any(word.endswith("N") for word in words) == (by == "force")
    assert len({tuple(found) for found in colours.values()}) == 3
    assert not said
