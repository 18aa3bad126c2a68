"""ISO 2533 and the airspeed indicator's law."""

import pytest

from gearwright.air import air_at, calibrated_of_true, true_of_calibrated
from gearwright.errors import DesignError
from gearwright.units import FOOT

KNOT = 1852.0 / 3600.0
ISO_2533 = [
    (0, 288.15, 101325.0, 1.225, 340.294),
    (1000, 281.65, 89874.6, 1.11164, 336.434),
    (2000, 275.15, 79495.2, 1.00649, 332.529),
    (3000, 268.65, 70108.5, 0.909122, 328.578),
    (5000, 255.65, 54019.9, 0.736116, 320.529),
    (8000, 236.15, 35599.8, 0.525168, 308.063),
    (10000, 223.15, 26436.3, 0.412707, 299.463),
    (11000, 216.65, 22632.1, 0.363918, 295.070),
    (12000, 216.65, 19330.4, 0.310828, 295.070),
    (15000, 216.65, 12044.6, 0.193674, 295.070),
    (20000, 216.65, 5474.88, 0.0880349, 295.070),
]


@pytest.mark.parametrize("row", ISO_2533, ids=lambda row: f"{row[0]} m")
def test_the_atmosphere_is_that_of_iso_2533(row):
    """ISO 2533:1975, table 5 (geopotential); 1e-5 is the rounding of its six printed digits."""
    assert air_at(row[0]) == pytest.approx(row[1:], rel=1e-5)


@pytest.mark.parametrize(
    ("level", "offset", "cas", "tas", "mach"),
    [
        (15, 0, 170, 173.7132, 0.263978),
        (100, 0, 170, 197.1042, 0.308779),
        (170, 0, 170, 219.8525, 0.353677),
        (250, 0, 213.8739, 313, 0.519977),
        (170, 0, 213.4972, 275, 0.442393),
        (15, 10, 170, 176.7327, 0.263978),
        (160, 0, 250, 315.9003, 0.506223),
    ],
)
def test_calibrated_and_true_airspeed_agree_both_ways(level, offset, cas, tas, mach):
    """Saint-Venant's pitot equation on flight levels; 1e-3 kt, ten times the printed digit."""
    air = air_at(level * 100 * FOOT, offset)
    assert true_of_calibrated(cas * KNOT, air) / KNOT == pytest.approx(tas, abs=1e-3)
    assert calibrated_of_true(tas * KNOT, air) / KNOT == pytest.approx(cas, abs=1e-3)
    assert tas * KNOT / air.sound_speed == pytest.approx(mach, abs=2e-6)


def test_an_offset_warms_the_air_and_leaves_the_pressure():
    """A pressure altitude is a pressure, whatever the temperature."""
    cold, warm = air_at(3000.0), air_at(3000.0, 20.0)
    assert warm.pressure == cold.pressure
    assert warm.temperature == cold.temperature + 20.0
    assert warm.density * warm.temperature == pytest.approx(cold.density * cold.temperature, rel=1e-14)


@pytest.mark.parametrize("altitude", [-1.0, 20001.0, float("nan")])
def test_an_altitude_outside_the_model_is_refused(altitude):
    with pytest.raises(DesignError, match="0 to 20000 m"):
        air_at(altitude)


def test_an_offset_that_is_no_weather_is_refused():
    with pytest.raises(DesignError, match="isa_offset"):
        air_at(0.0, -300.0)


def test_a_supersonic_airspeed_is_refused():
    with pytest.raises(DesignError, match="Mach"):
        calibrated_of_true(400.0, air_at(11000.0))
