"""The blank of a bevel gear without offset by ISO 23509: tip and root cones, depths, spiral angles along the face."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from gearwright.errors import DesignError, Problem
from gearwright.parts.bevel.geometry import BevelPair
from gearwright.units import Origin, Quantity

_SOURCE = "ISO 23509:2016"
_REACH = 1.001
"""How much larger than the least a cutter must be to end within the face [-]."""
Both = tuple[float, float]
"""Of pinion and wheel."""


@dataclass(frozen=True)
class BevelBlank:
    """Cones, depths and diameters of both gears of a pair."""

    root_angle_below: Annotated[Both, Quantity("angle"), Origin("θ_f", f"{_SOURCE}, annex C.5")]
    """Dedendum angles θ_f1, θ_f2 [rad]."""
    tip_angle: Annotated[Both, Quantity("angle"), Origin("δ_a = δ + θ_a, θ_a of the mate's θ_f", f"{_SOURCE}, eq. 140")]
    """Face angles δ_a1, δ_a2 [rad]."""
    root_angle: Annotated[Both, Quantity("angle"), Origin("δ_f = δ − θ_f", f"{_SOURCE}, eq. 141")]
    """Root angles δ_f1, δ_f2 [rad]."""
    outer_addendum: Annotated[Both, Quantity("length"), Origin("h_ae = h_am + b tan θ_a/2", f"{_SOURCE}, 7.7")]
    """At the outer end h_ae [m]."""
    outer_dedendum: Annotated[Both, Quantity("length"), Origin("h_fe = h_fm + b tan θ_f/2", f"{_SOURCE}, 7.7")]
    """At the outer end h_fe [m]."""
    outer_tip_diameter: Annotated[Both, Quantity("length"), Origin("d_ae = d_e + 2 h_ae cos δ", f"{_SOURCE}, 7.9")]
    """Diameters over the tips at the outer end d_ae [m]."""
    inner_tip_diameter: Annotated[Both, Quantity("length"), Origin("d_ai = d_i + 2 h_ai cos δ", f"{_SOURCE}, 7.9")]
    """At the inner end d_ai [m]."""
    thickness: Annotated[Both, Quantity("length"), Origin("s_mn = m_mn (π/2 + 2 (x_sm + x_hm tan α_n))", _SOURCE)]
    """Mean normal circular tooth thicknesses s_mn [m]."""
    outer_spiral_angle: Annotated[float, Quantity("angle"), Origin("β_e", f"{_SOURCE}, eq. 183")]
    """Spiral angle at the outer end β_e [rad]."""
    inner_spiral_angle: Annotated[float, Quantity("angle"), Origin("β_i", f"{_SOURCE}, eq. 184")]
    """Spiral angle at the inner end β_i [rad]."""


def bevel_blank(pair: BevelPair, cutter_radius: float | None = None) -> BevelBlank:
    """Return the blanks of a pair.

    Args:
        pair: The pair.
        cutter_radius: r_c0 of face-milled spiral teeth [m]; None: roots point to the apex and β is that of a cone.

    Source: ISO 23509:2016, clause 7 with a = 0: tips are parallel to the mate's root.
    Valid for: shafts at right angles, both ends within the cutter's reach.

    Raises:
        DesignError: A cutter smaller than `least_cutter_radius`.

    >>> pair = BevelPair((14, 39), 176.893e-3 / 39, 25.4e-3, math.radians(35.0))
    >>> round(math.degrees(bevel_blank(pair, 114.3e-3).outer_spiral_angle), 3)  # annex F.2: 36.846
    36.846
    """
    least = least_cutter_radius(pair)
    if cutter_radius is not None and pair.spiral_angle and cutter_radius < least:
        message = f"{1e3 * cutter_radius:.4g} mm given; ISO 23509, annex C.5 and eq. 183 ask for {1e3 * least:.4g} mm"
        raise DesignError([Problem("cutter_radius", message)])
    below = dedendum_angles(pair, cutter_radius)
    half, ends = 0.5 * pair.face_width, (pair.outer_cone_distance, pair.mean_cone_distance - 0.5 * pair.face_width)
    above = below[1], below[0]
    cosines = [math.cos(cone) for cone in pair.pitch_angles]
    rises, drops = [half * math.tan(angle) for angle in above], [half * math.tan(angle) for angle in below]
    outer = [height + rise for height, rise in zip(pair.addenda, rises, strict=True)]
    inner = [height - rise for height, rise in zip(pair.addenda, rises, strict=True)]
    small = [diameter * ends[1] / ends[0] for diameter in pair.outer_diameters]
    angles = [_spiral_at(pair, cutter_radius, end) for end in ends]
    return BevelBlank(
        below,
        (pair.pitch_angles[0] + above[0], pair.pitch_angles[1] + above[1]),
        (pair.pitch_angles[0] - below[0], pair.pitch_angles[1] - below[1]),
        (outer[0], outer[1]),
        (pair.dedenda[0] + drops[0], pair.dedenda[1] + drops[1]),
        (pair.outer_diameters[0] + 2.0 * outer[0] * cosines[0], pair.outer_diameters[1] + 2.0 * outer[1] * cosines[1]),
        (small[0] + 2.0 * inner[0] * cosines[0], small[1] + 2.0 * inner[1] * cosines[1]),
        (mean_thickness(pair, 0), mean_thickness(pair, 1)),
        angles[0],
        angles[1],
    )


def dedendum_angles(pair: BevelPair, cutter_radius: float | None = None) -> Both:
    """Return the dedendum angles θ_f1 and θ_f2 [rad].

    Args:
        pair: The pair.
        cutter_radius: r_c0 of face-milled spiral teeth, which are then cut duplex [m]; None: standard taper.

    Source: ISO 23509:2016, annex C.5: standard θ_f = atan(h_fm/R_m); duplex
        Σθ_f = 90° m_et/(R_e tan α_n cos β_m) (1 − R_m sin β_m/r_c0), θ_f1 = Σθ_f h_am2/h_mw.
    """
    cone = pair.mean_cone_distance
    if cutter_radius is None or pair.spiral_angle == 0.0:
        return math.atan(pair.dedenda[0] / cone), math.atan(pair.dedenda[1] / cone)
    least = cone * math.sin(pair.spiral_angle)
    total = 0.5 * math.pi * pair.outer_module * (1.0 - least / cutter_radius)
    total /= pair.outer_cone_distance * math.tan(pair.pressure_angle) * math.cos(pair.spiral_angle)
    part = pair.addenda[1] / sum(pair.addenda)
    return total * part, total * (1.0 - part)


def least_cutter_radius(pair: BevelPair) -> float:
    """Return the smallest cutter radius with which spiral teeth neither deepen towards the apex nor end too soon [m].

    Args:
        pair: The pair.

    Source: ISO 23509:2016, annex C.5: r_c0 ≥ R_m sin β_m; eqs 183 and 184: sin β_e < 1, sin β_i > −1.
    """
    mean, outer = pair.mean_cone_distance, pair.outer_cone_distance
    inner, lean = outer - pair.face_width, mean * math.sin(pair.spiral_angle)
    ends = (outer**2 - mean**2) / (outer - lean), (mean**2 - inner**2) / (inner + lean)
    return max(lean, *(_REACH * 0.5 * end for end in ends))


def mean_thickness(pair: BevelPair, gear: int) -> float:
    """Return the mean normal circular thickness of a tooth s_mn [m].

    Args:
        pair: The pair.
        gear: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, s_mn = m_mn (π/2 + 2 (x_sm + x_hm tan α_n)).
    """
    shift = pair.tooth.profile_shift if gear == 0 else -pair.tooth.profile_shift
    widening = pair.tooth.thickness_shifts[gear] + shift * math.tan(pair.pressure_angle)
    return pair.mean_module * (0.5 * math.pi + 2.0 * widening)


def _spiral_at(pair: BevelPair, cutter_radius: float | None, cone: float) -> float:
    """Spiral angle at a cone distance (eqs 183 and 184); the mean one where no cutter says otherwise."""
    if cutter_radius is None or pair.spiral_angle == 0.0:
        return pair.spiral_angle
    mean = pair.mean_cone_distance
    sine = 2.0 * mean * cutter_radius * math.sin(pair.spiral_angle) - mean**2 + cone**2
    return math.asin(sine / (2.0 * cone * cutter_radius))
