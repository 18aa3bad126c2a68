"""The drive-system laws of NASA's rotorcraft design code NDARC: AFDD00 (in the thesis NASA'15) and AFDD83."""

from __future__ import annotations

from gearwright.units import HORSEPOWER, POUND, RPM


def mass_afdd00(power: float, engine_speed: float, propeller_speed: float, *, rotors: float = 1.0) -> float:
    """Return the mass of gear boxes and rotor shafts by AFDD00.

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
    """Return the mass of gear boxes and rotor shafts by AFDD83.

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
