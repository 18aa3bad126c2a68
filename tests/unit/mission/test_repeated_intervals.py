"""Intervals that ask what the one before asks are computed once; what one flight is refused for leaves others alone."""

import numpy as np
import pytest

import gearwright as gw
from gearwright.catalogue import propeller_map
from gearwright.errors import DesignError
from gearwright.machines import angle_for_power, angle_for_thrust
from gearwright.mission import fly_each
from gearwright.mission.charts import angle_along
from gearwright.mission.profile import runs_of, spread


def test_of_a_run_the_first_few_speak_for_the_rest():
    asked = np.array([1.0, 1.0, 1.0, 1.0, 2.0, 2.0, np.nan, np.nan, np.nan])
    starts = np.array([True, False, False, False, False, True, False, False, False])
    runs = runs_of([asked], starts, 2)
    assert runs.kept.tolist() == [0, 1, 4, 5, 6, 7]
    assert runs.source.tolist() == [0, 1, 1, 1, 2, 3, 4, 5, 5]
    assert spread((asked[runs.kept], {"none": None}), runs.source)[0].tolist()[:6] == asked[:6].tolist()


def test_a_flight_without_a_course_leaves_the_others_their_bits():
    sizing, mission = gw.size(gw.read("in-line-h2")), gw.read_mission("thesis")
    warm, cold = (gw.edited_mission(mission, {"isa_offset_k": offset}) for offset in (9.0, -4.0))
    supersonic = gw.edited_mission(mission, {"phases.cruise.tas_kt": 640.0})
    first, refused, last = fly_each(sizing, [warm, supersonic, cold])
    assert isinstance(refused, DesignError) and "phases.cruise" in str(refused)
    for flight, alone in ((first, warm), (last, cold)):
        assert np.array_equal(flight.history.state_of_charge, gw.fly(sizing, alone).history.state_of_charge)


@pytest.mark.parametrize("name", ["6-blades-af115", "6-blades-af115-all-states"])
def test_blade_angles_of_many_points_are_those_of_each(name):
    chart, random = propeller_map(name), np.random.default_rng(3)
    ratio = random.uniform(-0.05, 1.01 * chart.advance_ratio[-1], 300)
    for table, alone in ((chart.power, angle_for_power), (chart.thrust, angle_for_thrust)):
        wanted = random.uniform(table.min(), table.max(), len(ratio))
        angles, inside = angle_along(chart, ratio, wanted, table), 0
        for k, outside in enumerate(angles.outside.tolist()):
            if outside:
                with pytest.raises(DesignError, match=r"outside the map|blades stall"):
                    alone(chart, ratio[k], wanted[k])
                continue
            inside += 1
            assert angles.value[k] == pytest.approx(alone(chart, ratio[k], wanted[k]), abs=1e-14)  # the same formula
        assert 0 < inside < len(ratio)
