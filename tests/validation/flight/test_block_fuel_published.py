"""Fuel of published aircraft and missions, with nothing fitted: what is assumed beside them is said here.

The aircraft's numbers are those of ATR's fact sheets of 2020 as they are quoted in public sources (masses, wing, power,
cruise speed, block fuel and block time), the drag polars are C_fe S_wet/S of the open aircraft models of BlueSky (TU
Delft, after Obert 2009), the fuel consumption is 77.6 µg/J of the PW127 family (Jane's, in the same files). Assumed:
Oswald's factor by Raymer for straight wings, a mass at the start of 22.3 and 18.3 t, FL170, a climb at 170 kt and
900 ft/min, a descent at 220 kt and 1100 ft/min, eight minutes of taxi, a core of 2600 kW, a Willans line with a fifth
of the fuel at idle, the propeller of the shipped charts.
"""

import math
from functools import cache

import numpy as np
import pytest

from gearwright.air import air_at
from gearwright.mission import fly, phase_forces
from gearwright.mission.thrust import Attitude, resistance
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import Aircraft, Phase, parse, parse_mission
from gearwright.units import FOOT, GRAVITY, HORSEPOWER, KNOT, NAUTICAL_MILE, POUND

TEXT = shipped_design("in-line").read_text(encoding="utf-8")
IN_LINE = size(parse(TEXT))
SQUARE_FOOT = FOOT**2


def raymer(ratio):
    """Return Oswald's factor of a straight wing, after Raymer; an assumption, from memory."""
    return 1.78 * (1.0 - 0.045 * ratio**0.68) - 0.64


ATR_72 = {
    "mass": 22300.0, "area": 61.0, "span": 27.05, "friction": 0.0039, "wetted": 4200.0, "cruise": 275.0,
    "take_off": 2000.0,
}  # fmt: skip
"""ATR 72-600: 22.8 t at most, 275 kt at the highest; friction and wetted area [ft²] of BlueSky's AT75."""
ATR_42 = {
    "mass": 18300.0, "area": 54.5, "span": 24.57, "friction": 0.0041, "wetted": 2500.0, "cruise": 300.0,
    "take_off": 1790.0,
}  # fmt: skip
"""ATR 42-600: 18.6 t at most, 300 kt at the highest; of BlueSky's AT45."""


def mission(plane, distance):
    """Return a mission over a distance of cruise [NM]."""
    ratio = plane["span"] ** 2 / plane["area"]
    drag = plane["friction"] * plane["wetted"] * SQUARE_FOOT / plane["area"]
    return parse_mission(
        f"""
schema = 1
name = "block fuel"
engines = 2
propeller_map = "6-blades-af115-all-states"
engine = {{ thermal_power_kw = 2600, fuel_kg_kwh = {0.0776 * 3.6} }}
[aircraft]
mass_kg = {plane["mass"]}
wing_area_m2 = {plane["area"]}
zero_lift_drag = {drag}
aspect_ratio = {ratio}
oswald = {raymer(ratio)}
highest_lift = 1.35
take_off = {{ highest_lift = 1.785, extra_drag = 0.015 }}
landing = {{ highest_lift = 2.55, extra_drag = 0.05 }}
[phases]
taxi-out = {{ kind = "taxi", altitude_ft = 0, tas_kt = 12, duration_min = 5, propeller_speed_rpm = 850 }}
run-up = {{ altitude_ft = 0, tas_kt = 0, duration_s = 20, power_kw = 700, propeller_speed_rpm = 1200, ramp_s = 15 }}
take-off = {{ kind = "take-off", altitude_ft = 35, power_kw = {plane["take_off"]}, propeller_speed_rpm = 1200 }}
faster = {{ kind = "speed-change", altitude_ft = 35, cas_kt = 170, power_kw = 1790, propeller_speed_rpm = 1200 }}
climb = {{ kind = "climb", altitude_ft = 17000, cas_kt = 170, rate_of_climb_ft_min = 900, propeller_speed_rpm = 984 }}
to-cruise = {{ kind = "speed-change", altitude_ft = 17000, tas_kt = {plane["cruise"]}, duration_s = 150,
  propeller_speed_rpm = 984 }}
cruise = {{ kind = "cruise", altitude_ft = 17000, tas_kt = {plane["cruise"]}, distance_nmi = {distance},
  propeller_speed_rpm = 984 }}
slower = {{ kind = "speed-change", altitude_ft = 17000, cas_kt = 220, duration_s = 60, propeller_speed_rpm = 984 }}
descent = {{ kind = "descent", altitude_ft = 1500, cas_kt = 220, rate_of_climb_ft_min = -1100,
  propeller_speed_rpm = 984 }}
to-approach = {{ kind = "speed-change", altitude_ft = 1500, cas_kt = 120, duration_s = 70, propeller_speed_rpm = 984 }}
approach = {{ kind = "approach", altitude_ft = 0, cas_kt = 120, path_angle_deg = -3, propeller_speed_rpm = 1200 }}
landing = {{ kind = "landing", altitude_ft = 0, power_kw = 350, propeller_speed_rpm = 1200 }}
taxi-in = {{ kind = "taxi", altitude_ft = 0, tas_m_s = 5, duration_min = 3, propeller_speed_rpm = 850, ramp_s = 20 }}
""".replace(",\n  ", ", ")
    )


def flown(plane, distance):
    """Return block fuel [kg] and block time [min] over a distance from take-off to landing [NM]."""
    other = 0.0
    for _ in range(2):  # the rest of the way does not depend on the cruise, but for rounding
        flight = fly(IN_LINE, mission(plane, distance - other))
        way = {row.name: row.distance / NAUTICAL_MILE for row in phase_forces(flight)}
        other = sum(value for name, value in way.items() if name not in ("taxi-out", "taxi-in", "cruise"))
    return 2.0 * flight.fuel, flight.duration / 60.0


@pytest.mark.parametrize(
    ("plane", "distance", "fuel", "minutes"),
    [
        pytest.param(ATR_72, 200.0, 638.0, None, id="ATR 72-600, 200 NM"),
        pytest.param(ATR_72, 300.0, 879.0, None, id="ATR 72-600, 300 NM"),
        pytest.param(ATR_42, 200.0, 584.0, 60.0, id="ATR 42-600, 200 NM"),
        pytest.param(ATR_42, 300.0, 802.0, 81.0, id="ATR 42-600, 300 NM"),
    ],
)
def test_block_fuel_is_within_8_percent_of_the_fact_sheets(plane, distance, fuel, minutes):
    found, took = flown(plane, distance)
    assert found == pytest.approx(fuel, rel=0.08)
    if minutes is not None:
        assert took == pytest.approx(minutes, abs=2.0)  # taxi times are not published


KING_AIR = Aircraft(mass=4581.0, wing_area=27.308, zero_lift_drag=0.022, aspect_ratio=8.5834, oswald=0.8)
"""Beechcraft King Air C90GT as in OpenConcept's examples."""


KING_AIR_TEXT = f"""
schema = 1
name = "King Air C90GT"
engines = 2
step_s = 60
propeller_map = "4-blades-af114-all-states"
engine = {{ thermal_power_kw = 1200, fuel_kg_kwh = {0.6 * POUND / 0.7457}, idle_fuel = 0 }}
[aircraft]
mass_kg = 4581
wing_area_m2 = 27.308
zero_lift_drag = 0.022
aspect_ratio = 8.5834
oswald = 0.8
[phases]
"""


def of_equivalent(speed, altitude):
    """Return the true airspeed of an equivalent one [kt], [m/s]."""
    return speed * KNOT * math.sqrt(air_at(0.0).density / air_at(altitude).density)


def test_the_drag_of_a_king_air_in_cruise_is_openconcepts():
    for burnt, expected in ((201.6346, 3516.834), (1551.4298, 3338.323)):
        weight, altitude = (4581.0 - burnt * POUND) * GRAVITY, 29000 * FOOT
        at = Attitude(air_at(altitude), of_equivalent(170.0, altitude), 0.0, 0.0)
        phase = Phase(kind="cruise", altitude=altitude, propeller_speed=200.0)
        assert resistance(KING_AIR, phase, weight, at) == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize(("burnt", "altitude", "expected"), [(0.0, 0.0, 8212.296), (201.6346, 29000.0, 6086.585)])
def test_the_thrust_of_a_king_air_in_climb_is_openconcepts(burnt, altitude, expected):
    """D + m g sin γ at 124 kt of equivalent airspeed and 1500 ft/min; both ends of the climb. 1e-3: its lift at the
    start is that of a level flight with another air by 0.1 %."""
    weight, height = (4581.0 - burnt * POUND) * GRAVITY, altitude * FOOT
    speed = of_equivalent(124.0, height)
    slope = 1500.0 * FOOT / 60.0 / speed
    phase = Phase(kind="climb", altitude=height, propeller_speed=200.0)
    drag = resistance(KING_AIR, phase, weight, Attitude(air_at(height), speed, slope, 0.0))
    assert drag + weight * slope == pytest.approx(expected, rel=1e-3)


@cache
def king_air():
    """Return OpenConcept's mission with our propeller (4 blades, AF 114) and a gearbox of 98 to 99 %, not fitted."""
    design = TEXT.replace("power_kw = 2051", "power_hp = 750").replace("speed_rpm = 20000", "speed_rpm = 30000")
    design = design.replace("speed_rpm = 1212", "speed_rpm = 1900").replace("diameter_m = 3.93", "diameter_m = 2.28")
    phases = []

    def leg(name, ends, speed, duration):
        first, last = (of_equivalent(speed, at) for at in ends)
        phases.append(
            f"{name} = {{ from_altitude_m = {ends[0]}, altitude_m = {ends[1]}, from_tas_m_s = {first},"
            f" tas_m_s = {last}, duration_s = {duration}, propeller_speed_rpm = 1900 }}"
        )

    top, cuts = 29000 * FOOT, 10
    for k in range(cuts):
        leg(f"climb-{k}", (top * k / cuts, top * (k + 1) / cuts), 124.0, 1158.6 / cuts)
    leg("cruise", (top, top), 170.0, 10635.86)
    for k in range(cuts):
        leg(f"descent-{k}", (top * (1 - k / cuts), top * max(1 - (k + 1) / cuts, 0.0)), 140.0, 2900.18 / cuts)
    return fly(
        size(parse(design.replace("blades = 6", "blades = 4"))), parse_mission(KING_AIR_TEXT + "\n".join(phases))
    )


def during(word):
    """Return the intervals of the climb, the cruise or the descent."""
    return np.array([name.split("-")[0] == word for name in king_air().phase])


def test_the_fuel_of_a_king_air_over_1000_miles_is_openconcepts_in_every_phase():
    """8 %: another propeller; OpenConcept also leaves out what gains true airspeed in the climb."""
    history = king_air().history
    burnt = 2.0 * history.fuel_flow * history.duration / POUND
    assert burnt.sum() == pytest.approx(1666.7346, rel=0.08)
    for word, expected in (("climb", 201.6346), ("cruise", 1551.4298 - 201.6346), ("descent", 1666.7346 - 1551.4298)):
        assert burnt[during(word)].sum() == pytest.approx(expected, rel=0.08), word


def test_the_throttle_of_a_king_air_is_openconcepts_but_for_the_efficiency_of_its_propeller():
    """Throttle: power of an engine over 750 hp. In cruise within 8 %, as both propellers have 0.83 to 0.9 there.

    At the ends of climb and descent OpenConcept's propeller is another one: its throttles mean efficiencies of 0.67 at
    sea level (the charts: 0.83) and 0.82 at 29 000 ft (0.78); the power that reaches the air is then the same within
    5 %, 4.3 of which are the gain of true airspeed that it leaves out.
    """
    history, rating = king_air().history, 750.0 * HORSEPOWER
    throttle = king_air().machines["gas-turbine"].power / rating
    cruise = throttle[during("cruise")]
    assert (cruise[0], cruise[-1]) == pytest.approx((0.52045, 0.49565), rel=0.08)
    useful = (2.0 * history.thrust * history.true_airspeed)[during("climb")]
    ends = (8212.296 * of_equivalent(124.0, 0.0), 6086.585 * of_equivalent(124.0, 29000.0 * FOOT))
    assert (useful[0], useful[-1]) == pytest.approx(ends, rel=0.05)
    implied = [power / (2.0 * rating * part) for power, part in zip(ends, (0.70047, 0.68036), strict=True)]
    assert implied == pytest.approx([0.669, 0.819], abs=1e-3)
