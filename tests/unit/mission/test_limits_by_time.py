"""Machines in flight: their limits for a time raise what they may give, and hold without a break."""

from __future__ import annotations

import re

import numpy as np
import pytest

from designs import HYBRID
from gearwright.errors import DesignError
from gearwright.mission import fly
from gearwright.mission.supply import Bound, outlasted
from gearwright.sizing import size
from gearwright.spec import parse, parse_mission

TEXT = (
    HYBRID[: HYBRID.index("[cases")].replace("power_kw = 1046", "power_kw = 1700") + "[cases.t.turbine]\nrating = 1\n"
)
LIMIT = "[turbines.turbine.limits.take-off]\npower_kw = 2051\nduration_min = 5\n"
SIZING = size(parse(TEXT + LIMIT))
MISSION = 'schema = 1\nname = "limits"\npropeller_map = "none"\n[engine]\nthermal_power_kw = 4000\n'
PHASE = (
    'mode = "conventional"\nduration_s = {}\naltitude_m = 0\nmach = 0.1\npropeller_speed_rpm = 1212\npower_kw = {}\n'
)


def flown(*phases, sizing=SIZING):
    """Return the flight of phases of a duration [s] and a power [kW] each."""
    tables = [f"[phases.p{k}]\n{PHASE.format(*phase)}" for k, phase in enumerate(phases)]
    return fly(sizing, parse_mission(MISSION + "".join(tables)))


def refused(*phases, sizing=SIZING):
    """Return the one problem of a flight that is refused."""
    with pytest.raises(DesignError) as caught:
        flown(*phases, sizing=sizing)
    (only,) = caught.value.problems
    return only


def test_a_take_off_limit_is_flown_for_its_time():
    # 1e-5: the drag of the bearings is that of the loads one round before.
    assert flown((290, 2000)).machines["turbine"].power.max() == pytest.approx(2000e3, rel=1e-5)


def test_a_rating_without_a_limit_is_all_that_a_turbine_gives():
    found = refused((290, 2000), sizing=size(parse(TEXT)))
    assert (
        found.path == "phases.p0"
        and "turbine: needs 2000 kW at 0 m, and gives 1700 kW (by its rating)" in found.message
    )


def test_a_phase_longer_than_the_limit_is_refused():
    found = refused((400, 2000))
    assert found.path == "phases.p0"
    assert "turbine: 2000 kW; more than 1700 kW lasts" in found.message
    assert "its limits allow 5 min; shorten the phase, or ask for less" in found.message


def test_a_phase_stronger_than_the_limit_is_refused():
    assert "turbine: needs 2100 kW at 0 m, and gives 2051 kW (by its rating)" in refused((60, 2100)).message


def test_the_time_counts_across_phases_until_a_break():
    assert refused((200, 2000), (200, 1900)).path == "phases.p1"
    assert len(flown((200, 2000), (60, 1700), (200, 2000)).mission.phases) == 3


def test_every_level_has_the_time_of_those_above_it():
    """1 for any time, 2 for 300 s, 3 for 30 s: 2.5 lasts no longer than 30 s, and 1.5 no longer than 300 s."""
    bounds = (
        Bound("m", "torque", 1.0, float("inf")),
        Bound("m", "torque", 2.0, 300.0),
        Bound("m", "torque", 3.0, 30.0),
    )

    def late(*intervals):
        """Return which intervals, of a duration [s] and a power at 10 rad/s [W] each, are too long, and the words."""
        duration, power = np.array(intervals).T
        always = np.ones(len(duration), bool)
        return outlasted([(bounds, always)], duration, {"m": power}, {"m": np.full(len(duration), 10.0)})

    assert late((30.0, -25.0), (270.0, 15.0)).where.tolist() == [False, False]
    assert late((30.0, -25.0), (271.0, 15.0)).where.tolist() == [False, True]
    with pytest.raises(DesignError, match=r"2\.5 N m; more than 2 N m lasts 0\.6667 min"):
        late((30.0, -25.0), (10.0, 25.0)).words(1)
    with pytest.raises(DesignError, match="beyond every limit"):
        late((1.0, 31.0)).words(0)


def test_a_power_that_is_a_little_too_much_is_told_with_the_digits_that_say_so():
    """Four digits would say that it needs 1700 kW and gives 1700 kW."""
    found = refused((290, 1700.02), sizing=size(parse(TEXT)))
    needed, given = re.search(r"needs ([\d.]+) kW at 0 m, and gives ([\d.]+) kW", found.message).groups()
    assert float(needed) == pytest.approx(1700.02, abs=0.02) and float(needed) > float(given) == 1700.0
