"""The virtual cylindrical gears of a bevel pair by ISO 10300-1:2023, annex A, method B1, without hypoid offset."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

from gearwright.parts.bevel.geometry import BevelPair
from gearwright.parts.gears import transverse_pressure_angle
from gearwright.parts.iso6336 import MeshGeometry

EFFECTIVE_WIDTH = 0.85
"""Part of the face that bears under load, b_2,eff/b [-] (ISO 10300-1:2023, annex A.2.4)."""
HIGH_CROWNING, LOW_CROWNING = 1.5, 3.0
"""Exponent e_LS of the load over the zone for high and low profile crowning [-] (ISO 10300-2:2023, table 5)."""


@dataclass(frozen=True)
class ContactLine:
    """One line of contact in the zone of action."""

    distance: float
    """Distance from the middle of the zone f [m]."""
    length: float
    """Length l_b [m]."""
    peak: float
    """Load relative to the middle of the zone p* [-]."""


@dataclass(frozen=True)
class VirtualPair:
    """The pair of cylindrical gears that stands for a bevel pair at its mean cone."""

    bevel: BevelPair
    """The bevel pair."""
    peak_exponent: float = HIGH_CROWNING
    """Exponent e_LS of the load over the zone [-]."""

    @cached_property
    def diameters(self) -> tuple[float, float]:
        """Reference diameters d_v = d_m/cos δ [m] (eq. A.1)."""
        first, second = (
            d / math.cos(angle) for d, angle in zip(self.bevel.mean_diameters, self.bevel.pitch_angles, strict=True)
        )
        return first, second

    @cached_property
    def transverse_angle(self) -> float:
        """α_vet [rad] (eq. A.10)."""
        return transverse_pressure_angle(self.bevel.pressure_angle, self.bevel.spiral_angle)

    @cached_property
    def base_helix_angle(self) -> float:
        """β_vb [rad] (eq. A.16)."""
        return math.asin(math.sin(self.bevel.spiral_angle) * math.cos(self.bevel.pressure_angle))

    @cached_property
    def base_diameters(self) -> tuple[float, float]:
        """d_vb [m] (eq. A.9)."""
        cosine = math.cos(self.transverse_angle)
        return self.diameters[0] * cosine, self.diameters[1] * cosine

    @cached_property
    def tip_diameters(self) -> tuple[float, float]:
        """d_va = d_v + 2 h_am [m] (eq. A.6)."""
        return self.diameters[0] + 2.0 * self.bevel.addenda[0], self.diameters[1] + 2.0 * self.bevel.addenda[1]

    @cached_property
    def teeth(self) -> tuple[float, float]:
        """z_v = z/cos δ [-] (eqs A.14, A.15)."""
        angles = self.bevel.pitch_angles
        return self.bevel.teeth[0] / math.cos(angles[0]), self.bevel.teeth[1] / math.cos(angles[1])

    @cached_property
    def normal_teeth(self) -> tuple[float, float]:
        """z_vn = z_v/(cos² β_vb cos β_v) [-] (eqs A.41, A.42)."""
        cosine = math.cos(self.base_helix_angle) ** 2 * math.cos(self.bevel.spiral_angle)
        return self.teeth[0] / cosine, self.teeth[1] / cosine

    @cached_property
    def base_pitch(self) -> float:
        """p_vet [m] (eq. A.17)."""
        return math.pi * self.bevel.mean_module * math.cos(self.transverse_angle) / math.cos(self.bevel.spiral_angle)

    @cached_property
    def path(self) -> float:
        """Length of the path of contact g_vα [m] (eq. A.18)."""
        sine = math.sin(self.transverse_angle)
        return sum(
            0.5 * (math.sqrt(tip**2 - base**2) - pitch * sine)
            for tip, base, pitch in zip(self.tip_diameters, self.base_diameters, self.diameters, strict=True)
        )

    @cached_property
    def effective_width(self) -> float:
        """b_v,eff [m] (eq. A.19 without offset)."""
        return EFFECTIVE_WIDTH * self.bevel.face_width

    @cached_property
    def profile_ratio(self) -> float:
        """ε_vα [-] (eq. A.23)."""
        return self.path / self.base_pitch

    @cached_property
    def face_ratio(self) -> float:
        """ε_vβ [-] (eq. A.24)."""
        return self.effective_width * math.sin(self.bevel.spiral_angle) / (math.pi * self.bevel.mean_module)

    @cached_property
    def total_ratio(self) -> float:
        """ε_vγ = ε_vα + ε_vβ [-] (eq. A.25)."""
        return self.profile_ratio + self.face_ratio

    @cached_property
    def curvature(self) -> float:
        """Radius of relative curvature normal to the contact line ρ_rel [m] (eqs A.37 to A.39)."""
        pair = self.bevel
        cones = sum(1.0 / (pair.mean_cone_distance * math.tan(angle)) for angle in pair.pitch_angles)
        normal = math.sin(pair.pressure_angle) / (math.cos(pair.spiral_angle) ** 2 * cones)
        return normal * math.cos(math.atan(math.tan(pair.spiral_angle) * math.sin(pair.pressure_angle))) ** 2

    @cached_property
    def lines(self) -> tuple[ContactLine, ContactLine, ContactLine]:
        """Contact lines at the tip, in the middle and at the root (table A.2, eqs A.26 to A.36)."""
        step = self.base_pitch * math.cos(self.base_helix_angle)
        middle = -step * (1.0 - 0.5 * self.profile_ratio) * (1.0 - self.face_ratio) if self.face_ratio < 1.0 else 0.0
        return self._line(middle + step), self._line(middle), self._line(middle - step)

    @cached_property
    def furthest(self) -> float:
        """Distance from the middle of the zone beyond which no line bears f_max [m]."""
        helix = self.base_helix_angle
        return 0.5 * (self.path + self.effective_width * math.tan(helix)) * math.cos(helix)

    def load_share(self, place: float) -> float:
        """Return the line load at a point of the path over that of one line across the face that bears all [-].

        Args:
            place: Distance of the point from the middle of the path of contact, along it, at mid-face [m].

        Source: ISO 10300-1:2023, annex A: lines one base pitch apart share the load as A* ~ p* l_b, p* = 1 −
            |f/f_max|^e_LS, which is p* (b_v,eff/cos β_vb)/Σ(p* l_b) or 1/ε_vα where all lines bear alike; along a line
            it fades as half an ellipse, whose peak over its mean is left to K_Hβ.
        """
        step = self.base_pitch * math.cos(self.base_helix_angle)
        here = place * math.cos(self.base_helix_angle)
        count = math.ceil(2.0 * self.furthest / step)
        lines = [self._line(here + number * step) for number in range(-count, count + 1)]
        borne = sum(line.peak * line.length for line in lines)
        start, end = self._ends(here)
        beside = min(abs(self.effective_width - start - end) / max(end - start, 1e-12 * self.effective_width), 1.0)
        across = self.effective_width / math.cos(self.base_helix_angle)
        return lines[count].peak * math.sqrt(1.0 - beside**2) * across / borne

    def _ends(self, distance: float) -> tuple[float, float]:
        """Ends of a contact line along the face [m]; those of a line out of the zone are one place."""
        helix, width = self.base_helix_angle, self.effective_width
        if helix <= 1e-9:
            return 0.0, width
        centre = 0.5 * width + distance / math.sin(helix)
        reach = 0.5 * self.path / math.tan(helix)
        start = max(centre - reach, 0.0)
        return start, max(min(centre + reach, width), start)

    def _line(self, distance: float) -> ContactLine:
        """One contact line, clipped at the edges of the zone of action."""
        part = min(abs(distance) / self.furthest, 1.0)
        start, end = self._ends(distance)
        length = (end - start) / math.cos(self.base_helix_angle)
        shortened = (1.0 - math.sqrt(EFFECTIVE_WIDTH)) * math.sqrt(1.0 - part**2)
        return ContactLine(distance, length * (1.0 - shortened), 1.0 - part**self.peak_exponent)

    @cached_property
    def load_sharing(self) -> float:
        """Z_LS = √(A*_m/(A*_t + A*_m + A*_r)) [-] (ISO 10300-2:2023, eqs 7 to 10)."""
        areas = [line.peak * line.length for line in self.lines]
        return math.sqrt(areas[1] / sum(areas))


def virtual_mesh(virtual: VirtualPair) -> MeshGeometry:
    """Return the virtual cylindrical gears as methods for cylindrical gears take them, with the part that bears.

    Args:
        virtual: The virtual pair.

    Source: ISO 10300-1:2023, annex A: z_v, d_va and a_v = (d_v1 + d_v2)/2; face 0.85 b.
    """
    first, second = virtual.tip_diameters
    return MeshGeometry(
        virtual.teeth,
        virtual.bevel.mean_module,
        virtual.effective_width,
        0.5 * sum(virtual.diameters),
        (0.5 * first, 0.5 * second),
        helix_angle=virtual.bevel.spiral_angle,
        pressure_angle=virtual.bevel.pressure_angle,
    )
