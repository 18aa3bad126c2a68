"""Tables, rows, figures and page of what gearboxes weigh."""

import csv
import io
from html.parser import HTMLParser

import pytest
from rich.console import Console

from gearwright.render.answers.schema import plain
from gearwright.render.answers.weights import mass_answer
from gearwright.render.figures.masses import (
    figure_densities,
    figure_mass_over_power,
    figure_methods,
    fit_of_all_rows,
    turboprop_fit,
)
from gearwright.render.pages.weights import weights_page
from gearwright.render.tables import weights, weights as weights_data
from gearwright.render.vector.figure import Curve, Dots
from gearwright.units import RPM
from gearwright.weights import Requirement, StatedMass, checked_engines, compare, scores

PW127 = Requirement(2051e3, 20204 * RPM, 1212 * RPM)
STATED = StatedMass(190.0, "weighed, <maintenance> manual", overridden=True)


@pytest.fixture(scope="module")
def found():
    return compare(PW127, stated=STATED)


@pytest.fixture(scope="module")
def page(found):
    return weights_page(found)


def printed(renderable, width=150):
    console = Console(width=width, file=io.StringIO(), record=True)
    console.print(renderable)
    return console.export_text()


def test_the_table_shows_every_method_its_mass_and_the_band(found):
    text = printed(weights.comparison_table(found))
    for expected in ("136.5 kg", "131.8 kg", "183.5 kg", "224.0 kg", "114.6 kg", "87.8 kg", "70.1 kg", "223.2 kg"):
        assert expected in text
    assert "110 to 170 kg" in text
    assert "89 to 211 kg" in text


def test_a_method_out_of_range_shows_words_in_place_of_a_mass(found):
    line = next(
        one for one in printed(weights.comparison_table(found)).splitlines() if one.lstrip().startswith("WATE-2")
    )
    assert "out of range" in line
    assert "160.6" not in line.partition("out of range")[0]


def test_the_users_mass_is_marked_as_an_override_with_its_origin(found):
    text = printed(weights.comparison_table(found))
    assert "Your own mass (override)" in text
    assert "Taken from here on: 190.0 kg (override, weighed, <maintenance> manual)." in text


@pytest.mark.parametrize("width", [80, weights.WIDE])
def test_the_engine_table_cuts_no_number_short(width):
    """Rich marks what it cuts with an ellipsis."""
    text = printed(weights.engine_table(checked_engines(), width=width), width)
    assert "…" not in text
    assert "20.8*" in text


def test_the_score_table_says_what_is_exact_and_what_is_assumed():
    text = printed(weights.score_table(scores()))
    assert "exact, β only" in text
    assert "Assumed for all" in text


def test_every_flagged_row_stands_in_the_notes_with_its_reason():
    text = printed(weights.note_table(checked_engines()))
    assert "misplaced" in text
    assert "B15A" in text


def test_the_csv_has_a_row_per_engine_and_keeps_the_printed_digits():
    rows = list(csv.DictReader(io.StringIO(weights_data.to_csv(weights_data.engine_rows(checked_engines())))))
    assert len(rows) == 121
    assert rows[1]["turbine_kw_kg_printed"] == "5.00"
    assert float(rows[1]["turbine_kw_kg_computed"]) == pytest.approx(5.00, abs=0.005)


def test_the_answer_carries_masses_reasons_and_origin(found):
    record = plain(mass_answer(found))
    methods = {one["key"]: one for one in record["methods"]}
    assert methods["wate2"]["mass_kg"] is None
    assert "outside" in methods["wate2"]["reason"]
    assert record["taken"] == {"mass_kg": 190.0, "origin": "weighed, <maintenance> manual", "overridden": True}


def test_figures_hold_every_engine_and_every_weight(found):
    power, methods = figure_mass_over_power(found), figure_methods(found)
    assert marked(power) == 121 + 1  # the engines and the requirement
    assert any(len(dots.x) == 61 for dots in methods.axes[0].of(Dots))
    assert len(figure_densities().axes) == 2


def test_figures_need_no_requirement():
    assert marked(figure_mass_over_power()) == 121
    assert figure_methods().axes[0].key is not None


def marked(figure):
    """Return how many marks stand on the first panel."""
    return sum(len(curve.x) for curve in figure.axes[0].of(Curve) if curve.marker)


def test_turboprop_masses_are_nearly_proportional_to_power():
    """NASA'15 goes with P^0.78 at one speed; slower propellers at greater power bring the fit to P^0.995 (computed)."""
    line = turboprop_fit()
    assert line.count == 82
    assert line.slope == pytest.approx(0.995, abs=1e-3)
    assert fit_of_all_rows().count == 121


class Links(HTMLParser):
    """Collects ids and where links lead."""

    def __init__(self):
        super().__init__()
        self.ids, self.targets, self.outside = [], set(), []

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            if name == "href":
                self.targets.add(value)
            if name in ("src", "href") and not value.startswith(("#", "data:")):
                self.outside.append(value)


def test_every_link_of_the_page_leads_somewhere_on_the_page(page):
    links = Links()
    links.feed(page)
    assert links.outside == []
    assert len(set(links.ids)) == len(links.ids)
    assert {target[1:] for target in links.targets} <= set(links.ids)


def test_the_page_holds_the_thirteen_tables_with_every_model(page):
    for number in range(3, 16):
        assert f'id="table-1.{number}"' in page
    for one in checked_engines():
        assert one.engine.model in page


def test_what_the_user_writes_is_text_and_not_markup(page):
    assert "<maintenance>" not in page
    assert "&lt;maintenance&gt;" in page


def test_the_page_is_the_same_at_every_run(found, page):
    assert weights_page(found) == page


def test_the_figures_of_the_page_are_images_within_it(page):
    assert page.count('<svg class="gw-figure"') == 3 and "<img" not in page
