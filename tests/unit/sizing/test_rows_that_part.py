"""Rows that part again and again are soon left to be sized one by one."""

import numpy as np
import pytest

from gearwright.lanes import Diverged
from gearwright.sizing import size_many
from gearwright.sizing.many.sizings import BEARINGS, BEVELS, SPARED, _parting
from gearwright.spec import read


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


@pytest.mark.parametrize(
    ("price", "rows", "most"), [(BEARINGS, 24, 0), (BEARINGS, 240, 2), (BEVELS, 24, 0), (BEVELS, 400, 2)]
)
def test_rows_that_part_late_take_no_more_than_a_tenth_of_their_time_in_vain(price, rows, most):
    calls = []

    def peeled(place):
        calls.append(len(place))
        raise Diverged(np.arange(len(place)) >= 1)

    assert list(_parting(np.arange(rows), peeled, price)) == []
    assert len(calls) == most
    assert price * len(calls) <= SPARED * rows


@pytest.mark.parametrize("name", ["hybrid-turboprop", "in-line-star"])
def test_few_rows_of_a_shipped_design_that_part_late_go_one_by_one(name):
    design = read(name)
    assert not size_many(design, {"shafting.safety": np.linspace(1.8, 2.2, 12)}, results=["mass"]).together.any()
