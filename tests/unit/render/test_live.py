"""What figures give to the script that makes them answer: every number within a step of the one that was drawn."""

import base64
import json
import re
import struct
import zlib

import numpy as np
import pytest

from gearwright.render import live, style as theme
from gearwright.render.pages.report import report
from gearwright.render.vector.live import GAP, STEPS, Numbers, live_panels


def unpacked(text):
    """Return the figures of a page's packed part and its arrays, as its script reads them."""
    whole = zlib.decompress(base64.b85decode(text))
    end = 4 + struct.unpack("<I", whole[:4])[0]
    given, planes = (
        json.loads(whole[4:end]),
        np.frombuffer(whole[end:], dtype=np.uint8).reshape(2, -1).astype(np.uint16),
    )
    steps, at, arrays = planes[0] + 256 * planes[1], 0, []
    for count, low, high, *power in given["ranges"]:
        place = np.cumsum(steps[at : at + count], dtype=np.uint16)
        values = np.where(place == GAP, np.nan, low + place / STEPS * (high - low))
        arrays.append(10.0**values if power else values)
        at += count
    assert at == len(steps)
    return given, arrays


def drawn(x, *rows, scale="linear"):
    """Return a figure with some curves."""
    figure = theme.sheet(100.0, 60.0)
    axes = figure.panel()
    axes.set_yscale(scale)
    for k, row in enumerate(rows):
        axes.plot(x, row, label=f"row {k}")
    return figure


def test_numbers_come_back_within_half_a_step_gaps_and_powers_of_ten_too():
    x = np.linspace(0.0, 1.0, 60)
    y = np.where(x > 0.5, np.nan, np.sin(9.0 * x))
    numbers = Numbers()
    panels = {
        "a": live_panels(drawn(x, y), numbers),
        "b": live_panels(drawn(x, np.exp(20.0 * x), scale="log"), numbers),
    }
    given, arrays = unpacked(numbers.packed(panels, ["script"]))
    curve, grown = (next(mark for mark in given["figures"][name][0]["m"] if mark["k"] == "line") for name in "ab")
    assert given["scripts"] == ["script"] and curve["n"] == "row 0" and curve["x"] == grown["x"]
    assert arrays[curve["x"]] == pytest.approx(x, abs=0.5 / STEPS)
    assert arrays[curve["y"]] == pytest.approx(y, abs=np.ptp(y[x <= 0.5]) / STEPS, nan_ok=True)
    assert np.log(arrays[grown["y"]]) == pytest.approx(20.0 * x, abs=20.0 / STEPS)


def test_long_curves_keep_every_peak_and_few_points():
    x = np.linspace(0.0, 1.0, 100_000)
    y = np.where(np.arange(100_000) == 54_321, 7.0, np.sin(3000.0 * x))
    numbers = Numbers()
    panels = live_panels(drawn(x, y), numbers)
    _, arrays = unpacked(numbers.packed({"a": panels}, []))
    kept = arrays[panels[0]["m"][0]["y"]]
    assert len(kept) < 4000 and np.nanmax(kept) == pytest.approx(7.0, abs=1e-3)


def test_what_no_pointer_can_follow_stays_still():
    turn = np.linspace(0.0, 6.0, 50)
    assert live_panels(drawn(np.cos(turn), np.sin(turn)), Numbers()) == []
    assert live_panels(drawn(np.array([0.0, 1.0]), np.array([0.0, 1.0])), Numbers()) == []


def test_a_report_carries_the_scripts_once_and_its_live_figures_by_name(in_line_h2, modal, run):
    page = report(in_line_h2, modes=modal, trace=run)
    given, _ = unpacked(re.search(r'id="live">(.*?)</script>', page)[1])
    assert "spectrum-rated" in given["figures"] and 'id="live-spectrum-rated"' in page
    assert "time" not in given["figures"], "its forces are 10 kN and rounding: an axis as narrow has no marks"
    assert [len(text) > 40_000 for text in given["scripts"]] == [True, False, False]
    assert all(f'id="live-{name}"' in page for name in given["figures"])


@pytest.mark.parametrize("name", live.OWN)
def test_own_scripts_write_no_markup_and_ask_for_nothing(name):
    assert not re.search(
        r"innerHTML|insertAdjacentHTML|document\.write|eval\(|new Function|fetch\(|import\(|https?:", live.text(name)
    )
