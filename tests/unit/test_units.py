"""Units: what is kept in SI, what is shown and what keys say agree."""

from gearwright import units
from gearwright.units import SUFFIXES, key_suffix, shown, si_unit


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
