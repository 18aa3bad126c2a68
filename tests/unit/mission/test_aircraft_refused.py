"""What an aircraft cannot fly, or a mission says twice, is refused with place, value, what is allowed and the fix."""

import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly, phase_forces
from gearwright.shipped import shipped_design, shipped_mission
from gearwright.sizing import size
from gearwright.spec import edited_mission, parse_mission, read, read_mission

PLAIN = size(read(shipped_design("in-line")))
HEAD = """
schema = 1
name = "test"
engines = 2
propeller_map = "6-blades-af115"
[engine]
thermal_power_kw = 2600
[aircraft]
mass_kg = 21000
wing_area_m2 = 61
zero_lift_drag = 0.025
aspect_ratio = 12
oswald = 0.75
highest_lift = 1.4
[aircraft.take_off]
highest_lift = 1.8
extra_drag = 0.015
"""
CRUISE = """
[phases.cruise]
kind = "cruise"
altitude_ft = 10000
tas_kt = 230
duration_min = 2
propeller_speed_rpm = 984
"""
CLIMB = """
[phases.climb]
kind = "climb"
from_altitude_ft = 0
altitude_ft = 10000
cas_kt = 170
rate_of_climb_ft_min = 900
propeller_speed_rpm = 984
"""
TAKE_OFF = """
[phases.take-off]
kind = "take-off"
from_altitude_ft = 0
altitude_ft = 35
power_kw = 1850
propeller_speed_rpm = 1200
"""


def said(text):
    """Return what is wrong with a mission as it is written."""
    with pytest.raises(DesignError) as error:
        parse_mission(HEAD + text)
    return str(error.value)


def refused(text, head=HEAD, sizing=PLAIN):
    """Return why a mission is not flown."""
    with pytest.raises(DesignError) as error:
        fly(sizing, parse_mission(head + text))
    return str(error.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (CRUISE.replace("duration_min = 2", ""), "nothing given; a cruise needs one of duration, distance"),
        (CRUISE + "distance_nmi = 5\n", "duration and distance given; a cruise needs one of"),
        (CRUISE + "power_kw = 1500\n", "tas and power given; a cruise at a power finds its speed"),
        (CRUISE + "path_angle_deg = 3\n", "a cruise does not read path_angle"),
        (CRUISE.replace("duration_min = 2", "duration_min = 0"), "duration_min"),
        (CRUISE.replace("duration_min = 2", "distance_nmi = 0"), "distance_nmi"),
        (CLIMB + "power_kw = 1500\n", "rate_of_climb and power given; a climb needs one of"),
        (CLIMB.replace("= 900", "= -900"), "turn its sign"),
        (CLIMB.replace("altitude_ft = 10000", "altitude_ft = 0"), "up, and this one from 0 ft (0 m) to 0 ft (0 m)"),
        (CLIMB + "tas_kt = 200\n", "cas and tas given; give one of cas, tas, mach"),
        (TAKE_OFF.replace("power_kw = 1850", ""), "a take-off needs one of power, pitch"),
        (TAKE_OFF + "end_power_kw = 900\n", "end_power in a phase that an aircraft flies"),
        (CRUISE + "from_tas_kt = 200\n", "starts at the speed of the one before"),
        (CRUISE.replace('"cruise"', '"landing"').replace("duration_min = 2", "power_kw = 400"),
         "rolls from the speed at which the phase before ended"),
        (CRUISE.replace('kind = "cruise"', 'kind = "hover"'), "kind"),
        (CRUISE.replace('kind = "cruise"\n', 'path_angle_deg = 3\n'), "path_angle is read where an aircraft flies"),
    ],
)  # fmt: skip
def test_phases_that_contradict_themselves_are_refused(text, message):
    assert message in said(text)


def test_a_kind_without_an_aircraft_is_refused():
    with pytest.raises(DesignError, match=r"without an \[aircraft\]"):
        parse_mission('schema = 1\nname = "test"\n' + CRUISE)


def test_an_aircraft_says_its_induced_drag_once():
    with pytest.raises(DesignError, match="give induced_drag, or aspect_ratio and oswald"):
        parse_mission(HEAD.replace("oswald = 0.75", "oswald = 0.75\ninduced_drag = 0.03") + CRUISE)


def test_flaps_that_lift_less_than_none_are_refused():
    with pytest.raises(DesignError, match="less than the clean"):
        parse_mission(HEAD.replace("highest_lift = 1.8", "highest_lift = 1.2") + CRUISE)


def test_an_airspeed_that_jumps_is_told_with_its_acceleration():
    message = refused(CLIMB + CRUISE.replace("tas_kt = 230", "tas_kt = 265"))
    assert "phases.cruise" in message
    assert "starts at 136.3 m/s, and the phase before ended at 101.4 m/s" in message
    assert "within a step of 10 s that is 3.49 m/s²" in message
    assert 'kind "speed-change"' in message


def test_a_plain_mission_is_told_of_its_jumps_and_of_the_thrust_that_is_left_over():
    plain = CLIMB.replace('kind = "climb"\n', "") + CRUISE.replace('kind = "cruise"\n', "power_kw = 1700\n")
    climb, cruise = phase_forces(fly(PLAIN, parse_mission(HEAD + plain)))
    assert cruise.jump == pytest.approx(118.3 - 101.4, abs=0.1)  # 230 kt after 170 kt CAS at 10 000 ft
    assert cruise.jump_acceleration == pytest.approx(cruise.jump / 10.0)
    assert cruise.left_over > 5e3  # 3.4 MW are more than 230 kt take
    assert cruise.implied == pytest.approx(cruise.left_over / cruise.mass)
    assert abs(climb.left_over) < 0.01 * climb.thrust  # its thrust was asked for


def test_a_descent_steeper_than_drag_allows_says_so():
    descent = CRUISE + CRUISE.replace("cruise", "down").replace('kind = "down"', 'kind = "descent"').replace(
        "altitude_ft = 10000", "altitude_ft = 2000"
    ).replace("duration_min = 2", "rate_of_climb_ft_min = -3000").replace("tas_kt = 230", "tas_kt = 230")
    message = refused(descent)
    assert "phases.down" in message
    assert "would have to brake by" in message
    assert "sink or slow down more gently" in message


def test_a_descent_that_only_a_windmill_would_hold_says_so_before_it_speaks_of_the_turbine():
    shipped = read_mission(shipped_mission("regional-aircraft"))
    mission = edited_mission(shipped, {"phases.descent.rate_of_climb_ft_min": -6000.0})
    with pytest.raises(DesignError) as error:
        fly(PLAIN, mission)
    first, second = error.value.problems
    assert "drag holds the aircraft by less than it weighs down the path: each propeller brakes by" in first.message
    assert "a turbine only gives" in second.message


def test_a_power_that_never_climbs_is_not_told_to_stop_lower():
    message = refused(CLIMB.replace("rate_of_climb_ft_min = 900", "power_kw = 500"))
    assert "does not climb at 0 ft (0 m) with this power" in message
    assert "stop lower" not in message


def test_a_key_that_is_misspelt_is_told_once_with_the_one_that_is_meant():
    """It was told twice: as unknown, and the one that is meant as missing."""
    with pytest.raises(DesignError) as error:
        parse_mission(HEAD.replace("wing_area_m2", "wing_aera_m2") + CRUISE)
    (problem,) = error.value.problems
    assert problem.message == "no such field; did you mean wing_area_m2?"


def test_a_ceiling_in_metres_that_was_meant_in_feet_is_told_with_its_range():
    with pytest.raises(DesignError, match=r"ceiling_m: 25000 m is not allowed; give a value from .* to 20000 m"):
        parse_mission(HEAD.replace("highest_lift = 1.4", "highest_lift = 1.4\nceiling_m = 25000") + CRUISE)


def test_an_altitude_above_the_ceiling_is_refused_as_stated():
    ceiling = HEAD.replace("highest_lift = 1.4", "highest_lift = 1.4\nceiling_ft = 9000")
    message = refused(CRUISE, ceiling)
    assert "10000 ft (3048 m) is above the ceiling of 9000 ft (2743 m); fly lower" in message


def test_an_altitude_above_the_ceiling_of_a_power_is_refused_where_the_climb_ends():
    weak = CLIMB.replace("rate_of_climb_ft_min = 900", "power_kw = 700").replace("10000", "25000")
    message = refused(weak)
    assert "does not climb at" in message
    assert "that is its ceiling" in message


def test_a_speed_change_that_its_power_does_not_make_is_refused():
    faster = CRUISE + CRUISE.replace("cruise", "faster").replace('kind = "faster"', 'kind = "speed-change"').replace(
        "tas_kt = 230", "tas_kt = 300"
    ).replace("duration_min = 2", "power_kw = 900")
    assert "does not come from 118.3 to 154.3 m/s" in refused(faster)


def test_flight_below_the_stall_is_refused():
    message = refused(CRUISE.replace("tas_kt = 230", "tas_kt = 110"))
    assert "stalls below" in message
    assert "flaps 'clean'" in message


def test_fuel_that_is_not_on_board_is_not_burnt():
    head = HEAD.replace("highest_lift = 1.4", "highest_lift = 1.4\nfuel_kg = 5")
    assert "kg are burnt, and 5 kg are on board" in refused(CRUISE, head)


def test_a_battery_that_empties_in_the_take_off_is_told_with_its_phase():
    hybrid = size(read(shipped_design("in-line-h2")))
    head = HEAD + "[battery]\nenergy_kwh = 10\nhighest_c_rate = 60\nresistance_ohm = 0\n[motor]\noverload = 1.1\n"
    run_up = (
        "[phases.run-up]\naltitude_ft = 0\ntas_kt = 0\nduration_s = 5\npower_kw = 900\npropeller_speed_rpm = 1200\n"
    )
    message = refused(run_up + TAKE_OFF + 'mode = "hybrid"\nelectric_share = 0.49\n', head, hybrid)
    assert "phases.take-off" in message
    assert "battery" in message


def test_a_mission_without_kinds_has_no_paths():
    plain = CRUISE.replace('kind = "cruise"\n', "")
    flight = fly(PLAIN, parse_mission(HEAD + plain))
    assert not flight.paths


def test_a_descent_that_only_blades_below_the_angle_of_least_power_would_hold_is_refused():
    """It was flown with the thrust of the other blade angle that takes the same power, 68 kN off the path."""
    shipped = read_mission(shipped_mission("regional-aircraft"))
    mission = edited_mission(shipped, {"phases.descent.rate_of_climb_ft_min": -9000.0})
    with pytest.raises(DesignError, match=r"would have to brake by 29\.9 kN, and governed it does not"):
        fly(PLAIN, mission)
