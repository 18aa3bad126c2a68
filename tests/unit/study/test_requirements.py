"""Architectures at requirements: every one that can exist has an answer, and the others their one reason."""

import math

import pytest

from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.spec import parse, read
from gearwright.study import compare, for_engine, for_requirement
from gearwright.units import RPM


def asked(power, fast, slow):
    return compare(power=power, engine_speed=fast * RPM, propeller_speed=slow * RPM)


@pytest.mark.parametrize(("power", "fast", "slow"), [(2e6, 26000, 1000), (400e3, 13800, 2000)])
def test_every_architecture_has_an_answer_where_each_can_exist(power, fast, slow):
    assert not asked(power, fast, slow).failed


def test_motors_that_no_rotor_bears_are_the_one_reason_at_thirty_megawatts():
    """14.7 MW as fast as a turbine of 24 000 rpm: 1.27 MW are what a rotor of magnets bears there."""
    failed = asked(30e6, 24000, 600).failed
    assert {row.design for row in failed} >= {"off-set-h1", "in-line-h1", "mixed-h1"}
    assert all(row.problem.startswith("motors.electric.speed_rpm: ") for row in failed)


def test_two_planetary_sets_in_line_exist_from_their_least_ratio_up():
    """Each at least 2 + 2·12/400 = 2.06, together 4.24; the others reach 4.2 and 4.3 alike."""
    below, above = asked(1e6, 4200, 1000), asked(1e6, 4300, 1000)
    assert {row.design for row in below.failed} == {"in-line", "in-line-h1", "in-line-h2"}
    for row in below.failed:
        assert row.problem.startswith("planetaries.")
        assert "all stages to the propeller together give no ratio below 4.24, and 4.2 is asked" in row.problem
    assert not above.failed


def test_a_speed_up_has_the_answers_of_those_that_are_pairs_only():
    rows = asked(1e6, 1000, 1400)
    assert {row.design for row in rows.good} == {"off-set", "off-set-h1", "off-set-h2", "off-set-h3"} | {
        row.design for row in rows.good if row.design.startswith("mixed")
    }
    assert {row.design for row in rows.failed} >= {"in-line", "in-line-h1", "in-line-h2"}


def test_a_design_that_cannot_be_fitted_is_a_row_with_its_reason():
    none = read(shipped_design("off-set")).model_copy(update={"turbines": {}})
    rows = compare({"off-set": read(shipped_design("off-set")), "none": none}, power=1e6)
    assert [row.design for row in rows.good] == ["off-set"]
    (row,) = rows.failed
    assert (row.design, row.problem.endswith("add a table such as [turbines.gas-turbine]")) == ("none", True)


def test_where_no_architecture_exists_each_says_why():
    with pytest.raises(DesignError) as refused:
        compare({name: read(shipped_design(name)) for name in ("in-line", "star")}, power=1e6, engine_speed=100.0,
                propeller_speed=100.0)  # fmt: skip
    assert [problem.path for problem in refused.value.problems] == ["in-line", "star"]
    assert all("every case failed, the first with planetaries." in each.message for each in refused.value.problems)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
@pytest.mark.parametrize("name", ["power", "engine_speed", "propeller_speed"])
def test_what_is_no_power_or_speed_is_refused_by_its_name(name, value):
    for verb in (for_engine, for_requirement):
        with pytest.raises(DesignError) as refused:
            verb(read(shipped_design("in-line")), **{name: value})
        (problem,) = refused.value.problems
        assert problem.path == name
        assert "must be above 0 and finite" in problem.message


def test_limits_by_time_are_scaled_with_the_engine():
    """Half again the power at half the speed: 1.5 times the limit in power, half of it in speed, 3 times in torque."""
    limits = "[turbines.gas-turbine.limits.take-off]\npower_kw = 1200\ntorque_nm = 700\n"
    limits += "speed_rpm = 21000\nduration_min = 5\n"
    limited = parse(shipped_design("in-line-h2").read_text(encoding="utf-8") + limits)
    total = sum(machine.power for machine in (limited.turbines | limited.motors).values())
    speed = limited.turbines["gas-turbine"].speed
    fitted = for_engine(limited, power=1.5 * total, engine_speed=0.5 * speed)
    limit = fitted.turbines["gas-turbine"].limits["take-off"]
    assert limit.power == pytest.approx(1800e3)
    assert limit.speed == pytest.approx(10500 * RPM)
    assert limit.torque == pytest.approx(2100.0)
    assert limit.duration == 300.0
