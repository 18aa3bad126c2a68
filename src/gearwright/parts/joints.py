"""Shaft-hub joints: parallel keys, involute splines and interference fits.

The notches that they make in the shaft are in `shafts`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.errors import DesignError, Problem
from gearwright.units import Density, Length, Ratio, Stress

# ----------------------------------------------------------------------------------------------------------------------
# Parallel keys: pressure on their flanks by DIN 6892, and shear and bearing by Shigley.
# ----------------------------------------------------------------------------------------------------------------------


TWO_KEYS_SHARE = 0.75
"""φ: what each of two keys bears, because they do not fit alike [-] (DIN 6892:2012, method C)."""
LONGEST_BEARING = 1.3
"""l_tr/d beyond which more length does not bear more [-] (DIN 6892:2012)."""


@dataclass(frozen=True)
class KeySection:
    """Section of a parallel key and of its keyways."""

    width: Length
    """b [m]."""
    height: Length
    """h [m]."""
    shaft_depth: Length
    """t_1, depth of the keyway in the shaft [m]."""
    hub_depth: Length
    """t_2, depth of the keyway in the hub [m]."""


def bearing_length(section: KeySection, length: float, hub_length: float) -> float:
    """Return the length of a key with round ends that bears on its flanks l_tr [m].

    Args:
        section: Of the key [m].
        length: l, with the round ends [m].
        hub_length: [m].

    Source: DIN 6892:2012, form A: l_tr = l − b.

    Raises:
        DesignError: If the key is longer than its hub, or all round ends.
    """
    if length > hub_length:
        message = f"{1e3 * length:g} mm is longer than its hub; allowed: up to {1e3 * hub_length:g} mm"
        raise DesignError([Problem("key.length", message)])
    if length <= section.width:
        message = f"{1e3 * length:g} mm leaves no flat flank; allowed: above {1e3 * section.width:g} mm"
        raise DesignError([Problem("key.length", message)])
    return length - section.width


def key_pressure(torque: float, diameter: float, section: KeySection, *, bearing_length: float, keys: int = 1) -> float:
    """Return the mean pressure on the flank of a key in the hub [Pa].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        bearing_length: l_tr [m].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C: p = 2 T / (d (h − t_1) l_tr i φ), φ = 1 for one key and 0.75 for two.

    Valid for: one or two keys.

    Raises:
        DesignError: If there are neither one nor two keys.

    >>> section = KeySection(14e-3, 9e-3, 5.5e-3, 3.8e-3)
    >>> round(key_pressure(500.0, 0.05, section, bearing_length=0.056) / 1e6, 2)
    102.04
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * bearing_length * _effective(keys))


def key_length(torque: float, diameter: float, section: KeySection, *, allowable: float, keys: int = 1) -> float:
    """Return the bearing length l_tr that a torque asks for [m].

    Args:
        torque: T [N m].
        diameter: d of the shaft [m].
        section: Of the key [m].
        allowable: Pressure that the weakest of shaft, hub and key bears, about 0.9 R_e over safety [Pa].
        keys: One, or two opposite ones [-].

    Source: DIN 6892:2012, method C solved for l_tr; useful up to 1.3 d.

    Raises:
        DesignError: If there are neither one nor two keys.
    """
    return 2.0 * torque / (diameter * _bearing_height(section) * allowable * _effective(keys))


def _bearing_height(section: KeySection) -> float:
    return section.height - section.shaft_depth


def _effective(keys: int) -> float:
    if keys not in (1, 2):
        raise DesignError([Problem("key.count", f"{keys} given; allowed: 1 or 2; use a spline for more torque")])
    return 1.0 if keys == 1 else 2.0 * TWO_KEYS_SHARE


# ----------------------------------------------------------------------------------------------------------------------
# Involute splines of DIN 5480: teeth for a shaft, diameters, and the length that a torque asks for.
# ----------------------------------------------------------------------------------------------------------------------


MODULES = (
    0.5e-3,
    0.6e-3,
    0.75e-3,
    0.8e-3,
    1e-3,
    1.25e-3,
    1.5e-3,
    1.75e-3,
    2e-3,
    2.5e-3,
    3e-3,
    4e-3,
    5e-3,
    6e-3,
    8e-3,
    10e-3,
)
"""Modules of the standard [m] (DIN 5480-1:2006)."""
BEARING_SHARE = 0.75
"""Share of the teeth that bear in a first sizing [-] (usual for flank centred splines of grade 8)."""
SHORTEST_RATIO = 0.6
"""l/d_B below which a hub rocks on its shaft [-] (usual for gears without another seat)."""
HOBBED = 0.60
"""Dedendum h_fP of a hobbed shaft over its module [-]; broached 0.55, shaped 0.65, cold rolled 0.84 (DIN 5480-1:2006,
basic rack profile)."""
ROOT_DEPTH = 1.1 + 2.0 * HOBBED
"""(d_B − d_f1)/m of a hobbed shaft [-]: d_f1 = m z + 2 x m − 2 h_fP with m z + 2 x m = d_B − 1.1 m."""
_SHIFT = (-0.05, 0.45)
"""Range of the profile shift x of shafts [-] (DIN 5480-1:2006)."""


class Spline(NamedTuple):
    """A shaft-hub joint with involute teeth of 30°."""

    reference_diameter: float
    """d_B [m]."""
    module: float
    """m [m]."""
    teeth: int
    """z [-]."""
    profile_shift: float
    """x of the shaft [-]; that of the hub is −x."""

    @property
    def pitch_diameter(self) -> float:
        """D = m z [m]."""
        return self.module * self.teeth

    @property
    def shaft_tip(self) -> float:
        """Tip diameter of the shaft d_a1 = d_B − 0.2 m [m]."""
        return self.reference_diameter - 0.2 * self.module

    @property
    def hub_tip(self) -> float:
        """Tip diameter of the hub d_a2 = d_B − 2 m [m]."""
        return self.reference_diameter - 2.0 * self.module

    @property
    def shaft_root(self) -> float:
        """Root diameter of the hobbed shaft d_f1 = d_B − 2.3 m [m]; DIN 5480-2 lists d_B − 2.2 m, the largest."""
        return self.reference_diameter - ROOT_DEPTH * self.module


def spline(reference_diameter: float, module: float) -> Spline:
    """Return the teeth of DIN 5480 on a shaft.

    Of two numbers of teeth with an allowed shift the even one is taken, as the standard does.

    Args:
        reference_diameter: d_B, that of the bearing or shaft [m].
        module: m [m].

    Source: DIN 5480-1:2006: d_B = m (z + 2 x + 1.1) with −0.05 ≤ x ≤ 0.45.

    Raises:
        DesignError: If the module is not standard or too few teeth fit.

    >>> spline(0.120, 0.003).teeth
    38
    """
    if not any(math.isclose(module, standard) for standard in MODULES):
        closest = min(MODULES, key=lambda standard: abs(standard - module))
        message = f"{1e3 * module:g} mm is not a module of DIN 5480; the nearest is {1e3 * closest:g} mm"
        raise DesignError([Problem("spline.module", message)])
    room = reference_diameter / module - 1.1
    fewest, most = math.ceil(room - 2.0 * _SHIFT[1] - 1e-9), math.floor(room - 2.0 * _SHIFT[0] + 1e-9)
    teeth = next((z for z in range(fewest, most + 1) if z % 2 == 0), fewest)
    if teeth < 6:
        message = f"{1e3 * reference_diameter:g} mm has room for {teeth} teeth of {1e3 * module:g} mm; 6 are needed"
        raise DesignError([Problem("spline.reference_diameter", message)])
    return Spline(reference_diameter, module, teeth, (room - teeth) / 2.0)


def spline_pressure(torque: float, joint: Spline, length: float, *, share: float = BEARING_SHARE) -> float:
    """Return the mean pressure on the flanks of a spline [Pa].

    Args:
        torque: T [N m].
        joint: Teeth [m].
        length: Bearing length l [m].
        share: Of the teeth that bear k [-].

    Source: first sizing as in Roloff/Matek, Maschinenelemente, with DIN 5480 heights: p = 2 T/(d_m h l z k),
        h = (d_a1 − d_a2)/2 = 0.9 m, d_m = (d_a1 + d_a2)/2 = d_B − 1.1 m.
    """
    return spline_length(torque, joint, share=share, allowable=1.0) / length


def spline_length(torque: float, joint: Spline, *, allowable: float, share: float = BEARING_SHARE) -> float:
    """Return the bearing length that a torque asks for [m]; 0.6 d_B at least keeps the hub from rocking.

    Args:
        torque: T [N m].
        joint: Teeth [m].
        allowable: Pressure on the flanks [Pa].
        share: Of the teeth that bear k [-].

    Source: as `spline_pressure`, solved for l.
    """
    height = (joint.shaft_tip - joint.hub_tip) / 2.0
    middle = (joint.shaft_tip + joint.hub_tip) / 2.0
    return 2.0 * torque / (middle * height * joint.teeth * share * allowable)


# ----------------------------------------------------------------------------------------------------------------------
# Press fits by Lamé and DIN 7190: pressure from interference, torque by friction, stress in hub and shaft.
# ----------------------------------------------------------------------------------------------------------------------


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
