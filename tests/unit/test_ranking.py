"""What is equal but for rounding is equal: no order and no choice hangs on the last digit of a processor."""

from gearwright.ranking import largest, largest_first

SUM = 0.1 + 0.2
"""0.30000000000000004."""


def test_the_first_of_equals_is_the_largest_in_whatever_way_it_is_rounded():
    assert largest([("left", 0.3), ("right", SUM)], lambda row: row[1])[0] == "left"
    assert largest([("left", SUM), ("right", 0.3)], lambda row: row[1])[0] == "left"
    assert largest([("left", 0.3), ("right", 0.3001)], lambda row: row[1])[0] == "right"


def test_equals_and_zeros_with_rounding_stay_in_their_order():
    rows = {"idle": 3e-15, "left": 0.3, "rest": 0.0, "most": 2.0, "right": SUM, "still": 5e-15}
    assert largest_first(rows, rows.__getitem__) == ["most", "left", "right", "idle", "rest", "still"]
    assert largest_first([], float) == []
