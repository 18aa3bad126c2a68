"""The page of a review: the verdict first, every requirement, every kilogram, every order, what is open."""

import re

import pytest

from gearwright.closure import REQUIREMENTS, requirement_of
from gearwright.render.pages.report import failed_table, met_table, open_table, order_table, review_page, waived_table
from gearwright.reviews import review
from gearwright.shipped import shipped_design
from gearwright.spec import edited, read
from shipped_work import flown_review, ground_review


def column(made, name):
    """Return the cells of a table's column."""
    place = next(k for k, column in enumerate(made.columns) if column.name == name)
    return [row[place] for row in made.rows]


def test_the_page_says_the_verdict_before_anything_else_and_once():
    page = review_page(flown_review())
    said = page.index('<div class="verdict bad"><p class="word">Fails</p>')
    assert said < page.index("complete mass") < page.index("What fails, and what would help")
    assert "The worst is first.planet: bearing life L<sub>10h</sub>" in page
    assert re.search(r"hottest oil in flight</dt><dd><span[^>]*>105 °C", page)


def test_what_fails_stands_on_the_page_with_what_would_help():
    made = failed_table(flown_review().checks)
    assert len(made.rows) == len(flown_review().failing)
    helps = column(made, "what_would_help")
    assert all(
        REQUIREMENTS[requirement_of(check)].helps in cell.text
        for check, cell in zip(flown_review().failing, helps, strict=True)
    )


def test_every_check_belongs_to_a_requirement_that_the_page_lists():
    made, checks = met_table(flown_review().checks), flown_review().checks
    counted = sum(cell.value for name in ("checks", "not_assessed") for cell in column(made, name))
    assert counted == len(checks)
    assert sum(cell.value for cell in column(made, "fail")) == len(flown_review().failing)
    assert {cell.text for cell in column(made, "requirement")} == {requirement_of(check) for check in checks}


def test_no_kilogram_is_hidden_groups_add_up_to_the_sum():
    mass = flown_review().complete
    assert sum(group.total for group in mass.groups) == pytest.approx(mass.total)
    page = review_page(flown_review())
    assert all(f">{group.group}<td" in page for group in mass.groups)
    assert flown_review().statistics.sentence in page


def test_orders_of_every_machine_are_told_also_one_that_meets_no_natural_frequency():
    orders = {cell.text for cell in column(order_table(flown_review().checks), "order")}
    machines = {"propeller 1P", "propeller blade pass", "electric 1P", "gas-turbine 1P", "first mesh"}
    assert {f"resonance of {order}" for order in machines} <= orders


def test_what_is_not_assessed_keeps_its_reason_and_equal_reasons_stand_together():
    made = open_table(ground_review().checks)
    named = [part for cell in column(made, "part") for part in cell.text.split(", ")]
    assert len(named) == len(ground_review().open)
    assert all(cell.text for cell in column(made, "why"))


def test_a_waiver_stands_on_the_page_with_its_reason():
    reason = "swings the tooth force by 4 % of its mean"
    waived = review(
        edited(read(shipped_design("in-line-h2")), {"waivers": {"gearbox resonance of second mesh": reason}})
    )
    assert [cell.text for cell in column(waived_table(waived.checks), "why")] == [reason]
    assert reason in review_page(waived)
    assert "Nothing is waived." in review_page(ground_review())


def test_the_same_review_gives_the_same_page():
    assert review_page(ground_review()) == review_page(ground_review())
