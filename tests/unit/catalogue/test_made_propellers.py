"""Maps and loads of propellers that are made from blades, and maps over the Mach number in files and flights."""

import math
from dataclasses import replace

import numpy as np
import pytest

import gearwright as gw
from gearwright.catalogue import FlightPoint, map_text, propeller_map, read_propeller_map
from gearwright.errors import DesignError
from gearwright.machines import Blades, MachMap, PropellerMap, map_at
from gearwright.machines.propellers import activity_factor, generic_blade
from gearwright.spec import parse_mission
from gearwright.units import FOOT, HORSEPOWER, KNOT, POUND_FORCE
from shipped_work import sized

SIX = Blades(6, 115.0, 0.5)
COARSE = {"advance_ratios": (0.0, 0.5, 1.0, 2.0, 3.0), "blade_angles": tuple(np.radians(range(-20, 91, 10)))}
STATIONS = "radius_ratio,chord_ratio,blade_angle_deg\n0.2,0.1,60\n0.4,0.15,45\n0.6,0.15,35\n0.8,0.12,28\n0.95,0.08,24\n"
POINT = FlightPoint(3.93, 126.9, 140.0, 6000.0, math.radians(3.0))


def problems(raised):
    """What is wrong, by its place."""
    return {problem.path for problem in raised.value.problems}


def test_a_map_by_charts_is_the_shipped_one_at_its_points():
    made = gw.propeller(SIX, advance_ratios=(1.0, 1.5), blade_angles=tuple(np.radians((25.0, 30.0, 35.0))), by="charts")
    shipped = propeller_map("6-blades-af115")
    row, column = np.searchsorted(shipped.advance_ratio, 1.0), np.searchsorted(shipped.blade_angle, math.radians(29.99))
    assert made.chart.power[0, 1] == pytest.approx(shipped.power[row, column], abs=2e-6)
    assert made.blades is None


def test_a_map_goes_to_a_file_and_back_over_the_mach_number(tmp_path):
    made = gw.propeller(SIX, **COARSE, tip_machs=(0.3, 0.7))
    path = tmp_path / "map.csv"
    path.write_text(map_text(made.chart), encoding="utf-8")
    read = read_propeller_map(path)
    assert isinstance(read, MachMap)
    assert read.tip_mach.tolist() == [0.3, 0.7]
    for one, other in zip(made.chart.maps, read.maps, strict=True):
        assert other.thrust == pytest.approx(one.thrust, abs=1e-6)


def test_maps_over_the_mach_number_are_linear_between_and_end():
    chart = gw.propeller(SIX, **COARSE, tip_machs=(0.3, 0.7)).chart
    half, first = map_at(chart, 0.5), map_at(chart, 0.1)
    assert half.power == pytest.approx(0.5 * (chart.maps[0].power + chart.maps[1].power))
    assert np.array_equal(first.power, chart.maps[0].power)
    with pytest.raises(DesignError, match=r"0\.710 at the tips: the map ends at 0\.7"):
        map_at(chart, 0.71)


def test_a_mission_flies_a_map_over_the_mach_number_from_its_file(tmp_path):
    """With both maps alike it is the flight of one of them; the tips turn at Mach 0.73 to 0.83."""
    plain = gw.propeller(SIX).chart
    text = (
        'schema = 1\nname = "one"\nengines = 1\npropeller_map = "map.csv"\n[phases.cruise]\nduration_min = 10\n'
        "altitude_m = 5000\ntas_m_s = 140\npropeller_speed_rpm = 1212\npower_kw = 600\n"
    )
    thrusts = []
    for chart in (plain, MachMap(np.array([0.3, 0.9]), (plain, plain))):
        (tmp_path / "map.csv").write_text(map_text(chart), encoding="utf-8")
        flight = gw.fly(sized(), parse_mission(text), folder=tmp_path)
        thrusts.append(flight.history.thrust)
    assert thrusts[1] == pytest.approx(thrusts[0], rel=1e-12)
    (tmp_path / "map.csv").write_text(map_text(MachMap(np.array([0.3, 0.5]), (plain, plain))), encoding="utf-8")
    with pytest.raises(DesignError, match=r"the map ends at 0\.5"):
        gw.fly(sized(), parse_mission(text), folder=tmp_path)


def test_maps_whose_mach_numbers_have_other_points_are_refused(tmp_path):
    path = tmp_path / "map.csv"
    text = map_text(gw.propeller(SIX, **COARSE, tip_machs=(0.3, 0.7)).chart)
    path.write_text("\n".join(line for line in text.splitlines() if not line.startswith("0.7,3,")) + "\n")
    with pytest.raises(DesignError, match=r"tip Mach 0\.7 has other advance ratios than tip Mach 0\.3"):
        read_propeller_map(path)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("advance_ratio,blade_angle_deg,power_coefficient\n0,10,0.1\n", "lacks thrust_coefficient"),
        ("J,beta\n0,10\n", "lacks advance_ratio"),
    ],
)
def test_maps_without_their_columns_are_refused(tmp_path, text, said):
    (tmp_path / "map.csv").write_text(text, encoding="utf-8")
    with pytest.raises(DesignError, match=said):
        read_propeller_map(tmp_path / "map.csv")


def test_maps_with_holes_are_refused(tmp_path):
    lines = map_text(gw.propeller(SIX, **COARSE).chart).splitlines()
    (tmp_path / "map.csv").write_text("\n".join(lines[:20] + lines[21:]) + "\n", encoding="utf-8")
    with pytest.raises(DesignError, match="has a gap between its blade angles"):
        read_propeller_map(tmp_path / "map.csv")


def test_blades_are_read_with_their_activity_factor(tmp_path):
    """100 000/16 ∫ (c/D) x³ dx of the stations' straight lines, by hand with Simpson's rule; 30 elements: 1 %."""
    (tmp_path / "blade.csv").write_text(STATIONS, encoding="utf-8")
    shape = gw.read_blades(tmp_path / "blade.csv", 3)
    x = np.linspace(0.2, 1.0, 2001)
    chord = np.interp(x, (0.2, 0.4, 0.6, 0.8, 0.95), (0.1, 0.15, 0.15, 0.12, 0.08))
    hand = 1e5 / 16.0 * float(np.sum(0.5 * chord * x**3) * (x[1] - x[0]))
    assert activity_factor(shape) == pytest.approx(hand, rel=0.01)
    assert shape.hub == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("0.6,0.15,35", "0.4,0.15,35", "blades.line 4"),
        ("0.4,0.15,45", "0.4,0.15,450", "blades.line 3"),
        ("0.95,0.08,24\n", "", "blades"),
        ("0.8,0.12,28\n0.95,0.08,24\n", "0.65,0.1,30\n0.7,0.1,29\n", "blades"),
    ],
)
def test_blades_that_are_none_are_refused_at_their_line(tmp_path, old, new, place):
    (tmp_path / "blade.csv").write_text(STATIONS.replace(old, new), encoding="utf-8")
    with pytest.raises(DesignError) as raised:
        gw.read_blades(tmp_path / "blade.csv", 3)
    assert place in problems(raised)


def test_all_that_is_wrong_with_a_propeller_is_told_at_once():
    with pytest.raises(DesignError) as raised:
        gw.propeller(Blades(1, 20.0, 0.5), advance_ratios=(0.0, 0.0), blade_angles=(0.3, 0.1), tip_machs=(0.5, 1.2))
    assert problems(raised) == {
        "blades.number", "blades.activity_factor", "advance_ratios", "blade_angles", "tip_machs"
    }  # fmt: skip


def test_a_power_beyond_the_stall_is_refused_with_what_the_blades_take():
    with pytest.raises(DesignError, match=r"9000 kW is asked for; .* take .* before they stall"):
        gw.propeller_loads(SIX, POINT, power=9e6)


def test_loads_at_a_point_of_flight_add_up():
    """P = ω Q, η = V T/P, and the asked power is taken to 1e-6."""
    found = gw.propeller_loads(SIX, POINT, power=1.6e6)
    assert found.power == pytest.approx(1.6e6, rel=1e-6)
    assert found.torque * 126.9 == pytest.approx(found.power)
    assert found.efficiency == pytest.approx(140.0 * found.thrust / found.power)
    again = gw.propeller_loads(generic_blade(SIX), POINT, blade_angle=found.blade_angle)
    assert again.hub_moment == pytest.approx(found.hub_moment, rel=1e-9)


def test_either_a_power_or_an_angle_is_asked_for_and_points_are_in_range():
    with pytest.raises(DesignError) as raised:
        gw.propeller_loads(SIX, FlightPoint(3.93, 126.9, -1.0))
    assert problems(raised) >= {"power", "point.airspeed"}


def test_a_made_map_is_a_propeller_map():
    assert isinstance(gw.propeller(SIX, **COARSE).chart, PropellerMap)


def test_at_a_point_of_flight_the_charts_are_asked_where_they_are_chosen():
    """GASP by the charts, as NASA's Aviary keeps it: 4 blades, AF 150, C_Li 0.5, 12 ft, 10 000 ft, 200 kt, 1000 hp,
    tips at 769.7 ft/s: 1470.5 lbf; blade elements give 6 % less."""
    diameter = 12.0 * FOOT
    point = FlightPoint(diameter, 2.0 * 769.7 * FOOT / diameter, 200.0 * KNOT, 1e4 * FOOT)
    blades = Blades(4, 150.0, 0.5)
    found = gw.propeller_loads(blades, point, power=1000.0 * HORSEPOWER, by="charts")
    assert found.thrust == pytest.approx(1470.5 * POUND_FORCE, rel=3e-3)
    elements = gw.propeller_loads(blades, point, power=1000.0 * HORSEPOWER)
    assert abs(elements.thrust / found.thrust - 1.0) > 0.03
    again = gw.propeller_loads(blades, replace(point, airspeed=80.0), blade_angle=math.radians(30.0), by="charts")
    back = gw.propeller_loads(blades, replace(point, airspeed=80.0), power=again.power, by="charts")
    assert (back.blade_angle, back.thrust) == (pytest.approx(math.radians(30.0)), pytest.approx(again.thrust))


def test_the_charts_say_where_they_hold_nothing():
    flat = replace(POINT, incidence=0.0)
    for blades, point, power, place in (
        (SIX, POINT, 1.6e6, "incidence"), (Blades(9, 115.0, 0.5), flat, 1.6e6, "blades.number"), (SIX, flat, 60e6, "by")
    ):  # fmt: skip
        with pytest.raises(DesignError) as raised:
            gw.propeller_loads(blades, point, power=power, by="charts")
        assert problems(raised) == {place}
