"""CSV that every program reads as the same data."""

import csv
import io

from gearwright.render.grid import csv_text


def test_a_text_is_never_a_formula_and_a_number_stays_a_number() -> None:
    """OWASP, CSV injection: = + - @ and a tab begin formulas; −1.5 and 1e-3 are numbers."""
    row = ["=cmd()", "+1+1", "-x", "@sum", "\t=1", " =1", "plain", -1.5, "-2.5", "1e-3", None, True]
    (_, read) = list(csv.reader(io.StringIO(csv_text(["-a", *"bcdefghijkl"], [row]))))
    assert read == ["'=cmd()", "'+1+1", "'-x", "'@sum", "'\t=1", "' =1", "plain", "-1.5", "-2.5", "1e-3", "", "True"]


def test_a_heading_is_no_formula_either() -> None:
    assert csv_text(["=a"], []) == "'=a\n"


def test_a_bare_carriage_return_ends_no_row() -> None:
    assert csv_text(["a"], [["one\rtwo\r\nthree"]]) == 'a\n"one\ntwo\nthree"\n'
