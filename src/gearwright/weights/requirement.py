"""What a designer knows before anything is sized: power and two speeds."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gearwright.errors import Problem, refuse
from gearwright.units import HORSEPOWER, RPM, Number, Power, Ratio, Speed, Torque, text


@dataclass(frozen=True)
class Requirement:
    """Power and speeds of a reduction gearbox, from which every statistical method starts."""

    power: Power
    """Power at the rating that sizes the gearbox [W]."""
    engine_speed: Speed
    """Speed of the input [rad/s]."""
    propeller_speed: Speed
    """Speed of the output [rad/s]."""

    def __post_init__(self) -> None:
        problems = [
            Problem(name, f"{value!r} was given; a finite number above zero is needed")
            for name, value in vars(self).items()
            if not (math.isfinite(value) and value > 0.0)
        ]
        if not problems and self.engine_speed <= self.propeller_speed:
            speeds = (
                f"{text(self.engine_speed, 'speed')} at the engine, {text(self.propeller_speed, 'speed')} at the output"
            )
            problems.append(
                Problem("engine_speed", f"{speeds}; the methods are for reduction gearboxes: swap the speeds")
            )
        refuse(problems)

    @property
    def ratio(self) -> Ratio:
        """Input speed over output speed [-]."""
        return self.engine_speed / self.propeller_speed

    @property
    def input_torque(self) -> Torque:
        """Torque at the input [N m]."""
        return self.power / self.engine_speed

    @property
    def output_torque(self) -> Torque:
        """Torque at the output without losses [N m]."""
        return self.power / self.propeller_speed

    @property
    def beta(self) -> Number:
        """Weight parameter β of NASA/TM-2009-215680, in the units of the report."""
        return beta(self.power, self.engine_speed, self.propeller_speed)


def beta(power: float, engine_speed: float, propeller_speed: float) -> float:
    """Return the weight parameter β = (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15.

    Args:
        power: [W].
        engine_speed: Speed of the input [rad/s].
        propeller_speed: Speed of the output [rad/s].

    Source:
        NASA/TM-2009-215680, figure of gearbox weights.
    """
    torque = (power / HORSEPOWER) / (propeller_speed / RPM)
    return float(torque**0.75 * (engine_speed / propeller_speed) ** 0.15)


def from_beta(value: float, *, ratio: float, propeller_speed: float) -> Requirement:
    """Return the requirement that has a given β at an assumed ratio and output speed.

    Args:
        value: β, in the units of the report.
        ratio: Input speed over output speed [-].
        propeller_speed: Speed of the output [rad/s].

    Source:
        Inverse of `beta`.
    """
    torque = (value / ratio**0.15) ** (1.0 / 0.75)
    power = torque * (propeller_speed / RPM) * HORSEPOWER
    return Requirement(power, ratio * propeller_speed, propeller_speed)
