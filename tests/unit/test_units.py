"""Units: what is kept in SI and what is shown agree."""

from gearwright import units
from gearwright.units import SUFFIXES, si_unit


def test_every_dimension_has_a_unit_in_si():
    for dimension in {*SUFFIXES, *units._SHOWN}:
        assert si_unit(dimension)


def test_a_dimension_that_is_shown_as_it_is_kept_has_one_unit():
    """g/mm is kg/m by another name."""
    for dimension, (name, factor) in units._SHOWN.items():
        assert (name or "1") == si_unit(dimension) or factor != 1.0 or dimension == "mass_per_length"
