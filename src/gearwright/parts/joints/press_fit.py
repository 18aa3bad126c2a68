"""Press fits by Lamé and DIN 7190: pressure from interference, torque by friction, stress in hub and shaft."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gearwright.errors import DesignError, Problem
from gearwright.units import Density, Length, Ratio, Stress

SMOOTHING = 0.8
"""Share of both roughnesses R_z that pressing smooths away, each on both sides [-] (DIN 7190:2001)."""


@dataclass(frozen=True)
class FitPart:
    """Shaft or hub of a press fit."""

    diameter_ratio: Ratio
    """Q: bore over joint diameter for the shaft (0 if solid), joint over outer diameter for the hub [-]."""
    elastic_modulus: Stress
    """E [Pa]."""
    poisson_ratio: Ratio = 0.3
    """ν [-]."""
    roughness: Length = 0.0
    """R_z of the seat [m]."""
    density: Density = 7850.0
    """ρ [kg/m³]."""

    def __post_init__(self) -> None:
        """Refuse a part without a wall."""
        if not 0.0 <= self.diameter_ratio < 1.0:
            message = f"{self.diameter_ratio:g} given; allowed: 0 to below 1, or nothing is left of the part"
            raise DesignError([Problem("diameter_ratio", message)])


def fit_pressure(interference: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the pressure in a press fit [Pa].

    Args:
        interference: Difference of the diameters as made U [m].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: Lamé 1852; DIN 7190:2001: U − 0.8 (R_z,i + R_z,a) = p d (c_i/E_i + c_a/E_a),
        c_a = (1 + Q_a²)/(1 − Q_a²) + ν_a, c_i = (1 + Q_i²)/(1 − Q_i²) − ν_i.

    Valid for: elastic parts of equal length, at rest; turning, with what `centrifugal_loss` leaves of U.

    Raises:
        DesignError: If the parts do not overlap once their roughness is smoothed.
    """
    lost = SMOOTHING * (shaft.roughness + hub.roughness)
    if interference <= lost:
        message = f"{1e6 * interference:.4g} µm given; the fit holds above {1e6 * lost:.4g} µm, which smoothing takes"
        raise DesignError([Problem("interference", message)])
    return (interference - lost) / (diameter * (_widening(hub, 1.0) + _widening(shaft, -1.0)))


def fit_interference(pressure: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the interference as made that gives a pressure [m].

    Args:
        pressure: p [Pa].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: as `fit_pressure`, solved for U.
    """
    lost = SMOOTHING * (shaft.roughness + hub.roughness)
    return lost + pressure * diameter * (_widening(hub, 1.0) + _widening(shaft, -1.0))


def _widening(part: FitPart, sign: float) -> float:
    square = part.diameter_ratio**2
    return ((1.0 + square) / (1.0 - square) + sign * part.poisson_ratio) / part.elastic_modulus


def centrifugal_loss(speed: float, diameter: float, shaft: FitPart, hub: FitPart) -> float:
    """Return the interference that turning takes from a press fit, as the hub widens more than the shaft [m].

    Args:
        speed: Of both [rad/s].
        diameter: Of the joint d [m].
        shaft: Inner part [Pa, m].
        hub: Outer part [Pa, m].

    Source: Lamé 1852 with body forces (Timoshenko and Goodier, Theory of elasticity, art. 32): the bore of a free ring
        widens by ρ ω² d³/(16 E) ((3 + ν)/Q² + 1 − ν) in diameter, a free shaft by ρ ω² d³/(16 E) (1 − ν + (3 + ν) Q²).

    Valid for: parts of plane stress, each of one density.
    """
    cube = speed**2 * diameter**3 / 16.0
    nu, mu = hub.poisson_ratio, shaft.poisson_ratio
    widened = hub.density / hub.elastic_modulus * ((3.0 + nu) / hub.diameter_ratio**2 + 1.0 - nu)
    thickened = shaft.density / shaft.elastic_modulus * (1.0 - mu + (3.0 + mu) * shaft.diameter_ratio**2)
    return cube * (widened - thickened)


def fit_torque(pressure: float, diameter: float, length: float, *, friction: float) -> float:
    """Return the torque at which a press fit slips [N m].

    Args:
        pressure: p [Pa].
        diameter: Of the joint d [m].
        length: Of the joint l [m].
        friction: μ, 0.14 to 0.2 for steel on steel [-].

    Source: DIN 7190:2001: T = π/2 d² l μ p.
    """
    return math.pi / 2.0 * diameter**2 * length * friction * pressure


def hub_stress(pressure: float, hub: FitPart) -> float:
    """Return Tresca's equivalent stress at the bore of a hub [Pa].

    Args:
        pressure: p [Pa].
        hub: Outer part [Pa, m].

    Source: Lamé 1852: σ_t − σ_r = p (1 + Q²)/(1 − Q²) + p = 2 p/(1 − Q²).
    """
    return 2.0 * pressure / (1.0 - hub.diameter_ratio**2)


def shaft_fit_stress(pressure: float, shaft: FitPart) -> float:
    """Return Tresca's equivalent stress in the shaft of a press fit [Pa].

    Args:
        pressure: p [Pa].
        shaft: Inner part [Pa, m].

    Source: Lamé 1852: p where solid, and at the bore of a hollow shaft |σ_t| = 2 p/(1 − Q²).
    """
    return pressure if shaft.diameter_ratio == 0.0 else 2.0 * pressure / (1.0 - shaft.diameter_ratio**2)
