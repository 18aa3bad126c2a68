"""What tires a housing and what is maintained, as tables, on the page of a review and in its JSON."""

import pytest

from gearwright.render.answers.review import review_answer
from gearwright.render.answers.schema import plain
from gearwright.render.pages.report import review_page
from gearwright.render.tables.housing import housing_tables
from gearwright.reviews import review_of
from shipped_work import BY_HAND, sized

TITLES = ["What tires the housing", "Assumed of the housing", "Maintenance"]


def test_the_tables_stand_in_the_words_and_on_the_page_with_their_units():
    review = review_of(sized(BY_HAND))
    tires, assumed, upkeep = housing_tables(review)
    assert [table.title for table in (tires, assumed, upkeep)] == TITLES
    stresses = {column.name: column.dimension for column in tires.columns}
    assert (stresses["start_range"], stresses["safety"]) == ("stress", "ratio")
    assert len(tires.rows) == len(review.housing)
    page = review_page(review)
    assert all(title in page for title in TITLES)
    rows = [[cell.text for cell in row] for row in upkeep.rows]
    assert ["gearbox", "change oil"] in [row[:2] for row in rows]
    assert next(row for row in rows if row[:2] == ["gearbox", "change oil"])[4] == "nothing"


def test_json_has_hours_and_megapascals_and_what_comes_off_as_a_list():
    review = review_of(sized(BY_HAND))
    answer = plain(review_answer(review))
    web = next(one for one in answer["housing"] if (one["part"], one["section"]) == ("input-front", "web"))
    assert web["stress_mpa"] == pytest.approx(1.25 * 103.0 / 3.5, rel=1e-3)
    task = next(
        one for one in answer["upkeep"] if (one["part"], one["task"]) == ("input", "overhaul with its bearings")
    )
    assert task["interval_h"] == pytest.approx(3522.0, rel=1e-3)
    assert task["first"] == ["arrius-2f", "covers and housing at the second end of input", "shaft tail"]
    assert {one["what"] for one in answer["housing_assumed"]} >= {"from start to start", "casting", "vibration"}


def test_a_gearbox_without_a_housing_of_its_own_has_no_table_of_it():
    tires, assumed, upkeep = housing_tables(review_of(sized("geared-turbofan-star")))
    assert not tires.rows and not assumed.rows and upkeep.rows
