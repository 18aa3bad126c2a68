"""A cylindrical gear as its drawing states it, and the radii and thicknesses that follow.

An internal gear has a negative number of teeth (ISO 21771); all radii are positive here, and a positive profile shift
makes the tooth of either kind thicker at the reference circle.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from gearwright.errors import Problem, refuse
from gearwright.parts.gears.involute import base_helix_angle, involute, least_profile_shift, transverse_pressure_angle


@dataclass(frozen=True)
class BasicRack:
    """The straight-sided rack that defines a tooth; lengths in normal modules."""

    pressure_angle: float = math.radians(20.0)
    """Normal pressure angle α_n [rad]."""
    addendum: float = 1.0
    """Addendum h_aP* [-]."""
    dedendum: float = 1.25
    """Dedendum h_fP* [-]."""
    fillet_radius: float = 0.38
    """Radius of the root fillet ρ_fP* [-]."""

    @property
    def straight_dedendum(self) -> float:
        """Straight part of the flank below the reference line, h_fP* − ρ_fP* (1 − sin α_n) [-]."""
        return self.dedendum - self.fillet_radius * (1.0 - math.sin(self.pressure_angle))


ISO53_A = BasicRack()
"""ISO 53:1998 profile A: general, for high torques."""
ISO53_D = BasicRack(dedendum=1.40, fillet_radius=0.39)
"""ISO 53:1998 profile D: fully rounded root, for ground or shaved high-precision gears."""


@dataclass(frozen=True)
class CylindricalGear:
    """One external or internal gear with its basic rack."""

    teeth: int
    """Number of teeth z [-]; negative for an internal gear."""
    module: float
    """Normal module m_n [m]."""
    face_width: float
    """Face width b [m]."""
    helix_angle: float = 0.0
    """Helix angle at the reference cylinder β [rad], absolute value."""
    profile_shift: float = 0.0
    """Profile shift coefficient x [-]."""
    rack: BasicRack = ISO53_A
    """Basic rack."""
    tip_alteration: float = 0.0
    """Tip alteration coefficient k [-]; negative shortens the tooth."""

    def __post_init__(self) -> None:
        limits = (
            ("teeth", self.teeth, "at least 5, or at most −5 for an internal gear", abs(self.teeth) >= 5),
            ("module", self.module, "above 0 m", 0.0 < self.module < math.inf),
            ("face_width", self.face_width, "above 0 m", 0.0 < self.face_width < math.inf),
            ("helix_angle", self.helix_angle, "from 0 to below π/3 rad", 0.0 <= self.helix_angle < math.pi / 3.0),
            ("profile_shift", self.profile_shift, "between −2 and 2", abs(self.profile_shift) <= 2.0),
        )
        if not all(good for *_, good in limits):
            wrong = [(name, value, allowed) for name, value, allowed, good in limits if not good]
            refuse(Problem(name, f"{value:.6g} given; must be {allowed}") for name, value, allowed in wrong)

    @property
    def side(self) -> int:
        """+1 for external teeth, −1 for internal ones [-]."""
        return 1 if self.teeth > 0 else -1

    @cached_property
    def transverse_pressure_angle(self) -> float:
        """Transverse pressure angle α_t [rad]."""
        return transverse_pressure_angle(self.rack.pressure_angle, self.helix_angle)

    @cached_property
    def base_helix_angle(self) -> float:
        """Helix angle at the base cylinder β_b [rad]."""
        return base_helix_angle(self.rack.pressure_angle, self.helix_angle)

    @cached_property
    def transverse_module(self) -> float:
        """Transverse module m_t [m]."""
        return self.module / math.cos(self.helix_angle)

    @cached_property
    def pitch_radius(self) -> float:
        """Reference radius r [m]."""
        return 0.5 * abs(self.teeth) * self.transverse_module

    @cached_property
    def base_radius(self) -> float:
        """Base radius r_b [m]."""
        return self.pitch_radius * math.cos(self.transverse_pressure_angle)

    @property
    def base_pitch(self) -> float:
        """Transverse base pitch p_bt [m]."""
        return math.pi * self.transverse_module * math.cos(self.transverse_pressure_angle)

    @cached_property
    def tip_radius(self) -> float:
        """Tip radius r_a [m]."""
        height = self.rack.addendum + self.profile_shift + self.tip_alteration
        return self.pitch_radius + self.side * height * self.module

    @property
    def root_radius(self) -> float:
        """Root radius r_f [m]."""
        return self.pitch_radius - self.side * (self.rack.dedendum - self.profile_shift) * self.module

    @property
    def undercut_shift(self) -> float:
        """Least profile shift of an external gear without undercut x_min [-]; −∞ for an internal one."""
        if self.side < 0:
            return -math.inf
        return least_profile_shift(
            self.teeth,
            self.rack.straight_dedendum,
            pressure_angle=self.rack.pressure_angle,
            helix_angle=self.helix_angle,
        )


def pressure_angle_at(gear: CylindricalGear, radius: float) -> float:
    """Return the transverse pressure angle of the flank at a radius.

    Args:
        gear: The gear.
        radius: At least the base radius [m].

    Source: ISO 21771:2007, cos α_y = r_b / r_y.
    """
    return math.acos(min(1.0, gear.base_radius / radius))


def half_angle_at(gear: CylindricalGear, radius: float) -> float:
    """Return half the angle that a tooth takes at a radius, without backlash allowance.

    Args:
        gear: The gear.
        radius: At least the base radius [m].

    Returns:
        ψ_y [rad]; the transverse tooth thickness is 2 ψ_y r_y.

    Source: ISO 21771:2007, ψ_y = (π + 4 x tan α_n)/(2 z) + inv α_t − inv α_y; opposite signs for internal teeth.
    """
    at_pitch = (math.pi + 4.0 * gear.profile_shift * math.tan(gear.rack.pressure_angle)) / (2.0 * abs(gear.teeth))
    return at_pitch + gear.side * (involute(gear.transverse_pressure_angle) - involute(pressure_angle_at(gear, radius)))


def tip_thickness(gear: CylindricalGear) -> float:
    """Return the transverse tooth thickness at the tip circle.

    Args:
        gear: The gear.

    Returns:
        s_a [m]; not positive means a pointed tooth.

    Source: ISO 21771:2007, s_a = 2 ψ_a r_a.

    >>> round(1e3 * tip_thickness(CylindricalGear(20, 1e-3, 0.01)), 3)
    0.695
    """
    return 2.0 * half_angle_at(gear, gear.tip_radius) * gear.tip_radius
