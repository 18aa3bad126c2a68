"""Undercuts and run-outs of threads: what two manuals print, and what a thread needs."""

import math
from itertools import pairwise

import pytest

from gearwright.catalogue import lock_nuts, thread_chamfer, thread_run_out, thread_undercut, thread_undercuts
from gearwright.errors import DesignError

PRINTED = {0.75: (1.2, 2.6, 0.4), 1.0: (1.6, 3.5, 0.6), 1.5: (2.3, 5.2, 0.8), 2.0: (3.0, 7.0, 1.0)}
"""Pitch -> d − d_g, width and radius [mm]: HEIDENHAIN, MANUALplus 4110, operation manual, 10.2."""


@pytest.mark.parametrize("pitch", PRINTED)
def test_two_manuals_print_the_same(pitch):
    found = thread_undercut(1e-3 * pitch)
    assert (1e3 * found.below, 1e3 * found.width, 1e3 * found.radius) == pytest.approx(PRINTED[pitch])


def test_undercuts_are_deeper_than_their_threads_and_grow_with_the_pitch():
    every = thread_undercuts()
    for one, other in pairwise(every):
        assert one.pitch < other.pitch and one.below < other.below and one.width < other.width
    for each in every:
        assert 1.2269 * each.pitch < each.below < 1.7 * each.pitch
        assert 3.4 * each.pitch <= each.width <= 3.56 * each.pitch
        # Between flanks of 30° there is a bottom.
        assert each.width > each.below / math.tan(math.radians(30.0))


def test_every_lock_nut_has_an_undercut():
    assert all(thread_undercut(nut.pitch).pitch == pytest.approx(nut.pitch) for nut in lock_nuts())


def test_a_pitch_without_an_undercut_is_refused_with_those_that_are():
    with pytest.raises(DesignError, match=r"no undercut for 0\.9 mm; it has some for 0\.5, 0\.6"):
        thread_undercut(0.9e-3)


def test_run_outs_are_what_a_maker_of_studs_prints():
    """Fabory: 2.5 mm of P = 1, 5 mm of P = 2; rounded up 3.8 of 1.5."""
    assert [1e3 * thread_run_out(1e-3 * pitch) for pitch in (1.0, 1.5, 2.0)] == pytest.approx([2.5, 3.75, 5.0])


def test_a_thread_starts_below_its_core():
    for pitch in (0.75e-3, 1e-3, 1.5e-3, 2e-3):
        assert 0.0 <= thread_chamfer(pitch) - 1.2269 * pitch / 2.0 < 0.1e-3
