"""Two gears in mesh: working pressure angle, backlash, path of contact, contact ratios.

Gear 1 is external and drives; gear 2 is external or internal. Distances along the path of contact are counted from
the pitch point in the direction in which the contact moves: from the driver's root to its tip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from gearwright.errors import Problem, refuse
from gearwright.parts.gears.cylindrical_gear import CylindricalGear, half_angle_at
from gearwright.parts.gears.involute import working_pressure_angle


@dataclass(frozen=True)
class GearPair:
    """A driving external gear and its mate on a centre distance."""

    driver: CylindricalGear
    """Gear 1, external."""
    driven: CylindricalGear
    """Gear 2, external or internal."""
    given_centre_distance: float | None = None
    """Working centre distance [m], positive; None: the one without backlash."""

    def __post_init__(self) -> None:
        problems = _mismatches(self.driver, self.driven)
        distance = self.given_centre_distance
        if not problems and distance is not None and distance <= self.base_centre_distance:
            allowed = f"above {1e3 * self.base_centre_distance:.6g} mm, where the base circles would roll on each other"
            problems.append(Problem("given_centre_distance", f"{1e3 * distance:.6g} mm given; must be {allowed}"))
        refuse(problems)
        _ = self.working_pressure_angle  # profile shifts that fit no centre distance are refused here

    @property
    def side(self) -> int:
        """+1 for an external pair, −1 for an internal one [-]."""
        return self.driven.side

    @cached_property
    def base_centre_distance(self) -> float:
        """Sum (external) or difference (internal) of the base radii, a cos α_t [m]."""
        return self.driven.base_radius + self.side * self.driver.base_radius

    @cached_property
    def working_pressure_angle(self) -> float:
        """Working transverse pressure angle α_wt [rad]."""
        if self.given_centre_distance is not None:
            return math.acos(self.base_centre_distance / self.given_centre_distance)
        return working_pressure_angle(
            self.driver.teeth + self.driven.teeth,
            self.driver.profile_shift + self.driven.profile_shift,
            pressure_angle=self.driver.rack.pressure_angle,
            helix_angle=self.driver.helix_angle,
        )

    @cached_property
    def centre_distance(self) -> float:
        """Working centre distance a_w [m]."""
        return self.base_centre_distance / math.cos(self.working_pressure_angle)

    @property
    def backlash(self) -> float:
        """Transverse circumferential backlash at the working pitch circles j_wt [m]; negative: the teeth jam."""
        cosine = math.cos(self.working_pressure_angle)
        radii = [gear.base_radius / cosine for gear in (self.driver, self.driven)]
        thickness = sum(
            2.0 * half_angle_at(gear, r) * r for gear, r in zip((self.driver, self.driven), radii, strict=True)
        )
        return 2.0 * math.pi * radii[0] / self.driver.teeth - thickness

    @cached_property
    def approach(self) -> float:
        """Length of the path of contact before the pitch point, ended by the driven gear's tip [m].

        An external pair's path never passes the tangent points of the base circles: beyond them there is no involute.
        """
        return _path(self.driven, self.driver, self.working_pressure_angle)

    @cached_property
    def recess(self) -> float:
        """Length of the path of contact after the pitch point, ended by the driver's tip [m]."""
        return _path(self.driver, self.driven, self.working_pressure_angle)

    @property
    def transverse_contact_ratio(self) -> float:
        """Transverse contact ratio ε_α [-] (ISO 21771:2007)."""
        return (self.approach + self.recess) / self.driver.base_pitch

    @property
    def overlap_ratio(self) -> float:
        """Overlap ratio ε_β = b sin β / (π m_n) with the narrower face [-] (ISO 21771:2007)."""
        return self.face_width * math.sin(self.driver.helix_angle) / (math.pi * self.driver.module)

    @property
    def face_width(self) -> float:
        """Common face width b [m]."""
        return min(self.driver.face_width, self.driven.face_width)


def tip_clearances(pair: GearPair) -> tuple[float, float]:
    """Return the room between the tips of each gear and the root of the other, on the line of centres.

    Args:
        pair: The pair.

    Returns:
        Of the driver's tips and of the driven gear's [m]; negative where they run into the root.

    Source: ISO 21771:2007, c = a_w − r_a1 − r_f2, with a_w, r_a2 and r_f2 negative for an internal gear.
    """
    driver, driven, centre = pair.driver, pair.driven, pair.centre_distance
    return (
        pair.side * (centre - driven.root_radius) - driver.tip_radius,
        pair.side * (centre - driven.tip_radius) - driver.root_radius,
    )


def contact_radii(pair: GearPair, distance: float) -> tuple[float, float]:
    """Return the radii at which the two flanks touch at a place of the path of contact.

    Args:
        pair: The pair.
        distance: Distance from the pitch point, positive towards the driver's tip [m].

    Returns:
        Radius on the driver and on the driven gear [m].

    Source: ISO 21771:2007, r_y² = r_b² + ρ_y² with the radii of curvature ρ_1 = r_b1 tan α_wt + s and
        ρ_2 = r_b2 tan α_wt − s (+ s for an internal gear).
    """
    tangent = math.tan(pair.working_pressure_angle)
    driver, driven = pair.driver.base_radius, pair.driven.base_radius
    return (
        math.hypot(driver, driver * tangent + distance),
        math.hypot(driven, driven * tangent - pair.side * distance),
    )


def _path(tip: CylindricalGear, mate: CylindricalGear, angle: float) -> float:
    """Length of the path that the tip of one gear adds beyond the pitch point [m]."""
    reach = math.sqrt(max(tip.tip_radius**2 - tip.base_radius**2, 0.0))
    length = tip.side * (reach - tip.base_radius * math.tan(angle))
    return min(length, mate.base_radius * math.tan(angle)) if mate.side > 0 else length


def _mismatches(driver: CylindricalGear, driven: CylindricalGear) -> list[Problem]:
    """Problems that keep two gears from meshing at all."""
    problems = []
    if driver.side < 0:
        problems.append(Problem("driver", f"{driver.teeth} teeth given; gear 1 must be external, exchange the gears"))
    elif driven.side < 0 and driver.teeth >= -driven.teeth:
        problems.append(Problem("driver", f"{driver.teeth} teeth do not fit inside a ring of {-driven.teeth}"))
    for name, expected, value in (
        ("module", driver.module, driven.module),
        ("helix_angle", driver.helix_angle, driven.helix_angle),
        ("rack.pressure_angle", driver.rack.pressure_angle, driven.rack.pressure_angle),
    ):
        if not math.isclose(expected, value, rel_tol=1e-9):
            message = f"{value:.6g} given, the driver has {expected:.6g}; they must be equal"
            problems.append(Problem(f"driven.{name}", message))
    return problems
