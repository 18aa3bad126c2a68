"""Ranking of architectures: the numbers of each, what is kept, what is refused."""

from dataclasses import replace

import numpy as np
import pytest

import gearwright as gw
from gearwright.enumeration import Architecture, Place, Seat, ranking as module, requirement_of
from gearwright.enumeration.ranking import _lightest, proportioned, rated, sketched
from gearwright.enumeration.trains import built
from gearwright.errors import DesignError
from gearwright.render.words.study import ranking_sentences

LIFE = 20000.0 * 3600.0


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
    whole = gw.architectures(design, life=LIFE, stages=(1,), closed=1)
    best = calls.pop()

    def stopping(asked, one):
        calls.append(one.slug)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return original(asked, one)

    monkeypatch.setattr(module, "sketched", stopping)
    with pytest.raises(KeyboardInterrupt):
        gw.architectures(design, life=LIFE, stages=(1,), closed=1, journal=journal)
    first = calls[0]
    calls[:] = ["", "", ""]
    again = gw.architectures(design, life=LIFE, stages=(1,), closed=1, journal=journal)
    assert first not in calls[:-1] and calls[-1] == best
    assert again == whole
    calls[:] = []
    assert gw.architectures(design, life=LIFE, stages=(1,), closed=1, journal=journal) == whole
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


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"life": 0.0}, "life: 0 h is asked"),
        ({"stages": (0,)}, r"stages: \[0\] are asked"),
        ({"design": gw.read("in-line"), "stages": (1,)}, "no train of 1 stages gives a ratio of 16.5"),
        ({"closed": -1}, "closed: -1 are asked"),
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
    found = gw.architectures(small(), life=LIFE, stages=(1,), closed=0)
    assert [row.bare for row in found.candidates] == [None] * len(found.candidates)  # nothing is closed
    asked = requirement_of(small())
    light = rated(asked, sketched(asked, Architecture(("planetary set",), Place(Seat.NONE))), life=LIFE)
    whole = module.weighed(light)
    assert whole.bare == "" and whole.complete_mass > 1.05 * light.complete_mass
    assert sorted((light, whole), key=lambda row: row.order) == [whole, light]


def test_what_is_lighter_than_all_that_pass_is_told_with_what_it_lacks():
    found = gw.architectures(small(), life=LIFE, stages=(1,), closed=1)
    row = replace(found.closed[0], fails="", verdict="passes as far as assessed")
    light = replace(row, with_machines=row.with_machines - 5.0, fails="gearbox resonance of engine 1P 0.5900")
    heavy = replace(light, with_machines=row.with_machines + 5.0)
    said = " ".join(ranking_sentences(replace(found, closed=(row, light))))
    assert "Lighter, but for what it lacks: " in said and "gearbox resonance of engine 1P 0.5900." in said
    assert "but for what it lacks" not in " ".join(ranking_sentences(replace(found, closed=(row, heavy))))
    assert "but for what it lacks" in " ".join(ranking_sentences(replace(found, closed=(light,))))
