"""The Hamilton Standard method against independent programs and a measured propeller."""

import json
import math
from pathlib import Path

import pytest

from gearwright.air import air_at
from gearwright.catalogue import MAPS, charted_point, hamilton_standard_charts
from gearwright.machines import Blades, performance
from gearwright.units import FOOT, HORSEPOWER

KNOT = 1852.0 / 3600.0
AVIARY_6_BLADES = [
    # activity factor, C_P, J, tip Mach, C_T
    (100, 0.20089, 0.00065, 0.72563, 0.30328),
    (120, 0.20089, 0.00065, 0.72563, 0.31429),
    (100, 0.20089, 0.39271, 0.72563, 0.24851),
    (120, 0.20089, 0.39271, 0.72563, 0.25352),
    (100, 0.20089, 0.75269, 0.72563, 0.1973),
    (120, 0.20089, 0.75269, 0.72563, 0.19869),
    (100, 0.33231, 1.38655, 0.59811, 0.20185),
    (120, 0.33231, 1.38655, 0.59811, 0.20139),
    (100, 0.39868, 1.57325, 0.6166, 0.2149),
    (120, 0.39868, 1.57325, 0.6166, 0.21487),
    (100, 0.44973, 2.195, 0.63317, 0.18087),
    (120, 0.44348, 2.195, 0.65386, 0.17715),
    (100, 0.55846, 2.49831, 0.65386, 0.19801),
    (120, 0.55846, 2.49831, 0.65386, 0.19568),
]


@pytest.mark.parametrize("row", AVIARY_6_BLADES, ids=str)
def test_six_blades_give_the_thrust_of_an_independent_program(row):
    """NASA Aviary's Hamilton Standard code run for D = 3.93 m; 1e-4 is four times the rounding of its inputs."""
    factor, power, ratio, tip_mach, thrust = row
    found = performance(
        hamilton_standard_charts(),
        Blades(6, factor, 0.5),
        ratio,
        power_coefficient=power,
        mach=ratio * tip_mach / math.pi,
        tip_mach=tip_mach,
    )
    assert found.thrust_coefficient == pytest.approx(thrust, rel=1e-4)
    assert found.held == ()


@pytest.mark.parametrize(
    ("ratio", "power", "mach", "thrust", "factor"),
    [
        (0.0066, 0.2352, 0.001509, 0.2763, 1.0),
        (0.8295, 0.2352, 0.1887, 0.2052, 1.0),
        (1.9908, 0.2553, 0.4976, 0.1158, 0.9818),
    ],
)
def test_four_blades_give_thrust_and_compressibility_of_an_independent_program(ratio, power, mach, thrust, factor):
    """NASA Aviary, test_hamilton_standard.py: C_T before compressibility; 5e-4 is its printed digit.

    The tip Mach number is that of the advance ratio; the one in that test, 1.2, contradicts its own flight speed.
    """
    found = performance(
        hamilton_standard_charts(),
        Blades(4, 114.0, 0.5),
        ratio,
        power_coefficient=power,
        mach=mach,
        tip_mach=math.pi * mach / ratio,
    )
    assert found.compressibility == pytest.approx(factor, abs=5e-5)
    assert found.thrust_coefficient / found.compressibility == pytest.approx(thrust, rel=5e-4)


GASP = [
    # blades, activity factor, C_Li, D [ft], altitude [ft], speed [kn], power [hp], tip speed [ft/s], C_T, efficiency
    (4, 114, 0.5, 10.5, 0, 0.1, 1850, 800.0, 0.27651, 0.00078),
    (4, 114, 0.5, 10.5, 0, 125, 1850, 800.0, 0.20518, 0.72354),
    (4, 150, 0.5, 12, 10000, 200, 1000, 769.7, 0.09694, 0.90350),
    (3, 150, 0.5, 12, 10000, 200, 1000, 750.0, 0.10189, 0.90172),
    (4, 150, 0.65, 12, 10000, 200, 900, 750.0, 0.08523, 0.83809),
    (4, 150, 0.65, 12, 10000, 200, 750, 750.0, 0.06463, 0.76259),
]


def flown(number, factor, lift, *, feet, altitude, knots, horsepower, tip):
    """J, C_P and the method's point of a propeller in flight."""
    air, diameter = air_at(altitude * FOOT), feet * FOOT
    turns = tip * FOOT / (math.pi * diameter)
    ratio = knots * KNOT / (turns * diameter)
    power = horsepower * HORSEPOWER / (air.density * turns**3 * diameter**5)
    mach, tip_mach = knots * KNOT / air.sound_speed, tip * FOOT / air.sound_speed
    charts, blades = hamilton_standard_charts(), Blades(number, factor, lift)
    return ratio, power, performance(charts, blades, ratio, power_coefficient=power, mach=mach, tip_mach=tip_mach)


@pytest.mark.parametrize("row", GASP, ids=str)
def test_gasp_flies_the_same_propellers(row):
    """GASP's values in NASA Aviary's test_propeller_performance.py; GASP stops its search of C_T at 1e-3."""
    number, factor, lift, feet, altitude, knots, horsepower, tip, thrust, efficiency = row
    ratio, power, found = flown(
        number, factor, lift, feet=feet, altitude=altitude, knots=knots, horsepower=horsepower, tip=tip
    )
    assert found.thrust_coefficient == pytest.approx(thrust, rel=1.4e-3)
    assert ratio * found.thrust_coefficient / power == pytest.approx(efficiency, rel=5e-4, abs=5e-6)
    assert found.held == ()


@pytest.mark.parametrize(
    ("case", "efficiency"),
    [
        ((4, 114, 0.5, 10.5, 25000, 300, 900, 800.0), 0.885405),
        ((4, 150, 0.5, 12, 0, 50, 1250, 769.7), 0.504393),
        ((3, 150, 0.5, 12, 0, 50, 1250, 750.0), 0.464327),
        ((4, 100, 0.4, 11, 5000, 140, 1100, 760.0), 0.814017),
    ],
)
def test_aviary_flies_the_same_propellers(case, efficiency):
    """NASA Aviary's program run for GASP's other three propellers and a fourth; 1e-4 as its search stops at 1e-3."""
    number, factor, lift, feet, altitude, knots, horsepower, tip = case
    ratio, power, found = flown(
        number, factor, lift, feet=feet, altitude=altitude, knots=knots, horsepower=horsepower, tip=tip
    )
    assert ratio * found.thrust_coefficient / power == pytest.approx(efficiency, rel=1e-4)


AVIARY_COMPRESSED = [
    # blades, activity factor, C_Li, C_P, J, flight and tip Mach, C_T and its compressibility factor
    (3, 198.864144, 0.535437, 0.408881, 3.697881, 0.620201, 0.539375, 0.076729, 0.94374),
    (3, 193.010688, 0.529919, 0.082263, 0.554964, 0.306277, 0.744928, 0.103712, 0.761723),
    (3, 190.328414, 0.727304, 0.160605, 0.624187, 0.247952, 0.584012, 0.177099, 0.919516),
    (3, 181.698466, 0.6765, 0.38618, 2.597298, 0.65229, 0.636555, 0.122617, 0.766636),
    (3, 110.215407, 0.664817, 0.25897, 1.010655, 0.525602, 0.551691, 0.184114, 0.702704),
]


@pytest.mark.parametrize("row", AVIARY_COMPRESSED, ids=str)
def test_odd_counts_and_lifts_between_the_tables_are_an_independent_programs(row):
    """NASA Aviary's program run at random points; 1e-3 is where its search of C_T stops."""
    number, factor, lift, power, ratio, mach, tip_mach, thrust, compressed = row
    blades = Blades(number, factor, lift)
    found = performance(
        hamilton_standard_charts(), blades, ratio, power_coefficient=power, mach=mach, tip_mach=tip_mach
    )
    assert found.compressibility == pytest.approx(compressed, abs=5e-4)
    assert found.thrust_coefficient / found.compressibility == pytest.approx(thrust, rel=1.1e-3)


def test_a_point_beyond_the_tables_says_so():
    """C_Li 0.8 at C_P 0.02 and J 1 leaves the lift table, where an unguarded code gives C_T = -0.74."""
    found = performance(hamilton_standard_charts(), Blades(4, 150.0, 0.8), 1.0, power_coefficient=0.02)
    assert found.held


def test_odd_blade_counts_lie_between_the_charts_of_even_ones():
    charts = hamilton_standard_charts()
    four, five, six = (
        performance(charts, Blades(count, 110.0, 0.5), 1.2, power_coefficient=0.25).blade_angle for count in (4, 5, 6)
    )
    assert six < five < four


@pytest.mark.parametrize("name", MAPS)
def test_the_shipped_maps_are_the_methods(name):
    """Every eightieth row made again; half a unit of the sixth decimal that the file holds."""
    import gearwright.catalogue as catalogue

    path = Path(catalogue.__file__).parent / f"data/propeller_{name}.csv"
    rows = path.read_text(encoding="utf-8").splitlines()[1::80]
    assert len(rows) > 20
    for row in rows:
        ratio, angle, power, thrust = map(float, row.split(","))
        found = charted_point(MAPS[name], ratio, math.radians(angle))
        assert found == pytest.approx((power, thrust), abs=5.1e-7)


def test_the_measured_5868_9_lies_near_the_charts():
    """Hartman and Biermann, NACA TR-640: three blades, 10 ft, Clark Y, C_P at J and blade angle.

    15 %: another blade (an activity factor of 90 is assumed for it) in front of a nacelle.
    """
    measured = {(0.5, 20): 0.0797, (0.8, 25): 0.0994, (1.0, 30): 0.135, (1.2, 30): 0.0998, (1.6, 40): 0.1857}
    for (ratio, angle), power in measured.items():
        found = charted_point(Blades(3, 90.0, 0.5), ratio, math.radians(angle))
        assert found is not None
        assert found[0] == pytest.approx(power, rel=0.15)


def test_the_charts_name_their_misprints():
    import gearwright.catalogue as catalogue

    raw = json.loads((Path(catalogue.__file__).parent / "data/hamilton_standard.json").read_text(encoding="utf-8"))
    assert [each["printed"] for each in raw["corrections"]] == [0.9, 0.9]
    assert hamilton_standard_charts().compressibility[2][3, 10] == raw["corrections"][0]["read_as"]
