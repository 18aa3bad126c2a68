"""Ranking of architectures: the numbers of each, what is kept, what is refused."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import gearwright as gw
from gearwright.enumeration import Architecture, Place, Seat, ranking as module, requirement_of
from gearwright.enumeration.ranking import _lightest, proportioned, rated, sketched
from gearwright.enumeration.trains import built
from gearwright.errors import DesignError
from gearwright.render.words.study import ranking_sentences

LIFE = 20000.0 * 3600.0
ONCE = gw.Effort(closed=1, restarts=0)


def small():
    """Return a requirement that one stage serves: 500 kW from 6000 to 1212 rpm, no motor."""
    conventional = gw.read("in-line")
    return gw.edited(conventional, {"turbines.gas-turbine.speed_rpm": 6000, "turbines.gas-turbine.power_kw": 500})


def test_the_ratio_that_is_found_weighs_nearly_as_little_as_the_best_of_a_grid():
    """Steps of teeth make the mass jump, so that a search of eight points may miss the best of forty by 3 %."""
    asked = requirement_of(gw.read("in-line"))
    one = Architecture(("pair", "planetary set"), Place(Seat.NONE))
    mass, *_ = _lightest(asked, one)
    grid = [gw.size(built(asked, one, [place]).design).mass for place in np.linspace(0.0, 1.0, 40)]
    assert mass <= 1.03 * min(grid)


def test_a_journal_is_gone_on_with_and_gives_the_same(tmp_path, monkeypatch):
    """Closing is done once: the second time the same design must be asked for, the third time none."""
    design, journal = small(), tmp_path / "kept.json"
    original, closed, calls, closings = module.sketched, module._closed, [], []

    def closing(named, *, life):
        calls.append(named[0])
        if not closings:
            closings.extend((named, life, closed(named, life=life)))
        assert [named, life] == closings[:2]
        return closings[2]

    monkeypatch.setattr(module, "_closed", closing)
    whole = gw.architectures(design, life=LIFE, stages=(1,), effort=ONCE)
    best = calls.pop()

    def stopping(asked, one):
        calls.append(one.slug)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return original(asked, one)

    monkeypatch.setattr(module, "sketched", stopping)
    with pytest.raises(KeyboardInterrupt):
        gw.architectures(design, life=LIFE, stages=(1,), effort=ONCE, journal=journal)
    first = calls[0]
    calls[:] = ["", "", ""]
    again = gw.architectures(design, life=LIFE, stages=(1,), effort=ONCE, journal=journal)
    assert first not in calls[:-1] and calls[-1] == best
    assert again == whole
    calls[:] = []
    assert gw.architectures(design, life=LIFE, stages=(1,), effort=ONCE, journal=journal) == whole
    assert not calls
    assert len(whole.candidates) == 3
    with pytest.raises(DesignError, match="was begun with another design, life"):
        gw.architectures(design, life=2 * LIFE, stages=(1,), journal=journal)


def test_numbers_that_are_chosen_anew_lack_no_more_than_before():
    asked = requirement_of(gw.read("in-line-h2"))
    one = Architecture(("pair", "planetary set"), Place(Seat.SHAFT, 0))
    row = rated(asked, sketched(asked, one), life=LIFE)
    better = proportioned(asked, row, life=LIFE)
    assert row.lacks and better.proportioned
    assert better.promise < 0.999 * row.promise
    assert min(ratio for _, ratio in better.lacks) > min(ratio for _, ratio in row.lacks)


@cache
def one_closed():
    """Return the row of a closed design."""
    return gw.architectures(small(), life=LIFE, stages=(1,), effort=ONCE).closed[0]


def closed_by_hand(monkeypatch, masses):
    """Let closings weigh what a list says, in the order in which starts are made; return what was closed."""
    asked, kept = [], one_closed()

    def closing(named, *, life):
        asked.append(named[0])
        weighs = masses[named[0]][asked.count(named[0]) - 1]
        return (replace(kept, fails="", without_bearings="", complete_mass=weighs, machines=0.0, with_machines=weighs),)

    monkeypatch.setattr(module, "_closed", closing)
    return asked


TWO = (
    Architecture(("pair", "planetary set"), Place(Seat.NONE)),
    Architecture(("solar set", "planetary set"), Place(Seat.NONE)),
)


def two_trains(monkeypatch, masses, *, restarts, journal=None):
    """Return the ranking of two trains whose closings weigh what is said, and what was closed in which order."""
    asked = closed_by_hand(monkeypatch, dict(zip((one.slug for one in TWO), masses, strict=True)))
    monkeypatch.setattr(module, "trains", lambda *_, **__: TWO)
    effort = gw.Effort(closed=2, restarts=restarts)
    return gw.architectures(small(), life=LIFE, effort=effort, journal=journal), asked


def test_what_could_be_the_lightest_is_closed_from_other_numbers_until_the_lead_is_four_times_what_is_left(monkeypatch):
    """θ/r = (x̄ − x₁)/(r − 1): of 100 and 101 kg 0.5, of 110 and 112 kg 1; 10 kg are more than 4 √(0.5² + 1²)."""
    found, asked = two_trains(monkeypatch, [(100.0, 101.0), (112.0, 110.0)], restarts=20)
    assert len(asked) == 4 and found.restarts == 2
    assert found.stopped == "the lead is 4 times what the search may have left"
    assert [row.starts for row in found.closed] == [(100.0, 101.0), (112.0, 110.0)]
    assert [row.search_error for row in found.closed] == [0.5, 1.0]
    assert found.lead.mass == 10.0 and found.lead.search == pytest.approx(1.25**0.5)
    assert "of the ±: search 1, rules of mass" in " ".join(ranking_sentences(found))


def test_a_budget_of_starts_ends_and_a_journal_gives_the_same_again(monkeypatch, tmp_path):
    masses = [(100.0, 103.0, 101.0), (101.0, 100.5, 104.0)]
    found, asked = two_trains(monkeypatch, masses, restarts=3, journal=tmp_path / "kept.json")
    assert (found.restarts, found.stopped) == (3, "no more were asked for")
    assert sorted(asked[2:]).count(asked[2]) in (1, 2) and len(asked) == 5
    again, more = two_trains(monkeypatch, masses, restarts=3, journal=tmp_path / "kept.json")
    assert again == found and not more
    fewer, none = two_trains(monkeypatch, masses, restarts=0, journal=tmp_path / "kept.json")
    assert not none and fewer.lead.search is None and fewer.stopped == ""


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"life": 0.0}, "life: 0 h is asked"),
        ({"stages": (0,)}, r"stages: \[0\] are asked"),
        ({"design": gw.read("in-line"), "stages": (1,)}, "no train of 1 stages gives a ratio of 16.5"),
        ({"effort": gw.Effort(closed=-1)}, "closed: -1 are asked"),
        ({"effort": gw.Effort(restarts=-1)}, "restarts: -1 are asked"),
        ({"fastest": -5.0}, "fastest: a motor of -5 rad/s"),
    ],
)
def test_what_cannot_be_asked_is_refused_before_anything_is_computed(wrong, said):
    with pytest.raises(DesignError, match=said):
        gw.architectures(**{"design": small(), "life": LIFE, **wrong})


def test_a_differential_that_turns_the_propeller_too_slowly_is_refused_and_one_that_does_not_is_sized():
    """(1 + P_m/P_t) of a case over that of the rated powers: 1.45/1.961 in the cruise of the thesis."""
    one = Architecture(("differential", "planetary set"), Place(Seat.RING, 0))
    hybrid = gw.read("in-line-h2")
    refused = sketched(requirement_of(hybrid), one)
    assert refused.design is None and "0.74 of its speed in cruise" in refused.refused
    steady = gw.edited(hybrid, {"cases.cruise.electric.rating": None, "cases.cruise.electric.power_kw": 1005.0})
    assert requirement_of(steady).slowed[1] == pytest.approx(1.0)
    assert "of its speed" not in sketched(requirement_of(steady), one).refused


def test_candidates_with_all_their_bearings_weighed_come_first_and_weigh_more():
    found = gw.architectures(small(), life=LIFE, stages=(1,), effort=gw.Effort(closed=0))
    assert [row.bare for row in found.candidates] == [None] * len(found.candidates)  # nothing is closed
    asked = requirement_of(small())
    light = rated(asked, sketched(asked, Architecture(("planetary set",), Place(Seat.NONE))), life=LIFE)
    whole = module.weighed(light)
    assert whole.bare == "" and whole.complete_mass > 1.05 * light.complete_mass
    assert sorted((light, whole), key=lambda row: row.order) == [whole, light]


def test_what_is_lighter_than_all_that_pass_is_told_with_what_it_lacks():
    found = gw.architectures(small(), life=LIFE, stages=(1,), effort=ONCE)
    row = replace(found.closed[0], fails="", verdict="passes as far as assessed")
    light = replace(row, with_machines=row.with_machines - 5.0, fails="gearbox resonance of engine 1P 0.5900")
    heavy = replace(light, with_machines=row.with_machines + 5.0)
    said = " ".join(ranking_sentences(replace(found, closed=(row, light))))
    assert "Lighter, but for what it lacks: " in said and "gearbox resonance of engine 1P 0.5900." in said
    assert "but for what it lacks" not in " ".join(ranking_sentences(replace(found, closed=(row, heavy))))
    assert "but for what it lacks" in " ".join(ranking_sentences(replace(found, closed=(light,))))
