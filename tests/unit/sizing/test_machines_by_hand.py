"""Machines of a sizing and loads of bearings, by hand; safeties of one case and of the same case twice."""

import pytest
from shaft_designs import OFF_SET

from designs import PAIR
from gearwright.shipped import shipped_design
from gearwright.sizing import bearing_forces, size
from gearwright.spec import parse, read
from gearwright.units import RPM

CASES = "[cases.full.turbine]\npower_kw = 100\n[cases.half.turbine]\npower_kw = 40\n"


def test_a_machine_has_the_torque_of_its_rating_and_a_propeller_the_largest_of_its_cases():
    sizing = size(parse(PAIR + CASES))
    machines = {machine.name: machine for machine in sizing.machines}
    assert machines["turbine"].torque == pytest.approx(100e3 / (6000 * RPM))
    ratio = sizing.teeth["stage.wheel"] / sizing.teeth["stage.pinion"]
    assert machines["propeller"].torque == pytest.approx(100e3 / (6000 * RPM) * ratio)
    assert (machines["turbine"].kind, machines["propeller"].shaft) == ("turbine", "slow")


def test_an_inertia_that_is_given_is_kept_and_said_to_be_so():
    text = PAIR.replace("power_kw = 100\n", "power_kw = 100\ninertia_kg_m2 = 0.25\n")
    machines = {machine.name: machine for machine in size(parse(text)).machines}
    assert (machines["turbine"].inertia, machines["turbine"].inertia_is_given) == (0.25, True)
    assert machines["propeller"].inertia > 0.0 and not machines["propeller"].inertia_is_given


def test_bearings_bear_what_their_shafts_say_and_rounding_is_nothing():
    """The input of two opposite wheels bears nothing; the others what their diagrams end with."""
    sizing = size(parse(OFF_SET))
    rows = bearing_forces(sizing)
    listed = [(shaft.name, bearing.position) for shaft in sizing.shafts for bearing in shaft.bearings]
    assert [(row.shaft, row.position) for row in rows] == listed
    forces = {name: [row.radial_force for row in rows if row.shaft == name] for name in sizing.design.shafts}
    assert forces["input"] == [0.0, 0.0]
    for shaft in sizing.shafts:
        if shaft.name != "input":
            assert forces[shaft.name] == [bearing.radial_force for bearing in shaft.bearings]
            assert min(forces[shaft.name]) > 1e3
    assert bearing_forces(size(read(shipped_design("star")))) == ()


@pytest.mark.parametrize("method", ["iso6336", "agma2001"])
def test_a_life_cut_into_equal_cases_is_the_life_of_one(method):
    """Two cases of the same power, half of the life each: Miner's sum of both is that of the whole, to the step of its
    root."""
    text = PAIR + "pinion_teeth = 23\nwheel_teeth = 69\nmodule_mm = 3\nface_width_mm = 30\n"
    text += f'[gears]\nrating = "{method}"\n'
    same = "[cases.one.turbine]\npower_kw = 100\n[cases.two.turbine]\npower_kw = 100\n"
    (cut,) = size(parse(text + same + "[service]\nshares = { one = 0.5, two = 0.5 }\n")).meshes
    (whole,) = size(parse(text)).meshes
    for gear in (0, 1):
        assert cut.rating.pitting[gear] == pytest.approx(whole.rating.pitting[gear], rel=1e-3)
        assert cut.rating.bending[gear] == pytest.approx(whole.rating.bending[gear], rel=1e-3)
