"""Every kind of page in a browser: quiet, alone, as narrow as a telephone, readable by all, with the JSON's numbers."""

import functools
import os
import re
import shutil

import pytest
from written import COMMANDS, EVERY_DESIGN, written

from gearwright.cli.printing import print_pdf
from gearwright.dynamics import modes
from gearwright.dynamics.assembly import assemble
from gearwright.dynamics.sharing import floating, sharing_problem, sharing_study
from gearwright.dynamics.vibration import critical_speeds
from gearwright.mission import durability
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.review import review_answer
from gearwright.render.answers.schema import plain
from gearwright.render.pages.flight import flight_page
from gearwright.render.pages.motion import sharing_page
from gearwright.render.pages.report import report, review_page
from gearwright.render.pages.studies import comparison
from gearwright.replays.colibri.pages import colibri_page
from gearwright.replays.pulvirenti.pages import thesis_page
from gearwright.reviews import review_of
from gearwright.shipped import shipped_design
from gearwright.sizing import governing_case
from gearwright.spec import read
from gearwright.study import compare
from shipped_work import flown, ground_review, sized

pytestmark = pytest.mark.extra("playwright", "axe_playwright_python")
WIDTHS = (1400, 820, 390)
SHOWN = ("in-line-h2", "ec120b")
KEY_NUMBERS = """[...document.querySelectorAll("dl.key > div")].map(box =>
  [box.querySelector("dt").textContent, (box.querySelector(".q") || {dataset: {}}).dataset.v])"""
"""Name and value of every key number."""
LEAVE_OUT_ROWS_THAT_ARE_ALIKE = r"""() => {
  const seen = {}, given = / (href|id|title|data-\w+)=("[^"]*"|[^\s>]*)/g;
  const bare = cell => cell.outerHTML.replace(given, " $1").replace(/>[^<]*/g, ">");
  for (const body of document.querySelectorAll("tbody")) for (const row of [...body.rows]) {
    const shapes = [row.className, ...[...row.cells].map((cell, place) => place + bare(cell))];
    if (row === body.rows[0] || shapes.some(shape => !(seen[shape] > 1)))
      shapes.forEach(shape => seen[shape] = (seen[shape] || 0) + 1);
    else row.remove();
  }
}"""
"""Of rows whose cells have the same elements, classes and attributes as two before, axe would say the same again."""
TOLERANCE = 5e-4
"""Half a unit of the fourth digit that a table shows."""


@functools.cache
def reviewed(name):
    """Return the review of a shipped design."""
    return ground_review() if name == "in-line-h2" else review_of(sized(name))


@functools.cache
def shared():
    """Return the page of a set of planets that share the load."""
    sizing = sized("single-planetary")
    return sharing_page(sizing, [sharing_study(sharing_problem(sizing))], floats=floating(sizing))


@functools.cache
def compared():
    """Return the page of two designs side by side."""
    names = ("in-line-h2", "mixed-h2")
    table = compare({name: read(shipped_design(name)) for name in names})
    return comparison(table, {name: sized(name) for name in names}, {name: reviewed(name) for name in names})


@functools.cache
def page_of_the_flight():
    """Return the page of the shipped flight."""
    flight = flown()
    return flight_page(flight, durability(flight), review_of(flight.sizing, flight))


@functools.cache
def moving_report():
    """Return the report of a shipped design with its modes and critical speeds."""
    sizing = sized("in-line-h2")
    system = assemble(sizing, governing_case(sizing))
    return report(sizing, modes=modes(system), system=system, campbell=critical_speeds(sizing), review=ground_review())


PAGES = {
    **{f"report of {name}": functools.partial(lambda name: report(sized(name), review=reviewed(name)), name)
       for name in SHOWN},
    **{f"review of {name}": functools.partial(lambda name: review_page(reviewed(name)), name) for name in SHOWN},
    "flight": page_of_the_flight, "sharing": shared, "comparison": compared,
    "colibri": colibri_page, "thesis": thesis_page,
    **{kind: functools.partial(written, kind) for kind in COMMANDS},
}  # fmt: skip
PRINTED = ("run of in-line-h2", "flight", "drawings")
"""Pages whose contrast on paper is looked at."""
BY_WIDTH = ["scrollable-region-focusable", "target-size", "nested-interactive", "link-in-text-block"]
"""Rules of axe that a width may break."""


@pytest.fixture(scope="module")
def chromium():
    """Yield a browser; skip with the reason where none is installed, and fail where one is demanded."""
    from playwright.sync_api import Error, sync_playwright

    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    with sync_playwright() as playwright:
        try:
            browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        except Error as reason:
            if os.environ.get("GEARWRIGHT_BROWSER") == "1":
                raise
            pytest.skip(f"no browser starts: {str(reason).splitlines()[0]}")
        yield browser
        browser.close()


@pytest.fixture
def opened(chromium, tmp_path):
    """Return a function that opens a page, and what its browser complained of and asked for."""
    contexts = []

    def opening(text, *, width=1400, scheme="light", scripts=True):
        file = tmp_path / "page.html"
        file.write_text(text, encoding="utf-8")
        context = chromium.new_context(
            viewport={"width": width, "height": 900}, color_scheme=scheme, java_script_enabled=scripts, offline=True,
            reduced_motion="reduce",
        )  # fmt: skip
        contexts.append(context)
        page, told = context.new_page(), []
        page.on("console", lambda message: told.append(message.text))
        page.on("pageerror", lambda error: told.append(str(error)))
        page.on("request", lambda request: told.append(request.url) if request.url[:4] not in ("file", "data") else 0)
        page.goto(file.as_uri())
        return page, told

    yield opening
    for context in contexts:
        context.close()


def wider(page):
    """Return by how much a page is wider than its window [px]."""
    return page.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")


@pytest.mark.parametrize("kind", PAGES)
def test_a_page_is_quiet_asks_for_nothing_and_fits_at_every_width(kind, opened):
    page, told = opened(PAGES[kind]())
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 900})
        assert wider(page) <= 0, width
    page.emulate_media(media="print")
    assert page.locator("nav").is_hidden()
    assert told == []


@pytest.mark.parametrize("kind", PAGES)
def test_links_lead_somewhere_and_no_id_stands_twice(kind):
    text = PAGES[kind]()
    ids = re.findall(r'\bid="([^"]+)"', text)
    assert len(ids) == len(set(ids))
    assert set(re.findall(r'href="#([^"]+)"', text)) <= set(ids)


@pytest.mark.parametrize(
    "kind",
    [kind for kind in PAGES if EVERY_DESIGN or not kind.endswith("ec120b")],  # the templates of in-line-h2
)
def test_nothing_serious_keeps_anyone_from_reading_a_page(kind, opened):
    """axe-core: no violation that it calls serious or critical, in light or dark; what is inside figures is theirs."""
    page, _ = opened(PAGES[kind](), width=820)
    page.evaluate("document.querySelectorAll('figure').forEach(figure => figure.scrollIntoView())")
    if not EVERY_DESIGN:
        page.evaluate(LEAVE_OUT_ROWS_THAT_ARE_ALIKE)
    assert serious(page) == []
    if kind not in PRINTED and not EVERY_DESIGN:  # the others are of the same parts
        return
    page.emulate_media(color_scheme="dark")
    assert serious(page, "color-contrast") == []
    for width in (1400, 390):
        page.set_viewport_size({"width": width, "height": 900})
        assert serious(page, *BY_WIDTH) == [], width
    if kind in PRINTED:
        page.emulate_media(media="print", color_scheme="light")
        assert serious(page, "color-contrast") == [], "print"


def serious(page, *rules):
    """Return what axe-core calls serious or critical: rule and first element."""
    from axe_playwright_python.sync_playwright import Axe

    options = {"resultTypes": ["violations"], **({"runOnly": list(rules)} if rules else {})}
    found = Axe().run(page, context={"exclude": [["figure svg"]]}, options=options).response["violations"]
    return [(one["id"], one["nodes"][0]["html"]) for one in found if one["impact"] in ("serious", "critical")]


@pytest.mark.parametrize("kind", PAGES)
def test_a_page_is_whole_without_scripts(kind, opened):
    page, _ = opened(PAGES[kind](), width=390, scripts=False)
    assert page.locator(".verdict").first.is_visible()
    assert page.locator("#units").is_hidden()


def test_units_switch_there_and_back_tables_sort_and_a_number_opens(opened):
    page, told = opened(PAGES["review of in-line-h2"]())
    mass = page.locator("dl.key .q[data-u=kg]").first
    pounds = float(mass.get_attribute("data-v")) / 0.45359237
    before = page.locator("main").inner_text()
    page.click("#units")
    assert float(mass.inner_text().removesuffix(" lb")) == pytest.approx(pounds, rel=TOLERANCE)
    page.click("#units")
    assert page.locator("main").inner_text() == before
    table = page.locator("table").first
    column = (
        table.locator("thead th")
        .all_inner_texts()
        .index(next(head for head in table.locator("thead th").all_inner_texts() if head.startswith("margin")))
    )
    table.locator("thead th").nth(column).locator("button").click()
    cells = [float(row) for row in table.locator(f"tbody td:nth-child({column + 1})").all_inner_texts()]
    assert cells == sorted(cells)
    cell = table.locator("tbody td.n").first
    cell.focus()
    page.keyboard.press("Enter")
    assert page.locator("dialog").is_visible()
    page.keyboard.press("Escape")
    assert page.locator("dialog").is_hidden()
    assert told == []


def test_a_number_of_the_report_opens_with_its_equation_and_what_the_file_says(opened):
    page, _ = opened(PAGES["report of in-line-h2"]())
    table = page.locator("table", has=page.locator("caption", has_text=re.compile("^Gears$"))).first
    named = table.locator("thead th").evaluate_all("heads => heads.findIndex(head => head.querySelector('a'))")
    table.locator(f"tbody td:nth-child({named + 1})").first.click()
    said = page.locator("dialog").inner_text()
    assert "equation" in said and "source" in said and "planetaries.first" in said


def test_a_part_of_the_power_flow_opens_with_its_rows_and_checks(opened):
    page, told = opened(PAGES["report of in-line-h2"]())
    word = page.locator("figure:not([id^=live-]) text.part", has_text=re.compile("^second$")).first
    word.focus()
    page.keyboard.press("Enter")
    said = page.locator("dialog").inner_text()
    ring = next(gear for gear in sized("in-line-h2").gears if gear.name == "second.ring")
    assert f"teeth {ring.teeth}" in said and "second.planet-ring: Checks, worst first" in said
    assert "planetaries.second.planets = 5" in said
    assert told == []


def test_a_curve_of_the_campbell_diagram_shows_the_shape_of_its_mode(opened):
    page, told = opened(moving_report(), width=1400)
    figure = page.locator("#live-campbell-0")
    figure.scroll_into_view_if_needed()
    over = figure.locator(".u-over").first
    over.wait_for()
    number = int(
        page.evaluate("""[...document.querySelectorAll("#drawn-modes-title")].map(title =>
        parseInt(title.textContent, 10))""")[0]
    )
    up = page.evaluate(
        """number => { const plot = livePlots.find(plot => plot.root.closest("figure").id === "live-campbell-0");
        const place = plot.series.findIndex(row => (row.label || "").startsWith(`mode ${number},`));
        return plot.valToPos(plot.data[place].find(value => value != null), "y"); }""",
        number,
    )
    over.hover(position={"x": 0.3 * over.bounding_box()["width"], "y": up})
    shown = figure.locator(".live-shape").first
    assert "moves most" in shown.inner_text() and shown.locator("svg").count() == 1
    assert f"{number}:" in shown.locator("svg text").first.text_content()
    assert told == []


def test_a_figure_answers_a_pointer_and_keys_zooms_and_is_still_on_paper(opened):
    page, told = opened(page_of_the_flight(), width=1400)
    figure = page.locator("figure[id^=live-]").first
    figure.scroll_into_view_if_needed()
    over = figure.locator(".u-over").nth(1)  # below the strip of phases
    over.wait_for()
    assert figure.locator("svg.gw-figure").bounding_box()["width"] <= 1.0
    over.hover()
    assert re.search(r"time.*\d", figure.locator(".live-at").first.inner_text())
    linked = {words for words in figure.locator(".live-at").all_inner_texts() if words}
    assert len(linked) == 1
    before = scale(page, figure)
    figure.locator(".live-area").nth(1).press("+")
    page.wait_for_timeout(100)
    assert scale(page, figure) == pytest.approx(before / 2.0)
    figure.locator(".live-area").nth(1).press("Escape")
    page.wait_for_timeout(100)
    assert scale(page, figure) == pytest.approx(before)
    page.emulate_media(media="print")
    assert figure.locator(".live-grid").is_hidden() and figure.locator("svg.gw-figure").bounding_box()["width"] > 300.0
    assert told == []


def test_zooming_into_a_front_leaves_the_rows_of_its_table_that_are_inside(opened):
    page, told = opened(written("front"))
    figure = page.locator("#live-front")
    figure.scroll_into_view_if_needed()
    figure.locator(".u-over").wait_for()
    table = page.locator("table", has=page.locator("caption", has_text=re.compile("^Pareto front$")))
    heads = [head.split("\n")[0] for head in table.locator("thead th").all_inner_texts()]
    column = next(k for k, head in enumerate(heads) if head.startswith("train as sized") and "+" not in head)
    masses = [float(text) for text in table.locator(f"tbody td:nth-child({column + 1})").all_inner_texts()]
    least = sorted(masses)[len(masses) // 2]
    page.evaluate(
        """most => { const plot = livePlots.find(plot => plot.root.closest("figure").id === "live-front");
        plot.setScale("x", { min: plot.scales.x.min, max: most }); }""",
        least,
    )
    page.wait_for_timeout(100)
    kept = [float(text) for text in table.locator(f"tbody tr:visible td:nth-child({column + 1})").all_inner_texts()]
    assert kept == [mass for mass in masses if mass <= least]
    assert f"{len(kept)} of {len(masses)} rows" in page.locator(".live-brush").inner_text()
    figure.locator(".live-area").press("Escape")
    page.wait_for_timeout(100)
    assert table.locator("tbody tr:visible").count() == len(masses)
    assert told == []


def test_a_stretch_of_a_parallel_axis_leaves_the_rows_lines_and_points_that_lie_in_it(opened):
    page, told = opened(written("front"))
    figure = page.locator("#live-lines")
    figure.scroll_into_view_if_needed()
    figure.locator("svg.live-parallel").wait_for()
    table = page.locator("table", has=page.locator("caption", has_text=re.compile("^Pareto front$")))
    speeds = [float(text) for text in table.locator("tbody td:nth-child(3)").all_inner_texts()]
    most = sorted(speeds)[len(speeds) // 2] + 0.1
    box = figure.locator("svg.live-parallel").bounding_box()
    page.mouse.move(box["x"] + 0.06 * box["width"], box["y"] + 0.3 * box["height"])
    page.mouse.down()
    page.mouse.move(box["x"] + 0.06 * box["width"], box["y"] + 0.6 * box["height"], steps=3)
    page.mouse.up()
    least, greatest = (float(figure.locator("input").nth(k).input_value()) for k in (0, 1))
    assert 3500.0 < least < greatest < 5500.0
    figure.locator("input").nth(0).fill("3000")
    figure.locator("input").nth(1).fill(f"{most}")
    figure.locator("input").nth(1).press("Enter")
    kept = [float(text) for text in table.locator("tbody tr:visible td:nth-child(3)").all_inner_texts()]
    assert kept == [speed for speed in speeds if speed <= most] and len(kept) < len(speeds)
    assert " lie in the stretches" in figure.locator(".live-stretch").inner_text()
    dim = page.evaluate("""() => { const plot = livePlots.find(plot => plot.root.closest("figure").id === "live-front");
        return [typeof plot.kept, document.querySelectorAll(".live-parallel .out").length]; }""")
    assert dim[0] == "function" and dim[1] > 10
    page.mouse.click(box["x"] + 0.06 * box["width"], box["y"] + 0.9 * box["height"])
    assert table.locator("tbody tr:visible").count() == len(speeds)
    assert told == []


def scale(page, figure):
    """Return the length of the first panel's x axis, in its unit."""
    plot = page.evaluate_handle(
        "id => livePlots.find(plot => plot.root.closest('figure').id === id)", figure.get_attribute("id")
    )
    return plot.evaluate("plot => plot.scales.x.max - plot.scales.x.min")


@pytest.mark.parametrize("name", SHOWN)
def test_the_head_has_the_numbers_of_the_json(name, opened):
    """The train as sized, and complete mass and worst margin of the review, as their commands print them."""
    page, _ = opened(PAGES[f"report of {name}"]())
    named = dict(page.evaluate(KEY_NUMBERS))
    sizing, judged = plain(size_answer(particulars(sized(name)))), plain(review_answer(reviewed(name)))
    mass = next(value for key, value in named.items() if key == "train as sized")
    assert float(mass) == pytest.approx(sizing["mass_kg"], rel=1e-6)
    margin = next(value for key, value in named.items() if key.startswith("worst margin"))
    assert float(margin) == pytest.approx(judged["margin"], rel=1e-6)
    whole = next(value for key, value in named.items() if key == "complete mass")
    assert float(whole) == pytest.approx(judged["complete_mass"]["total_kg"], rel=1e-6)


@pytest.mark.parametrize("name", ("wolfrom-reducer", "twin-engine-helicopter", "wind-turbine-5mw"))
def test_reports_of_other_architectures_fit_a_telephone(name, opened):
    page, told = opened(report(sized(name)), width=390)
    assert wider(page) <= 0
    assert told == []


def test_a_page_prints_as_pdf_with_bookmarks_and_tags(chromium, tmp_path):
    print_pdf(PAGES["review of in-line-h2"](), tmp_path / "review.pdf")
    made = (tmp_path / "review.pdf").read_bytes()
    assert made.startswith(b"%PDF-") and b"/StructTreeRoot" in made and b"/Outlines" in made
