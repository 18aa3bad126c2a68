"""Rainflow counting against the example of the standard, and what holds for every history."""

import itertools
import random

import pytest

from gearwright.parts.shaft_fatigue import rainflow, reversals

EXAMPLE = [-2, 1, -3, 5, -1, 3, -4, 4, -2]
"""ASTM E1049-85, figure 6: A to I."""


def by_range(cycles):
    """Return range -> cycles."""
    counted = {}
    for cycle in cycles:
        counted[cycle.range] = counted.get(cycle.range, 0.0) + cycle.count
    return counted


def test_the_example_of_the_standard_comes_out_with_half_cycles():
    """ASTM E1049-85, figure 6: its table of ranges and cycle counts."""
    assert by_range(rainflow(EXAMPLE)) == {9: 0.5, 8: 1.0, 6: 0.5, 4: 1.5, 3: 0.5}


def test_the_example_of_the_standard_comes_out_where_it_repeats():
    """ASTM E1049-85, figure 7: D-G, H-C, E-F and A-B, one cycle each."""
    assert by_range(rainflow(EXAMPLE, residue="repeated")) == {9: 1.0, 7: 1.0, 4: 1.0, 3: 1.0}


@pytest.mark.parametrize("seed", range(20))
def test_every_reversal_ends_a_half_cycle_and_none_is_lost(seed):
    history = [random.Random(seed).randint(-9, 9) for _ in range(60)] + [seed]
    turned = reversals(history)
    assert 2.0 * sum(cycle.count for cycle in rainflow(history)) == len(turned) - 1
    path = sum(2.0 * cycle.count * cycle.range for cycle in rainflow(history))
    assert path == sum(abs(there - here) for here, there in itertools.pairwise(turned))


@pytest.mark.parametrize("seed", range(20))
def test_a_history_that_repeats_has_whole_cycles_wherever_it_begins(seed):
    history = [random.Random(seed).randint(-9, 9) for _ in range(60)]
    counted = by_range(rainflow(history, residue="repeated"))
    assert all(count == int(count) for count in counted.values())
    for start in (1, 17, 40):
        turned = history[start:] + history[:start]
        assert by_range(rainflow(turned, residue="repeated")) == counted


def test_what_does_not_change_has_no_cycles():
    assert rainflow([]) == rainflow([3.0]) == rainflow([3.0, 3.0]) == ()
    assert rainflow([3.0, 3.0], residue="repeated") == ()
