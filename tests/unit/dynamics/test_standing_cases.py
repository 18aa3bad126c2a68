"""Cases in which some machine, or all of them, stand still have the critical speeds of what turns."""

import pytest

from gearwright.dynamics.vibration import critical_speeds, turning_shaft
from gearwright.errors import DesignError
from gearwright.shipped import shipped_design
from gearwright.sizing import size
from gearwright.spec import read

CAR, HELICOPTER = (size(read(shipped_design(name))) for name in ("e-axle", "twin-engine-helicopter"))


def test_a_case_that_a_brake_holds_has_no_critical_speeds():
    cases = ", ".join(speeds.cases for speeds in critical_speeds(CAR))
    assert "parked" not in cases
    assert "launch" in cases


def test_asked_for_the_critical_speeds_of_a_parked_car_the_answer_is_a_refusal():
    with pytest.raises(DesignError, match="nothing turns in parked"):
        critical_speeds(CAR, cases=["parked"])


def test_the_speed_of_a_case_is_that_of_the_first_machine_that_turns():
    assert turning_shaft(HELICOPTER, "hover") == "engine-1"
    assert turning_shaft(HELICOPTER, "other-engine-inoperative") == "engine-2"
    assert turning_shaft(HELICOPTER, "rotor-braked") is None
