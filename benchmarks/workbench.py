"""The workbench in a browser: how long start, a keystroke and a change of solids take, how large the page is.

python benchmarks/workbench.py [DESIGN] [--picture FILE.png]: needs the extras app and browser, and a Chromium.
"""

from __future__ import annotations

import argparse
import compileall
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import expect, sync_playwright

import gearwright

START = "from gearwright.cli import main; main()"
CHANGES = 12
MASS = "#keys dd[data-key=mass_kg] b"
WATCHED = """() => {
  window.seen = 0;
  const keys = document.getElementById("keys");
  new MutationObserver(() => { window.seen = performance.now(); }).observe(keys, {childList: true});
  window.solids = 0;
  const solids = new MutationObserver(() => { window.solids = performance.now(); });
  solids.observe(document.body, {attributeFilter: ["data-model"]});
}"""


FRAME = """() => {
  const {motion, view} = window.gearbox, begun = performance.now();
  for (let k = 0; k < 100; k++) {
    motion.time += 1e-5;
    motion.gearbox.pose(motion.time, motion.name);
    view.scene.updateMatrixWorld();
  }
  const posed = (performance.now() - begun) / 100, times = [];
  for (let k = 0; k < 9; k++) {
    const start = performance.now();
    view.renderer.render(view.scene, view.camera);
    times.push(performance.now() - start);
  }
  return posed + times.sort((a, b) => a - b)[4];
}"""
"""Script of a frame: pose, and the calls that hand it to the graphics processor, whose own time is not in it [ms]."""


@contextmanager
def served(*words: str) -> Iterator[str]:
    """Yield the address of a workbench."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    with tempfile.TemporaryDirectory() as folder:
        line = [sys.executable, "-c", START, "app", *words, "--no-browser", "--folder", folder]
        server = subprocess.Popen(line, stdout=subprocess.PIPE, text=True, env=kept)
        try:
            assert server.stdout is not None
            yield re.findall(r"http\S+", server.stdout.readline())[0]
        finally:
            server.terminate()
            server.wait()


def timed(page: Any, values: list[str], seen: str, selector: str) -> list[float]:
    """Return how long after each value the page shows what follows from it [ms]."""
    found = []
    for value in values:
        page.evaluate(f"window.{seen} = 0")
        box = page.locator(selector)
        begun = page.evaluate("performance.now()")
        box.evaluate("(box, value) => { box.value = value; box.dispatchEvent(new Event('input')); }", value)
        while not (end := page.evaluate(f"window.{seen}")):
            time.sleep(0.002)
        found.append(end - begun)
    return found


def main() -> None:
    """Print the times, or write a picture."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("design", nargs="?", default="in-line-h2")
    parser.add_argument("--picture")
    asked = parser.parse_args()
    compileall.compile_dir(Path(gearwright.__file__).parent, quiet=1)  # as an installation leaves it
    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    arguments = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=arguments)
        page = browser.new_page(viewport={"width": 1400, "height": 900})
        sizes: list[int] = []
        page.on("response", lambda answer: sizes.append(len(answer.body())) if "/static/" in answer.url else None)
        begun = time.perf_counter()
        with served(asked.design) as address:
            printed = time.perf_counter()
            page.goto(address)
            expect(page.locator(MASS)).not_to_be_empty(timeout=60_000)
            first = time.perf_counter()
            page.wait_for_selector("#flow svg")
            if asked.picture:
                page.locator("#margins button").nth(1).click()
                page.wait_for_selector("#why tbody")
                page.wait_for_timeout(1000)
                page.screenshot(path=asked.picture)
                return
            page.evaluate(WATCHED)
            box = "[id^='entry:'][id$='speed_rpm']"
            speed = float(page.locator(box).first.input_value())
            box = f"[id='{page.locator(box).first.get_attribute('id')}']"
            values = [str(round(speed * (1 + 0.002 * (k + 1)), 2)) for k in range(CHANGES)]
            strokes = timed(page, values, "seen", box)
            page.click("nav a >> text=Gearbox")
            page.wait_for_selector("body[data-model]", timeout=60_000)
            swaps = timed(page, [str(round(speed * (1 - 0.002 * (k + 1)), 2)) for k in range(6)], "solids", box)
            drawn = page.evaluate(
                "(({calls, triangles}) => ({calls, triangles}))(window.gearbox.view.renderer.info.render)"
            )
            frame = page.evaluate(FRAME)
        browser.close()
    print(f"{asked.design}: address after {printed - begun:.2f} s, first numbers after {first - begun:.2f} s")
    print(f"change to new numbers, {CHANGES} times: {spread(strokes)}")
    print(f"change to new solids, {len(swaps)} times: {spread(swaps)}")
    size = sum(sizes) / 1e6
    print(f"page: {size:.2f} MB of scripts and styles; {drawn['calls']} draw calls, {drawn['triangles']} triangles")
    print(f"script of a frame: {frame:.2f} ms")


def spread(times: list[float]) -> str:
    """Return what is usual and what is longest."""
    return f"median {statistics.median(times):.0f} ms, longest {max(times):.0f} ms"


if __name__ == "__main__":
    main()
