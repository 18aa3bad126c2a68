"""All intervals at once give the flight that one interval after the other gives."""

import importlib
from functools import cache

import numpy as np
import pytest

import gearwright as gw
from gearwright.errors import DesignError
from gearwright.mission import flight_series, fly_each
from gearwright.mission.intervals import Log
from gearwright.mission.together import log_at_once

flying = importlib.import_module("gearwright.mission.fly")
CLOSE = 1e-12
"""Rounds end where the lost part of a mesh moves by 5e-15 of what it carries, some 1e-12 of what it loses."""


@cache
def sized(design):
    """Return a shipped design as sized."""
    return gw.size(gw.read(design))


def coarse(mission, **changes):
    """Return a shipped mission in intervals of at most 40 s for 10 s: what holds of each holds of fewer."""
    return gw.edited_mission(gw.read_mission(mission), {"step_s": 40.0, **changes})


def both(design, mission, monkeypatch):
    """Return a flight flown at once, and the same flown one by one."""
    if isinstance(mission, str):
        name, _, coarser = mission.partition(" ")
        mission = coarse(name) if coarser else gw.read_mission(name)
    used = []

    def watched(flown):
        log = log_at_once(flown)
        used.append(isinstance(log, Log))
        return log

    monkeypatch.setattr(flying, "log_at_once", watched)
    together = gw.fly(sized(design), mission)
    monkeypatch.setattr(flying, "log_at_once", lambda flown: None)
    return together, gw.fly(sized(design), mission), used[0]


def apart(one, other):
    """Return the largest difference of two flights over the largest value of its kind, and what differs."""
    worst = (0.0, "")
    for series, same in zip(flight_series(one), flight_series(other), strict=True):
        assert series.name == same.name
        scale = np.abs(same.values).max() or 1.0
        worst = max(worst, (float(np.abs(series.values - same.values).max() / scale), series.name))
    return worst


@pytest.mark.parametrize(
    ("design", "mission"),
    [
        ("in-line-h2", "thesis"),
        ("in-line-h2", "thesis-chapter-4"),
        ("in-line-h1", "thesis coarse"),
        ("off-set-h2", "equal-power"),
        ("mixed-h2", "equal-power"),
        ("in-line", "regional-250nm coarse"),
        ("in-line", "regional-aircraft coarse"),
        ("in-line-h2", "hybrid-reserves coarse"),
    ],
)
def test_intervals_at_once_are_those_one_by_one(design, mission, monkeypatch):
    together, alone, at_once = both(design, mission, monkeypatch)
    assert at_once
    assert apart(together, alone)[0] < CLOSE
    assert together.phase == alone.phase
    assert together.fuel == pytest.approx(alone.fuel, rel=CLOSE)
    assert together.balance.battery == pytest.approx(alone.balance.battery, rel=CLOSE)


def test_the_energies_close():
    together = gw.fly(sized("in-line-h2"), gw.read_mission("thesis"))
    assert together.balance.residual < 1e-12  # sums of 533 intervals


def test_strategies_are_followed_at_once(monkeypatch):
    together, alone, at_once = both("in-line-h2", coarse("strategies"), monkeypatch)
    assert at_once
    assert apart(together, alone)[0] < 1e-10  # shares agree to 1e-12, and what tops up a battery adds up
    assert together.fuel == pytest.approx(alone.fuel, rel=CLOSE)


def test_motors_that_brake_are_followed_at_once(monkeypatch):
    mission = coarse("strategies", **{"strategies.burn.rule": "regenerate"})
    together, alone, at_once = both("in-line-h2", mission, monkeypatch)
    assert at_once and apart(together, alone)[0] < 1e-10  # as above


def test_a_plan_is_flown_one_by_one(monkeypatch):
    changes = {"strategies.peak.rule": "optimal", "strategies.peak.turbine_power_kw": None, "step_s": 60.0}
    planned = gw.edited_mission(gw.read_mission("strategies"), changes)
    assert not both("in-line-h2", planned, monkeypatch)[2]


def test_cells_follow_from_interval_to_interval(monkeypatch):
    cells = {"battery.cells": {}}
    mission = coarse("thesis", **cells)
    together, alone, at_once = both("in-line-h2", mission, monkeypatch)
    assert at_once and together.history.battery_temperature is not None
    assert apart(together, alone) < (2e-11, "")  # the current of cells is found by rounds, to 1e-12 of itself
    assert together.pack.worn == pytest.approx(alone.pack.worn, rel=1e-11)


def test_another_friction_of_teeth_and_gears_that_dip(monkeypatch):
    changes = {"oil.friction": "iso-tr-14179-1", "oil.windage": "dawson", "oil.seals": "simrit"}
    mission = coarse("thesis", **changes, **{"oil.dip": {"second.sun": 0.3}})
    together, alone, at_once = both("in-line-h2", mission, monkeypatch)
    assert at_once and together.history.churning_loss.max() > 0.0
    assert apart(together, alone)[0] < CLOSE


@pytest.mark.parametrize(
    ("mission", "changes"),
    [
        ("regional-250nm", {"aircraft.fuel_kg": 300.0}),
        ("regional-250nm", {"aircraft.mass_kg": 60000.0}),
        ("regional-aircraft", {"aircraft.highest_lift": 1.3, "aircraft.landing.highest_lift": 1.4}),
        ("regional-aircraft", {"phases.descent.rate_of_climb_ft_min": -4000.0}),
    ],
)
def test_aircraft_that_cannot_fly_are_refused_in_the_same_words(mission, changes, monkeypatch):
    mission = coarse(mission, **changes)
    with pytest.raises(DesignError) as together:
        gw.fly(sized("in-line"), mission)
    monkeypatch.setattr(flying, "log_at_once", lambda flown: None)
    with pytest.raises(DesignError) as alone:
        gw.fly(sized("in-line"), mission)
    assert str(together.value) == str(alone.value)


@pytest.mark.parametrize(
    ("design", "mission", "key", "values"),
    [
        ("in-line", "regional-aircraft", "aircraft.mass_kg", (20000.0, 20700.0, 21400.0)),
        ("in-line-h2", "strategies", "strategies.top-up.charge_power_kw", (40.0, 55.0, 60.0)),
    ],
)
def test_flights_that_follow_have_the_bits_that_each_has_alone(design, mission, key, values):
    scattered = [coarse(mission, **{key: value}) for value in values]
    for flight, alone in zip(fly_each(sized(design), scattered), scattered, strict=True):
        flown = gw.fly(sized(design), alone)
        assert all(
            np.array_equal(a.values, b.values) for a, b in zip(flight_series(flight), flight_series(flown), strict=True)
        )


@pytest.mark.parametrize(
    "changes",
    [
        {"battery.energy_kwh": 60.0},
        {"battery.cells": {"highest_temperature_k": 300.0}},
        {"phases.climb.power_kw": 4000.0},
        {"phases.cruise.tas_kt": 560.0},
        {"phases.run-up.power_kw": 0.01, "phases.run-up.end_power_kw": 0.01},
    ],
)
def test_what_cannot_be_flown_is_refused_in_the_same_words(changes, monkeypatch):
    mission = coarse("thesis", **changes)
    with pytest.raises(DesignError) as together:
        gw.fly(sized("in-line-h2"), mission)
    monkeypatch.setattr(flying, "log_at_once", lambda flown: None)
    with pytest.raises(DesignError) as alone:
        gw.fly(sized("in-line-h2"), mission)
    assert str(together.value) == str(alone.value)
    assert "phases." in str(alone.value)
