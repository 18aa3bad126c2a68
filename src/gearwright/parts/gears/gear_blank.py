"""What a gear's body weighs as it is made: teeth between root and tip, a rim that carries them, a web, a hub."""

from __future__ import annotations

import math
from typing import NamedTuple

from gearwright.parts.gears.cylindrical_gear import CylindricalGear, half_angle_at

_STRIPS = 16
"""Strips of equal height into which a tooth is cut, even for Simpson's rule [-]."""


class Blank(NamedTuple):
    """A body of revolution under external teeth: three annuli one inside the other; lengths [m]."""

    root_radius: float
    """Outside of the rim."""
    rim_radius: float
    """Inside of the rim."""
    hub_radius: float
    """Outside of the hub."""
    bore_radius: float
    """Inside of the hub."""
    width: float
    """Of rim and hub."""
    web_width: float
    """Of the web between them."""

    @property
    def is_solid(self) -> bool:
        """Whether rim and hub meet, so that there is no web."""
        return self.rim_radius <= self.hub_radius


def tooth_area(gear: CylindricalGear) -> float:
    """Return the area of all teeth of a gear between root and tip circle, in the transverse section [m²].

    Args:
        gear: The gear; a negative number of teeth is internal.

    Source: area of a profile, A = z ∫ 2 ψ(r) r dr by Simpson's rule with the tooth's half angle ψ of ISO 21771:2007;
        inside the base circle flanks are radial. Root fillets and tip relief are left out.
    """
    low, high = sorted((gear.root_radius, gear.tip_radius))
    step = (high - low) / _STRIPS
    radii = [low + k * step for k in range(_STRIPS + 1)]
    chords = [2.0 * max(half_angle_at(gear, max(radius, gear.base_radius)), 0.0) * radius for radius in radii]
    total = chords[0] + chords[-1] + 4.0 * sum(chords[1:-1:2]) + 2.0 * sum(chords[2:-1:2])
    return abs(gear.teeth) * total * step / 3.0


def blank_volume(blank: Blank) -> float:
    """Return the volume of the body under the teeth [m³].

    Args:
        blank: Its radii and widths.

    Source: annuli; one alone where rim and hub meet.
    """
    root, bore = blank.root_radius, min(blank.bore_radius, blank.root_radius)
    if blank.is_solid:
        return _annulus(root, bore) * blank.width
    rim, hub = _annulus(root, blank.rim_radius), _annulus(blank.hub_radius, bore)
    return (rim + hub) * blank.width + _annulus(blank.rim_radius, blank.hub_radius) * blank.web_width


def _annulus(outer: float, inner: float) -> float:
    return math.pi * (outer**2 - inner**2)
