"""Published laws from power and speeds to the mass of a gearbox, each as its report prints it."""

from __future__ import annotations

import math

from gearwright.errors import DesignError, Problem
from gearwright.units import FOOT, HORSEPOWER, POUND, POUND_FORCE, RPM

TM215680_INTERCEPT = -37.4262
"""Weight at β = 0 [lb] (NASA/TM-2009-215680)."""
TM215680_SLOPE = 116.3297
"""Weight per unit of β [lb] (same source)."""
LEAST_BETA = 0.627
"""β of the lightest gearbox of the figure of NASA/TM-2009-215680; the line is negative below β = 0.322."""
GREATEST_BETA = 65.9
"""β of the heaviest gearbox of that figure."""
STUDY_CONSTANT = 72.0
"""Constant K [lb] of the study of electric propulsion (Brown et al. 2005)."""
EXISTING_GEARBOXES = 94.0
"""Constant K [lb] for gearboxes in service (from general knowledge; the original was not read)."""


def mass_afdd00(power: float, engine_speed: float, propeller_speed: float, *, rotors: float = 1.0) -> float:
    """Return the mass of gear boxes and rotor shafts by AFDD00 of NASA's rotorcraft code NDARC (in the thesis NASA'15).

    W = 95.7634 N^0.38553 P^0.78137 ω_e^0.09899 / ω_r^0.80686 lb.
    The gear box alone is 1 - f_RS of it, with f_RS about 0.10 to 0.13.

    Args:
        power: Limit of the drive system [W].
        engine_speed: Speed of the engine's output [rad/s].
        propeller_speed: Speed of the rotor or propeller [rad/s].
        rotors: Number of main rotors N [-].

    Source:
        Johnson 2015, NASA/TP-2015-218751, AFDD00 (from 52 rotorcraft, mean error 8.6 %); Pulvirenti 2023, eq. 1.1,
        with the propeller's speed below the line, where its eq. 1.2 prints the engine's.

    Valid for:
        Rotorcraft drive systems; numeric limits are not published with the law.

    >>> round(mass_afdd00(2051e3, 20204 * RPM, 1212 * RPM), 1)
    183.5
    """
    horsepower = power / HORSEPOWER
    speeds = (engine_speed / RPM) ** 0.09899 / (propeller_speed / RPM) ** 0.80686
    return float(95.7634 * rotors**0.38553 * horsepower**0.78137 * speeds * POUND)


def mass_afdd83(
    power: float, engine_speed: float, propeller_speed: float, *, second_torque: float = 3.0, gearboxes: float = 1.0
) -> float:
    """Return the mass of gear boxes and rotor shafts by AFDD83 of NDARC.

    W = 57.72 P^0.8195 f_Q^0.068 N_gb^0.0663 (ω_e/1000)^0.0369 / ω_r^0.6379 lb.

    Args:
        power: Limit of the drive system [W].
        engine_speed: Speed of the engine's output [rad/s].
        propeller_speed: Speed of the rotor or propeller [rad/s].
        second_torque: Torque of the second rotor f_Q, in per cent of the total [%].
        gearboxes: Number of gear boxes N_gb [-].

    Source:
        Johnson 2015, NASA/TP-2015-218751, AFDD83 (from 30 aircraft, mean error 7.7 %).

    Valid for:
        Rotorcraft drive systems; numeric limits are not published with the law.

    >>> round(mass_afdd83(2051e3, 20204 * RPM, 1212 * RPM))
    224
    """
    horsepower = power / HORSEPOWER
    counts = second_torque**0.068 * gearboxes**0.0663
    speeds = (engine_speed / RPM / 1000.0) ** 0.0369 / (propeller_speed / RPM) ** 0.6379
    return float(57.72 * horsepower**0.8195 * counts * speeds * POUND)


def mass_tm215680(beta: float) -> float:
    """Return the mass of a gearbox with its lubrication by a line in β, -37.4262 + 116.3297 β lb.

    Args:
        beta: Weight parameter (hp/rpm_out)^0.75 (rpm_in/rpm_out)^0.15, in the units of the report.

    Source:
        NASA/TM-2009-215680, figure of gearbox weights; constants as read from the figure in AeroSandbox.

    Valid for:
        0.627 ≤ β ≤ 65.9, the weights of the figure.

    Raises:
        DesignError: The line is not positive there.

    >>> from gearwright.weights import beta
    >>> from gearwright.units import RPM
    >>> round(mass_tm215680(beta(2051e3, 20204 * RPM, 1212 * RPM)), 1)
    131.8
    """
    weight = TM215680_INTERCEPT + TM215680_SLOPE * beta
    if weight <= 0.0:
        message = (
            f"{beta:.3g} makes the line negative; allowed {LEAST_BETA} to {GREATEST_BETA}: use the power-law refit"
        )
        raise DesignError([Problem("beta", message)])
    return weight * POUND


def mass_wate2(power: float, engine_speed: float, propeller_speed: float) -> float:
    """Return the mass of an in-line propeller gearbox, (0.0174 Q_out[lbf ft] + 45) √(0.118 GR) lb.

    Args:
        power: [W].
        engine_speed: [rad/s].
        propeller_speed: [rad/s].

    Source:
        Plencner, Senty and Wickenheiser 1983, NASA TM-83458, as given by Pulvirenti 2023, eq. 1.3. Q is the output
        torque; with the input torque, which the thesis names, a PW127 gearbox would weigh 36 kg.

    Valid for:
        In-line gearboxes of 1000 to 2500 hp (Pulvirenti 2023, section 1.3).

    >>> from gearwright.units import RPM
    >>> round(mass_wate2(2051e3, 20204 * RPM, 1212 * RPM), 1)
    160.6
    """
    torque = power / propeller_speed / (POUND_FORCE * FOOT)
    return (0.0174 * torque + 45.0) * math.sqrt(0.118 * engine_speed / propeller_speed) * POUND


def mass_brown(power: float, engine_speed: float, propeller_speed: float, *, constant: float = STUDY_CONSTANT) -> float:
    """Return the mass of a gearbox, K hp^0.76 rpm_in^0.13 / rpm_out^0.89 lb.

    The exponents of the three add up to zero in speed: the law is one of output torque and ratio alone.

    Args:
        power: [W].
        engine_speed: Speed of the input [rad/s].
        propeller_speed: Speed of the output [rad/s].
        constant: State of the art K [lb].

    Source:
        Brown, Kascak, Ebihara et al. 2005, NASA/TM-2005-213800. Pulvirenti 2023, section 1.3, takes it for a law of
        combustion engines; it is one of gearboxes.

    Valid for:
        Aircraft gearboxes; numeric limits are not published in what was read.

    >>> round(mass_brown(2051e3, 20204 * RPM, 1212 * RPM), 1)
    87.8
    """
    horsepower = power / HORSEPOWER
    speeds = (engine_speed / RPM) ** 0.13 / (propeller_speed / RPM) ** 0.89
    return float(constant * horsepower**0.76 * speeds * POUND)
