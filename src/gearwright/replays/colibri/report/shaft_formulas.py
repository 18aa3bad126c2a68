"""The shaft, bearing and key formulas of the EC120B "Colibri" term project, as they were executed.

They replay the report and show its errors; they are not for design: see `shaft_fatigue`, `bearing_load` and `key`.
Source of all: Uyar, Kılıç, Koşar & Bölükbaş, Transmission System Design for Colibri, Istanbul Technical University.
"""

from __future__ import annotations

from gearwright.parts.bearings import LoadFactors
from gearwright.parts.joints import KeySection
from gearwright.units import RPM

TORQUE_CONSTANT = 9550.0
"""Torque in N m of 1 kW at 1 rpm, as the report rounds it; exactly 30000/π = 9549.3."""
KEY_PRESSURE = 450e6
"""Pressure on a key that gives the report's three lengths [Pa]; not stated."""


def report_torque(power: float, speed: float) -> float:
    """Return the torque of the report's section A, M_d = 9550 P/n [N m].

    Args:
        power: P [W].
        speed: n [rad/s].

    Source: section A; its result is labelled N mm and is N m.

    >>> round(report_torque(322e3, 6000 * RPM), 7)
    512.5166667
    """
    return TORQUE_CONSTANT * (power / 1e3) / (speed / RPM)


def report_bearing_load(radial: float, axial: float, static_rating: float, factors: LoadFactors) -> float:
    """Return the load that the report compares with C_0 [N].

    Args:
        radial: F_r [N].
        axial: F_a [N].
        static_rating: C_0 [N].
        factors: X and Y [-].

    Source: section C as executed, X F_r + Y F_a/C_0: the axial term is a ratio where a force belongs.
    """
    return factors.radial * radial + factors.axial * axial / static_rating


def report_key_length(torque: float, diameter: float, section: KeySection) -> float:
    """Return the length of a key by the report [m].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].

    Source: inferred from its three lengths, l = T/(d (t_1 + t_2) 450 N/mm²): half the force T/(d/2), on both keyways'
        depths together.

    >>> round(1e3 * report_key_length(512.5166667, 0.032, KeySection(0.010, 0.008, 0.0047, 0.0028)), 4)
    4.7455
    """
    return torque / (diameter * (section.shaft_depth + section.hub_depth) * KEY_PRESSURE)
