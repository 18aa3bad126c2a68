"""Undercuts of DIN 509, form F."""

import math

import pytest

from gearwright.catalogue import undercut, undercuts
from gearwright.errors import DesignError

HEIDENHAIN = {3: (0.1, 1.0), 18: (0.2, 2.0), 80: (0.3, 2.5), 125: (0.4, 4.0)}
"""Largest diameter -> depth and width, CNC PILOT 4290, user's manual, 11.1.3, for usual stress [mm]."""


@pytest.mark.parametrize(
    ("seat", "name"),
    [(12, "0.4 x 0.2"), (18, "0.4 x 0.2"), (20, "1.2 x 0.2"), (50, "1.2 x 0.2"), (60, "1.6 x 0.3"),
     (100, "2.5 x 0.4"), (140, "4 x 0.5")],
)  # fmt: skip
def test_a_seat_has_the_undercut_of_its_diameter(seat, name):
    assert undercut(1e-3 * seat).designation == f"DIN 509 - F {name}"


def test_the_table_has_no_gaps_and_every_undercut_has_room_for_its_radius():
    table = undercuts()
    assert [one.to for one in table[:-1]] == [other.over for other in table[1:]]
    for one in table:
        slope = one.depth / math.tan(math.radians(15.0))
        assert one.width - slope > one.radius - one.face_depth


@pytest.mark.parametrize("seat", [2, 12])
def test_small_ones_are_those_of_another_table(seat):
    found = undercut(1e-3 * seat)
    limit = next(largest for largest in HEIDENHAIN if seat <= largest)
    assert (1e3 * found.depth, 1e3 * found.width) == pytest.approx(HEIDENHAIN[limit])


def test_thinner_seats_have_none():
    with pytest.raises(DesignError, match=r"shafting\.shoulders: DIN 509 has no undercut for seats of 1\.5 mm"):
        undercut(1.5e-3)
