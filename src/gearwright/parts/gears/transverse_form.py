"""The outline of one tooth in its transverse section, as its tool leaves it: involute flank and the envelope of a tip.

External teeth are cut by their basic rack, whose rounded tip is an ellipse in the transverse section of a helical gear;
internal ones by a shaper cutter that rolls inside them. Tooth numbers need not be whole, as those of virtual gears.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwright.arrays import Floats, Ints
from gearwright.errors import DesignError, Problem
from gearwright.parts.gears.cylindrical_gear import BasicRack
from gearwright.parts.gears.involute import involute, transverse_pressure_angle

_FINE = 64
"""Points from which the wanted ones are chosen, on the fillet and on the flank [-]."""
SHAPER_SHARE, LEAST_SHAPER, LEAST_GAP = 0.5, 5, 8
"""Teeth of the shaper over those of its ring; its least number, and how many fewer than the ring's it has at least [-]:
an assumption, within what makers of cutters list."""


class TransverseTooth(NamedTuple):
    """What the outline of a tooth follows from."""

    teeth: float
    """z, positive; of a virtual gear not whole [-]."""
    module: float
    """Normal module m_n [m]."""
    helix_angle: float = 0.0
    """β [rad]."""
    profile_shift: float = 0.0
    """x; positive where it thickens the tooth [-]."""
    tip_alteration: float = 0.0
    """k [-]."""
    rack: BasicRack = BasicRack()
    side: int = 1
    """+1 external, −1 internal [-]."""
    shaper: float = 0.0
    """Teeth of the shaper that cuts an internal gear; 0: half as many as it has itself [-]."""

    @property
    def pitch_radius(self) -> float:
        """r [m]."""
        return 0.5 * self.teeth * self.module / math.cos(self.helix_angle)

    @property
    def pressure_angle(self) -> float:
        """α_t [rad]."""
        return transverse_pressure_angle(self.rack.pressure_angle, self.helix_angle)

    @property
    def base_radius(self) -> float:
        """r_b [m]."""
        return self.pitch_radius * math.cos(self.pressure_angle)

    @property
    def tip_radius(self) -> float:
        """r_a [m]."""
        return self.pitch_radius + self.side * (self.rack.addendum + self.profile_shift + self.tip_alteration) * (
            self.module
        )

    @property
    def root_radius(self) -> float:
        """r_f [m]."""
        return self.pitch_radius - self.side * (self.rack.dedendum - self.profile_shift) * self.module

    def half_angles(self, radius: Floats) -> Floats:
        """Return half the angle that a tooth takes between its involutes at radii [rad].

        Args:
            radius: At least the base radius [m], any shape.

        Source: ISO 21771:2007, ψ = (π + 4 x tan α_n)/(2 z) ± (inv α_t − inv α_y).
        """
        angle = np.arccos(np.minimum(1.0, self.base_radius / radius))
        at_pitch = (math.pi + 4.0 * self.profile_shift * math.tan(self.rack.pressure_angle)) / (2.0 * self.teeth)
        return np.asarray(at_pitch + self.side * (involute(self.pressure_angle) - (np.tan(angle) - angle)))


def transverse_form(tooth: TransverseTooth, *, fillet: int, flank: int) -> tuple[Floats, Floats]:
    """Return radii and half angles of one side of a tooth, from its root to its tip.

    Args:
        tooth: The tooth.
        fillet: Points on the fillet, the root's end among them [-].
        flank: Points on the involute, the tip's end among them [-].

    Returns:
        Radii [m] and half angles [rad], shape (fillet + flank,); fewer where the fillet is short.

    Source: law of gearing: the normal of the envelope runs through the pole (Litvin and Fuentes 2004, chapter 6).

    Raises:
        DesignError: A tip that is pointed below its circle, or a rack's tip that is too narrow for its rounding.
    """
    radius, angle = _cut_by_rack(tooth) if tooth.side > 0 else _cut_by_shaper(tooth)
    flanks = np.linspace(radius[-1], tooth.tip_radius, _FINE)
    half = tooth.half_angles(flanks)
    if half[-1] <= 0.0:
        raise DesignError(
            [Problem("profile_shift", "the tooth is pointed below its tip circle; shorten or shift less")]
        )
    low = np.unique(_spread(radius, angle, fillet))
    high = np.linspace(0, _FINE - 1, flank + 1).round().astype(int)[1:]
    return np.concatenate((radius[low], flanks[high])), np.concatenate((angle[low], half[high]))


def outline_area(tooth: TransverseTooth) -> float:
    """Return the area of one tooth between its root and tip circles, with the fillets that its tool leaves [m²].

    Args:
        tooth: The tooth.

    Source: area of a profile, A = ∫ 2 ψ(r) r dr = ∫ ψ d(r²), by trapezia over the points of `transverse_form`.

    >>> tooth = TransverseTooth(10_000, 1e-3)  # nearly a rack: thicker below the pitch line, where there is more of it
    >>> corner = math.radians(35.0)
    >>> rack = 2.25 * math.pi / 2.0 + (1.25**2 - 1.0) * math.tan(math.radians(20.0))
    >>> expected = rack + 2.0 * 0.38**2 * (math.tan(corner) - corner)
    >>> round(1e6 * outline_area(tooth) / expected, 3)
    1.0
    """
    radius, half = transverse_form(tooth, fillet=_FINE, flank=_FINE)
    return abs(float(np.sum(0.5 * (half[1:] + half[:-1]) * np.diff(radius**2))))


def form_radius(tooth: TransverseTooth) -> float:
    """Return where the involute of a tooth begins, beside the fillet that its tool leaves [m].

    Args:
        tooth: The tooth.

    Source: as `transverse_form`.
    """
    return float((_cut_by_rack(tooth) if tooth.side > 0 else _cut_by_shaper(tooth))[0][-1])


def widest_rounding(rack: BasicRack) -> float:
    """Return the fillet radius at which the tip of a rack is fully rounded [-].

    Args:
        rack: The rack.

    Source: half its space at the tip, π/4 − h_f tan α, holds ρ (1 − sin α)/cos α (ISO 53:1998, figure 1).

    >>> round(widest_rounding(BasicRack()), 3)  # of 20° and 1.25: 0.472 modules, ISO 53:1998, 4.6
    0.472
    """
    half = math.pi / 4.0 - rack.dedendum * math.tan(rack.pressure_angle)
    return half * math.cos(rack.pressure_angle) / (1.0 - math.sin(rack.pressure_angle))


def _spread(radius: Floats, angle: Floats, points: int) -> Ints:
    """Return which points of a curve stand evenly along it."""
    along = np.cumsum(np.hypot(np.diff(radius), radius[1:] * np.diff(angle)))
    along = np.concatenate(([0.0], along))
    places = np.linspace(0.0, along[-1], points) - 1e-15
    return np.asarray(np.searchsorted(along, places).clip(0, len(radius) - 1))


def _cut_by_rack(tooth: TransverseTooth) -> tuple[Floats, Floats]:
    """Return the fillet that the rack's tip leaves; of undercut teeth as far as it leaves less than the involute."""
    rack, module, slope = tooth.rack, tooth.module, math.cos(tooth.helix_angle)
    sine = math.sin(rack.pressure_angle)
    flat = math.pi / 4.0 - rack.dedendum * math.tan(rack.pressure_angle)
    flat -= rack.fillet_radius * (1.0 - sine) / math.cos(rack.pressure_angle)
    if flat < 0.0:
        raise DesignError([Problem("rack.fillet_radius", f"the rack's tip is {-2.0 * flat:.3g} modules too narrow")])
    normal = np.linspace(0.5 * math.pi, rack.pressure_angle, _FINE)
    # Of the tip's rounding, in the normal section: beside the middle of the space, and below the pitch line.
    beside = (flat + rack.fillet_radius * np.cos(normal)) * module / slope
    below = (rack.dedendum - tooth.profile_shift - rack.fillet_radius * (1.0 - np.sin(normal))) * module
    reach = (
        below * np.cos(normal) * slope / np.sin(normal)
    )  # where the normal meets the pole, n_t = (cos θ, sin θ/cos β)
    x, y = reach, tooth.pitch_radius - below
    roll = (reach - beside) / tooth.pitch_radius
    radius, angle = np.hypot(x, y), math.pi / tooth.teeth - (np.arctan2(x, y) - roll)
    if below[-1] > tooth.pitch_radius * math.sin(tooth.pressure_angle) ** 2:  # undercut
        kept = (radius < tooth.base_radius) | (angle < tooth.half_angles(np.maximum(radius, tooth.base_radius)))
        radius, angle = radius[kept], angle[kept]
    return radius, angle


def _cut_by_shaper(tooth: TransverseTooth) -> tuple[Floats, Floats]:
    """Return the fillet that a shaper's rounded tip leaves in a ring, whose root circle its tip reaches."""
    teeth = tooth.shaper or SHAPER_SHARE * tooth.teeth
    teeth = max(min(teeth, tooth.teeth - LEAST_GAP), LEAST_SHAPER)
    rack, module = tooth.rack, tooth.module
    cutter = TransverseTooth(teeth, module, tooth.helix_angle, rack=rack)
    distance = tooth.pitch_radius - cutter.pitch_radius  # the ring's shift is the cutter's: no play between them
    cutter = cutter._replace(profile_shift=-tooth.profile_shift)
    reach, rounding = tooth.root_radius - distance, rack.fillet_radius * module
    rounding, middle = _rounding(cutter, reach, rounding)
    ratio = cutter.teeth / tooth.teeth
    # Centre of the rounding at its place in the cutter, turned; the envelope lies beyond it on the line from the pole.
    turn = np.linspace(0.0, math.pi / 3.0, 8 * _FINE)
    centre = distance + (reach - rounding) * np.exp(1j * turn)
    away = centre - tooth.pitch_radius
    touch = centre + rounding * away / np.abs(away)
    angle = np.angle(touch) - ratio * (turn - middle)  # in the ring, from the middle of the space
    radius, half = np.abs(touch), math.pi / tooth.teeth - angle
    whole = radius > max(tooth.base_radius, tooth.tip_radius)
    radius, half = radius[whole], half[whole]
    last = int(np.argmin((half - tooth.half_angles(radius)) * radius))  # where the envelope touches the flank
    return radius[: last + 1], half[: last + 1]


def _rounding(cutter: TransverseTooth, reach: float, rounding: float) -> tuple[float, float]:
    """Return the radius of a cutter's tip rounding and the angle of its centre from the middle of the tooth.

    The rounding touches tip circle and flank; where the tip is too narrow, both roundings of a tooth are one.
    """
    for _ in range(12):
        centre = reach - rounding
        along = math.sqrt(max(centre**2 - cutter.base_radius**2, 0.0))
        # The flank's normal through the centre is a tangent of the base circle: the flank lies `rounding` further on.
        foot = (along + rounding) / cutter.base_radius
        at_base = float(cutter.half_angles(np.asarray(cutter.base_radius)))
        middle = at_base - (foot - math.atan2(along, cutter.base_radius))
        if middle >= 0.0:
            return rounding, middle
        rounding *= 0.8
    return rounding, max(middle, 0.0)
