"""A life of several missions: the file, what is wrong with it, and what it burns and wears."""

from functools import cache

import pytest

import gearwright as gw
import shipped_work
from gearwright.errors import DesignError
from gearwright.spec import parse_mix

HEAD = 'schema = 1\nname = "m"\n'
BEARINGS = "[bearings]\nlife_h = 5000\n"
ONE = f'{HEAD}flights = 100\n[missions.only]\nmission = "thesis"\nshare = 1\n'
TWO = """\
[missions.long]
mission = "thesis"
share = 0.25
[missions.short]
mission = "thesis"
share = 0.75
changes = { "phases.cruise.duration_min" = 20 }
"""


@cache
def flown(text):
    """Return the life of that gearbox over a mix."""
    return gw.mix(shipped_work.sized(), parse_mix(text))


def sums(life):
    """Return part and mode -> Miner's sum of a mean flight."""
    return {(part.part, part.mode): part.damage for part in life.parts}


def test_one_mission_with_all_flights_is_that_mission_alone():
    life = flown(ONE)
    flight = shipped_work.flown()
    assert sums(life.life) == sums(gw.durability(flight))
    assert life.fuel == pytest.approx(100 * flight.fuel, rel=1e-12)
    assert life.battery == pytest.approx(100 * flight.balance.battery, rel=1e-12)
    assert life.duration == pytest.approx(100 * flight.duration, rel=1e-12)


def test_the_order_of_missions_does_not_matter():
    """Sums of two numbers in either order; 1e-12 is their rounding."""
    first, second = TWO.split("[missions.short]")
    turned = flown(f"{HEAD}flights = 1000\n[missions.short]{second}{first}")
    straight = flown(f"{HEAD}flights = 1000\n{TWO}")
    assert sums(turned.life) == pytest.approx(sums(straight.life), rel=1e-12)
    assert turned.fuel == pytest.approx(straight.fuel, rel=1e-12)


def test_damage_adds_up_over_missions_and_over_flights():
    life = flown(f"{HEAD}flights = 1000\n{TWO}")
    for part in life.life.parts:
        by_mission = life.damage_by_mission(part)
        assert sum(by_mission.values()) == pytest.approx(1000 * part.damage, rel=1e-12)
        alone = {name: sums(lived)[part.part, part.mode] for name, lived in life.lives.items()}
        assert by_mission == pytest.approx({"long": 250 * alone["long"], "short": 750 * alone["short"]}, rel=1e-12)
    assert life.damage == pytest.approx(1000 / life.life.parts[0].flights)


def test_counts_say_the_same_as_shares():
    counted = TWO.replace("share = 0.25", "count = 250").replace("share = 0.75", "count = 750")
    assert sums(flown(HEAD + counted).life) == pytest.approx(sums(flown(f"{HEAD}flights = 1000\n{TWO}").life))
    assert parse_mix(HEAD + counted).flights == 1000


def test_the_shipped_life_has_one_bearing_a_seat_that_lives_what_each_mission_leaves_it():
    life = gw.mix(shipped_work.sized(), gw.read_mix("regional-life"))
    assert life.mix.flights == 30_000 and len(life.mix.missions) == 3
    for seat in {row.seat for lived in life.lives.values() for row in lived.bearings.rows}:
        rows = [row for lived in life.lives.values() for row in lived.bearings.rows if row.seat == seat]
        assert len(rows) == 3 and len({row.bearing.designation for row in rows}) == 1
        mixed = next(part for part in life.life.parts if (part.part, part.is_bearing) == (seat, True))
        lives = [row.life for row in rows]
        assert min(lives) <= mixed.life <= max(lives)


def test_where_missions_choose_other_bearings_the_largest_is_taken_for_all():
    """5000 h of either mission alone take other bearings at the second planet; else this asks nothing."""
    short = f'{HEAD}flights = 10\n{BEARINGS}[missions.a]\nmission = "thesis"\nshare = 0.5\n[missions.b]\n'
    short += 'mission = "strategies"\nshare = 0.5\n'
    mix = parse_mix(short)
    alone = [gw.durability(gw.fly(shipped_work.sized(), mission)).bearings.rows for mission in mix.missions.values()]
    assert len({row.bearing.designation for rows in alone for row in rows if row.seat == "second.planet"}) == 2
    taken = {row.seat: row.bearing for row in gw.mix(shipped_work.sized(), mix).lives["b"].bearings.rows}
    for rows in alone:
        for row in rows:
            assert taken[row.seat].dynamic_rating >= row.bearing.dynamic_rating


def _missions(*tables):
    return f"{HEAD}flights = 10\n" + "".join(f"[missions.{table}\n" for table in tables)


REFUSED = {
    "shares": (
        _missions('a]\nmission = "thesis"\nshare = 0.6'),
        r"missions: their shares add up to 0\.6; they have",
    ),
    "unknown": (
        _missions('a]\nmission = "thesi"\nshare = 1'),
        r"a\.mission: there is no shipped mission 'thesi'",
    ),
    "no file": (
        _missions('a]\nmission = "no.toml"\nshare = 1'),
        r"a\.mission: .*no\.toml: there is no such file",
    ),
    "above": (_missions('a]\nmission = "../x.toml"\nshare = 1'), r"missions\.a\.mission: .*this path leads upwards"),
    "a mix": (
        _missions('a]\nmission = "regional-life"\nshare = 1'),
        r"'regional-life' is a mix itself; a mix is",
    ),
    "no flights": (ONE.replace("= 100", "= 0"), r"flights: 0 is not allowed.*1"),
    "flights left out": (ONE.replace("flights = 100\n", ""), r"flights: is required beside shares; write how many"),
    "neither": (_missions('a]\nmission = "thesis"'), r"missions\.a: neither is given; give share"),
    "both": (_missions('a]\nmission = "thesis"\nshare = 1\ncount = 10'), r"missions\.a: both are given; give share"),
    "unlike": (
        _missions('a]\nmission = "thesis"\nshare = 1', 'b]\nmission = "thesis"\ncount = 1'),
        r"missions: some have a share and some a count; give all of them the same",
    ),
    "counts": (
        _missions('a]\nmission = "thesis"\ncount = 7'),
        r"flights: 10 flights, and counts of 7; leave",
    ),
    "no missions": (f"{HEAD}flights = 10\n[missions]\n", r"missions: {} is not allowed; give at least one"),
    "a change": (
        _missions('a]\nmission = "thesis"\nshare = 1\nchanges = { "phases.cruis.duration_min" = 1 }'),
        r"missions\.a\.changes\.phases\.cruis\.duration_min: .*did you mean",
    ),
    "a mission": ("schema = 1\n[phases.a]\n", r"phases: this is a mission; gearwright fly DESIGN"),
}


@pytest.mark.parametrize(("text", "said"), REFUSED.values(), ids=REFUSED)
def test_what_is_wrong_with_a_mix_is_told_with_its_path(text, said):
    with pytest.raises(DesignError, match=said):
        parse_mix(text)


def test_all_that_is_wrong_is_told_at_once():
    with pytest.raises(DesignError) as raised:
        parse_mix(_missions('a]\nmission = "thesi"\nshare = 0.5', 'b]\nmission = "no.toml"\nshare = 0.6'))
    assert {problem.path for problem in raised.value.problems} == {
        "missions",
        "missions.a.mission",
        "missions.b.mission",
    }


def test_a_mix_in_a_file_of_a_mix_is_refused(tmp_path):
    (tmp_path / "inner.toml").write_text(ONE, encoding="utf-8")
    (tmp_path / "outer.toml").write_text(ONE.replace('"thesis"', '"inner.toml"'), encoding="utf-8")
    with pytest.raises(DesignError, match=r"line \d+: missions.only.mission: 'inner.toml' is a mix itself"):
        gw.read_mix(tmp_path / "outer.toml")


def test_a_mission_that_the_design_cannot_fly_is_named():
    text = _missions('easy]\nmission = "thesis"\nshare = 0.5', 'hard]\nmission = "regional-aircraft"\nshare = 0.5')
    with pytest.raises(DesignError, match=r"missions\.hard: phases\.take-off: at \d+ s, gas-turbine: needs"):
        gw.mix(shipped_work.sized(), parse_mix(text))


def test_a_mix_is_no_mission_and_who_flies_it_is_told_the_command():
    with pytest.raises(DesignError, match="'regional-life' is a mix of missions; gearwright mix DESIGN regional-life"):
        gw.read_mission("regional-life")
