"""Units: what is kept in SI, what is shown and what keys say agree."""

import pytest

from gearwright import units
from gearwright.units import SUFFIXES, apart, key_suffix, margin_text, number_text, shown, si_unit, text


def test_every_dimension_has_a_unit_in_si():
    for dimension in {*SUFFIXES, *units._SHOWN}:
        assert si_unit(dimension)


def test_a_dimension_that_is_shown_as_it_is_kept_has_one_unit():
    """g/mm is kg/m by another name."""
    for dimension, row in units._SHOWN.items():
        assert (row.unit or "1") == si_unit(dimension) or row.factor != 1.0 or dimension == "mass_per_length"


def test_a_key_in_the_shown_unit_is_read_as_what_is_shown():
    for dimension, suffixes in SUFFIXES.items():
        assert shown(suffixes[key_suffix(dimension)], dimension) == 1.0


def test_words_and_counts_have_no_suffix():
    assert key_suffix("") == ""


@pytest.mark.parametrize("digits", [2, 3, 4])
@pytest.mark.parametrize("margin", [0.0, 1e-5, 0.7196, 0.994, 0.9951, 0.9996, 0.99996, 0.9999999, 1.0, 1.0004, 12.345])
def test_a_margin_is_rounded_to_the_nearest_and_below_one_never_reads_as_one(margin, digits):
    """0.7196 is 0.72 or 0.720 and never 0.71; 0.9996 is never 1.00."""
    for words in (margin_text(margin, digits), number_text(margin, "ratio", digits), text(margin, "ratio", digits)):
        assert (float(words) < 1.0) == (margin < 1.0)
        assert abs(float(words) - margin) <= 0.5 * 10.0 ** (1 - digits) * max(margin, 1e-9)


@pytest.mark.parametrize(
    ("first", "second", "dimension", "words"),
    [
        (1469.2e3, 1468.9e3, "power", ("1469.2 kW", "1468.9 kW")),
        (2000e3, 1700e3, "power", ("2000 kW", "1700 kW")),
        (0.0123456, 0.0123454, "length", ("12.346 mm", "12.345 mm")),
        (0.012, 0.012, "length", ("12 mm", "12 mm")),
    ],
)
def test_two_values_that_are_compared_have_digits_enough_to_differ(first, second, dimension, words):
    assert apart(first, second, dimension) == words
