"""Which combinations of teeth a preliminary sizing looks at, and which it takes."""

import pytest

from gearwright.sizing.rating.geometry import LARGER, strong_enough
from gearwright.sizing.teeth import Trying

TEETH = [(20, 60), (20, 61), (21, 60), (22, 63), (23, 66)]
"""Of the first and the second stage of five combinations."""


def course(masses=(10.0, 10.1, 10.2, 10.3, 12.0), teeth=TEETH):
    """Return a course through two-stage combinations."""
    return Trying(lambda place: frozenset({("first", teeth[place][:1]), ("second", teeth[place][1:])}), masses)


def note(trying, place, first=1.0, second=1.0, *, mass, heaviness=1.0):
    trying.note(place, {"first": first, "second": second}, {"first": 1.0, "second": heaviness}, mass=mass)


def test_one_that_passes_and_is_as_light_as_the_next_may_be_is_enough():
    trying = course()
    assert trying.next() == 0
    note(trying, 0, mass=10.5)
    assert trying.next() is None and trying.ranked()[0].place == 0


def test_teeth_of_a_stage_that_failed_are_not_tried_again():
    """20 teeth of the first stage fail: the second combination has them, too; then 60 teeth of the second stage."""
    trying = course()
    note(trying, trying.next(), first=0.9, mass=10.0)
    assert trying.next() == 2
    note(trying, 2, second=0.95, mass=10.0)
    assert trying.next() == 3
    note(trying, 3, mass=10.9)
    assert trying.next() is None and [tried.place for tried in trying.ranked()] == [3, 2, 0]


def test_teeth_that_grow_heavy_are_left_for_others_and_taken_only_where_none_are_lighter():
    trying = course()
    note(trying, trying.next(), mass=15.0, heaviness=1.5)
    assert trying.next() == 1
    note(trying, 1, mass=11.5)
    assert trying.next() == 3, "60 teeth of the second stage grew heavy"
    note(trying, 3, second=0.99, mass=9.0)
    assert trying.next() is None, "11.5 kg pass, and the last may weigh 12 kg"
    assert [tried.place for tried in trying.ranked()] == [1, 0, 3]


def test_of_those_that_are_as_near_the_lightest_is_taken_and_of_equals_the_first():
    trying = course()
    for place, near, mass in ((0, 0.9, 9.0), (1, 0.95, 10.0), (2, 0.95, 9.5), (3, 0.95, 9.5 * (1.0 - 1e-12))):
        note(trying, place, first=near, mass=mass)
    assert [tried.place for tried in trying.ranked()] == [2, 3, 1, 0]


def test_no_more_than_twelve_are_looked_at():
    trying = course([10.0] * 20, [(place, 100 + place) for place in range(20)])
    places = list(iter(trying.next, None))
    assert places == list(range(12)) and trying.ranked() == []


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
