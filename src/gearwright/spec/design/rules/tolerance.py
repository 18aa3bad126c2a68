"""What is not as drawn: how far a gear, a shaft or a planet stands from its place, and how far that may go.

Lengths are displacements of the part itself, so that a displacement towards the mating tooth closes a mesh.
"""

from __future__ import annotations

import math

from pydantic import Field

from gearwright.spec.record import Record
from gearwright.units import Angle, Length

_TURN = 2.0 * math.pi


class PartErrors(Record):
    """Errors of one gear, shaft or planet."""

    eccentricity: Length = Field(
        0.0, ge=0, le=0.1, description="Distance of its own axis from the axis that it turns about"
    )
    phase: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Where the eccentricity points at time 0, from the first axis across it"
    )
    radial: Length = Field(0.0, ge=0, le=0.1, description="Distance of its standing axis from the drawn place")
    radial_angle: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Where that distance points, from the first axis across it"
    )
    axial: Length = Field(0.0, description="Distance along its axis from the drawn place, positive along x")
    tooth_thickness: Length = Field(0.0, description="Tooth too thick, along the line of action; negative is too thin")
    clocking: Angle = Field(
        0.0, ge=-_TURN, le=_TURN, description="Turned on its shaft against the drawn angle, positive as it drives"
    )
    pin_radial: Length = Field(0.0, description="Of a planet: pin too far out")
    pin_tangential: Length = Field(0.0, description="Of a planet: pin too far ahead in the positive direction")
