"""The numbers on the theory pages are those that the code gives."""

import doctest
from pathlib import Path

import pytest

PAGES = Path(__file__).parents[2] / "docs" / "theory"


@pytest.mark.parametrize("page", ["mesh-stiffness.md", "planetary-sets.md", "dynamics-use.md"])
def test_the_examples_of_a_theory_page_run_and_print_what_stands_there(page):
    """Every example of the page, as a reader would type it."""
    failed, tried = doctest.testfile(str(PAGES / page), module_relative=False, encoding="utf-8")
    assert tried > 10 and failed == 0
