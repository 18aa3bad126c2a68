"""Formulas of the EC120B "Colibri" term project for gears, shafts, bearings and keys, as executed."""

import math
from dataclasses import dataclass
from enum import Enum

from gearwright.base import RPM
from gearwright.parts.bearings import LoadFactors
from gearwright.parts.shafts import KeySection

# ----------------------------------------------------------------------------------------------------------------------
# The gear formulas of the EC120B "Colibri" term project, as printed and as they were executed.
#
# They replay the report and show its errors; they are not for design: see `iso6336_rating` and `bevel_iso10300`.
# Source of all: Uyar, Kılıç, Koşar & Bölükbaş, Transmission System Design for Colibri, Istanbul Technical University.
# ----------------------------------------------------------------------------------------------------------------------


FRACTURE_COEFFICIENT = 0.6
"""Coefficient of eq. 1.1 [-]; exactly (2/(π² cos 20°))^⅓ = 0.5997 with ψ = b/(π m_n) and γ = π cos α Y_Fa."""
PITTING_COEFFICIENT = 0.9
"""Coefficient of eq. 1.2 [-]; exactly (0.175 · 4/(π sin 20° cos 20°))^⅓ = 0.8850."""
SPEED_CONSTANT = 35.9
"""Speed that doubles the load in the report's dynamic factor [m/s]; inferred from its two values of K_v."""
_FORM_TEETH = (16.0, 17.0)
_FORM_VALUES = (8.8, 8.6)


class Reading(Enum):
    """How to read eq. 1.2."""

    PRINTED = "as printed"
    """Without ε_α."""
    EXECUTED = "as executed"
    """With ε_α in the denominator: only so do the report's three pitting modules come out, to five digits."""


@dataclass(frozen=True)
class ReportGear:
    """What eqs 1.1 and 1.2 take."""

    torque: float
    """M_d on the gear [N m]."""
    teeth: int
    """N [-]."""
    ratio: float
    """i [-]."""
    form_factor: float
    """γ [-]."""
    contact_ratio: float
    """ε_α [-]."""
    helix_angle: float = 0.0
    """β_0 [rad]."""
    width_ratio: float = 12.0
    """ψ = b/(π m_n) [-]."""
    application_factor: float = 1.0
    """K_A [-]."""


@dataclass(frozen=True)
class ReportForces:
    """Forces on a gear as the report takes them."""

    tangential: float
    """F_t or W_t [N]."""
    radial: float
    """F_r or W_r [N]."""
    axial: float
    """F_a or W_a [N]."""
    normal: float
    """F_n [N]; computed in the report and not used."""


def form_factor_colibri(equivalent_teeth: float) -> float:
    """Return the form factor γ of the report's table 2.

    Args:
        equivalent_teeth: z_eq, which the report rounds to two decimals [-].

    Source: table 2, straight between γ = 8.8 at 16 (inferred) and 8.6 at 17 (printed).

    >>> round(form_factor_colibri(16.64), 3)
    8.672
    """
    slope = (_FORM_VALUES[1] - _FORM_VALUES[0]) / (_FORM_TEETH[1] - _FORM_TEETH[0])
    return _FORM_VALUES[0] + slope * (equivalent_teeth - _FORM_TEETH[0])


def dynamic_factor_colibri(speed: float) -> float:
    """Return the report's dynamic factor K_v.

    Args:
        speed: Pitch-line velocity at the module of eq. 1.1 before it is rounded up [m/s].

    Source: inferred from the two printed values, 1 + (v/35.9 m/s)²; no published rule of this form is known.
    """
    return 1.0 + (speed / SPEED_CONSTANT) ** 2


def fracture_module(gear: ReportGear, *, dynamic_factor: float, allowable: float) -> float:
    """Return the module that eq. 1.1 asks against fracture of a tooth [m].

    Args:
        gear: Load and teeth.
        dynamic_factor: K_v [-].
        allowable: σ_em [Pa].

    Source: eq. 1.1, m_n = 0.6 ∛(K_A K_V M_d γ cos β_0/(z σ_em ε_α ψ)).

    >>> pinion = ReportGear(512.5166667, 15, 4.0, 8.672, 1.65, math.radians(15.0))
    >>> round(1e3 * fracture_module(pinion, dynamic_factor=1.1165, allowable=220e6), 4)
    2.5117
    """
    load = gear.application_factor * dynamic_factor * gear.torque * gear.form_factor * math.cos(gear.helix_angle)
    return FRACTURE_COEFFICIENT * math.cbrt(load / (gear.teeth * allowable * gear.contact_ratio * gear.width_ratio))


def pitting_module(
    gear: ReportGear, reading: Reading, *, dynamic_factor: float, allowable: float, elastic_modulus: float
) -> float:
    """Return the module that eq. 1.2 asks against pitting [m].

    Args:
        gear: Load and teeth.
        reading: As printed, or as executed.
        dynamic_factor: K_v [-].
        allowable: P_em [Pa].
        elastic_modulus: E [Pa].

    Source: eq. 1.2, m_n = 0.9 ∛(K_A K_V M_d E (i+1) cos⁴ β_0/(z² P_em² i ψ)).

    >>> pinion = ReportGear(512.5166667, 15, 4.0, 8.672, 1.65, math.radians(15.0))
    >>> at = dict(dynamic_factor=1.1165, allowable=1400e6, elastic_modulus=200e9)
    >>> [round(1e3 * pitting_module(pinion, reading, **at), 4) for reading in Reading]
    [2.5791, 2.1826]
    """
    load = gear.application_factor * dynamic_factor * gear.torque * elastic_modulus * (gear.ratio + 1.0)
    load *= math.cos(gear.helix_angle) ** 4
    strength = gear.teeth**2 * allowable**2 * gear.ratio * gear.width_ratio
    shared = gear.contact_ratio if reading is Reading.EXECUTED else 1.0
    return PITTING_COEFFICIENT * math.cbrt(load / (strength * shared))


def settled_dynamic_factor(gear: ReportGear, *, speed: float, allowable: float) -> float:
    """Return K_v at which the fracture module and the speed that it makes agree.

    Args:
        gear: Load and teeth.
        speed: Speed of the gear ω [rad/s].
        allowable: σ_em [Pa].

    Returns:
        K_v [-], 1.1165 for the helical and 1.0188 for the bevel pinion.

    Source: the report's iteration, which starts from K_v = 1.
    """
    factor = 1.0
    for _ in range(60):
        module = fracture_module(gear, dynamic_factor=factor, allowable=allowable)
        factor = dynamic_factor_colibri(0.5 * speed * module * gear.teeth / math.cos(gear.helix_angle))
    return factor


def report_diameters(module: float, teeth: int, helix_angle: float) -> tuple[float, float, float]:
    """Return the addendum, dedendum and pitch diameter [m].

    Args:
        module: m_n [m].
        teeth: N [-].
        helix_angle: β [rad].

    Source: eqs 1.3 to 1.5; the report applies them to its bevel gears as well, which have other tip and root circles.

    >>> [round(1e3 * each, 4) for each in report_diameters(3e-3, 15, math.radians(15.0))]
    [52.5874, 39.3874, 46.5874]
    """
    pitch = module * teeth / math.cos(helix_angle)
    return pitch + 2.0 * module, pitch - 2.4 * module, pitch


def report_width(module: float, width_ratio: float) -> float:
    """Return the face width of eq. 1.6, b = ψ π m_n [m].

    Args:
        module: m_n [m].
        width_ratio: ψ [-].

    Source: eq. 1.6; with ψ = 12 it gives b = 37.7 m_n, about twice what such gears can use.
    """
    return width_ratio * math.pi * module


def helical_forces_colibri(
    torque: float, diameter: float, *, pressure_angle: float, helix_angle: float
) -> ReportForces:
    """Return the forces on a helical gear by the report's formulas.

    Args:
        torque: M_d [N m].
        diameter: d [m]; for shaft 2 the report takes that of the straight bevel pinion.
        pressure_angle: α [rad].
        helix_angle: β [rad].

    Source: section C; its F_a carries cos α in numerator and denominator, which cancel.

    >>> angles = dict(pressure_angle=math.radians(20.0), helix_angle=math.radians(15.0))
    >>> round(helical_forces_colibri(512.5166667, 46.587e-3, **angles).axial, 3)
    5895.569
    """
    force = 2.0 * torque / diameter
    cosine = math.cos(helix_angle)
    return ReportForces(
        tangential=force,
        radial=force * math.tan(pressure_angle) / cosine,
        axial=force * math.tan(helix_angle),
        normal=force / (math.cos(pressure_angle) * cosine),
    )


def bevel_forces_colibri(torque: float, diameter: float, *, pressure_angle: float, pitch_angle: float) -> ReportForces:
    """Return the forces on a straight bevel gear by the report's formulas.

    Args:
        torque: M_d [N m].
        diameter: d_av as printed; as executed the outer diameter of a gear of another module [m].
        pressure_angle: Φ [rad].
        pitch_angle: Γ [rad].

    Source: section C; W_r = W_t tan Φ cos Γ, W_a = W_t tan Φ sin Γ.
    """
    force = 2.0 * torque / diameter
    tangent = math.tan(pressure_angle)
    return ReportForces(
        tangential=force,
        radial=force * tangent * math.cos(pitch_angle),
        axial=force * tangent * math.sin(pitch_angle),
        normal=force / math.cos(pressure_angle),
    )


# ----------------------------------------------------------------------------------------------------------------------
# The shaft, bearing and key formulas of the EC120B "Colibri" term project, as they were executed.
#
# They replay the report and show its errors; they are not for design: see `shaft_fatigue`, `bearing_load` and `key`.
# Source of all: Uyar, Kılıç, Koşar & Bölükbaş, Transmission System Design for Colibri, Istanbul Technical University.
# ----------------------------------------------------------------------------------------------------------------------


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
