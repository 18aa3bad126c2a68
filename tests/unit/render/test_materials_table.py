"""What a design's materials are, where each number comes from, and which ones are estimated."""

import pytest
from rich.console import Console

from designs import PAIR
from gearwright.particulars import particulars
from gearwright.render.answers.design import size_answer
from gearwright.render.answers.schema import plain
from gearwright.render.pages.report import report
from gearwright.render.tables.sizing import materials_table
from gearwright.render.words.sizing import sizing_text
from gearwright.sizing import size
from gearwright.spec import parse

PYROWEAR = '[gears]\nmaterial = "Pyrowear-53"\nrating = "iso6336"\n'


@pytest.fixture(scope="module")
def estimated():
    return size(parse(PAIR + PYROWEAR))


def rows(sizing):
    return {row[1].text: row for row in materials_table(particulars(sizing).materials).rows}


def test_a_strength_that_no_source_gives_is_marked_with_its_rule(estimated):
    strength = rows(estimated)["strength of flanks σ_Hlim"]
    assert (strength[2].text, strength[2].mark, strength[3].text) == ("1500", "estimated", "MPa")
    assert "does not cover secondary-hardening steels" in strength[4].text
    assert rows(estimated)["proof stress R_p0.2"][2].mark == "estimated"
    assert rows(estimated)["hardness of flanks HV"][2].mark == ""


def test_a_grade_that_the_design_asks_for_is_of_the_standard_and_no_estimate_of_the_material():
    asked = rows(size(parse(PAIR + PYROWEAR + 'iso6336.grade = "ME"\n')))["strength of flanks σ_Hlim"]
    assert (asked[2].text, asked[2].mark) == ("1650", "")
    assert asked[4].text.startswith("ISO 6336-5:2016, table 1")


def test_a_material_without_a_class_is_rated_by_the_one_that_the_design_asks_for():
    text = PAIR + '[gears]\nmaterial = "mine"\nrating = "iso6336"\niso6336.steel = "case-hardened"\n[materials.mine]\n'
    plain = "elastic_modulus_gpa = 206\npoisson_ratio = 0.3\ndensity_kg_m3 = 7830\nyield_strength_mpa = 800\n"
    found = rows(size(parse(text + plain)))["strength of flanks σ_Hlim"]
    assert (found[2].text, found[2].mark) == ("1500", "")


def test_terminal_json_and_report_tell_what_is_estimated(estimated):
    console = Console(width=200, no_color=True)
    with console.capture() as shown:
        console.print(sizing_text(particulars(estimated)))
    assert "Materials: what is estimated" in shown.get()
    told = plain(size_answer(particulars(estimated)))["materials"]
    (strength,) = [row for row in told if row["quantity"] == "strength of flanks σ_Hlim"]
    assert (strength["value"], strength["unit"]) == (1500.0, "MPa")
    assert strength["source"].startswith("estimated: ISO 6336-5:2016")
    page = report(estimated)
    assert "secondary-hardening" in page
    assert "AMS 6308" in page


def test_a_design_without_estimates_has_no_table_of_them_on_the_screen():
    console = Console(width=200, no_color=True)
    with console.capture() as shown:
        console.print(sizing_text(particulars(size(parse(PAIR)))))
    assert "what is estimated" not in shown.get()


def test_every_material_that_is_used_stands_in_the_table():
    text = PAIR + '[gears]\nmaterial = "16MnCr5"\n[shafting]\nmaterial = "C45"\n'
    assert {row[0].text for row in materials_table(particulars(size(parse(text))).materials).rows} == {"16MnCr5", "C45"}
