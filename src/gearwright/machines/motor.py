"""Mass and rotor inertia of an electric motor from its torque."""

from __future__ import annotations

import math

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
