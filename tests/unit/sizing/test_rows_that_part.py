"""Rows that part again and again are soon left to be sized one by one."""

import numpy as np

from gearwright.lanes import Diverged
from gearwright.sizing.many.columns import _parting


def test_rows_that_halve_again_and_again_are_computed_in_vain_a_few_times_only():
    """256 rows that never stay together: 85 computations of a part down to six rows and more, were none spared."""
    calls = []

    def halved(place):
        calls.append(len(place))
        raise Diverged(np.arange(len(place)) >= len(place) // 2)

    assert list(_parting(np.arange(256), halved)) == []
    assert len(calls) <= 6


def test_rows_that_part_once_are_computed_in_both_parts():
    def once(place):
        if len(place) == 64:
            raise Diverged(place >= 32)
        return len(place)

    assert [result for _, result in _parting(np.arange(64), once)] == [32, 32]
