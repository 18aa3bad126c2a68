"""What is kept of a computation: the latest results by key, of the latest values, or shared within a block."""

from dataclasses import replace

import pytest

import gearwright as gw
from gearwright.memo import Memo, SharedMemo, of_latest
from gearwright.sizing.shafts import held_rings, holders_of
from gearwright.sizing.shafts.ends import exits_of
from gearwright.spec import edited
from shipped_work import sized


def test_another_object_is_computed_though_it_is_equal_and_the_first_one_is_forgotten():
    asked = []
    count = of_latest(1)(lambda words: asked.append(words) or len(words))
    one, other = ["sun"], ["sun"]
    assert [count(words) for words in (one, one, other, other, one)] == [1] * 5
    assert list(map(id, asked)) == [id(one), id(other), id(one)]


def test_of_two_that_take_turns_none_is_computed_twice_and_a_third_one_replaces_the_first():
    asked = []
    count = of_latest(2)(lambda words: asked.append(words) or len(words))
    one, other, third = ["sun"], ["sun"], ["sun"]
    assert [count(words) for words in (one, other, one, other, third, other, one)] == [1] * 7
    assert list(map(id, asked)) == [id(one), id(other), id(third), id(one)]


def test_what_is_refused_is_refused_anew_and_nothing_is_kept_of_it():
    halves = of_latest(1)(lambda words: 1 / len(words))
    none = []
    for _ in range(2):
        with pytest.raises(ZeroDivisionError):
            halves(none)
    none.append("sun")
    assert halves(none) == 1.0


def test_the_earliest_result_goes_where_there_is_no_room_and_asking_keeps_none_alive():
    lengths = Memo(2)
    for word in ("sun", "planet", "sun", "ring"):
        assert lengths.of(word, lambda word=word: len(word)) == len(word)
    assert [lengths.get(word) for word in ("sun", "planet", "ring")] == [None, 6, 4]


def test_a_result_that_is_none_is_made_once():
    asked, nothing = [], Memo(1)
    assert [nothing.of("sun", lambda: asked.append("sun")) for _ in range(3)] == [None] * 3
    assert asked == ["sun"]


def test_what_is_refused_leaves_the_memo_as_it_was():
    memo = Memo(1)
    memo.keep("sun", 1)
    with pytest.raises(ZeroDivisionError):
        memo.of("ring", lambda: 1 // 0)
    assert (memo.get("sun"), memo.get("ring")) == (1, None)


def test_blocks_share_the_memo_of_the_outermost_and_leave_none():
    shared = SharedMemo(9)
    with shared.sharing():
        outer = shared.now()
        with shared.sharing():
            assert shared.now() is outer
        assert shared.now() is outer
    assert shared.now() is not outer and shared.now() is not shared.now()


def test_a_block_that_fails_shares_no_longer():
    shared = SharedMemo(9)
    with pytest.raises(ZeroDivisionError), shared.sharing():
        shared.now().keep("sun", 1 // 0)
    assert shared.now() is not shared.now()


@pytest.mark.parametrize("function", [held_rings, holders_of, exits_of])
def test_a_changed_sizing_has_holders_of_its_own(function):
    """Without its housing nothing leaves one: the sizing that was asked for before does not answer."""
    whole = sized("ec120b")
    bare = replace(whole, design=edited(whole.design, {"housing.own": False}))
    assert function(whole) is function(whole)
    assert function(bare) == function.__wrapped__(bare)
    assert exits_of(bare) == () != exits_of(whole)
    assert function(whole) == function.__wrapped__(whole)


def test_rows_that_are_sized_together_have_the_holders_of_those_that_are_sized_alone():
    designs = [edited(gw.read("ec120b"), {"shafting.safety": safety}) for safety in (1.4, 1.5, 1.6)]
    together = gw.size_many(designs)
    for row, design in enumerate(designs):
        assert holders_of(together.at(row)) == holders_of(gw.size(design))
