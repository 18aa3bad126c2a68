"""Losses of an electric motor or generator over torque and speed: its efficiency map as a formula."""

from __future__ import annotations

from typing import NamedTuple

SHARES = (0.5, 0.3, 0.1, 0.1)
"""Assumed parts of copper, iron, windage and constant losses at the rated point [-]."""


class MotorLosses(NamedTuple):
    """Coefficients of P_loss = k_c T² + k_i ω + k_w ω³ + C."""

    copper: float
    """k_c [W/(N m)²]."""
    iron: float
    """k_i [W s/rad]."""
    windage: float
    """k_w [W s³/rad³]."""
    constant: float
    """C: electronics, while it runs [W]."""
    peak_torque: float
    """Torque limit [N m]."""
    peak_power: float
    """Power limit at the shaft [W]."""


def rated_losses(power: float, speed: float, *, efficiency: float, overload: float = 1.0) -> MotorLosses:
    """Return the coefficients of a motor that has an efficiency at its rated point.

    Args:
        power: Rated shaft power [W].
        speed: Rated speed [rad/s].
        efficiency: At the rated point, with its inverter [-].
        overload: Limits over ratings, of torque and power [-].

    Source: form of Larminie and Lowry, Electric Vehicle Technology Explained (2012), eq. 7.23; the split of the
        losses at the rated point is an assumption.
    """
    lost = power * (1.0 / efficiency - 1.0)
    torque = power / speed
    copper, iron, windage, constant = (share * lost for share in SHARES)
    return MotorLosses(
        copper / torque**2, iron / speed, windage / speed**3, constant, overload * torque, overload * power
    )


def motor_loss(motor: MotorLosses, torque: float, speed: float) -> float:
    """Return the power that a motor or generator turns into heat [W].

    Args:
        motor: Its coefficients.
        torque: At the shaft, of either sign [N m].
        speed: [rad/s].

    Source: Larminie and Lowry (2012), eq. 7.23. A motor without torque is switched off and only its iron and windage
        are dragged along.
    """
    turning = abs(speed)
    dragged = motor.iron * turning + motor.windage * turning**3
    return dragged + (motor.copper * torque * torque + motor.constant if torque != 0.0 else 0.0)
