"""The mission file: what it may say, and what it may not."""

import tomllib

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_mission, shipped_missions
from gearwright.spec import parse_mission, read_mission

HEAD = 'schema = 1\nname = "test"\n'
PHASE = "altitude_m = 0\nmach = 0.1\nduration_s = 60\npower_kw = 500\npropeller_speed_rpm = 1000\n"


def message(text):
    """Return what is said against a mission."""
    with pytest.raises(DesignError) as error:
        parse_mission(HEAD + text)
    return str(error.value)


@pytest.mark.parametrize("name", shipped_missions())
def test_a_shipped_mission_is_flown_in_the_order_of_its_file(name):
    written = tomllib.loads(shipped_mission(name).read_text(encoding="utf-8"))["phases"]
    assert list(read_mission(shipped_mission(name)).phases) == list(written)


def test_two_kinds_of_speed_at_once_are_refused():
    assert "cas and mach given; give one" in message("[phases.a]\ncas_kt = 170\n" + PHASE)


def test_a_phase_without_speed_is_refused():
    assert "no speed given" in message("[phases.a]\n" + PHASE.replace("mach = 0.1\n", ""))


def test_a_phase_that_starts_where_the_last_did_not_end_is_refused():
    second = "[phases.b]\nfrom_altitude_m = 1000\n" + PHASE.replace("altitude_m = 0", "altitude_m = 2000")
    assert "starts at 3281 ft (1000 m), but the phase before ended at 0 ft (0 m)" in message(
        "[phases.a]\n" + PHASE + second
    )


def test_a_climb_that_goes_down_is_refused():
    up = PHASE.replace("altitude_m = 0", "from_altitude_m = 0\naltitude_m = 1000")
    assert "never leads" in message("[phases.a]\n" + up.replace("duration_s = 60", "rate_of_climb_ft_min = -500"))


def test_duration_and_rate_of_climb_together_are_refused():
    assert "one of duration and rate_of_climb" in message("[phases.a]\nrate_of_climb_m_s = 5\n" + PHASE)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("pitch_deg = 20", "power and pitch given"),
        ('mode = "hybrid"', "hybrid without electric_share"),
        ("electric_share = 0.5", "electric_share in conventional mode"),
        ('mode = "electric"', "without a [battery]"),
        ("engines = 3", "3 engines work of 1"),
        ("power_kW = 3", "did you mean power_kw"),
    ],
)
def test_what_contradicts_itself_is_refused(line, expected):
    assert expected in message(f"[phases.a]\n{line}\n{PHASE}")


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("duration_h = 250", "cuts the phases into 90,002 intervals, at most 10,000"),
        ("from_altitude_m = 0\nrate_of_climb_m_s = 1e-5", "at most 10,000 are flown"),
    ],
)
def test_more_intervals_than_can_be_flown_are_refused_with_their_number(line, told):
    phase = PHASE.replace("duration_s = 60\n", "").replace("altitude_m = 0\n", "altitude_m = 10\n")
    assert told in message(f"[phases.a]\n{line}\n{phase}")


def test_a_battery_that_gains_voltage_as_it_empties_is_refused():
    battery = "[battery]\nenergy_kwh = 10\nfull_voltage_v = 500\nempty_voltage_v = 600\n"
    assert "500 V is less than the 600 V at no charge" in message(battery + "[phases.a]\n" + PHASE)


@pytest.mark.parametrize("dip", [-0.1, 1.5])
def test_a_gear_dips_into_oil_between_not_at_all_and_fully(dip):
    assert f"{dip:g} of a gear cannot dip" in message(f'[oil.dip]\n"first.ring" = {dip}\n[phases.a]\n' + PHASE)


def test_a_steel_that_no_table_has_is_refused():
    assert "gears.steel: 'butter' is not known" in message('[gears]\nsteel = "butter"\n[phases.a]\n' + PHASE)


def test_nothing_that_sets_the_power_is_refused():
    assert "nothing sets its power" in message("[phases.a]\n" + PHASE.replace("power_kw = 500\n", ""))


def test_every_problem_comes_at_once():
    text = message("[phases.a]\ncas_kt = 170\npitch_deg = 20\n" + PHASE)
    assert "cas and mach" in text
    assert "power and pitch" in text


def test_a_text_that_is_no_toml_is_refused():
    assert "not TOML" in message("[phases")


def test_a_mission_without_a_propeller_map_needs_powers():
    text = 'propeller_map = "none"\n[phases.a]\npitch_deg = 12\n' + PHASE.replace("power_kw = 500\n", "")
    assert "without a propeller map" in message(text)
