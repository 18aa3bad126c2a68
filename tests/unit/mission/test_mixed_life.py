"""A life of several missions: Miner's sum over all flights."""

from functools import cache

import pytest

import gearwright as gw
import shipped_work
from gearwright.errors import DesignError
from gearwright.mission import mixed_life

SHORT = {"phases.cruise.duration_min": 25.0}


@cache
def lives():
    """Return what a long and a short flight do to one gearbox."""
    short = gw.edited_mission(gw.read_mission("thesis"), SHORT)
    return {"long": shipped_work.lives(), "short": gw.durability(gw.fly(shipped_work.sized(), short))}


def test_a_mix_of_one_mission_is_its_life():
    alone = lives()["long"]
    mix = mixed_life({"long": alone}, {"long": 1.0})
    found, wanted = ({(part.part, part.mode): part.damage for part in rows} for rows in (mix.parts, alone.parts))
    assert found == wanted and mix.parts[0].life == pytest.approx(alone.parts[0].life)
    assert mix.hours == alone.gears[0].hours


def test_damages_add_up_by_shares():
    mix = mixed_life(lives(), {"long": 0.25, "short": 0.75})
    sums = {name: {(part.part, part.mode): part.damage for part in lived.parts} for name, lived in lives().items()}
    for part in mix.parts:
        by_hand = 0.25 * sums["long"][part.part, part.mode] + 0.75 * sums["short"][part.part, part.mode]
        assert part.damage == pytest.approx(by_hand, rel=1e-14)
    assert mix.damage_after(30_000) == pytest.approx(30_000 * mix.parts[0].damage)
    assert mix.parts[0].flights * mix.parts[0].damage == pytest.approx(1.0)


def test_halves_of_one_mission_are_the_whole():
    alone = lives()["long"]
    mix = mixed_life({"one": alone, "other": alone}, {"one": 0.5, "other": 0.5})
    assert [part.damage for part in mix.parts] == pytest.approx([part.damage for part in alone.parts])


@pytest.mark.parametrize(
    ("shares", "said"),
    [
        ({"long": 0.5, "short": 0.6}, "shares: 1.1; they have to add up to 1"),
        ({"long": 1.0}, "short: is flown and has no share"),
        ({"long": 0.5, "short": 0.3, "ferry": 0.2}, "ferry: has a share and is not flown"),
        ({"long": 1.5, "short": -0.5}, "a share is a part of all flights, from 0 to 1"),
    ],
)
def test_shares_that_are_none_are_refused(shares, said):
    with pytest.raises(DesignError, match=said):
        mixed_life(lives(), shares)
