"""The table of the Colibri report's numbers: whole, without repeats, and its notes name what is there."""

from gearwright.replays.colibri.report import assumptions, colibri_errata, executed, printed_numbers


def test_every_number_has_its_own_key_and_a_known_unit():
    numbers = printed_numbers()
    assert len({one.key for one in numbers}) == len(numbers) == 236
    assert all(one.scale > 0.0 and one.place and one.symbol for one in numbers)


def test_the_notes_name_numbers_that_are_there_each_once():
    rows = [row for one in colibri_errata() for row in one.rows]
    assert len(rows) == len(set(rows)) == 51
    assert set(rows) <= {one.key for one in printed_numbers()}


def test_every_assumption_is_used_and_every_one_used_is_explained():
    """H9 says what the report's γ is; only the right γ of E1 rests on it."""
    used = {key for step in executed().values() for key in step.assumptions}
    assert {*used, "H9"} == set(assumptions())
