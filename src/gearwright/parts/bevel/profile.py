"""The outline of a bevel gear's teeth in its axial plane, ended by back cones square to the pitch cone."""

from __future__ import annotations

import math
from dataclasses import dataclass

from gearwright.parts.bevel.geometry import BevelPair


@dataclass(frozen=True)
class BevelProfile:
    """Corners of a bevel tooth: distance along the axis, away from the apex, from the mean point, and radius."""

    small: tuple[complex, complex]
    """Tip and pitch point of the small end [m]."""
    large: tuple[complex, complex]
    """Tip and pitch point of the large end [m]."""
    roots: tuple[complex, complex]
    """Root at the small and the large end [m]."""
    apex: float
    """Where the apex lies along the axis, negative [m]."""

    def scaled(self, factor: float) -> BevelProfile:
        """Return the same in another unit or size.

        Args:
            factor: New over old lengths [-].
        """
        small, large, roots = ((factor * pair[0], factor * pair[1]) for pair in (self.small, self.large, self.roots))
        return BevelProfile(small, large, roots, factor * self.apex)


def face_and_root(pair: BevelPair, side: int) -> tuple[float, float]:
    """Return face and root cone angle of a bevel gear whose teeth taper towards the apex [rad].

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, standard depth taper: δ_a = δ + atan(h_am/R_m), δ_f = δ − atan(h_fm/R_m).
    """
    pitch, distance = pair.pitch_angles[side], pair.mean_cone_distance
    return pitch + math.atan(pair.addenda[side] / distance), pitch - math.atan(pair.dedenda[side] / distance)


def bevel_profile(pair: BevelPair, side: int) -> BevelProfile:
    """Return the corners of a bevel gear's teeth.

    Args:
        pair: The pair.
        side: 0 for the pinion, 1 for the wheel.

    Source: ISO 23509:2016, cones about one apex; back cones square to the pitch cone at R_m ± b/2.
    """
    pitch, mean = pair.pitch_angles[side], pair.mean_cone_distance
    face, root = face_and_root(pair, side)
    shift = mean * math.cos(pitch)

    def corner(distance: float, angle: float) -> complex:
        reach = distance / math.cos(angle - pitch)
        return complex(reach * math.cos(angle) - shift, reach * math.sin(angle))

    near, far = (mean + sign * pair.face_width / 2.0 for sign in (-1.0, 1.0))
    return BevelProfile(
        small=(corner(near, face), corner(near, pitch)),
        large=(corner(far, face), corner(far, pitch)),
        roots=(corner(near, root), corner(far, root)),
        apex=-shift,
    )
