"""The numbers on the theory page of gear rating are those that the code gives."""

import doctest
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "theory" / "gear-rating.md"


def test_the_examples_of_the_page_run_and_print_what_stands_there():
    """Every example of the page, as a reader would type it."""
    failed, tried = doctest.testfile(str(PAGE), module_relative=False, encoding="utf-8", optionflags=doctest.ELLIPSIS)
    assert tried > 20 and failed == 0
