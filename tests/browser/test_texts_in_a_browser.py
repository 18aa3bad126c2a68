"""Texts of the workbench: what undo takes back, what belongs to which file, what a window keeps, what is typed."""

import time

import pytest
from workbench import MASS, ended, mass_of, started, wait_for

import gearwright as gw

pytestmark = pytest.mark.extra("playwright", "axe_playwright_python", "starlette", "uvicorn", "tomlkit")
SPEED = "[id='entry:turbines/gas-turbine/speed_rpm']"
SLIDER = f"{SPEED} ~ input[type=range]"
TEXT = gw.shipped_design("in-line-h2").read_text(encoding="utf-8")
THUMB = """one => {
  const box = one.getBoundingClientRect();
  return box.left + 8 + (box.width - 16) * (one.value - one.min) / (one.max - one.min);
}"""
MISSION = gw.shipped_mission("thesis").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    """A server whose folder has two designs and two missions."""
    folder = tmp_path_factory.mktemp("files")
    for name, text in {
        "a.toml": TEXT,
        "b.toml": TEXT.replace("20000", "22000"),
        "out.toml": MISSION,
        "back.toml": MISSION.replace("schema = 1", "schema = 1  # back", 1),
    }.items():
        (folder / name).write_text(text, encoding="utf-8")
    server, at = started(folder)
    yield at, folder
    ended(server)


def take(page, name, speed):
    """Open a file of the folder, and wait until it is sized."""
    page.select_option("#design", f"file:{name}")
    page.wait_for_selector(f".cm-line:has-text('speed_rpm = {speed}')")
    wait_for(page, MASS + " b", mass_of(TEXT.replace("20000", str(speed))))


def shown(page):
    return page.inner_text("#editor .cm-content")


def late(route):
    """Hold up what changes a text or a file."""
    if route.request.method != "GET":
        time.sleep(0.7)
    route.continue_()


def test_undo_ends_where_a_file_was_opened_and_never_brings_the_text_of_another(opened, desk):
    at, folder = desk
    before = (folder / "b.toml").read_text(encoding="utf-8")
    page, told = opened(at)
    assert page.is_disabled("#undo") and page.is_disabled("#redo")
    take(page, "a.toml", 20000)
    page.locator(SPEED).fill("20500")
    wait_for(page, MASS + " b", mass_of(TEXT.replace("20000", "20500")))
    assert page.is_enabled("#undo") and page.is_disabled("#redo")
    take(page, "b.toml", 22000)
    assert page.is_disabled("#undo") and page.is_disabled("#redo") and page.is_disabled("#save")
    page.click("#editor .cm-content")
    page.keyboard.press("Control+z")
    assert "speed_rpm = 22000" in shown(page)
    page.locator(SPEED).fill("22500")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22500')")
    page.click("#undo")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22000')")
    assert page.is_disabled("#undo") and page.is_enabled("#redo") and page.is_disabled("#save")
    page.select_option("#design", "file:a.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20500')")  # as it was left
    page.click("#undo")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20000')")
    assert page.is_disabled("#undo") and page.is_disabled("#save")
    assert (folder / "b.toml").read_text(encoding="utf-8") == before
    assert told == []


def test_what_is_saved_or_changed_late_stays_with_its_own_file(opened, desk):
    """The answers to a save and to a change of the form come after another file was opened."""
    at, folder = desk
    page, told = opened(at)
    take(page, "a.toml", 20000)
    for address in ("**/api/files/a.toml", "**/api/edit"):
        page.route(address, late)
    page.locator(SPEED).fill("20100")
    page.select_option("#design", "file:b.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22000')")
    page.wait_for_timeout(1000)
    assert "speed_rpm = 22000" in shown(page) and page.is_disabled("#save")
    page.select_option("#design", "file:a.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20000')")
    page.locator("#editor .cm-line", has_text="speed_rpm = 20000").click()
    page.keyboard.press("End")
    page.keyboard.type(" # mine")
    page.keyboard.press("Control+s")
    page.select_option("#design", "file:b.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22000')")
    wait_for(page, "#status", "saved a.toml")
    assert page.input_value("#design") == "file:b.toml" and page.is_disabled("#save")
    assert "22000" in (folder / "b.toml").read_text(encoding="utf-8")
    assert "# mine" in (folder / "a.toml").read_text(encoding="utf-8")
    (folder / "a.toml").write_text(TEXT, encoding="utf-8")
    assert told == []


def test_missions_have_histories_and_drafts_of_their_own(opened, desk):
    at, _ = desk
    page, told = opened(at)
    page.click("nav a >> text=Flight")
    page.wait_for_selector("#mission option[value='file:out.toml']", state="attached")
    page.select_option("#mission", "file:out.toml")
    mission = page.locator("#mission-editor .cm-content")
    page.wait_for_selector("#windows button")
    page.locator("#mission-editor .cm-line", has_text="schema = 1").first.click()
    page.keyboard.press("End")
    page.keyboard.type(" # out")
    page.select_option("#mission", "file:back.toml")
    page.wait_for_selector("#mission-editor .cm-line:has-text('# back')")
    mission.click()
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+Home")
    page.wait_for_selector("#mission-editor .cm-line:has-text('schema = 1')")
    assert "# back" in mission.inner_text() and "# out" not in mission.inner_text()
    page.select_option("#mission", "file:out.toml")
    page.wait_for_selector("#mission-editor .cm-line:has-text('# out')")
    assert told == []


def test_studies_have_histories_and_drafts_of_their_own(opened):
    page, told = opened()
    page.click("nav a >> text=Studies")
    page.wait_for_selector("#vary option", state="attached")
    page.select_option("#vary", "motors.electric.speed_rpm")
    page.click("#vary-add")
    study = page.locator("#study-editor .cm-content")
    assert "motors.electric.speed_rpm" in study.inner_text()
    name = page.locator("#study option").nth(1).get_attribute("value")
    page.select_option("#study", name)
    page.wait_for_selector("#study-editor:not(:has-text('motors.electric.speed_rpm'))")
    study.click()
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+Home")
    assert "What makes it lighter" not in study.inner_text()
    page.select_option("#study", "")
    page.wait_for_selector("#study-editor .cm-line:has-text('motors.electric.speed_rpm')")
    assert told == []


def test_what_was_found_for_one_design_is_not_written_under_the_name_of_another(opened, desk):
    """A variant of another design, as of a study, is opened as that design; what was closed goes with its file."""
    at, _ = desk
    page, told = opened(at)
    take(page, "a.toml", 20000)
    page.click("#close-line button >> nth=0")
    page.wait_for_selector("body[data-closed] #unmet button")
    page.select_option("#design", "file:b.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22000')")
    assert page.locator("#unmet button").count() == 0
    other = (
        gw.shipped_design("in-line-h1").read_text(encoding="utf-8").replace("schema = 1", "schema = 1  # variant", 1)
    )
    page.evaluate("async text => (await import('/static/files.js')).offered(text, 'a variant', 'in-line-h1')", other)
    page.wait_for_selector(".cm-line:has-text('# variant')")
    assert page.input_value("#design") == "shipped:in-line-h1" and page.is_enabled("#undo")
    page.select_option("#design", "file:b.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22000')")
    assert "# variant" not in shown(page) and page.is_disabled("#save")
    assert told == []


def test_a_number_that_is_cleared_keeps_its_box_until_it_is_left(opened):
    page, told = opened()
    box = page.locator(SPEED)
    box.click()
    box.fill("")
    page.wait_for_timeout(800)
    assert page.evaluate("document.activeElement.id") == "entry:turbines/gas-turbine/speed_rpm"
    assert "empty" in box.get_attribute("class") and "speed_rpm = 20000" in shown(page)
    page.keyboard.type("21000")
    wait_for(page, MASS + " b", mass_of(TEXT.replace("20000", "21000")))
    assert "empty" not in (box.get_attribute("class") or "") and box.input_value() == "21000"
    box.fill("")
    page.wait_for_timeout(300)
    assert "speed_rpm = 21000" in shown(page)
    page.keyboard.press("Tab")
    page.wait_for_selector("body.stale")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 21000')", state="detached")
    page.click("#undo")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 21000')")
    assert [one for one in told if "422" not in one] == []


@pytest.mark.parametrize("wrong", ["abc", "1e400", "12 000", "--3"])
def test_what_is_no_number_is_marked_and_stays_out_of_the_text(opened, wrong):
    page, told = opened()
    box = page.locator(SPEED)
    box.fill(wrong)
    assert box.get_attribute("aria-invalid") == "true" and wrong in page.inner_text("#help")
    page.wait_for_timeout(300)
    assert "speed_rpm = 20000" in shown(page) and box.input_value() == wrong
    page.keyboard.press("Tab")
    assert box.input_value() == "20000" and box.get_attribute("aria-invalid") == "false"
    assert told == []


def test_one_drag_of_a_slider_is_one_step_of_undo(opened):
    page, told = opened()
    place = page.locator(SLIDER).bounding_box()
    y = place["y"] + place["height"] / 2
    for end in (0.55, 0.6):
        page.mouse.move(page.locator(SLIDER).evaluate(THUMB), y)
        page.mouse.down()
        page.mouse.move(place["x"] + end * place["width"], y, steps=40)
        page.wait_for_timeout(1200)  # a hand may rest
        page.mouse.move(place["x"] + (end + 0.2) * place["width"], y, steps=20)
        page.mouse.up()
        page.wait_for_timeout(400)
        if end == 0.55:
            first = page.locator(SPEED).input_value()
    assert page.locator(SPEED).input_value() != first != "20000"
    page.click("#undo")
    page.wait_for_selector(f".cm-line:has-text('speed_rpm = {first}')")
    page.click("#undo")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20000')")
    assert page.is_disabled("#undo")
    page.click("#redo")
    page.wait_for_selector(f".cm-line:has-text('speed_rpm = {first}')")
    assert told == []


def test_an_arrow_key_that_is_held_is_one_step_of_undo(opened):
    page, told = opened()
    for place in (SPEED, SLIDER):
        page.focus(place)
        for _ in range(12):
            page.keyboard.down("ArrowUp")
            page.wait_for_timeout(60)
        page.keyboard.up("ArrowUp")
        page.wait_for_selector(".cm-line:has-text('speed_rpm = 20000')", state="detached")
        page.wait_for_timeout(400)
        page.click("#undo")
        page.wait_for_selector(".cm-line:has-text('speed_rpm = 20000')")
        assert page.is_disabled("#undo"), place
    assert told == []


def test_a_reload_finds_every_file_as_it_was_left(opened, desk):
    at, folder = desk
    page, told = opened(at)
    take(page, "a.toml", 20000)
    page.locator(SPEED).fill("20700")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20700')")
    take(page, "b.toml", 22000)
    page.locator(SPEED).fill("22700")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22700')")
    page.reload()
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 22700')")
    assert page.input_value("#design") == "file:b.toml" and page.is_enabled("#save")
    page.select_option("#design", "file:a.toml")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20700')")
    (folder / "a.toml").write_text(TEXT.replace("20000", "19000"), encoding="utf-8")
    page.reload()
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 20700')")
    page.wait_for_selector("#save:enabled")
    page.keyboard.press("Control+s")  # made from a text that is no longer there
    page.wait_for_selector("#status:has-text('changed')")
    assert "19000" in (folder / "a.toml").read_text(encoding="utf-8")
    page.click("#undo")
    page.wait_for_selector(".cm-line:has-text('speed_rpm = 19000')")
    assert page.is_disabled("#save")
    (folder / "a.toml").write_text(TEXT, encoding="utf-8")
    assert [one for one in told if "412" not in one] == []
