"""Bending shafts: each Timoshenko segment is exactly six lines between its two ends.

One line stretches, one twists, and in each plane one bends (the ends tilt apart) and one shears (the ends shift against
their mean tilt). Masses and inertias of a segment go half to each end.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model.line import DampingRatio, Line
from gearwright.dynamics.model.model import Model
from gearwright.errors import DesignError, Problem
from gearwright.parts.material import STEEL_MODULUS, STEEL_POISSON
from gearwright.verbs import verb

DIRECTIONS = ("x", "y", "z", "tilt x", "tilt y", "twist")
"""Coordinates of a station: two across, one along the axis, two tilts about x and y, and the rotation."""


@dataclass(frozen=True)
class Segment:
    """A stretch of round shaft."""

    length: float
    """[m]."""
    diameter: float
    """Outer diameter [m]."""
    bore: float = 0.0
    """Inner diameter [m]."""
    elasticity: float = STEEL_MODULUS
    """Young's modulus [Pa]."""
    poisson: float = STEEL_POISSON
    """Poisson's ratio [-]."""
    density: float = 7850.0
    """[kg/m³]."""

    @property
    def area(self) -> float:
        """Cross-section [m²]."""
        return 0.25 * math.pi * (self.diameter**2 - self.bore**2)

    @property
    def second_moment(self) -> float:
        """Second moment of area about a diameter [m⁴]."""
        return math.pi / 64.0 * (self.diameter**4 - self.bore**4)

    @property
    def shear_modulus(self) -> float:
        """[Pa]."""
        return self.elasticity / (2.0 * (1.0 + self.poisson))

    @property
    def shear_coefficient(self) -> float:
        """Share of the cross-section that carries shear [-].

        Source: Cowper 1966, J. Appl. Mech. 33, table 1, hollow circle.
        """
        ratio, nu = self.bore / self.diameter, self.poisson
        square = (1.0 + ratio**2) ** 2
        return 6.0 * (1.0 + nu) * square / ((7.0 + 6.0 * nu) * square + (20.0 + 12.0 * nu) * ratio**2)


class _End(NamedTuple):
    """What a station carries."""

    mass: float
    diametral: float
    polar: float


@verb
@one_blas_thread()
def bending_shaft(
    model: Model, name: str, segments: Sequence[Segment], *, speed: float | None = None, damping_ratio: float = 0.0
) -> list[str]:
    """Add a shaft with bending, shear, stretch, twist and gyroscopic effect; return its stations' names.

    Coordinates are ``"<station> x"`` and so on, by `DIRECTIONS`; supports and gears attach to them.

    Args:
        model: Model to add to.
        name: Unique name.
        segments: From one end to the other.
        speed: Rotational speed [rad/s]; None: from the lines (no gyroscopic effect).
        damping_ratio: Of every line [-].

    Source:
        Przemieniecki 1968, Theory of Matrix Structural Analysis, eq. 5.116, written as a sum of rank-one terms.

    Raises:
        DesignError: If a segment has no length or no section.
    """
    wrong = [
        number
        for number, segment in enumerate(segments)
        if not (segment.length > 0.0 and 0.0 <= segment.bore < segment.diameter)
    ]
    if wrong or not segments:
        raise DesignError([Problem(f"{name}.{i}", "a segment needs a length and a section") for i in wrong or [0]])
    stations = [f"{name} {number}" for number in range(len(segments) + 1)]
    for station, end in zip(stations, _ends(segments), strict=True):
        _station(model, station, end, speed)
    for number, segment in enumerate(segments):
        for line in _lines(f"{name} {number}-{number + 1}", stations[number : number + 2], segment, damping_ratio):
            model.add(line)
    return stations


def _ends(segments: Sequence[Segment]) -> list[_End]:
    sums = [[0.0, 0.0, 0.0] for _ in range(len(segments) + 1)]
    for number, segment in enumerate(segments):
        half = 0.5 * segment.density * segment.length
        for end in sums[number : number + 2]:
            end[0] += half * segment.area
            end[1] += half * segment.second_moment
            end[2] += 2.0 * half * segment.second_moment
    return [_End(*end) for end in sums]


def _station(model: Model, station: str, end: _End, speed: float | None) -> None:
    x, y, z, tilt_x, tilt_y, twist = (f"{station} {direction}" for direction in DIRECTIONS)
    for direction in (x, y, z):
        model.translation(direction, mass=end.mass)
    for tilt in (tilt_x, tilt_y):
        model.rotation(tilt, inertia=end.diametral, speed=0.0)
    model.rotation(twist, inertia=end.polar, speed=speed)
    if speed:
        model.gyroscopic(tilt_x, tilt_y, moment=end.polar * speed)


def _lines(name: str, stations: Sequence[str], segment: Segment, damping_ratio: float) -> list[Line]:
    (x1, y1, z1, a1, b1, t1), (x2, y2, z2, a2, b2, t2) = (
        [f"{station} {direction}" for direction in DIRECTIONS] for station in stations
    )
    length, bending = segment.length, segment.elasticity * segment.second_moment
    shear = 12.0 * bending / (segment.shear_coefficient * segment.area * segment.shear_modulus * length**2)
    across = 12.0 * bending / ((1.0 + shear) * length**3)
    half = 0.5 * length
    pieces = {
        "stretch": ({z2: 1.0, z1: -1.0}, segment.elasticity * segment.area / length),
        "twist": ({t1: 1.0, t2: -1.0}, 2.0 * segment.shear_modulus * segment.second_moment / length),
        # A tilt about y carries x along the axis; a tilt about x carries −y.
        "bend x": ({b2: 1.0, b1: -1.0}, bending / length),
        "shear x": ({x2: 1.0, x1: -1.0, b1: -half, b2: -half}, across),
        "bend y": ({a2: 1.0, a1: -1.0}, bending / length),
        "shear y": ({y2: 1.0, y1: -1.0, a1: half, a2: half}, across),
    }
    damping = DampingRatio(damping_ratio)
    return [
        Line(f"{name} {what}", weights, stiffness, damping, kind="shaft")
        for what, (weights, stiffness) in pieces.items()
    ]
