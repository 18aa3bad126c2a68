"""What joins rotors: bearings with cross terms on the ground or a housing, and gear meshes that couple all motions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gearwright.arrays import Floats
from gearwright.blas_threads import one_blas_thread
from gearwright.dynamics.model.line import DampingRatio, Line, Periodic
from gearwright.dynamics.model.model import Model
from gearwright.dynamics.model.rotors.elastic_body import Motion, Point, between
from gearwright.errors import Problem, refuse
from gearwright.verbs import verb

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
    refuse(_problems(name, bearing))
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


def _problems(name: str, bearing: Bearing) -> Iterator[Problem]:
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
