import re
from dataclasses import replace

import pytest
from drawn_designs import MIXED, sized

from gearwright.dynamics import Outputs, simulate
from gearwright.dynamics.assembly import assemble
from gearwright.render.pages.page import Stamp, hash_of, symbols
from gearwright.render.pages.report import report
from gearwright.render.style import mathml
from gearwright.render.words.design_file import entries
from html_checks import PACKED, Balance


class Outline(Balance):
    """Checks that tags close in order; collects ids, links and headings."""

    def __init__(self) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.tags: set[str] = set()
        self.headings: list[str] = []

    def handle_starttag(self, tag, attrs) -> None:
        self.tags.add(tag)
        self.ids += [value for name, value in attrs if name == "id"]
        self.links += [value for name, value in attrs if name in ("href", "src", "xlink:href")]
        super().handle_starttag(tag, attrs)

    def handle_data(self, data) -> None:
        if self.stack and self.stack[-1] == "h2":
            self.headings.append(data)


@pytest.fixture(scope="module")
def page(in_line_h2, modal, run) -> str:
    return report(in_line_h2, modes=modal, trace=run)


@pytest.fixture(scope="module")
def outline(page) -> Outline:
    parsed = Outline()
    parsed.feed(page)
    return parsed


def test_the_same_input_gives_the_same_bytes(page, in_line_h2, modal, run) -> None:
    assert report(in_line_h2, modes=modal, trace=run) == page


def test_the_page_asks_for_nothing_from_outside(page, outline) -> None:
    assert not {"link", "img", "iframe", "object"} & outline.tags
    page = PACKED.sub("", page)
    assert not re.search(r"<script[^>]|fetch\(|XMLHttpRequest|innerHTML", page)
    assert all(link.startswith("#") for link in outline.links)
    assert "@import" not in page
    assert all(address.startswith("#") for address in re.findall(r"url\(([^)]*)\)", page))


def test_tags_close_ids_are_unique_and_links_lead_somewhere(outline) -> None:
    assert outline.stack == []
    assert len(outline.ids) == len(set(outline.ids))
    assert {link[1:] for link in outline.links} <= set(outline.ids)


def test_chapters_come_in_the_order_that_engineers_expect(outline) -> None:
    assert outline.headings == [
        "Summary", "Architecture and power flow", "Gears", "Meshes: forces, stresses and margins",
        "Shafts, carriers and machines", "Losses", "Materials", "Mass and envelope", "Places in space",
        "Natural modes", "Dynamic response, case rated", "Assumptions", "Inputs: the design file", "Defaults",
        "Formulas and sources",
    ]  # fmt: skip


def test_modes_and_dynamics_are_left_out_where_there_are_none(in_line_h2) -> None:
    page = report(in_line_h2)
    assert "Natural modes" not in page
    assert "Dynamic response" not in page


def test_formulas_stand_with_their_sources(page) -> None:
    assert mathml("b = λ m_n, or the least that serves") in page
    assert "backup ratio" not in page  # the rim is no column of the report: its formula is not either
    assert "ISO 21771:2007" in page


def test_what_the_user_writes_cannot_become_markup() -> None:
    page = report(sized(MIXED.replace("Mixed hybrid", "<script>alert(1)</script>")))
    assert "<script>alert" not in page
    assert "&lt;script&gt;" in page


def test_a_margin_below_one_is_the_first_thing_that_the_report_says() -> None:
    page = report(sized(MIXED + '[overrides]\n"lay.diameter_mm" = 20\n'))
    warning = page.index("it should be 1 or more")
    assert warning < page.index("<figure")
    assert "Given in place of computed values (user&#39;s design file): lay.diameter." in page


def test_inputs_tell_what_the_file_states_from_what_is_default(in_line_h2) -> None:
    found = {entry.path: entry for entry in entries(in_line_h2.design)}
    power, safety = found["turbines.gas-turbine.power"], found["gears.bending_safety"]
    assert (power.value, power.is_given) == ("1046 kW", True)
    assert (safety.value, safety.is_given) == ("2.5", False)
    assert found["cases.cruise.electric.power"].value == "470.7 kW"
    assert "planetaries.first.sun_teeth" not in found  # left open: gearwright chose


def test_symbols_get_their_subscripts() -> None:
    assert symbols("m_n³ = F_t / R_p0.2 < 1") == "m<sub>n</sub>³ = F<sub>t</sub> / R<sub>p0.2</sub> &lt; 1"


def test_keys_of_files_are_no_symbols() -> None:
    assert symbols("gears.bending_safety, machine_speed, dynamics.K_v, and `K_V` of K_V") == (
        "gears.bending_safety, machine_speed, dynamics.K_v, and <code>K_V</code> of K<sub>V</sub>"
    )


def test_the_head_says_the_worst_and_its_numbers_before_all_else(page, in_line_h2) -> None:
    said = page.index('<div class="verdict open">')
    assert said < page.index('<dl class="key">') < page.index("<nav") < page.index("<h2")
    assert hash_of(in_line_h2.design) in page


def test_every_sentence_and_figure_of_a_run_names_its_case(in_line_h2) -> None:
    """Two runs in one report: of each its chapter, its figures and what it leaves of the margins."""
    runs = {case: simulate(assemble(in_line_h2, case), 0.02, outputs=Outputs(start=0.005)) for case in in_line_h2.flows}
    page = report(in_line_h2, trace=runs["rated"], others={"cruise": runs["cruise"]})
    for case in ("rated", "cruise"):
        assert f"Dynamic response, case {case}" in page
        assert f"Forces and torques against time, case {case}." in page
        assert f"second.planet-ring, case {case}: with the simulated peak force" in page
    assert ": with the simulated peak force" not in re.sub(r", case \w+: with the simulated peak force", "", page)


def test_date_and_lines_come_from_the_caller_alone(in_line_h2) -> None:
    stamp = Stamp("24 November 2026", {"turbines.gas-turbine.power_kw": 17})
    stamped, bare = report(in_line_h2, stamp=stamp), report(in_line_h2)
    assert "24 November 2026" in stamped and "24 November 2026" not in bare
    row = re.search(r"<tr><td><code>turbines.gas-turbine.power</code>.*", stamped)
    assert "<td class=n>17<td" in row[0]


def test_author_and_revision_stand_in_the_head_where_the_design_states_them(in_line_h2) -> None:
    stated = in_line_h2.design.model_copy(update={"author": "A. <Smith>", "revision": "C"})
    page = report(replace(in_line_h2, design=stated))
    assert "<span>revision C</span>" in page and "by A. &lt;Smith&gt;" in page
    assert "<span>revision" not in report(in_line_h2)


def test_the_hash_follows_what_is_stated_and_not_its_order(in_line_h2) -> None:
    design = in_line_h2.design
    assert hash_of(design) == hash_of(design.model_copy())
    assert hash_of(design) != hash_of(design.model_copy(update={"name": "another"}))
