"""Rotors: shafts as beams that bend, stretch and twist, with discs on their stations, in bearings, coupled by gears.

Stations count from 0, one at each end of every segment. A shaft is written as its own free modes: ``NAME`` is its rigid
rotation, ``NAME bending x 1`` and so on are the others; `Placed.at` says how a station moves by them in each direction.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model.beam import Segment
from gearwright.dynamics.model.model import Model
from gearwright.dynamics.model.rotors.elastic_body import (
    ModalBasis,
    Motion,
    Placed,
    Spring,
    add_modes,
    modal_basis,
    motions,
)
from gearwright.dynamics.model.rotors.shaft_element import Element, element
from gearwright.errors import Problem, refuse
from gearwright.verbs import verb


@dataclass(frozen=True)
class Disc:
    """A rigid body on a station: a disc, a gear, a coupling."""

    mass: float
    """[kg]."""
    diametral: float
    """Moment of inertia about a diameter [kg m²]."""
    polar: float
    """Moment of inertia about the shaft [kg m²]."""

    @classmethod
    def of_steel(cls, width: float, diameter: float, *, bore: float = 0.0, density: float = 7850.0) -> Disc:
        """Return a round disc.

        Args:
            width: [m].
            diameter: Outer one [m].
            bore: [m].
            density: [kg/m³].
        """
        mass = density * math.pi / 4.0 * (diameter**2 - bore**2) * width
        square = diameter**2 + bore**2
        return cls(mass, mass * (square / 16.0 + width**2 / 12.0), mass * square / 8.0)


@dataclass(frozen=True)
class Rotor:
    """A shaft and what it carries."""

    segments: Sequence[Segment]
    """From one end to the other; finer ones are more exact."""
    discs: Mapping[int, Disc] = field(default_factory=dict)
    """Station -> what sits there."""

    @property
    def mass(self) -> float:
        """[kg]."""
        shaft = sum(segment.density * segment.area * segment.length for segment in self.segments)
        return shaft + sum(disc.mass for disc in self.discs.values())


@verb
@one_blas_thread()
def add_rotor(
    model: Model,
    name: str,
    rotor: Rotor,
    *,
    speed: float | None = None,
    damping_ratio: float = 0.0,
    highest: float | None = None,
) -> Placed:
    """Add a rotor with bending in both planes, axial motion, torsion and gyroscopic effect; return how it moves.

    Args:
        model: That gets it.
        name: Unique name, and that of its rotation.
        rotor: Shaft and discs.
        speed: Of rotation [rad/s]; None: from the lines, without gyroscopic effect.
        damping_ratio: ζ of every elastic mode of the free shaft [-].
        highest: Free modes above are left out, which lets a run take longer steps [Hz]; None: all are kept.

    Raises:
        DesignError: If a segment has no length or no section, or a disc no mass or no station.

    Source: Nelson 1980, J. Mech. Des. 102, 793-803 (elements); Friswell et al. 2010, Dynamics of Rotating Machines.
    """
    refuse(_problems(name, rotor))
    elements = [element(segment) for segment in rotor.segments]
    stations = [str(station) for station in range(len(elements) + 1)]
    basis = _bending(rotor, elements, highest)
    moves = list[dict[str, dict[str, Motion]]]()
    for axis, tilt, sense in (("x", "tilt y", 1.0), ("y", "tilt x", -1.0)):
        names = add_modes(model, basis, Spring(f"{name} bending {axis}", "m", damping_ratio))
        moves.append(motions(names, basis.shapes[0::2], ((station, axis) for station in stations)))
        moves.append(motions(names, sense * basis.shapes[1::2], ((station, tilt) for station in stations)))
    moves.append(_axial(model, name, rotor, elements, Spring(f"{name} axial", "m", damping_ratio), highest=highest))
    moves.append(_twist(model, name, rotor, elements, speed=speed, damping=damping_ratio, highest=highest))
    if speed:
        _add_gyroscopic(model, name, basis, speed * _polar(rotor, elements))
    merged = {station: {key: motion for move in moves for key, motion in move[station].items()} for station in stations}
    return Placed(name, merged)


def _problems(name: str, rotor: Rotor) -> Iterator[Problem]:
    if not rotor.segments:
        yield Problem(f"{name}.segments", "there is none; give the stretches of the shaft")
    for number, segment in enumerate(rotor.segments):
        numbers = (segment.length, segment.elasticity, segment.density, segment.diameter - segment.bore)
        if not (all(0.0 < value < math.inf for value in numbers) and segment.bore >= 0.0):
            yield Problem(f"{name}.segments.{number}", "a segment needs length, section, elasticity and density")
    for station, disc in rotor.discs.items():
        if not 0 <= station <= len(rotor.segments):
            yield Problem(f"{name}.discs.{station}", f"no such station; they count from 0 to {len(rotor.segments)}")
        if not all(0.0 <= value < math.inf for value in (disc.mass, disc.diametral, disc.polar)):
            yield Problem(f"{name}.discs.{station}", f"{disc}; give masses and inertias that are not negative")


def _assembled(parts: Sequence[Floats], width: int) -> Floats:
    """Return the matrix of a chain of elements with `width` coordinates at each station."""
    matrix = np.zeros((width * (len(parts) + 1),) * 2)
    for number, part in enumerate(parts):
        here = slice(width * number, width * (number + 2))
        matrix[here, here] += part
    return matrix


def _bending(rotor: Rotor, elements: Sequence[Element], highest: float | None) -> ModalBasis:
    """Return the free modes of bending in one plane, in deflection and slope of each station."""
    mass = _assembled([part.mass for part in elements], 2)
    for station, disc in rotor.discs.items():
        mass[2 * station, 2 * station] += disc.mass
        mass[2 * station + 1, 2 * station + 1] += disc.diametral
    stiffness = _assembled([part.stiffness for part in elements], 2)
    return modal_basis(mass, stiffness, modal_mass=rotor.mass, highest=highest, rigid=2)


def _polar(rotor: Rotor, elements: Sequence[Element]) -> Floats:
    """Return the polar inertias in the slopes of each station [kg m²]."""
    polar = _assembled([part.polar for part in elements], 2)
    for station, disc in rotor.discs.items():
        polar[2 * station + 1, 2 * station + 1] += disc.polar
    return polar


def _axial(
    model: Model, name: str, rotor: Rotor, elements: Sequence[Element], spring: Spring, *, highest: float | None
) -> dict[str, dict[str, Motion]]:
    mass = _assembled([part.axial_mass for part in elements], 1)
    for station, disc in rotor.discs.items():
        mass[station, station] += disc.mass
    stiffness = _assembled([part.axial_stiffness for part in elements], 1)
    basis = modal_basis(mass, stiffness, modal_mass=rotor.mass, highest=highest, rigid=1)
    names = add_modes(model, basis, spring)
    return motions(names, basis.shapes, ((str(station), "z") for station in range(len(mass))))


def _twist(
    model: Model,
    name: str,
    rotor: Rotor,
    elements: Sequence[Element],
    *,
    speed: float | None,
    damping: float,
    highest: float | None,
) -> dict[str, dict[str, Motion]]:
    """Add the rigid rotation, which turns at speed, and the modes of torsion."""
    mass = _assembled([part.torsion_mass for part in elements], 1)
    for station, disc in rotor.discs.items():
        mass[station, station] += disc.polar
    stiffness = _assembled([part.torsion_stiffness for part in elements], 1)
    inertia = float(np.sum(mass))
    basis = modal_basis(mass, stiffness, modal_mass=inertia, highest=highest, rigid=1)
    elastic = ModalBasis(basis.square[1:], basis.shapes[:, 1:], inertia)
    model.rotation(name, inertia=inertia, speed=speed)
    names = [name, *add_modes(model, elastic, Spring(f"{name} torsion", "rad", damping))]
    shapes = np.hstack([np.ones((len(mass), 1)), elastic.shapes])
    return motions(names, shapes, ((str(station), "twist") for station in range(len(mass))))


def _add_gyroscopic(model: Model, name: str, basis: ModalBasis, moments: Floats) -> None:
    """Couple the modes of both planes: a slope's rate in one bends the shaft in the other."""
    coupling = basis.shapes.T @ moments @ basis.shapes
    least = 1e-14 * float(np.max(np.abs(coupling), initial=0.0))
    for first, row in enumerate(coupling.tolist(), start=1):
        for second, moment in enumerate(row, start=1):
            if abs(moment) > least:
                model.gyroscopic(f"{name} bending x {first}", f"{name} bending y {second}", moment=moment)
