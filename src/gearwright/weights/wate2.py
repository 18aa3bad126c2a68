"""The propeller gearbox of the Navy/NASA engine program's weight code WATE-2 (1983)."""

from __future__ import annotations

import math

from gearwright.units import FOOT, POUND, POUND_FORCE


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
