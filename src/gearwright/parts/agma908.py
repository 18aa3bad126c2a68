"""Geometry factors J for bending and I for pitting of external cylindrical gears by AGMA 908-B89.

Lengths are in normal modules (a normal diametral pitch of 1), angles in rad. All fields may be numbers or arrays.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Annotated

import numpy as np

from gearwright.base import Origin, Quantity
from gearwright.parts.iso6336 import Value, as_value

_SOURCE = "AGMA 908-B89"
_HALVINGS = 60


class LoadPlace(Enum):
    """Where a spur tooth carries its load in bending."""

    SINGLE_CONTACT = "highest point of single tooth contact"
    """Accurate gears: the highest point of single tooth contact."""
    TIP = "tip"
    """Coarse gears, where one pair may carry all up to the tip; helical gears always."""


@dataclass(frozen=True)
class HobbedPair:
    """A pair of hobbed external gears in normal modules."""

    teeth: tuple[Value, Value]
    """n_1, n_2 [-]."""
    pressure_angle: Value = np.pi / 9.0
    """Normal pressure angle φ_n [rad]."""
    helix_angle: Value = 0.0
    """ψ at the standard pitch cylinder [rad]."""
    face_width: Value = 10.0
    """Net face width F over the module [-]; matters for helical gears only."""
    profile_shifts: tuple[Value, Value] = (0.0, 0.0)
    """x_1, x_2 [-]; their sum is zero: standard centre distance."""
    addenda: tuple[Value, Value] = (1.0, 1.0)
    """Addenda without shift over the module [-]."""
    hob_addendum: Value = 1.25
    """h_a0 [-]."""
    hob_radius: Value = 0.25
    """Tip radius of the hob ρ_a0 [-]."""
    thinning: Value = 0.024
    """Tooth thinning for backlash of each gear Δs_n [-]."""

    @cached_property
    def transverse_angle(self) -> Value:
        """φ [rad]."""
        return as_value(np.arctan(np.tan(self.pressure_angle) / np.cos(self.helix_angle)))

    @cached_property
    def base_helix_angle(self) -> Value:
        """ψ_b [rad]."""
        return as_value(np.arcsin(np.sin(self.helix_angle) * np.cos(self.pressure_angle)))

    @cached_property
    def radii(self) -> tuple[Value, Value]:
        """Standard pitch radii R [-]."""
        return 0.5 * self.teeth[0] / np.cos(self.helix_angle), 0.5 * self.teeth[1] / np.cos(self.helix_angle)

    @cached_property
    def outside_reach(self) -> tuple[Value, Value]:
        """√(R_o² − R_b²) of the two gears [-]."""
        first, second = (
            np.sqrt((r + h + x) ** 2 - (r * np.cos(self.transverse_angle)) ** 2)
            for r, h, x in zip(self.radii, self.addenda, self.profile_shifts, strict=True)
        )
        return first, second

    @cached_property
    def line(self) -> Value:
        """C_6, the length between the tangent points of the base circles [-]."""
        return (self.radii[0] + self.radii[1]) * np.sin(self.transverse_angle)

    @cached_property
    def base_pitch(self) -> Value:
        """Transverse base pitch p_b [-]."""
        return np.pi * np.cos(self.transverse_angle) / np.cos(self.helix_angle)

    @cached_property
    def contact_length(self) -> Value:
        """Active length of the line of action Z [-]."""
        return self.outside_reach[0] + self.outside_reach[1] - self.line

    @cached_property
    def axial_ratio(self) -> Value:
        """Axial contact ratio m_F [-]."""
        return self.face_width * np.sin(self.helix_angle) / np.pi

    @cached_property
    def virtual_teeth(self) -> tuple[Value, Value]:
        """n / cos³ ψ in the normal section [-]."""
        cube = np.cos(self.helix_angle) ** 3
        return self.teeth[0] / cube, self.teeth[1] / cube


@dataclass(frozen=True)
class BendingGeometry:
    """J of one gear and what it is made of."""

    height: Annotated[Value, Quantity("number"), Origin("h_F", _SOURCE)]
    """Height of the Lewis parabola h_F [modules]."""
    thickness: Annotated[Value, Quantity("number"), Origin("s_F", _SOURCE)]
    """Tooth thickness at the critical section s_F [modules]."""
    form: Annotated[Value, Quantity("ratio"), Origin("Y", _SOURCE)]
    """Tooth form factor Y [-]."""
    stress_correction: Annotated[Value, Quantity("ratio"), Origin("K_f = H + (s_F/ρ_F)^L (s_F/h_F)^M", _SOURCE)]
    """Stress correction factor K_f (Dolan & Broghamer) [-]."""
    sharing: Annotated[Value, Quantity("ratio"), Origin("m_N = F/L_min", _SOURCE)]
    """Load sharing ratio m_N [-]."""
    factor: Annotated[Value, Quantity("ratio"), Origin("J = Y C_ψ/(K_f m_N)", _SOURCE)]
    """Bending geometry factor J [-]."""


def load_sharing_ratio(pair: HobbedPair) -> Value:
    """Return the load sharing ratio m_N = F/L_min.

    Args:
        pair: The pair.

    Source: AGMA 908-B89, clause 3.4; 1 for spur and for helical gears with m_F ≤ 1.
    """
    profile = pair.contact_length / pair.base_pitch
    width = np.maximum(pair.axial_ratio, 1e-300)
    a, r = np.mod(pair.axial_ratio, 1.0), np.mod(profile, 1.0)
    pitch = pair.face_width / width  # axial pitch p_x
    wasted = np.where(np.asarray(a) <= 1.0 - np.asarray(r), a * r, (1.0 - a) * (1.0 - r))
    shortest = np.maximum((profile * pair.face_width - wasted * pitch) / np.cos(pair.base_helix_angle), 1e-300)
    return as_value(np.where(np.asarray(pair.axial_ratio) > 1.0, pair.face_width / shortest, 1.0))


def helical_overlap_factor(pair: HobbedPair) -> Value:
    """Return the helical overlap factor C_ψ, which joins spur and helical gears between m_F of 0 and 1.

    Args:
        pair: The pair.

    Source: AGMA 908-B89, clause 3.7, √(1 − m_F (1 − ρ_m1 ρ_m2 Z / (ρ_1 ρ_2 p_N))); 1 for m_F > 1.
    """
    low, mean = _curvatures(pair)
    normal = np.pi * np.cos(pair.pressure_angle)
    bridge = mean[0] * mean[1] * pair.contact_length / (low[0] * low[1] * normal)
    factor = np.sqrt(np.maximum(1.0 - pair.axial_ratio * (1.0 - bridge), 0.0))
    return as_value(np.where(np.asarray(pair.axial_ratio) > 1.0, 1.0, factor))


def _curvatures(pair: HobbedPair) -> tuple[tuple[Value, Value], tuple[Value, Value]]:
    """Curvatures of the flanks at the lowest point of single contact of the pinion, and at the mean point."""
    low = pair.outside_reach[0] - pair.base_pitch
    base = pair.radii[0] * np.cos(pair.transverse_angle)
    outside = np.hypot(pair.outside_reach[0], base)
    inside = sum(pair.radii) - np.hypot(pair.outside_reach[1], pair.radii[1] * np.cos(pair.transverse_angle))
    mean = np.sqrt((0.5 * (outside + inside)) ** 2 - base**2)
    return (low, pair.line - low), (mean, pair.line - mean)


def pitting_geometry_factor(pair: HobbedPair) -> Value:
    """Return the pitting geometry factor I.

    Args:
        pair: The pair, pinion first.

    Returns:
        I [-].

    Source: AGMA 908-B89, clause 4, I = cos φ_r C_ψ² / ((1/ρ_1 + 1/ρ_2) d m_N); at the lowest point of single tooth
        contact for spur and m_F ≤ 1, at the mean point for m_F > 1.
    Valid for: external gears on the standard centre distance.

    >>> round(float(pitting_geometry_factor(HobbedPair((21, 55)))), 3)
    0.102
    """
    low, mean = _curvatures(pair)
    helical = np.asarray(pair.axial_ratio) > 1.0
    first, second = (np.where(helical, m, s) for m, s in zip(mean, low, strict=True))
    overlap = helical_overlap_factor(pair)
    diameter = 2.0 * pair.radii[0]
    curvature = 1.0 / first + 1.0 / second
    return as_value(np.cos(pair.transverse_angle) * overlap**2 / (curvature * diameter * load_sharing_ratio(pair)))


def bending_geometry(pair: HobbedPair, gear: int, place: LoadPlace = LoadPlace.SINGLE_CONTACT) -> BendingGeometry:
    """Return the bending geometry factor J of one gear with its parts.

    Args:
        pair: The pair.
        gear: 0 for the pinion, 1 for the gear.
        place: Where a spur tooth is loaded; helical gears with m_F > 1 are loaded at the tip.

    Source: AGMA 908-B89, clauses 5 and 6: the Lewis parabola that touches the fillet, K_f of Dolan & Broghamer.
    Valid for: external gears whose parabola touches the fillet; beyond, the end of the fillet is taken.

    >>> round(float(bending_geometry(HobbedPair((21, 55)), 0).factor), 2)
    0.34
    """
    teeth = pair.virtual_teeth[gear]
    shift = pair.profile_shifts[gear] - 0.5 * pair.thinning / np.tan(pair.pressure_angle)
    angle, vertex = _load_line(pair, gear, shift, place=place)
    height, half = _critical_point(pair, teeth, shift, vertex=vertex)
    thickness = 2.0 * half
    form = _form_factor(pair, angle, height=height, thickness=thickness)
    depth = pair.hob_addendum - pair.hob_radius - shift
    fillet = pair.hob_radius + depth**2 / (0.5 * teeth + depth)
    correction = stress_correction(pair.pressure_angle, thickness / fillet, thickness / height)
    sharing = load_sharing_ratio(pair)
    factor = form * helical_overlap_factor(pair) / (correction * sharing)
    return BendingGeometry(height, thickness, form, correction, sharing, factor)


def stress_correction(pressure_angle: Value, over_fillet: Value, over_height: Value) -> Value:
    """Return the stress correction factor K_f of a tooth fillet.

    Args:
        pressure_angle: φ_n [rad].
        over_fillet: s_F/ρ_F [-].
        over_height: s_F/h_F [-].

    Source: AGMA 908-B89, clause 5.10, after Dolan & Broghamer 1942: H + (s_F/ρ_F)^L (s_F/h_F)^M with
        H = 0.331 − 0.436 φ_n, L = 0.324 − 0.492 φ_n, M = 0.261 + 0.545 φ_n.
    """
    h, length, m = 0.331 - 0.436 * pressure_angle, 0.324 - 0.492 * pressure_angle, 0.261 + 0.545 * pressure_angle
    return as_value(h + over_fillet**length * over_height**m)


def _load_line(pair: HobbedPair, gear: int, shift: Value, *, place: LoadPlace) -> tuple[Value, Value]:
    """Load angle φ_nL and the radius at which the line of action crosses the tooth's centre line."""
    teeth = pair.virtual_teeth[gear]
    pitch = [0.5 * tooth for tooth in pair.virtual_teeth]
    base = [radius * np.cos(pair.pressure_angle) for radius in pitch]
    tips = [r + h + x for r, h, x in zip(pitch, pair.addenda, pair.profile_shifts, strict=True)]
    reach = [np.sqrt(tip**2 - radius**2) for tip, radius in zip(tips, base, strict=True)]
    line = sum(pitch) * np.sin(pair.pressure_angle)
    single = line - reach[1 - gear] + np.pi * np.cos(pair.pressure_angle)
    at_tip = (np.asarray(pair.axial_ratio) > 1.0) | (place is LoadPlace.TIP)
    tangent = np.where(at_tip, reach[gear], single) / base[gear]
    thickness = 0.5 * np.pi + 2.0 * shift * np.tan(pair.pressure_angle)
    angle = tangent - (np.tan(pair.pressure_angle) - pair.pressure_angle + thickness / teeth)
    return as_value(angle), as_value(base[gear] / np.cos(angle))


def _fillet(pair: HobbedPair, teeth: Value, shift: Value, *, normal: Value) -> tuple[Value, Value, Value]:
    """Height above the centre, half thickness and inclination to the centre line of a point of the fillet."""
    drop = pair.hob_radius - pair.hob_addendum + shift
    alpha = pair.pressure_angle
    corner = np.pi / 4.0 - pair.hob_addendum * np.tan(alpha)
    corner = corner - (1.0 - np.sin(alpha)) * pair.hob_radius / np.cos(alpha)
    turned = 2.0 / teeth * (0.5 * np.pi - corner - drop * np.tan(normal))
    inclination = 0.5 * np.pi - normal - turned
    offset = drop / np.cos(normal) - pair.hob_radius
    height = 0.5 * teeth * np.cos(turned) + np.sin(inclination) * offset
    return height, 0.5 * teeth * np.sin(turned) + np.cos(inclination) * offset, inclination


def _critical_point(pair: HobbedPair, teeth: Value, shift: Value, *, vertex: Value) -> tuple[Value, Value]:
    """Height of the vertex over the point where the parabola touches the fillet, and the half thickness there."""
    low = np.zeros_like(np.asarray(vertex, dtype=float))
    high = low + 0.5 * np.pi - pair.pressure_angle
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        height, half, inclination = _fillet(pair, teeth, shift, normal=middle)
        steep = np.tan(inclination) > half / (2.0 * (vertex - height))
        low, high = np.where(steep, middle, low), np.where(steep, high, middle)
    height, half, _ = _fillet(pair, teeth, shift, normal=0.5 * (low + high))
    return vertex - height, half


def _form_factor(pair: HobbedPair, angle: Value, *, height: Value, thickness: Value) -> Value:
    """Y = K_ψ / (cos φ_nL/cos φ_nr (6 h_F/(s_F² C_h) − tan φ_nL/s_F))."""
    omega = np.degrees(np.arctan(np.tan(pair.helix_angle) * np.sin(pair.pressure_angle))) / 100.0
    helical = np.asarray(pair.axial_ratio) > 1.0
    line_factor = np.where(helical, 1.0 / (1.0 - np.sqrt(omega * (1.0 - omega))), 1.0)
    helix = np.where(helical, np.cos(pair.helix_angle) ** 2, 1.0)
    bracket = 6.0 * height / (thickness**2 * line_factor) - np.tan(angle) / thickness
    return as_value(helix / (np.cos(angle) / np.cos(pair.pressure_angle) * bracket))
