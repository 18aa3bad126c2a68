"""The gearbox law of NASA's study of electric propulsion (Brown and others, 2005)."""

from __future__ import annotations

from gearwright.units import HORSEPOWER, POUND, RPM

PUBLISHED_CONSTANT = 72.0
"""Constant K [lb] of the study (Brown et al. 2005)."""
EXISTING_GEARBOXES = 94.0
"""Constant K [lb] for gearboxes in service (from general knowledge; the original was not read)."""


def mass_brown(
    power: float, engine_speed: float, propeller_speed: float, *, constant: float = PUBLISHED_CONSTANT
) -> float:
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
