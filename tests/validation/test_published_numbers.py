"""Every published number that ``gearwright validate`` prints comes out."""

import re
from dataclasses import replace

import pytest

from gearwright.errors import DesignError, SolveError
from gearwright.render.pages.validation import by_source, source_table, verdict
from gearwright.validate import check, published


@pytest.mark.parametrize("case", published(), ids=lambda case: case.name)
def test_a_published_case_comes_out(case):
    """Source, numbers and the reason of the tolerance stand in the case itself."""
    missed = [one for one in check(case) if not one.holds]
    assert not missed, f"{case.source}, within {case.tolerance:g}: {case.reason}"


def test_a_number_that_is_off_by_more_than_its_tolerance_is_missed():
    case = published("five inertias")[0]
    wrong = replace(case, expected=(*case.expected[:-1], case.expected[-1] + 0.02))
    assert [one.holds for one in check(wrong)] == [True, True, True, True, False]


def test_a_case_that_finds_another_count_of_numbers_is_refused():
    case = published("five inertias")[0]
    with pytest.raises(SolveError, match="4 numbers are printed, 5 found"):
        check(replace(case, expected=case.expected[:-1]))


def test_cases_are_chosen_by_name_or_source_and_unknown_words_list_the_sources():
    assert {re.split(r"\W", case.source)[0] for case in published("friswell")} == {"Friswell"}
    with pytest.raises(DesignError, match="Timoshenko 1921"):
        published("Leonardo da Vinci")


def test_the_table_marks_what_is_missed_and_says_why_so_much_is_allowed():
    case = published("five inertias")[0]
    wrong = replace(case, expected=(*case.expected[:-1], case.expected[-1] + 0.02))
    found = tuple(one for numbers in by_source([wrong]) for one in numbers)
    shown = source_table(found)
    assert [row[2].text.endswith("missed") for row in shown.rows] == [False, False, False, False, True]
    assert shown.title == case.source and f"{case.name}, 5 (allowed because {case.reason})" in shown.note
    assert verdict(found) == "4 of 5 published numbers come out within their tolerance."
