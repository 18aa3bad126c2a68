"""The page on load sharing prints what the code gives."""

import doctest
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "theory" / "load-sharing.md"


def test_examples_of_the_page_run_and_print_what_stands_there():
    failed, tried = doctest.testfile(str(PAGE), module_relative=False, encoding="utf-8")
    assert tried > 10
    assert failed == 0
