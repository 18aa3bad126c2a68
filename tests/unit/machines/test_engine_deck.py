"""An engine's deck: its nodes, between them, other days, other sizes, and what is no deck."""

import math

import pytest

from gearwright.air import air_at, stagnation_ratios
from gearwright.catalogue.turboshafts import deck_of, deck_text, read_engine_deck
from gearwright.errors import DesignError
from gearwright.machines import Day, deck_fuel, deck_limit

ROWS = [
    (altitude, mach, share * (1e6 - 60.0 * altitude) * (1.0 + mach), 0.01 + 0.06 * share)
    for altitude in (0.0, 3000.0, 6000.0)
    for mach in (0.0, 0.4)
    for share in (0.2, 0.6, 1.0)
]
DECK = deck_of(ROWS)


def day(altitude, mach, offset=0.0):
    theta, delta = stagnation_ratios(air_at(altitude, offset), mach)
    return Day(altitude, mach, theta, delta, theta / stagnation_ratios(air_at(altitude), mach)[0])


@pytest.mark.parametrize("row", ROWS)
def test_at_a_node_it_is_what_is_printed(row):
    altitude, mach, power, fuel = row
    assert deck_fuel(DECK, day(altitude, mach), power) == pytest.approx(fuel, rel=1e-12)
    top = (1e6 - 60.0 * altitude) * (1.0 + mach)
    assert deck_limit(DECK, day(altitude, mach), 1.0) == pytest.approx(top, rel=1e-12)


def test_between_nodes_corrected_power_is_linear_and_below_the_lever_the_line_goes_on():
    middle = day(1500.0, 0.2)
    corrected = [
        top * (1.0 + mach) / factor(day(altitude, mach))
        for altitude, top in ((0.0, 1e6), (3000.0, 8.2e5))
        for mach in (0.0, 0.4)
    ]
    assert deck_limit(DECK, middle, 1.0) == pytest.approx(0.25 * sum(corrected) * factor(middle), rel=1e-12)
    assert deck_fuel(DECK, day(0.0, 0.0), 0.0) == pytest.approx(0.01, rel=1e-12)


def factor(at):
    return at.delta * math.sqrt(at.theta)


def test_another_day_follows_similarity_and_its_lapse():
    """At one pressure P/√θ and m/√θ go together; the highest power with the day's lapse."""
    warm = day(3000.0, 0.4, 20.0)
    power = 6e5
    fuel = deck_fuel(DECK, day(3000.0, 0.4), power / math.sqrt(warm.warmer)) * math.sqrt(warm.warmer)
    assert deck_fuel(DECK, warm, power) == pytest.approx(fuel, rel=1e-12)
    assert deck_limit(DECK, warm, 0.8) == pytest.approx(0.8 * deck_limit(DECK, day(3000.0, 0.4), 1.0), rel=1e-12)


def test_a_larger_engine_burns_as_much_more():
    larger = DECK.scaled(1.5)
    assert larger.reference == pytest.approx((1.5e6, 0.105), rel=1e-12)
    assert deck_fuel(larger, day(4000.0, 0.1), 6e5) == pytest.approx(1.5 * deck_fuel(DECK, day(4000.0, 0.1), 4e5))


@pytest.mark.parametrize(("altitude", "mach"), [(6001.0, 0.0), (0.0, 0.41)])
def test_outside_it_says_what_it_holds(altitude, mach):
    with pytest.raises(ValueError, match="the deck holds 0 to"):
        deck_fuel(DECK, day(altitude, mach), 1e5)


def test_a_file_that_is_written_is_read_back(tmp_path):
    (tmp_path / "deck.csv").write_text(deck_text(DECK), encoding="utf-8")
    again = read_engine_deck(tmp_path / "deck.csv")
    assert again.altitude == DECK.altitude and again.mach == DECK.mach
    assert deck_fuel(again, day(1000.0, 0.1), 4e5) == pytest.approx(deck_fuel(DECK, day(1000.0, 0.1), 4e5), rel=1e-5)


HEAD = "altitude_m,mach,power_kw,fuel_kg_h\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (HEAD + "0,0,100,50\n0,0,200,80\n3000,0.3,100,40\n3000,0.3,150,50\n", "at 0 m and Mach 0.3 it has 0 powers"),
        (HEAD + "0,0,100,50\n0,0,200,45\n", "line 3: at 0 m and Mach 0 200 kW burn no more than 100 kW"),
        (HEAD + "0,0,100,50\n0,0,100,60\n", "line 3: .*100 kW is given twice"),
        (HEAD + "0,1.2,100,50\n0,0,-3,60\n", "(?s)line 2: mach is 1.2.*line 3: power_kw is -3"),
        (HEAD, "it has no rows"),
        ("altitude_m,mach,power_kw\n0,0,1\n", "lacks fuel_kg_h"),
        (HEAD + "0,0,a,1\n", "has no 4 numbers in line 2"),
    ],
)
def test_what_is_no_deck_is_told_with_line_and_fix(text, said, tmp_path):
    (tmp_path / "bad.csv").write_text(text, encoding="utf-8")
    with pytest.raises(DesignError, match=said):
        read_engine_deck(tmp_path / "bad.csv")
