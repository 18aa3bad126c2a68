"""Long histories are thinned for a screen without the loss of a peak."""

import numpy as np
import pytest

from gearwright.app.motions import extremes, instants

RANDOM = np.random.default_rng(4)


@pytest.mark.parametrize("count", [10, 4000, 4001, 4003, 9_999, 123_457])
def test_what_is_drawn_has_the_extremes_at_their_instants_within_a_stretch(count):
    most, time = 4000, np.arange(count) * 1e-4
    values = RANDOM.normal(size=count)
    values[RANDOM.integers(count)], values[-1] = 50.0, -40.0
    drawn, at = extremes(values, most=most), instants(time, most=most)
    assert len(drawn) == len(at) <= most
    assert (drawn.max(), drawn.min()) == (values.max(), values.min())
    stretch = 2 * (at[1] - at[0]) + 2e-4
    assert abs(at[drawn.argmax()] - time[values.argmax()]) <= stretch
    assert np.all(np.diff(at) > 0.0)


def test_a_short_history_stays_as_it_is():
    values = RANDOM.normal(size=100)
    assert extremes(values, most=100) is values


def test_of_a_stretch_the_earlier_extreme_stands_first():
    assert extremes(np.array([5.0, 1.0, 2.0, 3.0, 0.0, 1.0, 7.0, 2.0]), most=4).tolist() == [5.0, 1.0, 0.0, 7.0]
