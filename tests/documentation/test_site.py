"""The documentation as a site: formulas, made pages, figures, numbers, and nothing from elsewhere."""

import functools
import importlib.util
import os
import re
import shutil
import sys
import threading
from html.parser import HTMLParser
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from gearwright.catalogue import materials
from gearwright.spec import Mission, Study, keys_of, records
from gearwright.spec.design import Design

ROOT = Path(__file__).parents[2]


SITE = pytest.mark.extra("mkdocs", "material", "mkdocstrings", "latex2mathml")


def beside(name):
    """Return a script of the documentation's folder, which is no package."""
    spec = importlib.util.spec_from_file_location(f"docs_{name}", ROOT / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


reference = beside("file_reference")


@pytest.fixture(scope="module")
def hooks():
    return beside("hooks")


@SITE
@pytest.mark.parametrize(
    "text",
    [
        "```sh\necho $A $B\n```",
        "    $ gearwright size\n    $ gearwright run",
        "`$x$`",
        "5 $ and 6 $",
        "a\\$b$",
        "~~~\n$x$\n~~~",
    ],
)
def test_code_and_prices_are_no_formulas(hooks, text):
    assert hooks.taken_out(text) == (text, [])


@SITE
def test_formulas_become_mathml_in_their_places(hooks):
    marked, formulas = hooks.taken_out("A $z_a$ and\n\n$$\\frac{1}{2}$$\n\nend")
    assert "$" not in marked
    html = hooks.put_in(marked, formulas)
    assert html.startswith("A <math") and html.endswith("end")
    assert re.search(r'<math[^>]*display="inline".*<msub>.*<math[^>]*display="block".*<mfrac>', html, re.DOTALL)


@pytest.mark.parametrize(
    ("model", "page"),
    [
        (Design, reference.design_file_markdown()),
        (Mission, reference.mission_file_markdown()),
        (Study, reference.study_file_markdown()),
    ],
)
def test_every_key_of_a_file_is_on_its_page(model, page):
    """One row for each field of each record, with the unit that is shown first and all others."""
    for record in records(model, {}):
        for name, info in record.model_fields.items():
            keys = [key for key, meant in keys_of(record).items() if meant.field in (name, info.alias)]
            rows = [line for line in page.splitlines() if line.startswith(f"| `{info.alias or name}")]
            assert any(all(f"`{key}`" in row or f"`{key[len(name) :]}`" in row for key in keys) for row in rows), name
            assert info.description.replace("|", "\\|") in page, f"{record.__name__}.{name}"


def test_links_within_a_page_lead_to_a_title():
    page = reference.design_file_markdown()
    titles = {re.sub(r"[^a-z_]", "", line.lower()) for line in page.splitlines() if line.startswith("## ")}
    assert set(re.findall(r"\]\(#([a-z_]+)\)", page)) <= titles


def test_defaults_and_bounds_are_in_the_unit_of_the_first_key():
    """α_n of 20°, from 14° to 30°; how many planets there are is free."""
    page = reference.design_file_markdown()
    assert "| `pressure_angle_deg` (`_rad`) | 20 ° | number; ≥ 14 °; ≤ 30 ° |" in page
    assert "| `planets` | none | whole number; ≥ 1; ≤ 12 |" in page
    assert "| `shafts` | **required** | list; at least 1 |" in page


@pytest.mark.parametrize(
    "name", sorted({**beside("figures").FIGURES, **beside("figures").SHEETS, **beside("figures").INPUTS})
)
def test_a_figure_is_what_the_tool_draws(name):
    """After a change of a figure: python docs/figures.py, and look at it."""
    assert (ROOT / "docs" / "figures" / f"{name}.svg").read_text(encoding="utf-8") == beside("figures").svg(name)


@pytest.mark.parametrize("name", sorted(beside("generate").PAGES))
def test_a_made_page_is_up_to_date(name):
    """After a change of a key, a material or a validation test: python docs/generate.py."""
    assert (ROOT / "docs" / name).read_text(encoding="utf-8") == beside("generate").PAGES[name]()


def test_every_material_stands_in_the_table_with_its_source():
    page = beside("generate").materials_markdown()
    for name, material in materials().items():
        section = page.partition(f"\n## {name}\n")[2].partition("\n## ")[0]
        assert f"\n| `{name}` |" in page, name
        assert material.source in section, name
        for words in (*material.sources.values(), *(f"estimated: {rule}" for rule in material.estimated.values())):
            assert words in section or words == "ISO 6336-5:2016, table 1", (name, words)
    assert "| `nitriding-steel-785` | 210 | 0.3 | 7850 | 785 | 980 | 600 | 650 ~ | nitrided MQ | 1250 ~ |" in page
    assert "| `structural-steel` | 210 | 0.3 | 7850 | 355 | 470 | – |" in page


def test_the_numbers_of_the_validation_page_are_within_their_tolerances():
    """The page refuses to be made otherwise; every test that it names exists."""
    checked = beside("checked")
    assert checked.checked_markdown().count("\n| ") > len(checked.CHECKED)
    for one in checked.CHECKED:
        assert (ROOT / "tests" / one.test).is_file(), one.test


class Requests(HTMLParser):
    """Collects what a browser fetches for a page."""

    def __init__(self):
        super().__init__()
        self.found = []

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if tag in ("img", "script", "iframe", "source"):
            self.found.append(given.get("src") or "")
        if tag == "link":
            self.found.append(given.get("href") or "")


@pytest.fixture(scope="module")
def site(tmp_path_factory, hooks):
    """Return the folder of the site, built as in continuous integration; mkdocs counts every warning."""
    folder = tmp_path_factory.mktemp("site")
    with pytest.MonkeyPatch.context() as given:
        given.setenv("NO_MKDOCS_2_WARNING", "1")
        given.chdir(ROOT)
        from mkdocs.commands.build import build
        from mkdocs.config import load_config

        build(load_config(str(ROOT / "mkdocs.yml"), site_dir=str(folder), strict=True))
    return folder


@SITE
def test_the_site_builds_without_warnings_and_asks_for_nothing_from_elsewhere(site):
    pages = list(site.rglob("*.html"))
    assert len(pages) > 20
    for page in pages:
        requests = Requests()
        requests.feed(page.read_text(encoding="utf-8"))
        assert not [each for each in requests.found if re.match(r"(https?:)?//", each)], page
        assert "FORMULA0HERE" not in page.read_text(encoding="utf-8")


@pytest.mark.extra("mkdocs", "material", "mkdocstrings", "latex2mathml", "playwright")
def test_the_search_finds_options_of_commands_and_abbreviations(site):
    """Typed into the site in a browser; a leading hyphen would say "without"."""
    from playwright.sync_api import sync_playwright

    path = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    if path is None and os.environ.get("GEARWRIGHT_BROWSER") != "1":
        pytest.skip("no browser is here")
    handler = functools.partial(SimpleHTTPRequestHandler, directory=str(site))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server, sync_playwright() as playwright:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"]).new_page()
        page.goto(f"http://127.0.0.1:{server.server_port}/404.html")
        for words, wanted in (
            ("--json", "how-to/scripts/"),
            ("FFT", "reference/figures/"),
            ("backlash_mm", "design-file/"),
        ):
            page.goto(f"http://127.0.0.1:{server.server_port}/404.html?q={words}")
            page.locator(f".md-search-result__link[href*='{wanted}']").first.wait_for(state="attached")
        server.shutdown()
