"""The command ``turboshaft``, called as its users call it."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.catalogue import read_engine_deck
from gearwright.cli.commands.flights import turboshaft
from gearwright.errors import DesignError

APP = typer.Typer()
APP.command()(turboshaft)
ENGINE = ("--power-kw", "835", "--fuel-kg-kwh", "0.35", "--air-flow-kg-s", "3.609", "--pressure-ratio", "9",
          "--n1-rpm", "43000", "--altitudes-m", "0:6000:6000", "--machs", "0:0.4:0.4")  # fmt: skip
ROTOR = ("--rotor-inertia-kg-m2", "1", "--n2-rpm", "19000")


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, [*ENGINE, *arguments], catch_exceptions=catch)


def test_it_shows_the_deck_and_what_a_mission_says_and_writes_it(tmp_path):
    shown = run("--out", str(tmp_path / "deck.csv"))
    assert shown.exit_code == 0
    for words in ("consumption", "0.3500", "thermal_power_kw = 835", "idle_fuel =", "deck of 28 rows"):
        assert words in shown.output
    power, fuel = read_engine_deck(tmp_path / "deck.csv").reference
    assert power == pytest.approx(835e3, rel=1e-5) and 3.6e6 * fuel / power == pytest.approx(0.35, rel=1e-5)


def test_a_slam_a_held_rotor_and_a_start_have_seconds():
    slam = run("--slam-kw", "500:600", "--slam-s", "2").output
    assert "Lever" in slam and "95 % of the change of power have come after" in slam
    both = run("--slam-kw", "300:700", "--slam-s", "1", *ROTOR, "--starter-nm", "60").output
    for words in (
        "Rotor held by a governor on N2",
        "; N2 is from 9",
        " to 100.0 %",
        "Start; P is the starter's",
        "At idle after",
        "the starter gave",
    ):
        assert words in both


def test_a_load_that_goes_tells_the_overspeed_and_its_limit():
    shown = run("--slam-kw", "700:50", "--slam-s", "2", *ROTOR, "--n2-limit", "1.05").output
    assert "N2 is from 100.0 to 10" in shown and "bound by N2" in shown


def test_its_json_has_the_deck_and_the_seconds():
    found = json.loads(run("--slam-kw", "300:700", "--slam-s", "1", *ROTOR, "--json").output)["result"]
    assert len(found["rows"]) == 28 and found["start"] is None
    assert found["slam"]["lowest_rotor"] < 1.0 and found["slam"]["rows"][0]["power_kw"] == pytest.approx(300.0)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--slam-kw", "300"), "is not from:to, such as 300:800"),
        (("--slam-kw", "300:2000"), "leave 835 kW in air of 15.0 °C; ask for powers that it gives there"),
        (("--slam-kw", "300:700", "--slam-altitude-m", "15000"), "leave 191.7 kW in air of -56.5 °C"),
        (("--slam-kw", "300:700", "--slam-mach", "5"), "mach: 5 is not allowed; give one from 0 to 0.95"),
        (
            ("--slam-kw", "300:700", *ROTOR, "--n2-limit", "0.9"),
            "highest: 0.9 is not allowed; give an N2 limit",
        ),
        (("--n2-rpm", "19000"), "--rotor-inertia-kg-m2: a rotor is given without it"),
        (ROTOR, "--slam-kw: a rotor is given, and no power that changes"),
        (("--pressure-ratio", "2", "--compressor", "0.2"), "(?s)pressure_ratio: 2 is not.*compressor: 0.2 is not"),
        (("--fuel-kg-kwh", "0.1"), "power turbine would need an efficiency"),
    ],
)
def test_what_cannot_be_is_told(arguments, said):
    with pytest.raises(DesignError, match=said):
        run(*arguments, catch=False)
