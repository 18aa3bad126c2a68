"""Contacts: meshes with a direction in space, so that gears may shift, run out or stand wrong.

A contact is where a tooth of gear a presses on one of gear b along the unit vector n. With displacements u and
rotations θ of the two,

    δ = n·(u_a − u_b) + l_a θ_a + l_b θ_b − e,   e = −n·(ε_a − ε_b) − …

an error ε that displaces a gear is a displacement like any other. Shafts lie along x, the pinion of a face gear across;
every shaft has two axes across it, in the order in which a positive rotation meets them. The contacts of a planetary
set are written in the frame of its carrier, whose y axis passes through the first planet.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from gearwright.dynamics.model.line import Periodic
from gearwright.spec.design import PartErrors

Vector = tuple[float, float, float]
Turns = Mapping[str, int]
"""An angle as integers of rotations."""
AXES = "xyz"
SMALL = 1e-12
"""Direction cosine below which a direction counts as square to an axis [-]."""


class Carried(NamedTuple):
    """A gear body in a contact, with the shaft (of a planet: the carrier's) that it sits on."""

    gear: str
    """Name of the body, and of its rotation."""
    shaft: str
    """Name of the shaft."""
    lever: float
    """l: weight of its rotation in the contact's line, base radius with sign [m]."""
    gear_turns: Turns
    """Angle of the gear in the contact's frame."""
    shaft_turns: Turns
    """Angle of the shaft in the contact's frame."""
    housing_turns: Turns
    """Angle of the housing in the contact's frame: nothing, but for planetary sets."""
    axis: str = "x"
    """Axis of the shaft: ``"x"``, ``"y"`` or ``"z"``."""
    place: complex | None = None
    """Of a planet: direction from the carrier's axis to its pin, y + i z; None for other gears."""

    @property
    def across(self) -> tuple[int, int]:
        """The two axes across its shaft, as numbers of x, y, z."""
        first = (AXES.index(self.axis) + 1) % 3
        return first, (first + 1) % 3


@dataclass(frozen=True)
class Contact:
    """Where a tooth of one gear presses on a tooth of another."""

    line: str
    """Name of the mesh's line."""
    direction: Vector
    """n: along the line of action, from gear a into gear b [-]."""
    sides: tuple[Carried, Carried]
    """Gears a and b."""


def push_direction(towards: complex, pressure_angle: float, *, sense: float) -> Vector:
    """Return the direction in which a gear's tooth presses on another's, both with axes along x.

    Args:
        towards: From the axis of the pressing gear to the pitch point, y + i z, of any length.
        pressure_angle: Working transverse pressure angle [rad].
        sense: 1 if it pushes on positively about its axis (y to z), −1 if negatively.

    Source: the line of action stands at the pressure angle to the common tangent, ISO 21771:2007, clause 5.2.

    Valid for: a pressing gear with external teeth.
    """
    out = towards / abs(towards)
    push = math.cos(pressure_angle) * sense * 1j * out + math.sin(pressure_angle) * out
    return (0.0, push.real, push.imag)


def face_push_direction(place: complex, pressure_angle: float, *, sense: float) -> Vector:
    """Return the direction in which a pinion presses on a face gear that turns about x.

    The pinion lies along y or z, so that its axis meets the face gear's. A face gear on the positive side of it lies
    at smaller x than the pinion, one on the negative side at larger x: then both turn against it, as two wheels
    do on a cylindrical pinion.

    Args:
        place: From the pinion to the face gear's axis, y + i z, of any length, along y or z.
        pressure_angle: Of the pinion [rad].
        sense: 1 if the pinion pushes on positively about its axis, −1 if negatively.

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


def shift_weights(contact: Contact) -> dict[str, float]:
    """Return the weights of the shafts' displacements in a contact's line: ``"input.y"`` -> direction cosine [-].

    Args:
        contact: The mesh.
    """
    weights: dict[str, float] = {}
    for side, sign in zip(contact.sides, (1.0, -1.0), strict=True):
        for axis, cosine in zip(AXES, contact.direction, strict=True):
            if abs(cosine) > SMALL:
                name = f"{side.shaft}.{axis}"
                weights[name] = weights.get(name, 0.0) + sign * cosine
    return weights


def contact_errors(contact: Contact, parts: Mapping[str, PartErrors]) -> list[Periodic]:
    """Return the errors of a contact's line: what its two gears and their shafts bring along.

    Args:
        contact: The mesh.
        parts: Gear body or shaft -> its errors.

    Source: equivalent mesh errors, e = −J ε; Wang, Zhao, Tao, Jia & Guo, eqs 1 to 4, with the projections that follow
        from the directions of the lines of action instead of the printed phases.
    """
    errors: list[Periodic] = []
    for side, sign in zip(contact.sides, (1.0, -1.0), strict=True):
        direction = [sign * cosine for cosine in contact.direction]
        if side.gear in parts:
            errors += _errors(parts[side.gear], side, side.gear_turns, direction)
        if side.shaft in parts and side.shaft != side.gear:
            errors += _errors(parts[side.shaft], side, side.shaft_turns, direction)
    return [error for error in errors if error.constant or any(error.cosine) or any(error.sine)]


def _errors(part: PartErrors, side: Carried, turns: Turns, direction: Sequence[float]) -> Iterator[Periodic]:
    """Yield what one gear or shaft adds, given the contact's direction on its side."""
    first, second = (direction[axis] for axis in side.across)
    still = part.axial * direction[AXES.index(side.axis)] + part.tooth_thickness + side.lever * part.clocking
    if side.place is not None:
        pin = side.place / abs(side.place) * complex(part.pin_radial, part.pin_tangential)
        still += first * pin.real + second * pin.imag
    yield Periodic(constant=-still)
    yield from _vector(part.radial, part.radial_angle, side.housing_turns, (first, second))
    yield from _vector(part.eccentricity, part.phase, turns, (first, second))


def _vector(length: float, angle: float, turns: Turns, across: tuple[float, float]) -> Iterator[Periodic]:
    """Yield the error of a displacement across the shaft whose direction turns, or stands."""
    first, second = across
    if turns:
        yield Periodic(turns, cosine=(-length * first,), sine=(-length * second,), offset=angle)
    else:
        yield Periodic(constant=-length * (first * math.cos(angle) + second * math.sin(angle)))
