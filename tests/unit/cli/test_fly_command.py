"""The command ``fly``, called as its users call it."""

import json

import pytest
import typer
from typer.testing import CliRunner

from gearwright.cli.commands.flights import fly
from gearwright.errors import DesignError
from gearwright.shipped import shipped_mission

THESIS = shipped_mission("thesis").read_text(encoding="utf-8")
REGIONAL = shipped_mission("regional-250nm").read_text(encoding="utf-8")
APP = typer.Typer()
APP.command()(fly)


def run(*arguments, catch=True):
    """Return what a call gives."""
    return CliRunner().invoke(APP, list(arguments), catch_exceptions=catch)


def test_without_a_design_the_shipped_missions_are_listed():
    result = run()
    assert result.exit_code == 0
    assert "thesis" in result.output
    assert "regional-250nm" in result.output


def test_one_command_tells_fuel_charge_heat_and_the_part_that_fails_first(tmp_path):
    result = run("in-line-h2", "thesis", "--csv", str(tmp_path / "histories.csv"))
    assert result.exit_code == 0
    for word in ("Fuel", "State of charge", "Oil", "First to fail"):
        assert word in result.output
    assert (tmp_path / "histories.csv").read_text(encoding="utf-8").startswith("phase,")


def test_json_is_for_machines():
    result = run("in-line", "regional-250nm", "--json")
    assert json.loads(result.stdout)["result"]["balance"]["residual"] < 1e-6


def test_the_duty_of_every_mesh_shaft_and_bearing_is_part_of_the_json():
    """Classes rise in load and keep the time of the flight; 1e-9 is the rounding of sums."""
    told = json.loads(run("in-line-h2", "thesis", "--json").stdout)["result"]
    spectrum = told["spectrum"]
    assert {"first.sun-planet", "second.sun-planet"} <= set(spectrum["meshes"])
    assert "output" in spectrum["shafts"]
    assert "second.planet" in spectrum["bearings"]
    for kind, spectra in spectrum.items():
        for bins in spectra.values():
            assert sum(row["time_s"] for row in bins) == pytest.approx(told["duration_s"], rel=1e-9)
            loads = [row["force_n" if kind == "bearings" else "torque_nm"] for row in bins]
            assert loads == sorted(loads)
            assert all(row["turns"] == pytest.approx(row["speed_rpm"] * row["time_s"] / 60.0) for row in bins)


def test_json_has_no_infinity():
    """The second pinion's flanks pass their static limit in hover: its damage is ∞, and it lives no flight."""
    result = run("face-gear-split-torque", "rotor-schedule", "--json")
    told = json.loads(result.stdout, parse_constant=pytest.fail)["result"]
    first = {"part": "second.pinion", "mode": "pitting", "damage": None, "flights": 0.0, "life_h": 0.0}
    assert told["damage"][0] == first


def test_a_window_without_a_page_is_refused():
    with pytest.raises(DesignError, match="name its file with --report"):
        run("in-line-h2", "thesis", "--window", "gust", catch=False)


def test_a_battery_that_no_motor_uses_is_not_told():
    assert "State of charge" not in run("in-line", "equal-power").output


def test_a_flight_with_gears_that_are_not_rated_says_why():
    result = run("face-gear-split-torque", "rotor-schedule")
    assert result.exit_code == 0
    assert "ISO 6336 rates cylindrical gears only" in result.output
    assert "First to fail of what is rated: " in result.output


def test_a_life_is_bought_with_mass():
    result = run("in-line-h2", "thesis", "--life-h", "2000")
    assert "costs" in result.output


def test_one_command_writes_the_page_of_a_flight(tmp_path):
    page, mission = tmp_path / "flight.html", tmp_path / "mission.toml"
    window = '[windows.cut]\nphase = "cruise"\nevent = "motor-cut"\nevent_at_s = 0.1\nduration_s = 0.2\n'
    mission.write_text(f"{THESIS}\n{window}", encoding="utf-8")
    result = run("in-line-h2", str(mission), "--report", str(page), "--window", "cut")
    assert result.exit_code == 0
    told = page.read_text(encoding="utf-8")
    assert "First gear to fail: first.sun" in told
    assert "Window cut" in told


REFUSED = {
    "outside the map": (
        ("in-line-h2", THESIS, "pitch_deg = 10", "pitch_deg = 3"),
        "phases.taxi-out: at 5 s, propeller.map: .*blade angle 3°: outside the map, which spans .* change speed",
    ),
    "a climb without power": (
        ("in-line", REGIONAL, "ft_min = 900", "ft_min = 2900"),
        "phases.climb: at 437 s, gas-turbine: needs 2820 kW at 74 m, and gives 1930 kW .by its torque.; climb slower",
    ),
    "an empty battery": (
        ("in-line-h2", THESIS, "energy_kwh = 700", "energy_kwh = 400"),
        r"phases.cruise: at \d+ s, battery: empty: .*minimum 0.1.*; lower electric_share",
    ),
    "a gap between phases": (
        ("in-line-h2", THESIS, "rate_of_climb_ft_min = 1500", "rate_of_climb_ft_min = 1500\nfrom_altitude_ft = 3000"),
        "phases.climb: it starts at 3000 ft .914 m., but the phase before ended at 1500 ft .457 m.; make them equal",
    ),
    "a map that is not there": (
        ("in-line-h2", THESIS, '"6-blades-af115"', '"nowhere.csv"'),
        "propeller_map: .*nowhere.csv: there is no such file",
    ),
    "two speeds": (
        ("in-line-h2", THESIS, "tas_kt = 313", "tas_kt = 313\nmach = 0.52"),
        "phases.cruise: tas and mach given; give one of cas, tas and mach",
    ),
}


@pytest.mark.parametrize(("change", "expected"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_flown_is_named_with_line_value_and_fix(tmp_path, change, expected):
    design, text, old, new = change
    path = tmp_path / "mission.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(DesignError, match=rf"line \d+: {expected}") as raised:
        run(design, str(path), catch=False)
    assert str(raised.value).startswith(str(path))


def test_the_forces_of_an_aircraft_are_part_of_the_json():
    """Thrust is what drag, path and what is left over come to: a sum, to rounding."""
    told = json.loads(run("in-line", "regional-aircraft", "--json").stdout)["result"]["forces"]
    assert [row["name"] for row in told][:3] == ["taxi-out", "stop", "run-up"]
    for row in told:
        assert row["thrust_n"] == pytest.approx(row["drag_n"] + row["path_n"] + row["left_over_n"])
        assert row["implied_m_s2"] == pytest.approx(row["left_over_n"] / row["mass_kg"])
    assert told[3]["roll_m"] == pytest.approx(903.0, abs=1.0)  # as the how-to page shows it


def test_a_mission_without_an_aircraft_has_no_forces():
    assert json.loads(run("in-line-h2", "thesis", "--json").stdout)["result"]["forces"] == []
