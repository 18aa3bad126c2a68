"""Flights that no propeller, battery, engine or air allows: what is said, and where."""

import pytest

import gearwright as gw
from gearwright.catalogue import map_text
from gearwright.errors import DesignError
from gearwright.machines import Blades
from gearwright.spec import parse_mission
from shipped_work import sized

ONE = """\
schema = 1
name = "one"
engines = 1
propeller_map = "6-blades-af115-all-states"
[phases.cruise]
duration_min = 10
altitude_m = 5000
tas_m_s = 140
propeller_speed_rpm = 1212
power_kw = 600
"""
HYBRID = 'power_kw = 600\nmode = "hybrid"\nelectric_share = 0.9\n[battery]\nenergy_kwh = 2\nhighest_c_rate = 100\n'


def fly(text, folder=None):
    """Fly a mission with the hybrid of the thesis."""
    return gw.fly(sized(), parse_mission(text, folder=folder), folder=folder)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("altitude_m = 5000", "altitude_m = 12000", r"gas-turbine: needs 600 kW at 12000 m, and gives \d+"),
        ("altitude_m = 5000", "altitude_m = 25000", "25000 m is not allowed"),
        (
            "engines = 1",
            "engines = 1\nisa_offset_k = -100",
            r"isa_offset_k: -100 is not allowed; give a value from -60",
        ),
        ("power_kw = 600\n", "power_kw = 600\n[oil]\ninlet_temperature_k = 193\n", "193 is not allowed; give a value"),
        (
            "power_kw = 600\n",
            "power_kw = 600\n[oil.network]\noil_mass_kg = 12\nhousing_mass_kg = 40\nbearing_mass_kg = 15\n"
            "gears_to_oil_w_k = 400\nbearings_to_oil_w_k = 300\ncooler_w_k = 300\nstart_temperature_k = 193.15\n",
            r"at 5 s, oil: at -80\.0 °C it has 1\.64e\+08 mm²/s, .* no pump moves it; heat it before the start",
        ),
        ("power_kw = 600\n", HYBRID, r"phases\.cruise: at \d+ s, battery: "),
    ],
)
def test_what_cannot_be_flown_is_refused_with_its_place(old, new, said):
    assert old in ONE
    with pytest.raises(DesignError, match=said):
        fly(ONE.replace(old, new))


def test_a_power_beyond_the_stall_names_the_stall(tmp_path):
    made = gw.propeller(Blades(2, 60.0, 0.5))
    (tmp_path / "weak.csv").write_text(map_text(made.chart), encoding="utf-8")
    text = ONE.replace("6-blades-af115-all-states", "weak.csv").replace("= 1212", "= 700").replace("= 140", "= 60")
    with pytest.raises(DesignError, match=r"phases\.cruise: at \d+ s, propeller\.map: .* the blades stall at \d"):
        fly(text, tmp_path)


def test_maps_with_holes_are_refused_by_the_mission_that_names_them(tmp_path):
    lines = map_text(gw.propeller(Blades(6, 115.0, 0.5)).chart).splitlines()
    (tmp_path / "hole.csv").write_text("\n".join(lines[:100] + lines[101:]), encoding="utf-8")
    with pytest.raises(DesignError, match="advance ratio 0.1 has a gap between its blade angles".replace(".", r"\.")):
        fly(ONE.replace("6-blades-af115-all-states", "hole.csv"), tmp_path)


def test_rows_of_a_map_may_stand_in_any_order(tmp_path):
    """Angles that do not rise in the file are sorted: the flight is the same, bit for bit."""
    lines = map_text(gw.propeller(Blades(6, 115.0, 0.5)).chart).splitlines()
    text, thrusts = ONE.replace("6-blades-af115-all-states", "map.csv"), []
    for rows in (lines[1:], lines[:0:-1]):
        (tmp_path / "map.csv").write_text("\n".join([lines[0], *rows]), encoding="utf-8")
        thrusts.append(fly(text, tmp_path).history.thrust.tolist())
    assert thrusts[0] == thrusts[1]
