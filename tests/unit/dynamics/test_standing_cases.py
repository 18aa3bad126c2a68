"""Cases in which some machine, or all of them, stand still have the critical speeds of what turns."""

import pytest

from gearwright.dynamics.vibration import critical_speeds, turning_shaft
from gearwright.errors import DesignError
from shipped_work import sized


def test_a_case_that_a_brake_holds_has_no_critical_speeds():
    cases = ", ".join(speeds.cases for speeds in critical_speeds(sized("e-axle")))
    assert "parked" not in cases
    assert "launch" in cases


def test_asked_for_the_critical_speeds_of_a_parked_car_the_answer_is_a_refusal():
    with pytest.raises(DesignError, match="nothing turns in parked"):
        critical_speeds(sized("e-axle"), cases=["parked"])


def test_the_speed_of_a_case_is_that_of_the_first_machine_that_turns():
    assert turning_shaft(sized("twin-engine-helicopter"), "hover") == "engine-1"
    assert turning_shaft(sized("twin-engine-helicopter"), "other-engine-inoperative") == "engine-2"
    assert turning_shaft(sized("twin-engine-helicopter"), "rotor-braked") is None
