"""The published mesh load factors as a table, and the levels that are taken where a design states none."""

import math

import pytest

from gearwright.catalogue import LEAST_SHARING, level_load_factor, load_factor_tables, load_factors


def test_every_row_says_how_sure_it_is_and_exceeds_an_equal_share():
    """Of IEC 5, of levels 1 to 4 of AGMA 7 and three times 8, measured 3."""
    assert len(load_factors()) == 5 + 7 + 3 * 8 + 3
    assert all(row.confidence and row.source and row.load_factor >= 1.0 for row in load_factors())


def test_tables_grow_with_the_number_of_planets():
    """More planets, less even: true of every table, and a misplaced row would break it."""
    tables = load_factor_tables()
    assert len(tables) == 5
    for table in tables.values():
        assert list(table) == sorted(table)
        assert list(table.values()) == sorted(table.values())


@pytest.mark.parametrize(("planets", "factor"), [(3, 1.05), (4, 1.15), (5, 1.19), (6, 1.23), (7, 1.27), (9, 1.33)])
def test_level_3_is_that_of_one_floating_member(planets, factor):
    """AGMA 6123-B06, level 3, with 1.05 at least."""
    assert level_load_factor(3, planets) == factor


def test_a_better_level_never_shares_worse():
    """Levels 2 to 4; level 1 is not worse than 2 from five planets on, as the table has it."""
    for planets in range(2, 10):
        assert level_load_factor(4, planets) <= level_load_factor(3, planets) <= level_load_factor(2, planets)


def test_a_single_planet_carries_what_it_carries():
    assert level_load_factor(1, 1) == 1.0
    assert level_load_factor(1, 2) == 1.16
    assert level_load_factor(4, 3) == LEAST_SHARING == 1.05


def test_beyond_the_table_sharing_grows_with_what_float_does_not_take_up():
    """√((p − 3)/p): 1.33 at nine planets of level 3, √(9/12 / (6/9)) of its excess at twelve."""
    expected = 1.0 + 0.33 * math.sqrt((9.0 / 12.0) / (6.0 / 9.0))
    assert level_load_factor(3, 12) == pytest.approx(expected, rel=1e-12)
    assert level_load_factor(3, 12) > level_load_factor(3, 9)
