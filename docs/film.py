"""The pictures of the workbench: python docs/film.py writes docs/figures/workbench.png and workbench.gif.

Needs the extras app and browser, a Chromium and ffmpeg. Every picture is posed, so that a slow machine shows the same.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
from workbench import served

WHERE = Path(__file__).parent / "figures"
RATE = 5
"""Pictures a second."""
WIDE = 1280, 720
LOOK = "scale=900:-1:flags=lanczos"
SPEED = "[id='entry:motors/electric/speed_rpm']"
TURNED = (
    "turn => { const {gearbox, motion, view} = window.gearbox; motion.time += turn / motion.fastest(); motion.show(); }"
)
CHANGED = "text => document.getElementById('keys').innerText !== text"
DRAG = "(box, value) => { box.value = value; box.dispatchEvent(new Event('input')); }"


class Film:
    """Pictures in a row."""

    def __init__(self, page: Any, folder: Path) -> None:
        self.page, self.folder, self.count = page, folder, 0

    def take(self, times: int = 1) -> None:
        """Take one picture and show it for some time."""
        first = self.folder / f"{self.count:04}.png"
        self.page.screenshot(path=first)
        for k in range(1, times):
            shutil.copy(first, self.folder / f"{self.count + k:04}.png")
        self.count += times


def scenes(page: Any) -> Iterator[int]:
    """Yield how long each picture is shown, while the page is led through a design."""
    page.wait_for_selector("#flow svg")
    yield 3
    slider = page.locator(f"{SPEED} ~ input[type=range]")
    for speed in (4400, 4300, 4200, 4100):
        before = page.inner_text("#keys")
        slider.evaluate(DRAG, speed)
        page.wait_for_function(CHANGED, arg=before)
        yield 1
    before = page.inner_text("#keys")
    page.locator("[id='entry:planetaries/second/planets']").fill("6")
    page.wait_for_function(CHANGED, arg=before)
    page.wait_for_timeout(500)
    yield 3
    page.click("#keys dd[data-key=mass_kg] button")
    page.wait_for_selector("#why .bars")
    yield 5
    page.click("nav a >> text=Gearbox")
    page.wait_for_selector("body[data-model]")
    page.wait_for_timeout(1500)
    for _ in range(12):
        page.evaluate(TURNED, 0.12)
        page.wait_for_timeout(400)
        yield 1
    page.click("nav a >> text=Dynamics")
    page.wait_for_selector("body[data-simulate][data-campbell]")
    page.wait_for_timeout(800)
    yield 4
    page.click("#vibration-tabs button >> text=Campbell")
    page.wait_for_timeout(800)
    yield 4
    page.click("nav a >> text=Studies")
    for path in ("motors.electric.speed_rpm", "planetaries.first.planets"):
        page.select_option("#vary", path)
        page.click("#vary-add")
    page.click("#study-line button >> nth=0")
    page.wait_for_selector("body[data-studied]")
    page.wait_for_timeout(500)
    yield 3
    page.fill("#limits input[data-column='planetaries.first.planets'] >> nth=0", "4")
    page.keyboard.press("Enter")
    page.wait_for_timeout(500)
    yield 5


def main() -> None:
    """Write the picture and the film."""
    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    arguments = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with sync_playwright() as playwright, served("in-line-h2") as address, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=path, args=arguments)
        page = browser.new_page(viewport=dict(zip(("width", "height"), WIDE, strict=True)), bypass_csp=True)
        page.set_default_timeout(120_000)
        page.goto(address)
        film = Film(page, Path(folder))
        for k, times in enumerate(scenes(page)):
            film.take(times)
            if k == 6:
                page.screenshot(path=WHERE / "workbench.png")
        browser.close()
        made = WHERE / "workbench.gif"
        look = f"{LOOK},split[a][b];[a]palettegen=max_colors=64:stats_mode=diff[p];[b][p]paletteuse=dither=none"
        given = ["-framerate", str(RATE), "-i", f"{folder}/%04d.png", "-vf", look]
        line = ["ffmpeg", "-y", "-v", "error", *given, str(made)]
        subprocess.run(line, check=True)
        print(f"{made}: {film.count / RATE:.1f} s, {made.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
