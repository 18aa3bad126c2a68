"""The mean normal section of a bevel pair as annex C of ANSI/AGMA 2003 sees it: radii, path of contact, load sharing.

The geometry factors I and J are both taken from it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from gearwright.errors import Problem, refuse
from gearwright.parts.bevel import BevelPair

SOURCE = "ANSI/AGMA 2003-D19"


@dataclass(frozen=True)
class MeanSection:
    """A bevel pair cut square to its teeth in the middle of the face, with the paths on which they touch."""

    bevel: BevelPair
    """The pair."""
    is_static: bool = False
    """Loaded without running, as in a differential; then no inertia factor is taken."""

    def __post_init__(self) -> None:
        ratio = self.profile_ratio
        refuse(
            [Problem("contact_ratio", f"{ratio:.3f} given; {SOURCE}, eq. C.24 asks straight teeth for more than 1")]
            if self.bevel.spiral_angle == 0.0 and ratio <= 1.0
            else []
        )

    @cached_property
    def mean_scale(self) -> float:
        """m_mt/m_et = R_m/R_e [-]."""
        return self.bevel.mean_cone_distance / self.bevel.outer_cone_distance

    @cached_property
    def transverse_radii(self) -> tuple[float, float]:
        """r_mpt = d_m/(2 cos δ) [m] (eqs C.13, C.14)."""
        pair = self.bevel
        first, second = (
            0.5 * d / math.cos(cone) for d, cone in zip(pair.mean_diameters, pair.pitch_angles, strict=True)
        )
        return first, second

    @cached_property
    def normal_radii(self) -> tuple[float, float]:
        """r_mpn = r_mpt/cos² β_m [m] (eqs C.15, C.16)."""
        square = math.cos(self.bevel.spiral_angle) ** 2
        return self.transverse_radii[0] / square, self.transverse_radii[1] / square

    @cached_property
    def base_radii(self) -> tuple[float, float]:
        """r_mbn = r_mpn cos α_n [m] (eqs C.17, C.18)."""
        cosine = math.cos(self.bevel.pressure_angle)
        return self.normal_radii[0] * cosine, self.normal_radii[1] * cosine

    @cached_property
    def tip_tangents(self) -> tuple[float, float]:
        """√(r_mne² − r_mbn²), from the base circle to the tip along the path of contact [m] (eqs C.19 to C.22)."""
        first, second = (
            math.sqrt((pitch + addendum) ** 2 - base**2)
            for pitch, addendum, base in zip(self.normal_radii, self.bevel.addenda, self.base_radii, strict=True)
        )
        return first, second

    @cached_property
    def addendum_actions(self) -> tuple[float, float]:
        """g_a1 and g_a2, from the pitch point to the tips [m] (eqs C.21, C.22)."""
        sine = math.sin(self.bevel.pressure_angle)
        return self.tip_tangents[0] - self.normal_radii[0] * sine, self.tip_tangents[1] - self.normal_radii[1] * sine

    @cached_property
    def action(self) -> float:
        """Length of action in the normal section g_an [m] (eq. C.23)."""
        return sum(self.addendum_actions)

    @cached_property
    def base_pitch(self) -> float:
        """Mean normal base pitch p_mbn [m] (eq. C.10)."""
        return math.pi * self.bevel.mean_module * math.cos(self.bevel.pressure_angle)

    @cached_property
    def base_cosine(self) -> float:
        """cos β_mb of the mean base spiral angle [-] (eq. C.28)."""
        alpha = self.bevel.pressure_angle
        return math.cos(alpha) * math.hypot(math.cos(self.bevel.spiral_angle), math.tan(alpha))

    @cached_property
    def base_sine(self) -> float:
        """sin β_mb [-]."""
        return math.sqrt(max(1.0 - self.base_cosine**2, 0.0))

    @cached_property
    def profile_ratio(self) -> float:
        """Transverse contact ratio ε_α = g_an/p_2 [-] (eqs C.12, C.24)."""
        alpha = self.bevel.pressure_angle
        pitch = math.pi * self.bevel.mean_module / math.cos(alpha)
        return self.action * (math.cos(self.bevel.spiral_angle) ** 2 + math.tan(alpha) ** 2) / pitch

    @cached_property
    def face_ratio(self) -> float:
        """Face contact ratio ε_β [-]; 0 of straight teeth (eqs C.25, C.26)."""
        part, slope = self.bevel.face_width / self.bevel.outer_cone_distance, math.tan(self.bevel.spiral_angle)
        lean = part * (2.0 - part) / (2.0 * (1.0 - part)) * slope
        return (lean - lean**3 / 3.0) * self.bevel.outer_cone_distance / (math.pi * self.bevel.outer_module)

    @cached_property
    def modified_ratio(self) -> float:
        """Modified contact ratio ε_o = √(ε_α² + ε_β²) [-] (eq. C.27)."""
        return math.hypot(self.profile_ratio, self.face_ratio)

    @cached_property
    def inertia(self) -> float:
        """Inertia factor Z_i = 2/ε_o, at least 1 [-] (eqs C.40, C.105)."""
        return 1.0 if self.is_static else max(2.0 / self.modified_ratio, 1.0)

    @cached_property
    def ellipse(self) -> float:
        """g_η², the square of the length of action within the ellipse of contact [m²] (eq. C.29)."""
        return (self.action * self.base_cosine**2) ** 2 + (self.bevel.face_width * self.base_sine) ** 2

    @cached_property
    def location(self) -> float:
        """Location constant k′, by which the load leaves the middle of the face [-] (eq. C.7)."""
        first, second = self.bevel.teeth
        return (second - first) / (3.2 * second + 4.0 * first)

    def chord(self, place: float) -> float:
        """Return the length of action within the ellipse at a place on it, g_ηI or g_ηJ [m].

        Args:
            place: Distance from the middle, y_I or y_J [m].

        Source: ANSI/AGMA 2003-D19, eqs C.34 and C.50.
        """
        return math.sqrt(max(self.ellipse - 4.0 * place**2, 0.0))

    def sharing(self, place: float) -> float:
        """Return the part of the load that the rated pair of teeth bears, ε_NI or ε_NJ [-].

        Args:
            place: Where it touches, y_I or y_J [m].

        Source: ANSI/AGMA 2003-D19, eqs C.41, C.42, C.103 and C.104: all pairs within the ellipse, each by the cube of
            its length of action.
        """
        own = self.chord(place) ** 3
        return own / (own + self._beyond(place, self.base_pitch) + self._beyond(place, -self.base_pitch))

    def _beyond(self, place: float, step: float) -> float:
        """Cubes of the lengths of action of all pairs on one side of a place, a base pitch apart [m³]."""
        total = 0.0
        while (chord := self.chord(place := place + step)) > 0.0:
            total += chord**3
        return total


def root_between(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function that rises through 0 does so.

    Args:
        function: Of a length, below 0 at the lower end and above 0 at the upper [-].
        low: Lower end [m].
        high: Upper end [m].

    Source: bisection to the last digits.
    """
    while (middle := 0.5 * (low + high)) not in (low, high):
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return high
