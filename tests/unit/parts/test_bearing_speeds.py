"""Thermal reference speed, least load and speed factor of rolling bearings: closed forms, limits, monotony."""

import math

import pytest
from hypothesis import given, strategies as st

from gearwright.catalogue import bearing_friction, bearings
from gearwright.parts.bearings import BearingKind, least_load, speed_factor, speed_limit, thermal_reference_speed
from gearwright.parts.bearings.rolling_bearing import reference_heat
from gearwright.units import RPM

near = pytest.approx


def reference(bearing):
    series = bearing_friction(bearing)
    return thermal_reference_speed(
        bearing.bore, bearing.outer_diameter, bearing.width, static_rating=bearing.static_rating,
        oil_factor=series.oil_factor, load_factor=series.load_factor,
    )  # fmt: skip


@pytest.mark.parametrize("name", ["6309", "NU 212", "QJ 312", "30209", "33212"])
def test_at_the_reference_speed_friction_is_what_the_bearing_gives_off(name):
    """ISO 15312 in its own units: π n/(30e3) (1e-7 f_0r (12 n)^(2/3) d_m³ + f_1r 0.05 C_0 d_m) = q_r π B (D + d)."""
    bearing = bearings()[name]
    series, turns = bearing_friction(bearing), reference(bearing) / RPM
    mean = 1e3 * (bearing.bore + bearing.outer_diameter) / 2.0
    idle = 1e-7 * series.oil_factor * (12.0 * turns) ** (2.0 / 3.0) * mean**3
    loaded = series.load_factor * 0.05 * bearing.static_rating * mean
    surface = math.pi * 1e3 * bearing.width * 2.0 * mean
    flow = 0.016 * (surface / 50e3) ** -0.34 if surface > 50e3 else 0.016
    assert math.pi * turns / 30e3 * (idle + loaded) == near(flow * surface, rel=1e-10)


def test_heat_flow_has_no_step_where_it_begins_to_fall():
    """A_r = 50 000 mm² = π B (D + d)."""
    width = 0.05 / (math.pi * 0.3)
    below, above = (reference_heat(0.1, 0.2, width * (1.0 + step)) for step in (-1e-9, 1e-9))
    assert below == near(above, rel=1e-8) and below == near(800.0, rel=1e-6)


def test_without_load_the_reference_speed_is_a_power():
    """ω = (Φ/k)^(3/5), k = 1e-10 f_0 (12/RPM)^(2/3) d_m³."""
    speed = thermal_reference_speed(0.045, 0.1, 0.025, static_rating=0.0, oil_factor=2.3, load_factor=2e-4)
    factor = 1e-10 * 2.3 * (12.0 / RPM) ** (2.0 / 3.0) * 72.5**3
    assert speed == near((reference_heat(0.045, 0.1, 0.025) / factor) ** 0.6)


@given(st.floats(0.5, 5.0), st.floats(0.0, 1e6))
def test_more_friction_or_load_makes_the_reference_speed_smaller(oil_factor, rating):
    size = (0.045, 0.1, 0.025)
    speeds = [
        thermal_reference_speed(*size, static_rating=load, oil_factor=oil, load_factor=2e-4)
        for oil, load in ((oil_factor, rating), (1.1 * oil_factor, rating), (oil_factor, 1.1 * rating + 1.0))
    ]
    assert speeds[1] < speeds[0] and speeds[2] < speeds[0]


def test_every_bearing_of_the_catalogue_has_its_series_and_turns_at_some_speed():
    for bearing in bearings().values():
        assert 100.0 * RPM < reference(bearing) < 60e3 * RPM


def test_large_bearings_of_a_series_turn_slower():
    sixty_three = [bearing for name, bearing in bearings().items() if name.startswith("63")]
    speeds = [reference(bearing) for bearing in sorted(sixty_three, key=lambda bearing: bearing.bore)]
    assert speeds == sorted(speeds, reverse=True)


def test_least_loads_and_speed_factors_by_hand():
    """0.01 C for balls, 0.02 C for rollers; n d_m of 45/100 at 6000/min: 435 000 mm/min."""
    assert least_load(53e3, BearingKind.DEEP_GROOVE) == near(530.0)
    assert least_load(53e3, BearingKind.FOUR_POINT) == near(530.0)
    assert least_load(70e3, BearingKind.TAPER) == near(1400.0)
    assert speed_factor(-6000 * RPM, 0.045, 0.1) == near(435e3)


def test_better_lubrication_bears_faster_bearings_and_care_more_than_usual():
    """Makers' catalogues: grease below oil jets below oil under the races; tapers below rollers below balls."""
    order = (BearingKind.TAPER, BearingKind.CYLINDRICAL, BearingKind.DEEP_GROOVE)
    for lubrication in ("grease", "jet", "under-race"):
        limits = [speed_limit(kind, lubrication) for kind in order]
        assert all(limit.usual < limit.careful for limit in limits)
        assert limits[0].usual <= limits[1].usual <= limits[2].usual
    for kind in order:
        usual = [speed_limit(kind, lubrication).usual for lubrication in ("grease", "jet", "under-race")]
        assert usual[0] < usual[1] < usual[2]
    assert speed_limit(BearingKind.FOUR_POINT, "jet") == (1.2e6, 1.8e6)
    assert speed_limit(BearingKind.TAPER, "under-race") == (1.0e6, 2.4e6)
