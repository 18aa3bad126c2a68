"""The published mesh load factors as a table; their values gate nothing."""

from gearwright.catalogue import load_factor_tables, load_factors


def test_every_row_says_how_sure_it_is_and_exceeds_an_equal_share():
    assert len(load_factors()) == 20
    assert all(row.confidence and row.source and row.load_factor >= 1.0 for row in load_factors())


def test_tables_grow_with_the_number_of_planets():
    """More planets, less even: true of every table, and a misplaced row would break it."""
    tables = load_factor_tables()
    assert len(tables) == 4
    for table in tables.values():
        assert list(table) == sorted(table)
        assert list(table.values()) == sorted(table.values())
