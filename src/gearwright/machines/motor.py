"""An electric motor: mass and rotor inertia from its torque, losses over torque and speed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from gearwright.units import FOOT, POUND, POUND_FORCE

POWER_LAW_COEFFICIENT = 1.854
"""k of m = k T^0.33 [kg/(N m)^0.33]: the motor is 30 % of gearbox and motor at 4500 rpm, as Pulvirenti 2023 says."""
POWER_LAW_EXPONENT = 0.33
ROTOR_SHARE = 0.4
"""Part of the motor's mass that turns; an assumption for the inertia estimate only."""
MEAN_DENSITY = 4500.0
"""Mean density of motor and housing [kg/m³]; an assumption for sizes and inertia only."""
LENGTH_RATIO = {"radial": 1.5, "axial": 0.4}
"""Length over diameter: a radial-flux machine is slender, an axial-flux machine squat (Pulvirenti 2023, §2.2)."""
LOSS_SHARES = (0.5, 0.3, 0.1, 0.1)
"""Assumed parts of copper, iron, windage and constant losses at the rated point [-]."""


def motor_mass_ndarc(torque: float) -> float:
    """Return the mass of a motor by NDARC's law [kg].

    Args:
        torque: Rated torque [N m].

    Source: m[lb] = 0.3928 Q[lb ft]^0.8587; Johnson, NDARC (NASA/TP-2015-218751), electric motor weight.

    >>> round(motor_mass_ndarc(2132.7), 1)
    99.1
    """
    return 0.3928 * math.pow(torque / (POUND_FORCE * FOOT), 0.8587) * POUND


def motor_mass_power_law(torque: float) -> float:
    """Return the mass of a motor by a power law of its torque [kg]; about a quarter of NDARC's.

    Args:
        torque: Rated torque [N m].

    Source: m = k T^0.33; Pulvirenti 2023, appendix. Its exponent is doubtful (NDARC 0.8587), its k is not printed.

    >>> round(motor_mass_power_law(2132.7), 1)
    23.3
    """
    return POWER_LAW_COEFFICIENT * math.pow(torque, POWER_LAW_EXPONENT)


def motor_diameter(mass: float, length_ratio: float) -> float:
    """Return the outer diameter of a motor taken as a cylinder of mean density [m].

    Args:
        mass: [kg].
        length_ratio: Length over diameter [-].

    Source: cylinder of 4500 kg/m³; an estimate.
    """
    return math.cbrt(4.0 * mass / (math.pi * length_ratio * MEAN_DENSITY))


def rotor_inertia(mass: float, diameter: float) -> float:
    """Return the polar inertia of a motor's rotor [kg m²].

    Args:
        mass: Of the whole motor [kg].
        diameter: Outer diameter of the motor [m].

    Source: disc of 40 % of the mass and 60 % of the diameter; an estimate.
    """
    return ROTOR_SHARE * mass * (0.6 * diameter) ** 2 / 8.0


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
    eddy: float = 0.0
    """k_e of k_e ω² [W s²/rad²]."""
    stray: float = 0.0
    """k_s of k_s |T| ω: switching and stray load, inverter [-]."""


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
    copper, iron, windage, constant = (share * lost for share in LOSS_SHARES)
    return MotorLosses(
        copper / torque**2, iron / speed, windage / speed**3, constant, overload * torque, overload * power
    )


def shared_losses(power: float, speed: float, *, lost: float, shares: Sequence[float], overload: float) -> MotorLosses:
    """Return the coefficients of a motor whose loss at the rated point is divided by stated parts.

    Args:
        power: Rated shaft power [W].
        speed: Rated speed [rad/s].
        lost: There, with its inverter [W].
        shares: Of copper, hysteresis, eddy currents, windage, stray load and switching, constant; their sum is 1 [-].
        overload: Limits over ratings, of torque and power [-].

    Source: P = k_c T² + k_i ω + k_e ω² + k_w ω³ + k_s |T| ω + C. With parts of 0.29, 0.11, 0.16, 0, 0.44 and 0 it has
        the efficiencies of a published map of 1800 N m and 6000 rpm (NASA Aviary) within 0.0065 above a tenth of the
        torque and a sixth of the speed.
    """
    torque = power / speed
    copper, iron, eddy, windage, stray, constant = (share * lost for share in shares)
    limits = overload * torque, overload * power
    coefficients = copper / torque**2, iron / speed, windage / speed**3, constant
    return MotorLosses(*coefficients, *limits, eddy / speed**2, stray / power)


def motor_loss(motor: MotorLosses, torque: float, speed: float) -> float:
    """Return the power that a motor or generator turns into heat [W].

    Args:
        motor: Its coefficients.
        torque: At the shaft, of either sign [N m].
        speed: [rad/s].

    Source: Larminie and Lowry (2012), eq. 7.23, with eddy currents and stray load where they are
        given. A motor without torque is switched off and only its iron and windage
        are dragged along.
    """
    turning = abs(speed)
    dragged = motor.iron * turning + motor.eddy * turning**2 + motor.windage * turning**3
    switched_on = motor.constant * (torque != 0.0)
    return dragged + motor.copper * torque * torque + motor.stray * abs(torque) * turning + switched_on
