"""What no aircraft flies is refused with the reason, whatever the numbers."""

import pytest

from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import parse_mission, read

HYBRID = size(read(shipped_design("in-line-h2")))
BASE = """
schema = 1
name = "test"
[aircraft]
mass_kg = 20000
wing_area_m2 = 60
zero_lift_drag = 0.025
induced_drag = 0.03
[phases.one]
altitude_ft = 5000
cas_kt = 170
duration_min = 2
propeller_speed_rpm = 1212
"""
POWER = BASE + "power_kw = 900\n"


def refused(text, sizing=HYBRID):
    """Return why a mission is not flown."""
    with pytest.raises(DesignError) as error:
        fly(sizing, parse_mission(text))
    return str(error.value)


@pytest.mark.parametrize("speed", ["0", "1e-5", "8"])
def test_a_wing_that_does_not_fly_bears_nothing(speed):
    assert "no wing bears 196.1 kN; fly faster" in refused(BASE.replace("cas_kt = 170", f"tas_m_s = {speed}"))


def test_an_aircraft_does_not_climb_faster_than_it_flies():
    text = BASE.replace("altitude_ft = 5000", "from_altitude_m = 0\naltitude_m = 5000")
    slow = text.replace("cas_kt = 170", "tas_m_s = 60").replace("duration_min = 2", "rate_of_climb_m_s = 90")
    assert "climbs 90 m/s at 60 m/s" in refused(slow)


def test_an_aircraft_does_not_burn_more_than_it_weighs():
    two = BASE[BASE.index("[phases.one]") :].replace("one", "two")
    assert "aircraft.mass" in refused(POWER.replace("mass_kg = 20000", "mass_kg = 1") + two)


def test_the_last_machine_cannot_be_out():
    out = 'mode = "rated"\ninoperative = ["gas-turbine", "electric"]\n[battery]\nenergy_kwh = 100\n'
    assert "every machine is out" in refused(POWER + out)


def test_air_that_is_warmer_than_the_oil_does_not_cool_it():
    oil = "isa_offset_k = 60\n[oil]\ninlet_temperature_k = 300\n[engine]\nthermal_power_kw = 9000\n[aircraft]"
    assert "does not cool this oil" in refused(POWER.replace("[aircraft]", oil))
