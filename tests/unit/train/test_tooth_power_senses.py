"""Every state in which the senses of the tooth powers agree with their losses is found, and no other."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from gearwright.train.torques import Losing, states

SIZE = 4
ENTRIES = st.lists(st.floats(-1.5, 1.5).map(lambda value: round(value, 3)), min_size=SIZE, max_size=SIZE)
MATRICES = st.lists(ENTRIES, min_size=SIZE, max_size=SIZE).map(np.array)


def tried(losing):
    """Return every solution, by trying all combinations of signs; None where one of them is nearly singular."""
    found = []
    for signs in itertools.product((1.0, -1.0), repeat=len(losing.lossless)):
        matrix = np.eye(len(signs)) + np.where(np.array(signs) > 0.0, losing.positive, losing.negative)
        if np.linalg.cond(matrix) > 1e6:
            return None
        state = np.linalg.solve(matrix, losing.lossless)
        if np.abs(state).min() < 1e-6 * np.abs(state).max():
            return None  # on the border of two pieces
        if np.all(state * signs > 0.0):
            found.append(state)
    return found


@settings(max_examples=300, deadline=None)
@given(lossless=ENTRIES.map(np.array), positive=MATRICES, negative=MATRICES)
def test_all_states_of_any_equations_are_found(lossless, positive, negative):
    losing = Losing(lossless, positive, negative)
    expected = tried(losing)
    if expected is None or not np.abs(lossless).max() > 1e-3:
        return
    solved = states(losing)
    assert solved.complete
    assert len(solved.found) == len(expected)
    for state in expected:
        assert any(np.allclose(state, other, rtol=1e-6, atol=1e-9) for other in solved.found)


@given(lossless=ENTRIES.map(np.array), swing=MATRICES)
def test_small_losses_leave_one_state_whatever_the_load(lossless, swing):
    """Entries up to 1.5 / 20 in rows of four: row sums of |S| are below one, and the mean is zero."""
    solved = states(Losing(lossless, swing / 20.0, -swing / 20.0))
    assert solved.complete and len(solved.found) == 1


@pytest.mark.parametrize("load, expected", [(1.0, [1.0 / 3.0, 1.0]), (-1.0, [])])
def test_one_row_that_loses_more_than_it_gets_has_two_states_or_none(load, expected):
    """It is (1 + 2) x where x is positive and (1 − 2) x where it is negative: 3 x, or |x|, and never below zero."""
    losing = Losing(np.array([load]), np.array([[2.0]]), np.array([[-2.0]]))
    assert sorted(abs(float(state[0])) for state in states(losing).found) == pytest.approx(expected)
