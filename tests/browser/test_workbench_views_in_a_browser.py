"""The views of motion, flight, studies and comparison, as their users have them."""

import re

import pytest
from workbench import MASS, choose, wait_for

import gearwright as gw
from gearwright.dynamics.assembly import assemble
from gearwright.render.figures.motion import mesh_frequencies
from shipped_work import sized

pytestmark = pytest.mark.extra("playwright", "axe_playwright_python", "starlette", "uvicorn", "tomlkit")
SHAKEN = """() => {
  const {gearbox, motion} = window.gearbox, found = {};
  motion.time = 0.75 / motion.slow;
  gearbox.pose(motion.time, motion.name);
  for (const body of gearbox.bodies) {
    const turn = body.rest.clone().invert().multiply(body.frame.quaternion);
    found[body.name] = 2 * Math.atan2(turn.z, turn.w);
  }
  return found;
}"""
POINTED = """() => {
  const {plot, criticals} = window.campbell, row = criticals[0], box = plot.over.getBoundingClientRect();
  const [x, y] = [plot.valToPos(row.speed_rpm, "x"), plot.valToPos(row.frequency_hz, "y")];
  return {order: row.order, mode: row.mode, x: box.left + x, y: box.top + y};
}"""
CAMERAS = """() => Object.values(window.twins).map(
  ({view}) => view.camera.position.clone().sub(view.orbit.target).toArray())"""


def test_a_run_is_drawn_its_orders_are_named_and_a_mode_moves_the_solids(opened):
    page, told = opened()
    choose(page, "single-planetary")
    page.click("nav a >> text=Dynamics")
    page.wait_for_selector("body[data-simulate]:not([data-simulate='']):not([data-campbell=''])")
    sizing = sized("single-planetary")
    assert int(page.get_attribute("#forces", "data-points")) > 500
    meeting = max(mesh_frequencies(sizing, page.input_value("#dynamics-case")).values())
    assert f"mesh {round(meeting)} Hz" in page.inner_text("#orders")
    page.click("#vibration-tabs button >> text=Campbell")
    page.wait_for_selector("body[data-campbell] #criticals tbody tr")
    page.wait_for_timeout(300)
    at = page.evaluate(POINTED)
    page.mouse.move(at["x"] + 1, at["y"] + 1)
    page.wait_for_selector(f"#campbell-read:has-text('mode {at['mode']} ')")
    assert at["order"] in page.inner_text("#campbell-read") and "margin" in page.inner_text("#campbell-read")
    page.click("#vibration-tabs button >> text=Modes")
    page.wait_for_selector("#modes tbody tr")
    row = page.locator("#modes tbody tr").nth(1)
    first = gw.modes(assemble(sizing)).frequency
    assert row.locator("td").first.inner_text() == f"{float(f'{first[first > 0][0]:.4g}'):g} Hz"
    row.locator("button").click()
    page.wait_for_selector("body[data-model]")
    page.wait_for_selector("#shaking:not([hidden])")
    turns = page.evaluate(SHAKEN)
    assert max(abs(turn) for turn in turns.values()) == pytest.approx(0.12, rel=1e-3)  # as it is shown at first
    page.click("#calm")
    assert max(abs(turn) for name, turn in page.evaluate(SHAKEN).items() if "ring" in name) == 0.0
    assert told == []


def test_a_mission_is_flown_and_what_is_wrong_in_it_is_marked(opened):
    page, told = opened()
    page.click("nav a >> text=Flight")
    page.wait_for_selector("#windows button")
    page.click("#fly-line button >> nth=0")
    page.wait_for_selector("body[data-flown]")
    flight = gw.fly(sized("in-line-h2"), gw.read_mission(gw.shipped_mission("thesis")))
    assert f"{float(f'{flight.fuel:.4g}'):g} kg" in page.inner_text("#flight-keys")
    assert page.locator("#timeline .plot").count() >= 6 and page.locator("#damage tbody tr").count() >= 4
    assert page.evaluate("document.getElementById('sankey').naturalWidth") > 100
    page.locator("#mission-editor .cm-line", has_text="[battery]").click()
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    page.keyboard.type("x")
    page.wait_for_selector("#mission-problems button")
    line = gw.shipped_mission("thesis").read_text(encoding="utf-8").split("[battery]")[0].count("\n") + 1
    assert f"line {line}" in page.inner_text("#mission-problems")
    assert [one for one in told if "422" not in one] == []


def test_a_brush_keeps_the_right_designs_and_a_row_opens_its_design(opened):
    page, told = opened()
    page.click("nav a >> text=Studies")
    page.wait_for_selector("#vary option", state="attached")
    for path in ("motors.electric.speed_rpm", "planetaries.second.planets"):
        page.select_option("#vary", path)
        page.click("#vary-add")
    page.fill("#journal", "kept.journal")
    page.click("#study-line button >> nth=0")
    page.wait_for_selector("body[data-studied]")
    total = int(page.inner_text("#kept").split()[0])  # few of the 128 cannot be built
    assert 100 < total <= 128 and page.inner_text("#kept") == f"{total} of {total} kept"
    page.fill("#limits input[data-column='planetaries.second.planets'] >> nth=0", "6")
    page.keyboard.press("Enter")
    page.wait_for_selector(f"#kept:not(:has-text('{total} of {total}'))")
    kept = int(page.inner_text("#kept").split()[0])
    assert total / 4 < kept < total / 2 and page.get_attribute("#scatter", "data-dots") == str(kept)
    column = page.locator("#study-rows tbody tr td:nth-child(3)").all_inner_texts()
    assert set(column) == {"6"}
    axis = page.locator("#parallel .grip").nth(0).bounding_box()
    page.mouse.move(axis["x"] + axis["width"] / 2, axis["y"] + 2)
    page.mouse.down()
    page.mouse.move(axis["x"] + axis["width"] / 2, axis["y"] + axis["height"] / 2, steps=4)
    page.mouse.up()
    half = [float(cell) for cell in page.locator("#study-rows tbody tr td:nth-child(2)").all_inner_texts()]
    assert min(half) >= 4499 and len(half) < kept  # the upper half of 4050 to 4950 rpm
    mass = page.locator("#study-rows tbody tr").first.locator("td").nth(2).inner_text()
    page.locator("#study-rows tbody button").first.click()
    page.wait_for_selector("#design-view:not([hidden])")
    wait_for(page, f"{MASS} b", mass)
    assert "planets = 6" in page.inner_text(".cm-content >> nth=0")
    assert page.locator(f"{MASS} .change.better").count() == 1
    assert told == []


def test_a_study_is_paused_and_gone_on_with(opened):
    page, told = opened()
    page.click("nav a >> text=Studies")
    page.wait_for_selector("#vary option", state="attached")
    page.select_option("#vary", "motors.electric.speed_rpm")
    page.click("#vary-add")
    page.fill("#journal", "paused.journal")
    page.click("#study-line button >> nth=0")
    page.wait_for_selector("#study-line progress[value]")
    page.click("#study-line button >> nth=1")
    page.wait_for_selector("body[data-paused]")
    assert "gearwright resume paused.journal" in page.inner_text("#study-words")
    assert 0 < int(page.get_attribute("body", "data-paused")) <= 128
    page.click("#resume-line button >> nth=0")
    page.wait_for_selector("body[data-studied]")
    assert int(page.inner_text("#kept").split()[0]) > 100
    assert told == []


def test_skeletons_and_solids_stand_beside_each_other_under_one_camera(opened):
    page, told = opened()
    page.click("nav a >> text=Compare")
    page.select_option("#beside-of", "designs/in-line-h1")
    page.wait_for_selector("#beside-told:has-text('in-line-h1')")
    page.wait_for_selector("body[data-twinnow][data-twinpinned]")
    assert page.locator(".schematic svg").count() == 2
    page.wait_for_timeout(300)
    page.focus("#solids-now")
    before = page.evaluate(CAMERAS)
    page.keyboard.press("ArrowLeft")
    after = page.evaluate(CAMERAS)
    for pinned, now in (before, after):
        assert pinned == pytest.approx(now, rel=1e-9)
    assert after != before
    cells = page.locator("#beside tr", has_text=re.compile(r"^mass")).first.locator("td").all_inner_texts()
    then, now = (float(cell.split()[0]) for cell in cells[:2])
    assert (then, now) == tuple(float(f"{sized(name).mass:.4g}") for name in ("in-line-h1", "in-line-h2"))
    assert told == []


def test_a_number_says_why_and_what_would_change_it(opened):
    page, told = opened()
    page.click(f"{MASS} button")
    page.wait_for_selector("#why .bars")
    words = page.inner_text("#why")
    assert "planetaries.second.planets" in words and "second.planet" in words and "What limits" in words
    text = gw.shipped_design("in-line-h2").read_text(encoding="utf-8")
    after = gw.size(gw.parse(text.replace("planets = 5", "planets = 6")))
    share = 100.0 * (1.0 - after.mass / sized("in-line-h2").mass)
    assert f"−{share:.1f} %" in words
    assert told == []


def test_a_plot_is_read_and_measured_from_the_keyboard(opened):
    page, told = opened()
    choose(page, "single-planetary")
    page.click("nav a >> text=Dynamics")
    page.wait_for_selector("#forces[data-points]")
    page.focus("#forces")
    for key in ("ArrowRight", "Enter", "Shift+ArrowRight"):
        page.keyboard.press(key)
    wide, words = page.evaluate("document.querySelector('#forces .u-over').clientWidth"), page.inner_text("#measured")
    assert wide > 100 and re.fullmatch(r"[\d.]+ ms to [\d.]+ ms: Δt = [\d.]+ ms, 1/Δt = [\d.]+ Hz", words)
    first, last, apart = (float(number) for number in re.findall(r"([\d.]+) ms", words))
    assert apart == pytest.approx(last - first, rel=1e-3) == pytest.approx(0.1 * 50.0, rel=0.02)  # a tenth of 50 ms
    assert told == []


def test_what_is_not_assessed_is_listed_and_what_closing_found_is_greyed_by_a_change(opened):
    page, told = opened()
    choose(page, "single-planetary")
    page.click("#review")
    page.wait_for_selector("#reviewed:has-text('pass')")
    review = gw.review(gw.read("single-planetary"))
    reasons = [check.why for check in review.checks if check.status == "not assessed"]
    assert page.locator("#unassessed li").count() == len(reasons) > 0
    page.click("#unassessed summary")
    assert all(why in page.inner_text("#unassessed") for why in reasons)
    assert page.locator("#margins li").count() == len(review.checks) - len(reasons)
    assert not [one for one in page.locator("#margins .value").all_inner_texts() if one in ("", "–")]
    page.click("#close-line button >> nth=0")
    page.wait_for_selector("body[data-closed]")
    assert page.locator("#unmet.old").count() == 0
    page.locator("[id^='entry:'][id$='speed_rpm']").first.press("ArrowUp")
    page.wait_for_selector("#unmet.old .since")
    page.click("#undo")
    page.wait_for_selector("#unmet:not(.old)")
    assert told == []
