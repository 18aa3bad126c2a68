"""What the search for the lightest gearbox found still stands, for a few designs of each kind's quickest."""

from pathlib import Path

import pytest
from oracle_answers import FAILS, as_kept, compared, kept, table
from oracle_designs import KINDS, all_designs, design_of
from oracle_exchange import exchanged, pairs
from oracle_search import Outcome, outcome_of

from gearwright import edited, size

ROOT = Path(__file__).parents[2]
ALIKE = 1e-3
"""Part by which masses may differ where nothing but their last digits moved [-]."""
FARTHER = 0.005
"""Part of its mass by which a choice may be farther from the lightest than it was kept [-]."""
FEW = [("spur pair", 4), ("star", 0), ("stepped", 2), ("layshaft", 1), ("bevel + pair", 4), ("bevel + pair", 16)]


def record(kind, number):
    return next(one for one in kept() if (one["kind"], one["k"]) == (kind, number))


@pytest.mark.parametrize(("kind", "number"), FEW)
def test_the_gearbox_that_was_found_passes_and_weighs_what_it_weighed(kind, number):
    own = record(kind, number)
    best = outcome_of(size(edited(design_of(kind, number), own["changes"])))
    assert not best.failing
    assert best.mass == pytest.approx(own["best"], rel=ALIKE)


@pytest.mark.parametrize(("kind", "number"), FEW)
def test_no_choice_is_farther_from_the_lightest_than_it_was(kind, number):
    own = record(kind, number)
    today = compared(own)
    assert bool(today.fails) <= bool(own["choice_fails"])
    assert today.gap <= own["gap"] + FARTHER


def test_two_sets_whose_films_are_too_thin_grow_together():
    """Their faces are too narrow by half; one after the other the first that served weighed 424 kg, then 308 at best.

    What is chosen for the harder of two requirements is lighter by 1.5 %, and passes here, too: a known gap.
    """
    made = next(made for kind, number, _, made in pairs(1000) if (kind, number) == ("planetary + planetary", "1008"))
    found = exchanged(*made())
    assert not found.own.failing and not found.harder.failing
    assert found.own.mass < 240.0
    assert found.own.mass <= 1.02 * found.other.mass


def test_every_design_has_its_answer_once():
    keys = [(one["kind"], one["k"]) for one in kept()]
    assert len(keys) == len(set(keys))
    assert set(keys) == set(all_designs())
    assert sum(kind.designs for kind in KINDS.values()) == 300


def test_the_page_shows_the_gaps_that_are_kept():
    page = (ROOT / "docs" / "theory" / "choice.md").read_text(encoding="utf-8")
    assert table([as_kept(one) for one in kept() if "refused" not in one]) in page


def test_what_fails_does_not_count_as_passing():
    assert not Outcome(1.0, {"set.sun pitting": 1.0, "set.ring tooth root": 2.0}).failing
    assert Outcome(1.0, {"set.sun pitting": 0.99}).failing == {"set.sun pitting": 0.99}
    assert all(one["best_fails"] for one in kept() if one.get("class") == FAILS)
