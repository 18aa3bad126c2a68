"""Flights flown together: each has the bits that it has alone, and its energies close."""

from functools import cache

import numpy as np
import pytest

import gearwright as gw
from gearwright.mission import flight_series, fly_each


@cache
def sized(design):
    """Return a shipped design as sized."""
    return gw.size(gw.read(design))


def coarse(mission, **changes):
    """Return a shipped mission in intervals of at most 40 s for 10 s: what holds of each holds of fewer."""
    return gw.edited_mission(gw.read_mission(mission), {"step_s": 40.0, **changes})


def test_the_energies_close():
    together = gw.fly(sized("in-line-h2"), gw.read_mission("thesis"))
    assert together.balance.residual < 1e-12  # sums of 533 intervals


@pytest.mark.parametrize(
    ("design", "mission", "key", "values"),
    [
        ("in-line", "regional-aircraft", "aircraft.mass_kg", (20000.0, 20700.0, 21400.0)),
        ("in-line-h2", "strategies", "strategies.top-up.charge_power_kw", (40.0, 55.0, 60.0)),
        ("ec120b", "ec120b-trim", "rotorcraft.mass_kg", (1500.0, 1550.0, 1600.0)),
    ],
)
def test_flights_that_follow_have_the_bits_that_each_has_alone(design, mission, key, values):
    scattered = [coarse(mission, **{key: value}) for value in values]
    for flight, alone in zip(fly_each(sized(design), scattered), scattered, strict=True):
        flown = gw.fly(sized(design), alone)
        assert all(
            np.array_equal(a.values, b.values) for a, b in zip(flight_series(flight), flight_series(flown), strict=True)
        )
