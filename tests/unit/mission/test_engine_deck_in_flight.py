"""Flights by an engine's deck: its fuel at a node, its limits, two books, scaled engines, windows, what is refused."""

import numpy as np
import pytest

from gearwright.catalogue.turboshafts import deck_of, deck_text
from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.mission.windows.background import background
from gearwright.spec import parse_mission
from shipped_work import sized

TOP, BURNT = {0.0: 2.5e6, 6000.0: 1.6e6}, {0.0: 0.19, 6000.0: 0.11}
DECK = deck_of(
    (altitude, mach, share * top, (0.2 + 0.8 * share) * BURNT[altitude])
    for altitude, top in TOP.items()
    for mach in (0.0, 0.45)
    for share in (0.1, 0.5, 1.0)
)
ONE = """\
schema = 1
name = "one"
propeller_map = "6-blades-af115-all-states"
[engine]
deck = "deck.csv"
air_flow_kg_s = 9
[phases.cruise]
duration_min = 2
altitude_m = 6000
mach = 0.45
propeller_speed_rpm = 1212
power_kw = 800
[windows.quiet]
phase = "cruise"
duration_s = 0.02
"""


def flown(folder, *changes):
    text = ONE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "deck.csv").write_text(deck_text(DECK), encoding="utf-8")
    return fly(sized("in-line"), parse_mission(text, folder=folder), folder=folder)


def test_it_burns_what_the_deck_says_and_the_books_agree(tmp_path):
    flight = flown(tmp_path)
    power = flight.history.turbine_power
    share = power / 1.6e6
    assert flight.history.fuel_flow == pytest.approx((0.2 + 0.8 * share) * 0.11, rel=1e-5)
    assert flight.history.turbine_available == pytest.approx(np.full(len(power), 1.6e6), rel=1e-5)
    assert flight.balance.residual <= 1e-9
    assert np.all(flight.history.exhaust_temperature > 500.0)


def test_a_thermal_power_scales_it(tmp_path):
    larger = flown(tmp_path, ("air_flow", "thermal_power_kw = 3000\nair_flow"))
    share = larger.history.turbine_power / (1.2 * 1.6e6)
    assert larger.history.fuel_flow == pytest.approx(1.2 * (0.2 + 0.8 * share) * 0.11, rel=1e-5)


def test_a_window_knows_the_deck_and_the_engine_that_it_makes(tmp_path):
    flight = flown(tmp_path)
    supply = background(flight, flight.mission.windows["quiet"]).supply
    assert supply.deck == flight.engine_deck
    assert supply.engines["gas-turbine"].thermal_power == pytest.approx(2.5e6, rel=1e-5)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("power_kw = 800", "power_kw = 1700"), r"needs 1.* kW at 6000 m, and gives 1600 kW \(by its core\)"),
        (("altitude_m = 6000", "altitude_m = 7000"), "engine.deck: the deck holds 0 to 6000 m, and 7000 m is flown"),
        (("deck.csv", "none.csv"), "engine.deck: .*none.csv: there is no such file"),
        (("deck.csv", "../deck.csv"), "engine.deck"),
    ],
)
def test_what_the_deck_does_not_hold_is_refused_with_its_place(change, said, tmp_path):
    with pytest.raises(DesignError, match=said):
        flown(tmp_path, change)
