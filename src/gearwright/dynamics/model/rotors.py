"""Rotors by beam elements with discs and gyroscopic effect, in bearings, coupled by gear meshes.

It adds coordinates and lines to a model; lumped shafts between two gears are in `beam`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from gearwright.base import DesignError, Floats, Problem, by_name, one_blas_thread, refuse, verb
from gearwright.dynamics.model.elements import DampingRatio, Line, Periodic
from gearwright.dynamics.model.model import Model
from gearwright.parts.material import STEEL_MODULUS, STEEL_POISSON
from gearwright.spec.bodies import ReducedBody

# ----------------------------------------------------------------------------------------------------------------------
# Bending shafts: each Timoshenko segment is exactly six lines between its two ends.
#
# One line stretches, one twists, and in each plane one bends (the ends tilt apart) and one shears (the ends shift
# against their mean tilt). Masses and inertias of a segment go half to each end.
# ----------------------------------------------------------------------------------------------------------------------


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


# ----------------------------------------------------------------------------------------------------------------------
# One element of a round shaft: consistent mass, stiffness and gyroscopic matrices of bending, axial and torsion.
# ----------------------------------------------------------------------------------------------------------------------


_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)
_AT, _SHARE = 0.5 * (_NODES + 1.0), 0.5 * _WEIGHTS
"""Places ξ and weights of the integration over an element, exact to ξ⁷."""


class Element(NamedTuple):
    """Matrices of one segment; bending in (deflection, slope) of both ends, axial and torsion in one of each."""

    mass: Floats
    """Bending [kg, kg m, kg m²], shape (4, 4)."""
    stiffness: Floats
    """Bending [N/m, N, N m], shape (4, 4)."""
    polar: Floats
    """Gyroscopic terms over the speed: ∫ ρ J_p of the slopes [kg m²], shape (4, 4)."""
    axial_mass: Floats
    """[kg], shape (2, 2)."""
    axial_stiffness: Floats
    """[N/m], shape (2, 2)."""
    torsion_mass: Floats
    """[kg m²], shape (2, 2)."""
    torsion_stiffness: Floats
    """[N m/rad], shape (2, 2)."""


def element(segment: Segment) -> Element:
    """Return the matrices of one segment.

    Args:
        segment: Stretch of round shaft.

    Source: Nelson 1980, J. Mech. Des. 102, 793-803: Timoshenko element, interpolated by its exact static deflection.
    """
    length, bending = segment.length, segment.elasticity * segment.second_moment
    shear = segment.shear_coefficient * segment.area * segment.shear_modulus
    softness = 12.0 * bending / (shear * length**2)
    deflection, slope, curvature = _interpolation(length, softness)
    # The shear strain, the same all along.
    ends = np.array([-1.0 / length, -0.5, 1.0 / length, -0.5]) * softness / (1.0 + softness)
    sliding = np.repeat(ends[:, None], len(_AT), axis=1)
    tilting = segment.density * segment.second_moment * _integral(slope, length)
    equal, against = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0, np.array([[1.0, -1.0], [-1.0, 1.0]])
    mass, polar_moment = segment.density * segment.area * length, 2.0 * segment.second_moment
    return Element(
        mass=segment.density * segment.area * _integral(deflection, length) + tilting,
        stiffness=bending * _integral(curvature, length) + shear * _integral(sliding, length),
        polar=2.0 * tilting,
        axial_mass=mass * equal,
        axial_stiffness=segment.elasticity * segment.area / length * against,
        torsion_mass=segment.density * polar_moment * length * equal,
        torsion_stiffness=segment.shear_modulus * polar_moment / length * against,
    )


def _integral(rows: Floats, length: float) -> Floats:
    return np.asarray(length * np.einsum("ag,bg,g->ab", rows, rows, _SHARE))


def _interpolation(length: float, shear: float) -> tuple[Floats, Floats, Floats]:
    """Return deflection, slope and curvature at the places of the integration by the coordinates of the ends."""
    x, one = _AT, np.ones_like(_AT)
    deflection = np.array([
        one - 3.0 * x**2 + 2.0 * x**3 + shear * (1.0 - x),
        length * (x - 2.0 * x**2 + x**3 + 0.5 * shear * (x - x**2)),
        3.0 * x**2 - 2.0 * x**3 + shear * x,
        length * (x**3 - x**2 - 0.5 * shear * (x - x**2)),
    ])  # fmt: skip
    slope = np.array([
        6.0 * (x**2 - x) / length, one - 4.0 * x + 3.0 * x**2 + shear * (1.0 - x),
        6.0 * (x - x**2) / length, 3.0 * x**2 - 2.0 * x + shear * x,
    ])  # fmt: skip
    curvature = np.array([
        6.0 * (2.0 * x - 1.0) / length, 6.0 * x - 4.0 - shear, 6.0 * (1.0 - 2.0 * x) / length, 6.0 * x - 2.0 + shear,
    ])  # fmt: skip
    return deflection / (1.0 + shear), slope / (1.0 + shear), curvature / ((1.0 + shear) * length)


# ----------------------------------------------------------------------------------------------------------------------
# An elastic body by its mass and stiffness matrices, written as its own modes, so that the system's mass is diagonal.
#
# With M Φ = K Φ ω⁻² and Φᵀ M Φ = m I its coordinates p have the mass m each and are held by m ω²; points of the body
# move by u = Φ p, exactly, if all modes are kept. A shaft is such a body, and so is a housing that was reduced
# elsewhere.
# ----------------------------------------------------------------------------------------------------------------------


RIGID = 1e-11
"""ω² over the largest one of a body below which a mode is rigid [-]."""

Motion = Mapping[str, float]
"""Coordinate -> its weight in a displacement or a rotation."""


Point = Mapping[str, Motion]
"""Direction -> motion of one place: what bearings and meshes join."""


@dataclass(frozen=True)
class Placed:
    """A body in a model: how its places move."""

    name: str
    """As it was added."""
    places: Mapping[str, Point]
    """Station or seat -> its motion in each direction, by coordinates of the model."""

    def at(self, place: int | str) -> Point:
        """Return how a station or a seat moves, by direction: ``x``, ``y``, ``z``, ``tilt x``, ``tilt y``, ``twist``.

        Args:
            place: Station of a shaft, or the name of a seat.

        Raises:
            DesignError: If there is no such place.
        """
        return by_name(str(place), self.places, f"place of {self.name}")


class ModalBasis(NamedTuple):
    """Modes of a body, rigid ones first."""

    square: Floats
    """ω² [1/s²], shape (modes,); zero for rigid ones."""
    shapes: Floats
    """Φ, shape (coordinates, modes), of modal mass m each."""
    mass: float
    """m [kg or kg m²]."""


def modal_basis(
    mass: Floats, stiffness: Floats, *, modal_mass: float, highest: float | None = None, rigid: int | None = None
) -> ModalBasis:
    """Return the modes of a body.

    Args:
        mass: M, symmetric and positive definite [kg …].
        stiffness: K, symmetric and positive semi-definite [N/m …].
        modal_mass: m of every mode [kg or kg m²].
        highest: Modes above are left out [Hz]; None: all are kept.
        rigid: Number of motions without stiffness, where it is known; None: those below `RIGID`.

    Source: Craig & Kurdila 2006, Fundamentals of Structural Dynamics, ch. 10: eigenproblem by M = L Lᵀ.
    """
    inverse = np.linalg.inv(np.linalg.cholesky(mass))
    square, vectors = np.linalg.eigh(inverse @ (0.5 * (stiffness + stiffness.T)) @ inverse.T)
    loose = np.arange(len(square)) < rigid if rigid is not None else square < RIGID * square[-1]
    square = np.where(loose, 0.0, square)
    kept = len(square) if highest is None else int(np.sum(square <= (2.0 * np.pi * highest) ** 2))
    shapes = np.sqrt(modal_mass) * (inverse.T @ vectors[:, :kept])
    return ModalBasis(square[:kept], shapes, modal_mass)


class Spring(NamedTuple):
    """What modal coordinates are called and how they are held."""

    label: str
    """Before the number of the mode, such as ``shaft bending x``."""
    unit: str
    """``"m"`` or ``"rad"``."""
    damping: float
    """ζ of each mode that is not rigid [-]."""


def add_modes(model: Model, basis: ModalBasis, spring: Spring) -> list[str]:
    """Add a body's modal coordinates and what holds them; return their names.

    Args:
        model: That gets them.
        basis: Of the body.
        spring: Names, unit, damping.
    """
    names = [f"{spring.label} {number}" for number in range(1, 1 + len(basis.square))]
    for name, square in zip(names, basis.square.tolist(), strict=True):
        if spring.unit == "rad":
            model.rotation(name, inertia=basis.mass, speed=0.0)
        else:
            model.translation(name, mass=basis.mass)
        if square > 0.0:
            damping = DampingRatio(spring.damping)
            model.add(Line(f"{name} elastic", {name: 1.0}, basis.mass * square, damping, kind="shaft"))
    return names


def motions(names: Sequence[str], shapes: Floats, points: Iterable[tuple[str, str]]) -> dict[str, dict[str, Motion]]:
    """Return how each place moves in each direction.

    Args:
        names: Of the modal coordinates.
        shapes: A row for each point.
        points: Place and direction of each.
    """
    places: dict[str, dict[str, Motion]] = {}
    for (place, direction), row in zip(points, shapes.tolist(), strict=True):
        weights = {name: weight for name, weight in zip(names, row, strict=True) if weight}
        places.setdefault(place, {})[direction] = weights
    return places


def between(first: Motion, second: Motion | None = None) -> dict[str, float]:
    """Return the motion of one point against another's, or against the ground.

    Args:
        first: Of the point.
        second: Of the other; None: the ground.
    """
    weights = dict(first)
    for name, weight in (second or {}).items():
        weights[name] = weights.get(name, 0.0) - weight
    return weights


@verb
@one_blas_thread()
def add_body(
    model: Model, name: str, body: ReducedBody, *, damping_ratio: float = 0.0, highest: float | None = None
) -> Placed:
    """Add a housing or another elastic body by its reduced matrices; return how its places move.

    Args:
        model: That gets it.
        name: Unique name.
        body: From `read_body`.
        damping_ratio: ζ of each of its modes [-].
        highest: Modes above are left out [Hz]; None: all are kept, and the coupling is exact.

    Source: Craig & Bampton 1968, AIAA J. 6, 1313-1319, in the modes of the reduced body.
    """
    basis = modal_basis(body.mass, body.stiffness, modal_mass=1.0, highest=highest)
    names = add_modes(model, basis, Spring(f"{name} mode", "m", damping_ratio))
    return Placed(name, motions(names, basis.shapes, body.places))


# ----------------------------------------------------------------------------------------------------------------------
# Rotors: shafts as beams that bend, stretch and twist, with discs on their stations, in bearings, coupled by gears.
#
# Stations count from 0, one at each end of every segment. A shaft is written as its own free modes: ``NAME`` is its
# rigid rotation, ``NAME bending x 1`` and so on are the others; `Placed.at` says how a station moves by them in each
# direction.
# ----------------------------------------------------------------------------------------------------------------------


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
    refuse(_rotor_problems(name, rotor))
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


def _rotor_problems(name: str, rotor: Rotor) -> Iterator[Problem]:
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


# ----------------------------------------------------------------------------------------------------------------------
# What joins rotors: bearings with cross terms on the ground or a housing, and gear meshes that couple all motions.
# ----------------------------------------------------------------------------------------------------------------------


ACROSS, TILTS = ("x", "y"), ("tilt x", "tilt y")


@dataclass(frozen=True)
class Bearing:
    """A linear bearing: force = −K u − C u̇ across, and springs along and against tilting."""

    stiffness: tuple[float, float]
    """k_xx, k_yy [N/m]."""
    cross_stiffness: tuple[float, float] = (0.0, 0.0)
    """k_xy, k_yx [N/m]: unequal ones follow the turning oil film and may drive the shaft."""
    damping: tuple[float, float] = (0.0, 0.0)
    """c_xx, c_yy [N s/m]."""
    cross_damping: tuple[float, float] = (0.0, 0.0)
    """c_xy, c_yx [N s/m]."""
    axial: tuple[float, float] = (0.0, 0.0)
    """Stiffness [N/m] and damping [N s/m] along the shaft."""
    tilting: tuple[float, float] = (0.0, 0.0)
    """Stiffness [N m/rad] and damping [N m s/rad] against each tilt."""

    def matrices(self) -> tuple[Floats, Floats]:
        """Return K [N/m] and C [N s/m] across, shape (2, 2) each."""
        pairs = ((self.stiffness, self.cross_stiffness), (self.damping, self.cross_damping))
        first, second = (np.array([[d[0], c[0]], [c[1], d[1]]], dtype=float) for d, c in pairs)
        return first, second


@verb
@one_blas_thread()
def add_bearing(model: Model, name: str, journal: Point, bearing: Bearing, *, housing: Point | None = None) -> None:
    """Hold a station of a rotor to the ground, or to a seat of a housing.

    Args:
        model: That gets the lines.
        name: Unique name.
        journal: Where it sits: `Placed.at` of a rotor.
        bearing: Its coefficients.
        housing: Seat: `Placed.at` of a body; None: the ground.

    Raises:
        DesignError: If a coefficient is not finite, or a principal stiffness or damping is negative.

    Source: Lund 1987, J. Tribol. 109, 37-41: eight coefficients; their symmetric parts act along principal axes.
    """
    stiffness, damping = bearing.matrices()
    refuse(_bearing_problems(name, bearing))
    moves = {
        direction: between(motion, None if housing is None else housing.get(direction, {}))
        for direction, motion in journal.items()
    }
    for what, matrix in (("stiffness", stiffness), ("damping", damping)):
        _add_principal(model, f"{name} {what}", matrix, moves=moves, is_stiff=what == "stiffness")
    skew = 0.5 * (stiffness - stiffness.T)[0, 1], 0.5 * (damping - damping.T)[0, 1]
    if any(skew):
        model.following(moves["x"], moves["y"], stiffness=float(skew[0]), damping=float(skew[1]))
    for direction, (stiff, damped) in (("z", bearing.axial), *((tilt, bearing.tilting) for tilt in TILTS)):
        _add_spring(model, f"{name} {direction}", moves.get(direction, {}), stiff, damping=damped)


def _bearing_problems(name: str, bearing: Bearing) -> Iterator[Problem]:
    numbers = (*bearing.axial, *bearing.tilting)
    matrices = bearing.matrices()
    if not all(math.isfinite(value) for value in (*numbers, *matrices[0].flat, *matrices[1].flat)):
        yield Problem(name, f"{bearing}; every coefficient must be finite")
        return
    for what, matrix in zip(("stiffness", "damping"), matrices, strict=True):
        least = float(np.linalg.eigvalsh(0.5 * (matrix + matrix.T))[0])
        if least < -1e-12 * float(np.max(np.abs(matrix))):
            yield Problem(name, f"its smallest principal {what} is {least:.6g}; it must not be negative")
    if min(numbers) < 0.0:
        yield Problem(name, f"{min(numbers):.6g} along or against tilting; it must not be negative")


def _add_principal(model: Model, name: str, matrix: Floats, *, moves: Point, is_stiff: bool) -> None:
    """Add the symmetric part of a matrix as a line along each of its principal axes."""
    values, axes = np.linalg.eigh(0.5 * (matrix + matrix.T))
    for number, (value, axis) in enumerate(zip(values.tolist(), axes.T.tolist(), strict=True), start=1):
        motion = combined([(axis[0], moves["x"]), (axis[1], moves["y"])])
        if value > 1e-12 * float(np.max(np.abs(values))):
            _add_spring(
                model, f"{name} {number}", motion, value if is_stiff else 0.0, damping=0.0 if is_stiff else value
            )


def _add_spring(model: Model, name: str, motion: Motion, stiffness: float, *, damping: float) -> None:
    if motion and stiffness:
        model.add(Line(name, motion, stiffness, damping, kind="support"))
    elif motion and damping:
        model.add(Line(name, motion, 0.0, damping, kind="damper"))


def combined(parts: Sequence[tuple[float, Motion]]) -> dict[str, float]:
    """Return a weighted sum of motions.

    Args:
        parts: Weight and motion.
    """
    weights: dict[str, float] = {}
    for factor, motion in parts:
        for name, weight in motion.items():
            weights[name] = weights.get(name, 0.0) + factor * weight
    return {name: weight for name, weight in weights.items() if weight}


@dataclass(frozen=True)
class GearContact:
    """Where and how the teeth of two gears on parallel shafts press on each other."""

    radii: tuple[float, float]
    """Working pitch radii of first and second gear [m]; a ring's is negative."""
    pressure_angle: float
    """Working transverse pressure angle [rad]."""
    helix_angle: float = 0.0
    """At the working pitch circle [rad]: positive where the first gear is right-hand."""
    place: float = 0.0
    """Angle from the first gear's x axis to the second gear's centre [rad]."""
    sense: int = 1
    """+1 where the first gear pushes the second as it turns about +z, −1 for the other flanks."""

    def direction(self) -> Floats:
        """Return the unit vector along which the first gear pushes the second, shape (3,)."""
        base = math.atan(math.tan(self.helix_angle) * math.cos(self.pressure_angle))
        along = np.array([math.cos(self.place), math.sin(self.place), 0.0])
        round_it = np.array([-along[1], along[0], 0.0])
        push = self.sense * math.cos(self.pressure_angle) * round_it + math.sin(self.pressure_angle) * along
        return np.asarray(math.cos(base) * push - np.array([0.0, 0.0, self.sense * math.sin(base)]))

    def levers(self) -> tuple[Floats, Floats]:
        """Return the weights of displacements and rotations (x, y, z each) of both gears, shape (6,) each [-, m]."""
        along = np.array([math.cos(self.place), math.sin(self.place), 0.0])
        push = self.direction()
        first, second = (np.concatenate([push, np.cross(arm * along, push)]) for arm in (self.radii[0], -self.radii[1]))
        return first, -second


@verb
@one_blas_thread()
def add_gear_contact(
    model: Model,
    name: str,
    gears: tuple[Point, Point],
    contact: GearContact,
    *,
    stiffness: float,
    damping: float | DampingRatio = 0.0,
    backlash: float = 0.0,
    variation: Periodic | None = None,
    errors: Sequence[Periodic] = (),
) -> None:
    """Couple two rotors by a mesh: one line whose deflection has torsion, bending, tilting and axial motion in it.

    Args:
        model: That gets the line.
        name: Unique name.
        gears: `Placed.at` of the stations on which the gears sit.
        contact: Radii, angles, place.
        stiffness: Mean mesh stiffness along the line of action [N/m].
        damping: c [N s/m] or a `DampingRatio`.
        backlash: Along the line of action [m]; 0 keeps the teeth in contact both ways.
        variation: Stiffness over its mean, less 1, in the mesh phase.
        errors: Along the line of action [m].

    Source: Kahraman, Ozguven, Houser & Zakrajsek 1992, J. Mech. Des. 114, 507-514 (spur); in space for helical teeth.
    """
    directions = (*ACROSS, "z", *TILTS, "twist")
    weights = combined([
        (weight, gear.get(direction, {}))
        for gear, levers in zip(gears, contact.levers(), strict=True)
        for direction, weight in zip(directions, levers.tolist(), strict=True)
        if abs(weight) > 1e-15
    ])  # fmt: skip
    model.mesh(
        name, weights, stiffness=stiffness, damping=damping, backlash=backlash, variation=variation, errors=errors
    )
