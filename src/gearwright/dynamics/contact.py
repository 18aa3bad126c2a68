"""Contacts: meshes with a direction in space, so that gears may shift, run out or stand wrong.

A contact is where a driving tooth presses on a driven one along the unit vector n. With the displacements u of the two
shafts and the rotations θ, positive as they drive,

    δ = n·(u_a − u_b) + r_a θ_a − r_b θ_b − e

so an error that displaces a gear is a displacement like any other: e = −n·ε_a + n·ε_b. Shafts lie along x; the pinion
of a face gear lies across. Each shaft has two axes across it, in the order in which a positive rotation meets them.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.dynamics.line import Periodic
from gearwright.spec.tolerance import PartErrors

Vector = tuple[float, float, float]
AXES = "xyz"
SMALL = 1e-12
"""Direction cosine below which a direction counts as square to an axis [-]."""


class Spin(NamedTuple):
    """How a shaft stands and turns."""

    rotation: str
    """Coordinate of its rotation."""
    axis: str
    """``"x"``, ``"y"`` or ``"z"``."""
    sense: int
    """1 if the coordinate grows as the shaft drives, −1 if it falls."""

    @property
    def across(self) -> tuple[int, int]:
        """The two axes across it, as numbers of x, y, z."""
        first = (AXES.index(self.axis) + 1) % 3
        return first, (first + 1) % 3


@dataclass(frozen=True)
class Contact:
    """Where one gear drives another."""

    line: str
    """Name of the mesh's line."""
    gears: tuple[str, str]
    """Names of the driving and the driven gear body, whose errors it feels."""
    shafts: tuple[str, str]
    """Shafts of the two, whose motions and errors it feels."""
    direction: Vector
    """n: along the line of action, from the driving into the driven tooth [-]."""
    radii: tuple[float, float]
    """Base radii of the two [m]."""


def push_direction(towards: complex, pressure_angle: float, *, sense: int, concave: bool = False) -> Vector:
    """Return the direction in which a driving tooth presses on the driven one, both gears with axes along x.

    Args:
        towards: From the driver's axis to the pitch point, y + i z, of any length.
        pressure_angle: Working transverse pressure angle [rad].
        sense: 1 if the driver turns positively (y to z), −1 if negatively.
        concave: The driver is an internal gear, whose teeth press inwards.

    Source: the line of action stands at the pressure angle to the common tangent, ISO 21771:2007, clause 5.2.
    """
    out = towards / abs(towards)
    along = math.cos(pressure_angle) * sense * 1j * out
    push = along + math.sin(pressure_angle) * (-out if concave else out)
    return (0.0, push.real, push.imag)


def face_push_direction(place: complex, pressure_angle: float, *, sense: int) -> Vector:
    """Return the direction in which a pinion presses on a face gear that turns about x.

    The pinion lies along y or z, so that its axis meets the face gear's. A face gear on the positive side of it lies
    at smaller x than the pinion, one on the negative side at larger x: then both turn against it, as two wheels
    do on a cylindrical pinion.

    Args:
        place: From the pinion to the face gear's axis, y + i z, of any length, along y or z.
        pressure_angle: Of the pinion [rad].
        sense: 1 if the pinion turns positively about its axis, −1 if negatively.

    Source: geometry of two crossing axes; Wang, Zhao, Tao, Jia & Guo, eqs 5 and 6, whose face gear 1 lies above.
    """
    out = place / abs(place)
    push = math.cos(pressure_angle) * sense * 1j * out
    return (math.copysign(math.sin(pressure_angle), -out.real - out.imag), push.real, push.imag)


def crossing_axis(place: complex) -> str | None:
    """Return the axis along which a face gear's pinion lies, ``"y"`` or ``"z"``; None if along neither.

    Args:
        place: From the pinion to the face gear's axis, y + i z.
    """
    unit = place / abs(place)
    if abs(unit.imag) < SMALL**0.5:
        return "y"
    return "z" if abs(unit.real) < SMALL**0.5 else None


def contact_weights(contact: Contact, spins: Mapping[str, Spin], rotations: tuple[str, str],
                    moving: Collection[str]) -> dict[str, float]:  # fmt: skip
    """Return the weights of a contact's line: rotations, and translations of shafts that can move.

    Args:
        contact: The mesh.
        spins: Of every shaft.
        rotations: Coordinates of the driving and the driven gear.
        moving: Names of the translations in the model, such as ``"input.y"``.
    """
    weights: dict[str, float] = {}
    for end, sign in ((0, 1.0), (1, -1.0)):
        shaft = contact.shafts[end]
        weights[rotations[end]] = sign * spins[shaft].sense * contact.radii[end]
        for axis, cosine in zip(AXES, contact.direction, strict=True):
            name = f"{shaft}.{axis}"
            if name in moving and abs(cosine) > SMALL:
                weights[name] = weights.get(name, 0.0) + sign * cosine
    return weights


def contact_errors(contact: Contact, spins: Mapping[str, Spin], parts: Mapping[str, PartErrors]) -> list[Periodic]:
    """Return the errors of a contact's line: what its two gears and its two shafts bring along.

    Args:
        contact: The mesh.
        spins: Of every shaft.
        parts: Gear body or shaft -> its errors.

    Source: equivalent mesh errors, e = −J ε; Wang, Zhao, Tao, Jia & Guo, eqs 1 to 4, with the projections that follow
        from the directions of the lines of action instead of the printed phases.
    """
    found = []
    for end, sign in ((0, 1.0), (1, -1.0)):
        spin = spins[contact.shafts[end]]
        for part in (contact.gears[end], contact.shafts[end]):
            if part in parts:
                found += _errors(parts[part], spin, contact, (sign, contact.radii[end]))
    return [each for each in found if each.constant or any(each.cosine) or any(each.sine)]


def _errors(part: PartErrors, spin: Spin, contact: Contact, end: tuple[float, float]) -> list[Periodic]:
    """Errors of one gear or shaft at one end of a contact, given its sign and base radius."""
    sign, radius = end
    first, second = (sign * contact.direction[axis] for axis in spin.across)
    still = part.radial * (first * math.cos(part.radial_angle) + second * math.sin(part.radial_angle))
    still += part.axial * sign * contact.direction[AXES.index(spin.axis)]
    still += part.tooth_thickness + sign * radius * part.clocking
    turning = Periodic(
        phase={spin.rotation: 1},
        cosine=(-part.eccentricity * first,),
        sine=(-part.eccentricity * second,),
        offset=part.phase,
    )
    return [Periodic(constant=-still), turning]
