"""Crests between rows: of waves, of kinks, over the edges of blocks."""

from itertools import pairwise

import numpy as np
import pytest

from gearwright.dynamics.codegen import blank_crests, bring_crests


def crests_of(table, cuts=()):
    """Return greatest, least and both with what they may be off by, worked out piece by piece."""
    rows, columns = table.shape
    wide = np.zeros((rows, -(-columns // 8) * 8))
    wide[:, :columns] = table
    crests, ends = blank_crests(wide.shape[1]), [2, *cuts, rows - 3]
    for first, stop in pairwise(ends):
        bring_crests(wide, first, stop - first, crests)
    return crests[:4, :columns]


@pytest.mark.parametrize("angle", [0.1, 0.5, 0.95])
def test_the_crest_of_a_wave_is_met_between_its_rows(angle):
    """Amplitude 1 in 24 phases about a mean of 5: within 5 φ⁶/1024, and within what is told, 3 φ⁴/128."""
    phase = np.linspace(0.0, 2.0 * np.pi, 24)
    table = 5.0 + np.sin(angle * np.arange(int(17.0 / angle))[:, None] + phase)
    high, low, above, below = crests_of(table)
    allowed = 5.0 * angle**6 / 1024.0 + 1e-7
    assert np.all(np.abs(high - 6.0) < allowed)
    assert np.all(np.abs(low - 4.0) < allowed)
    assert np.all((above >= 6.0) & (above < 6.0 + 3.0 * angle**4 / 128.0 + 1e-7))
    assert np.all((below <= 4.0) & (below > 4.0 - 3.0 * angle**4 / 128.0 - 1e-7))
    assert np.min(np.max(table[2:-3], axis=0)) < 6.0 - 0.02 * angle**2  # what the rows alone would have met


def test_the_crest_of_one_long_wave_lies_where_a_polynomial_has_it():
    """A quintic is its own interpolant: its crest to what the parabola in quarters leaves."""
    time = np.arange(12.0) - 5.3
    table = 7.0 - (time**2 + 0.01 * time**3 + 0.001 * time**4)[:, None]
    assert crests_of(table)[0, 0] == pytest.approx(7.0, abs=1e-4)


def test_pieces_meet_without_a_seam():
    """Blocks and bins cut a run anywhere, also beside a crest."""
    table = np.random.default_rng(3).normal(size=(60, 11)).cumsum(axis=0)
    whole = crests_of(table)
    for cuts in ((3,), (17, 18, 19), tuple(range(3, 57))):
        assert np.array_equal(crests_of(table, cuts), whole)


def test_a_straight_line_and_a_constant_have_no_crest():
    """Nothing is divided by nothing."""
    high, low, above, _ = crests_of(np.column_stack([np.arange(20.0), np.full(20, 3.0)]))
    assert high.tolist() == pytest.approx([16.75, 3.0])
    assert low.tolist() == [2.0, 3.0]
    assert above.tolist() == pytest.approx([16.75, 3.0])
