"""The form of a motor's losses against a published map of efficiency, and the parts that a mission states."""

import numpy as np
import pytest
from scipy.optimize import nnls

from gearwright.errors import DesignError
from gearwright.machines import motor_loss, rated_losses, shared_losses
from gearwright.mission import fly
from gearwright.spec import edited_mission, read_mission
from gearwright.units import RPM
from shipped_work import sized

SPEEDS = np.array([1000, 2000, 3000, 4000, 5000, 6000])
MAP = {
    187.2: (0.932, 0.928, 0.923, 0.918, 0.912, 0.907),
    417.6: (0.946, 0.954, 0.955, 0.954, 0.952, 0.950),
    648.0: (0.940, 0.956, 0.960, 0.961, 0.961, 0.960),
    993.6: (0.924, 0.949, 0.957, 0.961, 0.962, 0.963),
    1339.2: (0.905, 0.939, 0.951, 0.957, 0.959, 0.961),
    1800.0: (0.877, 0.923, 0.939, 0.948, 0.952, 0.954),
}
"""NASA Aviary, electric_motor_1800Nm_6000rpm.csv: torque [N m] -> efficiency at `SPEEDS` [rpm]."""


def test_the_form_of_the_losses_is_that_of_a_published_map():
    torque = np.repeat(list(MAP), len(SPEEDS))
    speed, printed = np.tile(SPEEDS * RPM, len(MAP)), np.concatenate(list(MAP.values()))
    power = torque * speed
    terms = np.column_stack([torque**2, speed, speed**2, speed**3, torque * speed, np.ones_like(speed)])
    fitted, _ = nnls(terms / power[:, None], 1.0 / printed - 1.0)
    found = 1.0 / (1.0 + terms @ fitted / power)
    assert np.abs(found - printed).max() < 0.008
    rated = terms[-1] * fitted
    motor = shared_losses(power[-1], speed[-1], lost=rated.sum(), shares=rated / rated.sum(), overload=1.0)
    again = [p / (p + motor_loss(motor, t, w)) for p, t, w in zip(power, torque, speed, strict=True)]
    assert again == pytest.approx(found, rel=1e-12)


def test_usual_shares_are_the_usual_motor():
    usual = rated_losses(1e6, 471.2, efficiency=0.95)
    stated = shared_losses(1e6, 471.2, lost=1e6 * (1 / 0.95 - 1), shares=(0.5, 0.3, 0.0, 0.1, 0.0, 0.1), overload=1.0)
    assert stated == pytest.approx(usual, rel=1e-12)


def test_a_flight_takes_the_stated_parts():
    mission = read_mission("strategies")
    other = edited_mission(mission, {"motor.loss_shares": [0.3, 0.1, 0.2, 0.0, 0.4, 0.0]})
    usual, stated = fly(sized(), mission), fly(sized(), other)
    assert stated.balance.motor_loss != pytest.approx(usual.balance.motor_loss, rel=1e-3)
    assert stated.balance.residual < 1e-9


def test_parts_that_are_not_a_whole_are_told():
    with pytest.raises(DesignError, match=r"motor.loss_shares: .*add up to 1, and these to 0\.9"):
        edited_mission(read_mission("strategies"), {"motor.loss_shares": [0.3, 0.1, 0.1, 0.0, 0.4, 0.0]})
