"""Golden screenshots, compared loosely: each page's first window as a few grey cells, beside those of before.

`GEARWRIGHT_SCREENS=write pytest tests/browser/test_pages_look_alike.py` writes them anew.
"""

import base64
import json
import os
from pathlib import Path

import numpy as np
import pytest
from test_pages_in_a_browser import PAGES, chromium, opened  # noqa: F401 (fixtures)

pytestmark = pytest.mark.extra("playwright")
KEPT = Path(__file__).with_name("screens.json")
SHOWN = ("run of in-line-h2", "review of in-line-h2", "flight", "study", "mass", "drawings", "load sharing")
VIEWS = {"wide": (1400, "light"), "narrow": (390, "light"), "dark": (1400, "dark")}
CELLS = (36, 24)
"""Across and down."""
LIKE = 0.75
"""Least correlation of the grey of all cells [-]: other letters pass, a missing verdict, figure or style does not."""
SMALL = """async ([data, across, down]) => {
  const picture = new Image();
  picture.src = "data:image/png;base64," + data;
  await picture.decode();
  const canvas = new OffscreenCanvas(across, down), ink = canvas.getContext("2d");
  ink.imageSmoothingQuality = "high";
  ink.drawImage(picture, 0, 0, across, down);
  const { data: bytes } = ink.getImageData(0, 0, across, down);
  const grey = k => Math.round((bytes[4 * k] + bytes[4 * k + 1] + bytes[4 * k + 2]) / 3);
  return Array.from({ length: across * down }, (_, k) => grey(k));
}"""
"""Grey of each cell of a picture."""


def cells(page):
    """Return the grey of what a page's window shows, as hexadecimal digits."""
    picture = base64.b64encode(page.screenshot()).decode()
    return bytes(page.evaluate(SMALL, [picture, *CELLS])).hex()


def likeness(first, second):
    """Return the correlation of the grey of two pictures [-]."""
    greys = [np.frombuffer(bytes.fromhex(text), np.uint8).astype(float) for text in (first, second)]
    return float(np.corrcoef(*greys)[0, 1])


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("kind", SHOWN)
def test_a_page_looks_as_it_did(kind, view, opened):  # noqa: F811
    width, scheme = VIEWS[view]
    page, _ = opened(PAGES[kind](), width=width, scheme=scheme)
    page.wait_for_timeout(200)
    kept, found, name = json.loads(KEPT.read_text()) if KEPT.exists() else {}, cells(page), f"{kind}, {view}"
    if os.environ.get("GEARWRIGHT_SCREENS") == "write":
        KEPT.write_text(json.dumps(kept | {name: found}, indent=0, sort_keys=True) + "\n")
        return
    assert likeness(found, kept[name]) > LIKE


OTHER_LETTERS = "<style>body { font-family: 'Liberation Sans', Arial, sans-serif !important; }</style></head>"


def test_other_letters_pass_and_another_page_a_missing_verdict_or_no_styles_do_not(opened):  # noqa: F811
    kept, whole = json.loads(KEPT.read_text()), PAGES["flight"]()
    before = kept["flight, wide"]
    page, _ = opened(whole.replace("</head>", OTHER_LETTERS, 1))
    assert likeness(cells(page), before) > LIKE
    assert likeness(kept["study, wide"], before) < LIKE
    assert likeness(kept["flight, dark"], before) < LIKE
    page, _ = opened(whole.replace('<div class="verdict', '<div hidden class="verdict', 1))
    assert likeness(cells(page), before) < LIKE
    page, _ = opened(whole.replace("<style>", '<style media="print">', 1))
    assert likeness(cells(page), before) < LIKE
