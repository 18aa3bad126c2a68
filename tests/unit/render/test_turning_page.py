"""The page on which a gearbox turns is one file, says what the sizing says, and carries the three.js that it names."""

import base64
import dataclasses
import hashlib
import json
import re
from pathlib import Path

import pytest

from gearwright.particulars import particulars
from gearwright.render import solids, uplot
from gearwright.render.pages.motion import turning, upright
from gearwright.shape import glb
from shipped_work import coarse, sized

ROOM = Path(solids.__file__).parent
OUTSIDE = re.compile(r"""(?:src|href|url)\s*[=(]\s*["']?(?!#|data:|["'])[\w/.:]+""")


def turned(sizing):
    """Return the page of a sizing with coarse solids."""
    return turning(particulars(sizing), coarse(sizing), glb(coarse(sizing)))


def page(name):
    """Return the page of a shipped design without the copy of three.js."""
    return turned(sized(name)).replace(solids.text("three.min.js"), "")


def block(text, name):
    """Return what a script element that is no script holds."""
    return re.search(rf'<script type="[^"]+" id="{name}">(.*?)</script>', text, re.DOTALL)[1]


def test_the_copy_of_three_is_the_one_that_is_named():
    known = solids.bundled()
    data = (ROOM / "three.min.js").read_bytes()
    assert hashlib.sha512(data).hexdigest() == known["sha512"]
    assert known["licence"] == "MIT" and b"SPDX-License-Identifier: MIT" in data
    assert b"</script" not in data
    tool = (Path(__file__).parents[3] / "tools" / "three.mjs").read_text(encoding="utf-8")
    assert f'THREE = "{known["version"]}"' in tool


def test_the_copy_of_three_goes_nowhere():
    found = set(re.findall(rb"https?://[\w./-]+", (ROOM / "three.min.js").read_bytes()))
    assert found <= {b"http://www.w3.org/1999/xhtml"}  # a name, not a place


@pytest.mark.parametrize("name", solids.OWN)
def test_own_scripts_are_short_and_write_no_markup(name):
    text = solids.text(name)
    assert len(text.splitlines()) <= 200
    assert not re.search(r"innerHTML|insertAdjacentHTML|document\.write|eval\(|new Function|fetch\(|import\(", text)


def test_the_page_loads_nothing_and_says_so_without_scripts_or_webgl():
    text = page("in-line-h2")
    assert not OUTSIDE.search(re.sub(r"<svg.*?</svg>", "", text, flags=re.DOTALL))
    assert "<noscript>" in text and "WebGL is missing" in text and "<svg" in text


def test_the_page_carries_the_solids_and_the_numbers_of_its_parts():
    sizing, text = sized("in-line-h2"), page("in-line-h2")
    assert base64.b64decode(block(text, "model"))[:4] == b"glTF"
    facts = json.loads(block(text, "facts"))
    sun = next(gear for gear in sizing.gears if gear.name == "first.sun")
    rows = dict(facts["parts"]["first.sun"]["rows"])
    assert rows["teeth"] == str(sun.teeth) and rows["material"] == sizing.design.rules("first").material
    worst = min(facts["parts"].values(), key=lambda part: part["margin"] or 9.0)["margin"]
    assert worst == pytest.approx(sizing.worst_margin, abs=1e-4)
    assert set(facts["labels"].values()) == set(facts["parts"])


def test_a_name_cannot_end_the_script_that_holds_it():
    sizing = sized("in-line-h2")
    design = sizing.design.model_copy(update={"name": "</script><b>"})
    text = turned(dataclasses.replace(sizing, design=design))
    assert "</script><b>" not in text


def test_a_rotor_stands_upright():
    assert upright(sized("ec120b")) == pytest.approx([0.0, 0.0, -1.0])
    assert upright(sized("in-line-h2")) == [0.0, 0.0, 1.0]


def test_the_copy_of_uplot_is_the_one_that_is_named_and_goes_nowhere():
    known, room = uplot.bundled(), Path(uplot.__file__).parent
    script, style = ((room / name).read_bytes() for name in ("uplot.min.js", "uplot.min.css"))
    assert hashlib.sha512(script).hexdigest() == known["sha512"]
    assert hashlib.sha512(style).hexdigest() == known["style_sha512"]
    assert known["licence"] == "MIT" and "MIT" in (room / "LICENSE.txt").read_text(encoding="utf-8")
    assert set(re.findall(rb"https?://[\w./-]+", script + style)) == {b"https://github.com/leeoniya/uPlot"}  # a comment
    assert b"</script" not in script and b"@import" not in style
