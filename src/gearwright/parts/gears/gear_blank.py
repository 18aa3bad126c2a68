"""What a gear's body under its teeth weighs as it is made: a rim that carries them, a web, a hub."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

HOLE = 0.6
"""Diameter of a hole in a web over the room between rim and hub, or between neighbours, an assumption [-]."""


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
    holes: int = 0
    """Evenly spaced ones in the web that lighten it [-]."""
    dish: float = 0.0
    """How far the web stands at the hub from where it stands at the rim, along the axis [m]."""

    @property
    def is_solid(self) -> bool:
        """Whether rim and hub meet, or nothing is turned out between them."""
        return self.rim_radius <= self.hub_radius or self.web_width >= self.width

    @property
    def hole_circle(self) -> float:
        """Radius of the circle on which holes stand, in the middle of the web."""
        return (self.rim_radius + self.hub_radius) / 2.0

    @property
    def hole_radius(self) -> float:
        """Of one hole; 0 where there is none."""
        if not self.holes or self.is_solid:
            return 0.0
        chord = 2.0 * self.hole_circle * math.sin(math.pi / self.holes)
        return HOLE / 2.0 * min(self.rim_radius - self.hub_radius, chord)


def blank_volume(blank: Blank) -> float:
    """Return the volume of the body under the teeth [m³].

    Args:
        blank: Its radii and widths.

    Source: annuli; one alone where rim and hub meet; less what is bored through the web. A dished web is sheared along
        the axis, so that it is as thick along it, and fills as much (Cavalieri).
    """
    root, bore = blank.root_radius, min(blank.bore_radius, blank.root_radius)
    inside = max(blank.rim_radius, blank.hub_radius)
    rim, hub = _annulus(root, inside), _annulus(blank.hub_radius, bore)
    web = _annulus(inside, blank.hub_radius) - blank.holes * math.pi * blank.hole_radius**2
    return (rim + hub) * blank.width + web * blank.web_width


def _annulus(outer: float, inner: float) -> float:
    return math.pi * (outer**2 - inner**2)


def revolved_volume(corners: Sequence[tuple[float, float]]) -> float:
    """Return the volume that a closed chain of straight lines sweeps about the axis [m³].

    Args:
        corners: Place along the axis and radius of each [m]; the last one is joined to the first.

    Source: frusta of cones, V = π/3 Σ (z_2 − z_1)(r_1² + r_1 r_2 + r_2²), either way round.

    >>> round(revolved_volume([(0.0, 0.0), (0.3, 0.0), (0.3, 0.1)]) / math.pi, 6)  # a cone, r² h/3
    0.001
    """
    ends = pairwise([*corners, corners[0]])
    swept = sum((high - low) * (one**2 + one * two + two**2) for (low, one), (high, two) in ends)
    return abs(math.pi / 3.0 * swept)
