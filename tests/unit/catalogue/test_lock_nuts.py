"""Lock nuts of the series KM: what two makers print, and what their threads bear."""

import math
from itertools import pairwise

import pytest

from gearwright.catalogue import lock_nut, lock_nuts

PRINTED = {20: (1.0, 32, 6), 30: (1.5, 45, 7), 55: (2.0, 75, 11), 100: (2.0, 130, 18)}
"""Thread -> pitch, outside and width [mm], IBB general catalogue."""


@pytest.mark.parametrize("thread", PRINTED)
def test_two_makers_print_the_same(thread):
    nut = lock_nut(1e-3 * thread)
    assert (1e3 * nut.pitch, 1e3 * nut.outer, 1e3 * nut.width) == pytest.approx(PRINTED[thread])


def test_nuts_grow_with_their_threads_and_weigh_less_than_their_envelopes():
    nuts = lock_nuts()
    assert len(nuts) == 21
    for one, other in pairwise(nuts):
        assert one.thread < other.thread and one.outer < other.outer and one.capacity < other.capacity
    for nut in nuts:
        envelope = math.pi / 4.0 * (nut.outer**2 - nut.core**2) * nut.width * 7850.0
        assert 0.6 * envelope < nut.mass < 1.25 * envelope, nut.designation  # slots and chamfers, one digit printed


def test_a_diameter_without_a_nut_has_none():
    assert lock_nut(0.0175) is None
