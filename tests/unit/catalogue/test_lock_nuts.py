"""Lock nuts of the series KM: what two makers print, and what their threads bear."""

import math
from itertools import pairwise

import pytest

from gearwright.catalogue import lock_nut, lock_nuts

PRINTED = {
    20: (1.0, 32, 6), 30: (1.5, 45, 7), 55: (2.0, 75, 11), 100: (2.0, 130, 18),
    110: (2.0, 145, 19), 140: (2.0, 180, 22), 160: (3.0, 210, 25), 180: (3.0, 230, 27), 200: (3.0, 250, 29),
}  # fmt: skip
"""Thread -> pitch, outside and width [mm], IBB general catalogue, from 110 mm NSK, Rolling Bearings."""
NAMES = {10: "KM 0", 17: "KM 3", 20: "KM 4", 100: "KM 20", 170: "KM 34", 180: "KM 36", 200: "KM 40"}
"""Thread [mm] -> nut."""


@pytest.mark.parametrize("thread", PRINTED)
def test_two_makers_print_the_same(thread):
    nut = lock_nut(1e-3 * thread)
    assert (1e3 * nut.pitch, 1e3 * nut.outer, 1e3 * nut.width) == pytest.approx(PRINTED[thread])


@pytest.mark.parametrize("thread", NAMES)
def test_nuts_are_called_by_a_fifth_of_their_thread_from_20_mm_on(thread):
    assert lock_nut(1e-3 * thread).designation == f"{NAMES[thread]} with {NAMES[thread].replace('KM', 'MB')}"


def test_nuts_grow_with_their_threads_and_weigh_less_than_their_envelopes():
    nuts = lock_nuts()
    assert len(nuts) == 38
    for one, other in pairwise(nuts):
        assert one.thread < other.thread and one.outer <= other.outer and one.capacity < other.capacity
    for nut in nuts:
        envelope = math.pi / 4.0 * (nut.outer**2 - nut.core**2) * nut.width * 7850.0
        assert 0.6 * envelope < nut.mass < 1.25 * envelope, nut.designation  # slots and chamfers, one digit printed


def test_a_diameter_without_a_nut_has_none():
    assert lock_nut(0.0175) is None
