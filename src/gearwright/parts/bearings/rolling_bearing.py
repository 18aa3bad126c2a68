"""What is inside a rolling bearing: its rolling elements and the curvature of its raceways."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from gearwright.errors import Problem, refuse
from gearwright.units import Angle, Length, Number, Ratio


class BearingKind(StrEnum):
    """Kinds of radial rolling bearings that gearwright rates."""

    DEEP_GROOVE = "deep-groove ball"
    FOUR_POINT = "four-point contact ball"
    CYLINDRICAL = "cylindrical roller"
    TAPER = "taper roller"

    @property
    def is_ball(self) -> bool:
        """True where the rolling elements touch the raceways at points."""
        return self in (BearingKind.DEEP_GROOVE, BearingKind.FOUR_POINT)


@dataclass(frozen=True)
class BearingGeometry:
    """Rolling elements and raceways, as the ratings of ISO 281 and ISO 76 see them."""

    kind: BearingKind
    elements: Number
    """Rolling elements of one row Z [-]."""
    diameter: Length
    """Ball diameter D_w, or mean diameter of the rollers D_we [m]."""
    pitch_diameter: Length
    """D_pw [m]."""
    contact_angle: Angle = 0.0
    """Nominal contact angle α [rad]."""
    roller_length: Length = 0.0
    """Effective length of the rollers L_we [m]; 0 for balls."""
    rows: Number = 1
    """Rows i [-]; a four-point contact bearing counts as two, because its balls work in both directions."""
    inner_conformity: Ratio = 0.52
    """Groove radius of the inner ring over ball diameter r_i/D_w [-]."""
    outer_conformity: Ratio = 0.53
    """Groove radius of the outer ring over ball diameter r_e/D_w [-]."""

    def __post_init__(self) -> None:
        """Refuse what cannot be built."""
        problems = []
        if self.elements < 3:
            problems.append(Problem("elements", f"{self.elements:g} given; a ring needs 3 rolling elements or more"))
        if not 0.0 < self.diameter < self.pitch_diameter:
            message = f"{1e3 * self.diameter:g} mm given; allowed: above 0, below the pitch diameter"
            problems.append(Problem("diameter", message))
        if not self.kind.is_ball and self.roller_length <= 0.0:
            problems.append(Problem("roller_length", f"{1e3 * self.roller_length:g} mm given; rollers need a length"))
        if self.kind is BearingKind.TAPER and not 0.0 < self.contact_angle < math.pi / 4.0:
            message = f"{math.degrees(self.contact_angle):g}° given; a taper bearing has more than 0° and less than 45°"
            problems.append(Problem("contact_angle", message))
        if min(self.inner_conformity, self.outer_conformity) <= 0.5:
            message = (
                f"{min(self.inner_conformity, self.outer_conformity):g} given; a groove is wider than its ball: > 0.5"
            )
            problems.append(Problem("conformity", message))
        refuse(problems)

    @property
    def curvature_ratio(self) -> float:
        """γ = D_w cos α / D_pw [-]."""
        return self.diameter * math.cos(self.contact_angle) / self.pitch_diameter

    @property
    def conformity_ratio(self) -> float:
        """(r_i/r_e) (2 r_e − D_w)/(2 r_i − D_w) [-]."""
        inner, outer = self.inner_conformity, self.outer_conformity
        return inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0)
