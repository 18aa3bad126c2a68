"""Modules of bevel gears that are strong enough in the search for teeth."""

import pytest

from gearwright.sizing.rating.geometry import LARGER, strong_enough


def test_a_module_that_bears_less_than_the_smaller_one_gives_way_to_the_next():
    """3.5 mm stands in a resonance: 4 mm is the next that bears its loads; hopeless ones stay."""
    gaps = {3.0e-3: 0.9, 3.5e-3: 0.8, 4.0e-3: 1.1}
    assert strong_enough(3.5e-3, gaps.get, standard=True) == 4.0e-3
    tried = []
    assert strong_enough(3.5e-3, lambda module: tried.append(module) or 0.5, standard=True) == 3.5e-3
    assert len(tried) == 1 + len(LARGER)


def test_a_module_that_is_not_rounded_is_the_least_above_that_is_strong_enough():
    """A module that bears its loads stays; 3.52 and 3.6 mm are found; 4.2 mm are 20 % away: too far."""
    for needed, found in ((3.4e-3, 3.5e-3), (3.52e-3, 3.52e-3), (3.6e-3, 3.6e-3), (4.2e-3, 3.5e-3)):
        module = strong_enough(3.5e-3, lambda module, needed=needed: (module / needed) ** 3, standard=False)
        assert module == pytest.approx(found, rel=1e-6) and module >= found
