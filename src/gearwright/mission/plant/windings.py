"""Motors of a flight that warm up: winding and case, copper that resists more, limits that fall."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from gearwright.errors import DesignError, Problem
from gearwright.machines import MotorLosses, motor_loss
from gearwright.machines.power import Network, warmed
from gearwright.spec import WindingRules
from gearwright.units import CELSIUS, apart

COPPER = 234.5
"""Temperature below 0 °C at which copper's resistance would vanish if its slope went on [K]; IEC 60034-1."""


class Warmth(NamedTuple):
    """Temperatures of one motor."""

    winding: float
    """[K]"""
    case: float
    """[K]"""


Warmths = Mapping[str, Warmth]
"""Motor -> its temperatures; empty where a mission does not follow them."""


def started(rules: WindingRules | None, motors: Mapping[str, MotorLosses], air: float) -> Warmths:
    """Return the temperatures with which motors start.

    Args:
        rules: Of the mission; None: they are not followed.
        motors: By name.
        air: Temperature of the air [K].
    """
    if rules is None:
        return {}
    start = rules.start_temperature_k or rules.coolant_temperature_k or air
    return dict.fromkeys(motors, Warmth(start, start))


def warm_motor(rules: WindingRules | None, motor: MotorLosses, warmth: Warmth | None) -> MotorLosses:
    """Return a motor as its winding's temperature makes it: more copper loss, lower limits.

    Args:
        rules: Of the mission; None: temperature changes nothing.
        motor: At its rated temperature.
        warmth: Its temperatures.

    Source: R ∝ 234.5 + t for copper, t in °C (IEC 60034-1); limits fall linearly to nothing, as controllers have it.
    """
    if rules is None or warmth is None:
        return motor
    copper = (COPPER + warmth.winding - CELSIUS) / (COPPER + rules.rated_winding_k - CELSIUS)
    kept = 1.0
    if rules.derate_from_k is not None and rules.derate_from_k < rules.highest_winding_k:
        fall = (rules.highest_winding_k - warmth.winding) / (rules.highest_winding_k - rules.derate_from_k)
        kept = min(max(fall, 0.0), 1.0)
    return motor._replace(
        copper=motor.copper * copper, peak_torque=motor.peak_torque * kept, peak_power=motor.peak_power * kept
    )


def warmed_motor(
    rules: WindingRules, motor: MotorLosses, warmth: Warmth, *, at: tuple[float, float], air: float, duration: float
) -> Warmth:
    """Return a motor's temperatures after an interval.

    Args:
        rules: Of the mission.
        motor: As warm as it is.
        warmth: At the start.
        at: Torque [N m] and speed [rad/s].
        air: Temperature of the air [K].
        duration: [s].
    """
    torque, speed = at
    copper = rules.winding_loss * motor.copper * torque * torque
    heat = np.array([copper, motor_loss(motor, torque, speed) - copper])
    between = np.array([[0.0, rules.winding_to_case_w_k], [rules.winding_to_case_w_k, 0.0]])
    capacity = np.array([rules.winding_capacity_j_k, rules.case_capacity_j_k])
    network = Network(capacity, between, np.array([[0.0], [rules.case_to_coolant_w_k]]))
    around = np.array([rules.coolant_temperature_k or air])
    after = warmed(network, np.array(warmth), heat, surroundings=around, duration=duration)
    return Warmth(*after.temperature.tolist())


def refuse_hot(rules: WindingRules, name: str, warmth: Warmth) -> None:
    """Refuse a winding that is too warm.

    Args:
        rules: Of the mission.
        name: Of the motor.
        warmth: Its temperatures.

    Raises:
        DesignError: It is; with the limit.
    """
    if warmth.winding > rules.highest_winding_k * (1.0 + 1e-12):
        found, limit = apart(warmth.winding - CELSIUS, rules.highest_winding_k - CELSIUS, "temperature")
        message = (
            f"the winding of {name} reaches {found}, the highest is {limit}; give the motor less power or"
            " more cooling (case_to_coolant_w_k, coolant_temperature_k), or let derate_from_k lower its limits"
        )
        raise DesignError([Problem("motor.heat.highest_winding_k", message)])
