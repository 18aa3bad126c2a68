"""Lives of lips and oil by hand."""

import pytest

from gearwright.parts.upkeep import LEAKAGE, lip_life, lip_wear_life, oil_life

HOUR = 3600.0


def test_a_lip_lives_twice_as_long_ten_kelvin_cooler_and_half_as_long_twice_as_fast():
    """1000 h at its hottest; 30 K below 8000 h. 250 000 km at 10 m/s are 6944 h."""
    assert lip_life(100.0, 100.0) == pytest.approx(1000.0 * HOUR)
    assert lip_life(100.0, 70.0) == pytest.approx(8000.0 * HOUR)
    assert lip_wear_life(10.0) == pytest.approx(6944.4 * HOUR, rel=1e-4)
    assert lip_wear_life(20.0) == pytest.approx(lip_wear_life(10.0) / 2.0)


def test_oil_lives_a_year_cool_and_three_months_at_100_degrees():
    """8760 h up to 50 °C, 2190 at 100 °C; half-way between, at 75 °C, 4380: 4^−½."""
    assert oil_life(30.0) == oil_life(50.0) == pytest.approx(8760.0 * HOUR)
    assert oil_life(75.0) == pytest.approx(4380.0 * HOUR)
    assert oil_life(100.0) == pytest.approx(2190.0 * HOUR)


def test_a_tight_seal_lets_three_grams_through_in_ten_days():
    assert pytest.approx(3e-3) == LEAKAGE * 240.0 * HOUR
